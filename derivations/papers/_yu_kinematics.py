"""Yu, Wu and Zhang: frames, lengths and rates of the legs, (1) to (10)."""

from armillary import (
    Chain,
    Paper,
    X,
    Y,
    Z,
    at,
    cos,
    elementary,
    hat,
    matrix,
    number,
    sin,
    time_derivative,
    unit,
    vector,
)

paper = p = Paper(
    "yu",
    title="Energy consumption of a two-axis solar tracker with redundantly actuated parallel "
    "mechanism",
)

rr = p.use("rr_3ups")
sun = p.use("sun")
leg = rr.derivation.indices["leg"]
alpha, beta = rr.quantity("alpha"), rr.quantity("beta")
alpha_dot, beta_dot = rr.quantity("alpha_dot"), rr.quantity("beta_dot")
alpha_ddot, beta_ddot = rr.quantity("alpha_ddot"), rr.quantity("beta_ddot")
r, phi, R, theta, h, h_0, zeta = (
    rr.quantity(name) for name in ("r", "phi", "R", "theta", "h", "h_0", "zeta")
)

p.assume(
    "The figures are lost. The axes are those of the text: X east, Y north and Z up stand for "
    "the static frame, in which nothing else says where the sun is before (27)."
)
p.assume("The paper is in Chinese. Its sentences are quoted in translation.")
p.assume(
    "w_i points from Q_i to P_i, as (3) and the axes of a leg have it; w by (5) is the opposite, "
    "and what that would change is said where it stands first."
)
p.assume(
    "The angular velocity of a leg is that of a body on a universal joint, whose two axes the "
    "text names; a leg that does not spin about itself is another one."
)

SPIN_FREE = "true of a leg that does not spin about itself"


def times(jacobian, first, second):
    """A matrix of two columns times the derivatives of alpha and beta, of three rows at most."""
    made = [row[0] * first + row[1] * second for row in jacobian.rows]
    return made[0] if len(made) == 1 else vector(*made)


def rates(jacobian):
    """A Jacobian times the rates of alpha and beta."""
    return times(jacobian, alpha_dot, beta_dot)


def columns(name, jacobian, letter):
    """The two columns of a Jacobian, with names."""
    return tuple(
        p.define(
            f"{name}_{k + 1}",
            jacobian.column_vector(k),
            because="A product with the matrix is taken column by column.",
            meaning=f"column {k + 1} of {name}",
            latex=rf"\mathbf{{J}}_{{{letter}{k + 1}}}",
        )
        for k in range(2)
    )


def beside(vectors):
    """Vectors as the columns of a matrix."""
    return matrix(*([v[i] for v in vectors] for i in range(3)))


# ---- The frames ----

R_m, leg_frame, gamma, psi = (rr[name] for name in ("R_m", "leg_frame", "gamma", "psi"))
w, q, a, b = (rr[name] for name in ("w", "q_leg", "a", "b"))
c_a, s_a, c_b, s_b = cos(alpha), sin(alpha), cos(beta), sin(beta)
c_z, s_z, c_g, s_g, c_p, s_p = cos(zeta), sin(zeta), cos(gamma), sin(gamma), cos(psi), sin(psi)
rot_m = matrix((c_a, -s_a * c_b, s_a * s_b), (s_a, c_a * c_b, -c_a * s_b), (0, s_b, c_b))
rot_i = matrix(
    (c_z * c_g, -c_z * s_g * c_p + s_z * s_p, c_z * s_g * s_p + s_z * c_p),
    (s_g, c_g * c_p, -c_g * s_p),
    (-s_z * c_g, s_z * s_g * c_p + c_z * s_p, -s_z * s_g * s_p + c_z * c_p),
)
p.equation(
    "1",
    words="rotation of the platform",
    claims=R_m,
    printed=rot_m,
    product=Chain("O").rotate(Z, alpha).rotate(X, beta, frame="o"),
)
p.equation(
    "1 in words",
    words="rotation of the platform, as the two turns of the text",
    quote="alpha and beta are the angles by which the platform turns about the z axis and about "
    "the x axis that follows",
    claims=R_m,
    printed=elementary(Z, alpha) @ elementary(X, beta),
)
p.equation(
    "2",
    words="rotation of leg i",
    claims=leg_frame,
    printed=rot_i,
    product=Chain("O").rotate(Y, zeta).rotate(Z, gamma).rotate(X, psi, frame="leg"),
)
p.word(
    "rotations",
    "the rotation matrix of the moving frame [...] the rotation matrix of the leg's frame",
    "orthogonal",
    of={"(1)": rot_m, "(2)": rot_i},
)
p.equation(
    "y axis",
    words="axis y of leg i by (2), from Q_i to P_i",
    quote="the direction from the centre Q_i of the U joint to the centre P_i of the ball joint is "
    "the y_i axis",
    claims=w,
    printed=rot_i.column_vector(1),
)
first = p.define(
    "e_1",
    elementary(Y, zeta) @ vector(0, 0, 1),
    because="The mounting angle turns it about Y, and the first angle of the joint turns about it.",
    meaning="first axis of universal joint i",
    latex=r"\mathbf{e}_1",
)
p.equation(
    "x axis",
    words="axis x of leg i by (2), along the second axis of its universal joint",
    quote="the direction vector of the second axis of the U joint is the x_i axis",
    claims=unit(w.cross(first)),
    printed=rot_i.column_vector(0),
)

