"""The way to the sun once more: attitudes by SciPy, the sun by ERFA, rates by Cauchy's formula."""

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare
from armillary.verify.points import chosen

COUNT = 1000
TURN = 2 * np.pi
ZENITH = 1e-6  # horizontal length of the sun's direction below which alpha is free
OVERHEAD = np.array([0.0, 0.0, 1.0])


def attitude(alpha, beta):
    """Rotations of the platform, by SciPy."""
    euler = np.stack(np.broadcast_arrays(alpha, beta), axis=-1).reshape(-1, 2)
    return need("scipy.spatial.transform").Rotation.from_euler("ZX", euler)


def normal(alpha, beta):
    """The platform's third axis, by SciPy."""
    return attitude(alpha, beta).as_matrix()[..., 2].reshape(*np.shape(alpha), 3)


def directions(seed, count=COUNT):
    """Unit vectors all around."""
    enu = np.random.default_rng(seed).normal(size=(count, 3))
    return enu / np.linalg.norm(enu, axis=1, keepdims=True)


def excess(name, found, inputs, kernel, engine="bounds"):
    """What must be exactly zero at every point."""
    return compare(name, engine, found, 0.0, 0.0, inputs, kernel)


# -- attitudes ------------------------------------------------------------------------------------


def aim_by_scipy(kernels):
    """The normal is on the sun, all around and due north, where alpha is half a turn."""
    enu = directions(31)
    enu[:40:2, 0], enu[1:40:2, 0] = 0.0, -0.0
    enu[:40] /= np.linalg.norm(enu[:40], axis=1, keepdims=True)
    given = {"enu": enu}
    found = kernels.aim(**given)
    yield compare(
        "the normal is on the sun", "SciPy", normal(found.alpha, found.beta), enu, 1e-14, given,
        "aim",
    )  # fmt: skip
    outside = (np.abs(found.alpha) > np.pi) | (found.beta < 0) | (found.beta > np.pi)
    yield excess("alpha lies in [-pi, pi] and beta in [0, pi]", outside, given, "aim")


