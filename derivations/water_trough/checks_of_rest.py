"""Where the trough rests, and the closed forms about it, against parcels and searches."""

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare
from armillary.verify.points import chosen

from .checks_of_motion import whole
from .parcels import STEP, UP, demand, state, sums
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
    """Every rest has its volume found; at that volume the trough rests there and stays."""
    points = whole(23, 3000, **STILL)
    points["theta"] = call(kernels.rest_angle, points).theta
    found = call(kernels.rest_volume, points)
    yield compare(
        "every rest has a volume found", "rest_angle", found.status, Status.OK, 0.0, points,
        "rest_volume",
    )  # fmt: skip
    at = {**points, "s": found.s}
    yield compare(
        "the rest at the volume for an angle", "rest_angle", call(kernels.rest_angle, at).theta,
        at["theta"], 1e-10, at, "rest_volume", turn=True,
    )  # fmt: skip
    levels = call(kernels.levels, at)
    yield compare(
        "and the containers hold it", "levels", levels.status >= 0, 1.0, 0.0, at, "rest_volume"
    )
    yield from _refused_where_there_is_none(kernels)


def _refused_where_there_is_none(kernels):
    """At any angle: a volume that does, or no rest at it among the volumes that fit."""
    points = whole(31, 400, **STILL)
    found = call(kernels.rest_volume, points)
    given = found.status == Status.OK
    at = chosen({**points, "s": found.s}, given)
    yield compare(
        "a volume found at any angle does", "rest_angle", call(kernels.rest_angle, at).theta,
        at["theta"], 1e-9, at, "rest_volume", turn=True,
    )  # fmt: skip
    low = -np.minimum(
        points["A_1"] * points["h_10"], points["A_2"] * (points["h_max"] - points["h_20"])
    )
    high = np.minimum(
        points["A_2"] * points["h_20"], points["A_1"] * (points["h_max"] - points["h_10"])
    )
    parts = np.linspace(1e-6, 1 - 1e-6, 1001)[:, None]
    off = call(kernels.rest_angle, {**points, "s": low + parts * (high - low)}).theta
    off = off - points["theta"]
    crossed = (np.sin(off[1:]) * np.sin(off[:-1]) < 0) & (np.cos(off[1:]) > 0.9)
    yield compare(
        "where a volume is refused, a search finds none", "search over volumes",
        np.any(crossed, axis=0)[~given], 0.0, 0.0, chosen(points, ~given), "rest_volume",
    )  # fmt: skip
    yield compare(
        "both happen", "counting", [given.sum() > 20, (~given).sum() > 20], 1.0, 0.0,
        {"angles": np.arange(2)}, "rest_volume",
    )  # fmt: skip


def upright(kernels):
    """A trough even about its axis rests upright with its water even."""
    points = whole(33, **STILL)
    even = {**points, "theta": 0.0 * points["theta"], "l": 0.0, "S_t_xi": 0.0, "S_t_eta": -0.1}
    even |= {"x_2": -points["x_1"], "y_1": -0.5, "y_2": -0.5}
    even |= {"A_2": points["A_1"], "h_20": points["h_10"]}
    found = call(kernels.rest_volume, even)
    yield compare(
        "an even trough rests upright with its water even", "symmetry",
        np.stack([found.status, found.s]), 0.0, 0.0, even, "rest_volume",
    )  # fmt: skip


# -- level surfaces -------------------------------------------------------------------------------

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)


def moment_of_wedges(row, theta, s):
    """What level surfaces add to the moment of weight: strips of water as high as they stand."""
    added, tilt = 0.0, np.tan(theta)
    heights = row["h_10"] + s / row["A_1"], row["h_20"] - s / row["A_2"]
    for k, height in zip("12", heights, strict=True):
        for node, weight in zip(_NODES, _WEIGHTS, strict=True):
            x = row["w"] * node / 2
            strip = row["rho"] * row[f"A_{k}"] * weight / 2
            for stands, sign in ((height - x * tilt, 1), (height, -1)):
                xi, eta = row[f"x_{k}"] + x, row[f"y_{k}"] + stands / 2
                off = xi * np.cos(theta) - eta * np.sin(theta)
                added = added - sign * row["g"] * strip * stands * off
    return added


