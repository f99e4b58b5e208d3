"""Mo et al.: the attitude of the dish, the pose of the platform, and the sun, (10) to (16)."""

from armillary import (
    PI,
    Chain,
    X,
    Y,
    Z,
    at,
    cos,
    degrees,
    direction_angles,
    elementary,
    matrix,
    number,
    sin,
    sqrt,
    substitute,
    tilted,
    vector,
)
from armillary.algebra.rigid import Matrix
from armillary.derivation.units import METRE

from ._mo2023_frames import alpha, beta, d, dish, eta, height, p, phi, r_b, r_m, sun, z_O

# ---- The attitude of the dish ----

p.unchecked("10", "pose of the dish", "It names the three coordinates and the three angles.")

c_a, s_a, c_b, s_b = cos(alpha), sin(alpha), cos(beta), sin(beta)
gamma = p.angle("gamma", "third of the ZYZ angles of the dish", latex=r"\gamma")
x_O, y_O = (
    p.scalar(f"{axis}_O", f"{axis} of the dish's point O in {{H}}", unit=METRE, range=(-2.0, 2.0),
             latex=rf"{axis}_{{O\_H}}")
    for axis in "xy"
)  # fmt: skip


def pose_of_dish(gamma, x, y):
    """The matrix (11)."""
    c_g, s_g = cos(gamma), sin(gamma)
    return matrix(
        (c_a * c_b * c_g - s_a * s_g, -c_a * c_b * s_g - s_a * c_g, c_a * s_b, x),
        (s_a * c_b * c_g + c_a * s_g, -s_a * c_b * s_g + c_a * c_g, s_a * s_b, y),
        (-s_b * c_g, s_b * s_g, c_b, z_O),
        (0, 0, 0, 1),
    )


turns = Chain("H").translate(X, x_O).translate(Y, y_O).translate(Z, z_O)
turns = turns.rotate(Z, alpha).rotate(Y, beta).rotate(Z, gamma, frame="O")
p.equation(
    "11",
    words="pose of the dish above H, with gamma = -alpha as (16) has it",
    claims=dish["H_T_O"],
    printed=pose_of_dish(-alpha, 0, 0),
)
p.equation(
    "11'",
    words="pose of the dish anywhere, as three turns ZYZ",
    claims=turns.pose("H", "O"),
    printed=pose_of_dish(gamma, x_O, y_O),
    product=turns,
)

# ---- The pose of the platform ----

p.unchecked("12", "pose of the platform", "It names the twelve elements of the matrix.")

carried, H_T_P, M = dish["carried"], dish["H_T_P"], dish["M"]
p.equation(
    "13",
    words="rotation of the platform, as that of the dish and (8)",
    claims=dish["H_R_M"],
    printed=Matrix(tuple(row[:3] for row in carried.matrix().rows[:3])),
)
p.equation(
    "13'",
    words="position of the platform, as that of the dish and (8)",
    claims=M,
    printed=carried.position,
)


def elements(gamma):
    """The twelve elements after (13), as rows of the matrix (12)."""
    c_g, s_g, c_f, s_f, c_e, s_e = cos(gamma), sin(gamma), cos(phi), sin(phi), cos(eta), sin(eta)
    n_1 = c_e * c_f * (s_a * s_g - c_a * c_b * c_g) + c_e * s_f * (c_g * s_a + c_a * c_b * s_g)
    n_2 = -c_e * c_f * (c_a * s_g + c_b * c_g * s_a) - c_e * s_f * (c_a * c_g - c_b * s_a * s_g)
    n_3 = s_b * c_e * c_g * c_f - c_b * s_e - s_b * c_e * s_g * s_f
    o_1 = c_f * (c_g * s_a + c_a * c_b * s_g) - s_f * (s_a * s_g - c_a * c_b * c_g)
    o_2 = s_f * (c_a * s_g + c_b * c_g * s_a) - c_f * (c_a * c_g - c_b * s_a * s_g)
    o_3 = -s_e * s_f * (c_a * c_g - c_b * s_a * s_g) - c_f * s_e * (c_a * s_g + c_b * c_g * s_a)
    a_1 = c_f * s_e * (s_a * s_g - c_a * c_b * c_g) + s_e * s_f * (c_g * s_a + c_a * c_b * s_g)
    a_2 = -s_e * s_f * (c_a * c_g - c_b * s_a * s_g) - c_f * s_e * (c_a * s_g + c_b * c_g * s_a)
    a_3 = c_b * c_e + c_g * c_f * s_b * s_e - s_b * s_e * s_g * s_f
    x_m = c_a * s_b * height(phi) - d * s_f * (c_g * s_a + c_a * c_b * s_g)
    y_m = s_a * s_b * height(phi) + d * c_f * (c_a * s_g + c_b * c_g * s_a)
    return (
        (n_1 - c_a * s_b * s_e, o_1, a_1 + c_a * c_e * s_b,
         x_m - d * c_f * (s_a * s_g - c_a * c_b * c_g)),
        (n_2 - s_a * s_b * s_e, o_2, a_2 + c_e * s_a * s_b,
         y_m + d * s_f * (c_a * c_g - c_b * s_a * s_g)),
        (n_3, o_3 + c_e * s_a * s_b, a_3,
         z_O + c_b * height(phi) - d * c_g * c_f * s_b + d * s_b * s_g * s_f),
    )  # fmt: skip


