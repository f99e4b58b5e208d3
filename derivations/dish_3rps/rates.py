"""How the facet and its rods move while the dish turns: by differentiation, and as Jacobians."""

from armillary import (
    Twist,
    Wrench,
    at,
    partial,
    stack_wrenches,
    tilting,
    time_derivative,
    vector,
)
from armillary.algebra.rigid import Matrix, stack_twists

from .dish import Omega_O
from .facet import (
    M_P,
    arm_D,
    from_base,
    half_turn,
    lean,
    n_P,
    platform,
    seen,
    t,
    tilt,
    u,
    z_M,
)
from .rods import h, length, reach, w
from .symbols import alpha, beta, d, leg, r_m, z_dot

# ---- the facet ----
# Each rate is named as soon as it is known, and later ones are taken from it.

Omega_D = d.define(
    "Omega_D",
    half_turn(seen.angular_velocity("dish")),
    because="Seen from the base the dish turns as ever; the facet's azimuth stands still.",
    meaning="angular velocity of the dish, {P}",
    latex=r"\boldsymbol{\Omega}_D",
)
d.identity("it is that of the dish in {H}", from_base(Omega_D), Omega_O)
n_dot = d.define(
    "n_dot",
    Omega_D.cross(n_P),
    because="The normal turns with the dish.",
    meaning="rate of the normal, {P}",
    latex=r"\dot{\mathbf{n}}",
)
z_M_dot = d.define(
    "z_M_dot",
    z_dot + Omega_D.cross(arm_D).z,
    because="The dish's point turns about the vertex, which may rise.",
    meaning="rate of the height of the facet's point",
    latex=r"\dot{z}_M",
)
d.identity("the normal turns as its closed form says", n_dot, time_derivative(n_P))
d.identity("the facet's point rises as its closed form says", z_M_dot, time_derivative(z_M))
w_dot = d.define(
    "w_dot",
    n_dot.x * u.x + n_dot.y * u.y,
    because="The joints of the base stand still.",
    meaning="rate of w",
    latex=r"\dot{w}",
)
KNOWN = {n_P: n_dot, z_M: z_M_dot, lean: n_dot.z, w: w_dot}
v_P = d.define(
    "v_P",
    time_derivative(M_P, KNOWN),
    because="Differentiate the facet's point; sideways that is the parasitic motion's rate.",
    meaning="velocity of the facet's point, {P}",
    latex=r"\mathbf{v}_P",
)
Omega_P = d.define(
    "Omega_P",
    tilting(n_P, n_dot, lean),
    because="A tilt that stays without torsion turns about (z + n) x dn/dt. The dish turns "
    "otherwise: the two share the rate of the normal and no more.",
    meaning="angular velocity of the facet, {P}",
    latex=r"\boldsymbol{\Omega}_P",
)
v_M = d.define(
    "v_M",
    from_base(v_P),
    because="The same in East-North-Up.",
    meaning="velocity of the facet's point, {H}",
    latex=r"\mathbf{v}_M",
)
Omega_M = d.define(
    "Omega_M",
    from_base(Omega_P),
    because="The same in East-North-Up.",
    meaning="angular velocity of the facet, {H}",
    latex=r"\boldsymbol{\Omega}_M",
)
V_S = d.define(
    "V_S",
    from_base(platform.leg.joint_velocity(Twist(Omega_P, v_P))),
    because="The facet is rigid: its S-joint has the velocity of its point, and that of turning "
    "about it.",
    meaning="velocity of S-joint i, {H}",
    printed="20",
    latex=r"\mathbf{v}_S",
)
# ---- the rods ----

reach_dot = d.define(
    "reach_dot",
    time_derivative(reach, KNOWN),
    because="Differentiate the outward part of the rod.",
    meaning="rate of the component of rod i along the azimuth of its joint",
    latex=r"\dot{a}",
)
h_dot = d.define(
    "h_dot",
    time_derivative(h, KNOWN),
    because="And its height.",
    meaning="rate of the height of S-joint i",
    latex=r"\dot{h}",
)
l_dot = d.define(
    "l_dot",
    (reach * reach_dot + h * h_dot) / length,
    because="Differentiate the right triangle.",
    meaning="rate of the length of rod i",
    printed="27",
    latex=r"\dot{l}",
)
e = d.define(
    "e",
    from_base(vector((reach / length) * u.x, (reach / length) * u.y, h / length)),
    because="The rod keeps to the plane of its hinge.",
    meaning="unit vector along rod i, {H}",
    latex=r"\mathbf{e}",
)
r_S = d.define(
    "r_S",
    from_base(r_m * (tilt @ u)),
    because="The S-joints are fixed in the facet.",
    meaning="from the facet's point to S-joint i, {H}",
    latex=r"\mathbf{r}_S",
)


def row(direction):
    """What a way of the S-joint is in the facet's twist, {H}."""
    return stack_wrenches(Wrench(r_S.cross(direction), direction))


