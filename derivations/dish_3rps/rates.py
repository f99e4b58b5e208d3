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

from .facet import M_P, any_platform, from_base, lean, n_any, n_P, platform, t, tilt, u
from .rods import h, length, reach
from .symbols import alpha, beta, d, leg, r_m, z_O

# ---- the facet ----

v_P = time_derivative(M_P)
Omega_P = tilting(n_P, time_derivative(n_P), lean)
motion = Twist(Omega_P, v_P)  # in {P}

v_M = d.define(
    "v_M",
    from_base(v_P),
    because="Differentiate the facet's point; its sideways part is the parasitic motion's.",
    meaning="velocity of the facet's point, {H}",
    latex=r"\mathbf{v}_M",
)
Omega_M = d.define(
    "Omega_M",
    from_base(Omega_P),
    because="A tilt that stays without torsion turns about (z + n) x dn/dt. The dish turns "
    "otherwise: the two share the rate of the normal and no more.",
    meaning="angular velocity of the facet, {H}",
    latex=r"\boldsymbol{\Omega}_M",
)
V_S = d.define(
    "V_S",
    from_base(platform.leg.joint_velocity(motion)),
    because="The facet is rigid: its S-joint has the velocity of its point, and that of turning "
    "about it.",
    meaning="velocity of S-joint i, {H}",
    printed="20",
    latex=r"\mathbf{v}_S",
)
_position = any_platform.pose.position
_moving = Twist(tilting(n_any, time_derivative(n_any)), time_derivative(_position))
d.identity(
    "so the S-joint moves as its position says, whatever the normal",
    any_platform.leg.joint_velocity(_moving),
    time_derivative(any_platform.leg.joint),
)

# ---- the rods ----

l_dot = d.define(
    "l_dot",
    (reach * time_derivative(reach) + h * time_derivative(h)) / length,
    because="Differentiate the right triangle.",
    meaning="rate of the length of rod i",
    printed="27",
    latex=r"\dot{l}",
)
e_P = vector((reach / length) * u.x, (reach / length) * u.y, h / length)
e = d.define(
    "e",
    from_base(e_P),
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
    "velocity first, then angular velocity, m",
    printed="22",
    latex="J_A",
)


def column(q):
    """The facet's twist per unit rate of one coordinate, {H}."""
    spin = tilting(n_P, partial(n_P, q), lean)
    return Twist(from_base(spin), from_base(partial(M_P, q)))


_twists = tuple(column(q) for q in (alpha, beta, z_O))
J_B = d.define(
    "J_B",
    stack_twists(_twists),
    because="Column by column, the motion of the facet while one coordinate runs. The height "
    "depends on beta, and the parasitic motion on both angles.",
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

f_P = vector((h / length) * u.x, (h / length) * u.y, -reach / length)
J_P = d.define(
    "J_P",
    Matrix((tuple(entry / length for entry in row(from_base(f_P)).rows[0]),)),
    because="What moves the S-joint across the rod, in the plane of the hinge, turns the hinge; "
    "the longer the rod, the less.",
    meaning="row i of the Jacobian from the facet's twist about its point to the rates of the "
    "hinges, {H}",
    latex="J_P",
)
J_plane = d.define(
    "J_plane",
    row(from_base(t)),
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
