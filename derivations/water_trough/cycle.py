"""An on-off pump behind the sun: the steady cycle of stick and slip in which it keeps the trough.

Angles of the iteration are phases of the swing about the edge of friction. Lengths of time go in
and come out; the equation between is one of pure numbers, with a single root in each swing.
"""

from armillary import (
    PI,
    absolute,
    arccos,
    atan2_or_zero,
    cos,
    number,
    one_like,
    partial,
    sin,
    solve,
    sqrt,
    substitute,
    where,
    wrap,
)
from armillary.derivation.units import RADIAN, SECOND

from .friction import arm, inertialess
from .linear import kick
from .rest import gain, half_width, reach, still, theta_dot_ref
from .symbols import FIRST, FLOW, VOLUME, d, g, positive, s
from .water import S, inertia, m_all

STEPS = 14  # the slowest start of a swing ends at rounding error after 12

q_pump = positive("q_pump", "flow of the pump when it runs", FLOW, 0.0, 1e3, (2e-6, 2e-5))
band_on = positive(
    "band_on", "error of the angle at which the pump starts", RADIAN, 0.0, 10.0, (0.001, 0.05)
)
band_off = d.parameter.angle(
    "band_off",
    "error of the angle, in the sense of the motion, at which the pump stops; negative lets it run "
    "ahead of the sun",
    limits=(-10.0, 10.0),
    range=(-0.05, 0.0),
)
lag = positive(
    "lag",
    "time from where the error asks for a change of the flow to the middle of that change: half of "
    "a sampling period and half of a ramp",
    SECOND, 0.0, 1e3, (0.0, 1.0),
)  # fmt: skip
rate_tolerance = d.constant(
    "rate_tolerance",
    "1e-12",
    "angular velocity below which the sun, or what the pump gains on it, stands still",
    unit=RADIAN / SECOND,
    latex=r"\tau_r",
)
phase_tolerance = d.constant(
    "phase_tolerance",
    "1e-4",
    "what may be left of the equation of the cycle",
    latex=r"\tau_\psi",
)

# ---- the edge of friction ----

_least = arm * m_all
_square = reach * reach
gripped = d.define(
    "gripped",
    ~(
        ~still
        & ~inertialess
        & (_square > number("1e-18") * one_like(_square))
        & (_square - _least * _least > number("1e-4") * _square)
    ),
    because="A trough swings about that edge if its weight drives it back by more than friction "
    "holds, and if it has inertia.",
    meaning="whether the trough does not swing about the edge of friction",
)
firm = d.define(
    "firm",
    sqrt(where(gripped, one_like(_square), _square - _least * _least)),
    because="At the edge the mass centre stands off the vertical by the arm; this is what is left "
    "below the axis.",
    meaning="first moment along the vertical at the edge of friction",
    unit=FIRST,
    latex="S_k",
)
_turned = where(theta_dot_ref < 0, -1, 1)
edge_gain = d.define(
    "edge_gain",
    gain
    + _turned
    * (_least / firm)
    * (S.x * partial(S.x, s) + S.y * partial(S.y, s))
    / (firm * firm + _least * _least),
    because="The edge of friction behind the rest, which the trough slides along. It turns as the "
    "rest does, and closer to it as the first moment grows.",
    meaning="turn per volume moved of the edge of friction behind the rest",
    unit=RADIAN / VOLUME,
    latex=r"\theta_k'",
)
edge_swing = d.define(
    "edge_swing",
    sqrt(
        where(
            gripped,
            one_like(g * firm / inertia),
            g * firm / where(gripped, one_like(inertia), inertia),
        )
    ),
    because="The moment equation about the edge, for small angles. The size of dry friction is "
    "taken as constant: off its edge the trough swings as a pendulum does.",
    meaning="angular frequency of swings about the edge of friction",
    unit=RADIAN / SECOND,
    latex=r"\omega_k",
)
no_cycle = d.define(
    "no_cycle",
    ~(absolute(theta_dot_ref) > rate_tolerance),
    because="A sun that stands still starts no pump.",
    meaning="whether there is no cycle",
)
_pushed = edge_gain * q_pump
pace = d.define(
    "pace",
    where(_pushed > rate_tolerance, _pushed, one_like(_pushed)),
    because="While the pump runs.",
    meaning="angular velocity of the edge of friction",
    unit=RADIAN / SECOND,
    latex="v",
)
outrun = d.define(
    "outrun",
    ~((_pushed > rate_tolerance) & (absolute(theta_dot_ref) < number("0.999") * _pushed)),
    because="A pump that is too small never catches up, and where water turns the trough the other "
    "way the law drives it off.",
    meaning="whether the pump does not catch up with the sun",
)
_part = where(theta_dot_ref < 0, -theta_dot_ref, theta_dot_ref) / pace
slow = d.define(
    "slow",
    where(_part < number("0.999"), _part, number("0.5")),
    because="Less than 1, or the pump does not catch up.",
    meaning="rate of the sun over that of the edge",
    latex="r",
)
recoil = d.define(
    "recoil",
    kick * q_pump / pace,
    because="What the trough gains or loses when the flow stops: the moment of momentum of the "
    "water goes to the trough.",
    meaning="change of the trough's speed when the pump stops, over that of the edge",
    latex=r"\chi",
)
swept = d.define(
    "swept",
    where(band_on > band_off, band_on - band_off, 0),
    because="The error is to fall from where the pump starts to where it stops.",
    meaning="width of the dead band",
    unit=RADIAN,
    latex=r"\Delta e",
)

