"""Mo et al.: the paraboloid, its normals, and the frames of facet and base, (1) to (9)."""

from armillary import (
    PI,
    Paper,
    Y,
    Z,
    arccos,
    cos,
    degrees,
    elementary,
    matrix,
    number,
    partial,
    sin,
    sqrt,
    vector,
)
from armillary.derivation.units import METRE

paper = p = Paper(
    "mo2023",
    title="Design, modeling and solar tracking control for a novel parabolic dish solar "
    "concentrator",
)

dish = p.use("dish_3rps")
sun = p.use("sun")
f, d, z_O = (dish.quantity(name) for name in ("f", "d", "z_O"))
r_b, r_m, phi = (dish.quantity(name) for name in ("r_b", "r_m", "phi"))
alpha, beta = dish.quantity("alpha"), dish.quantity("beta")

p.assume(
    "The figures are lost. The axes are those of the text: {H} is East-North-Up on the ground "
    "below the dish, and the origin of {O} is the vertex that (1) has there."
)
p.assume(
    "The tables are lost. Where a finding needs dimensions, they are an inferred set that gives "
    "the shortest and the longest rod of the paper: D = 2 m, edge angle 40 deg, d = 0.6 m, "
    "r_m = 0.5 m, r_b = 0.25 m, with z_O = 2960.23 mm as printed. Other sets give them too."
)
p.assume(
    "cos phi^2 is the square of cos phi, and what follows a stroke, as in d^2/4f, stands below it: "
    "the lines after (13) print it so."
)
p.assume(
    "The bar before the arc cosine of (29) has no other beside it; both bars would change nothing."
)
p.assume("The four days, which have no dates, are numbers 80, 172, 266 and 355 of the year.")


def square(value):
    """What the paper prints as cos phi^2, too."""
    return value * value


def height(phi):
    """The height of M above the vertex as (2), (8) and (13) print it."""
    return (d**2 * square(cos(phi)) + d**2 * square(sin(phi))) / (4 * f)


# ---- The paraboloid ----

M_O, gradient, n_O = dish["M_O"], dish["gradient"], dish["n_O"]
named = "the paper's name of the coordinate of M in {O}"
x_m = p.define("x_m", M_O.x, because=named, latex=r"x_{m\_O}")
y_m = p.define("y_m", M_O.y, because=named, latex=r"y_{m\_O}")
z_m = p.define("z_m", M_O.z, because=named, latex=r"z_{m\_O}")

p.equation(
    "1",
    words="what vanishes on the paraboloid",
    claims=dish["on_dish"],
    printed=x_m**2 + y_m**2 - 4 * f * z_m,
)
p.equation(
    "2",
    words="point M in {O}",
    claims=M_O,
    printed=vector(d * cos(phi), d * sin(phi), height(phi)),
)
D, theta_rim = dish.quantity("D"), dish.quantity("theta_rim")
p.equation(
    "f",
    words="focal length, in the text after (2)",
    claims=dish["f_rim"],
    printed=D * (1 + cos(theta_rim)) / (4 * sin(theta_rim)),
)
surface = p.define(
    "z_C",
    D**2 / (32 * dish["f_rim"]),
    because="Over the aperture the paraboloid is half as high as at its rim.",
    meaning="height of the dish's centroid above the vertex",
    latex="z_C",
)
p.equation(
    "centroid",
    words="height of the dish's centroid above the point O of (1)",
    quote="Point O is the centroid of the dish concentrator",
    claims=surface,
    printed=number(0),
)

# ---- The normals ----

