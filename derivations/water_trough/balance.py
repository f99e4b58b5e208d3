"""The balance of forces: what the bearings carry, and why one freedom is enough."""

from armillary import Matrix, Z, cos, elementary, sin, time_derivative, vector
from armillary.derivation.units import NEWTON

from .symbols import alpha, d, g, omega, r_A, r_B, theta
from .water import S, m_all

UP = vector(0, 1, 0)
AXIS = vector(0, 0, 1)

S_dot = d.define(
    "S_dot",
    time_derivative(S),
    because="Only the water moves in the frame of the trough.",
    meaning="rate of the first moment, as seen from the trough",
    latex=r"\mathring{\mathbf{S}}",
)
lever = d.define(
    "lever",
    AXIS.cross(S),
    because="Turning faster throws every mass at a right angle to its arm.",
    meaning="force on the bearings per unit of angular acceleration",
    latex=r"\mathbf{e}",
)
F_held = d.define(
    "F_held",
    time_derivative(S_dot)
    + (2 * omega) * AXIS.cross(S_dot)
    - (omega * omega) * S
    + (m_all * g) * vector(sin(theta), cos(theta), 0),
    because="The water's own motion, its sideways force in the turning trough, the pull to the "
    "axis, and the weight of all, for either bearing together. Ours, in place of the paper's right "
    "side, which has the acceleration of the concentrator alone.",
    meaning="force of both bearings at no angular acceleration, frame of the trough",
    unit=NEWTON,
    latex=r"\mathbf{F}_0",
)
F_all = d.define(
    "F_all",
    F_held + alpha * lever,
    because="The balance of forces, the paper's line (2) with the water's momentum added: the rate "
    "of momentum is what acts, bearings and weight.",
    meaning="force of both bearings on the trough, frame of the trough",
    unit=NEWTON,
    printed="2",
    latex=r"\mathbf{F}",
)
_turn = elementary(Z, theta)
d.identity(
    "the force is what the momentum of all mass needs, besides its weight",
    _turn @ F_all,
    time_derivative(time_derivative(_turn @ S)) + (m_all * g) * UP,
)

share_A = d.define(
    "share_A",
    r_B / (r_A + r_B),
    because="The trough is symmetric about the plane across the axis through O, where its mass "
    "centre lies: the nearer bearing carries more. The section in three dimensions has the rest.",
    meaning="part of the force that bearing A carries",
    latex=r"\kappa_A",
)


def bearing(name, share):
    """The force of a bearing, level and upward."""
    world = _turn @ (share * F_all)
    return d.define(
        name,
        Matrix(((world.x, world.y),)),
        because="Moments about an axis across the first must balance.",
        meaning=f"force of bearing {name[-1]} on the trough, level and upward",
        unit=NEWTON,
        latex=rf"\mathbf{{F}}_{name[-1]}",
    )


F_A, F_B = bearing("F_A", share_A), bearing("F_B", 1 - share_A)
_A, _B = (vector(*f.rows[0], 0) for f in (F_A, F_B))
d.identity(
    "with this split no moment is left across the axis: one freedom is enough",
    (r_A * AXIS).cross(_A) - (r_B * AXIS).cross(_B),
    vector(0, 0, 0),
)
