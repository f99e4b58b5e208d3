"""What it takes to move the platform and its legs: by virtual work, for all three legs or two."""

from armillary import Body, Matrix, Wrench, X, Z, at, elementary, number, total, vector
from armillary.derivation.units import NEWTON_METRE

from .legs import length
from .legs_in_motion import (
    P_alpha,
    P_beta,
    acceleration,
    fall,
    free_joint,
    joint,
    omega,
    omega_dot,
    turning_of,
    u_dot,
)
from .symbols import (
    I_m,
    I_s,
    I_t,
    alpha,
    alpha_ddot,
    alpha_dot,
    beta,
    beta_ddot,
    beta_dot,
    d,
    g,
    leg,
    m_m,
    m_s,
    m_t,
    n_d,
    r_sc,
    s,
    t,
)

# ---- the links of a leg ----

a_T = d.define(
    "a_T",
    t * u_dot,
    because="The first link's centre of mass keeps its distance from the universal joint.",
    meaning="acceleration of the first link's centre of mass, leg axes",
    latex=r"\mathbf{a}_T",
)
a_S = d.define(
    "a_S",
    acceleration - s * u_dot,
    because="The second link's keeps its distance from the spherical joint.",
    meaning="acceleration of the second link's centre of mass, leg axes",
    latex=r"\mathbf{a}_S",
)
f_T = d.define(
    "f_T",
    Body(m_t, I_t).force(a_T + fall),
    because="Newton's law; a link at rest asks for its weight, as if it accelerated upwards by g.",
    meaning="force that the first link asks for at its centre of mass, leg axes",
    latex=r"\mathbf{f}_T",
)
f_S = d.define(
    "f_S",
    Body(m_s, I_s).force(a_S + fall),
    because="Newton's law; a link at rest asks for its weight, as if it accelerated upwards by g.",
    meaning="force that the second link asks for at its centre of mass, leg axes",
    latex=r"\mathbf{f}_S",
)
I_leg = d.define(
    "I_leg",
    I_t + I_s,
    because="The links slide along each other and turn as one, so that what turns them adds.",
    meaning="moments of inertia of both links of leg i, each about its centre of mass, leg axes",
    latex=r"\mathbf{I}",
)


def demand_of(legs, omega, omega_dot, mark, which):
    """What a leg asks of the platform."""
    moment = d.define(
        f"moment{mark}",
        Body(number(0), I_leg).moment(omega, omega_dot),
        because="Euler's equations about each link's centre of mass, in the leg's axes, where the "
        "moments are principal.",
        meaning=f"moment that turns both links of leg i{which} about their centres of mass, "
        "leg axes",
        latex=r"\mathbf{n}",
    )
    about_joint = d.define(
        f"about_joint{mark}",
        vector(
            moment.x + t * f_T.z + (length - s) * f_S.z,
            moment.y,
            moment.z - t * f_T.x - (length - s) * f_S.x,
        ),
        because="The moment about the joint: each force at a centre of mass adds its arm along the "
        "leg times the force across it.",
        meaning=f"moment about universal joint i that moves its leg{which}, leg axes",
        latex=r"\mathbf{M}",
    )
    return d.define(
        f"f_P{mark}",
        legs.asked(Wrench(about_joint, f_S)),
        because="Virtual work: along each motion that the joint permits, the force at the "
        "spherical joint does what moves the leg. Along itself the second link slides.",
        meaning=f"force that leg i{which} asks for at its spherical joint, leg axes",
        latex=r"\mathbf{f}_P",
    )


f_P = demand_of(joint, omega, omega_dot, "", "")


def works(force, mark, which):
    """What that force does per unit of each angle."""
    return tuple(
        d.define(
            f"tau_{letter}_leg{mark}",
            along.dot(force),
            because="What that force does along the joint's motion.",
            meaning=f"moment about the axis of {letter} that leg i{which} asks for",
            latex=rf"\tau_{{\{letter},i}}",
        )
        for letter, along in (("alpha", P_alpha), ("beta", P_beta))
    )


tau_alpha_leg, tau_beta_leg = works(f_P, "", "")

# ---- the platform ----

