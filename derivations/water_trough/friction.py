"""Friction of the bearings, in closed form although the force on them holds the acceleration."""

from armillary import hypot, one_like, sqrt, substitute, time_derivative, where
from armillary.derivation.units import METRE, NEWTON, NEWTON_METRE, RADIAN, SECOND

from .balance import F_A, F_B, F_held, lever, share_A
from .motion import T, V, drive, needed, pressure
from .symbols import SECOND_MOMENT, alpha, d, mu, omega, positive, q, q_dot, r_f
from .water import inertia

jam_tolerance = d.constant(
    "jam_tolerance",
    "1e-3",
    "how far the square of the friction's own lever must stay below 1",
    latex=r"\tau_j",
)
least_inertia = d.constant(
    "least_inertia",
    "1e-9",
    "moment of inertia below which there is nothing to turn",
    unit=SECOND_MOMENT,
    latex=r"\tau_I",
)
arm = d.define(
    "arm",
    mu * r_f / 2,
    because="Friction acts at the bearing's surface; r_f is its diameter.",
    meaning="moment of friction per unit of force on the bearings",
    unit=METRE,
    latex="k",
)
inertialess = d.define(
    "inertialess",
    ~(inertia > least_inertia),
    because="There is nothing to turn.",
    meaning="whether the trough has no moment of inertia",
)
_I = where(inertialess, one_like(inertia), inertia)
alpha_free = d.define(
    "alpha_free",
    drive / _I,
    because="The moment equation, solved.",
    meaning="angular acceleration if the bearings had no friction",
    unit=RADIAN / SECOND**2,
    latex=r"\alpha_0",
)
f = d.define(
    "f",
    arm * (F_held + alpha_free * lever),
    because="What the bearings would carry, times the arm.",
    meaning="friction moment, as a vector along the force, if friction did not slow the trough",
    unit=NEWTON_METRE,
    latex=r"\mathbf{f}",
)
self_lever = d.define(
    "self_lever",
    (arm / _I) * lever,
    because="A moment of friction slows the trough, and that changes the force on the bearings.",
    meaning="change of f per unit of friction moment",
    latex=r"\boldsymbol{\varepsilon}",
)
jammed = d.define(
    "jammed",
    ~(~inertialess & (self_lever.dot(self_lever) < 1 - jam_tolerance)),
    because="Where friction raises the force on the bearings by more than itself, no acceleration "
    "balances, or two do. The arm k would have to be as long as the square of the radius of "
    "gyration over the distance of the mass centre, and so at least as long as that radius.",
    meaning="whether the bearings would jam, or nothing has inertia",
)


def size(part):
    """The moment of friction when that part of it, -1 to 1, acts."""
    safe = where(jammed, 0, part)
    slope = safe * f.dot(self_lever)
    across = safe * f.cross(self_lever).z
    return (sqrt(f.dot(f) - across * across) - slope) / (
        1 - safe * safe * self_lever.dot(self_lever)
    )


stands = d.define(
    "stands",
    ~(omega < 0) & ~(omega > 0),
    because="Dry friction has a direction only in motion.",
    meaning="whether the trough stands still",
)
M_most = d.define(
    "M_most",
    arm * F_held.norm(),
    because="At rest friction takes any value up to this one.",
    meaning="largest moment of friction at rest",
    unit=NEWTON_METRE,
    latex=r"M_\mathrm{s}",
)
sticks = d.define(
    "sticks",
    stands & ~(drive > M_most) & ~(drive < -M_most),
    because="What drives the trough does not overcome friction.",
    meaning="whether friction holds the trough at rest",
)
direction = d.define(
    "direction",
    where(stands, where(drive < 0, -1, 1), where(omega < 0, -1, 1)),
    because="Friction acts against the motion, or against the one that is about to begin.",
    meaning="sense of the motion",
    latex=r"\sigma",
)
M_slip = d.define(
    "M_slip",
    size(direction),
    because="The size m of the friction moment is k times the length of a force that holds the "
    "acceleration, which holds m: m = |f - sigma m epsilon|. Squared, this is a quadratic in m; "
    "of its roots the one that is positive is taken, for either sense of the motion.",
    meaning="size of the friction moment in motion",
    unit=NEWTON_METRE,
    latex="m",
)
M_F = d.define(
    "M_F",
    where(sticks, -drive, -direction * M_slip),
    because="At rest friction balances what drives; in motion it acts against it.",
    meaning="moment of friction of both bearings on the trough",
    unit=NEWTON_METRE,
    latex="M_F",
)
alpha_found = d.define(
    "alpha_found",
    where(sticks, 0, (drive - direction * M_slip) / _I),
    because="The moment equation with the friction that is now known.",
    meaning="angular acceleration",
    unit=RADIAN / SECOND**2,
    latex=r"\alpha",
)