along = p.scalar(
    "along", "distance from M along the normal", unit=METRE, range=(-2.0, 2.0), latex=r"\ell"
)
on_normal = "a point of the normal through M, in {O}"
x = p.define("x", M_O.x + along * n_O.x, because=on_normal, latex="x")
y = p.define("y", M_O.y + along * n_O.y, because=on_normal, latex="y")
z = p.define("z", M_O.z + along * n_O.z, because=on_normal, latex="z")
by = "the paper's name of the component of the gradient"
F_x = p.define("F_x", gradient.x, because=by, latex=r"\partial F/x_{m\_O}")
F_y = p.define("F_y", gradient.y, because=by, latex=r"\partial F/y_{m\_O}")
F_z = p.define("F_z", gradient.z, because=by, latex=r"\partial F/z_{m\_O}")
ratio = p.define(
    "ratio",
    -along / (2 * dish["slope_length"]),
    because="The gradient is as long as twice the normal down to the axis, and points outward.",
    meaning="what the ratios of the normal's equation are equal to",
    latex="k",
)
p.equation(
    "3",
    words="the three ratios that are equal on the normal",
    claims=vector(ratio, ratio, ratio),
    printed=vector((x - y_m) / F_x, (x - y_m) / F_y, (z - z_m) / F_z),
)
p.equation(
    "4",
    words="gradient of F: the right sides",
    claims=gradient,
    printed=vector(2 * x_m, 2 * y_m, -4 * f),
)
X_m, Y_m, Z_m = (
    p.scalar(f"{axis}_any", f"any {axis}, for F off the paraboloid", unit=METRE, range=(-2.0, 2.0),
             latex=rf"{axis}_{{m\_O}}")
    for axis in "xyz"
)  # fmt: skip
F = p.define(
    "F_any",
    X_m**2 + Y_m**2 - 4 * f * Z_m,
    because="(1), of any point: it is to be differentiated.",
    latex="F",
)
p.equation(
    "4'",
    words="gradient of F: the left sides, each with one sign of differentiation",
    claims=vector(partial(F, X_m), partial(F, Y_m), partial(F, Z_m)),
    printed=vector(F / X_m, F / Y_m, F / Z_m),
)
z_G = p.define(
    "z_G",
    M_O.z + dish["slope_length"] * n_O.z,
    because="There the normal through M meets the axis, which is the normal through O.",
    meaning="height of G above the vertex",
    latex=r"z_{G\_O}",
)
p.equation(
    "G",
    words="height of G, from (3) at x = y = 0",
    quote="substitute the coordinates of point G into Eq. (4)",
    claims=z_G,
    printed={
        "the first and the last ratio of (3)": z_m - y_m * (F_z / F_x),
        "the second and the last": z_m - y_m * (F_z / F_y),
    },
)
GO, GM = vector(0, 0, -z_G), vector(x_m, y_m, z_m - z_G)
from_G = {"O": sqrt((-z_G) ** 2), "M": sqrt(x_m**2 + y_m**2 + (z_m - z_G) ** 2)}
p.equation("5", words="distance from G to O", claims=GO.norm(), printed=from_G["O"])
p.equation("6", words="distance from G to M", claims=dish["slope_length"], printed=from_G["M"])
eta = dish["eta"]
p.equation(
    "7",
    words="angle between the normals",
    claims=eta,
    printed=arccos(GO.dot(GM) / (from_G["O"] * from_G["M"])),
)
p.between("7'", "0 <= eta <= 90", eta, 0, degrees(90), words="the angle between the normals")

# ---- The frames ----

O_R_M = dish["O_T_M"].rotation
p.equation(
    "clockwise",
    words="rotation of (8), as the two turns of the text",
    quote="the coordinate system {O} can be obtained by rotating {M} clockwise eta around Y_m-axis "
    "and clockwise phi around Z_m'-axis",
    claims=O_R_M,
    printed=(elementary(Y, -eta) @ elementary(Z, -phi)).transpose(),
)
p.equation(
    "8",
    words="pose of {M} in {O}",
    claims=dish["O_T_M"],
    printed=matrix(
        (-cos(eta) * cos(phi), sin(phi), -cos(phi) * sin(eta), d * cos(phi)),
        (-cos(eta) * cos(phi), -cos(phi), -sin(eta) * sin(phi), d * cos(phi)),
        (-sin(eta), 0, cos(eta), height(phi)),
        (0, 0, 0, 1),
    ),
)
p.equation(
    "9",
    words="pose of {P} in {H}",
    claims=dish["H_T_P"],
    printed=matrix(
        (-cos(phi), sin(phi), 0, d * cos(phi)),
        (-sin(phi), -cos(phi), 0, d * sin(phi)),
        (0, 0, 1, 0),
        (0, 0, 0, 1),
    ),
)
p.equation(
    "from {P} to {H}",
    words="rotation of (9), as the turn of the text",
    quote="the coordinate system {P} rotates (phi - 180) deg around the Z axis to obtain "
    "coordinate system {H}",
    claims=dish["H_T_P"].rotation,
    printed=elementary(Z, phi - PI).transpose(),
)
p.equation(
    "from {P} to {O}",
    words="rotation of (9), as the heading of its section has it",
    quote="3.2.2. Rotation transformation matrix from {P} to {O}",
    claims=dish["H_T_O"].rotation.transpose() @ dish["H_T_P"].rotation,
    printed=matrix((-cos(phi), sin(phi), 0), (-sin(phi), -cos(phi), 0), (0, 0, 1)),
)