def before(seed):
    """Suns all around, some near the zenith and the horizon, and attitudes up to 1000 rad."""
    random = np.random.default_rng(seed)
    enu = directions(seed + 1)
    enu[::5, 2] *= 1e-3
    enu[1::5, :2] *= 10.0 ** random.uniform(-5, -1, (COUNT // 5, 1))
    enu /= np.linalg.norm(enu, axis=1, keepdims=True)
    alpha, beta = random.uniform(-1e3, 1e3, COUNT), random.uniform(-1e3, 1e3, COUNT)
    alpha[::2], beta[::2] = random.uniform(-np.pi, np.pi, (2, COUNT // 2))
    return {"enu": enu, "alpha_before": alpha, "beta_before": beta}


def nearest_by_scipy(kernels):
    """Of the two attitudes that face the sun the one is taken that SciPy calls nearer."""
    given = before(33)
    found = kernels.aim_nearest(**given)
    alpha, beta = given["alpha_before"], given["beta_before"]
    yield compare(
        "the normal is on the sun, from attitudes up to 1000 rad", "SciPy",
        normal(found.alpha, found.beta), given["enu"], 1e-12, given, "aim_nearest",
    )  # fmt: skip
    stood = attitude(alpha, beta)
    turned, other = (
        (stood.inv() * attitude(*angles)).magnitude()
        for angles in ((found.alpha, found.beta), (found.alpha + np.pi, -found.beta))
    )
    farther = np.maximum(turned - other - 1e-12, 0.0)
    yield excess("the platform turns less than to the other one", farther, given, "aim_nearest")
    for what, move in (("alpha", found.alpha - alpha), ("beta", found.beta - beta)):
        beyond = np.maximum(np.abs(move) - np.pi - 1e-12, 0.0)
        yield excess(f"{what} moves by half a turn at most", beyond, given, "aim_nearest")
    flipped = kernels.aim(enu=given["enu"])
    over = np.cos(found.alpha - flipped.alpha) < 0
    yield compare(
        "it is the attitude of aim, or that with the other sign of beta", "round trip",
        np.stack([found.alpha, found.beta], axis=1),
        np.stack([flipped.alpha + np.pi * over, np.where(over, -1, 1) * flipped.beta], axis=1),
        1e-11, given, "aim_nearest", turn=True,
    )  # fmt: skip


def followed(kernels, path, alpha):
    """Attitudes along paths of the sun, each found from the one before.

    Args:
        path: directions (steps, paths, 3).
        alpha: turns to begin with, as `aim` gives them but for whole turns.
    """
    beta = kernels.aim(enu=path[0]).beta
    way = []
    for enu in path:
        found = kernels.aim_nearest(enu=enu, alpha_before=alpha, beta_before=beta)
        alpha, beta = found.alpha, found.beta
        way.append((alpha, beta))
    return np.moveaxis(np.array(way), 1, 0)


def passing(off, step, half=300):
    """Great circles that pass the zenith at distances `off`, each towards another azimuth."""
    heading = np.random.default_rng(34).uniform(0, TURN, len(off))
    ahead = np.stack([np.cos(heading), np.sin(heading), 0 * off], axis=-1)
    aside = np.cross(OVERHEAD, ahead)
    top = np.cos(off)[:, None] * OVERHEAD + np.sin(off)[:, None] * aside
    way = (np.arange(-half, half + 1) * step)[:, None, None]
    return np.cos(way) * top + np.sin(way) * ahead


def passes(kernels):
    """Through the zenith and close beside it nothing jumps; farther off alpha follows."""
    step = 1e-3
    off = np.array([0.0, 1e-9, 0.9e-6, 1.1e-6, 1e-5, 1e-4, 3e-3, 0.03, 0.3])
    path = passing(off, step)
    start = kernels.aim(enu=path[0]).alpha
    alpha, beta = followed(kernels, path, start)
    given = {"off": off}
    missed = np.linalg.norm(normal(alpha, beta) - path, axis=-1).max(axis=0)
    wanted = np.where(off < ZENITH, off, 0.0)
    yield compare(
        "the sun is missed only within 1e-6 of the zenith, and by no more", "SciPy", missed,
        wanted, 1e-12, given, "aim_nearest",
    )  # fmt: skip
    # On the great circle the azimuth goes from one side to the other.
    swing = 2 * np.arctan2(np.tan(300 * step), np.sin(off))
    tilted = off < ZENITH
    turn = np.abs(alpha[-1] - alpha[0])
    yield compare(
        "through the zenith alpha holds and beta changes its sign; beside it alpha swings",
        "geometry", turn, np.where(tilted, np.pi - swing, swing), 1e-12, given, "aim_nearest",
    )  # fmt: skip
    yield compare(
        "beta ends as it began, but for its sign", "geometry", beta[-1],
        np.where(tilted, -beta[0], beta[0]), 1e-13, given, "aim_nearest",
    )  # fmt: skip
    steps = np.abs(np.diff(alpha, axis=0)).max(axis=0)
    beyond = np.maximum(steps - np.pi / 2, 0.0)
    yield excess("no step turns alpha by more than a quarter", beyond, given, "aim_nearest")
    jump = np.abs(np.diff(beta, axis=0)).max(axis=0)
    yield excess(
        "no step tilts by more than the sun moves, and 1e-6 for what is missed overhead",
        np.maximum(jump - step - ZENITH, 0.0), given, "aim_nearest",
    )  # fmt: skip
    yield straddled(kernels, step)


def straddled(kernels, step):
    """Steps that stride over the zenith: alpha stays, as in the pass through it."""
    off = np.array([1e-9, 1e-6, 1e-5, 1e-4])
    path = passing(off, step)
    path = np.concatenate([path[:300], path[301:]])  # the nearest point is stepped over
    alpha, _ = followed(kernels, path, kernels.aim(enu=path[0]).alpha)
    swing = 2 * np.arctan2(np.tan(300 * step), np.sin(off))
    return compare(
        "in strides of twice the distance or more alpha stays and beta changes its sign",
        "geometry", np.abs(alpha[-1] - alpha[0]), np.pi - swing, 1e-10, {"off": off},
        "aim_nearest",
    )  # fmt: skip


def midnight_sun(kernels):
    """Where the sun does not set alpha winds up, turn by turn, over the north without a jump."""
    from armillary_kernels import sun

    latitude = np.array([1.2, 1.3, 1.5, -1.3, -1.5])
    hour = np.linspace(-2.0, 2.0, 1921)[:, None] * np.pi
    enu = sun.direction(latitude=latitude, declination=0.4 * np.sign(latitude), hour_angle=hour).enu
    aimed = kernels.aim(enu=enu)
    first = aimed.alpha[0] + TURN * np.array([0, 1, -1, 20, 100])
    alpha, beta = followed(kernels, enu, first)
    wanted = np.unwrap(aimed.alpha, axis=0) + (first - aimed.alpha[0])
    given = {"latitude": latitude}
    yield compare(
        "two days of midnight sun wind alpha up by two turns", "NumPy", alpha.T, wanted.T, 1e-13,
        given, "aim_nearest",
    )  # fmt: skip
    yield compare(
        "to the west in the north, to the east in the south", "geometry", alpha[-1] - alpha[0],
        -2 * TURN * np.sign(latitude), 1e-13, given, "aim_nearest",
    )  # fmt: skip
    yield compare("beta keeps its sign", "NumPy", beta.T, aimed.beta.T, 1e-13, given, "aim_nearest")


# -- rates ----------------------------------------------------------------------------------------


def slopes(curve, radius=0.5, count=32):
    """First and second derivative at 0, by Cauchy's formula on a circle of the complex plane."""
    around = np.exp(1j * TURN * np.arange(count) / count)
    values = [curve(radius * t) for t in around]
    first = sum(v / t for v, t in zip(values, around, strict=True)) / (count * radius)
    second = 2 * sum(v / t**2 for v, t in zip(values, around, strict=True)) / (count * radius**2)
    return first.real, second.real


def moving(seed):
    """Attitudes of either sign of beta, and how they move."""
    random = np.random.default_rng(seed)
    alpha = random.uniform(-np.pi, np.pi, COUNT)
    beta = random.uniform(0.05, np.pi - 0.05, COUNT) * random.choice([-1, 1], COUNT)
    return alpha, beta, *random.uniform(-3, 3, (4, COUNT))


def rates_by_circles(kernels):
    """A sun that a moving platform is made to face gives the platform's motion back."""
    alpha, beta, alpha_dot, beta_dot, alpha_ddot, beta_ddot = moving(35)

    def sun(t):
        a = alpha + alpha_dot * t + alpha_ddot * t**2 / 2
        b = beta + beta_dot * t + beta_ddot * t**2 / 2
        return np.stack([np.sin(a) * np.sin(b), -np.cos(a) * np.sin(b), np.cos(b)], axis=-1)

    speed, bend = slopes(sun)
    given = {"enu": sun(0.0), "enu_dot": speed, "enu_ddot": bend}
    found = kernels.aim_rates(**given)
    sign = np.sign(beta)  # with beta < 0 it is the other attitude that moved
    for what, wanted in (
        ("alpha_dot", alpha_dot), ("beta_dot", sign * beta_dot),
        ("alpha_ddot", alpha_ddot), ("beta_ddot", sign * beta_ddot),
    ):  # fmt: skip
        yield compare(
            f"{what}, beta of either sign", "Cauchy's formula", getattr(found, what), wanted,
            1e-11, given, "aim_rates",
        )  # fmt: skip
    yield compare(
        "the angles beside the rates are those of aim", "round trip",
        np.stack([found.alpha, found.beta], axis=1),
        np.stack([alpha + np.pi * (beta < 0), sign * beta], axis=1), 1e-13, given, "aim_rates",
        turn=True,
    )  # fmt: skip


def shone(seed):
    """Places, days, hours and speeds of the sun."""
    random = np.random.default_rng(seed)
    return {
        "latitude": random.uniform(-1.5, 1.5, COUNT),
        "declination": random.uniform(-0.41, 0.41, COUNT),
        "hour_angle": random.uniform(-np.pi, np.pi, COUNT),
        "hour_angle_rate": random.uniform(0.1, 0.3, COUNT),
    }


def by_erfa(at):
    """The turn and the tilt that face ERFA's sun."""
    azimuth, elevation = need("erfa").hd2ae(at["hour_angle"], at["declination"], at["latitude"])
    return np.pi - azimuth, np.pi / 2 - elevation


def track_by_erfa(kernels):
    """Angles by ERFA; rates and accelerations add up to the way between them."""
    start = shone(36)
    nodes, weights = np.polynomial.legendre.leggauss(24)
    times, weights = (nodes + 1) / 2, weights / 2

    def at(time):
        return {**start, "hour_angle": start["hour_angle"] + time * start["hour_angle_rate"]}

    first, found = kernels.track(**start), [kernels.track(**at(time)) for time in times]
    tilts = np.stack([by_erfa(at(time))[1] for time in times])
    clear = np.sin(tilts).min(axis=0) > 0.25  # off the zenith and the nadir
    given = chosen(start, clear)
    for k, what in enumerate(("alpha", "beta")):
        began, ended = by_erfa(start)[k][clear], by_erfa(at(1.0))[k][clear]
        yield compare(
            f"{what} that faces the sun", "ERFA", getattr(first, what)[clear], began, 1e-13,
            given, "track", turn=True,
        )  # fmt: skip

        def summed(name, weight):
            values = np.stack([getattr(f, name)[clear] for f in found])
            return np.tensordot(weight, values, axes=1)

        yield compare(
            f"{what}_dot adds up to the way", "ERFA", summed(f"{what}_dot", weights),
            ended - began, 1e-12, given, "track", turn=True,
        )  # fmt: skip
        left = getattr(first, f"{what}_dot")[clear]
        yield compare(
            f"{what}_ddot adds up to what the first speed leaves of it", "ERFA",
            summed(f"{what}_ddot", weights * (1 - times)) + left, ended - began, 1e-12, given,
            "track", turn=True,
        )  # fmt: skip


def declination_left_out(kernels):
    """What `track` leaves out is the declination's rate: no more, no less, whichever way."""
    given = shone(37)
    latitude, declination, hour, speed = given.values()
    slope = np.random.default_rng(38).uniform(-1, 1, COUNT)

    def sun(t):
        from_pole, around = declination + slope * t, hour + speed * t
        east = -np.cos(from_pole) * np.sin(around)
        equator = np.cos(from_pole) * np.cos(around)
        north = np.cos(latitude) * np.sin(from_pole) - np.sin(latitude) * equator
        up = np.sin(latitude) * np.sin(from_pole) + np.cos(latitude) * equator
        return np.stack([east, north, up], axis=-1)

    velocity, bend = slopes(sun)
    moved = kernels.aim_rates(enu=sun(0.0), enu_dot=velocity, enu_ddot=bend)
    found = kernels.track(**given)
    missing = np.hypot(
        (moved.alpha_dot - found.alpha_dot) * np.sin(found.beta), moved.beta_dot - found.beta_dot
    )
    yield compare(
        "the rates lack that of the declination, as the angle it moves the normal by",
        "Cauchy's formula", missing, np.abs(slope), 1e-12, {**given, "slope": slope}, "track",
    )  # fmt: skip


# -- statuses -------------------------------------------------------------------------------------


def overhead(kernels):
    """Within 1e-6 of the zenith and the nadir alpha is free, and nowhere else."""
    turn = np.random.default_rng(39).uniform(-np.pi, np.pi, 40)
    off = np.repeat([0.0, 1e-9, 0.999e-6, 1.001e-6], 10)
    enu = np.stack([off * np.cos(turn), off * np.sin(turn), np.ones(40)], axis=1)
    enu[::2, 2] = -1.0
    free, rates = off < ZENITH, {"enu_dot": np.ones((40, 3)), "enu_ddot": np.ones((40, 3))}
    stood = {"alpha_before": 300 * turn, "beta_before": np.where(enu[:, 2] < 0, 3.0, 0.2)}
    status = np.where(free, Status.SINGULAR, Status.OK)
    answers = (
        ("aim", kernels.aim(enu=enu), 0.0),
        ("aim_nearest", kernels.aim_nearest(enu=enu, **stood), stood["alpha_before"]),
        ("aim_rates", kernels.aim_rates(enu=enu, **rates), 0.0),
    )
    for kernel, found, held in answers:
        given = {"enu": enu}
        yield compare(
            "alpha is free within 1e-6 of the vertical, and nowhere else", "geometry",
            found.status, status, 0.0, given, kernel,
        )  # fmt: skip
        kept = np.where(free, found.alpha - held, 0.0)
        yield excess("a free alpha is 0, or is held", kept, given, kernel, "geometry")
    reached = answers[1][1]
    along = np.cos(turn - stood["alpha_before"])  # aside of what alpha held lets the tilt reach
    missed = np.linalg.norm(normal(reached.alpha, reached.beta) - enu, axis=1)
    yield compare(
        "the tilt follows what it can: the sun is missed by what stands aside", "SciPy", missed,
        np.where(free, off * np.abs(along), 0.0), 1e-12, {"enu": enu, **stood}, "aim_nearest",
    )  # fmt: skip
    still = np.stack(answers[2][1][2:6], axis=1)
    yield excess("nothing moves there", np.where(free[:, None], still, 0.0), given, "aim_rates")
    yield from overhead_by_the_clock(kernels)


def overhead_by_the_clock(kernels):
    """The same for the sun of a place and an hour; underfoot it is below the horizon."""
    off = np.tile([0.0, 0.999e-6, 1.001e-6], 2)
    below = np.arange(6) >= 3
    given = {
        "latitude": np.where(below, -0.3, 0.3) + off,
        "declination": np.full(6, 0.3),
        "hour_angle": np.where(below, np.pi, 0.0),
        "hour_angle_rate": np.ones(6),
    }
    found = kernels.track(**given)
    free = off < ZENITH
    up = np.where(free, Status.SINGULAR, Status.OK)
    yield compare(
        "overhead alpha is free; underfoot the sun is below the horizon", "geometry",
        found.status, np.where(below, Status.BELOW_HORIZON, up), 0.0, given, "track",
    )  # fmt: skip
    values = np.stack([found.alpha, *found[2:6]], axis=1)
    still = np.where(free[:, None], values, 0.0)
    yield excess("alpha is 0 and nothing moves there", still, given, "track", "geometry")


def horizon_by_the_sun(kernels):
    """The status changes at the limits of the day, which the kernels of the sun know."""
    from armillary_kernels import sun

    place = {name: value for name, value in shone(40).items() if "hour" not in name}
    limits = sun.day_limits(**place)
    rises = limits.status == Status.OK
    place, rise, down = chosen(place, rises), limits.rise[rises], limits.set[rises]
    for name, hour, sign in (("sunrise", rise, 1), ("sunset", down, -1)):
        for what, wanted in ((1, Status.OK), (-1, Status.BELOW_HORIZON)):
            given = {**place, "hour_angle": hour + what * sign * 1e-9, "hour_angle_rate": 1.0}
            when = "after" if what * sign > 0 else "before"
            yield compare(
                f"the sun {when} {name}", "sun", kernels.track(**given).status, wanted, 0.0,
                given, "track",
            )  # fmt: skip
