"""How each leg turns and accelerates, in its own axes.

x is along the second axis of the leg's universal joint, y along the leg.
"""

from armillary import (
    Axes,
    UniversalLeg,
    Y,
    Z,
    any_of,
    at,
    elementary,
    leg_axes,
    second_axis,
    vector,
    where,
)

from .legs import EAST, UP, J_alpha, J_beta, a_c, l_c, length, q_dot
from .symbols import (
    alpha,
    alpha_ddot,
    alpha_dot,
    axis_tolerance,
    beta_ddot,
    beta_dot,
    d,
    g,
    leg,
    zeta,
)

# ---- axes of a leg ----

y_leg = d.define(
    "y_leg",
    l_c / length,
    because="A leg's y axis is its direction: the leg divided by its length.",
    meaning="y axis of leg i, turned axes",
    latex=r"\mathbf{y}",
)
first = d.define(
    "first",
    elementary(Z, -alpha) @ (elementary(Y, zeta) @ UP),
    because="The first axis of a universal joint is fixed to the ground; mounted level or upright, "
    "it is turned back like the ground.",
    meaning="first axis of universal joint i, turned axes",
    latex=r"\mathbf{e}_1",
)
second = d.define(
    "second",
    second_axis(y_leg, first),
    because="The second axis is square to the first and to the leg.",
    meaning="along the second axis of universal joint i, as long as the cosine of psi, turned axes",
    latex=r"\mathbf{e}_2",
)
cos_psi = d.define(
    "cos_psi",
    second.norm(),
    because="The first axis and the leg have length 1, and stand apart by a quarter turn less psi.",
    meaning="cosine of the angle of leg i about its second axis",
    latex=r"\mathrm{c}\psi",
)
sin_psi = d.define(
    "sin_psi",
    y_leg.dot(first),
    because="How far the leg leans along the first axis.",
    meaning="sine of the angle of leg i about its second axis",
    latex=r"\mathrm{s}\psi",
)
along_axis = d.define(
    "along_axis",
    any_of(~(cos_psi > axis_tolerance), over=leg),
    because="A leg along the first axis of its joint cannot turn every way: rates that are asked "
    "for may be no motion of the machine. That is more than a free angle, so the status is "
    "UNREACHABLE, not SINGULAR.",
    meaning="whether a leg stands along the first axis of its universal joint",
)
along_axis_2 = d.define(
    "along_axis_2",
    ~((at(cos_psi, leg, 0) > axis_tolerance) & (at(cos_psi, leg, 1) > axis_tolerance)),
    because="Where leg 3 is absent, it does not count.",
    meaning="whether leg 1 or 2 stands along the first axis of its universal joint",
)
cosine = d.define(
    "cosine",
    where(cos_psi > axis_tolerance, cos_psi, axis_tolerance),
    because="What is divided by must not be 0; where the tolerance stands in, the status tells it.",
    meaning="cosine of psi of leg i, at least the tolerance",
    latex=r"\mathrm{c}\psi^+",
)
tangent = d.define(
    "tangent",
    sin_psi / cosine,
    because="It ties the spin of a leg to its turning.",
    meaning="tangent of psi of leg i",
    latex=r"\mathrm{t}\psi",
)
x_leg = d.define(
    "x_leg",
    second / cosine,
    because="The leg turns about the second axis, which so stands still in the leg.",
    meaning="x axis of leg i, turned axes",
    latex=r"\mathbf{x}",
)
z_leg = d.define(
    "z_leg",
    leg_axes(y_leg, x_leg).z,
    because="The third axis of a right-handed frame is the cross product of the two before.",
    meaning="z axis of leg i, turned axes",
    latex=r"\mathbf{z}",
)
axes = Axes(x_leg, y_leg, z_leg)

# ---- the spherical joint, seen from the leg ----


def seen(vector_, along, name, because, meaning, latex):
    """A vector of turned axes in the leg's, of which the part along the leg is known."""
    return d.define(
        name,
        vector(x_leg.dot(vector_), along, z_leg.dot(vector_)),
        because=because,
        meaning=meaning,
        latex=latex,
    )


