"""The moment equation and the pump's pressure, from one Lagrangian."""

from armillary import cos, partial, sin, substitute, time_derivative
from armillary.derivation.units import NEWTON_METRE, PASCAL

from .symbols import alpha, d, g, omega, q, rho, s, theta
from .water import Gamma, S, inertia, m_eff

T = d.define(
    "T",
    inertia * omega * omega / 2 + rho * Gamma * q * omega + m_eff * q * q / 2,
    because="A parcel moves with the trough and, on top of that, with the flow: the square of the "
    "sum has the turn, the flow, and twice their product.",
    meaning="kinetic energy of trough and water",
    unit=NEWTON_METRE,
    latex="T",
)
V = d.define(
    "V",
    g * (S.x * sin(theta) + S.y * cos(theta)),
    because="Weight times height.",
    meaning="potential energy, zero where the mass centre is level with the axis",
    unit=NEWTON_METRE,
    latex="V",
)
momentum = d.define(
    "momentum",
    partial(T, omega),
    because="What turns, and what flows past the axis.",
    meaning="moment of momentum about the axis",
    latex=r"\partial T/\partial\omega",
)
needed = d.define(
    "needed",
    time_derivative(momentum) - partial(T, theta) + partial(V, theta),
    because="Lagrange's equation of theta, ours: the paper announces its moment equation as (3), "
    "and the file ends before it.",
    meaning="moment that must act on the trough from outside, besides its weight",
    unit=NEWTON_METRE,
    latex=r"M_\theta",
)
drive = d.define(
    "drive",
    -substitute(needed, {alpha: 0}),
    because="The equation is linear in the acceleration, with the moment of inertia before it.",
    meaning="moment of weight and water that accelerates the trough",
    unit=NEWTON_METRE,
    latex="N",
)
pressure = d.define(
    "pressure",
    time_derivative(partial(T, q)) - partial(T, s) + partial(V, s),
    because="Lagrange's equation of the volume moved: what does work on a volume is a pressure. It "
    "is called pressure since the C functions take their parameters as p.",
    meaning="pressure that the pump must give; losses in the tube come on top",
    unit=PASCAL,
    latex="p",
)
