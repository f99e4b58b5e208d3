"""The freedoms of the facet as coordinates that are regular at the zenith too.

Where the dish stands level, alpha is free and its rate moves nothing, so alpha and beta cannot
serve a search or a balance of forces there. The tangent of half the tilt can, as a vector towards
the azimuth that the facet leans to: with it everything is rational, but for the lengths.
"""

from armillary import (
    Matrix,
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

from .facet import from_base, lean, n_P, rod, t, u, z_M
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
    r_m * (2 - shrink - 4 * w_q * w_q * shrink) - r_b,
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

_HERE = {q_x: n_P.x / lean, q_y: n_P.y / lean, q_z: z_M}


def here(value):
    """A value in these coordinates at the pose of alpha, beta and z_O."""
    return substitute(value, _HERE)


def placed_at(found):
    """Rotation and point of the facet in {H} at coordinates that were found."""
    at_found = dict(zip(UNKNOWNS, found, strict=True))
    tilt = tilted(substitute(n_q, at_found), 2 * substitute(shrink, at_found))
    columns = [from_base(tilt.column(k)) for k in range(3)]
    turned = Matrix(tuple(tuple(c[i] for c in columns) for i in range(3)))
    return turned, substitute(M_q, at_found)


# ---- the facet's motion in these coordinates ----

motions = tuple(
    Twist(spin, partial(M_q, q))
    for spin, q in zip(
        (
            2 * shrink * vector(0, 1, -q_y),
            2 * shrink * vector(-1, 0, q_x),
            vector(0, 0, 0),
        ),
        UNKNOWNS,
        strict=True,
    )
)
for _motion, _q in zip(motions[:2], (q_x, q_y), strict=True):
    d.identity(
        f"the tilt without torsion turns like this while {_q.name} runs",
        _motion.angular,
        tilting(n_q, partial(n_q, _q), 2 * shrink),
    )
for _motion, _q in zip(motions, UNKNOWNS, strict=True):
    _velocity = _platform.leg.joint_velocity(_motion)
    d.identity(
        f"while {_q.name} runs, the S-joint's velocity along the rod changes its length",
        _platform.leg.vector.dot(_velocity),
        reach_q * partial(reach_q, _q) + h_q * partial(h_q, _q),
    )
    d.identity(
        f"while {_q.name} runs, its velocity across the rod turns the hinge",
        t.cross(_platform.leg.vector).dot(_velocity),
        h_q * partial(reach_q, _q) - reach_q * partial(h_q, _q),
    )
