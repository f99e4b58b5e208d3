"""A surface left to itself is level: what the convention of the parallel surface leaves out."""

from armillary import absolute, cos, one_like, partial, sin, where
from armillary.derivation.units import METRE, NEWTON_METRE

from .rest import indifferent, reach
from .symbols import A_1, A_2, FIRST, d, g, h_max, rho, theta, w
from .water import h_1, h_2

upright_tolerance = d.constant(
    "upright_tolerance",
    "1e-3",
    "cosine of the turn below which a container counts as lying on its side",
    latex=r"\tau_c",
)
tipped = d.define(
    "tipped",
    ~(cos(theta) > upright_tolerance),
    because="In a container on its side, or upside down, the water has another shape.",
    meaning="whether a container is turned by a quarter or more",
)
_size = rho * (A_1 + A_2) * w * w / 24
V_level = d.define(
    "V_level",
    -g * _size * sin(theta) * sin(theta) / cos(theta),
    because="The first slosh of a container is faster than the swing of the trough: at the speed "
    "of tracking the surface is level. Over a floor of width w a surface of the slope tan(theta) "
    "has its centre w^2 tan(theta)/(12 h) to the lower side, and w^2 tan(theta)^2/(24 h) higher "
    "above the floor. Times weight, h cancels.",
    meaning="what level surfaces add to the potential energy",
    unit=NEWTON_METRE,
    latex=r"V_\mathrm{w}",
)
_c = where(tipped, one_like(theta), cos(theta))
_n = where(tipped, 0, sin(theta))
wedge = d.define(
    "wedge",
    _size * _n * (1 + 1 / (_c * _c)),
    because="The slope of that potential, over g: the wedges of water pull the trough on, to "
    "either side.",
    meaning="first moment, off the vertical of the axis, that level surfaces add",
    unit=FIRST,
    latex="S_\\mathrm{w}",
)
wedge_slope = d.define(
    "wedge_slope",
    _size * (_c + 1 / _c + 2 * _n * _n / (_c * _c * _c)),
    because="The derivative of that by the turn.",
    meaning="loss of stiffness to level surfaces, over g",
    unit=FIRST,
    latex="S_\\mathrm{w}'",
)
_bare = _size * sin(theta) * (1 + 1 / (cos(theta) * cos(theta)))
d.identity("level surfaces pull as their potential falls", g * _bare, -partial(V_level, theta))
d.identity(
    "and take the curvature of that potential off the stiffness",
    g
    * _size
    * (
        cos(theta)
        + 1 / cos(theta)
        + 2 * sin(theta) * sin(theta) / cos(theta) / cos(theta) / cos(theta)
    ),
    -partial(partial(V_level, theta), theta),
)
softer = d.define(
    "softer",
    where(indifferent, 0, wedge_slope / where(indifferent, one_like(reach), reach)),
    because="Over the stiffness with parallel surfaces. Where it comes to 1 the trough would not "
    "stay: it is no small part.",
    meaning="part of the stiffness that level surfaces take away",
    latex="k_\\mathrm{w}",
)
M_level = d.define(
    "M_level",
    g * wedge,
    because="Weight is what pulls.",
    meaning="moment of level surfaces on the trough",
    unit=NEWTON_METRE,
    latex=r"M_\mathrm{w}",
)
_rise = (w / 2) * absolute(_n / _c)


def wall(number, level):
    """How high the water stands at the lower wall of a container."""
    return d.define(
        f"wall_{number}",
        level + _rise,
        because="Half of the width away from the middle the level surface has risen by that much.",
        meaning=f"height of level water over the floor, at the lower wall of container {number}",
        unit=METRE,
        latex=rf"h_{{\mathrm{{w}}{number}}}",
    )


wall_1, wall_2 = wall(1, h_1), wall(2, h_2)
runs_over = d.define(
    "runs_over",
    ~(~(wall_1 > h_max) & ~(wall_2 > h_max)),
    because="An open container gives water away long before its mean level reaches the rim; a "
    "closed one keeps it, and the wedge meets the lid.",
    meaning="whether level water would stand higher than a wall",
)
bares = d.define(
    "bares",
    ~(~(h_1 < _rise) & ~(h_2 < _rise)),
    because="The wedge then ends on the floor, which it no longer covers.",
    meaning="whether a part of a floor falls dry under a level surface",
)
