"""Yu, Wu and Zhang: what acts on the bodies, virtual work, and the forces, (19) to (24)."""

from armillary import (
    Z,
    at,
    determinant,
    elementary,
    matrix,
    partial,
    solved,
    time_derivative,
    total,
    vector,
)
from armillary.mechanism.body import Body

from ._yu_kinematics import (
    SPIN_FREE,
    J,
    R_m,
    alpha,
    alpha_dot,
    beta_dot,
    leg,
    leg_frame,
    omega,
    p,
    rr,
)
from ._yu_links import S_W, T_W, a_s, a_t, v_s, v_t

m_m, m_t, m_s = (rr.quantity(name) for name in ("m_m", "m_t", "m_s"))
I_m, I_t, I_s = (rr.quantity(name) for name in ("I_m", "I_t", "I_s"))
r_sc, f_d, n_d = (rr.quantity(name) for name in ("r_sc", "f_d", "n_d"))
UP = vector(0, 0, 1)
g = p.define(
    "g_W",
    -rr.quantity("g") * UP,
    because="The text after (19) has it along the negative Z axis.",
    meaning="acceleration of free fall, world axes",
    latex=r"\mathbf{g}",
)

p.assume(
    "m_s, I_s, v_s and Q_s stand for the platform in (19) and (22), and, with an i, for the second "
    "link of leg i. Table 1 calls the platform's m_m and I_m, as is done here."
)


def tensor(rotation, moments, spin):
    """The tensor rot I rot^T times a vector; I is diagonal."""
    inner = rotation.transpose() @ spin
    return rotation @ vector(*(moments[k] * inner[k] for k in range(3)))


# ---- The platform ----

Omega = p.define(
    "Omega_W",
    alpha_dot * UP + beta_dot * (elementary(Z, alpha) @ vector(1, 0, 0)),
    because="The platform turns about Z by alpha, and about the level axis that follows by beta.",
    meaning="angular velocity of the platform, world axes",
    latex=r"\boldsymbol{\omega}",
)
Omega_dot = p.define(
    "Omega_dot_W",
    time_derivative(Omega),
    because="In the axes of the world, which stand still, components are differentiated.",
    meaning="angular acceleration of the platform, world axes",
    latex=r"\dot{\boldsymbol{\omega}}",
)
r_c = p.define(
    "r_c",
    R_m @ r_sc,
    because="The text after (19) turns it with the platform.",
    meaning="centre of mass of the platform from o, world axes",
    latex=r"\mathbf{r}_{sc}",
)
a_c = p.define(
    "a_c",
    time_derivative(time_derivative(r_c)),
    because="o stands still, so that only what is from o to the mass centre moves.",
    meaning="acceleration of the platform's centre of mass, world axes",
    latex=r"\dot{\mathbf{v}}_{sc}",
)
AT_CENTRE = "true where v_s is the velocity of the centre of mass"
o_dot = p.define(
    "v_o_dot",
    vector(0, 0, 0),
    because="The text after (22) says that v_o is 0.",
    meaning="acceleration of o",
    latex=r"\dot{\mathbf{v}}_o",
)
p.equation(
    "19",
    words="force on the platform, with the velocity v_s of (22), that of o",
    claims=-m_m * a_c + m_m * g + f_d,
    printed=-m_m * o_dot + m_m * g + f_d,
    meant={AT_CENTRE: {o_dot: a_c}},
)
n_m = p.define(
    "n_m",
    R_m @ -rr["moment_m"] + r_c.cross(m_m * g) + n_d,
    because="It is what weight and disturbance do about o, less the rate of its angular momentum.",
    meaning="moment on the platform about o, less what turns it, world axes",
    latex=r"\mathbf{n}_m",
)
I_Omega = tensor(R_m, I_m, Omega)
n_19 = -tensor(R_m, I_m, Omega_dot) - Omega.cross(I_Omega) + r_c.cross(m_m * g) + n_d
p.equation("19'", words="moment on the platform about o", claims=n_m, printed=n_19)

# ---- The links ----

