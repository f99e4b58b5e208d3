"""Mo et al.: the height of the dish, the rods on the four days, and the control, (35) to (39)."""

import tomllib
from pathlib import Path

from armillary import at, degrees, partial, substitute, total, vector
from armillary.derivation.units import METRE, RADIAN

from ._mo2023_frames import D, alpha, beta, d, dish, f, p, phi, r_b, r_m, sun, theta_rim, z_O
from ._mo2023_platform import H_T_P, carried, enu, leg, turned, u, x_14, x_P, y_15, y_P
from ._mo2023_sun import SUMMER, date, degree, number_of_day, on

# ---- The dimensions: Table 1 is lost ----

_FILE = Path(__file__).parents[1] / "dish_3rps" / "parameters.toml"
nominal = {name: one["value"] for name, one in tomllib.loads(_FILE.read_text())["nominal"].items()}


def dimension(q):
    """The nominal value of a length, as a constant with its name."""
    return p.constant(
        f"{q.name}_nominal", str(nominal[q.name]), f"nominal {q.facts.meaning}", unit=METRE,
        latex=f"{{{q.facts.latex}}}^*",
    )  # fmt: skip


sizes = {q: dimension(q) for q in (d, r_b, r_m, z_O)}
rim = {
    D: dimension(D),
    theta_rim: p.constant(
        "theta_nominal", degrees(str(nominal["theta_rim"])), "nominal edge angle", unit=RADIAN
    ),
}
around = dish.derivation.constants["phi_N"]


def on_days(value):
    """A value of the dish at the site while it faces the sun: per day, and per facet."""
    faced = substitute(value, {alpha: dish["alpha_aim"], beta: dish["beta_aim"], phi: around})
    faced = on(substitute(faced, {enu: sun["enu"]}), number_of_day)
    return substitute(substitute(faced, {f: dish["f_rim"], **sizes}), rim)


l_day = p.define(
    "l_day", on_days(dish["l_rod"]), because="The inferred set, on the four days.",
    meaning="length of rod i of facet N at the clock time t on the four days",
    latex="l",
)  # fmt: skip

# ---- The height of the dish ----

lengths = total(dish["l_rod"], over=leg)
p.equation(
    "35",
    words="height of the dish, as the least sum of the rods of a facet at any time: f = l",
    claims=z_O,
    printed={"all weights 1": lengths, "all weights 1/3": lengths / 3},
)
sum_slope = p.define(
    "sum_slope", on_days(partial(lengths, z_O)),
    because="The sum of a facet's rods on the four days, differentiated by the height.",
    meaning="slope of the sum of a facet's rods in z_O, on the four days",
    latex=r"\Sigma_z",
)  # fmt: skip
objective = "z_O-H = min sum lambda_i,N f(l_i,N, t), 2000 <= l_i,N <= 4000, 9 <= t <= 16"
p.between(
    "35'",
    objective,
    sum_slope,
    0,
    0,
    words="the slope of the sum of a facet's rods in z_O, 0 at a minimum between the bounds,",
)
p.extremes(
    "35''",
    objective,
    l_day,
    2,
    None,
    to="0.001",
    words="the length of the rods, the shortest at its bound where the sum is least,",
)
p.extremes(
    "shortest, longest",
    "The minimum and maximum lengths of the telescopic rod are 2105 mm and 3864 mm, respectively",
    l_day,
    "2.105",
    "3.864",
    to="0.001",
    words="the length of the rods on the four days",
)
p.between(
    "two sections",
    "Then a 2-section telescopic rod with a length of both the upper rod and the lower rod of "
    "2000 mm can meet the requirements",
    l_day,
    2,
    4,
    words="the length of the rods on the four days",
)
p.between(
    "59 deg",
    "a passive composite spherical joint with a limit range of (-59 deg - 59 deg), which can "
    "realize solar trajectory tracking from 9:00 am to 16:00 pm",
    p.define(
        "s_day",
        on_days(dish["s"]) / degree,
        because="The inferred set, on the four days.",
        meaning="angle of S-joint i of facet N from the normal, in degrees",
        latex="s",
    ),
    0,
    59,
    words="the angle of the S-joints from the facet's normal on the four days, in degrees,",
)

# ---- What the model of the paper errs ----

R_P, joint = H_T_P.rotation, r_m * u
base = H_T_P.position + R_P @ (r_b * u)
for key, name, words, rod in (
    (
        "rods in {H}",
        "Delta_H",
        "the error of a rod by (13) to (18) as printed",
        vector(x_14, y_15, dish["z_M"]) + carried.rotation @ joint - base,
    ),
    (
        "rods in {P}",
        "Delta_P",
        "the error of a rod by (13) to (18), with (14) and (15) read in {P},",
        vector(x_P, y_P, dish["z_M"]) + turned @ joint - r_b * u,
    ),
    (
        "rods by (13)",
        "Delta_O",
        "the error of a rod by (13), (17) and (18) alone",
        carried.position + carried.rotation @ joint - base,
    ),
):
    error_of_rod = p.define(
        name, on_days(rod.norm() - dish["l_rod"]), because="Less the true length.",
        meaning=words.strip(","), latex=rf"\Delta l_{{{name[-1]}}}",
    )  # fmt: skip
    p.between(
        key, "calculate the length of the 3-RPS telescopic rod", error_of_rod, 0, 0, words=words
    )
