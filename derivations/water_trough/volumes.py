"""How much water an angle takes, how much turns the trough back, and an on-off pump's cycle."""

from armillary import absolute, cos, one_like, partial, sin, sqrt, substitute, where
from armillary.derivation.units import RADIAN, SECOND

from .friction import arm
from .rest import gain, theta_dot_ref
from .symbols import FLOW, VOLUME, d, positive, s, theta
from .water import S, m_all, spilt

# The first moment is a polynomial of the volume: linear along xi, of second degree along eta.
_NONE = {s: 0}
bend = d.define(
    "bend",
    -(partial(partial(S.y, s), s) / 2) * sin(theta),
    because="Water that is moved also lifts its own centre.",
    meaning="coefficient of the volume squared in the moment about the axis, over g",
    latex="a",
)
slope = d.define(
    "slope",
    substitute(partial(S.x, s) * cos(theta) - partial(S.y, s) * sin(theta), _NONE),
    because="Water moved from one side to the other.",
    meaning="coefficient of the volume in that moment",
    latex="b",
)
level = d.define(
    "level",
    substitute(S.x * cos(theta) - S.y * sin(theta), _NONE),
    because="The moment before any water is moved.",
    meaning="that moment when no water is moved",
    latex="c",
)

far = d.constant(
    "far", "1e3", "volume that no container of a trough holds", unit=VOLUME, latex=r"s_\infty"
)


def root(offset):
    """The volume nearest to none at which the moment is `offset`, and whether there is none."""
    rest = level - offset
    under = slope * slope - 4 * bend * rest
    none = ~(~(under < 0) & (absolute(rest) < far * absolute(slope)))
    wide = sqrt(where(none, one_like(under), under))
    divisor = where(none, one_like(slope), slope + where(slope < 0, -wide, wide))
    return where(none, 0, -2 * rest / divisor), none


def volume(name, offset, because, meaning, latex):
    """Define a volume of that kind."""
    value, none = root(offset)
    made = d.define(name, value, because=because, meaning=meaning, unit=VOLUME, latex=latex)
    lost = d.define(
        f"no_{name}",
        ~(~none & ~substitute(spilt, {s: made})),
        because="The quadratic has no root, water turns nothing at this angle, or the containers "
        "do not hold so much.",
        meaning=f"whether no {name} exists",
    )
    return made, lost


s_rest, no_s_rest = volume(
    "s_rest", 0,
    "The rest condition is a quadratic in the volume; the root that stays finite where the "
    "quadratic becomes linear is taken.",
    "volume at which the trough rests at this angle without friction", "s_0",
)  # fmt: skip
tops = d.define(
    "tops",
    ~(substitute(S.x * sin(theta) + S.y * cos(theta), {s: s_rest}) < 0),
    because="With its mass centre above the axis the trough rests, but does not stay.",
    meaning="whether the rest at that volume does not last",
)
s_on, no_s_on = volume(
    "s_on", -arm * m_all,
    "Friction is overcome when the mass centre stands off by the arm, here towards positive turns.",
    "volume at which the trough breaks away towards positive angles", "s_+",
)  # fmt: skip
s_back, no_s_back = volume(
    "s_back", arm * m_all,
    "The same towards negative turns.",
    "volume at which it breaks away towards negative angles", "s_-",
)  # fmt: skip
reversal = d.define(
    "reversal",
    s_on - s_back,
    because="To turn the other way the mass centre must cross the whole range of friction.",
    meaning="volume to be moved before the trough reverses",
    unit=VOLUME,
    latex=r"\Delta s",
)

# ---- an on-off pump ----

q_pump = positive("q_pump", "flow of the pump when it runs", FLOW, 0.0, 1e3, (1e-6, 1e-3))
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
rate_tolerance = d.constant(
    "rate_tolerance",
    "1e-12",
    "angular velocity below which the sun, or what the pump gains on it, stands still",
    unit=RADIAN / SECOND,
    latex=r"\tau_r",
)
outrun = d.define(
    "outrun",
    ~(absolute(gain) * q_pump - absolute(theta_dot_ref) > rate_tolerance),
    because="A pump that is too small never catches up.",
    meaning="whether the sun outruns the pump",
)
swept = d.define(
    "swept",
    where(band_on > band_off, band_on - band_off, 0),
    because="The error runs from where the pump starts to where it stops, and back.",
    meaning="range of the error in a cycle",
    unit=RADIAN,
    latex=r"\Delta e",
)
_asleep = ~(absolute(theta_dot_ref) > rate_tolerance)
_none = ~(~outrun & ~_asleep)
_rate = where(_none, one_like(theta_dot_ref), absolute(theta_dot_ref))
_ahead = where(_none, one_like(theta_dot_ref), absolute(gain) * q_pump - absolute(theta_dot_ref))
no_cycle = d.define(
    "no_cycle",
    _none,
    because="A sun that stands still starts no pump.",
    meaning="whether there is no cycle",
)
t_on = d.define(
    "t_on",
    where(no_cycle, 0, swept / _ahead),
    because="While it runs the trough gains on the sun. It moves with the rest, behind it by the "
    "range of friction, as long as the flow changes slowly against the period of its swings. Gain "
    "and that range are taken as they are at this volume.",
    meaning="time for which the pump runs in a cycle",
    unit=SECOND,
    latex=r"t_\mathrm{on}",
)
t_cycle = d.define(
    "t_cycle",
    where(no_cycle, 0, swept / _rate) + t_on,
    because="While it stands the sun gains on the trough, which friction holds.",
    meaning="period of the cycle of an on-off pump",
    unit=SECOND,
    latex=r"t_\mathrm{c}",
)
