"""The rods: vectors and lengths, of one facet and of all four."""

from armillary import Z, any_of, elementary, substitute, vector, where

from .dish import R_D, slope_length
from .facet import any_platform, face_down, half_turn, lean, n_any, n_P, platform, u, z_M
from .symbols import d, dist, f, facet, leg, phi, phi_N, r_b, r_m, rod_tolerance, z_O

BS = d.define(
    "BS",
    platform.leg.vector,
    because="From the hinge on the ground to the S-joint on the facet.",
    meaning="vector along rod i from its hinge to its S-joint, {P}",
    printed="17",
    latex=r"\overrightarrow{BS}",
)


def leaning(n):
    """How far a facet with the normal n leans towards joint i."""
    return n.x * u.x + n.y * u.y


def outward(n, w, lean):
    """Where its S-joint stands in the plane of the hinge, from the base's centre."""
    return r_m * ((3 - n.z) / 2 - 2 * (w * w) / lean)


w = d.define(
    "w",
    leaning(n_P),
    because="The sine of the facet's slope along the azimuth of the joint.",
    meaning="component of the normal along the azimuth of joint i",
    latex="w",
)
rho = d.define(
    "rho",
    outward(n_P, w, lean),
    because="The S-joint is drawn in by the tilt, and stands aside by the parasitic motion; three "
    "times any joint's azimuth is a whole turn, so that both depend on w alone.",
    meaning="distance of S-joint i from the vertical through the base's centre, outward",
    latex=r"\rho",
)
h = d.define(
    "h",
    z_M - r_m * w,
    because="The joint that the facet leans to is lower.",
    meaning="height of S-joint i above the ground",
    latex="h",
)
_joint = any_platform.leg.joint
d.identity(
    "for any normal this is where the platform has the joint, outward",
    _joint.dot(u),
    outward(n_any, leaning(n_any), 1 + n_any.z),
)
d.identity("and upward", _joint.z, z_O - r_m * leaning(n_any))
reach = d.define(
    "reach",
    rho - r_b,
    because="The rod leans outward by this much.",
    meaning="component of rod i along the azimuth of its joint",
    latex="a",
)
l_rod = d.define(
    "l_rod",
    vector(reach, 0, h).norm(),
    because="A right triangle in the plane of the hinge.",
    meaning="length of rod i; rods 0, 1, 2 stand at 0, 120, -120 degrees from the way to the "
    "dish's axis, counter-clockwise from above",
    printed="18",
    latex="l",
)
no_rod = d.define(
    "no_rod",
    any_of(~(l_rod > rod_tolerance), over=leg),
    because="Where an S-joint meets its hinge, the rod has no direction.",
    meaning="whether a rod has no length",
)
length = d.define(
    "length",
    where(l_rod > rod_tolerance, l_rod, rod_tolerance),
    because="The length that is divided by.",
    meaning="length of rod i, at least the tolerance",
    latex="l^+",
)
# ---- all four facets ----

_seen = elementary(Z, -phi_N) @ R_D @ elementary(Z, phi_N)
n_N = d.define(
    "n_N",
    half_turn(_seen @ (vector(-dist, 0, 2 * f) / slope_length)),
    because="One attitude of the dish serves all four: the facets are turned to it.",
    meaning="unit normal of facet N, {P}",
    latex=r"\mathbf{n}",
)
z_N = d.define(
    "z_N",
    z_O + (_seen @ vector(dist, 0, dist * dist / (4 * f))).z,
    because="As for one facet: the point of the dish, turned with it.",
    meaning="height of the point of facet N above the ground",
    latex="z_M",
)
_of_facet = {n_P: n_N, z_M: z_N}
l_all = d.define(
    "l_all",
    substitute(l_rod, _of_facet),
    because="The same closed form for each.",
    meaning="length of rod i of facet N: facets to the east, north, west and south",
    latex="l",
)
face_down_all = d.define(
    "face_down_all",
    any_of(substitute(face_down, _of_facet), over=facet),
    because="One such facet is enough to answer nothing.",
    meaning="whether one of the four facets hangs face down",
)
d.identity("a facet of the four is the facet at its azimuth", n_N, substitute(n_P, {phi: phi_N}))
d.identity("and as high", z_N, substitute(z_M, {phi: phi_N}))