p.between(
    "tangent point",
    "the moving platform of the 3-RPS is on the tangent plane of the rotating paraboloid and point "
    "M is the tangent point of the two planes",
    p.define(
        "off_day",
        on_days(dish["off_dish"].norm()),
        because="The inferred set, on the four days.",
        meaning="distance of M from the point of the dish",
        latex=r"\Delta M",
    ),
    0,
    0,
    words="the distance of M from the point of the dish",
)

# ---- The control ----

p.unchecked(
    "36",
    "index of the control",
    "It defines by what the paper judges a controller. The letter t is its variable and its limit.",
)
K_P, K_I, K_D = (dish.quantity(name) for name in ("K_P", "K_I", "K_D"))
error = p.define("e_t", dish["error"], because="the paper's name", latex="e(t)")
summed = p.define(
    "e_sum", dish.quantity("integral") / K_I,
    because="The law keeps the integral with its gain, sample by sample.",
    meaning="integral of the error", latex=r"\int_0^t e(\tau)\,d\tau",
)  # fmt: skip
slope = p.define(
    "e_dot", dish.quantity("l_dot_ref") - dish["v_next"],
    because="The speed that is wanted, less the one that is measured and filtered.",
    meaning="rate of the error", latex=r"\frac{de(t)}{dt}",
)  # fmt: skip
feed_forward = {dish.quantity(name): 0 for name in ("F_ff", "K_V", "F_C")}
p.equation(
    "37",
    words="force that the controller asks for, without feed-forward",
    claims=substitute(dish["wanted"], feed_forward),
    printed=K_P * error + K_I * summed + K_D * slope,
)
p.unchecked(
    "steady error",
    "the tracking errors stay within 2.6 mm, and rod 1 has the smallest",
    "They stand on the gains, the plant and the step of a simulation, which the lost Tables 2 and "
    "3 and the text do not give; the study of dish_3rps has its own.",
)
p.least_moved(
    "rod 1",
    "mainly because the displacement change of the telescopic rod near the centroid of the "
    "concentrator is smaller than the outer layer during the whole tracking work",
    at(l_day, date, SUMMER),
    over=leg,
    part=0,
    words="the change of the length of a rod on the summer solstice",
)

# ---- The swarm ----

named = "a symbol of (38)"
omega, c_1, c_2 = (
    p.scalar(name, meaning, range=(0.0, 2.0), latex=latex)
    for name, meaning, latex in (
        ("omega", "inertial weight", r"\omega"),
        ("c_1", "learning factor of a particle's own best", "c_1"),
        ("c_2", "learning factor of the swarm's best", "c_2"),
    )
)
rand_1, rand_2 = (
    p.scalar(f"rand_{k}", "a random number", range=(0.0, 1.0), latex=rf"\mathrm{{rand}}_{k}")
    for k in (1, 2)
)
x_t, v_t, p_best, G_best = (
    p.scalar(name, meaning, range=(-10.0, 10.0), latex=latex)
    for name, meaning, latex in (
        ("x_t", "position of a particle", "x_t"),
        ("v_t", "its velocity", "v_t"),
        ("p_best", "the best position that it has found", r"p_{t\mathrm{best}}"),
        ("G_best", "the best position of the swarm", r"G_{t\mathrm{best}}"),
    )
)
pull = c_1 * rand_1 + c_2 * rand_2
v_next = p.define(
    "v_next",
    omega * v_t + pull * ((c_1 * rand_1 * p_best + c_2 * rand_2 * G_best) / pull - x_t),
    because="A particle is drawn to a mean of the two best positions, each weighed at random.",
    meaning="velocity of a particle after a step",
    latex="v_{t+1}",
)


def velocity(first, second):
    """The right side of (38)."""
    return omega * v_t + c_1 * first * (p_best - x_t) + c_2 * second * (G_best - x_t)


p.equation(
    "38",
    words="velocity of a particle",
    claims=v_next,
    printed={
        "a number drawn for each rand()": velocity(rand_1, rand_2),
        "one number for both": velocity(rand_1, rand_1),
    },
)
p.unchecked(
    "39",
    "position of a particle",
    "It says what the velocity is for. Here t counts the steps; in the text it counts the "
    "particles, whose best of all is p_gbest there and G_tbest in (38).",
)
