"""The declination and the equation of time from the day of the year."""

from armillary import PI, Rate, cos, degrees, sin
from armillary.derivation.units import RADIAN, SECOND

from .clock import solar_day
from .symbols import d

day = d.scalar(
    "day",
    "day of the year, 1.0 at 1 January 0 h UTC, with its fraction",
    rate=Rate.DAY,
    range=(1.0, 367.0),
    latex="n",
)
obliquity = d.constant(
    "obliquity",
    degrees("23.45"),
    "inclination of the ecliptic, rounded as Cooper did",
    unit=RADIAN,
    latex="i",
)

declination_cooper = d.define(
    "declination_cooper",
    obliquity * sin(2 * PI * (284 + day) / 365),
    because="The declination swings once a year through the inclination of the ecliptic, and "
    "passes the equator northward 81 days into the year.",
    meaning="declination by Cooper's formula",
    printed="13",
    latex=r"\delta_\mathrm{C}",
)
declination_cosine = d.define(
    "declination_cosine",
    -obliquity * cos(2 * PI * (day + 10) / 365),
    because="The same swing, counted from the winter solstice ten days before the year begins. "
    "Yu et al. print a factor 365 in the numerator, which would hold the sun at the solstice.",
    meaning="declination by the cosine formula",
    latex=r"\delta_\mathrm{Y}",
)

day_angle = d.define(
    "day_angle",
    2 * PI * (day - 1) / 365,
    because="Spencer counts the year as an angle from 1 January.",
    meaning="day angle",
    latex=r"\Gamma",
)
declination_spencer = d.define(
    "declination_spencer",
    (
        0.006918
        - 0.399912 * cos(day_angle)
        + 0.070257 * sin(day_angle)
        - 0.006758 * cos(2 * day_angle)
        + 0.000907 * sin(2 * day_angle)
        - 0.002697 * cos(3 * day_angle)
        + 0.00148 * sin(3 * day_angle)
    ),
    because="Spencer's harmonics of 1971 follow the eccentric orbit, which one sine cannot.",
    meaning="declination by Spencer's series",
    unit=RADIAN,
    latex=r"\delta_\mathrm{S}",
)
equation_of_time_spencer = d.define(
    "equation_of_time_spencer",
    (
        0.000075
        + 0.001868 * cos(day_angle)
        - 0.032077 * sin(day_angle)
        - 0.014615 * cos(2 * day_angle)
        - 0.040849 * sin(2 * day_angle)
    )
    * solar_day
    / (2 * PI),
    because="The first harmonic is the eccentricity of the orbit, the second its inclination; "
    "one turn of the series is one day. A later erratum takes a tenth of the constant term, 0.9 s "
    "less; over 2020-2050 the constant as printed errs less, so it is kept.",
    meaning="equation of time by Spencer's series",
    unit=SECOND,
    latex=r"E_\mathrm{S}",
)