point = Chain("H").translate(Z, z_O).rotate(Z, alpha).rotate(Y, beta).rotate(Z, gamma)
point = point.rotate(Z, phi).translate(X, d).translate(Z, dish["M_O"].z)
point = point.rotate(Z, -PI).rotate(Y, eta, frame="M")
p.equation(
    "13 elements",
    words="the twelve elements of the product (13): rows 1 to 3 of n, o, a and the position",
    claims=matrix(*point.pose("H", "M").matrix().rows[:3]),
    printed=matrix(*elements(gamma)),
)
p.word(
    "cosines",
    "orientation vectors n [...], o [...], a [...] are the directional cosines of the axes X_m, "
    "Y_m, Z_m",
    "orthogonal",
    of={"n, o, a": matrix(*(row[:3] for row in elements(gamma)))},
)

# ---- The planes of the hinges ----

u, R_P = dish["u"], H_T_P.rotation
in_base = dish["BS"] + r_b * u
S_P = p.define(
    "S_P", in_base, because="The rod stands on its hinge.", meaning="S-joint i in {P}",
    latex="S_P",
)  # fmt: skip
S_H = p.define(
    "S_H", H_T_P.position + R_P @ in_base, because="The same point in {H}.",
    meaning="S-joint i in {H}", latex="S_H",
)  # fmt: skip
leg = dish.derivation.indices["leg"]
root_3 = sqrt(number(3))
p.equation(
    "planes",
    words="y of the three S-joints, on the planes of their hinges",
    quote="its three legs can only move in the planes of y_S1_H = 0, y_S2_H = -sqrt(3) x and "
    "y_S3_H = sqrt(3) x_S3_H",
    claims=vector(*(at(S_H, leg, k).y for k in range(3))),
    printed=vector(0, -root_3 * at(S_H, leg, 1).x, root_3 * at(S_H, leg, 2).x),
    meant={"true of the components in {P}": {S_H: S_P}},
)


def sideways(alpha, beta, phi):
    """X and y of the platform as (14) and (15) print them."""
    c_a, s_a, c_b, s_b = cos(alpha), sin(alpha), cos(beta), sin(beta)
    c_f, s_f, c_e, s_e, s_2a = cos(phi), sin(phi), cos(eta), sin(eta), sin(2 * alpha)
    half = number("0.5")
    x = -half * r_m * (
        c_e * c_f * (c_a**2 * c_b - c_a**2 + 1) + half * s_2a * c_e * s_f * (c_b - 1)
        - c_f * (c_a**2 + c_b * s_a**2) + half * s_2a * s_f * (c_b - 1) + c_a * s_b * s_e
    )  # fmt: skip
    y = r_m * (
        c_e * s_f * (c_a**2 + c_b * s_a**2) + c_a * c_e * c_f * s_a * (c_b - 1) + s_a * s_b * s_e
    )
    return x, y


x_14, y_15 = sideways(alpha, beta, phi)
by_13 = carried.rotation
p.equation(
    "14, 15 from (13)",
    words="x and y by (14) and (15), as the planes give them by the elements of (13)",
    quote="Then the constraint relations of x_m-H and y_m-H are obtained",
    claims=vector(r_m * (by_13.column(0).x - by_13.column(1).y) / 2, -r_m * by_13.column(0).y, 0),
    printed=vector(x_14, y_15, 0),
)
# In {P} the azimuths of sun and facet are counted from its x axis, which the facet's is half a
# turn away from.
x_P, y_P = (
    p.define(name, value, because=f"({key}) with all azimuths counted in {{P}}.",
             meaning=f"{name[0]} of the platform by ({key}), read in {{P}}",
             latex=rf"{name[0]}_{{({key})}}")
    for name, key, value in zip(
        ("x_P", "y_P"), ("14", "15"), sideways(alpha - phi + PI, beta, PI), strict=True
    )
)  # fmt: skip
p.equation("14", words="x of the platform in {H}", claims=M.x, printed=x_14)
p.equation("15", words="y of the platform in {H}", claims=M.y, printed=y_15)
p.equation(
    "14 in {P}",
    words="x of the platform in {P}, by (14) with all azimuths counted in {P}",
    claims=dish["x_M"],
    printed=x_P,
)
p.equation(
    "15 in {P}",
    words="y of the platform in {P}, by (15) with all azimuths counted in {P}",
    claims=dish["y_M"],
    printed=y_P,
)

