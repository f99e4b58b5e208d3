"""The trough about its rest, for small angles: what a controller is designed with."""

from armillary import one_like, partial, substitute, where

from .friction import inertialess
from .motion import V, drive
from .rest import gain, stiffness
from .symbols import d, g, omega, q, q_dot, rho, s, theta
from .water import Gamma, S, inertia

_V_theta = partial(V, theta)
d.identity(
    "standing still, only the weight and a flow that grows drive the trough",
    substitute(drive, {omega: 0, q: 0}),
    -_V_theta - rho * Gamma * q_dot,
)
d.identity(
    "at the rest, where the slope of V is null and its curvature the stiffness K, the moment by "
    "the volume moved is K times the gain",
    _V_theta * partial(partial(_V_theta, theta), s)
    - partial(_V_theta, theta) * partial(_V_theta, s),
    (g * g) * (S.y * partial(S.x, s) - S.x * partial(S.y, s)),
)
_I = where(inertialess, one_like(inertia), inertia)
swing = d.define(
    "swing",
    where(inertialess, 0, stiffness / _I),
    because="For small deviations e from the rest, and a small volume v moved since, the moment "
    "equation is I e'' = -K (e - gain v) - rho Gamma q'. Dry friction has no linear form: it is "
    "left out. This is the coefficient of e, with its sign turned.",
    meaning="square of the angular frequency of small swings",
    latex=r"\omega_0^2",
)
pull = d.define(
    "pull",
    swing * gain,
    because="Water that is moved shifts the rest by the gain: the coefficient of v.",
    meaning="angular acceleration per volume moved",
    latex=r"\omega_0^2\,\theta_0'",
)
kick = d.define(
    "kick",
    where(inertialess, 0, rho * Gamma / _I),
    because="The moment of momentum that the flow takes up is missing to the trough: the "
    "coefficient of the rate of the flow, with its sign turned.",
    meaning="angular velocity that the trough loses per flow that the pump starts",
    latex=r"\kappa_q",
)
