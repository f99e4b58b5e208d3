"""Mo et al.: the rods and their rates, (17) to (27)."""

from armillary import (
    at,
    cos,
    matrix,
    number,
    partial,
    sin,
    sqrt,
    time_derivative,
    vector,
)

from ._mo2023_frames import alpha, beta, dish, eta, p, phi, r_b, r_m, z_O
from ._mo2023_platform import H_T_P, R_P, M, leg, x_14, y_15

u = dish["u"]
R = dish["H_R_M"].rows
half, root_3 = number("0.5"), sqrt(number(3))


def turned(rows, v):
    """The rotation with these rows, applied to a vector."""
    return vector(*(row[0] * v.x + row[1] * v.y + row[2] * v.z for row in rows))


# ---- The joints and the lengths ----


def each_joint(v):
    """A vector per leg as three columns."""
    parts = [at(v, leg, k) for k in range(3)]
    return matrix([a.x for a in parts], [a.y for a in parts], [a.z for a in parts])


def circle(r):
    """Three joints on a circle as the text prints them, a column each."""
    across = root_3 / 2 * r
    return matrix((r, -half * r, -half * r), (0, across, -across), (0, 0, 0))


p.equation(
    "joints of the base",
    words="B_1, B_2 and B_3 in {P}, a column each",
    quote="the coordinates of the rotary joints in coordinate system {P}",
    claims=each_joint(r_b * u),
    printed=circle(r_b),
)
p.equation(
    "joints of the platform",
    words="S_1, S_2 and S_3 in {M}, a column each",
    quote="the coordinates of the spherical joints in coordinate system {M}",
    claims=each_joint(r_m * u),
    printed=circle(r_m),
)

P = H_T_P.position
BS_H = p.define(
    "BS_H", R_P @ dish["BS"], because="The rod's vector, turned from {P} to {H}.",
    meaning="vector along rod i, {H}", latex=r"\overrightarrow{BS}_H",
)  # fmt: skip
MS, PB = r_m * u, r_b * u
S, B = M + turned(R, MS), P + R_P @ PB
p.equation(
    "17",
    words="vector along rod i, and a 1 below it",
    claims=matrix([BS_H.x], [BS_H.y], [BS_H.z], [1]),
    printed=matrix([S.x - B.x], [S.y - B.y], [S.z - B.z], [number(1) - number(1)]),
)
p.equation("18", words="length of rod i", claims=dish["l_rod"], printed=BS_H.norm())
p.unchecked("19", "pose of the platform", "It names the quantities that the pose stands on.")

# ---- The rates ----

v_M, Omega, V_S = dish["v_M"], dish["Omega_M"], dish["V_S"]
e, r_S = dish["e"], dish["r_S"]
alpha_dot, beta_dot, z_dot = (dish.quantity(name) for name in ("alpha_dot", "beta_dot", "z_dot"))
lever = r_S.cross(e)
p.equation(
    "20",
    words="velocity of the S-joint of rod i",
    claims=V_S,
    printed=v_M + Omega.cross(r_S),
)
p.equation(
    "20 in words",
    words="velocity of the S-joint of rod i, its radius vector as the text has it",
    quote="H_r_Si is the radius vector from the spherical joint S_i to point M",
    claims=V_S,
    printed=v_M + Omega.cross(-r_S),
)
p.equation("21", words="rate of rod i", claims=dish["l_dot"], printed=V_S.dot(e))
p.equation(
    "21'",
    words="rate of rod i, from the motion of the platform",
    claims=dish["l_dot"],
    printed=e.dot(v_M) + lever.dot(Omega),
)
J_A, J_B = dish["J_A"].rows[0], dish["J_B"].rows
p.equation(
    "22",
    words="row i of J_A",
    claims=dish["J_A"],
    printed=matrix([e.x, e.y, e.z, lever.x, lever.y, lever.z]),
)
p.equation(
    "22'",
    words="rate of rod i, as row i of J_A times the motion of the platform",
    claims=dish["l_dot"],
    printed=vector(*J_A[:3]).dot(v_M) + vector(*J_A[3:]).dot(Omega),
)

# ---- J_B ----

