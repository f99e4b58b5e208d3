"""The freedoms of the facet as coordinates that are regular at the zenith too.

Where the dish stands level, alpha is free and its rate moves nothing, so alpha and beta cannot
serve a search or a balance of forces there. The tangent of half the tilt can, as a vector towards
the azimuth that the facet leans to: with it everything is rational, but for the lengths.
"""

from armillary import (
    Axes,
    Place,
    Platform,
    Twist,
    number,
    partial,
    substitute,
    tilted,
    tilting,
    vector,
)
from armillary.derivation.units import METRE

from .facet import H_T_P, from_base, lean, n_P, rod, t, u, z_M
from .symbols import d, r_b, r_m

q_x = d.unknown("q_x", "tangent of half the facet's tilt, component along the x axis of {P}")
q_y = d.unknown("q_y", "tangent of half the facet's tilt, component along the y axis of {P}")
q_z = d.unknown("q_z", "height of the facet's point", unit=METRE)
UNKNOWNS = (q_x, q_y, q_z)

shrink = d.define(
    "shrink",
    1 / (1 + (q_x * q_x + q_y * q_y)),
    because="One plus the squared tangent of half the tilt is one over its squared cosine.",
    meaning="squared cosine of half the tilt",
    latex="k",
)
n_q = d.define(
    "n_q",
    vector(2 * q_x * shrink, 2 * q_y * shrink, 2 * shrink - 1),
    because="Sine and cosine of the whole tilt by the tangent of its half.",
    meaning="unit normal of the facet by these coordinates, {P}",
    latex=r"\mathbf{n}_q",
)
M_q = d.define(
    "M_q",
    vector(
        r_m * (q_y * q_y - q_x * q_x) * shrink,
        2 * r_m * q_x * q_y * shrink,
        q_z,
    ),
    because="The parasitic motion by these coordinates.",
    meaning="the facet's point by these coordinates, {P}",
    latex=r"\mathbf{M}_q",
)
w_q = d.define(
    "w_q",
    q_x * u.x + q_y * u.y,
    because="How far the facet leans towards joint i.",
    meaning="component of the half tilt along the azimuth of joint i",
    latex="w_q",
)
reach_q = d.define(
    "reach_q",
    r_m * (2 - shrink - 4 * (w_q * w_q) * shrink) - r_b,
    because="The closed form of the rod's outward part by these coordinates.",
    meaning="component of rod i along the azimuth of its joint, by these coordinates",
    latex="a_q",
)
h_q = d.define(
    "h_q",
    q_z - 2 * r_m * w_q * shrink,
    because="The closed form of its height by these coordinates.",
    meaning="height of S-joint i above the ground, by these coordinates",
    latex="h_q",
)
_platform = Platform(Place(tilted(n_q, 2 * shrink), M_q), (rod,))
d.identity("the normal has length 1", n_q.dot(n_q), number(1))
d.identity("its rods are those of the platform, outward", _platform.leg.vector.dot(u), reach_q)
d.identity("and upward", _platform.leg.vector.z, h_q)
d.identity("and their S-joints keep to the planes", _platform.leg.plane_residual, number(0))


# ---- where these coordinates are ----

p_x = d.define(
    "p_x",
    n_P.x / lean,
    because="The tangent of half an angle is its sine over one plus its cosine.",
    meaning="half tilt of the facet that alpha and beta ask for, component along x",
    latex="p_x",
)
p_y = d.define(
    "p_y",
    n_P.y / lean,
    because="And along y.",
    meaning="half tilt of the facet that alpha and beta ask for, component along y",
    latex="p_y",
)
_HERE = {q_x: p_x, q_y: p_y, q_z: z_M}


def here(value):
    """A value in these coordinates at the pose of alpha, beta and z_O."""
    return substitute(value, _HERE)


