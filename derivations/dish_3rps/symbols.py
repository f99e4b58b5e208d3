"""The record of the 3-RPS dish, and the quantities that its parts share."""

from armillary import Derivation, Kind, Rate, degrees
from armillary.derivation.units import KILOGRAM, METRE, NEWTON, NEWTON_METRE, ONE, RADIAN, SECOND

derivation = d = Derivation(
    "dish_3rps",
    title="Dish on 3-RPS platforms",
    paper="mo2023",
    summary="The mirror of a parabolic dish is cut into facets. Nothing carries the dish: each "
    "facet stands on three rods of its own, hinged to the ground and ball-jointed to the facet, "
    "and the rods move it as if the dish turned about its vertex to face the sun. A platform on "
    "three such rods has three freedoms, not six. The normal and the height are given to it; where "
    "it stands sideways and how it is turned about its normal follow from its hinges, and the page "
    "derives both.",
)

# ---- like parts ----

facet = d.index("facet", 4, letter="N")
leg = d.index("leg", 3)

theta = d.constant(
    "theta",
    (0, degrees(120), degrees(-120)),
    "azimuth of joint i of base and platform, from the x axis, counter-clockwise",
    unit=RADIAN,
    latex=r"\theta",
    per=leg,
)
phi_N = d.constant(
    "phi_N",
    (0, degrees(90), degrees(180), degrees(270)),
    "azimuth of facet N from the east, counter-clockwise",
    unit=RADIAN,
    latex=r"\varphi",
    per=facet,
)

# ---- dimensions, the same for every call ----

_SIZE = {"limits": (0.0, 1e3)}
f = d.parameter.length(
    "f", "focal length of the dish", limits=(1e-3, 1e3), range=(0.5, 10.0), latex="f"
)
dist = d.parameter.length(
    "d",
    "distance from the dish's axis to the facet's point",
    range=(0.1, 2.0),
    latex="d",
    **_SIZE,
)
r_b = d.parameter.length(
    "r_b", "radius of the circle of the base joints", range=(0.05, 1.0), latex="r_b", **_SIZE
)
r_m = d.parameter.length(
    "r_m", "radius of the circle of the platform joints", range=(0.2, 1.0), latex="r_m", **_SIZE
)
z_O = d.parameter.length(
    "z_O",
    "height of the dish's vertex above the origin of {H}, "
    "whose axes are East-North-Up on the ground below it",
    range=(1.0, 10.0),
    latex="z_O",
    **_SIZE,
)
phi = d.parameter.angle(
    "phi", "azimuth of the facet from the east, counter-clockwise", latex=r"\varphi"
)

# ---- attitude of the dish ----

alpha = d.angle(
    "alpha", "azimuth of the dish's axis from the east, counter-clockwise", latex=r"\alpha"
)
beta = d.angle("beta", "angle from the zenith to the dish's axis", range=(0.0, 1.4), latex=r"\beta")
alpha_dot, beta_dot = alpha.rate(), beta.rate()
z_dot = z_O.rate("z_dot", "rate of the height of the dish's vertex")
enu = d.unit_vector("enu", "unit vector to the sun", latex=r"\mathbf{c}")
tau = d.angle("tau", "a torsion: turn of a platform about its own normal", latex=r"\tau")
D = d.length(
    "D", "diameter of the dish", limits=(0.0, 1e3), range=(0.5, 20.0), latex="D", rate=Rate.MOUNT
)
theta_rim = d.angle(
    "theta_rim",
    "edge angle: at the focus, from the axis to the rim",
    limits=(1e-3, 3.1415926),
    range=(0.1, 2.0),
    latex=r"\psi_\mathrm{rim}",
    rate=Rate.MOUNT,
)

# ---- loads ----

mass = d.scalar(
    "mass",
    "mass of the facet with its platform",
    unit=KILOGRAM,
    kind=Kind.NON_NEGATIVE,
    range=(0.0, 100.0),
    rate=Rate.MOUNT,
)
centre = d.vector(
    "centre",
    "centre of mass from the facet's point, facet axes",
    unit=METRE,
    limits=(-1e3, 1e3),
    range=(-0.3, 0.3),
    rate=Rate.MOUNT,
    latex=r"\mathbf{r}_\mathrm{c}",
)
f_d = d.vector(
    "f_d",
    "disturbing force on the facet at its point, such as wind",
    unit=NEWTON,
    range=(-500.0, 500.0),
    latex=r"\mathbf{f}_\mathrm{d}",
)
n_d = d.vector(
    "n_d",
    "disturbing moment on the facet about its point",
    unit=NEWTON_METRE,
    range=(-200.0, 200.0),
    latex=r"\mathbf{n}_\mathrm{d}",
)
g = d.scalar(
    "g",
    "acceleration of free fall",
    unit=METRE / SECOND**2,
    kind=Kind.NON_NEGATIVE,
    range=(0.0, 10.0),
    limits=(0.0, 1e3),
    rate=Rate.MOUNT,
)

# ---- forward kinematics ----

l_given = d.length(
    "l", "length of rod i", limits=(0.0, 1e3), range=(2.0, 4.0), per=leg, latex=r"\bar{l}"
)
guess = d.vector(
    "guess",
    "where the search starts: alpha and beta in rad and z_O in m",
    unit=ONE,
    range=(0.0, 1.5),
    latex=r"\mathbf{g}",
)
metre = d.constant(
    "metre", 1, "the unit of the last entry of guess", unit=METRE, latex=r"1\,\mathrm{m}"
)

# ---- tolerances ----

zenith_tolerance = d.constant(
    "zenith_tolerance",
    "1e-6",
    "horizontal length of the sun's direction below which its azimuth is taken as free",
    latex=r"\tau_z",
)
face_down_tolerance = d.constant(
    "face_down_tolerance",
    "1e-6",
    "1 + n_z below which the facet hangs face down",
    latex=r"\tau_n",
)
rod_tolerance = d.constant(
    "rod_tolerance",
    "1e-6",
    "length below which a rod has no direction",
    unit=METRE,
    latex=r"\tau_l",
)
forward_tolerance = d.constant(
    "forward_tolerance",
    "1e-5",
    "part of a squared length that a search may leave",
    latex=r"\tau_f",
)
statics_tolerance = d.constant(
    "statics_tolerance",
    "1e-6",
    "part of r_m squared below which a determinant is taken as 0",
    latex=r"\tau_s",
)
receiver_tolerance = d.constant(
    "receiver_tolerance",
    "1e-5",
    "angle in rad, by component, between normal and bisector that a search may leave",
    latex=r"\tau_b",
)
