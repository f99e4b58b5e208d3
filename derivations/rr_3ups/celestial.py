"""The sun and the platform in the axes of the paper."""

from armillary import PI, X, Z, cos, elementary, sin, substitute, vector

from .aiming import normal
from .symbols import alpha, d
from .trajectory import declination, enu_sun, hour_angle, latitude

frames = d.use("frames")

# Its celestial frame: x to the west, y to where the meridian meets the equator, z to the pole.


def west_south_up(v):
    """Components in the paper's horizontal axes of a vector given in East-North-Up."""
    return substitute(frames["wsu"], {frames.quantity("v"): v})


d.identity(
    "in West-South-Up axes the same attitude is half a turn further",
    west_south_up(normal),
    substitute(normal, {alpha: alpha + PI}),
)
celestial = elementary(X, latitude - PI / 2)
V_sun = d.define(
    "V_sun",
    celestial @ west_south_up(enu_sun),
    because="The horizontal frame leans back from the celestial one by what the pole lacks to the "
    "zenith.",
    meaning="unit vector to the sun, axes west, meridian on the equator, and celestial pole",
    printed="27",
    latex=r"\mathbf{V}_\mathrm{sun}",
)
d.identity(
    "the sun goes round the pole at the declination's height",
    V_sun,
    vector(
        sin(hour_angle) * cos(declination), cos(hour_angle) * cos(declination), sin(declination)
    ),
)
V_bj = d.define(
    "V_bj",
    (celestial @ elementary(X, 0)).column(Z),
    because="The zenith stands as high above the equator as the place is north of it.",
    meaning="unit vector to the zenith of the place, the same axes",
    printed="28",
    latex=r"\mathbf{V}_\mathrm{bj}",
)
cos_zenith = d.define(
    "cos_zenith",
    V_bj.dot(V_sun),
    because="The dot product of two unit vectors is the cosine of the angle between them; the "
    "print has a cross, and calls the angle the altitude.",
    meaning="cosine of the angle between sun and zenith",
    printed="29",
    latex=r"\cos\vartheta",
)
d.identity(
    "it is the law of cosines in the triangle of zenith, pole and sun",
    cos_zenith,
    cos(latitude) * cos(declination) * cos(hour_angle) + sin(latitude) * sin(declination),
)
V_PKM = d.define(
    "V_PKM",
    celestial @ west_south_up(normal),
    because="The platform's normal is carried along; it stands in East-North-Up axes, not in the "
    "axes west and south that the print takes for those of the base.",
    meaning="unit normal of the platform, axes west, meridian on the equator, and celestial pole",
    printed="31",
    latex=r"\mathbf{V}_\mathrm{PKM}",
)
