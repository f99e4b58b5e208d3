"""Yu et al.: the sun over Beijing, and the way of the two angles, (25) to (33)."""

from armillary import (
    PI,
    X,
    Z,
    absolute,
    arccos,
    atan2,
    cos,
    degrees,
    elementary,
    matrix,
    number,
    partial,
    sin,
    substitute,
    time_derivative,
    vector,
)
from armillary.derivation.units import RADIAN, SECOND

from ._yu_kinematics import alpha, beta, p, rr, sun

latitude, declination = sun.quantity("latitude"), sun.quantity("declination")
hour_angle, day = sun.quantity("hour_angle"), sun.quantity("day")
utc, longitude = sun.quantity("utc"), sun.quantity("longitude")
E = sun.quantity("equation_of_time")
enu = rr.quantity("enu")
hour = p.constant("hour", 3600, "an hour", unit=SECOND, latex=r"1\,\mathrm{h}")
degree = p.constant("degree", degrees(1), "a degree", unit=RADIAN, latex=r"1^\circ")
right, site = degrees(90), {longitude: degrees(116)}

p.assume(
    "The celestial frame of (27), which the text does not lay out, has Z to the pole and Y to "
    "where the meridian meets the equator, since (28) puts Beijing at [0, cos Phi, sin Phi]. X "
    "then points west."
)
p.assume(
    "The stroke of a fraction covers what follows it as far as the next sign, unless said "
    "otherwise; arctan has values between -90 and 90 degrees, arccos between 0 and 180."
)


def product(rows, right):
    """A printed 3 by 3 matrix times a vector."""
    return vector(*(row[0] * right[0] + row[1] * right[1] + row[2] * right[2] for row in rows))


def about_x(angle):
    """The matrix that (27), (28) and (31) print for a turn about X."""
    c, s = cos(angle), sin(angle)
    return ((number(1), number(0), number(0)), (number(0), c, -s), (number(0), s, c))


def about_z(angle):
    """The matrix that (27) and (31) print for a turn about Z."""
    c, s = cos(angle), sin(angle)
    return ((c, -s, number(0)), (s, c, number(0)), (number(0), number(0), number(1)))


# ---- The sun ----

p.equation(
    "25",
    words="declination",
    claims=sun["declination_cosine"],
    printed=degrees("-23.45") * cos(365 * (day + 10) * 2 * PI / 365),
)
H = p.define(
    "H",
    -hour_angle,
    because="(26) is positive in the morning, and with it (27) has the morning sun in the east.",
    meaning="hour angle, positive in the morning",
    latex="H",
)
p.equation(
    "26",
    words="hour angle, positive in the morning, by the sundial's time h",
    claims=-sun["hour_angle_of_clock"],
    printed=degrees(15 * (12 - ((utc + E) / hour + longitude / (15 * degree)))),
)
p.equation(
    "26 by the clock",
    words="hour angle at 116 degrees east, by Beijing's clock, 8 hours ahead of Greenwich",
    quote="where h is the time in hours",
    claims=-substitute(sun["hour_angle_of_clock"], site),
    printed=degrees(15 * (12 - (utc / hour + 8))),
)
c, V_sun, V_bj = sun["enu"], rr["V_sun"], rr["V_bj"]
ALONG_Y, UP = vector(0, 1, 0), vector(0, 0, 1)
p.equation(
    "27",
    words="direction to the sun",
    claims=V_sun,
    printed=vector(-sin(H) * cos(declination), cos(H) * cos(declination), sin(declination)),
)
p.equation(
    "27'",
    words="direction to the sun, as two turns",
    claims=V_sun,
    printed=product(about_z(H), product(about_x(declination), ALONG_Y)),
)
p.equation(
    "28",
    words="direction to Beijing's zenith",
    claims=V_bj,
    printed=vector(0, cos(latitude), sin(latitude)),
)
p.equation(
    "28'",
    words="direction to Beijing's zenith, as a turn",
    claims=V_bj,
    printed=product(about_x(latitude), ALONG_Y),
)
cP, sP, cd, sd, cH, sH = (
    f(angle) for angle in (latitude, declination, H) for f in (cos, sin)
)  # fmt: skip
height = cP * cH * cd + sP * sd
p.equation("29", words="cos theta: the right side", claims=rr["cos_zenith"], printed=height)
p.equation(
    "29'",
    words="cos theta: the product of the two vectors, printed with a cross",
    claims=rr["cos_zenith"],
    printed=V_bj.cross(V_sun).norm(),
)
p.equation(
    "29''",
    words="theta, as the altitude of the sun",
    quote="the product of the two vectors gives the cosine of the altitude",
    claims=sun["elevation_of_sun"],
    printed=arccos(height),
)
rises = absolute(sP * sd) < cP * cd
for key, name, sign in (("30", "sunrise", -1), ("30'", "sunset", 1)):
    p.equation(
        key,
        words=f"sundial time of {name} in hours",
        claims=12 + sun[name] / degrees(15),
        printed=sign * (arccos(-sP * sd / (cP * cd)) / degree / 15) + 12,
        given=rises,
    )

# ---- The platform in the sky ----

