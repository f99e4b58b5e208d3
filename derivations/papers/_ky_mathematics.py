"""Ky et al.: the mathematics, (01) to (10)."""

from armillary import (
    Chain,
    Paper,
    Pose,
    X,
    Y,
    Z,
    cos,
    elementary,
    hat,
    matrix,
    sin,
    time_derivative,
    vector,
)
from armillary.derivation.units import RADIAN, SECOND

paper = p = Paper("ky", title="Basic mathematics to robotic for tracking systems")

altazimuth = p.use("altazimuth")
orientation = p.use("orientation")

p.assume("The figures are lost, and with them the axes' directions: x is east, y north and z up.")
p.assume(
    "The image of (01), a dot in each line of (09) and the dot of (22) are lost or doubtful: each "
    "way to read them is judged. The transposition sign of (20) is scanned as an I."
)
p.assume(
    "The azimuth of (12) is counted from the south, positive to the west, as in the book that the "
    "paper cites for it."
)
p.assume(
    "What faces the sun is the collector's axis z on the altazimuth, the quasi-steady and the "
    "steady mount, and its axis y on the equatorial one."
)

# ---- II. Mathematics ----

beta = p.angle("beta", "angle of a rotation")

about_x = matrix(
    (1, 0, 0),
    (0, cos(beta), -sin(beta)),
    (0, sin(beta), cos(beta)),
)
about_x_transposed = matrix(
    (1, 0, 0),
    (0, cos(beta), sin(beta)),
    (0, -sin(beta), cos(beta)),
)
# The image of (01) is lost: it turns as (02) and (03) do, or the other way.
p.equation(
    "01",
    words="rotation about x",
    claims=elementary(X, beta),
    printed={"turning as (02) and (03) do": about_x, "transposed": about_x_transposed},
)
p.equation(
    "02",
    words="rotation about y",
    claims=elementary(Y, beta),
    printed=matrix(
        (cos(beta), 0, sin(beta)),
        (0, 1, 0),
        (-sin(beta), 0, cos(beta)),
    ),
)
p.equation(
    "03",
    words="rotation about z",
    claims=elementary(Z, beta),
    printed=matrix(
        (cos(beta), -sin(beta), 0),
        (sin(beta), cos(beta), 0),
        (0, 0, 1),
    ),
)

turns = tuple(orientation.quantity(name) for name in "abc")
phi = p.define("phi", turns[0], because="the paper's name of the first turn", latex=r"\phi")
theta = p.define("theta", turns[1], because="of the second", latex=r"\theta")
psi = p.define("psi", turns[2], because="of the third", latex=r"\psi")

euler = elementary(Z, phi) @ elementary(X, theta) @ elementary(Z, psi)
bryant = elementary(Z, phi) @ elementary(Y, theta) @ elementary(X, psi)
lebian = elementary(Z, phi) @ elementary(Y, theta) @ elementary(Y, psi)

p.equation(
    "ZYZ",
    words="the product that is named ZYZ Euler",
    quote="ZYZ EULER or Tilt and Torsion-T&T angles combination: "
    "Rot_z0(phi).Rot_x1(theta).Rot_z2(psi)",
    claims=orientation["R_zyz"],
    printed=euler,
)
p.equation(
    "T&T",
    words="the same product, named tilt and torsion",
    quote="ZYZ EULER or Tilt and Torsion-T&T angles combination: "
    "Rot_z0(phi).Rot_x1(theta).Rot_z2(psi)",
    claims=orientation["R_tilt_torsion"],
    printed=euler,
)
p.equation(
    "ZYX",
    words="the product that is named ZYX Bryant, or yaw, pitch and roll",
    quote="ZYX BRYANT or Yaw-Pitch-Roll angles Rot_z0(phi).Rot_y1(theta).Rot_x2(psi)",
    claims=orientation["R_zyx"],
    printed=bryant,
)
p.equation(
    "ZXX",
    words="the product that is named ZXX Lebian",
    quote="ZXX LEBIAN angles combination: Rot_z0(phi).Rot_y1(theta).Rot_y2(psi)",
    claims=elementary(Z, phi) @ elementary(X, theta) @ elementary(X, psi),
    printed=lebian,
)
for name, product in {"EULER": euler, "BRYANT": bryant, "LEBIAN": lebian}.items():
    p.spans(
        f"3 angles {name}",
        "The industrial robots use these angles combinations for the bearer (usually 3 angles) "
        "and the wrist (also 3 angles)",
        turns=product,
        angles=turns,
    )

