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


def roots(name, offset, letter):
    """Volumes at which that moment is `offset`: (value, whether it is one) of the near and far."""
    rest = unmoved - offset
    under = d.define(
        f"{name}_under",
        slope * slope - 4 * bend * rest,
        because="Where this is negative no volume does.",
        meaning=f"what stands under the root of the quadratic of {name}",
        latex=rf"\Delta_{{{letter}}}",
    )
    real = ~(under < 0)
    wide = sqrt(where(real, under, one_like(under)))
    both = d.define(
        f"{name}_sum",
        slope + where(slope < 0, -wide, wide),
        because="The root is taken with the sign of the slope: a sum loses no digits.",
        meaning="slope and root together",
        latex=rf"k_{{{letter}}}",
    )
    is_near = d.define(
        f"{name}_is_near",
        real & (absolute(2 * rest) < most_volume * absolute(both)),
        because="Of the two roots of the quadratic, one is near to no water moved.",
        meaning="whether there is a near root",
    )
    is_far = d.define(
        f"{name}_is_far",
        real & (absolute(both) < most_volume * absolute(2 * bend)),
        because="The other goes away where the quadratic becomes linear.",
        meaning="whether there is a far root",
    )
    near = d.define(
        f"{name}_near",
        where(is_near, -2 * rest / where(is_near, both, one_like(both)), 0),
        because="Written so that it stays finite where the quadratic becomes linear.",
        meaning="the near root",
        unit=VOLUME,
        latex=rf"s_{{{letter},1}}",
    )
    far = d.define(
        f"{name}_far",
        where(is_far, -both / where(is_far, 2 * bend, one_like(bend)), 0),
        because="The product of the roots is known, and so the other.",
        meaning="the far root",
        unit=VOLUME,
        latex=rf"s_{{{letter},2}}",
    )
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


def best(name, offset, letter, lost=0):
    """The near root where the trough can rest and stay with it, else the far one; if it is one."""
    (near, is_near), (far, is_far) = roots(name, offset, letter)
    near_does, far_does = (
        d.define(
            f"{name}_{which}_does",
            is_one & held(root) & lasting(root, lost),
            because="The containers must hold it, and the mass centre stand below the axis.",
            meaning=f"whether the trough rests with the {which} root, and stays",
        )
        for which, root, is_one in (("near", near, is_near), ("far", far, is_far))
    )
    far_taken = d.define(
        f"{name}_is_other",
        ~near_does & either(far_does, ~(is_near & held(near))),
        because="Far from upright, what the water lifts of its own weight counts, and two volumes "
        "may balance. The one nearer to none is taken, unless the containers do not hold it or "
        "the trough does not stay with it.",
        meaning="whether the root farther from no water moved is taken",
    )
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


other_root, _value, _is_one = best("rest", 0, "0")
s_rest, no_s_rest = volume(
    "s_rest", _value, _is_one,
    "The rest condition is a quadratic in the volume.",
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
    (near, is_near), (far, is_far) = roots(name, offset, latex[-1])
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
_, _value, _is_one = best("level", wedge, "w", wedge_slope)
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
