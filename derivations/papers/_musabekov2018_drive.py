"""Musabekov et al.: the sun, the drive angles and the conclusions, (10) to (20)."""

from fractions import Fraction

from armillary import (
    PI,
    X,
    Y,
    Z,
    absolute,
    arcsin,
    cos,
    degrees,
    elementary,
    partial,
    sin,
    sqrt,
    vector,
)
from armillary.derivation.units import RADIAN, SECOND

from ._musabekov2018_frames import (
    M,
    alpha,
    b,
    beta,
    c,
    chi,
    delta,
    heliostat,
    lam,
    p,
    phi,
    psi,
    reachable,
    sun,
    theta,
)

# ---- The sun ----

p.equation(
    "10",
    words="direction to the sun in the equatorial frame",
    claims=heliostat["c_E"],
    printed=vector(cos(lam) * cos(delta), -sin(lam) * cos(delta), sin(delta)),
)
width = p.angle(
    "width", "latitude of the sun from the ecliptic", range=(-6e-6, 6e-6), latex=r"\beta_\odot"
)
p.equation(
    "width",
    words="direction (10), with the latitude of the sun for lambda",
    quote="where lambda - width of the Sun",
    claims=heliostat["c_E"],
    printed=vector(cos(width) * cos(delta), -sin(width) * cos(delta), sin(delta)),
)
ecliptic = p.angle("ecliptic", "longitude of the sun along the ecliptic", latex=r"\ell")
obliquity = p.constant(
    "obliquity", degrees("23.44"), "inclination of the ecliptic", unit=RADIAN, latex="i"
)
p.equation(
    "longitude",
    words="third component of (10), with the longitude of the sun for delta",
    quote="delta - longitude of the Sun",
    claims=sin(obliquity) * sin(ecliptic),
    printed=sin(ecliptic),
)

day_length = p.constant(
    "day_length", 86400, "length of the mean solar day", unit=SECOND, latex="T_d"
)
by_sun = p.constant(
    "by_sun",
    degrees(Fraction(1, 240)),
    "angular velocity of the Earth's rotation against the sun",
    unit=RADIAN / SECOND,
    latex=r"\omega_\odot",
)
by_stars = p.constant(
    "by_stars",
    "7.292115e-5",
    "angular velocity of the Earth's rotation against the stars",
    unit=RADIAN / SECOND,
    latex=r"\omega_\star",
)
t = p.define(
    "t",
    sun.quantity("utc")
    + sun.quantity("equation_of_time")
    + sun.quantity("longitude") * day_length / (2 * PI)
    - day_length / 2,
    because="time of day, measured from noon",
    latex="t",
)
p.equation(
    "11",
    words="hour angle",
    claims=sun["hour_angle_of_clock"],
    printed={"omega_Earth against the sun": by_sun * t, "against the stars": by_stars * t},
    given=absolute(t) < day_length / 2,
)

c_eta_E = p.define(
    "c_eta_E",
    heliostat["c_E"].y,
    because="the paper's name of the component (10)",
    latex=r"c_{\eta_E}",
)


def sun_in_local(c_eta):
    """The three lines of the second equation (11)."""
    return vector(
        cos(lam) * cos(delta) * sin(phi) - sin(delta) * cos(phi),
        c_eta,
        cos(lam) * cos(delta) * cos(phi) + sin(delta) * sin(phi),
    )


p.equation(
    "11'",
    words="direction to the sun in the local frame; an equals sign of its second line may be lost",
    claims=heliostat["c_L"],
    printed={
        "c_eta = c_eta_E = -sin lambda cos delta": sun_in_local(-sin(lam) * cos(delta)),
        "c_eta = c_eta_E - sin lambda cos delta": sun_in_local(c_eta_E - sin(lam) * cos(delta)),
    },
)

# ---- The normal ----

c_xi = p.define("c_xi", -c.y, because="south is minus north", latex=r"c_\xi")
c_eta = p.define("c_eta", c.x, because="the eastward component", latex=r"c_\eta")
c_zeta = p.define("c_zeta", c.z, because="the upward component", latex=r"c_\zeta")
b_xi = p.define("b_xi", -b.y, because="south is minus north", latex=r"b_\xi")
b_eta = p.define("b_eta", b.x, because="the eastward component", latex=r"b_\eta")
b_zeta = p.define("b_zeta", b.z, because="the upward component", latex=r"b_\zeta")
p.equation(
    "12",
    words="normal in the local frame",
    claims=heliostat["n_L"],
    printed=vector((b_xi + c_xi) / M, (b_eta + c_eta) / M, (b_zeta + c_zeta) / M),
)
p.equation(
    "12'",
    words="length of the sum of the two unit vectors",
    claims=heliostat["m"].norm(),
    printed=M,
)

n_L, n_I = heliostat["n_L"], heliostat["n_I"]
named = "the paper's name of the component"
n_xi = p.define("n_xi", n_L.x, because=named, latex=r"n_\xi")
n_eta = p.define("n_eta", n_L.y, because=named, latex=r"n_\eta")
n_zeta = p.define("n_zeta", n_L.z, because=named, latex=r"n_\zeta")
n_X = p.define("n_X", n_I.x, because=named, latex="n_X")
n_Y = p.define("n_Y", n_I.y, because=named, latex="n_Y")
n_Z = p.define("n_Z", n_I.z, because=named, latex="n_Z")


nought = p.constant("nought", 0, "the factor 0 that (13) and (16) print", latex="0")


