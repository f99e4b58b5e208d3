"""The direction of the sun, its angles and their rates."""

from armillary import Chain, X, Y, atan2, atan2_or_zero, cos, full_turn, hypot, sin, vector, where

from .symbols import d, declination, hour_angle, hour_angle_rate, latitude

zenith_tolerance = d.constant(
    "zenith_tolerance",
    "1e-6",
    "horizontal length of the sun's direction below which its azimuth is taken as free",
    latex=r"\tau",
)


def sky(hour):
    """The chain from the horizontal frame to the sun, at an hour angle.

    In the celestial frame x points east, y to the celestial pole and z to where the meridian meets
    the equator.
    """
    return (
        Chain("enu")
        .rotate(X, latitude, frame="celestial")
        .rotate(Y, -hour, frame="hour")
        .rotate(X, -declination, frame="sun")
    )


enu = d.define(
    "enu",
    sky(hour_angle).rotation("enu", "sun").column(2),
    because="The sun stands on the last axis of the chain: on the meridian and the equator to "
    "begin with, lifted by the declination, turned westward by the hour angle, and seen from a "
    "ground whose vertical leans towards the pole by the complement of the latitude.",
    meaning="unit vector to the sun",
    latex=r"\mathbf{c}",
)
enu_at_noon = d.define(
    "enu_at_noon",
    sky(0).rotation("enu", "sun").column(2),
    because="At apparent noon the hour angle is zero and the chain bends in the meridian only.",
    meaning="unit vector to the sun at apparent noon",
    latex=r"\mathbf{c}_{12}",
)
pole = d.define(
    "pole",
    sky(hour_angle).rotation("enu", "celestial").column(1),
    because="The celestial pole is the axis that the hour angle turns about.",
    meaning="unit vector to the north celestial pole",
    latex=r"\mathbf{p}",
)

d.identity(
    "the sun keeps the declination's distance from the celestial equator",
    enu.dot(pole),
    sin(declination),
)
d.identity("the afternoon sun stands in the west", enu.x, -cos(declination) * sin(hour_angle))
d.identity(
    "its height is that of the spherical triangle of zenith, pole and sun",
    enu.z,
    sin(latitude) * sin(declination) + cos(latitude) * cos(declination) * cos(hour_angle),
)
d.identity(
    "at noon the zenith distance is the latitude less the declination",
    enu_at_noon,
    vector(0, -sin(latitude - declination), cos(latitude - declination)),
)

# ---- angles ----

horizontal = d.define(
    "horizontal",
    hypot(enu.x, enu.y),
    because="The shadow of a unit pole that points to the sun has this length.",
    meaning="length of the direction's horizontal part",
    latex=r"\rho",
)
at_zenith = d.define(
    "at_zenith",
    horizontal < zenith_tolerance,
    because="With the sun overhead (or underfoot) every azimuth is as good as another.",
    meaning="whether the azimuth is free",
)


azimuth_of_sun = d.define(
    "azimuth_of_sun",
    full_turn(atan2_or_zero(enu.x, enu.y, at_zenith)),
    because="The azimuth turns from north to east; where it is free it is that of the north, 0. "
    "The paper's (12) holds the sine of another angle.",
    meaning="azimuth of the sun from north, clockwise",
    printed="12",
    latex="a",
)
elevation_of_sun = d.define(
    "elevation_of_sun",
    atan2(enu.z, horizontal),
    because="Height over horizontal length is the tangent of the elevation, and keeps its digits "
    "near the zenith, where the sine alone would lose half of them. "
    "The paper's (11) is its value at noon.",
    meaning="elevation of the sun above the horizon, without refraction",
    printed="11",
    latex="h",
)

# ---- rates ----


def unless_free(value, otherwise):
    """A value, replaced where the azimuth is free."""
    return where(at_zenith, otherwise, value)


enu_dot = d.define(
    "enu_dot",
    sky(hour_angle).velocity("sun", point=vector(0, 0, 1)),
    because="In the course of a day only the hour angle moves, and it turns the direction about "
    "the celestial pole.",
    meaning="rate of the direction to the sun",
    latex=r"\dot{\mathbf{c}}",
)
shadow = d.define(
    "shadow",
    unless_free(horizontal, 1),
    because="Where the azimuth is free the rates are stated, not divided.",
    meaning="horizontal length that the rates are divided by",
    latex=r"\rho_1",
)
elevation_rate = d.define(
    "elevation_rate",
    unless_free(enu_dot.z, 0) / shadow,
    because="The height is the sine of the elevation, so its rate is the elevation's rate times "
    "the horizontal length. At the zenith the elevation is greatest and its rate is 0.",
    meaning="rate of the elevation",
    latex=r"\dot{h}",
)
azimuth_rate = d.define(
    "azimuth_rate",
    unless_free(enu.y * enu_dot.x - enu.x * enu_dot.y, 0) / shadow / shadow,
    because="The horizontal part sweeps an area at half this cross product, and the same area is "
    "half the squared length times the azimuth's rate. At the zenith no rate is defined; 0 holds "
    "the axis.",
    meaning="rate of the azimuth",
    latex=r"\dot{a}",
)
d.identity(
    "the sun turns westward about the pole",
    enu_dot,
    enu.cross(pole) * hour_angle_rate,
)
d.identity(
    "the azimuth's rate is that of the spherical triangle",
    enu.y * enu_dot.x - enu.x * enu_dot.y,
    hour_angle_rate
    * (sin(latitude) * (enu.x * enu.x + enu.y * enu.y) - cos(latitude) * enu.y * enu.z),
)
