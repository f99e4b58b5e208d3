"""Salgado Conrado et al.: the principle, and the balance of forces, (1) to (3)."""

from armillary import absolute, number, substitute, time_derivative, vector, where

from ._salgado2014_units import M, a_c, g, omega, p, q, trough, turned

alpha, q_dot, rho = (trough.quantity(name) for name in ("alpha", "q_dot", "rho"))
S, m_all = trough["S"], trough["m_all"]

# ---- The principle ----

p.between(
    "principle",
    "Water pump of container 2 is turned on and it drains water from the container 2 to the "
    "container 1 when the rotation is in a counterclockwise direction",
    trough["gain"],
    0,
    None,
    words="the turn of the rest angle per volume moved from container 2 to 1, where the trough "
    "rests within 45 degrees of the upright,",
    given=absolute(S.x) < -S.y,
)
A_1, A_2, x_1, x_2 = (trough.quantity(name) for name in ("A_1", "A_2", "x_1", "x_2"))
h_1, h_2 = trough["h_1"], trough["h_2"]
water_turns = p.define(
    "water_turns",
    -g * (trough["m_1"] * x_1 + trough["m_2"] * x_2),
    because="Weight times arm; the water on the left turns the trough on.",
    meaning="moment of the containers' water about the axis, at theta = 0",
    latex=r"M_\mathrm{w}",
)
ALIKE = {A_2: A_1, x_2: -x_1}
towards_higher = where(h_2 < h_1, water_turns, -water_turns)
p.between(
    "imbalance",
    "The difference of water level generates a dynamic imbalance",
    substitute(towards_higher, ALIKE),
    0,
    None,
    words="the moment of the water at theta = 0 towards the container with the higher level, of "
    "containers with one floor area at one distance,",
)

# ---- The balance of forces ----

r_all = p.define(
    "r_all",
    (1 / m_all) * (turned @ S),
    because="First moment over mass.",
    meaning="mass centre of trough and water",
    latex=r"\mathbf{r}",
)
a_all = p.define(
    "a_all",
    time_derivative(time_derivative(r_all)),
    because="The water's own motion moves it, too.",
    meaning="acceleration of the mass centre of trough and water",
    latex=r"\mathbf{a}_\mathrm{all}",
)
F_A, F_B = trough["F_A"].rows[0], trough["F_B"].rows[0]
level = p.define(
    "level",
    F_A[0] + F_B[0],
    because="The left side of (2) along i.",
    meaning="force of both bearings along i",
    latex="F_x",
)
upward = p.define(
    "upward",
    F_A[1] + F_B[1],
    because="The bearings' part of (2) along j.",
    meaning="force of both bearings along j",
    latex="F_y",
)
F_1, F_2 = trough["F_1"], trough["F_2"]
p.equation(
    "1",
    words="sum of the forces, with m all that moves and a of its mass centre",
    claims=turned @ trough["F_all"] - (m_all * g) * vector(0, 1, 0),
    printed=m_all * a_all,
)


# M, and the a beside it, may be of the concentrator or of all that moves.
MASSES = {"M the concentrator's mass": M, "M the mass of all that moves": m_all}


def readings(made, of_all=a_all):
    """`made` of mass and acceleration, for each way to read M and a."""
    centres = {
        "a of the concentrator's centre of mass": a_c,
        "a of the mass centre of trough and water": of_all,
    }
    return {
        f"{mass}, {centre}": made(MASSES[mass], centres[centre])
        for mass in MASSES
        for centre in centres
    }


