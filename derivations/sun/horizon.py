"""Sunrise and sunset."""

from armillary import PI, atan2, cos, sin, sqrt, where
from armillary.derivation.units import RADIAN

from .symbols import d, declination, latitude

# With c = cos(latitude) cos(declination) and s = sin(latitude) sin(declination) the height is
# s + c cos(hour angle). c - s and c + s are each a single cosine.

midnight_depth = d.define(
    "midnight_depth",
    cos(latitude + declination),
    because="The sun's height is s + c cos(hour angle), with s the product of the sines of "
    "latitude and declination and c that of their cosines. Half a turn from noon it is s - c, and "
    "c - s is a single cosine: how far below the horizon the sun stands at midnight.",
    meaning="c - s: depth of the sun below the horizon at midnight",
    latex="m",
)
noon_height = d.define(
    "noon_height",
    cos(latitude - declination),
    because="At noon the height is s + c, which is a single cosine too.",
    meaning="c + s: height of the sun at noon",
    latex="k",
)
crossing = d.define(
    "crossing",
    midnight_depth * noon_height,
    because="The sun crosses the horizon only when it stands on opposite sides of it at noon and "
    "at midnight; depth and height then have one sign.",
    meaning="positive on the days with a sunrise",
    latex="p",
)
crosses = d.define(
    "crosses",
    crossing > 0,
    because="Where the product is not positive the sun stays up or down, or grazes the horizon "
    "at noon or midnight.",
    meaning="whether the sun rises and sets",
)
stays_down = d.define(
    "stays_down",
    ~crosses & (noon_height < midnight_depth),
    because="s is half of height less depth: its sign tells which side of the horizon the sun "
    "keeps to.",
    meaning="polar night",
)
stays_up = d.define(
    "stays_up",
    ~crosses & ~(noon_height < midnight_depth),
    because="A sun that does not cross the horizon and is not down is up.",
    meaning="polar day",
)
chord = d.define(
    "chord",
    2 * sqrt(where(crosses, crossing, 1)),
    because="On the horizon c cos(hour angle) = -s, so this is 2|c| times the sine's magnitude.",
    meaning="2|c| times the sine of the hour angle at sunset",
    latex="q",
)
beyond_pole = d.define(
    "beyond_pole",
    midnight_depth + noon_height < 0,
    because="2c is negative only when the latitude (or the declination) is carried past 90 "
    "degrees: then the sun culminates at hour angle pi and the day is centred there.",
    meaning="whether the angles pass the pole",
)
set_regular = d.define(
    "set_regular",
    atan2(
        where(beyond_pole, -chord, chord),
        where(beyond_pole, noon_height - midnight_depth, midnight_depth - noon_height),
    ),
    because="Sine and cosine of the hour angle at sunset, both times 2|c|: no tangent of the "
    "latitude, and all digits down to the polar circles.",
    meaning="hour angle of sunset on a day that has one",
    latex=r"\omega_s",
)
sunset = d.define(
    "sunset",
    where(stays_up, PI, where(stays_down, 0, set_regular)),
    because="A polar day lasts the whole turn and a polar night none of it.",
    meaning="hour angle of sunset",
    unit=RADIAN,
    latex=r"\omega_\mathrm{set}",
)
sunrise = d.define(
    "sunrise",
    -sunset,
    because="The height is even in the hour angle.",
    meaning="hour angle of sunrise",
    unit=RADIAN,
    latex=r"\omega_\mathrm{rise}",
)
d.identity(
    "at sunset the height s + c cos(hour angle) is zero",
    sin(latitude) * sin(declination) * (midnight_depth + noon_height),
    -cos(latitude) * cos(declination) * (midnight_depth - noon_height),
)
d.identity(
    "chord and height lie on the daily circle of radius 2c",
    4 * crossing + (midnight_depth - noon_height) * (midnight_depth - noon_height),
    4 * cos(latitude) * cos(latitude) * cos(declination) * cos(declination),
)
