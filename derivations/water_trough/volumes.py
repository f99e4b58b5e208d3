"""How much water an angle takes, and how much turns the trough back."""

from armillary import absolute, cos, one_like, partial, sin, sqrt, substitute, where

from .friction import arm
from .surface import wedge, wedge_slope
from .symbols import VOLUME, d, s, theta
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
unmoved = d.define(
    "unmoved",
    substitute(S.x * cos(theta) - S.y * sin(theta), _NONE),
    because="The moment before any water is moved.",
    meaning="that moment when no water is moved",
    latex="c",
)

most_volume = d.constant(
    "most_volume", "1e3", "volume that no container of a trough holds", unit=VOLUME,
    latex=r"s_\infty",
)  # fmt: skip


def roots(offset):
    """Volumes at which that moment is `offset`: (value, whether it is one) of the near and far."""
    rest = unmoved - offset
    under = slope * slope - 4 * bend * rest
    real = ~(under < 0)
    wide = sqrt(where(real, under, one_like(under)))
    both = slope + where(slope < 0, -wide, wide)
    is_near = real & (absolute(2 * rest) < most_volume * absolute(both))
    is_far = real & (absolute(both) < most_volume * absolute(2 * bend))
    near = where(is_near, -2 * rest / where(is_near, both, one_like(both)), 0)
    far = where(is_far, -both / where(is_far, 2 * bend, one_like(bend)), 0)
    return (near, is_near), (far, is_far)


def either(one, other):
    """Whether at least one of two conditions holds."""
    return ~(~one & ~other)


def held(value):
    """Whether the containers hold what a volume leaves in them."""
    return ~substitute(spilt, {s: value})


def lasting(value, lost=0):
    """Whether the trough stays at a rest, where a part of its stiffness is lost."""
    return substitute(S.x * sin(theta) + S.y * cos(theta), {s: value}) < -lost


def best(offset, lost=0):
    """The near root where the trough can rest and stay with it, else the far one; if it is one."""
    (near, is_near), (far, is_far) = roots(offset)
    near_does = is_near & held(near) & lasting(near, lost)
    far_does = is_far & held(far) & lasting(far, lost)
    far_taken = ~near_does & either(far_does, ~(is_near & held(near)))
    return far_taken, where(far_taken, far, near), either(far_taken & is_far, ~far_taken & is_near)


def volume(name, value, is_one, because, meaning, latex):
    """Define a volume, and whether there is none."""
    made = d.define(name, value, because=because, meaning=meaning, unit=VOLUME, latex=latex)
    lost = d.define(
        f"no_{name}",
        ~(is_one & held(made)),
        because="The quadratic has no such root, water turns nothing at this angle, or the "
        "containers do not hold so much.",
        meaning=f"whether no {name} exists",
    )
    return made, lost


_far_taken, _value, _is_one = best(0)
other_root = d.define(
    "other_root",
    _far_taken,
    because="Far from upright, what the water lifts of its own weight counts, and two volumes may "
    "balance. The one nearer to none is taken, unless the containers do not hold it or the trough "
    "does not stay with it.",
    meaning="whether the root farther from no water moved is taken",
)
s_rest, no_s_rest = volume(
    "s_rest", _value, _is_one,
    "The rest condition is a quadratic in the volume. The near root is written so that it stays "
    "finite where the quadratic becomes linear.",
    "volume at which the trough rests at this angle without friction", "s_0",
)  # fmt: skip
tops = d.define(
    "tops",
    ~lasting(s_rest),
    because="With its mass centre above the axis the trough rests, but does not stay.",
    meaning="whether the rest at that volume does not last",
)


def breakaway(name, offset, because, meaning, latex):
    """Where the moment is off by friction, on the side of the quadratic that the rest is on."""
    (near, is_near), (far, is_far) = roots(offset)
    is_one = either(other_root & is_far, ~other_root & is_near)
    return volume(name, where(other_root, far, near), is_one, because, meaning, latex)


s_on, no_s_on = breakaway(
    "s_on", -arm * m_all,
    "Friction is overcome when the mass centre stands off by the arm, here towards positive turns.",
    "volume at which the trough breaks away towards positive angles", "s_+",
)  # fmt: skip
s_back, no_s_back = breakaway(
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
_, _value, _is_one = best(wedge, wedge_slope)
s_level, no_s_level = volume(
    "s_level", _value, _is_one,
    "The same quadratic, with the wedges of level surfaces on its other side.",
    "volume at which the trough rests at this angle when the surfaces are level", "s_w",
)  # fmt: skip
tops_level = d.define(
    "tops_level",
    ~lasting(s_level, wedge_slope),
    because="Level surfaces take stiffness away.",
    meaning="whether the rest at that volume does not last",
)
