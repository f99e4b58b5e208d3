"""Platform and legs: joints, lengths, and how the two angles move them."""

from armillary import (
    Leg,
    Matrix,
    Place,
    Platform,
    X,
    Z,
    any_of,
    at,
    cos,
    elementary,
    number,
    partial,
    sin,
    time_derivative,
    vector,
    where,
)
from armillary.derivation.units import METRE, SECOND

from .symbols import (
    R,
    alpha,
    alpha_ddot,
    alpha_dot,
    beta,
    beta_ddot,
    beta_dot,
    d,
    h,
    h_0,
    leg,
    leg_tolerance,
    phi,
    r,
    theta,
)

UP = vector(0, 0, 1)
EAST = vector(1, 0, 0)

# ---- the loop, in the world ----

R_m = d.define(
    "R_m",
    elementary(Z, alpha) @ elementary(X, beta),
    because="The platform turns about the vertical, then about the level axis that turned with it.",
    meaning="rotation of the platform: its axes in the world's",
    printed="1",
    latex="R_m",
)
a_m = d.define(
    "a_m",
    vector(r * cos(phi), r * sin(phi), number(0)),
    because="The spherical joints lie in a plane through o.",
    meaning="from o to spherical joint i, platform axes",
    latex=r"\mathbf{a}_m",
)
b = d.define(
    "b",
    vector(R * cos(theta), R * sin(theta), h),
    because="The universal joints stand around the column.",
    meaning="position of universal joint i, world axes",
    latex=r"\mathbf{b}",
)
platform = Platform(Place(R_m, h_0 * UP), (Leg(base_joint=b, platform_joint=a_m),))
a = d.define(
    "a",
    platform.leg.arm,
    because="The platform carries its joints.",
    meaning="from o to spherical joint i, world axes",
    latex=r"\mathbf{a}",
)
P = d.define(
    "P",
    platform.leg.joint,
    because="o stands on the column.",
    meaning="position of spherical joint i, world axes",
    latex=r"\mathbf{P}",
)
l_W = d.define(
    "l_W",
    platform.leg.vector,
    because="The loop closes: column, platform, leg and ground.",
    meaning="from universal joint i to spherical joint i, world axes",
    printed="3",
    latex=r"\mathbf{l}",
)

# ---- the same, turned back with the platform ----

b_c = d.define(
    "b_c",
    elementary(Z, -alpha) @ (b - h_0 * UP),
    because="Turn the ground back instead of the platform forward: then each angle moves one "
    "vector, and alpha only this one.",
    meaning="from o to universal joint i, axes turned about the vertical with the platform",
    latex=r"\mathbf{b}_c",
)
a_c = d.define(
    "a_c",
    elementary(X, beta) @ a_m,
    because="The tilt moves only this one.",
    meaning="from o to spherical joint i, axes turned about the vertical with the platform",
    latex=r"\mathbf{a}_c",
)
l_c = d.define(
    "l_c",
    a_c - b_c,
    because="The leg joins the two.",
    meaning="from universal joint i to spherical joint i, turned axes",
    latex=r"\mathbf{l}_c",
)
d.identity("it is the leg of the loop, turned back", elementary(Z, alpha) @ l_c, l_W)
q = d.define(
    "q_leg",
    l_c.norm(),
    because="A turn changes no length.",
    meaning="length of leg i",
    printed="4",
    latex="q",
)
no_leg = d.define(
    "no_leg",
    any_of(~(q > leg_tolerance), over=leg),
    because="A leg without length has no direction.",
    meaning="whether a leg has no length",
)
no_leg_2 = d.define(
    "no_leg_2",
    ~((at(q, leg, 0) > leg_tolerance) & (at(q, leg, 1) > leg_tolerance)),
    because="Where leg 3 is absent, it does not count.",
    meaning="whether leg 1 or 2 has no length",
)
length = d.define(
    "length",
    where(q > leg_tolerance, q, leg_tolerance),
    because="What is divided by must not be 0; where the tolerance stands in, the status tells it.",
    meaning="length of leg i, at least the tolerance",
    latex="q^+",
)