def found(expression):
    """With the acceleration that the moments give."""
    return substitute(expression, {alpha: alpha_found})


F_A_found, F_B_found = (
    d.define(
        f"F_{letter}_found",
        found(force),
        because="The force at the acceleration that friction leaves.",
        meaning=f"force of bearing {letter} on the trough in motion, level and upward",
        unit=NEWTON,
        latex=rf"\mathbf{{F}}_{letter}",
    )
    for letter, force in (("A", F_A), ("B", F_B))
)
M_FA, M_FB = (
    d.define(
        f"M_F{letter}",
        share * M_F,
        because="In motion each bearing has k times the force that it carries. At rest only the "
        "sum is determined: that it is split alike there is a convention.",
        meaning=f"moment of friction of bearing {letter} on the trough",
        unit=NEWTON_METRE,
        latex=rf"M_{{F{letter}}}",
    )
    for letter, share in (("A", share_A), ("B", 1 - share_A))
)
pressure_found = d.define(
    "pressure_found",
    found(pressure),
    because="The pump pushes water through the trough as it moves.",
    meaning="pressure that the pump must give at the acceleration that friction leaves",
    latex="p",
)

# ---- smooth friction, for integrators that know no events ----

omega_s = positive(
    "omega_s", "angular velocity at which smooth friction has 0.71 of its size",
    RADIAN / SECOND, 1e-9, 1e3, (1e-4, 0.1), latex=r"\omega_\mathrm{s}",
)  # fmt: skip
tau = d.define(
    "tau",
    omega / hypot(omega, omega_s),
    because="A ramp instead of a step: an integrator meets no event, but nothing ever sticks.",
    meaning="part of the friction that acts, -1 to 1",
    latex=r"\tau",
)
M_F_smooth = d.define(
    "M_F_smooth",
    -tau * size(tau),
    because="The same quadratic with a part of the friction.",
    meaning="moment of smooth friction",
    unit=NEWTON_METRE,
    latex=r"\tilde{M}_F",
)
alpha_smooth = d.define(
    "alpha_smooth",
    (drive + M_F_smooth) / _I,
    because="The moment equation with smooth friction.",
    meaning="angular acceleration under smooth friction",
    unit=RADIAN / SECOND**2,
    latex=r"\tilde{\alpha}",
)

# What still water asks of friction at rest, and the most that friction could give.
_drive, _most = (substitute(x, {omega: 0, q: 0, q_dot: 0}) for x in (drive, M_most))
slips = d.define(
    "slips",
    ~((_most > _drive) & (_most > -_drive)),
    because="Beyond what friction can carry nothing holds.",
    meaning="whether the weight overcomes friction",
)
_safe = where(slips, 0, _drive)
_room = (_most - _safe) * (_most + _safe)
creep = d.define(
    "creep",
    omega_s * _safe / sqrt(where(slips, one_like(_room), _room)),
    because="Where dry friction would hold, smooth friction carries the drive at the speed at "
    "which tau is the part of the largest friction that the drive takes.",
    meaning="angular velocity at which the trough creeps under smooth friction, the water at rest",
    unit=RADIAN / SECOND,
    latex=r"\omega_\mathrm{c}",
)

# ---- power ----

pumped = d.define(
    "pumped",
    pressure_found * q,
    because="Pressure times flow.",
    meaning="power of the pump, without what the tube loses",
    unit=NEWTON_METRE / SECOND,
    latex="P_q",
)
lost = d.define(
    "lost",
    -M_F * omega,
    because="Friction acts against the motion.",
    meaning="power that the bearings turn into heat",
    unit=NEWTON_METRE / SECOND,
    latex="P_F",
)
d.identity(
    "energy grows by what pump and outer moment put in, whatever the motion",
    time_derivative(T + V),
    pressure * q + needed * omega,
)
