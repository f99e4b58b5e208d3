"""Where the trough rests, and the closed forms about it, against parcels and searches."""

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare
from armillary.verify.points import chosen

from .checks_of_motion import whole
from .parcels import STEP, UP, demand, sums
from .samples import call, rows

STILL = {"omega": 0.0, "q": 0.0, "q_dot": 0.0}


def moment_of_weight(row, theta, s):
    """Of all parcels about the axis."""
    found = sums(row, theta, 0.0, s, 0.0)
    return np.cross(found.first, -row["g"] * UP)[2]


def slope(row, theta, s, d_theta, d_s):
    """Its derivative along a direction."""
    moved = moment_of_weight(row, theta + 1j * STEP * d_theta, s + 1j * STEP * d_s)
    return float(np.imag(moved)) / STEP


def _rest(row):
    """Where a search finds no moment, and a turn off it is driven back."""
    brentq = need("scipy.optimize").brentq
    grid = np.linspace(-np.pi, np.pi, 9) + 0.1234
    values = [moment_of_weight(row, theta, row["s"]) for theta in grid]
    k = next(k for k in range(8) if values[k] > 0 >= values[k + 1])
    return brentq(
        lambda theta: moment_of_weight(row, theta, row["s"]), grid[k], grid[k + 1],
        xtol=1e-15, rtol=1e-15,
    )  # fmt: skip


def rest_by_parcels(kernels):
    """Rest angle, stiffness, gain and period from the parcels' moment and its slopes."""
    points = {**whole(21, **STILL), "theta_dot_ref": np.linspace(-0.01, 0.01, 60)}
    wanted = np.array([_rest(row) for row in rows(points)])
    theta = call(kernels.rest_angle, points).theta
    yield compare(
        "rest angle", "SciPy's root", theta, wanted, 1e-12, points, "rest_angle", turn=True
    )
    pairs = list(zip(rows(points), theta, strict=True))
    stiff = np.array([-slope(row, at, row["s"], 1.0, 0.0) for row, at in pairs])
    by_water = np.array([slope(row, at, row["s"], 0.0, 1.0) for row, at in pairs])
    inertia = np.array([_inertia(row) for row in rows(points)])
    found, linear = call(kernels.rest, points), call(kernels.linear, points)
    about = {
        "stiffness": (found.stiffness, stiff, "rest"),
        "gain": (found.gain, by_water / stiff, "rest"),
        "period": (found.period, 2 * np.pi * np.sqrt(inertia / stiff), "rest"),
        "swing": (linear.swing, stiff / inertia, "linear"),
        "pull": (linear.pull, by_water / inertia, "linear"),
        "flow per rate to follow": (
            call(kernels.follow, points).q / points["theta_dot_ref"], stiff / by_water, "follow",
        ),
    }  # fmt: skip
    for name, (value, wanted, kernel) in about.items():
        yield compare(f"{name} about the rest", "parcels", value, wanted, 1e-10, points, kernel)


def _inertia(row):
    return demand(row, 1.0).moment[2] - demand(row, 0.0).moment[2]


def linear_to_second_order(kernels):
    """What the linear form leaves of the acceleration falls with the square of the deviation."""
    points = {**whole(22, **STILL), "mu": np.zeros(60)}
    points["s"] = 0.3 * points["s"]
    rest, random = call(kernels.rest_angle, points).theta, np.random.default_rng(22)
    e, v = random.uniform(0.01, 0.02, 60), 0.01 * np.abs(points["s"])
    flow = random.uniform(-1e-4, 1e-4, 60)
    found = call(kernels.linear, points)

    def left(part):
        at = {
            **points, "theta": rest + part * e, "s": points["s"] + part * v,
            "q_dot": part * flow,
        }  # fmt: skip
        straight = part * (-found.swing * e + found.pull * v - found.kick * flow)
        return np.linalg.norm(call(kernels.acceleration, at).alpha - straight)

    order = np.log2(left(1 / 4) / left(1 / 8))
    yield compare(
        "order of what the linear form leaves out", "halving", order, 2.0, 0.05, points, "linear",
        relative=False,
    )  # fmt: skip


def rest_volume_inverts(kernels):
    """At the volume for an angle the trough rests at that angle, and stays."""
    points = whole(23, **STILL)
    points["theta"] = call(kernels.rest_angle, points).theta
    found = call(kernels.rest_volume, points)
    at = chosen({**points, "s": found.s}, found.status == Status.OK)
    yield compare(
        "the rest at the volume for an angle", "rest_angle", call(kernels.rest_angle, at).theta,
        at["theta"], 1e-11, at, "rest_volume", turn=True,
    )  # fmt: skip
    yield compare(
        "almost every rest has its volume found again", "rest_angle",
        np.mean(found.status == Status.OK) > 0.9, 1.0, 0.0, {"angles": 60}, "rest_volume",
    )  # fmt: skip
    levels = call(kernels.levels, at)
    yield compare(
        "and the containers hold it", "levels", levels.status >= 0, 1.0, 0.0, at, "rest_volume"
    )
    over = {**points, "theta": points["theta"] + np.pi}
    yield compare(
        "no volume for a rest that does not last", "geometry",
        call(kernels.rest_volume, over).status, Status.UNREACHABLE, 0.0, over, "rest_volume",
    )  # fmt: skip
    even = {**points, "theta": 0.0 * points["theta"], "l": 0.0, "S_t_xi": 0.0, "S_t_eta": -0.1}
    even |= {"x_2": -points["x_1"], "y_1": -0.5, "y_2": -0.5}
    even |= {"A_2": points["A_1"], "h_20": points["h_10"]}
    found = call(kernels.rest_volume, even)
    yield compare(
        "an even trough rests upright with its water even", "symmetry",
        np.stack([found.status, found.s]), 0.0, 0.0, even, "rest_volume",
    )  # fmt: skip


