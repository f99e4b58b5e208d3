"""Power of the drives, what their motors lose, and the energy of what moves."""

from armillary import PI, Body, Matrix, Rate, X, at, elementary, number, total, vector
from armillary.derivation.units import AMPERE, METRE, NEWTON, NEWTON_METRE, OHM, WATT

from .dynamics import I_leg, Omega_m
from .forces import F_2, F_q
from .legs import a_c, q_dot
from .legs_in_motion import omega, u, v, y_leg
from .symbols import I_m, I_s, I_t, beta, d, g, h, h_0, leg, m_m, m_s, m_t, r_sc, s, t

F_leg = d.scalar(
    "F_leg", "force of drive i, extending positive", unit=NEWTON, range=(-500.0, 500.0), per=leg,
    latex=r"F",
)  # fmt: skip
_MOTOR = {"rate": Rate.MOUNT}
K_M = d.scalar(
    "K_M", "torque constant of a motor", unit=NEWTON_METRE / AMPERE, limits=(1e-4, 1e6),
    range=(0.01, 1.0), latex="K_M", **_MOTOR,
)  # fmt: skip
R_w = d.scalar(
    "R_w", "resistance of a motor's winding", unit=OHM, limits=(0.0, 1e6), range=(0.0, 10.0),
    latex="R_w", **_MOTOR,
)  # fmt: skip
lead = d.scalar(
    "lead", "travel of a screw per turn", unit=METRE, limits=(0.0, 10.0), range=(0.001, 0.02),
    latex="d", **_MOTOR,
)  # fmt: skip

P_q = d.define(
    "P_q",
    vector(*(F_q[k] * at(q_dot, leg, k) for k in range(leg.size))),
    because="A drive does its force times the speed at which its leg extends.",
    meaning="mechanical power of the three drives",
    printed="34",
    latex=r"\mathbf{P}",
)
P_2 = d.define(
    "P_2",
    Matrix((tuple(F_2.rows[0][k] * at(q_dot, leg, k) for k in (0, 1)),)),
    because="A drive does its force times the speed at which its leg extends.",
    meaning="mechanical power of the two drives where leg 3 is absent",
    unit=WATT,
    latex=r"\mathbf{P}_2",
)
torque = d.define(
    "torque",
    F_leg * lead / (2 * PI),
    because="A screw without friction: what a turn does at the motor it does along the leg.",
    meaning="moment of motor i",
    printed="36",
    latex="T",
)
current = d.define(
    "current",
    torque / K_M,
    because="A motor's moment is proportional to its current.",
    meaning="current of motor i",
    latex="I",
)
P_copper = d.define(
    "P_copper",
    current * current * R_w,
    because="The winding resists: its heat is the resistance times the square of the current.",
    meaning="heat of motor i",
    printed="35",
    latex=r"P_\mathrm{Cu}",
)

# ---- energy ----

_v_S = vector(v.x - s * u.x, v.y, v.z - s * u.z)
T_leg = d.define(
    "T_leg",
    (
        Body(m_t, I_t).kinetic_energy(t * u, vector(0, 0, 0))
        + Body(m_s, I_s).kinetic_energy(_v_S, vector(0, 0, 0))
        + Body(number(0), I_leg).kinetic_energy(vector(0, 0, 0), omega)
    ),
    because="A body's kinetic energy is that of its centre of mass and that of turning about it.",
    meaning="kinetic energy of both links of leg i",
    latex="T_i",
)
T = d.define(
    "T",
    total(T_leg, over=leg) + Body(m_m, I_m).kinetic_energy(vector(0, 0, 0), Omega_m),
    because="The platform turns about o, which stands still.",
    meaning="kinetic energy of platform and legs",
    latex="T",
)
V_leg = d.define(
    "V_leg",
    (m_t * (h + t * y_leg.z) + m_s * (h_0 + a_c.z - s * y_leg.z)) * g,
    because="Potential energy is weight times the height of the centre of mass above the ground.",
    meaning="potential energy of both links of leg i, zero on the ground",
    latex="V_i",
)
V = d.define(
    "V",
    total(V_leg, over=leg) + m_m * g * (h_0 + (elementary(X, beta) @ r_sc).z),
    because="Weight times height; no turn about the vertical changes it.",
    meaning="potential energy of platform and legs, zero on the ground",
    latex="V",
)
