"""Forces in the rods that hold the facet, by virtual work."""

from armillary import (
    Twist,
    Wrench,
    at,
    determinant,
    number,
    one_like,
    partial,
    solved,
    vector,
    where,
)

from .facet import tilt, to_base
from .half_tilt import UNKNOWNS, h_q, here, motions, reach_q
from .rods import length
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

works, slopes = [], []
for _motion, _q, _name in zip(motions, UNKNOWNS, "xyz", strict=True):
    works.append(
        d.define(
            f"work_{_name}",
            load.power(Twist(here(_motion.angular), here(_motion.linear))),
            because="What the load does along a motion that the hinges permit; their own forces "
            "do nothing along it.",
            meaning=f"work of the load per unit of {_q.name}",
            latex=f"W_{_name}",
        )
    )
    slopes.append(
        d.define(
            f"slope_{_name}",
            here(reach_q * partial(reach_q, _q) + h_q * partial(h_q, _q)) / length,
            because="What the same motion does to the rods.",
            meaning=f"change of the length of rod i per unit of {_q.name}",
            latex=f"l_{{,{_name}}}",
        )
    )
_rows = [[at(slope, leg, k) for k in range(leg.size)] for slope in slopes]
det = d.define(
    "det",
    determinant(_rows),
    because="Where two freedoms move the rods alike, the rods do not hold the facet.",
    meaning="determinant of what the three freedoms do to the three rods",
    latex=r"\delta",
)
loose = d.define(
    "loose",
    ~(det * det > (statics_tolerance * r_m * r_m) ** 2),
    because="It has the size of r_m squared where the rods stand well.",
    meaning="whether the rods do not hold the facet",
)
_forces = solved(_rows, [-work for work in works], where(loose, one_like(det), det))
F_rod = d.define(
    "F_rod",
    vector(*(where(loose, number(0), force) for force in _forces)),
    because="The work of rods and load is zero along each freedom: three equations for three "
    "forces.",
    meaning="force of each rod on the facet, push positive",
    latex=r"\mathbf{F}",
)