p.unchecked(
    "04",
    "homogeneous matrix",
    "It names the blocks of a matrix: nothing is stated of them that a number could refute.",
)
p.equation(
    "05",
    words="transposed matrix of a rotation about x",
    claims=Pose(elementary(X, beta).transpose(), vector(0, 0, 0)),
    printed=matrix(
        (1, 0, 0, 0),
        (0, cos(beta), sin(beta), 0),
        (0, -sin(beta), cos(beta), 0),
        (0, 0, 0, 1),
    ),
)
L_j = p.length("L_j", "distance of a translation")
p.equation(
    "06",
    words="translation along x",
    claims=Chain("i").translate(X, L_j, frame="j").pose("i", "j"),
    printed=matrix(
        (1, 0, 0, L_j),
        (0, 1, 0, 0),
        (0, 0, 1, 0),
        (0, 0, 0, 1),
    ),
)
p.unchecked(
    "07",
    "velocity tensor",
    "It names angular velocity and velocity as a pair: nothing is stated that a number could "
    "refute.",
)

# (08) and (09) hold or fail for any body; the collector of the altazimuth tracker stands for it.
Rot, Tr = altazimuth["M"].rotation, altazimuth["M"].position
Omega = p.define(
    "Omega",
    altazimuth["Omega_space"],
    because="the paper's name of the body's angular velocity",
    latex=r"\vec\Omega",
)
T = p.define("T", Tr, because="the paper's name of the body's displacement", latex=r"\vec T")
T_dot = p.define(
    "T_dot", time_derivative(Tr), because="the rate of the displacement", latex=r"\dot{\vec T}"
)
V = p.define("V", T_dot - Omega.cross(T), because="the second line of (09)", latex=r"\vec V")
skew = hat(Omega).rows
p.equation(
    "08",
    words="velocity matrix, of the blocks that (09) gives",
    claims=altazimuth["V_space"],
    printed=matrix(
        (*skew[0], V.x),
        (*skew[1], V.y),
        (*skew[2], V.z),
        (0, 0, 0, 0),
    ),
)

rows = [
    p.define(
        f"r_{i + 1}",
        Rot.transpose().column(i),
        because=f"row {i + 1} of Rot",
        latex=rf"\mathbf{{r}}_{i + 1}",
    )
    for i in range(3)
]
row_rates = [
    p.define(
        f"r_{i + 1}_dot",
        time_derivative(row),
        because=f"row {i + 1} of Rot with its dot",
        latex=rf"\dot{{\mathbf{{r}}}}_{i + 1}",
    )
    for i, row in enumerate(rows)
]


def minus_product(left, right):
    """The entries of -A B^T, from the rows of A and of B."""
    return matrix(*([-a.dot(b) for b in right] for a in left))


dot_on_first = minus_product(row_rates, rows)
dot_on_second = minus_product(rows, row_rates)
p.equation(
    "09",
    words="skew matrix of the angular velocity: -Rot Rot^T, one of the factors with a dot",
    claims=hat(altazimuth["Omega_space"]),
    printed={"dot on Rot": dot_on_first, "dot on Rot^T": dot_on_second},
)
p.equation(
    "09'",
    words="velocity of the body: -Omega T + T, one of the T with a dot",
    claims=altazimuth["v_spatial"],
    printed={
        "dot on the last T": -Omega.cross(T) + T_dot,
        "dot on the first T": -Omega.cross(T_dot) + T,
    },
)
p.word(
    "antisymmetric",
    "Omega_i^0 is an antisymmetric matrix that gives the vector Omega(i/0) by identification",
    "skew-symmetric",
    of={"-Rot Rot^T, dot on Rot": dot_on_first, "dot on Rot^T": dot_on_second},
)

alpha_dot, beta_dot, theta_dot = (
    p.scalar(
        f"{name}_dot",
        "component of an angular velocity",
        unit=RADIAN / SECOND,
        latex=rf"\dot{{\{name}}}",
    )
    for name in ("alpha", "beta", "theta")
)
p.equation(
    "10",
    words="skew matrix of a vector",
    claims=hat(vector(alpha_dot, beta_dot, theta_dot)),
    printed=matrix(
        (0, -theta_dot, beta_dot),
        (theta_dot, 0, -alpha_dot),
        (-beta_dot, alpha_dot, 0),
    ),
)
