"""Ky et al.: the sun and the trackers that follow it, (11) to (22)."""

from armillary import (
    PI,
    Chain,
    X,
    Y,
    Z,
    absolute,
    cos,
    degrees,
    direction_angles,
    elementary,
    matrix,
    number,
    partial,
    sin,
    vector,
)
from armillary.algebra.rotation import factors
from armillary.derivation.units import SECOND

from ._ky_mathematics import altazimuth, p

sun = p.use("sun")
equatorial = p.use("equatorial")
quasi_steady = p.use("quasi_steady")

# ---- III. The sun ----

latitude, declination = sun.quantity("latitude"), sun.quantity("declination")
hour_angle, day = sun.quantity("hour_angle"), sun.quantity("day")
h = sun["elevation_of_sun"]
# The paper takes h and a from Duffie and Beckman, who count a from the south, positive westward.
a = p.define(
    "a",
    sun["azimuth_of_sun"] - PI,
    because="the azimuth of the book that the paper cites",
    meaning="azimuth from the south, positive to the west",
)

p.equation(
    "11",
    words="elevation of the sun, latitude not below the declination",
    claims=sin(h),
    printed=cos(latitude - declination),
    given=~(latitude < declination),
)
p.equation(
    "11'",
    words="elevation of the sun, latitude below the declination",
    claims=sin(PI - h),
    printed=cos(latitude - declination),
    given=latitude < declination,
)
p.equation(
    "12",
    words="azimuth of the sun",
    claims=sin(a),
    printed=cos(declination) * cos(hour_angle) / cos(h),
)
p.equation(
    "north to south",
    words="with the declination above the latitude the noon sun stands in the north",
    quote="the sun moves from north to south sometimes in the year [when] the declination angle "
    "becomes superior to the latitude angle",
    claims=absolute(sun["enu_at_noon"].y),
    printed=sun["enu_at_noon"].y,
    given=latitude < declination,
)
p.equation(
    "13",
    words="declination by Cooper's equation",
    claims=sun["declination_cooper"],
    printed=degrees("23.45") * sin(degrees(360 * ((284 + day) / 365))),
)

# ---- IV. Altazimuth ----

gamma, upsilon = altazimuth.quantity("gamma"), altazimuth.quantity("upsilon")
gamma_dot, upsilon_dot = altazimuth.quantity("gamma_dot"), altazimuth.quantity("upsilon_dot")
L_0, L_1, L_2 = (altazimuth.quantity(f"L_{k}") for k in range(3))


def altazimuth_joints(gamma, upsilon):
    """The joints of (14); [Rot, angle]^T turns as (05) does."""
    return (
        Chain("0")
        .translate(Z, L_0)
        .rotate(Z, -gamma)
        .translate(Z, L_1)
        .rotate(X, -upsilon)
        .translate(Y, L_2, frame="2")
    )


tracked = "The configuration (upsilon, gamma) called Altazimuth which tracks the altitude and "
tracked += "azimuth angles h and a"
azimuth_angle, altitude_angle = direction_angles(altazimuth.quantity("enu"))
p.equation(
    "tracks azimuth",
    words="angle gamma that puts the axis z of the collector on the sun, as the azimuth",
    quote=tracked,
    claims=altazimuth["gamma_aim"],
    printed=azimuth_angle,
)
p.equation(
    "tracks altitude",
    words="angle upsilon that puts the axis z of the collector on the sun, as the altitude",
    quote=tracked,
    claims=altazimuth["upsilon_aim"],
    printed=altitude_angle,
)
p.equation(
    "EULER first two",
    words="the altazimuth axes are the first two of the Euler product",
    quote="the 2 rotations axis identical to EULER or LEBIAN first two angles robots",
    claims=altazimuth["M"].rotation,
    printed=elementary(Z, -gamma) @ elementary(X, -upsilon),
)
p.equation(
    "LEBIAN first two",
    words="the altazimuth axes are the first two of the Lebian product",
    quote="the 2 rotations axis identical to EULER or LEBIAN first two angles robots",
    claims=altazimuth["M"].rotation,
    printed=elementary(Z, -gamma) @ elementary(Y, -upsilon),
)
p.equation(
    "14",
    words="pose of the altazimuth collector, as a product of joints",
    claims=altazimuth["M"],
    printed=altazimuth_joints(gamma, upsilon).pose("0", "2"),
    product=altazimuth_joints(gamma, upsilon),
)
p.equation(
    "15",
    words="pose of the altazimuth collector",
    claims=altazimuth["M"],
    printed=matrix(
        (
            cos(gamma),
            sin(gamma) * cos(upsilon),
            sin(gamma) * sin(upsilon),
            sin(gamma) * (L_1 * sin(upsilon) + L_2 * cos(upsilon)),
        ),
        (
            -sin(gamma),
            cos(gamma) * cos(upsilon),
            cos(gamma) * sin(upsilon),
            cos(gamma) * (L_1 * sin(upsilon) + L_2 * cos(upsilon)),
        ),
        (0, -sin(upsilon), cos(upsilon), L_0 + L_1 * cos(upsilon) - L_2 * sin(upsilon)),
        (0, 0, 0, 1),
    ),
    product=altazimuth_joints(gamma, upsilon),
)
p.equation(
    "16",
    words="angular velocity of the altazimuth collector",
    claims=altazimuth["Omega_space"],
    printed=vector(upsilon_dot, -gamma_dot * sin(upsilon), gamma_dot * cos(upsilon)),
)

# ---- Equatorial ----