J_A = d.define(
    "J_A",
    row(e),
    because="Only the velocity along the rod changes its length.",
    meaning="row i of the Jacobian from the facet's twist about its point to the rods' rates, {H}: "
    "three columns in 1 for the velocity, then three in m for the angular velocity",
    printed="22",
    latex="J_A",
)


_turning = Matrix(seen.jacobian("dish", (alpha, beta)).rows[3:])


def column(k, q, letter):
    """The facet's twist per unit rate of one coordinate, {H}; its parts are named."""
    turning = d.define(
        f"Omega_D_{letter}",
        half_turn(_turning.column_vector(k)),
        because="The axis of that turn.",
        meaning=f"angular velocity of the dish per unit of {q.name}, {{P}}",
        latex=rf"\boldsymbol{{\Omega}}_{{D{q.facts.latex}}}",
    )
    n_slope = d.define(
        f"n_{letter}",
        turning.cross(n_P),
        because="The normal turns with the dish.",
        meaning=f"change of the normal per unit of {q.name}, {{P}}",
        latex=rf"\mathbf{{n}}_{{,{q.facts.latex}}}",
    )
    z_slope = d.define(
        f"z_{letter}",
        turning.cross(arm_D).z,
        because="The facet's point rises with the dish's.",
        meaning=f"change of the height of the facet's point per unit of {q.name}",
        latex=rf"z_{{,{q.facts.latex}}}",
    )
    d.identity(f"the normal turns with {q.name} as its closed form says", n_slope, partial(n_P, q))
    d.identity(f"and the height changes so with {q.name}", z_slope, partial(z_M, q))
    known = {n_P: n_slope, z_M: z_slope, lean: n_slope.z}
    velocity = d.define(
        f"v_{letter}",
        partial(M_P, q, known),
        because="The parasitic motion goes with the normal.",
        meaning=f"velocity of the facet's point per unit of {q.name}, {{P}}",
        latex=rf"\mathbf{{v}}_{{{q.facts.latex}}}",
    )
    spin = d.define(
        f"Omega_{letter}",
        tilting(n_P, n_slope, lean),
        because="A tilt that stays without torsion.",
        meaning=f"angular velocity of the facet per unit of {q.name}, {{P}}",
        latex=rf"\boldsymbol{{\Omega}}_{{{q.facts.latex}}}",
    )
    return Twist(from_base(spin), from_base(velocity))


_twists = (
    column(0, alpha, "alpha"), column(1, beta, "beta"), Twist(vector(0, 0, 0), vector(0, 0, 1))
)  # fmt: skip
J_B = d.define(
    "J_B",
    stack_twists(_twists),
    because="Column by column, the motion of the facet while one coordinate runs. The height "
    "depends on beta, and the parasitic motion on both angles; the height of the vertex lifts all.",
    meaning="Jacobian from the rates of alpha, beta and z_O to the facet's twist about its point, "
    "{H}: velocity over angular velocity",
    printed="26",
    latex="J_B",
)
J_v = d.define(
    "J_v",
    Matrix(J_B.rows[:3]),
    because="The upper half of J_B.",
    meaning="Jacobian from the rates of alpha, beta and z_O to the velocity of the facet's point, "
    "{H}",
    printed="23",
    latex="J_v",
)
# ---- the hinges and the planes ----

e_across = d.define(
    "e_across",
    from_base(vector((h / length) * u.x, (h / length) * u.y, -(reach / length))),
    because="Square to the rod, in the plane of its hinge.",
    meaning="unit vector across rod i, the way that its hinge turns it, {H}",
    latex=r"\mathbf{e}^{\perp}",
)
J_P = d.define(
    "J_P",
    Matrix((tuple(entry / length for entry in row(e_across).rows[0]),)),
    because="What moves the S-joint across the rod, in the plane of the hinge, turns the hinge; "
    "the longer the rod, the less.",
    meaning="row i of the Jacobian from the facet's twist about its point to the rates of the "
    "hinges, {H}",
    latex="J_P",
)
t_H = d.define(
    "t_H",
    from_base(t),
    because="The hinge is fixed to the ground.",
    meaning="axis of the hinge of rod i, {H}",
    latex=r"\mathbf{t}^{H}",
)
J_plane = d.define(
    "J_plane",
    row(t_H),
    because="What moves the S-joint along the axis of its hinge is barred.",
    meaning="row i of what the facet's twist about its point must make zero, {H}",
    latex="J_t",
)
J = d.define(
    "J",
    Matrix(
        tuple(
            tuple(at(entry, leg, k) for entry in rows_.rows[0])
            for rows_ in (J_A, J_plane)
            for k in range(leg.size)
        )
    ),
    because="Three rates of rods and three bars take the six freedoms of the facet. Where it is "
    "singular, locked rods do not hold the facet.",
    meaning="Jacobian from the facet's twist about its point to the three rates of the rods, over "
    "the three that the hinges make zero, {H}",
    latex="J",
)
