"""Yu, Wu and Zhang: the four days, and how the legs move on the equinox (Figs. 4 and 5)."""

from armillary import absolute, at, degrees, number, partial, substitute

from ._yu_kinematics import alpha, beta, leg, p, q, rr, sun
from ._yu_sun import day, declination, degree, hour_angle, latitude
from ._yu_table import TABLES, by_table

p.assume(
    "The text says what Figs. 4 to 9 show. The four days are numbers 172, 80, 266 and 355 of the "
    "year, which the paper does not give; on the equinox of Figs. 5 to 9 the sun stands over the "
    "equator."
)
NORTH = {latitude: degrees(str(TABLES["site"]["latitude"]["value"]))}

# ---- The four days: Fig. 4 ----

date = p.index("date", 4, letter="n")
number_of_day = p.constant(
    "n_day",
    tuple(map(str, TABLES["days"]["number"]["value"])),
    "number of the day in the year",
    per=date,
    latex="n",
)
SUMMER, SPRING, AUTUMN, WINTER = range(4)
hours = p.scalar(
    "h_day", "sundial time in hours, with the sun up on all four days", range=(7.5, 16.5), latex="h"
)
delta = p.define(
    "delta_day",
    substitute(sun["declination_cosine"], {day: number_of_day}),
    because="(25) gives it once the 365 that stands twice is left out.",
    meaning="declination on the four days",
    latex=r"\delta",
)


def on_days(value):
    """A value of the sun and the platform that faces it, at 40 degrees north on the four days."""
    faced = substitute(value, {alpha: rr["alpha_track"], beta: rr["beta_track"]})
    at_time = substitute(faced, {hour_angle: degrees(15 * (hours - 12)), declination: delta})
    return substitute(at_time, NORTH)


altitude = p.define(
    "altitude_day",
    on_days(sun["elevation_of_sun"]) / degree,
    because="The two directions of (27) and (28) enclose the rest of a right angle.",
    meaning="altitude of the sun on the four days, in degrees",
    latex=r"\theta",
)
daylight = p.define(
    "daylight",
    on_days(2 * sun["sunset"]) / degrees(15),
    because="The sun is up from the first to the second hour of (30).",
    meaning="hours from sunrise to sunset on the four days",
    latex=r"\Delta h",
)
for key, quote, value, low, high, words in (
    (
        "summer and winter",
        "on the summer solstice the sun is highest [...] on the winter solstice it is lowest",
        altitude,
        WINTER,
        SUMMER,
        "the altitude on the four days, in degrees,",
    ),
    (
        "daylight",
        "on the summer solstice [...] the sun shines longest [...] on the winter solstice shortest",
        daylight,
        WINTER,
        SUMMER,
        "the time from sunrise to sunset on the four days, in hours,",
    ),
):
    p.between(key, quote, value, at(value, date, low), at(value, date, high), words=words)
p.between(
    "equinoxes",
    "on the spring and the autumn equinox the sun stands over the equator, its altitude is the "
    "same, so that the paths are the same",
    absolute(at(altitude, date, SPRING) - at(altitude, date, AUTUMN)),
    0,
    number("0.1") * (at(altitude, date, SUMMER) - at(altitude, date, WINTER)),
    words="the difference of the two altitudes, in degrees, beside a tenth of that of the "
    "solstices,",
)
crowding = p.define(
    "crowding",
    on_days(partial(rr["V_PKM"].z, beta)),
    because="The third component of the normal is the sine of the declination that it faces.",
    meaning="derivative by beta, at one alpha, of the sine of the declination that is faced",
    latex=r"\left(\partial\sin\delta/\partial\beta\right)_\alpha",
)
p.between(
    "Fig. 4",
    "the curves are, from bottom to top, those of the summer solstice, the spring equinox, the "
    "autumn equinox, the winter solstice",
    crowding,
    None,
    0,
    words="the derivative by beta, at one alpha, of the sine of the declination that the platform "
    "faces, negative where a curve runs lower the nearer summer is,",
)

# ---- The legs on the equinox: Fig. 5 ----

hours_up = p.scalar(
    "h_equinox", "sundial time in hours, on the equinox", range=(6.0, 18.0), latex="h"
)


def on_equinox(value, time=hours_up):
    """A value of the mechanism of Table 1 that faces the sun at 40 degrees north."""
    faced = substitute(by_table(value), {alpha: rr["alpha_track"], beta: rr["beta_track"]})
    moved = {hour_angle: degrees(15 * (time - 12)), declination: degrees(0), **NORTH}
    return substitute(faced, moved)


lengths = p.define(
    "q_day",
    on_equinox(q),
    because="(4) gives the length for the dimensions of Table 1, with the sun faced.",
    meaning="length of leg i on the equinox",
    latex="q",
)
mirrored = p.define(
    "q_mirrored",
    on_equinox(q, 24 - hours_up),
    because="The time is as long before noon as the other is after it.",
    meaning="length of leg i on the equinox at 24 h - h",
    latex=r"\tilde{q}",
)
p.least_moved(
    "Fig. 5",
    "the length q_3 of the third leg changes less, the lengths q_1 and q_2 of the first and the "
    "second change more",
    lengths,
    over=leg,
    part=2,
    words="the change of the length of a leg on the equinox",
)
p.equation(
    "Fig. 5'",
    words="length of leg 2 on the equinox, as that of leg 1 as long before noon",
    quote="[q_1 and q_2] are symmetric",
    claims=at(lengths, leg, 1),
    printed=at(mirrored, leg, 0),
)
