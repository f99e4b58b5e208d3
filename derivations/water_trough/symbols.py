"""The record of the water-displacement trough, and the quantities that its parts share."""

from armillary import Derivation, Kind
from armillary.derivation.units import KILOGRAM, METRE, SECOND

derivation = d = Derivation(
    "water_trough",
    title="Trough turned by water",
    paper="salgado2014",
    summary="A parabolic trough turns about a level axis that two bearings carry. A container "
    "hangs at either side of it, and a pump moves water from one to the other: the heavier side "
    "sinks, and the trough follows the sun. Of the paper's mechanics only the balance of forces "
    "survives; the moment equation announced as (3) is lost. The page derives a complete model of "
    "one freedom in the paper's nomenclature. The line that claims a printed equation carries its "
    "number; every other line is ours.",
)

AREA, VOLUME = METRE**2, METRE**3
FIRST, SECOND_MOMENT = KILOGRAM * METRE, KILOGRAM * METRE**2
FLOW = VOLUME / SECOND


def positive(name, meaning, unit, least, most, usual, **more):
    """A parameter that may not be 0 or less."""
    return d.parameter.scalar(
        name, meaning, unit=unit, kind=Kind.NON_NEGATIVE, limits=(least, most), range=usual, **more
    )


def place(name, meaning, usual, **more):
    """A coordinate in the frame of the trough."""
    return d.parameter.scalar(
        name, meaning, unit=METRE, limits=(-100.0, 100.0), range=usual, **more
    )


# ---- the dry trough ----

M = positive("M", "mass of the concentrator, without water", KILOGRAM, 0.0, 1e5, (5.0, 200.0))
l = positive(
    "l", "distance of the concentrator's centre of mass from the axis", METRE, 0.0, 100.0,
    (0.0, 0.3), latex=r"\ell",
)  # fmt: skip
lam = d.parameter.angle(
    "lam",
    "direction of that centre of mass, from xi towards eta: -pi/2 is below the axis",
    range=(-2.2, -0.9),
    latex=r"\lambda",
)
I_zz = positive(
    "I_zz", "moment of inertia of the concentrator about the axis", SECOND_MOMENT, 0.0, 1e6,
    (2.0, 50.0), latex="I_{zz}",
)  # fmt: skip

# ---- the containers ----

_AREA = (1e-4, 100.0)
A_1 = positive("A_1", "floor area of container 1", AREA, *_AREA, (0.02, 0.2), latex="A_1")
A_2 = positive("A_2", "floor area of container 2", AREA, *_AREA, (0.02, 0.2), latex="A_2")
w = positive("w", "width of either container across the axis", METRE, 0.0, 100.0, (0.05, 0.3))
x_1 = place("x_1", "centre of container 1's floor, along xi", (-1.0, -0.3))
y_1 = place("y_1", "centre of container 1's floor, along eta", (-0.3, 0.1))
x_2 = place("x_2", "centre of container 2's floor, along xi", (0.3, 1.0))
y_2 = place("y_2", "centre of container 2's floor, along eta", (-0.3, 0.1))
_LEVEL = (METRE, 0.0, 10.0)
h_10 = positive("h_10", "level in container 1 before any water is moved", *_LEVEL, (0.05, 0.1))
h_20 = positive("h_20", "level in container 2 before any water is moved", *_LEVEL, (0.05, 0.1))
h_max = positive(
    "h_max", "height of either container", *_LEVEL, (0.15, 0.3), latex=r"h_\mathrm{max}"
)

# ---- the tube, full of water ----

a_t = positive("a_t", "cross-section of the tube", AREA, 1e-6, 1.0, (1e-4, 1e-3), latex="a_t")
L_t = positive("L_t", "length of the tube", METRE, 0.0, 100.0, (1.0, 3.0), latex="L_t")
m_t = positive("m_t", "mass of the water in the tube", KILOGRAM, 0.0, 1e5, (0.1, 3.0))
_FIRST = {"unit": FIRST, "limits": (-1e5, 1e5), "range": (-0.3, 0.3)}
S_t_xi = d.parameter.scalar(
    "S_t_xi",
    "first moment S_t of the water in the tube: its component along xi, given by itself",
    latex=r"S_{t\xi}",
    **_FIRST,
)
S_t_eta = d.parameter.scalar("S_t_eta", "the same along eta", latex=r"S_{t\eta}", **_FIRST)
I_t = positive(
    "I_t", "second moment of the water in the tube about the axis", SECOND_MOMENT, 0.0, 1e6,
    (0.0, 2.0),
)  # fmt: skip
Gamma_t = d.parameter.scalar(
    "Gamma_t",
    "twice the area that the tube sweeps about the axis on its way from container 2 to 1: the "
    "integral of xi d(eta) - eta d(xi)",
    unit=AREA,
    limits=(-1e4, 1e4),
    range=(-0.5, 0.5),
    latex=r"\Gamma_t",
)

# ---- what is around ----

rho = positive(
    "rho", "density of the water", KILOGRAM / VOLUME, 1e-3, 2e4, (990.0, 1010.0), latex=r"\rho"
)
g = positive("g", "acceleration of free fall", METRE / SECOND**2, 0.0, 1e3, (0.0, 10.0))
mu = d.parameter.scalar(
    "mu", "friction coefficient of the bearings", kind=Kind.NON_NEGATIVE, limits=(0.0, 10.0),
    range=(0.0, 0.3), latex=r"\mu",
)  # fmt: skip
r_f = positive("r_f", "diameter of the bearings", METRE, 0.0, 100.0, (0.01, 0.06))
r_A = positive("r_A", "distance of bearing A from O along the axis", METRE, 1e-3, 1e3, (0.3, 2.0))
r_B = positive("r_B", "distance of bearing B from O along the axis", METRE, 1e-3, 1e3, (0.3, 2.0))

# ---- state ----

theta = d.angle(
    "theta", "turn of the trough about the axis; filling container 1 turns it on",
    range=(-1.6, 1.6), latex=r"\theta",
)  # fmt: skip
omega = theta.rate("omega", "angular velocity of the trough", limits=(-1e3, 1e3))
alpha = omega.rate("alpha", "angular acceleration of the trough")
s = d.scalar(
    "s", "volume moved from container 2 to 1", unit=VOLUME, limits=(-1e3, 1e3),
    range=(-1e-3, 1e-3),
)  # fmt: skip
# Squares of forces stay within single precision up to these limits.
q = s.rate("q", "flow from container 2 to 1", limits=(-10.0, 10.0), range=(-1e-3, 1e-3))
q_dot = q.rate("q_dot", "rate of the flow", limits=(-1e3, 1e3), range=(-1e-2, 1e-2))
STATE = [theta, omega, s, q, q_dot]
