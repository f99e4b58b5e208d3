"""The sun: its direction as a chain of rotations, its angles and rates, and simple almanacs."""

from armillary import (
    PI,
    Chain,
    Derivation,
    Kind,
    Rate,
    Status,
    X,
    Y,
    Z,
    atan2,
    atan2_or_zero,
    cos,
    degrees,
    full_turn,
    hypot,
    sin,
    sqrt,
    vector,
    where,
    wrap,
)
from armillary.derivation.units import KELVIN, PASCAL, RADIAN, SECOND

derivation = d = Derivation(
    "sun",
    title="The sun",
    paper="ky",
    summary="Seen from the ground, the sun is carried round the earth's axis by the hour angle, "
    "lifted off the equator by the declination, and the whole is tilted by the latitude: a chain "
    "of three rotations. Everything else here follows from that chain, except the almanacs, which "
    "say what the declination is and how far the sundial differs from the clock.",
)

latitude = d.angle(
    "latitude",
    "geodetic latitude, positive north",
    rate=Rate.MOUNT,
    range=(-1.5708, 1.5708),
    latex=r"\varphi",
)
declination = d.angle(
    "declination",
    "declination of the sun, positive north",
    rate=Rate.DAY,
    range=(-0.4102, 0.4102),
    latex=r"\delta",
)
hour_angle = d.angle(
    "hour_angle",
    "hour angle of the sun, 0 at apparent noon and positive in the afternoon",
    rate=Rate.TICK,
    latex=r"\omega",
)
hour_angle_rate = hour_angle.rate("hour_angle_rate", "rate of the hour angle")

zenith_tolerance = d.constant(
    "zenith_tolerance",
    "1e-6",
    "horizontal length of the sun's direction below which its azimuth is taken as free",
    latex=r"\tau",
)

# ---- direction ----


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

# ---- hour angle from the clock ----

solar_day = d.constant("solar_day", 86400, "length of the mean solar day", unit=SECOND, latex="T")
utc = d.time("utc", "time of the day, UTC", range=(0.0, 86400.0), latex=r"t_\mathrm{UTC}")
longitude = d.angle("longitude", "longitude, positive east", rate=Rate.MOUNT, latex=r"\lambda")
equation_of_time = d.time(
    "equation_of_time",
    "apparent minus mean solar time",
    rate=Rate.DAY,
    range=(-1000.0, 1000.0),
    latex="E",
)

hour_angle_of_clock = d.define(
    "hour_angle_of_clock",
    wrap(2 * PI * (utc + equation_of_time) / solar_day + longitude - PI),
    because="Mean time plus the equation of time is the sundial's time; it turns once a day, runs "
    "ahead by the longitude, and counts from noon instead of midnight.",
    meaning="hour angle from the clock, in [-pi, pi]",
    latex=r"\omega_t",
)

# ---- almanacs ----

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

# ---- sunrise and sunset ----
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

# ---- refraction ----