# ---- The loop ----

h0 = vector(0, 0, h_0)
p.equation("3", words="from the ground to o, round leg i", claims=h0, printed=b + q * w - a)
p.equation(
    "a_i'",
    words="vector from o to P_i in the moving frame, in the text after (3)",
    claims=rr["a_m"],
    printed=vector(r * cos(phi), r * sin(phi), 0),
)
p.equation(
    "a_i",
    words="vector from o to P_i, in the text after (3)",
    claims=a,
    printed=R_m @ rr["a_m"],
)
p.equation(
    "b_i",
    words="vector from O to Q_i, in the text after (3)",
    claims=b,
    printed=vector(R * cos(theta), R * sin(theta), h),
)
p.equation("4", words="length of leg i", claims=q, printed=(b - h0 - a).norm())
w_5 = p.define(
    "w_5",
    (b - h0 - a) / q,
    because="(5) divides what leads from P_i to Q_i by the length, and is taken as it stands.",
    meaning="direction of leg i by (5)",
    latex=r"\mathbf{w}_{(5)}",
)
p.equation("5", words="direction of leg i", claims=w, printed=(b - h0 - a) / q)
p.equation(
    "3 by (5)",
    words="from the ground to o, round leg i, with w by (5)",
    claims=h0,
    printed=b + q * w_5 - a,
)

# ---- The rates ----

a_dot, J_a, q_dot, J = (rr[name] for name in ("a_dot", "J_a", "q_dot", "J"))
spun = [[time_derivative(entry) for entry in row] for row in rot_m.rows]
arm = (r * cos(phi), r * sin(phi), number(0))
p.equation(
    "6",
    words="velocity of P_i, as the rate of (1) times a_i'",
    claims=a_dot,
    printed=vector(*(sum((e * x for e, x in zip(row, arm, strict=True)), start=number(0))
                     for row in spun)),
)  # fmt: skip
x_r, y_r = r * cos(phi), r * sin(phi)
J_a_columns = columns("J_a", J_a, "a")
J_6 = matrix((-x_r * c_a * c_b, x_r * s_a * s_b), (-y_r * s_a * c_b, -y_r * c_a * s_b), (0, 0))
p.equation("6'", words="Jacobian of P_i", claims=J_a, printed=J_6)
omega = rr["omega_W"]
p.equation(
    "7",
    words="what vanishes as the loop moves",
    claims=vector(0, 0, 0),
    printed=q_dot * w + q * omega.cross(w) - a_dot,
)
p.equation("8", words="rate of length i", claims=q_dot, printed=w.dot(a_dot))
p.equation(
    "8'",
    words="row i of the Jacobian",
    claims=J,
    printed=matrix([w.dot(column) for column in J_a_columns]),
)
p.equation(
    "8 by (5)",
    words="rate of length i, with w by (5)",
    claims=q_dot,
    printed=w_5.dot(a_dot),
)
p.equation(
    "8 by (6)",
    words="rate of length i, with the Jacobian of P_i by (6)",
    claims=q_dot,
    printed=w.dot(rates(J_6)),
)
p.equation(
    "9",
    words="rates of the three lengths, by the rows of the Jacobian",
    claims=vector(*(at(q_dot, leg, k) for k in range(3))),
    printed=vector(*(at(rates(J), leg, k) for k in range(3))),
)
J_omega = rr["J_omega_free"]
J_omega_columns = columns("J_omega", J_omega, r"\omega ")
p.equation(
    "10",
    words="angular velocity of leg i",
    claims=omega,
    printed=(1 / q) * w.cross(a_dot),
)
p.equation(
    "10 reason",
    words="what (7) becomes, multiplied by w_i",
    quote="because w_i x w_i = 0 and w_i x (q_i omega_i x w_i) = q_i omega_i",
    claims=w.cross(q * omega.cross(w)),
    printed=q * omega,
    meant={SPIN_FREE: {omega: rr["omega_free_W"]}},
)
p.equation(
    "10'",
    words="Jacobian of the angular velocity that (10) gives",
    claims=J_omega,
    printed=beside([w.cross(column) / q for column in J_a_columns]),
)
p.equation(
    "10''",
    words="matrix of the cross product with w_i",
    claims=hat(w),
    printed=matrix((0, -w.z, w.y), (w.z, 0, -w.x), (-w.y, w.x, 0)),
)
