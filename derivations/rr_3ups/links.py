"""The legs in the world: their frames, how they turn, and how their links move."""

from armillary import (
    Matrix,
    X,
    Y,
    Z,
    atan2,
    elementary,
    hypot,
    partial,
    time_derivative,
    vector,
    where,
)

from .dynamics import omega_free
from .legs import J_alpha, J_beta, a, l_W, length, q, q_dot
from .legs_in_motion import (
    P_ddot,
    along_axis,
    axes,
    omega,
    spin,
    spin_rate,
    u,
    v,
    x_leg,
    y_leg,
    z_leg,
)
from .symbols import alpha, alpha_dot, beta, beta_dot, d, leg_tolerance, s, t, zeta

w = d.define(
    "w",
    elementary(Z, alpha) @ y_leg,
    because="Turned axes become the world's by the turn about the vertical.",
    meaning="unit vector along leg i, from the ground up, world axes",
    printed="5",
    latex=r"\mathbf{w}",
)

# ---- the angles of a universal joint ----

mounted = d.define(
    "mounted",
    elementary(Y, -zeta) @ l_W,
    because="Seen from the joint as it is mounted: the first axis is z, the second x while both "
    "angles are 0.",
    meaning="leg i, axes of its universal joint's base",
    latex=r"\mathbf{l}_\zeta",
)
gamma = d.define(
    "gamma",
    atan2(-mounted.x, where(along_axis, leg_tolerance, mounted.y)),
    because="The first turn takes y to the azimuth of the leg.",
    meaning="angle of leg i about the first axis of its universal joint, in [-pi, pi]",
    latex=r"\gamma",
)
psi = d.define(
    "psi",
    atan2(mounted.z, where(along_axis, leg_tolerance, hypot(mounted.x, mounted.y))),
    because="The second turn lifts the leg out of the plane that is square to the first axis.",
    meaning="angle of leg i about the second axis of its universal joint, in [-pi/2, pi/2]",
    latex=r"\psi",
)
leg_frame = d.define(
    "leg_frame",
    elementary(Y, zeta) @ elementary(Z, gamma) @ elementary(X, psi),
    because="The mounting comes first, then the turn about each axis of the joint in the order "
    "from the ground.",
    meaning="rotation of leg i: its axes in the world's; y is along the leg",
    printed="2",
    latex="R",
)


def to_world(vector_):
    """A vector in leg axes, in the world's."""
    return elementary(Z, alpha) @ (axes @ vector_)


for _k, _axis in ((X, x_leg), (Y, y_leg), (Z, z_leg)):
    d.identity(
        f"the leg's axes are those of its joint's two turns: {'xyz'[_k]}",
        elementary(Z, alpha) @ _axis,
        leg_frame.column(_k),
    )

# ---- the spherical joint ----

a_dot = d.define(
    "a_dot",
    time_derivative(a),
    because="o stands still, so this is the velocity of the joint.",
    meaning="velocity of spherical joint i, world axes",
    latex=r"\dot{\mathbf{a}}",
)
_columns = tuple(partial(a, angle) for angle in (alpha, beta))


def beside(columns):
    """Two vectors as a matrix."""
    first, second = columns
    return Matrix(
        ((first.x, second.x), (first.y, second.y), (first.z, second.z))
    )  # fmt: skip


J_a = d.define(
    "J_a",
    beside(_columns),
    because="A column is the velocity while one angle turns at 1 rad/s and the other is held.",
    meaning="Jacobian from the rates of alpha and beta to the velocity of spherical joint i, world",
    printed="6",
    latex="J_a",
)
d.identity("seen along the leg's axes it is the same", to_world(v), a_dot)

# ---- turning ----