# ---- one slip ----

delay = d.define(
    "delay",
    edge_swing * lag,
    because="The flow changes late.",
    meaning="phase of a swing that goes by until the flow changes",
    latex=r"\delta",
)


def _number(name, value):
    """A number of the cycle by itself: the equation below is then one of numbers, and short."""
    x = d.unknown(name, "a number of the cycle")
    return solve(x - value, {x: value}, steps=1, name=f"take_{name}")[0]


_r, _chi, _delay = _number("r_k", slow), _number("chi_k", recoil), _number("delta_k", delay)
_ahead = 1 - _r
psi = d.unknown("psi", "phase in the last swing of a slip, while it is looked for", latex=r"\psi")


def _off(phase):
    """Place against the edge, and speed, once the flow has stopped, over v and its swing."""
    return -sin(phase), 1 + _chi - cos(phase)


def _coast(phase):
    """How far beyond the edge a trough comes to rest, by v / omega_k; never quite 0."""
    place, speed = _off(phase)
    return sqrt(place * place + speed * speed + number("1e-12"))


# The phase at which the trough gains on the sun as fast as the sun itself moves. A slip that ends
# as close as this to a whole swing does not follow itself: a shorter one has a longer coast.
_floor = arccos(1 - 2 * _r)
_all = d.define(
    "to_sweep",
    edge_swing * swept / pace + slow * delay,
    because="The dead band, and what the sun adds before the flow comes, by the length of a swing.",
    meaning="fall of the error that the slip must bring, by v over the angular frequency",
    latex=r"\epsilon",
)
_sum = _number("epsilon_k", _all)
_most = (_sum + _r * _coast(_delay - _floor) + _ahead * _floor - sin(_floor)) / _ahead - PI
_turns = d.define(
    "whole_swings",
    where(_most > 0, _most - wrap(_most), 0),
    because="A trough that slides behind a moving edge swings: it stands for an instant once in a "
    "turn of the phase. The error reaches where the pump stops in the first swing that is long "
    "enough, but not at its very end: a cycle that ends there does not follow itself.",
    meaning="phase of the whole swings before the one in which the pump is told to stop",
    latex=r"2\pi n",
)
missing = d.define(
    "missing",
    _ahead * psi - sin(psi) - _r * _coast(psi + _delay) - (_sum - _ahead * _turns),
    because="Behind the edge the trough lags by the sine of the phase. Before it could slip the "
    "edge had to come as far as the trough had coasted beyond it, and the sun moved meanwhile. The "
    "same coast follows this slip: the cycle is steady.",
    meaning="what vanishes at the phase at which the pump is told to stop",
    latex=r"\Delta",
)
# From the middle of a swing, where the speed is greatest, Newton's steps do not overshoot.
(_found,) = solve(
    missing, {psi: PI * one_like(_r)}, steps=STEPS, name="slip", within={psi: (0, 2 * PI)}
)
phase = d.define(
    "phase",
    _found + _delay,
    because="The flow stops late as it started late.",
    meaning="phase in the last swing at which the flow has stopped",
    latex=r"\varphi",
)
unfound = d.define(
    "unfound",
    ~(absolute(substitute(missing, {psi: _found})) < phase_tolerance),
    because="Nothing says that the iteration has ended where it should: what is left does.",
    meaning="whether no phase was found",
)
coast = d.define(
    "coast",
    _coast(phase),
    because="Place and speed at the end of the flow make one swing, and the trough sticks where "
    "its speed is null.",
    meaning="how far beyond the edge the trough comes to rest, by v over the angular frequency",
    latex="c",
)
_scale = pace / edge_swing
swings_back = d.define(
    "swings_back",
    (coast * _scale > 2 * half_width),
    because="Beyond the other edge of the range friction does not hold it.",
    meaning="whether the trough swings back after the pump has stopped",
)

