"""The water: levels, and its mass moments as polynomials of the volume moved."""

from armillary import cos, sin, vector
from armillary.derivation.units import KILOGRAM, NEWTON

from .symbols import (
    A_1,
    A_2,
    AREA,
    FIRST,
    SECOND_MOMENT,
    VOLUME,
    Gamma_t,
    I_t,
    I_zz,
    L_t,
    M,
    S_t_eta,
    S_t_xi,
    a_t,
    d,
    g,
    h_10,
    h_20,
    h_max,
    l,
    lam,
    m_t,
    rho,
    s,
    w,
    x_1,
    x_2,
    y_1,
    y_2,
)  # fmt: skip

h_1 = d.define(
    "h_1",
    h_10 + s / A_1,
    because="What leaves container 2 arrives in container 1, whose walls are straight. By "
    "convention the surface stays parallel to the floor, as under a lid that slides with it; a "
    "surface left to itself is level at the speed of tracking, and the section on it tells what "
    "that changes.",
    meaning="level in container 1",
    latex="h_1",
)
h_2 = d.define(
    "h_2",
    h_20 - s / A_2,
    because="Container 2 loses the same volume.",
    meaning="level in container 2",
    latex="h_2",
)
spilt = d.define(
    "spilt",
    ~(~(h_1 < 0) & ~(h_2 < 0) & ~(h_1 > h_max) & ~(h_2 > h_max)),
    because="A container gives no more than it holds, and holds no more than its height.",
    meaning="whether a container would overflow, or hold less than nothing",
)
dry = d.define(
    "dry",
    ~((h_1 > 0) & (h_2 > 0)),
    because="The pump of an empty container draws air.",
    meaning="whether a container is empty",
)
m_1 = d.define(
    "m_1",
    rho * A_1 * h_1,
    because="Density times volume.",
    meaning="mass of the water in container 1",
    unit=KILOGRAM,
    latex="m_1",
)
m_2 = d.define(
    "m_2",
    rho * A_2 * h_2,
    because="Density times volume.",
    meaning="mass of the water in container 2",
    unit=KILOGRAM,
    latex="m_2",
)
F_1 = d.define(
    "F_1",
    m_1 * g,
    because="The paper names a force on container 1 and gives no formula for it. We read it as the "
    "weight of the water.",
    meaning="weight of the water in container 1",
    unit=NEWTON,
    latex="F_1",
)
F_2 = d.define(
    "F_2",
    m_2 * g,
    because="The weight of what container 2 holds.",
    meaning="weight of the water in container 2",
    unit=NEWTON,
    latex="F_2",
)
m_all = d.define(
    "m_all",
    M + rho * (A_1 * h_10 + A_2 * h_20) + m_t,
    because="Moving water changes no mass.",
    meaning="mass of the trough with all its water",
    unit=KILOGRAM,
    latex="m",
)

# ---- first moments: where the weight is ----

S = d.define(
    "S",
    vector(
        M * l * cos(lam) + m_1 * x_1 + m_2 * x_2 + S_t_xi,
        M * l * sin(lam) + m_1 * (y_1 + h_1 / 2) + m_2 * (y_2 + h_2 / 2) + S_t_eta,
        0,
    ),
    because="Mass times place, in the frame of the trough; a column of water has its centre at "
    "half its height.",
    meaning="first mass moment about the axis, frame of the trough",
    unit=FIRST,
    latex=r"\mathbf{S}",
)


def _column(mass, x, y, h):
    """Second moment of a column of water about the axis."""
    return mass * (x * x + w * w / 12 + y * y + y * h + h * h / 3)


inertia = d.define(
    "inertia",
    I_zz + _column(m_1, x_1, y_1, h_1) + _column(m_2, x_2, y_2, h_2) + I_t,
    because="The same convention: the water turns with the trough, as if it were frozen. With a "
    "surface left to itself a part of it would not.",
    meaning="moment of inertia of the trough with its water about the axis",
    unit=SECOND_MOMENT,
    latex="I",
)
Gamma = d.define(
    "Gamma",
    x_1 * h_1 - x_2 * h_2 + Gamma_t,
    because="Water that rises by d(h) at the distance x from the axis has the moment of momentum "
    "x of its momentum; in container 2 it sinks.",
    meaning="arm of the flow: its moment of momentum about the axis is rho Gamma q",
    unit=AREA,
    latex=r"\Gamma",
)
m_eff = d.define(
    "m_eff",
    rho * (h_1 / A_1 + h_2 / A_2 + L_t / a_t),
    because="A flow q moves at q over the cross-section. The narrow tube counts most.",
    meaning="inertia of the flow: its kinetic energy is m_eff q^2 / 2",
    unit=KILOGRAM / VOLUME / VOLUME * AREA,
    latex=r"m_\mathrm{eff}",
)

# ---- what cannot belong to one trough ----

fit_tolerance = d.constant(
    "fit_tolerance",
    "1e-3",
    "part by which parameters that follow from each other may differ",
    latex=r"\tau_f",
)
m_fit = d.define(
    "m_fit",
    rho * a_t * L_t,
    because="The tube is full, and has one cross-section.",
    meaning="mass of the water that a tube of that length and cross-section holds",
    unit=KILOGRAM,
    latex=r"\hat m_t",
)
misfit = d.define(
    "misfit",
    ~(~(m_t - m_fit > fit_tolerance * m_fit) & ~(m_fit - m_t > fit_tolerance * m_fit)),
    because="The mass of the tube's water is given beside its length: a slip in either shows.",
    meaning="whether mass, length and cross-section of the tube contradict each other",
)
too_slight = d.define(
    "too_slight",
    ~(
        ~(M * l * l * (1 - fit_tolerance) > I_zz)
        & ~(inertia * m_eff < (rho * Gamma) * (rho * Gamma))
    ),
    because="No body has less inertia about the axis than its mass gathered at its centre, and no "
    "motion of water and trough together has a negative kinetic energy.",
    meaning="whether the inertia is less than any body's of that mass and centre, or than any "
    "water's on that way",
)