elevation = d.angle(
    "elevation",
    "elevation of the sun above the horizon, without refraction",
    limits=(-1.6, 1.6),
    range=(-0.0145, 1.5708),
    latex="e",
)
pressure = d.scalar(
    "pressure",
    "air pressure at the site",
    unit=PASCAL,
    rate=Rate.DAY,
    kind=Kind.NON_NEGATIVE,
    range=(50e3, 110e3),
    latex="P",
)
temperature = d.scalar(
    "temperature",
    "absolute temperature of the air",
    unit=KELVIN,
    rate=Rate.DAY,
    kind=Kind.NON_NEGATIVE,
    limits=(100.0, 1000.0),
    range=(220.0, 330.0),
    latex=r"\vartheta",
)
pressure_0 = d.constant("pressure_0", 101000, "pressure of the formula", unit=PASCAL, latex="P_0")
temperature_0 = d.constant(
    "temperature_0", 283, "temperature of the formula", unit=KELVIN, latex=r"\vartheta_0"
)
below = d.define(
    "below",
    elevation < -degrees("0.83337"),
    because="The sun's radius is 0.26667 degrees and refraction at the horizon 0.5667 degrees: "
    "lower than both together not even the upper limb is seen. The NREL algorithm stops here, and "
    "so do we.",
    meaning="whether the whole disc is below the horizon",
)
seen = d.define(
    "seen",
    where(below, 0, elevation),
    because="The formula is evaluated only where it holds.",
    meaning="elevation that is refracted",
)
lifted = d.define(
    "lifted",
    seen + degrees("10.3") / (seen / degrees(1) + 5.11),
    because="Saemundsson's argument, which keeps the cotangent finite at the horizon.",
    meaning="argument of the cotangent",
    latex="w",
)
refraction = d.define(
    "refraction",
    degrees("0.017")
    * (pressure / pressure_0)
    * temperature_0
    * cos(lifted)
    / (temperature * sin(lifted)),
    because="Refraction follows the cotangent of the elevation and the density of the air: 1.02 "
    "arc minutes at 45 degrees, 1010 hPa and 10 degrees Celsius.",
    meaning="how far refraction lifts the sun",
    unit=RADIAN,
    latex="R",
)
elevation_apparent = d.define(
    "elevation_apparent",
    elevation + where(below, 0, refraction),
    because="Refraction lifts the sun; a sun wholly below the horizon is left where it is.",
    meaning="elevation as seen through the air",
    latex="e_a",
)

# ---- kernels ----

place = [latitude, declination, hour_angle]
free_azimuth = (
    Status.SINGULAR,
    at_zenith,
    "the sun is within 1e-6 of the zenith or the nadir: its azimuth is free",
)

d.kernel("direction", inputs=place, outputs=[enu], summary="Unit vector to the sun.")
d.kernel(
    "angles",
    inputs=place,
    outputs={"elevation": elevation_of_sun, "azimuth": azimuth_of_sun},
    cases=[free_azimuth],
    summary="Elevation, in [-pi/2, pi/2], and azimuth, in [0, 2 pi), of the sun.",
)
d.kernel(
    "rates",
    inputs=[*place, hour_angle_rate],
    outputs=[elevation_rate, azimuth_rate],
    cases=[free_azimuth],
    summary="Rates of elevation and azimuth while the hour angle runs.",
)
d.kernel(
    "hour_angle",
    inputs=[utc, longitude, equation_of_time],
    outputs={"hour_angle": hour_angle_of_clock},
    summary="Hour angle of the sun from the clock, in [-pi, pi].",
)
d.kernel(
    "cooper",
    inputs=[day],
    outputs={"declination": declination_cooper},
    summary="Declination by Cooper's sine.",
)
d.kernel(
    "cosine",
    inputs=[day],
    outputs={"declination": declination_cosine},
    summary="Declination by the cosine from the winter solstice.",
)
d.kernel(
    "spencer",
    inputs=[day],
    outputs={
        "declination": declination_spencer,
        "equation_of_time": equation_of_time_spencer,
    },
    summary="Declination and equation of time by Spencer's series.",
)
d.kernel(
    "day_limits",
    inputs=[latitude, declination],
    outputs={"rise": sunrise, "set": sunset},
    cases=[
        (Status.BELOW_HORIZON, stays_down, "polar night: rise and set are both 0"),
        (Status.CLAMPED, stays_up, "polar day: rise is -pi and set is pi"),
    ],
    summary="Hour angles of the sun's centre on the unrefracted horizon. The day runs from rise "
    "to set; past the pole rise is the larger, and the day runs through pi.",
)
d.kernel(
    "refraction",
    inputs=[elevation, pressure, temperature],
    outputs={"elevation": elevation_apparent},
    summary="Elevation as seen through the air. Below -0.0145 rad the sun is left where it is: "
    "the refraction, 0.0108 rad there, ends with a jump.",
)

d.assume("The earth turns about a fixed axis, and the sun is so far that its rays are parallel.")
d.assume("Directions are geometric: only the kernel refraction bends the rays.")
d.picture(
    sky(hour_angle),
    at={"latitude": 0.7, "hour_angle": 0.8, "declination": 0.35},
    sun=Z,
    caption="The sun in the sky of 40 degrees north, on a summer afternoon. The circle is its way "
    "in the course of a day about the celestial pole.",
)
