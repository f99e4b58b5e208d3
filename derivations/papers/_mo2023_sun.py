"""Mo et al.: the sun, (28) to (34), and what the text says of its way on the four days."""

from armillary import (
    PI,
    absolute,
    arccos,
    arcsin,
    at,
    cos,
    degrees,
    number,
    partial,
    sin,
    substitute,
    where,
)
from armillary.derivation.units import RADIAN, SECOND

from ._mo2023_frames import p, sun

latitude, declination = sun.quantity("latitude"), sun.quantity("declination")
omega, day = sun.quantity("hour_angle"), sun.quantity("day")
utc, longitude = sun.quantity("utc"), sun.quantity("longitude")
E, Spencer = sun.quantity("equation_of_time"), sun["equation_of_time_spencer"]
altitude, azimuth = sun["elevation_of_sun"], sun["azimuth_of_sun"]

# ---- Altitude and azimuth ----

p.equation(
    "28",
    words="altitude of the sun",
    claims=altitude,
    printed=arcsin(
        sin(latitude) * sin(declination) + cos(latitude) * cos(declination) * cos(omega)
    ),
)
from_south = p.define(
    "gamma_south",
    azimuth - PI,
    because="The sign of the hour angle makes it positive in the afternoon, so to the west.",
    meaning="azimuth of the sun from the south, positive to the west",
    latex=r"\gamma_\mathrm{S}",
)
sign = where(omega < 0, -1, where(omega > 0, 1, 0))
gamma_s = sign * absolute(
    arccos((sin(altitude) * sin(latitude) - sin(declination)) / (cos(altitude) * cos(latitude)))
)
one_turn = absolute(omega) < PI
p.equation(
    "29",
    words="azimuth of the sun, from the south",
    claims=from_south,
    printed=gamma_s,
    given=one_turn & (declination < latitude),
)
p.equation(
    "29'",
    words="azimuth of the sun, from the north as (16) needs it",
    claims=azimuth,
    printed=gamma_s,
    given=one_turn & (declination < latitude),
)
p.equation(
    "29 at noon",
    words="azimuth of the sun from the south at noon, where it passes north of the zenith",
    quote="when omega_s = 0, sgn omega_s = 0",
    claims=substitute(azimuth, {omega: 0}) - PI,
    printed=number(0),
    given=latitude < declination,
)

# ---- The almanac ----

lam = p.define(
    "lam", sun["day_angle"], because="the paper's name", meaning="day angle", latex=r"\lambda"
)
p.equation(
    "lambda",
    words="day angle, in the text after (31)",
    claims=sun["day_angle"],
    printed=degrees(360 * (day - 1) / 365),
)
p.equation(
    "30",
    words="declination, in degrees",
    claims=sun["declination_spencer"],
    printed=degrees(
        180 / PI
        * (
            "0.00148" * sin(3 * lam) - "0.399912" * cos(lam)
            + "0.070257" * sin(lam) - "0.006758" * cos(2 * lam)
            + "0.000907" * sin(2 * lam) - "0.002679" * cos(3 * lam)
            + "0.006918"
        )
    ),
)  # fmt: skip

# ---- The clock ----

hour = p.constant("hour", 3600, "an hour", unit=SECOND, latex=r"1\,\mathrm{h}")
minute = p.constant("minute", 60, "a minute", unit=SECOND, latex=r"1\,\mathrm{min}")
degree = p.constant("degree", degrees(1), "a degree", unit=RADIAN, latex=r"1^\circ")
S_m = p.define(
    "S_m",
    utc / hour + longitude / (15 * degree),
    because="Mean time at Greenwich, an hour later every 15 degrees to the east.",
    meaning="mean solar time in hours",
    latex="S_m",
)
S_t = p.define(
    "S_t",
    (utc + E) / hour + longitude / (15 * degree),
    because="The sundial is ahead of the mean time by the equation of time.",
    meaning="true solar time in hours",
    latex="S_t",
)
E_t = p.define(
    "E_t", E / minute, because="(34) gives minutes.", meaning="equation of time in minutes",
    latex="E_t",
)  # fmt: skip
p.equation(
    "31",
    words="hour angle",
    claims=sun["hour_angle_of_clock"],
    printed=degrees(15 * (S_t - 12)),
)
p.equation("32", words="true solar time in hours", claims=S_t, printed=S_m + E_t)
F_1 = p.scalar("F_1", "minutes of the clock", range=(0.0, 59.0), latex="F_1")
F_2 = p.scalar("F_2", "minutes of arc of the longitude", range=(0.0, 59.0), latex="F_2")
S_l = p.define(
    "S_l",
    utc / hour + 8 - F_1 / 60,
    because="The clock shows Beijing time, 8 hours ahead of Greenwich.",
    meaning="hours of the clock",
    latex="S_l",
)
L_o = p.define(
    "L_o", longitude / degree - F_2 / 60, because="The rest is minutes of arc.",
    meaning="degrees of the longitude", latex="L_o",
)  # fmt: skip
p.equation(
    "33",
    words="mean solar time in hours",
    claims=S_m,
    printed=(S_l + F_1 / 60) - number(4) / 60 * (120 - (L_o + F_2 / 60)),
)
p.equation(
    "34",
    words="equation of time, in minutes",
    claims=Spencer,
    printed=minute
    * (
        180 / PI * 4
        * (
            "0.001868" * cos(lam) - "0.032077" * sin(lam)
            - "0.014615" * cos(2 * lam) - "0.0409" * sin(2 * lam)
            + "0.000075"
        )
    ),
)  # fmt: skip