omega_dot = rr["omega_dot_W"]
LINKS = (("t", m_t, I_t, a_t, T_W, "first"), ("s", m_s, I_s, a_s, S_W, "second"))
f_of, n_of, n_20, places = {}, {}, {}, {}
for letter, mass, moments, acceleration, place, which in LINKS:
    f_of[letter] = p.define(
        f"f_{letter}",
        -mass * acceleration + mass * g,
        because="Of its weight, what accelerates it is not left for the leg to hold.",
        meaning=f"force on the {which} link at its centre of mass, less what accelerates it, "
        "world axes",
        latex=rf"\mathbf{{f}}_{letter}",
    )
    n_of[letter] = p.define(
        f"n_{letter}",
        leg_frame @ -Body(mass, moments).moment(rr["omega"], rr["omega_dot"]),
        because="About its centre of mass weight has no moment, so that inertia alone is left.",
        meaning=f"moment on the {which} link about its centre of mass, less what turns it, world "
        "axes",
        latex=rf"\mathbf{{n}}_{letter}",
    )
    places[letter] = p.define(
        f"r_{letter}ic",
        place,
        because="The paper's position vector starts at the origin of the leg's frame, Q_i.",
        meaning=f"centre of mass of the {which} link from Q_i, world axes",
        latex=rf"\mathbf{{r}}_{{{letter}c}}",
    )
    turned = tensor(leg_frame, moments, omega)
    n_20[letter] = p.define(
        f"n_{letter}20",
        -tensor(leg_frame, moments, omega_dot)
        - omega.cross(turned)
        + places[letter].cross(mass * g),
        because="(20) adds a moment of the weight about Q_i, and is taken as it stands.",
        meaning=f"moment on the {which} link by (20), world axes",
        latex=rf"\mathbf{{n}}_{{{letter}(20)}}",
    )
p.equation(
    "20",
    words="force on the first link at its centre of mass",
    claims=f_of["t"],
    printed=-m_t * a_t + m_t * g,
)
p.equation(
    "20'",
    words="moment on the first link about its centre of mass",
    claims=n_of["t"],
    printed=n_20["t"].expression,
)
p.equation(
    "20''",
    words="moment on the second link about its centre of mass, of the form of (20)",
    quote="the force and moment at the centre of mass of the second link have the same form",
    claims=n_of["s"],
    printed=n_20["s"].expression,
)
p.equation(
    "20'''",
    words="force on the second link at its centre of mass, of the form of (20)",
    claims=f_of["s"],
    printed=-m_s * a_s + m_s * g,
)
p.unchecked(
    "21", "forces of the drives", "It gives a name to the three forces, and states nothing of them."
)

# ---- Virtual work ----

VELOCITIES = {"v_t": v_t, "v_s": v_s, "omega": omega, "Omega": Omega}
PARTS = dict(zip(VELOCITIES, ("tv", "sv", r"\omega", "S"), strict=True))


def per_unit(rate):
    """The velocities per unit of the rate of one angle."""
    return {
        name: p.define(
            f"{name}_{rate.name[:-4]}",
            partial(velocity, rate),
            because="The velocities are linear in the rates; these are the columns of (23).",
            meaning=f"derivative of {name} by {rate.name}",
            latex=rf"\mathbf{{J}}^{{\{rate.name[:-4]}}}_{{{PARTS[name]}}}",
        )
        for name, velocity in VELOCITIES.items()
    }


def work(moments, motion):
    """What acts on platform and links along a motion."""
    first = f_of["t"].dot(motion["v_t"]) + moments["t"].dot(motion["omega"])
    second = f_of["s"].dot(motion["v_s"]) + moments["s"].dot(motion["omega"])
    return n_m.dot(motion["Omega"]) + total(first, over=leg) + total(second, over=leg)


tau_alpha, tau_beta = rr["tau_alpha"], rr["tau_beta"]
columns = [per_unit(rate) for rate in (alpha_dot, beta_dot)]
p.equation(
    "22",
    words="power of the drives, with the moments on the links as derived",
    claims=tau_alpha * alpha_dot + tau_beta * beta_dot,
    printed=-work(n_of, VELOCITIES),
)
p.equation(
    "23",
    words="generalised force of the drives, with the moments on the links as derived",
    claims=rr["tau"],
    printed=matrix([-work(n_of, column) for column in columns]),
)
p.equation(
    "23 with (20)",
    words="generalised force of the drives, with the moments on the links by (20)",
    claims=rr["tau"],
    printed=matrix([-work(n_20, column) for column in columns]),
    meant={"true of the moments without that of weight": {n_20[k]: n_of[k] for k in n_20}},
)
p.equation(
    "23 with (10)",
    words="generalised force of the drives, with the angular velocities of (10)",
    claims=rr["tau"],
    printed=matrix([rr["tau_alpha_free"], rr["tau_beta_free"]]),
    meant={SPIN_FREE: {rr["tau"]: rr["tau_free"]}},
)

# ---- The forces ----

row = J.rows[0]
gram = [[total(a * b, over=leg) for b in row] for a in row]
inner = solved(gram, (tau_alpha, tau_beta))
held = ~rr["loose"]
p.equation(
    "24",
    words="forces of the drives, by the generalised inverse of J^T, where J has rank 2",
    claims=rr["F_q"],
    printed=vector(*(at(row[0] * inner[0] + row[1] * inner[1], leg, k) for k in range(3))),
    given=held,
)
p.between(
    "singular",
    "J is a 3 x 2 singular matrix",
    determinant(gram),
    0,
    0,
    words="the determinant of J^T J, 0 where J has lost its rank of 2,",
)
