"""Where the trough comes to rest, how stiff it is there, and what friction makes of it."""

from armillary import (
    PI,
    absolute,
    arcsin,
    atan2,
    hypot,
    one_like,
    partial,
    sqrt,
    where,
)  # fmt: skip
from armillary.derivation.units import METRE, NEWTON_METRE, RADIAN, SECOND

from .friction import arm, inertialess
from .motion import V
from .symbols import FLOW, VOLUME, d, g, s, theta
from .water import S, inertia, m_all

balance_tolerance = d.constant(
    "balance_tolerance",
    "1e-6",
    "distance of the mass centre from the axis below which every angle is a rest",
    unit=METRE,
    latex=r"\tau_S",
)
swing_tolerance = d.constant(
    "swing_tolerance",
    "1e-12",
    "stiffness over moment of inertia below which nothing drives the trough back",
    unit=SECOND**-2,
    latex=r"\tau_\omega",
)
gain_tolerance = d.constant(
    "gain_tolerance",
    "1e-6",
    "turn per volume below which moving water turns nothing",
    unit=RADIAN / VOLUME,
    latex=r"\tau_g",
)
reach = d.define(
    "reach",
    hypot(S.x, S.y),
    because="Mass times the distance of its centre.",
    meaning="length of the first moment",
    latex="|S|",
)
indifferent = d.define(
    "indifferent",
    ~(reach > balance_tolerance * m_all),
    because="With its mass centre on the axis the trough rests anywhere.",
    meaning="whether the mass centre lies on the axis",
)
_Sx = where(indifferent, 0, S.x)
_Sy = where(indifferent, -one_like(reach), S.y)
theta_rest = d.define(
    "theta_rest",
    atan2(-_Sx, -_Sy),
    because="The mass centre hangs below the axis. It is the least of V; the greatest, half a "
    "turn on, is the rest that does not last.",
    meaning="angle at which the trough rests without friction, in [-pi, pi]",
    unit=RADIAN,
    latex=r"\theta_0",
)
stiffness = d.define(
    "stiffness",
    g * reach,
    because="The second derivative of V where the mass centre hangs below the axis.",
    meaning="moment per angle that drives the trough back to rest",
    unit=NEWTON_METRE,
    latex="K",
)
d.identity(
    "slope and curvature of V turn into each other: the stiffness is the largest of either",
    partial(V, theta) * partial(V, theta)
    + partial(partial(V, theta), theta) * partial(partial(V, theta), theta),
    stiffness * stiffness,
)
still = d.define(
    "still",
    ~(~indifferent & (stiffness > swing_tolerance * inertia)),
    because="Without weight nothing swings.",
    meaning="whether nothing drives the trough back",
)
_idle = ~(~still & ~inertialess)
period = d.define(
    "period",
    2 * PI * sqrt(where(_idle, 0, inertia / where(_idle, one_like(stiffness), stiffness))),
    because="A physical pendulum. It swings with the water held by the pump.",
    meaning="period of small swings about the rest, 0 where nothing drives the trough back",
    unit=SECOND,
    latex=r"T_0",
)
gain = d.define(
    "gain",
    where(
        indifferent,
        0,
        (_Sy * partial(S.x, s) - _Sx * partial(S.y, s)) / (_Sx * _Sx + _Sy * _Sy),
    ),
    because="The derivative of the rest angle by the volume: the first moment turns by what is "
    "added across it.",
    meaning="turn of the rest angle per volume moved",
    unit=RADIAN / VOLUME,
    latex=r"\theta_0'",
)
theta_dot_ref = d.scalar(
    "theta_dot_ref", "rate at which the trough is to turn", unit=RADIAN / SECOND,
    limits=(-1e3, 1e3), range=(-0.01, 0.01), latex=r"\dot\theta_\mathrm{ref}",
)  # fmt: skip
level_gain = d.define(
    "level_gain",
    ~(absolute(gain) > gain_tolerance),
    because="Water moved along the line to the mass centre turns nothing.",
    meaning="whether moving water does not turn the rest",
)
q_follow = d.define(
    "q_follow",
    where(level_gain, 0, theta_dot_ref / where(level_gain, one_like(gain), gain)),
    because="The rest must turn as fast as the sun.",
    meaning="flow at which the rest turns at the rate wanted",
    unit=FLOW,
    latex=r"q_\mathrm{ref}",
)

# ---- friction at rest ----

held_everywhere = d.define(
    "held_everywhere",
    ~(~indifferent & (g > 0) & (reach > arm * m_all)),
    because="The largest moment of the weight about the axis does not overcome friction.",
    meaning="whether friction holds the trough at every angle",
)
half_width = d.define(
    "half_width",
    where(
        held_everywhere,
        PI,
        arcsin(where(held_everywhere, 0, arm * m_all / where(indifferent, one_like(reach), reach))),
    ),
    because="At rest the bearings carry the weight. Friction holds while the mass centre stands "
    "off the axis' vertical by less than the arm.",
    meaning="half of the range of angles about the rest where friction holds the trough",
    unit=RADIAN,
    latex=r"\Delta\theta",
)