# ---- The four days ----

date = p.index("date", 4, letter="n")
number_of_day = p.constant(
    "n_day", (80, 172, 266, 355), "number of the day in the year", per=date, latex="n"
)
t = p.scalar("t", "clock time, Beijing, in hours", range=(9.0, 16.0), latex="t")
site = {latitude: degrees("27.9"), longitude: degrees("112.9"), utc: (t - 8) * hour}
SPRING, SUMMER, AUTUMN, WINTER = range(4)


def on(value, n):
    """A value of the sun at the site and the clock time t, on the day of a number."""
    at_day = {day: n}
    found = substitute(
        value,
        {omega: sun["hour_angle_of_clock"], declination: sun["declination_spencer"]},
    )
    found = substitute(found, {E: Spencer})
    return substitute(found, {**site, **at_day})


SPAN = 10  # days before and after, at which an extreme would be seen


def nearby(shift):
    """The declination some days after each of the four."""
    return substitute(sun["declination_spencer"], {day: number_of_day + shift})


p.between(
    "four extremes",
    "The extreme values of the inclination angles of the Earth's rotation axis relative to the "
    "sun's incident light occur at the spring equinox, summer solstice, autumn equinox and winter "
    "solstice",
    (nearby(SPAN) - nearby(0)) * (nearby(0) - nearby(-SPAN)),
    None,
    0,
    words="the change of the declination in the 10 days before, times that in the 10 days after, "
    "negative at an extreme,",
)
h_day = p.define(
    "h_day", on(altitude, number_of_day) / degree, because="(28) to (34), mended.",
    meaning="altitude of the sun at the site on the four days, in degrees", latex=r"\alpha_s",
)  # fmt: skip
g_day = p.define(
    "g_day", on(from_south, number_of_day) / degree, because="(29) to (34), mended.",
    meaning="azimuth of the sun at the site on the four days, in degrees", latex=r"\gamma_s",
)  # fmt: skip


h_rate = p.define(
    "h_rate", 180 / PI * partial(on(altitude, number_of_day), t),
    because="The altitude, differentiated by the clock, in degrees an hour.",
    meaning="rate of that altitude, in degrees an hour", latex=r"\dot\alpha_s",
)  # fmt: skip
g_rate = p.define(
    "g_rate", 180 / PI * partial(on(from_south, number_of_day), t),
    because="The azimuth, differentiated by the clock, in degrees an hour.",
    meaning="rate of that azimuth, in degrees an hour", latex=r"\dot\gamma_s",
)  # fmt: skip


def h_on(k):
    """The altitude on one of the four days."""
    return at(h_day, date, k)


def g_on(k):
    """The azimuth on one of the four days."""
    return at(g_day, date, k)


p.between(
    "morning",
    "the change law of alpha_s in a day increases gradually in the morning",
    h_rate,
    0,
    None,
    words="the rate of the altitude before 12 o'clock, in degrees an hour,",
    given=t < 12,
)
p.between(
    "afternoon",
    "[alpha_s] reaches its peak at noon and decreases in the afternoon",
    h_rate,
    None,
    0,
    words="the rate of the altitude after 12 o'clock, in degrees an hour,",
    given=t > 12,
)
p.between(
    "solstices",
    "alpha_s reaches the maximum and minimum values on the summer solstice and the winter "
    "solstice, respectively",
    h_day,
    h_on(WINTER),
    h_on(SUMMER),
    words="the altitude on the four days, in degrees,",
)
tenth = number("0.1")
p.between(
    "equinoxes",
    "alpha_s at the spring equinox and autumn equinox is nearly equal",
    absolute(h_on(SPRING) - h_on(AUTUMN)),
    0,
    tenth * (h_on(SUMMER) - h_on(WINTER)),
    words="the difference of the two altitudes, in degrees, beside a tenth of that of the "
    "solstices,",
)
p.between(
    "monotonic",
    "The variation of gamma_s in a day presents a monotonic decreasing trend",
    g_rate,
    None,
    0,
    words="the rate of the azimuth, in degrees an hour,",
)
p.between(
    "azimuth at the solstices",
    "[gamma_s] reaches the maximum and minimum values on the summer solstice and the winter "
    "solstice, respectively",
    g_day,
    g_on(WINTER),
    g_on(SUMMER),
    words="the azimuth on the four days, in degrees,",
)
p.between(
    "azimuth at the equinoxes",
    "[gamma_s:] the values at the spring and autumn equinoxes are almost equal",
    absolute(g_on(SPRING) - g_on(AUTUMN)),
    0,
    tenth * absolute(g_on(SUMMER) - g_on(WINTER)),
    words="the difference of the two azimuths, in degrees, beside a tenth of that of the "
    "solstices,",
)