tilt = elementary(X, -beta)
z_m = d.define(
    "z_m",
    tilt @ vector(0, 0, 1),
    because="The tilt, turned back: from the platform the vertical leans the other way.",
    meaning="vertical axis, platform axes",
    latex=r"\mathbf{z}",
)
Omega_m = d.define(
    "Omega_m",
    vector(beta_dot, number(0), number(0)) + alpha_dot * z_m,
    because="Angular velocities add: the tilt about the platform's own x axis, the turn about the "
    "vertical.",
    meaning="angular velocity of the platform, platform axes",
    latex=r"\boldsymbol{\Omega}",
)
Omega_m_dot = d.define(
    "Omega_m_dot",
    vector(beta_ddot, (alpha_dot * beta_dot) * z_m.z, -((alpha_dot * beta_dot) * z_m.y))
    + alpha_ddot * z_m,
    because="Differentiate; the vertical turns about the level axis as seen from the platform.",
    meaning="angular acceleration of the platform, platform axes",
    latex=r"\dot{\boldsymbol{\Omega}}",
)
moment_m = d.define(
    "moment_m",
    Body(m_m, I_m).moment(Omega_m, Omega_m_dot),
    because="Euler's equations about o, which stands still.",
    meaning="moment about o that turns the platform, platform axes",
    latex=r"\mathbf{n}_m",
)
n_turned = d.define(
    "n_turned",
    elementary(Z, -alpha) @ n_d,
    because="The level axis of the tilt is x in the axes turned with the platform.",
    meaning="disturbing moment, turned axes",
    latex=r"\mathbf{n}_{d,c}",
)
tau_alpha_m = d.define(
    "tau_alpha_m",
    z_m.dot(moment_m) - n_d.z,
    because="Euler's moment about the vertical, less what the disturbance gives; weight is "
    "parallel to that axis and does nothing.",
    meaning="moment about the vertical that the platform asks for",
    latex=r"\tau_{\alpha,m}",
)
tau_beta_m = d.define(
    "tau_beta_m",
    moment_m.x + m_m * g * (r_sc.y * z_m.z - r_sc.z * z_m.y) - n_turned.x,
    because="What turns it, what its weight does about the level axis, and the disturbance.",
    meaning="moment about the level axis that the platform asks for",
    latex=r"\tau_{\beta,m}",
)

# ---- all together ----


def sum_of(parts, of_platform, letter, mark, which, meaning):
    """Legs and platform."""
    return d.define(
        f"tau_{letter}{mark}",
        parts + of_platform,
        because=f"Work per unit of {letter}{which}.",
        meaning=meaning,
        latex=rf"\tau_\{letter}",
    )


def both(works_, mark, which):
    """The generalised force of platform and three legs."""
    return tuple(
        sum_of(
            total(work, over=leg), part, letter, mark, which,
            f"generalised force of {letter} that the drives must give{which}",
        )
        for letter, work, part in zip(
            ("alpha", "beta"), works_, (tau_alpha_m, tau_beta_m), strict=True
        )
    )  # fmt: skip


tau_alpha, tau_beta = both((tau_alpha_leg, tau_beta_leg), "", "")
tau = d.define(
    "tau",
    Matrix(((tau_alpha, tau_beta),)),
    because="The platform has two freedoms: a moment about each axis.",
    meaning="generalised force that the drives must give: moments about the axes of alpha and beta",
    printed="23",
    unit=NEWTON_METRE,
    latex=r"\boldsymbol{\tau}",
)
tau_alpha_2, tau_beta_2 = (
    sum_of(
        at(work, leg, 0) + at(work, leg, 1), part, letter, "_2", " on two legs",
        f"generalised force of {letter} that two drives must give",
    )
    for letter, work, part in (
        ("alpha", tau_alpha_leg, tau_alpha_m),
        ("beta", tau_beta_leg, tau_beta_m),
    )
)  # fmt: skip
tau_2 = d.define(
    "tau_2",
    Matrix(((tau_alpha_2, tau_beta_2),)),
    because="The platform has two freedoms: a moment about each axis.",
    meaning="generalised force that two drives must give where leg 3 is absent",
    unit=NEWTON_METRE,
    latex=r"\boldsymbol{\tau}_2",
)

# ---- the paper's legs, which do not spin ----

_FREE = " that does not spin"
_, _, omega_free, omega_dot_free = turning_of(free_joint, "_free", _FREE)
_f_free = demand_of(free_joint, omega_free, omega_dot_free, "_free", _FREE)
tau_alpha_free, tau_beta_free = both(works(_f_free, "_free", _FREE), "_free", " of spin-free legs")
tau_free = d.define(
    "tau_free",
    Matrix(((tau_alpha_free, tau_beta_free),)),
    because="The platform has two freedoms: a moment about each axis.",
    meaning="generalised force that the drives must give if legs do not spin",
    unit=NEWTON_METRE,
    latex=r"\boldsymbol{\tau}_\mathrm{free}",
)