# ---- half the square of a length ----
E = d.define(
    "E",
    -b_c.dot(a_c),
    because="Half the square of a length is half those of both arms, less their product. Turns "
    "keep the arms, so that this is all of it that moves.",
    meaning="what the angles change of half the square of length i",
    latex="E",
)
d.identity(
    "it is half the square, less what stands still",
    E,
    (q * q - (b - h_0 * UP).dot(b - h_0 * UP) - a_m.dot(a_m)) / 2,
)


def slope(of, by, letter):
    """A first derivative of E."""
    return d.define(
        f"g_{letter}",
        partial(of, by),
        because="The gradient of half a square is the length times that of the length.",
        meaning=f"derivative of E by {by.name}",
        latex=f"g_{by.facts.latex}",
    )


def bend(of, by, letters, latex):
    """A second derivative of E."""
    return d.define(
        f"H_{letters}",
        partial(of, by),
        because="The gradient changes with the angles; how fast, the rate of the Jacobian asks.",
        meaning="second derivative of E, by " + " and ".join(latex[1]),
        latex=f"H_{{{latex[0]}}}",
    )


g_alpha = slope(E, alpha, "alpha")
g_beta = slope(E, beta, "beta")
H_aa = bend(g_alpha, alpha, "aa", (r"\alpha\alpha", ("alpha", "alpha")))
H_ab = bend(g_alpha, beta, "ab", (r"\alpha\beta", ("alpha", "beta")))
H_bb = bend(g_beta, beta, "bb", (r"\beta\beta", ("beta", "beta")))
d.identity("either order serves", H_ab, partial(g_beta, alpha))

# ---- rates of the legs ----

J_alpha = d.define(
    "J_alpha",
    g_alpha / length,
    because="E is half the square of q but for what stands still, so that dE = q dq.",
    meaning="derivative of length i by alpha",
    latex=r"J_\alpha",
)
J_beta = d.define(
    "J_beta",
    g_beta / length,
    because="E is half the square of q but for what stands still, so that dE = q dq.",
    meaning="derivative of length i by beta",
    latex=r"J_\beta",
)
J = d.define(
    "J",
    Matrix(((J_alpha, J_beta),)),
    because="The length of a leg depends on the two angles alone: a row has two entries.",
    meaning="Jacobian from the rates of alpha and beta to those of the lengths, row i",
    printed="9",
    unit=METRE,
    latex="J",
)
q_dot = d.define(
    "q_dot",
    J_alpha * alpha_dot + J_beta * beta_dot,
    because="The chain rule: each angle changes the length at its own rate.",
    meaning="rate of length i",
    printed="8",
    latex=r"\dot{q}",
)
E_a_dot = d.define(
    "E_a_dot",
    H_aa * alpha_dot + H_ab * beta_dot,
    because="The chain rule for the first slope: each angle changes it at its own rate.",
    meaning="rate of the derivative of E by alpha",
    latex=r"\dot{g}_\alpha",
)
E_b_dot = d.define(
    "E_b_dot",
    H_ab * alpha_dot + H_bb * beta_dot,
    because="The chain rule for the second slope.",
    meaning="rate of the derivative of E by beta",
    latex=r"\dot{g}_\beta",
)
J_dot = d.define(
    "J_dot",
    Matrix((((E_a_dot - q_dot * J_alpha) / length, (E_b_dot - q_dot * J_beta) / length),)),
    because="Differentiate q J = g, and solve for the rate of J.",
    meaning="rate of row i of the Jacobian",
    unit=METRE / SECOND,
    latex=r"\dot{J}",
)
for _k, _entry in enumerate((J_alpha, J_beta)):
    d.identity(
        f"column {_k + 1} of the Jacobian's rate is its derivative",
        J_dot.rows[0][_k],
        time_derivative(_entry, {length: q_dot}),
    )
_J_dot = J_dot.rows[0]
q_ddot = d.define(
    "q_ddot",
    (J_alpha * alpha_ddot + J_beta * beta_ddot) + (_J_dot[0] * alpha_dot + _J_dot[1] * beta_dot),
    because="The rate of J times the rates of the angles: both factors change.",
    meaning="acceleration of length i",
    latex=r"\ddot{q}",
)
