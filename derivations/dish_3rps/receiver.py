"""Where the sunlight goes: past the focus by a little, or into it with other normals."""

from armillary import (
    Y,
    Z,
    absolute,
    atan2,
    elementary,
    number,
    one_like,
    solve,
    sqrt,
    substitute,
    vector,
    where,
)

from .dish import c_dish
from .facet import D_P, M_P, from_base, half_turn, n_P, off_P, psi, z_M
from .half_tilt import M_q, h_q, here, placed_at, q_x, q_y, q_z, reach_q
from .symbols import beta, d, dist, f, receiver_tolerance, z_O

STEPS = 5

c_P = d.define(
    "c_P",
    half_turn(elementary(Z, psi) @ elementary(Y, beta) @ vector(0, 0, 1)),
    because="Seen from the base.",
    meaning="unit vector along the dish's axis, to the sun, {P}",
    latex=r"\mathbf{c}_P",
)
d.identity("it is the dish's axis", from_base(c_P), c_dish)
focus = d.define(
    "focus",
    vector(dist, number(0), z_O) + f * c_P,
    because="The receiver stands on the dish's axis at the focal length from the vertex, which "
    "stays above the origin of {H} while the dish turns about it.",
    meaning="the focus, {P}",
    latex=r"\mathbf{F}_P",
)

# ---- with the normals of the dish ----

way = d.define(
    "way",
    focus - M_P,
    because="From the facet's point, where the rods have it.",
    meaning="vector from the facet's point to the focus, {P}",
    latex=r"\mathbf{s}",
)
ray = d.define(
    "ray",
    2 * c_P.dot(n_P) * n_P - c_P,
    because="The part along the normal comes back, the part across goes on.",
    meaning="direction of the central ray after the facet, {P}",
    latex=r"\mathbf{b}",
)
d.identity(
    "from the dish's own point it goes through the focus", ray.cross(focus - D_P), vector(0, 0, 0)
)
miss = d.define(
    "miss",
    ray.cross(off_P).norm(),
    because="A ray of the same direction from the dish's point would meet the focus, so this one "
    "passes it by as much as the facet stands aside, across the ray.",
    meaning="distance by which the central ray passes the focus",
    latex=r"\epsilon",
)
miss_angle = d.define(
    "miss_angle",
    atan2(miss, ray.dot(way)),
    because="Seen from the facet.",
    meaning="angle between the central ray and the way to the focus, in [0, pi]",
    latex=r"\angle\epsilon",
)

# ---- with normals that halve the angle between sun and receiver ----


way_q = d.define(
    "way_q",
    focus - M_q,
    because="The facet steps aside as it tilts, so the way depends on what is looked for.",
    meaning="vector from the facet's point to the focus by the half tilt, {P}",
    latex=r"\mathbf{s}_q",
)
m = d.define(
    "m",
    way_q + way_q.norm() * c_P,
    because="Two vectors of one length add up to their bisector.",
    meaning="a vector along the bisector of the directions to sun and receiver, {P}",
    latex=r"\mathbf{m}",
)
_square = m.dot(m)
length_m = d.define(
    "length_m",
    sqrt(where(_square > 0, _square, one_like(_square))),
    because="The search divides by it. Where sun and receiver are opposite, m is null, and any "
    "length serves: the search goes on from elsewhere.",
    meaning="length of m",
    latex=r"|\mathbf{m}|",
)
off_x = d.define(
    "off_x",
    q_x * (length_m + m.z) - m.x,
    because="The half tilt of m is m_x / (|m| + m_z), and so for y.",
    meaning="what vanishes where the normal is the bisector, x",
    latex=r"\Delta_x",
)
off_y = d.define(
    "off_y",
    q_y * (length_m + m.z) - m.y,
    because="The half tilt of m is m_x / (|m| + m_z), and so for y.",
    meaning="what vanishes where the normal is the bisector, y",
    latex=r"\Delta_y",
)
_height = {q_z: z_M}
_residuals = [substitute(off, _height) for off in (off_x, off_y)]
found = (
    *solve(
        _residuals,
        {q_x: here(q_x), q_y: here(q_y)},
        steps=STEPS,
        name="bisect",
        within={q_x: (-2, 2), q_y: (-2, 2)},
    ),
    z_M,
)
_at = dict(zip((q_x, q_y, q_z), found, strict=True))
m_size = d.define(
    "m_size",
    substitute(length_m, _at),
    because="What is left is measured against it.",
    meaning="length of m where the search has ended",
    latex=r"m^{\ast}",
)
_LEFT = "Nothing says that the search has ended where it should."
left_x = d.define(
    "left_x",
    substitute(off_x, _at),
    because=_LEFT,
    meaning="what is left of off_x",
    latex=r"\Delta_x^{\ast}",
)
left_y = d.define(
    "left_y",
    substitute(off_y, _at),
    because=_LEFT,
    meaning="what is left of off_y",
    latex=r"\Delta_y^{\ast}",
)
astray = d.define(
    "astray",
    ~(
        (absolute(left_x) < receiver_tolerance * m_size)
        & (absolute(left_y) < receiver_tolerance * m_size)
    ),
    because="The normal that was found must be the bisector.",
    meaning="whether the normal that was found is not the bisector",
)
H_R_aimed, M_aimed = placed_at(found, "aimed", "a facet that aims at the receiver")
l_aimed = d.define(
    "l_aimed",
    substitute(vector(reach_q, 0, h_q).norm(), _at),
    because="The closed form at the tilt that was found.",
    meaning="length of rod i of a facet that aims at the receiver",
    latex="l_b",
)