w_dot = d.define(
    "w_dot",
    (a_dot - q_dot * w) / length,
    because="What does not lengthen the leg turns it. This needs no axes of the leg but its own "
    "line, and holds where its universal joint has none.",
    meaning="rate of the direction of leg i, world axes",
    latex=r"\dot{\mathbf{w}}",
)
d.identity("seen along the leg's axes it is the same turning", to_world(u), w_dot)
a_ddot = d.define(
    "a_ddot",
    elementary(Z, alpha) @ P_ddot,
    because="Turned axes become the world's by the turn about the vertical.",
    meaning="acceleration of spherical joint i, world axes",
    latex=r"\ddot{\mathbf{a}}",
)
d.identity("it is what differentiation gives", a_ddot, time_derivative(time_derivative(a)))
w_ddot = d.define(
    "w_ddot",
    (a_ddot - w.dot(a_ddot) * w - (2 * q_dot) * w_dot) / length - w_dot.dot(w_dot) * w,
    because="Differentiate q w twice and solve for what turns; along the leg a direction of "
    "length 1 falls back by the square of its rate.",
    meaning="acceleration of the direction of leg i, world axes",
    latex=r"\ddot{\mathbf{w}}_W",
)
omega_free_W = d.define(
    "omega_free_W",
    w.cross(a_dot) / length,
    because="Square to the leg: this turns the direction and spins nothing.",
    meaning="angular velocity of leg i if it does not spin, world axes",
    printed="10",
    latex=r"\boldsymbol{\omega}_\mathrm{free}",
)
J_omega_free = d.define(
    "J_omega_free",
    beside(tuple(w.cross(column) / length for column in _columns)),
    because="Angular velocity is linear in the rates: a column is that at one rate of 1, the other "
    "0.",
    meaning="Jacobian from the rates of alpha and beta to that angular velocity, world axes",
    latex=r"J_{\omega}",
)
omega_W = d.define(
    "omega_W",
    omega_free_W + spin * w,
    because="The leg turns with its direction, and spins about itself.",
    meaning="angular velocity of leg i, world axes",
    latex=r"\boldsymbol{\omega}_W",
)
d.identity("seen along the leg's axes it is the same angular velocity", to_world(omega), omega_W)
d.identity("without spin it is the paper's", to_world(omega_free), omega_free_W)
omega_free_dot_W = d.define(
    "omega_free_dot_W",
    w.cross(w_ddot),
    because="Differentiate w cross its rate: a rate is along itself.",
    meaning="angular acceleration of leg i if it does not spin, world axes",
    latex=r"\dot{\boldsymbol{\omega}}_\mathrm{free}",
)
omega_dot_W = d.define(
    "omega_dot_W",
    omega_free_dot_W + spin_rate * w + spin * w_dot,
    because="Differentiate; the axis of the spin turns too.",
    meaning="angular acceleration of leg i, world axes",
    latex=r"\dot{\boldsymbol{\omega}}_W",
)
# ---- centres of mass ----

T_W = d.define(
    "T_W",
    t * w,
    because="The first link does not slide: its centre of mass keeps its distance from the ground "
    "joint.",
    meaning="from universal joint i to the first link's centre of mass, world axes",
    printed="11",
    latex=r"\mathbf{t}",
)
S_W = d.define(
    "S_W",
    (q - s) * w,
    because="At a distance from the other end that stays.",
    meaning="from universal joint i to the second link's centre of mass, world axes",
    printed="13",
    latex=r"\mathbf{s}",
)
d.identity("it is s short of the spherical joint", S_W, l_W - s * w)
v_t = d.define(
    "v_t",
    t * w_dot,
    because="The distance t stays, so that only the direction changes.",
    meaning="velocity of the first link's centre of mass, world axes",
    printed="12",
    latex=r"\mathbf{v}_t",
)
v_s = d.define(
    "v_s",
    q_dot * w + (length - s) * w_dot,
    because="Differentiate (q - s) w: the link slides along the leg, and turns with it.",
    meaning="velocity of the second link's centre of mass, world axes",
    printed="14",
    latex=r"\mathbf{v}_s",
)
d.identity(
    "the second link's centre moves with the spherical joint", v_s, to_world(v) - s * to_world(u)
)
a_t = d.define(
    "a_t",
    t * w_ddot,
    because="The distance t stays, so that only the direction accelerates.",
    meaning="acceleration of the first link's centre of mass, world axes",
    latex=r"\mathbf{a}_t",
)
a_s = d.define(
    "a_s",
    a_ddot - s * w_ddot,
    because="Its distance from the spherical joint stays, along a direction that accelerates.",
    meaning="acceleration of the second link's centre of mass, world axes",
    latex=r"\mathbf{a}_s",
)


def turned_about(column):
    """How the direction turns per unit of an angle."""
    return (w.cross(column) / length).cross(w)


J_tv = d.define(
    "J_tv",
    beside(tuple(t * turned_about(column) for column in _columns)),
    because="The velocity t w_dot is linear in the rates: a column is that at one rate of 1, the "
    "other 0.",
    meaning="Jacobian from the rates of alpha and beta to the velocity of the first link's centre "
    "of mass, world axes",
    latex="J_{tv}",
)
J_sv = d.define(
    "J_sv",
    beside(
        tuple(
            entry * w + (length - s) * turned_about(column)
            for entry, column in zip((J_alpha, J_beta), _columns, strict=True)
        )
    ),
    because="The velocity of sliding and turning is linear in the rates: a column for each.",
    meaning="Jacobian from the rates of alpha and beta to the velocity of the second link's centre "
    "of mass, world axes",
    latex="J_{sv}",
)


def at_rates(jacobian):
    """Both columns at their rates."""
    return vector(*(row[0] * alpha_dot + row[1] * beta_dot for row in jacobian.rows))


d.identity("both columns at their rates make the second link's velocity", at_rates(J_sv), v_s)
d.identity("and so for the first link's", at_rates(J_tv), t * to_world(u))