# ---- the cycle ----

t_on = d.define(
    "t_on",
    (coast + phase + _turns) / edge_swing,
    because="Until the edge has come to the trough, and then the slip.",
    meaning="time for which the pump runs in a cycle, from the middle of one change of the flow to "
    "that of the other",
    unit=SECOND,
    latex=r"t_\mathrm{on}",
)
travel = d.define(
    "travel",
    pace * t_on,
    because="At the end of a cycle the trough stands to the edge as at its beginning: it has come "
    "as far.",
    meaning="turn of the trough in a cycle",
    unit=RADIAN,
    latex="D",
)
t_cycle = d.define(
    "t_cycle",
    t_on / where(no_cycle, 1, _r),
    because="The sun has come as far, too.",
    meaning="period of the cycle of an on-off pump",
    unit=SECOND,
    latex=r"t_\mathrm{c}",
)
_place, _speed = _off(phase)
# A trough that the recoil would throw back stands at once.
_stop = atan2_or_zero(where(_speed < 0, 0, _speed), _place, ~(coast > number("1e-5")))
error_rest = d.define(
    "error_rest",
    band_on + absolute(theta_dot_ref) * (lag + t_on + _stop / edge_swing) - travel,
    because="It goes on falling after the pump was told to stop: the flow is late, and the trough "
    "coasts until it stands.",
    meaning="error of the angle, in the sense of the motion, when the trough comes to rest",
    unit=RADIAN,
    latex=r"e_0",
)
hunts = d.define(
    "hunts",
    error_rest < -band_on,
    because="A trough that coasts past the sun by the whole dead band starts the other pump.",
    meaning="whether the other pump starts after the coast",
)
d.assume(
    "Ours, of the cycle: angles are small, and gain, stiffness and friction are taken as they are "
    "at one volume, best that in the middle of the run; the sun's rate is steady. What this misses "
    "is of first order in the angles of the cycle, a ramp's shape of second in its length."
)
d.assume(
    "Ours, of the cycle: the flow starts gently enough for friction to hold the trough until the "
    "edge has come to it, and the containers have room."
)
d.assume(
    "Ours, of the cycle: it is steady. Where a slip would end so close to a whole swing that "
    "1 - cos(phi) < 2 r, it would not follow itself, and goes on into the next swing. Beside that "
    "limit, for a little more or less to sweep, either of the two cycles may last; one is told."
)