p.between(
    "declination speed",
    "The declination angle moves quite slowly (1 deg each 2-3 days)",
    value=absolute(partial(sun["declination_cooper"], day)),
    low=degrees(1) / 3,
    high=degrees(1) / 2,
    words="the change of the declination in a day",
)
mean_day = p.constant("mean_day", 86400, "length of the mean solar day", unit=SECOND, latex="T_d")
drift = p.define(
    "drift",
    partial(sun["equation_of_time_spencer"], day),
    because="The sundial, which shows the hour angle, gains this much on the clock.",
    meaning="change of the equation of time in a day",
    latex=r"\frac{\mathrm{d} E_\mathrm{S}}{\mathrm{d} n}",
)
p.equation(
    "hour angle speed",
    words="turns of the hour angle in a mean solar day",
    quote="The hour angle in the other hand has a constant speed value",
    claims=1 + drift / mean_day,
    printed=number(1),
)

incl, epsilon = equatorial.quantity("incl"), equatorial.quantity("epsilon")
incl_dot, epsilon_dot = equatorial.quantity("incl_dot"), equatorial.quantity("epsilon_dot")
L_0, L_1, L_2 = (equatorial.quantity(f"L_{k}") for k in range(3))


def equatorial_joints(incl, epsilon):
    """The joints of (17)."""
    return (
        Chain("0")
        .translate(Z, L_0)
        .rotate(X, -incl)
        .translate(Z, L_1)
        .rotate(Z, -epsilon)
        .translate(Y, L_2, frame="2")
    )


# The angles differ from declination and hour angle by what puts the second axis on the noon sun.
p.equation(
    "declination and hour angle",
    words="direction to the sun as that of the collector's axis y, with the drive angles at "
    "declination and hour angle",
    quote="The configuration (I, epsilon) called Equatorial which tracks the declination and hour "
    "angles delta and omega",
    claims=sun["enu"],
    printed=equatorial_joints(PI / 2 - latitude + declination, PI + hour_angle)
    .rotation("0", "2")
    .column(1),
)
p.equation(
    "17",
    words="pose of the equatorial collector, as a product of joints",
    claims=equatorial["M"],
    printed=equatorial_joints(incl, epsilon).pose("0", "2"),
    product=equatorial_joints(incl, epsilon),
)
p.equation(
    "18",
    words="pose of the equatorial collector",
    claims=equatorial["M"],
    printed=matrix(
        (cos(epsilon), sin(epsilon), 0, L_2 * sin(epsilon)),
        (
            -cos(incl) * sin(epsilon),
            cos(incl) * cos(epsilon),
            sin(incl),
            L_1 * sin(incl) + L_2 * cos(incl) * cos(epsilon),
        ),
        (
            sin(incl) * sin(epsilon),
            -sin(incl) * cos(epsilon),
            cos(incl),
            L_0 + L_1 * cos(incl) - L_2 * sin(incl) * cos(epsilon),
        ),
        (0, 0, 0, 1),
    ),
    product=equatorial_joints(incl, epsilon),
)
p.equation(
    "19",
    words="angular velocity of the equatorial collector",
    claims=equatorial["Omega_space"],
    printed=vector(incl_dot * cos(epsilon), incl_dot * sin(epsilon), epsilon_dot),
)

# ---- Quasi-steady and steady ----

incl, incl_dot = quasi_steady.quantity("incl"), quasi_steady.quantity("incl_dot")
L_0, L_1, L_2 = (quasi_steady.quantity(f"L_{k}") for k in range(3))


def quasi_steady_joints(incl):
    """The joints of (20)."""
    return (
        Chain("0").translate(Z, L_0).rotate(X, -incl).translate(Z, L_1).translate(Y, L_2, frame="1")
    )


p.equation(
    "declination only",
    words="direction to the noon sun, with the drive angle at declination less latitude",
    quote="The configuration also called quasi-steady, which only tracks the declination angle",
    claims=sun["enu_at_noon"],
    printed=quasi_steady_joints(declination - latitude).rotation("0", "1").column(2),
)
p.equation(
    "20",
    words="pose of the quasi-steady collector, as a product of joints",
    claims=quasi_steady["M"],
    printed=quasi_steady_joints(incl).pose("0", "1"),
    product=quasi_steady_joints(incl),
)
p.equation(
    "21",
    words="pose of the quasi-steady collector",
    claims=quasi_steady["M"],
    printed=matrix(
        (1, 0, 0, 0),
        (0, cos(incl), sin(incl), L_1 * sin(incl) + L_2 * cos(incl)),
        (0, -sin(incl), cos(incl), L_0 + L_1 * cos(incl) - L_2 * sin(incl)),
        (0, 0, 0, 1),
    ),
    product=quasi_steady_joints(incl),
)
p.equation(
    "22",
    words="angular velocity of the quasi-steady collector; a dot on I may be lost",
    claims=quasi_steady["Omega_space"],
    printed={"with a dot": vector(incl_dot, 0, 0), "without": vector(incl, 0, 0)},
)
p.equation(
    "steady",
    words="direction to the noon sun, with the fixed tilt at the latitude",
    quote="The collectors are permanently adjusted with the sun in relation to the local latitude "
    "angle",
    claims=sun["enu_at_noon"],
    printed=quasi_steady_joints(-latitude).rotation("0", "1").column(2),
)

# ---- V. Conclusion ----

mounts = (altazimuth, equatorial, quasi_steady)
p.between(
    "two rotations",
    "The maximum rotation matrixes on a solar tracking robot is two",
    value=number(max(len(factors(mount["M"].rotation)) for mount in mounts)),
    low=0,
    high=2,
    words="the largest number of rotations in (14), (17) and (20)",
)
