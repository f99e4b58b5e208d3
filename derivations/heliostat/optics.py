"""The mirror: the normal that is wanted, the beam it throws, and where the beam lands."""

from armillary import partial, unit, vector, where

from .frames import I_R_L, local, normal, normal_I
from .symbols import (
    aim_point,
    b,
    beta,
    c,
    chi,
    d,
    grazing_tolerance,
    n,
    nearest_distance,
    opposite_tolerance,
    position,
)

# ---- the normal that is wanted ----

m = d.define(
    "m",
    b + c,
    because="Sun and receiver are seen at equal angles from the normal, so the normal points where "
    "the two unit vectors add up to. Its length does not matter to the drives.",
    meaning="sum of the directions to the receiver and to the sun",
    latex=r"\mathbf{m}",
)
opposed = d.define(
    "opposed",
    m.dot(m) < opposite_tolerance * opposite_tolerance,
    because="A receiver opposite the sun stands in the mirror's shadow: no normal is singled out.",
    meaning="whether sun and receiver stand opposite each other",
)
wanted = d.define(
    "wanted",
    unit(vector(where(opposed, 1, m.x), where(opposed, 0, m.y), where(opposed, 0, m.z))),
    because="The normal itself has length 1. The print divides by the root of 2 (1 + b.c), which "
    "is the same length for exact unit vectors and loses digits as they become opposite.",
    meaning="unit normal that sends the sun to the receiver",
    printed="3",
    latex=r"\mathbf{n}_{bc}",
)
n_L = d.define(
    "n_L",
    local(unit(m)),
    because="In the paper's axes: south, east and up.",
    meaning="unit normal that is wanted, in local axes",
    printed="12",
    latex=r"\mathbf{n}_L",
)
n_I = d.define(
    "n_I",
    I_R_L @ n_L,
    because="Seen from the leaning azimuth axis.",
    meaning="unit normal that is wanted, in the frame of the azimuth axis",
    printed="13",
    latex=r"\mathbf{n}_I",
)
d.identity("the sum leans on sun and receiver alike", m.dot(c) - c.dot(c), m.dot(b) - b.dot(b))

# ---- the beam ----


def mirrored(ray, normal):
    """Where a mirror sends what comes from a direction."""
    return 2 * ray.dot(normal) * normal - ray


b_reflected = d.define(
    "b_reflected",
    mirrored(c, n),
    because="The part along the normal comes back, the part across goes on.",
    meaning="direction of the reflected beam for a given normal",
    latex=r"\mathbf{b}_n",
)
b_beam = d.define(
    "b_beam",
    mirrored(c, normal),
    because="The same for the normal that the drives have set.",
    meaning="direction of the reflected beam for given drive angles",
    latex=r"\mathbf{b}_{\alpha\beta}",
)
_back = mirrored(c, normal_I)
d.identity(
    "the beam leaves as steeply as the ray came",
    _back.dot(normal_I),
    c.dot(normal_I),
)
d.identity("and keeps to their common plane", _back.cross(normal_I), normal_I.cross(c))
d.identity(
    "a normal that slips moves the beam by 2 (c.dn) n + 2 (c.n) dn",
    partial(b_beam, chi),
    2 * c.dot(partial(normal, chi)) * normal + 2 * c.dot(normal) * partial(normal, chi),
)
_slip, _shift = partial(normal_I, beta), partial(_back, beta)
d.identity(
    "these two are square: the beam moves between 2 |dn| cos(incidence) and 2 |dn|",
    _shift.dot(_shift),
    4 * c.dot(_slip) ** 2 + 4 * c.dot(normal_I) ** 2,
)

# ---- the receiver ----

way = d.define(
    "way",
    aim_point - position,
    because="The beam must go from the mirror to the aim point.",
    meaning="vector from the mirror to the aim point",
    latex=r"\mathbf{w}",
)
distance = d.define(
    "distance",
    way.norm(),
    because="How far the receiver is.",
    meaning="distance from the mirror to the aim point",
    latex="r",
)
on_mirror = d.define(
    "on_mirror",
    distance < nearest_distance,
    because="An aim point on the mirror has no direction.",
    meaning="whether the aim point lies on the mirror",
)
stretch = d.define(
    "stretch",
    where(on_mirror, nearest_distance, distance),
    because="The distance that is divided by.",
    meaning="distance, and the tolerance on the mirror itself",
    latex="r_1",
)
b_target = d.define(
    "b_target",
    way / stretch,
    because="The direction in which the beam must leave.",
    meaning="unit vector from the mirror to the aim point",
    latex=r"\mathbf{b}_w",
)
ahead = d.define(
    "ahead",
    b_beam.dot(way),
    because="How far the way goes along with the beam.",
    meaning="component of the way along the beam",
    latex="a",
)
astray = d.define(
    "astray",
    ~(ahead > grazing_tolerance * distance),
    because="A beam that leaves across the way, or backwards, never meets the plane through the "
    "aim point that faces the mirror.",
    meaning="whether the beam does not get to the aim point's plane",
)
unlit = d.define(
    "unlit",
    ~(c.dot(normal) > 0),
    because="The formula of the beam knows no front and no back: turned round, the mirror would "
    "throw the same beam with its back.",
    meaning="whether the sun is behind the mirror",
)
miss = d.define(
    "miss",
    distance * b_beam.cross(way).norm() / where(astray, nearest_distance, ahead),
    because="The beam and the way make an angle whose tangent is the cross product over the dot "
    "product; in the plane that faces the mirror the beam lands off by the distance times that.",
    meaning="distance from the aim point at which the beam meets the plane that faces the mirror",
    latex=r"\epsilon",
)