c_a, s_a, c_b, s_b, s_2a = cos(alpha), sin(alpha), cos(beta), sin(beta), sin(2 * alpha)
c_e, s_e, c_f, s_f = cos(eta), sin(eta), cos(phi), sin(phi)
named = "the paper's shorthand"
k_1 = p.define("k_1", c_e * c_f, because=named, latex="k_1")
k_2 = p.define("k_2", s_f * c_e, because=named, latex="k_2")
k_3 = p.define("k_3", half * s_f * (c_e + 1), because=named, latex="k_3")
k_4 = p.define("k_4", k_1 + c_f, because=named, latex="k_4")
J_v1 = vector(
    half * r_m * (
        (c_b - 1) * c_f * s_2a + s_e * s_a * s_b
        - (c_b - 1) * (k_2 + s_f) * cos(2 * alpha) + k_1 * (c_b - 1) * s_2a
    ),
    r_m * (
        k_1 * (c_b - 1) * c_a**2 + s_e * s_b * c_a
        + 2 * k_2 * (c_b - 1) * c_a * s_a - k_1 * (c_b - 1) * s_a**2
    ),
    0,
)  # fmt: skip
J_v2 = vector(
    half * r_m * (s_b * c_a**2 * k_4 + k_1 * s_2a * s_b - s_e * c_a * c_b - c_f * s_b),
    -r_m * s_a * (k_1 * c_a * s_b - s_e * c_b + k_2 * s_a * s_b),
    0,
)
J_v3 = vector(0, 0, 1)
p.equation(
    "23",
    words="velocity of the platform",
    claims=v_M,
    printed=J_v1 * alpha_dot + J_v2 * beta_dot + J_v3 * z_dot,
)
position = vector(x_14, y_15, dish["z_M"])
for key, q, column in (("23'", alpha, J_v1), ("23''", beta, J_v2), ("23'''", z_O, J_v3)):
    p.equation(
        key,
        words=f"derivative by {q.name} of x by (14), y by (15) and z by (13)",
        claims=partial(position, q),
        printed=column,
    )

spin = [[time_derivative(entry) for entry in row] for row in R]
spun = p.define(
    "spun",
    matrix(
        *(
            [spin[i][0] * R[j][0] + spin[i][1] * R[j][1] + spin[i][2] * R[j][2] for j in range(3)]
            for i in range(3)
        )
    ),
    because="The derivative of the platform's rotation by the time, and its inverse.",
    meaning="rate of the platform's rotation, times its inverse",
    latex=r"{}^{H}\dot{R}_M\,{{}^{H}R_M}^{-1}",
)
p.equation(
    "24",
    words="rate of the platform's rotation, times its inverse",
    claims=spun,
    printed={
        "the minus before H of the entry (1, 2) as a sign": matrix(
            (0, -Omega.z, Omega.y), (Omega.z, 0, -Omega.x), (-Omega.y, Omega.x, 0)
        ),
        "the minus as a part of the index": matrix(
            (0, Omega.z, Omega.y), (Omega.z, 0, -Omega.x), (-Omega.y, Omega.x, 0)
        ),
    },
)
p.equation(
    "25",
    words="angular velocity of the platform",
    claims=Omega,
    printed=vector(
        -s_a * beta_dot + s_b * c_a * -alpha_dot,
        c_a * beta_dot + s_b * s_a * -alpha_dot,
        alpha_dot + c_b * -alpha_dot,
    ),
)
p.equation(
    "26",
    words="J_B, put together of (23) and (25)",
    claims=dish["J_B"],
    printed=matrix(
        *([a, b, c] for a, b, c in zip(*(v.components for v in (J_v1, J_v2, J_v3)), strict=True)),
        (-s_b * c_a, -s_a, 0),
        (-s_b * s_a, c_a, 0),
        (1 - c_b, 0, 0),
    ),
)
p.equation(
    "27",
    words="rate of rod i, as J_A times J_B times the rates",
    claims=dish["l_dot"],
    printed=sum(
        (J_A[k] * (J_B[k][0] * alpha_dot + J_B[k][1] * beta_dot + J_B[k][2] * z_O)
         for k in range(6)),
        start=number(0),
    ),
)  # fmt: skip
