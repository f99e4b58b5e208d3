"""The control law of a rod, and its discrete form."""

from armillary import Kind, where
from armillary.derivation.units import METRE, NEWTON, SECOND

from .symbols import d

SPEED = METRE / SECOND

# ---- gains ----


def _gain(name, meaning, unit, most, limits=(0.0, 1e12), least=0.0, latex=None):
    """A setting of the law that is not negative; `least` and `most` bound its range."""
    return d.parameter.scalar(
        name, meaning, unit=unit, kind=Kind.NON_NEGATIVE, range=(least, most), limits=limits,
        latex=latex,
    )  # fmt: skip


K_P = _gain("K_P", "gain of the error", NEWTON / METRE, 1e7)
K_I = _gain("K_I", "gain of the error's integral", NEWTON / METRE / SECOND, 1e9)
K_D = _gain("K_D", "gain of the error's rate", NEWTON / SPEED, 1e6)
T_D = _gain("T_D", "time constant of the filter of the measured speed", SECOND, 1.0)
T_S = _gain("T_S", "sampling period", SECOND, 1.0, limits=(1e-6, 1e3), least=1e-5)
F_max = _gain("F_max", "largest force of the drive", NEWTON, 1e5, latex=r"F_\mathrm{max}")
K_V = _gain("K_V", "feed-forward of the viscous friction", NEWTON / SPEED, 1e5)
F_C = _gain("F_C", "feed-forward of the dry friction", NEWTON, 1e4)
v_C = _gain(
    "v_C", "speed at which the dry friction is given in full", SPEED, 1.0,
    limits=(1e-9, 1e3), least=1e-8,
)  # fmt: skip

# ---- what is known at a sample ----

# A reading that no rod has is refused, so that it cannot stay in the states: what legal inputs make
# of these is within their limits.
_LENGTH = {"unit": METRE, "limits": (-100.0, 100.0), "range": (0.0, 10.0)}

l_ref = d.scalar("l_ref", "wanted length of the rod", latex=r"l_\mathrm{ref}", **_LENGTH)
l_dot_ref = d.scalar(
    "l_dot_ref", "its rate", unit=SPEED, range=(-1.0, 1.0), latex=r"\dot{l}_\mathrm{ref}"
)
l_measured = d.scalar("l_measured", "measured length of the rod", latex=r"l_\mathrm{m}", **_LENGTH)
F_ff = d.scalar(
    "F_ff",
    "force known beforehand, such as static_forces gives",
    unit=NEWTON,
    range=(-1e3, 1e3),
    latex=r"F_\mathrm{ff}",
)
F_start = d.scalar(
    "F_start",
    "force that the integral starts from: 0, or what holds the rod now less what is fed forward",
    unit=NEWTON,
    range=(-1e3, 1e3),
    latex=r"F_0",
)
integral = d.state.scalar(
    "integral",
    "integral part of the force",
    unit=NEWTON,
    limits=(-1e20, 1e20),
    range=(-1e4, 1e4),
    latex="J_I",
)
v = d.state.scalar(
    "v",
    "filtered speed of the rod",
    unit=SPEED,
    limits=(-1e10, 1e10),
    range=(-1.0, 1.0),
    latex="v",
)
l_before = d.state.scalar(
    "l_before", "length measured at the sample before", latex=r"l_{-}", **_LENGTH
)


def held(value, bound):
    """A value between two bounds of one size."""
    return where(value < -bound, -bound, where(value > bound, bound, value))


# ---- the law ----

error = d.define(
    "error",
    l_ref - l_measured,
    because="What is wanted less what is measured, before the force of this sample acts.",
    meaning="error of the rod's length",
    latex="e",
)
v_next = d.define(
    "v_next",
    v + T_S / (T_D + T_S) * ((l_measured - l_before) / T_S - v),
    because="A difference of two readings is coarse by the encoder's step over the period; a "
    "filter of first order, stepped backward, smooths it.",
    meaning="filtered speed of the rod after this sample",
    latex="v_+",
)
F_known = d.define(
    "F_known",
    F_ff + K_V * l_dot_ref + F_C * held(l_dot_ref / v_C, 1),
    because="What is known of the load and the friction need not wait for an error. Dry friction "
    "changes its sign over a range of speeds: a jump would shake the rod where it turns round.",
    meaning="feed-forward force",
    latex=r"F_\mathrm{k}",
)
wanted = d.define(
    "wanted",
    F_known + K_P * error + integral + K_D * (l_dot_ref - v_next),
    because="The rate of the error is that of the wanted length less the measured one's.",
    meaning="force that the law asks for",
    printed="37",
    latex="u",
)
F_drive = d.define(
    "F_drive",
    held(wanted, F_max),
    because="The drive has no more.",
    meaning="force that the drive is told to give",
    latex=r"F_\mathrm{u}",
)
wound = d.define(
    "wound",
    (wanted - F_drive) * error > 0,
    because="While the drive gives all it has, an integral that goes on growing would have to be "
    "undone later.",
    meaning="whether the force is at its bound and the error asks for more",
)
integral_next = d.define(
    "integral_next",
    integral + where(wound, 0, K_I * T_S * error),
    because="The integral takes the error of a period at a time, and nothing while the drive is "
    "at its bound and the error asks for more.",
    meaning="integral part of the force after this sample",
    latex="J_{I+}",
)