def normal_in_axes(first, turn):
    """The three lines of (13)."""
    return vector(
        first + n_eta * nought + n_zeta * theta,
        first * theta * psi + n_eta - n_zeta * turn,
        -first * theta + n_eta * psi + n_zeta,
    )


# Each line begins with what is read as n_zeta; "n psi" is psi or sin psi, which (7) has there.
p.equation(
    "13",
    words="normal in the frame of the azimuth axis, from its local components",
    claims=n_I,
    printed={
        "n_zeta first, psi": normal_in_axes(n_zeta, psi),
        "n_zeta first, sin psi": normal_in_axes(n_zeta, sin(psi)),
        "n_xi first, psi": normal_in_axes(n_xi, psi),
        "n_xi first, sin psi": normal_in_axes(n_xi, sin(psi)),
    },
    small=(theta, psi),
)
p.equation(
    "14",
    words="normal in the frame of the azimuth axis, from the drive angles",
    claims=heliostat["normal_I"],
    printed=vector(cos(alpha) * cos(beta), -sin(alpha) * cos(beta), cos(chi) * sin(beta)),
    small=(chi,),
)

# ---- The drive angles ----

alpha_n, beta_n = heliostat["alpha_drive"], heliostat["beta_drive"]
turned = elementary(Y, beta_n) @ elementary(X, chi) @ elementary(Z, alpha_n)
p.equation(
    "15",
    words="the two normals are one: that of sun and receiver, and that of the drive angles",
    claims=n_I,
    printed=turned.transpose().column(0),
    given=reachable,
)
p.equation(
    "16",
    words="first component of the normal, from its local components",
    claims=n_I.x,
    printed={
        "n_zeta * theta": n_xi + n_eta * nought + n_zeta * theta,
        "n_xi * theta": n_xi + n_eta * nought + n_xi * theta,
    },
    small=(theta, psi),
)
p.equation(
    "16'",
    words="first component of the normal, from the drive angles",
    claims=heliostat["normal_I"].x,
    printed=cos(alpha) * cos(beta),
    small=(chi,),
)
p.equation(
    "17",
    words="second component of the normal, from its local components",
    claims=n_I.y,
    printed={
        "n_zeta * psi": n_xi * theta * psi + n_eta - n_zeta * psi,
        "n_zeta * sin psi": n_xi * theta * psi + n_eta - n_zeta * sin(psi),
        "n_xi * psi": n_xi * theta * psi + n_eta - n_xi * psi,
        "n_xi * sin psi": n_xi * theta * psi + n_eta - n_xi * sin(psi),
    },
    small=(theta, psi),
)
p.equation(
    "17'",
    words="second component of the normal, from the drive angles",
    claims=heliostat["normal_I"].y,
    printed=-sin(alpha) * cos(beta),
    small=(chi,),
)
p.equation(
    "18",
    words="third component of the normal, from its local components",
    claims=n_I.z,
    printed={
        "-n_zeta * theta": -n_zeta * theta + n_eta * psi + n_zeta,
        "-n_xi * theta": -n_xi * theta + n_eta * psi + n_zeta,
    },
    small=(theta, psi),
)
p.equation(
    "18'",
    words="third component of the normal, from the drive angles",
    claims=heliostat["normal_I"].z,
    printed=cos(chi) * sin(beta),
    small=(chi,),
)
p.equation(
    "from (17)",
    words="sine of beta, from the component of the normal that (17) gives",
    quote="from (17) the expression for the angle of rotation of the MCS around the horizontal "
    "axis beta is obtained",
    claims=sin(beta_n),
    printed=n_Y / cos(chi),
    given=reachable,
)
p.equation(
    "19",
    words="angle of the elevation drive",
    claims=beta_n,
    printed=arcsin(n_Z / cos(chi)),
    given=reachable,
)
p.equation(
    "20",
    words="angle of the azimuth drive",
    claims=alpha_n,
    printed=arcsin(-n_Y / sqrt(1 - (n_Z / cos(chi)) ** 2)),
    given=reachable,
)
p.equation(
    "chi = 0",
    words="error (1) of the azimuth, as the angle (20) at chi = 0",
    quote="In the particular case when chi = 0, at the expression is obtained as (1) equation",
    claims=heliostat["Delta_A"],
    printed=arcsin(-n_Y / sqrt(1 - n_Z**2)),
    given=reachable,
)

# ---- Conclusion ----

p.needed(
    "theta and psi",
    "the algorithms of the movement MCS [have] to consider [...] the angles theta and psi "
    "characterizing the angle of inclination of the axis of rotation relative to the vertical",
    (theta, psi),
    of=heliostat["normal"],
)
p.negligible(
    "chi",
    "the influence of the angle of inclination of the horizontal (zenithal) axis of rotation on "
    "the equations of motion is negligible and may be ignored",
    chi,
    of=heliostat["normal"],
    beside=(theta, psi),
)
speed = p.define(
    "speed",
    partial(sun["hour_angle_of_clock"], sun.quantity("utc")),
    because="The hour angle runs on with the clock.",
    meaning="speed of the sun's hour angle",
    latex=r"\dot\omega_t",
)
p.equation(
    "all stars",
    words="turn of the sun's hour angle in a mean solar day, as a star's",
    quote="the equations of motion of all stellar bodies (except satellites) will be the same",
    claims=speed * day_length,
    printed=by_stars * day_length,
)