first_turn = (
    (number(1), number(0), number(0)),
    (number(0), sP, cP),
    (number(0), -cP, sP),
)
ca, sa, cb, sb = (f(angle) for angle in (alpha, beta) for f in (cos, sin))
V_PKM = rr["V_PKM"]
V_west = p.define(
    "V_west",
    elementary(X, latitude - right) @ rr["R_m"].column(Z),
    because="The first axis of the base points west, as that of the celestial frame does.",
    meaning="normal of the platform on a base with X to the west and Y to the south",
    latex=r"\mathbf{V}_\mathrm{west}",
)
TO_WEST = "true on a base with X to the west and Y to the south"
printed_31 = vector(sa * sb, -sP * ca * sb + cP * cb, cP * ca * sb + sP * cb)
p.equation(
    "31",
    words="normal of the platform",
    claims=V_PKM,
    printed=printed_31,
    meant={TO_WEST: {V_PKM: V_west}},
)
p.equation(
    "31'",
    words="normal of the platform, as three turns",
    claims=V_PKM,
    printed=product(first_turn, product(about_z(alpha), product(about_x(beta), UP))),
    meant={TO_WEST: {V_PKM: V_west}},
)
p.equation(
    "31''",
    words="the first matrix of (31), as the turn of the text",
    quote="first turn about X by -(90 deg - Phi)",
    claims=elementary(X, -(right - latitude)),
    printed=matrix(*first_turn),
)

# ---- The two angles ----


def arctan(top, below):
    """The arc tangent of a quotient: it knows half of the circle."""
    return atan2(top / below, 1)


alpha_sun, beta_sun = (substitute(rr[name], {enu: c}) for name in ("alpha_aim", "beta_aim"))
south_of_it = cH * cd * sP - sd * cP
p.equation(
    "32",
    words="turn about the vertical, with the sun to the south",
    claims=alpha_sun,
    printed=arctan(sH * sd, south_of_it),
    given=c.y < 0,
)
p.equation("32'", words="tilt", claims=beta_sun, printed=arccos(cH * cd * cP + cH * sd))
turn = p.define(
    "alpha_32",
    arctan(sH * cd, south_of_it),
    because="(32) gives it with the cosine of the declination for its sine.",
    meaning="turn about the vertical by (32), mended",
    latex=r"\alpha_{(32)}",
)
tilt = p.define(
    "beta_32",
    arccos(height),
    because="(32) gives it with the right side of (29), of which it is the arc cosine.",
    meaning="tilt by (32), mended",
    latex=r"\beta_{(32)}",
)
p.equation(
    "32 all day",
    words="turn about the vertical by (32), mended, all day",
    claims=alpha_sun,
    printed=turn,
)
p.equation(
    "32 from (27) and (31)",
    words="the normal of the platform that (31) gives for the angles of (32), mended",
    quote="(27) and (31) together give",
    claims=V_sun,
    printed=substitute(printed_31, {alpha: turn, beta: tilt}),
    given=c.y < 0,
)
p.equation(
    "32 on the base of (1)",
    words="the normal of the platform by (1) for the angles of (32), mended, X east and Y north",
    quote="the angles of the tracker follow",
    claims=c,
    printed=substitute(vector(sa * sb, -ca * sb, cb), {alpha: turn, beta: tilt}),
    given=c.y < 0,
)

# ---- Their rates ----

H_t = p.angle("H_t", "hour angle, positive in the morning, as it moves", latex="H")
H_dot = H_t.rate("H_dot", "rate of H")
H_ddot = H_dot.rate("H_ddot", "rate of H_dot")
seen = p.define(
    "c_t",
    substitute(c, {hour_angle: -H_t}),
    because="Within a day the hour angle moves and the declination is held.",
    meaning="unit vector to the sun, by H",
    latex=r"\mathbf{c}",
)
seen_dot = p.define(
    "c_t_dot",
    time_derivative(seen),
    because="Only H moves, so that its rate is a factor of every term.",
    meaning="its rate",
    latex=r"\dot{\mathbf{c}}",
)
seen_ddot = p.define(
    "c_t_ddot",
    time_derivative(seen_dot),
    because="It has a term of the rate of H_dot, and one of its square.",
    meaning="its second derivative",
    latex=r"\ddot{\mathbf{c}}",
)
moving = {enu: seen, rr.quantity("enu_dot"): seen_dot, rr.quantity("enu_ddot"): seen_ddot}
for name, keys in (("alpha", ("33", "33'")), ("beta", ("33''", "33'''"))):
    slope = p.define(
        f"{name}_slope",
        partial(substitute(rr[f"{name}_aim"], moving), H_t),
        because="(33) differentiates by H alone, with the declination held.",
        meaning=f"derivative of {name} by H",
        latex=rf"\frac{{\mathrm{{d}}\{name}}}{{\mathrm{{d}}H}}",
    )
    bend = p.define(
        f"{name}_bend",
        partial(slope, H_t),
        because="The slope changes with H, which (33) needs for the acceleration.",
        meaning=f"second derivative of {name} by H",
        latex=rf"\frac{{\mathrm{{d}}^2\{name}}}{{\mathrm{{d}}H^2}}",
    )
    p.equation(
        keys[0],
        words=f"rate of {name}",
        claims=substitute(rr[f"{name}_aim_dot"], moving),
        printed=slope * H_dot,
    )
    p.equation(
        keys[1],
        words=f"acceleration of {name}",
        claims=substitute(rr[f"{name}_aim_ddot"], moving),
        printed=slope * H_ddot + bend * H_dot,
    )