# -- friction at rest -----------------------------------------------------------------------------


def band_by_kernels(kernels):
    """Friction holds the trough just inside the band, and lets go just outside."""
    points = whole(24, **STILL)
    rest, band = call(kernels.rest_angle, points).theta, call(kernels.stick_band, points)
    for side in (1.0, -1.0):
        for part, status in ((1 - 1e-9, Status.STICKING), (1 + 1e-9, Status.OK)):
            at = {**points, "theta": rest + side * part * band.half_width}
            fit = band.status == Status.OK
            yield compare(
                "friction holds up to the half width and no further", "acceleration",
                call(kernels.acceleration, at).status[fit], status, 0.0, chosen(at, fit),
                "stick_band",
            )  # fmt: skip
    heavy = {**points, "l": np.zeros(60), "mu": np.full(60, 10.0), "r_f": np.full(60, 0.3)}
    loose = call(kernels.stick_band, heavy)
    everywhere = loose.status == Status.CLAMPED
    at = {**heavy, "theta": np.random.default_rng(24).uniform(-3.1, 3.1, 60)}
    found = call(kernels.acceleration, at).status
    yield compare(
        "where it is told that friction holds everywhere, it does", "acceleration",
        found[everywhere & (found >= 0)], Status.STICKING, 0.0,
        chosen(at, everywhere & (found >= 0)), "stick_band",
    )  # fmt: skip


def volumes_of_breakaway(kernels):
    """Between the two volumes friction holds; beyond either the trough sets off that way."""
    points = whole(25, **STILL)
    points["theta"] = call(kernels.rest_angle, points).theta
    found = call(kernels.stick_volumes, points)
    points = chosen(points, found.status == Status.OK)
    on, back, water = (getattr(found, n)[found.status == Status.OK] for n in found._fields[:3])
    yield compare("their distance", "NumPy", water, on - back, 1e-14, points, "stick_volumes")
    width = on - back
    for s, wanted, sense in (
        (on - 1e-8 * width, Status.STICKING, 0.0), (on + 1e-8 * width, Status.OK, 1.0),
        (back + 1e-8 * width, Status.STICKING, 0.0), (back - 1e-8 * width, Status.OK, -1.0),
    ):  # fmt: skip
        at = {**points, "s": s}
        moved = call(kernels.acceleration, at)
        yield compare(
            "held between the volumes of breakaway only", "acceleration", moved.status, wanted,
            0.0, at, "stick_volumes",
        )  # fmt: skip
        yield compare(
            "and beyond them it sets off that way", "acceleration", np.sign(moved.alpha), sense,
            0.0, at, "stick_volumes",
        )  # fmt: skip


def creep_of_smooth_friction(kernels):
    """Held by smooth friction the trough creeps at the speed that makes it carry the drive."""
    brentq = need("scipy.optimize").brentq
    points = {**whole(26, 30, **STILL), "omega_s": np.full(30, 1e-5)}
    rest, band = call(kernels.rest_angle, points).theta, call(kernels.stick_band, points)
    points["theta"] = rest + band.half_width * np.linspace(-0.8, 0.8, 30)
    points = chosen(points, band.status == Status.OK)
    needs = [demand(row, 0.0) for row in rows(points)]
    arm = points["mu"] * points["r_f"] / 2
    part = [-n.moment[2] / np.linalg.norm(n.force) for n in needs] / arm
    predicted = points["omega_s"] * part / np.sqrt(1 - part**2)

    def speed(row):
        def alpha(omega):
            return float(kernels.acceleration_smooth(**{**row, "omega": omega}).alpha)

        return brentq(alpha, -1e-4, 1e-4, xtol=1e-20, rtol=1e-14)

    wanted = [speed({n: v for n, v in row.items() if n != "sag"}) for row in rows(points)]
    yield compare(
        "speed of creep over that of smooth friction", "SciPy's root",
        predicted / points["omega_s"], np.array(wanted) / points["omega_s"], 1e-7, points,
        "acceleration_smooth",
    )  # fmt: skip


# -- limits ---------------------------------------------------------------------------------------


def limits_of_the_model(kernels):
    """Equal levels give the dry rest; without water and tube the trough is a pendulum."""
    points = whole(27, s=0.0, **STILL)
    points.update(A_2=points["A_1"], h_20=points["h_10"], x_2=-points["x_1"])
    points.update(dict.fromkeys(("m_t", "S_t_xi", "S_t_eta", "I_t", "Gamma_t"), np.zeros(60)))
    low = {**points, "y_1": -points["h_10"] / 2, "y_2": -points["h_10"] / 2}
    yield compare(
        "equal levels with their centres level with the axis: the dry rest", "geometry",
        call(kernels.rest_angle, low).theta, -np.pi / 2 - low["lam"], 1e-11, low, "rest_angle",
        turn=True,
    )  # fmt: skip
    bare = {**points, "h_10": 0 * points["s"], "h_20": 0 * points["s"], "mu": 0 * points["s"]}
    alpha = call(kernels.acceleration, bare).alpha
    wanted = -bare["M"] * bare["g"] * bare["l"] * np.cos(bare["theta"] + bare["lam"])
    yield compare(
        "without water and tube: a physical pendulum", "NumPy", alpha, wanted / bare["I_zz"],
        1e-13, bare, "acceleration",
    )  # fmt: skip