rows = dish["H_R_M"].rows
columns = [vector(*(row[k] for row in rows)) for k in range(2)]
n_H, o_H = (
    p.define(name, column, because="as (12) names the axes",
             meaning=f"axis {axis} of {{M}} in {{H}}", latex=rf"\mathbf{{{name[0]}}}")
    for name, axis, column in zip(("n_H", "o_H"), "xy", columns, strict=True)
)  # fmt: skip
n_P, o_P = (
    p.define(name, R_P.transpose() @ column, because="the same axis in {P}",
             meaning=f"axis {axis} of {{M}} in {{P}}", latex=rf"{{}}^{{P}}\mathbf{{{name[0]}}}")
    for name, axis, column in zip(("n_P", "o_P"), "xy", columns, strict=True)
)  # fmt: skip
in_P = {M: dish["M_P"], n_H: n_P, o_H: o_P}
p.equation(
    "from the planes",
    words="x and y of the platform by the elements of (12), as (14) and (15) take them",
    quote="Then the constraint relations of x_m-H and y_m-H are obtained",
    claims=vector(M.x, M.y, 0),
    printed=vector(number("0.5") * r_m * (n_H.x - o_H.y), -r_m * n_H.y, 0),
    meant={"true of the components in {P}": in_P},
)
turned = R_P.transpose() @ carried.rotation  # the rotation (13), in {P}
p.between(
    "third plane",
    "its three legs can only move in the planes [...] the constraint relations of x_m-H and y_m-H "
    "are obtained",
    turned.column(0).y - turned.column(1).x,
    0,
    0,
    words="n_2 - o_1 of (13) in {P}, which is 0 where the third leg is in its plane too,",
)
told = "the distance of S-joint i from the plane of its hinge"
off_plane = p.define(
    "off_plane",
    dish["t"].dot(vector(x_P, y_P, dish["z_M"]) + turned @ (r_m * u)),
    because="The rotation (13), with x and y of (14) and (15) in {P}.",
    meaning=f"{told}, in the pose of (13) to (15)",
    latex=r"\epsilon",
)
p.between(
    "joints",
    "The movement of the 3-RPS moving platform is constrained by spherical joints, so its three "
    "legs can only move in the planes",
    off_plane,
    0,
    0,
    words=f"{told}, in the pose of (13) to (15), all in {{P}},",
)

# ---- The sun ----

enu = dish.quantity("enu")
from_north, alpha_s = direction_angles(enu)
gamma_29 = p.define(
    "gamma_29", from_north - PI, because="From the south, positive in the afternoon: (29).",
    meaning="azimuth of the sun from the south, positive to the west", latex=r"\gamma_{(29)}",
)  # fmt: skip
altitude = p.define(
    "alpha_s", alpha_s, because="the paper's name", meaning="altitude of the sun", latex=r"\alpha_s"
)
right = degrees(90)
p.equation(
    "16",
    words="azimuth of the dish's axis, from the east",
    claims=dish["alpha_aim"],
    printed={
        "gamma_s from the north, clockwise": right - from_north,
        "gamma_s by (29), from the south": right - gamma_29,
    },
)
p.equation(
    "16'",
    words="angle of the dish's axis from the zenith",
    claims=dish["beta_aim"],
    printed=right - altitude,
)
p.equation(
    "16''",
    words="attitude with gamma = -alpha, as the tilt from the zenith without torsion",
    claims=tilted(dish["c_dish"]).matrix(),
    printed=elementary(Z, alpha) @ elementary(Y, beta) @ elementary(Z, -alpha),
)


def axis_of_dish(azimuth):
    """The third column of (11) with the angles of (16)."""
    alpha, beta = right - azimuth, right - altitude
    return vector(cos(alpha) * sin(beta), sin(alpha) * sin(beta), cos(beta))


p.equation(
    "axis by (16)",
    words="axis of the dish, on the sun, with gamma_s from the north",
    quote="the normal line of the dish concentrator is parallel to the incident sunlight",
    claims=enu,
    printed=axis_of_dish(from_north),
)
p.equation(
    "axis by (16), (29)",
    words="axis of the dish, on the sun, with gamma_s as (29) gives it",
    quote="the normal line of the dish concentrator is parallel to the incident sunlight",
    claims=enu,
    printed=axis_of_dish(gamma_29),
)
p.between(
    "no turn about Z",
    "the parabolic dish concentrator cannot rotate around the Z axis",
    dish["Omega_O"].z,
    0,
    0,
    words="the dish's angular velocity about Z",
)
hour_angle = sun.quantity("hour_angle")
p.equation(
    "symmetric",
    words="direction to the sun as long before noon, mirrored in the plane ZHX",
    quote="the path of the sun in a day is basically symmetrical with respect to the ZHX plane",
    claims=substitute(sun["enu"], {hour_angle: -hour_angle}),
    printed=vector(sun["enu"].x, -sun["enu"].y, sun["enu"].z),
)
p.equation(
    "initial pose",
    words="axis of the dish by (11) and (16), with altitude and azimuth of 90 deg",
    quote="When the solar altitude angle and the azimuth angle are both 90 deg, the attitude of "
    "the novel dish solar tracking platform is in the initial position",
    claims=substitute(dish["c_dish"], {alpha: 0, beta: 0}),
    printed=vector(
        cos(right - right) * sin(right - right), sin(right - right) * sin(right - right),
        cos(right - right),
    ),
)  # fmt: skip