P_alpha = seen(
    UP.cross(a_c),
    J_alpha,
    "P_alpha",
    "The platform turns about the vertical; along the leg that is what lengthens it.",
    "velocity of spherical joint i per unit of alpha_dot, leg axes",
    r"\mathbf{P}_\alpha",
)
P_beta = seen(
    EAST.cross(a_c),
    J_beta,
    "P_beta",
    "And about the level axis.",
    "velocity of spherical joint i per unit of beta_dot, leg axes",
    r"\mathbf{P}_\beta",
)
d.identity("along the leg it is the Jacobian's entry", y_leg.dot(UP.cross(a_c)), J_alpha)
d.identity("and so for the other angle", y_leg.dot(EAST.cross(a_c)), J_beta)
v = d.define(
    "v",
    vector(
        P_alpha.x * alpha_dot + P_beta.x * beta_dot,
        q_dot,
        P_alpha.z * alpha_dot + P_beta.z * beta_dot,
    ),
    because="Velocities add: what each angle does, times its rate. Along the leg that is the rate "
    "of its length.",
    meaning="velocity of spherical joint i, leg axes",
    latex=r"\mathbf{v}",
)
P_ddot = d.define(
    "P_ddot",
    (alpha_ddot * UP.cross(a_c) + beta_ddot * EAST.cross(a_c))
    + (
        (alpha_dot * alpha_dot) * UP.cross(UP.cross(a_c))
        + (2 * (alpha_dot * beta_dot)) * UP.cross(EAST.cross(a_c))
        + (beta_dot * beta_dot) * EAST.cross(EAST.cross(a_c))
    ),
    because="The two accelerations, and what turning bends: by alpha twice, by both, by beta "
    "twice.",
    meaning="acceleration of spherical joint i, turned axes",
    latex=r"\ddot{\mathbf{P}}",
)
fall = d.define(
    "fall",
    vector(x_leg.z * g, y_leg.z * g, z_leg.z * g),
    because="What carries weight accelerates upwards against free fall.",
    meaning="acceleration of free fall, upwards, axes of leg i",
    latex=r"\mathbf{g}",
)
acceleration = d.define(
    "acceleration",
    vector(x_leg.dot(P_ddot), y_leg.dot(P_ddot), z_leg.dot(P_ddot)),
    because="A leg's inertia is simple in its own axes, so what moves it is told in them.",
    meaning="acceleration of spherical joint i, leg axes",
    latex=r"\mathbf{a}_P",
)

# ---- turning ----


def turning_of(legs, mark, which):
    """How a leg turns; its steps are named."""
    spin = d.define(
        f"spin{mark}",
        legs.spin(u),
        because="Neither axis of the joint turns the leg about x cross y without spinning it.",
        meaning=f"angular velocity of leg i about itself{which}",
        latex=r"\sigma",
    )
    spin_rate = d.define(
        f"spin_rate{mark}",
        legs.spin_rate(u, u_dot),
        because="Differentiate the spin; the tangent changes as the leg turns about x.",
        meaning=f"angular acceleration of leg i about itself{which}",
        latex=r"\dot{\sigma}",
    )
    omega = d.define(
        f"omega{mark}",
        legs.angular_velocity(u, spin),
        because="The leg turns with its direction, and spins.",
        meaning=f"angular velocity of leg i{which}, leg axes",
        latex=r"\boldsymbol{\omega}",
    )
    omega_dot = d.define(
        f"omega_dot{mark}",
        legs.angular_acceleration(u, u_dot, spin, spin_rate),
        because="Differentiate in the world; the axis of the spin turns too.",
        meaning=f"angular acceleration of leg i{which}, leg axes",
        latex=r"\dot{\boldsymbol{\omega}}",
    )
    return spin, spin_rate, omega, omega_dot


joint = UniversalLeg(length, tangent)
free_joint = UniversalLeg(length)
u = d.define(
    "u",
    joint.turning(v),
    because="What the end's velocity does not lengthen, it turns.",
    meaning="rate of the direction of leg i, leg axes",
    latex=r"\mathbf{u}",
)
u_dot = d.define(
    "u_dot",
    joint.turning_rate(v, acceleration, u),
    because="Differentiate q w twice and solve for what turns.",
    meaning="acceleration of the direction of leg i, leg axes",
    latex=r"\ddot{\mathbf{w}}",
)
spin, spin_rate, omega, omega_dot = turning_of(joint, "", "")