def level_surfaces(kernels):
    """Moment, loss of stiffness and height at the wall, from strips; and the volume of a rest."""
    points = whole(28, **STILL)
    points["theta"] = np.random.default_rng(28).uniform(-1.2, 1.2, 60)
    told = call(kernels.free_surface, points)
    pairs = [(row, row["theta"], row["s"]) for row in rows(points)]
    wanted = [moment_of_wedges(*one) for one in pairs]
    yield compare(
        "moment of level surfaces", "strips", told.M_level, wanted, 1e-10, points, "free_surface"
    )
    steeper = [np.imag(moment_of_wedges(row, at + 1j * STEP, s)) / STEP for row, at, s in pairs]
    stiff = call(kernels.rest, points).stiffness
    yield compare(
        "part of the stiffness that level surfaces take", "strips", told.loss, steeper / stiff,
        1e-9, points, "free_surface",
    )  # fmt: skip
    for k, sign in (("1", 1), ("2", -1)):
        ends = points[f"h_{k}0"] + sign * points["s"] / points[f"A_{k}"]
        highest = np.max([ends + end * points["w"] / 2 * np.tan(points["theta"])
                          for end in (-1, 1)], axis=0)  # fmt: skip
        yield compare(
            f"height of water at the wall of container {k}", "NumPy",
            getattr(told, f"wall_{k}"), highest, 1e-13, points, "free_surface",
        )  # fmt: skip
    points["theta"] = call(kernels.rest_angle, {**points, "s": 0 * points["s"]}).theta
    points["theta"] = points["theta"] + np.linspace(-0.05, 0.05, 60)
    found = call(kernels.rest_volume_level, points)
    able = found.status == Status.OK
    at = chosen({**points, "s": found.s}, able)
    left = [moment_of_weight(row, row["theta"], row["s"])
            + moment_of_wedges(row, row["theta"], row["s"]) for row in rows(at)]  # fmt: skip
    scale = call(kernels.rest, at).stiffness
    yield compare(
        "at the volume for level surfaces no moment is left", "parcels and strips",
        np.array(left) / scale, 0.0, 1e-11, at, "rest_volume_level", relative=False,
    )  # fmt: skip
    yield compare(
        "which is found for most of the angles near a rest", "parcels and strips",
        np.mean(able) > 0.5, 1.0, 0.0, {"angles": 60}, "rest_volume_level",
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
    everywhere = call(kernels.stick_band, heavy).status == Status.CLAMPED
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
    """Held by smooth friction the trough creeps at the speed at which it does not accelerate."""
    brentq = need("scipy.optimize").brentq
    points = {**whole(26, 30, **STILL), "omega_s": np.full(30, 1e-5)}
    rest, band = call(kernels.rest_angle, points).theta, call(kernels.stick_band, points)
    parts = np.linspace(-0.8, 0.8, 30)
    points["theta"] = rest + np.arcsin(parts * np.sin(band.half_width))
    fit = band.status == Status.OK
    points = chosen(points, fit)
    told = call(kernels.creep, points).omega

    def speed(row):
        def alpha(omega):
            return float(kernels.acceleration_smooth(**{**row, "omega": omega}).alpha)

        return brentq(alpha, -1e-4, 1e-4, xtol=1e-20, rtol=1e-14)

    wanted = [speed({n: v for n, v in row.items() if n != "sag"}) for row in rows(points)]
    yield compare(
        "speed of creep over that of smooth friction", "SciPy's root", told / points["omega_s"],
        np.array(wanted) / points["omega_s"], 1e-7, points, "creep",
    )  # fmt: skip
    past = {**points, "theta": rest[fit] + 1.01 * band.half_width[fit]}
    yield compare(
        "outside the range of friction nothing creeps", "stick_band",
        call(kernels.creep, past).status, Status.UNREACHABLE, 0.0, past, "creep",
    )  # fmt: skip


# -- limits ---------------------------------------------------------------------------------------


def limits_of_the_model(kernels):
    """Equal levels give the dry rest; without water and tube the trough is a pendulum."""
    points = whole(27, s=0.0, **STILL)
    points.update(A_2=points["A_1"], h_20=points["h_10"], x_2=-points["x_1"])
    points.update(
        dict.fromkeys(("L_t", "m_t", "S_t_xi", "S_t_eta", "I_t", "Gamma_t"), np.zeros(60))
    )
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
    yield from _pendulum_with_water(kernels)


def _pendulum_with_water(kernels):
    """Water that turns with the trough makes a heavier pendulum; a flow departs in order."""
    points = {**whole(29, q=0.0, q_dot=0.0), "mu": np.zeros(60)}
    found = [sums(row, *state(row)) for row in rows(points)]
    moment = [
        np.cross(f.first, -row["g"] * UP)[2] for f, row in zip(found, rows(points), strict=True)
    ]
    wanted = np.array(moment) / [_inertia(row) for row in rows(points)]
    yield compare(
        "swinging water that does not flow: a physical pendulum", "parcels",
        call(kernels.acceleration, points).alpha, wanted, 1e-11, points, "acceleration",
    )  # fmt: skip

    def departure(part):
        flow = {"q": part * 1e-4 + 0 * points["s"], "q_dot": part * 1e-3 + 0 * points["s"]}
        return np.linalg.norm(call(kernels.acceleration, {**points, **flow}).alpha - wanted)

    yield compare(
        "order in which a flow departs from the pendulum", "halving",
        np.log2(departure(1 / 8) / departure(1 / 16)), 1.0, 0.02, points, "acceleration",
        relative=False,
    )  # fmt: skip
