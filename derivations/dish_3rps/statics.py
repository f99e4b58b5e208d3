"""Forces in the rods that hold the facet, by virtual work."""

from armillary import Twist, Wrench, at, number, reciprocal_or_zero, vector

from .facet import tilt, to_base
from .half_tilt import h_q, here, q_x, q_y, q_z, reach_q, slopes, spins
from .rods import h, length
from .symbols import centre, d, f_d, g, leg, mass, n_d, r_m, statics_tolerance

weight = d.define(
    "weight",
    vector(number(0), number(0), -mass * g),
    because="Weight pulls down.",
    meaning="weight of the facet, {P} and {H}",
    latex=r"\mathbf{G}",
)
load = d.define(
    "load",
    Wrench(to_base(n_d) + (tilt @ centre).cross(weight), to_base(f_d) + weight),
    because="Weight acts in the centre of mass, the disturbance at the facet's point.",
    meaning="what acts on the facet about its point, {P}",
    latex=r"\mathbf{W}",
)

# ---- a balance for each freedom ----

_WORK = (
    "What the load does along a motion that the hinges permit; their own forces do nothing along "
    "it."
)


def works_of(letter, q, spin, velocity):
    """Work of the load per unit of a coordinate."""
    return d.define(
        f"work_{letter}",
        load.power(Twist(here(spin), here(velocity))),
        because=_WORK,
        meaning=f"work of the load per unit of {q.name}",
        latex=f"W_{letter}",
    )


def rods_of(letter, q, slope):
    """What a coordinate does to the three rods, as a vector."""
    slope = d.define(
        f"slope_{letter}",
        slope / length,
        because="What the same motion does to the rods.",
        meaning=f"change of the length of rod i per unit of {q.name}",
        latex=f"l_{{,{letter}}}",
    )
    return d.define(
        f"rods_{letter}",
        vector(*(at(slope, leg, k) for k in range(leg.size))),
        because="A component for each rod.",
        meaning=f"change of the lengths of the three rods per unit of {q.name}",
        latex=rf"\mathbf{{l}}_{{,{letter}}}",
    )


work_x, work_y = (
    works_of(letter, q, spin, v)
    for letter, q, spin, (v, _, _) in zip("xy", (q_x, q_y), spins, slopes, strict=True)
)
work_z = works_of("z", q_z, vector(0, 0, 0), vector(0, 0, 1))
rods_x, rods_y = (
    rods_of(letter, q, here(reach_q * a + h_q * b))
    for letter, q, (_, a, b) in zip("xy", (q_x, q_y), slopes, strict=True)
)
rods_z = rods_of("z", q_z, h)
det = d.define(
    "det",
    rods_x.dot(rods_y.cross(rods_z)),
    because="Where the three freedoms move the rods alike, the rods do not hold the facet.",
    meaning="determinant of what the three freedoms do to the three rods",
    latex=r"\delta",
)
loose = d.define(
    "loose",
    ~(det * det > (statics_tolerance * r_m * r_m) ** 2),
    because="It has the size of r_m squared where the rods stand well.",
    meaning="whether the rods do not hold the facet",
)
inverse = d.define(
    "inverse",
    reciprocal_or_zero(det, loose),
    because="Rods that do not hold the facet are given no force.",
    meaning="one over the determinant, 0 where it vanishes",
    latex=r"\delta^{-1}",
)
F_rod = d.define(
    "F_rod",
    (work_x * rods_y.cross(rods_z) + work_y * rods_z.cross(rods_x) + work_z * rods_x.cross(rods_y))
    * -inverse,
    because="The work of rods and load is zero along each freedom, F.l + W = 0: three equations "
    "for three forces.",
    meaning="force of each rod on the facet, push positive",
    latex=r"\mathbf{F}",
)