def placed_at(found, mark, which):
    """Rotation and point in {H} of a facet whose coordinates were found; its steps are named."""
    at_found = dict(zip(UNKNOWNS, found, strict=True))
    normal = d.define(
        f"n_{mark}",
        substitute(n_q, at_found),
        because="The normal by the half tilt that was found.",
        meaning=f"unit normal of {which}, {{P}}",
        latex=rf"\mathbf{{n}}_{{\mathrm{{{mark}}}}}",
    )
    point = d.define(
        f"M_P_{mark}",
        substitute(M_q, at_found),
        because="And where the hinges put the facet's point.",
        meaning=f"point of {which}, {{P}}",
        latex=rf"\mathbf{{M}}_{{P\mathrm{{{mark}}}}}",
    )
    cosine = d.define(
        f"shrink_{mark}",
        substitute(shrink, at_found),
        because="The closed form of a tilt divides by one plus the cosine, which is twice this.",
        meaning=f"squared cosine of half the tilt of {which}",
        latex=rf"k_{{\mathrm{{{mark}}}}}",
    )
    axes = tilted(normal, 2 * cosine)
    rotation = d.define(
        f"H_R_{mark}",
        Axes(*map(from_base, axes.columns)).matrix(),
        because="The tilt without torsion, in East-North-Up.",
        meaning=f"rotation of {which}: its axes in {{H}}",
        latex=rf"{{}}^{{H}}R_{{\mathrm{{{mark}}}}}",
    )
    place = d.define(
        f"M_{mark}",
        H_T_P.position + from_base(point),
        because="The base stands at the facet's azimuth.",
        meaning=f"point of {which}, {{H}}",
        latex=rf"\mathbf{{M}}_{{\mathrm{{{mark}}}}}",
    )
    return rotation, place


# ---- the facet's motion in these coordinates ----

_DOWN = "Differentiate one over one plus a square."
shrink_x = d.define(
    "shrink_x",
    -2 * q_x * (shrink * shrink),
    because=_DOWN,
    meaning="change of shrink per unit of q_x",
    latex="k_{,x}",
)
shrink_y = d.define(
    "shrink_y",
    -2 * q_y * (shrink * shrink),
    because=_DOWN,
    meaning="change of shrink per unit of q_y",
    latex="k_{,y}",
)
spins = (
    d.define(
        "spin_x",
        2 * shrink * vector(0, 1, -q_y),
        because="A facet that leans more to x turns about y, and a little about the vertical.",
        meaning="angular velocity of the facet per unit of q_x, {P}",
        latex=r"\boldsymbol{\omega}_x",
    ),
    d.define(
        "spin_y",
        2 * shrink * vector(-1, 0, q_x),
        because="One that leans more to y turns about x, backwards.",
        meaning="angular velocity of the facet per unit of q_y, {P}",
        latex=r"\boldsymbol{\omega}_y",
    ),
)


def steps_of(q, change, letter):
    """Velocity of the facet's point, and what the rods' parts do, while one coordinate runs."""
    known = {shrink: change}
    return (
        d.define(
            f"v_{letter}",
            partial(M_q, q, known),
            because="The parasitic motion goes with the tilt.",
            meaning=f"velocity of the facet's point per unit of {q.name}, {{P}}",
            latex=rf"\mathbf{{v}}_{letter}",
        ),
        d.define(
            f"reach_{letter}",
            partial(reach_q, q, known),
            because="The S-joint is drawn in, or let out.",
            meaning=f"change of the outward part of rod i per unit of {q.name}",
            latex=f"a_{{,{letter}}}",
        ),
        d.define(
            f"h_{letter}",
            partial(h_q, q, known),
            because="And sinks, or rises.",
            meaning=f"change of the height of S-joint i per unit of {q.name}",
            latex=f"h_{{,{letter}}}",
        ),
    )


slopes = (steps_of(q_x, shrink_x, "x"), steps_of(q_y, shrink_y, "y"))
for _q, _change, _spin, (_v, _reach, _h) in zip(
    (q_x, q_y), (shrink_x, shrink_y), spins, slopes, strict=True
):
    _velocity = _platform.leg.joint_velocity(Twist(_spin, _v))
    d.identity(f"the squared cosine changes like this while {_q.name} runs",
               partial(shrink, _q), _change)  # fmt: skip
    d.identity(
        f"the tilt without torsion turns like this while {_q.name} runs",
        _spin,
        tilting(n_q, partial(n_q, _q), 2 * shrink),
    )
    d.identity(
        f"while {_q.name} runs, the S-joint moves as its position says",
        _velocity,
        partial(_platform.leg.joint, _q),
    )
    d.identity(
        f"while {_q.name} runs, the S-joint's velocity along the rod changes its length",
        _platform.leg.vector.dot(_velocity),
        reach_q * _reach + h_q * _h,
    )
    d.identity(
        f"while {_q.name} runs, its velocity across the rod turns the hinge",
        t.cross(_platform.leg.vector).dot(_velocity),
        h_q * _reach - reach_q * _h,
    )