STILL = {rate: number(0) for rate in (omega, alpha, q, q_dot)}
AXIS = vector(0, 0, 1)
NO_FLOW = {q: number(0), q_dot: number(0)}
EMPTY = {trough.quantity(name): number(0) for name in ("m_t", "S_t_xi", "S_t_eta")}
AN_EMPTY_TUBE = "true of an empty tube"
ONCE = "true without F_1 and F_2: M has the mass of the water already"
WEIGHTLESS = {F_1: number(0), F_2: number(0)}
AT_REST = {
    level: substitute(level, STILL),
    upward: substitute(upward, STILL),
    a_c: vector(0, 0, 0),
    a_all: vector(0, 0, 0),
}
p.equation(
    "2",
    words="force of both bearings, F_1 and F_2 the weights of the water",
    claims=vector(level, upward, 0),
    printed=readings(lambda m, a: vector(m * a.x, m * a.y + m * g + F_1 + F_2, 0)),
    meant={
        "true of a trough at rest with an empty tube": {
            **AT_REST,
            upward: substitute(upward, {**STILL, **EMPTY}),
        },
        ONCE: WEIGHTLESS,
        "true at rest without F_1 and F_2: M has the mass of the water already": {
            **AT_REST,
            **WEIGHTLESS,
        },
    },
)
p.equation(
    "2 at rest",
    words="force of both bearings upward, where nothing moves",
    claims=substitute(upward, STILL),
    printed={words: m * g + F_1 + F_2 for words, m in MASSES.items()},
    meant={ONCE: WEIGHTLESS},
)


def lifting(container):
    """The upward force of a container's water on it, while no water is moved."""
    x, y = (trough.quantity(f"{letter}_{container}") for letter in "xy")
    place = turned @ vector(x, y + trough[f"h_{container}"] / 2, 0)
    rise = (alpha * AXIS.cross(place) - (omega * omega) * place).y
    return p.define(
        f"N_{container}",
        trough[f"m_{container}"] * (g + rise),
        because="What lifts the water, besides its weight.",
        meaning=f"upward force of the water on container {container}, while none is moved",
        latex=f"N_{container}",
    )


N_1, N_2 = lifting(1), lifting(2)
AS_FORCES = "F_1 force on container 1 [N] [...] F_2 force on container 2 [N]"
NO_WATER = {**EMPTY, rho: number(0)}
A_DRY_TROUGH = "true of a trough without water"
held_level, held_upward = (
    p.define(
        f"held_{force.name}",
        substitute(force, NO_FLOW),
        because="The pumps are off.",
        meaning=f"force of both bearings along {along} while no water is moved",
        latex=f"F_{{{axis}0}}",
    )
    for force, along, axis in ((level, "i", "x"), (upward, "j", "y"))
)
a_held = p.define(
    "a_held",
    substitute(a_all, NO_FLOW),
    because="The pumps are off.",
    meaning="acceleration of the mass centre of trough and water while no water is moved",
    latex=r"\mathbf{a}_0",
)
DRY = {m_all: M, a_held: a_c, N_1: number(0), N_2: number(0)}
p.equation(
    "2 along j",
    words="force of both bearings along j while no water is moved, F_1 and F_2 the forces on the "
    "containers that the nomenclature calls them",
    quote=AS_FORCES,
    claims=held_upward,
    printed=readings(lambda m, a: m * a.y + m * g + N_1 + N_2, a_held),
    meant={
        AN_EMPTY_TUBE: {held_upward: substitute(held_upward, EMPTY)},
        ONCE: {N_1: number(0), N_2: number(0)},
        A_DRY_TROUGH: {**DRY, held_upward: substitute(held_upward, NO_WATER)},
    },
)
p.equation(
    "2 along i",
    words="force of both bearings along i while no water is moved, where (2) has no force on the "
    "containers",
    quote=AS_FORCES,
    claims=held_level,
    printed=readings(lambda m, a: m * a.x, a_held),
    meant={A_DRY_TROUGH: {**DRY, held_level: substitute(held_level, NO_WATER)}},
)
p.unchecked(
    "3",
    "sum of moments about the spin axis z",
    "It is lost: the file announces it, says that it is deduced from Fig. 3, which is lost too, "
    "and ends. The moment equation of the trough's page is derived, not the paper's.",
)
