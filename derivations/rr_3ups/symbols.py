"""The record of the RR-3UPS tracker, and the quantities that its parts share."""

from armillary import Derivation, Kind
from armillary.derivation.units import KILOGRAM, METRE, NEWTON, NEWTON_METRE, SECOND

derivation = d = Derivation(
    "rr_3ups",
    title="Two-axis tracker on three legs",
    paper="yu",
    summary="A platform stands on two crossed axes at the top of a column: it turns about the "
    "vertical, and tilts about a level axis that turns with it. Three legs of variable length "
    "drive it, one more than it needs. Each stands on a universal joint on the ground and ends in "
    "a spherical joint under the platform. The page derives how the legs move, what forces drive "
    "a motion, and what the third leg is worth.",
)

# ---- like parts ----

leg = d.index("leg", 3)

# ---- dimensions, the same for every call ----

_LENGTH = {"limits": (0.0, 1e3)}
r = d.parameter.length(
    "r", "distance of spherical joint i from o", range=(0.2, 0.5), latex="r", per=leg, **_LENGTH
)
phi = d.parameter.angle(
    "phi",
    "azimuth of spherical joint i about the platform's normal, from its x axis",
    latex=r"\varphi",
    per=leg,
)
R = d.parameter.length(
    "R",
    "distance of universal joint i from the column's axis",
    range=(0.3, 1.0),
    latex="R",
    per=leg,
    **_LENGTH,
)
theta = d.parameter.angle(
    "theta", "azimuth of universal joint i, from the east towards the north", latex=r"\theta",
    per=leg,
)  # fmt: skip
h = d.parameter.scalar(
    "h",
    "height of universal joint i above the ground",
    unit=METRE,
    limits=(-1e3, 1e3),
    range=(0.0, 1.0),
    per=leg,
)
zeta = d.parameter.angle(
    "zeta",
    "mounting angle of universal joint i: turn of its first axis from the vertical about the "
    "north axis",
    latex=r"\zeta",
    per=leg,
)
t = d.parameter.length(
    "t",
    "distance of the first link's centre of mass from universal joint i",
    range=(0.0, 0.5),
    per=leg,
    **_LENGTH,
)
s = d.parameter.length(
    "s",
    "distance of the second link's centre of mass from spherical joint i",
    range=(0.0, 0.5),
    per=leg,
    **_LENGTH,
)
_MASS = {"unit": KILOGRAM, "kind": Kind.NON_NEGATIVE}
m_t = d.parameter.scalar(
    "m_t", "mass of the first link of leg i", range=(0.0, 20.0), per=leg, **_MASS
)
m_s = d.parameter.scalar(
    "m_s", "mass of the second link of leg i", range=(0.0, 20.0), per=leg, **_MASS
)
_INERTIA = {"unit": KILOGRAM * METRE**2, "kind": Kind.NON_NEGATIVE}
I_t = d.parameter.vector(
    "I_t",
    "moments of inertia of the first link of leg i about its centre of mass, leg axes",
    range=(0.0, 2.0),
    latex=r"\mathbf{I}_t",
    per=leg,
    **_INERTIA,
)
I_s = d.parameter.vector(
    "I_s",
    "moments of inertia of the second link of leg i about its centre of mass, leg axes",
    range=(0.0, 2.0),
    latex=r"\mathbf{I}_s",
    per=leg,
    **_INERTIA,
)
I_m = d.parameter.vector(
    "I_m",
    "moments of inertia of the platform with its mirror about o, platform axes",
    range=(0.5, 20.0),
    latex=r"\mathbf{I}_m",
    **_INERTIA,
)
h_0 = d.parameter.length("h_0", "height of o above the ground", range=(0.3, 1.0), **_LENGTH)
m_m = d.parameter.scalar("m_m", "mass of the platform with its mirror", range=(0.0, 100.0), **_MASS)
r_sc = d.parameter.vector(
    "r_sc",
    "centre of mass of the platform with its mirror, from o, platform axes",
    unit=METRE,
    limits=(-1e3, 1e3),
    range=(-0.2, 0.2),
    latex=r"\mathbf{r}_{sc}",
)
g = d.parameter.scalar(
    "g",
    "acceleration of free fall",
    unit=METRE / SECOND**2,
    kind=Kind.NON_NEGATIVE,
    limits=(0.0, 1e3),
    range=(0.0, 10.0),
)

# ---- motion ----

alpha = d.angle("alpha", "turn of the platform about the vertical", latex=r"\alpha")
beta = d.angle(
    "beta", "tilt of the platform about the axis that turned with it", range=(-1.6, 1.6),
    latex=r"\beta",
)  # fmt: skip
alpha_dot, beta_dot = alpha.rate(), beta.rate()
alpha_ddot = alpha_dot.rate("alpha_ddot", "rate of alpha_dot")
beta_ddot = beta_dot.rate("beta_ddot", "rate of beta_dot")
enu = d.unit_vector("enu", "unit vector to the sun", latex=r"\mathbf{c}")

# ---- loads ----

f_d = d.vector(
    "f_d",
    "disturbing force on the platform at o, which the column takes: it does no work. A force on "
    "another point, such as wind, comes in by its moment about o, n_d",
    unit=NEWTON,
    range=(-500.0, 500.0),
    latex=r"\mathbf{f}_\mathrm{d}",
)
n_d = d.vector(
    "n_d",
    "disturbing moment on the platform about o, world axes",
    unit=NEWTON_METRE,
    range=(-200.0, 200.0),
    latex=r"\mathbf{n}_\mathrm{d}",
)

STATE = [alpha, beta, alpha_dot, beta_dot, alpha_ddot, beta_ddot]
DISTURBANCE = [f_d, n_d]

# ---- tolerances ----

leg_tolerance = d.constant(
    "leg_tolerance",
    "1e-6",
    "length below which a leg has no direction",
    unit=METRE,
    latex=r"\tau_l",
)
axis_tolerance = d.constant(
    "axis_tolerance",
    "1e-5",
    "cosine below which a leg stands along the first axis of its universal joint",
    latex=r"\tau_c",
)
hold_tolerance = d.constant(
    "hold_tolerance",
    "1e-5",
    "part of the sum of r squared below which the area that the columns of J span is taken as 0",
    latex=r"\tau_h",
)
mass_tolerance = d.constant(
    "mass_tolerance",
    "1e-5",
    "part of the inertia of beta below which what is left of it with alpha free is taken as 0",
    latex=r"\tau_H",
)
least_inertia = d.constant(
    "least_inertia",
    "1e-9",
    "moment of inertia below which an angle moves no mass",
    unit=KILOGRAM * METRE**2,
    latex=r"\tau_I",
)
