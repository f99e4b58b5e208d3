"""Rotation of a single axis: pvlib over a year, a search, the trough's own frame, awkward suns."""

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare

ALLOWED = np.radians(1e-9)
BLUNT = np.radians(0.05)  # closer to 0 than this the arc cosines of pvlib lose digits
HOURS = 8760
# Latitude and longitude in degrees: the equator, both tropics and polar circles, near the pole.
SITES = (
    (0.0, -78.5), (23.4, 72.6), (-23.4, 15.0), (35.0, -115.0), (-34.6, -58.4), (47.0, 8.0),
    (59.9, 30.3), (66.6, 25.7), (-66.6, 140.0), (89.0, 0.0),
)  # fmt: skip
# Azimuth and tilt in degrees.
AXES = ((0.0, 0.0), (90.0, 20.0), (180.0, 20.0), (270.0, 60.0), (143.0, 60.0))
# Ground cover ratio, slope across the axes, least and greatest rotation, in degrees; site by site.
SETTINGS = (
    (0.4, 0.0, -180.0, 180.0), (0.3, 12.0, -60.0, 60.0), (0.5, -17.0, -45.0, 70.0),
    (0.9, 8.0, 10.0, 55.0), (0.25, -5.0, -70.0, -15.0),
)  # fmt: skip


def setting(values):
    """What the kernel hears, of the numbers in degrees above."""
    names = ("cross_axis_tilt", "rotation_min", "rotation_max")
    angles = dict(zip(names, np.radians(values[1:]), strict=True))
    return {"gcr": np.float64(values[0]), **angles}


def mount(azimuth, tilt):
    """The axis as the kernel hears it."""
    return {"axis_azimuth": np.radians(azimuth), "axis_tilt": np.radians(tilt)}


def suns():
    """Zenith angle and azimuth of the sun by pvlib in degrees, every hour of a year: (sites, n)."""
    pandas, solar = need("pandas"), need("pvlib.solarposition")
    hours = pandas.date_range("2026-01-01 00:30", periods=HOURS, freq="h", tz="UTC")
    found = [solar.ephemeris(hours, *site) for site in SITES]
    return [(90.0 - f["elevation"].to_numpy(), f["azimuth"].to_numpy()) for f in found]


def direction(zenith, azimuth):
    """East, north, up; angles in degrees."""
    zenith, azimuth = np.radians(zenith), np.radians(azimuth)
    across = np.sin(zenith)
    return np.stack([across * np.sin(azimuth), across * np.cos(azimuth), np.cos(zenith)], axis=-1)


def axis_frame(azimuth, tilt):
    """SciPy's rotation that carries the frame of the axis to East-North-Up; angles in radians."""
    rotation = need("scipy.spatial.transform").Rotation
    turns = np.stack([-np.broadcast_to(azimuth, np.shape(tilt)), -np.asarray(tilt)], axis=-1)
    return rotation.from_euler("ZX", turns)


def about_axis(turn):
    """SciPy's rotation about y by angles (n,)."""
    return need("scipy.spatial.transform").Rotation.from_rotvec(np.outer(turn, [0.0, 1.0, 0.0]))


def between(a, b):
    """Angle between unit vectors, sharp at 0 and at a half turn."""
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), np.sum(a * b, axis=-1))


def year(kernels, kernel, backtrack, settings=SETTINGS):
    """Every site, axis and hour, by the kernel and by pvlib: a dictionary of arrays."""
    tracking = need("pvlib.tracking")
    collected = []
    for k, (zenith, azimuth) in enumerate(suns()):
        chosen = settings[k % len(settings)]
        for axis in AXES:
            given = {"enu": direction(zenith, azimuth), **mount(*axis)}
            more = {"backtrack": False, "max_angle": 180.0}
            if backtrack:
                given |= setting(chosen)
                more = {"gcr": chosen[0], "cross_axis_tilt": chosen[1], "max_angle": chosen[2:]}
            found = getattr(kernels, kernel)(**given)
            told = tracking.singleaxis(zenith, azimuth, axis[1], axis[0], **more)
            turn = tracking.singleaxis(zenith, azimuth, axis[1], axis[0], 180.0, backtrack=False)
            collected.append({
                **{n: np.broadcast_to(v, (HOURS, *np.shape(v)[1:])) for n, v in given.items()},
                "rotation": found.rotation, "incidence": found.incidence, "status": found.status,
                **{n: np.radians(told[n]) for n in ("tracker_theta", "aoi", "surface_tilt")},
                "ideal": np.radians(turn["tracker_theta"]),
            })  # fmt: skip
    return {name: np.concatenate([c[name] for c in collected]) for name in collected[0]}


def inputs_of(points, mask, backtrack):
    """The inputs among what `year` collected."""
    names = ["enu", "axis_azimuth", "axis_tilt"]
    if backtrack:
        names += ["gcr", "cross_axis_tilt", "rotation_min", "rotation_max"]
    return {name: points[name][mask] for name in names}


def year_by_pvlib(kernels):
    """Rotation and incidence without backtracking."""
    yield from _year(kernels, "single_axis", False, "")


def backtracking_by_pvlib(kernels):
    """With backtracking, on slopes of either sign, between limits that are not symmetric."""
    yield from _year(kernels, "single_axis_backtrack", True, ", backtracking")


def backtracking_without_limits(kernels):
    """Every cover and slope at every site, with no limit at which rotations agree by themselves."""
    kernel = "single_axis_backtrack"
    for cover, slope, *_ in SETTINGS:
        points = year(kernels, kernel, True, [(cover, slope, -180.0, 180.0)])
        day = np.isfinite(points["tracker_theta"])
        yield compare(
            f"rotation over a year, cover {cover:g}, slope {slope:g} degrees, no limits", "pvlib",
            points["rotation"][day], points["tracker_theta"][day], ALLOWED,
            inputs_of(points, day, True), kernel, relative=False, turn=True,
        )  # fmt: skip


def _year(kernels, kernel, backtrack, told):
    points = year(kernels, kernel, backtrack)
    day = np.isfinite(points["tracker_theta"])
    at = inputs_of(points, day, backtrack)
    yield compare(
        f"rotation over a year at {len(SITES)} sites, {len(AXES)} axes{told}", "pvlib",
        points["rotation"][day], points["tracker_theta"][day], ALLOWED, at, kernel,
        relative=False, turn=True,
    )  # fmt: skip
    frames = axis_frame(at["axis_azimuth"], at["axis_tilt"])
    normal = (frames * about_axis(points["tracker_theta"][day])).apply([0.0, 0.0, 1.0])
    yield compare(
        f"incidence at pvlib's rotation{told}", "SciPy", points["incidence"][day],
        between(normal, at["enu"]), ALLOWED, at, kernel, relative=False,
    )  # fmt: skip
    sharp = day & (points["aoi"] > BLUNT) & (points["surface_tilt"] > BLUNT)
    yield compare(
        f"incidence where pvlib's arc cosines are sharp{told}", "pvlib",
        points["incidence"][sharp], points["aoi"][sharp], ALLOWED,
        inputs_of(points, sharp, backtrack), kernel, relative=False,
    )  # fmt: skip
    everywhere = inputs_of(points, slice(None), backtrack)
    night = points["status"] == Status.BELOW_HORIZON
    answered = np.isfinite(points["rotation"]) & np.isfinite(points["incidence"])
    yield compare(
        f"a status tells where pvlib has no number, and every answer is finite{told}", "pvlib",
        (night != ~day) | ~answered, 0.0, 0.0, everywhere, kernel,
    )  # fmt: skip
    if backtrack:
        yield from _arc_cosines(points, day, kernel)


def _arc_cosines(points, day, kernel):
    """Backtracking's own arc cosine has no value at noon, nor with the sun under the rows."""
    from_rows = np.cos(points["ideal"] - points["cross_axis_tilt"])
    apart = from_rows / (points["gcr"] * np.cos(points["cross_axis_tilt"]))
    for told, of in (("a row is not shaded", apart > 1), ("the sun is under the rows", apart < 0)):
        met = day & of
        yield compare(
            f"finite where {told}: pvlib's issues 656 and 824", "bounds",
            ~np.isfinite(points["rotation"][met]), 0.0, 0.0, inputs_of(points, met, True), kernel,
        )  # fmt: skip


# -- without pvlib -------------------------------------------------------------------------------


def anywhere(count, seed):
    """Suns above the horizon over axes of any azimuth and tilt."""
    random = np.random.default_rng(seed)
    enu = random.normal(size=(count, 3))
    enu /= np.linalg.norm(enu, axis=1, keepdims=True)
    enu[:, 2] = np.abs(enu[:, 2])
    turn = random.uniform(0.0, 2 * np.pi, count)
    return {"enu": enu, "axis_azimuth": turn, "axis_tilt": random.uniform(0.0, np.pi / 2, count)}


def least_by_search(kernels):
    """No rotation comes closer to the sun."""
    optimize = need("scipy.optimize")
    points = anywhere(60, 71)
    frames = axis_frame(points["axis_azimuth"], points["axis_tilt"])
    grid = np.linspace(-np.pi, np.pi, 33)
    least = []
    for enu, frame in zip(points["enu"], frames, strict=True):

        def miss(turn, enu=enu, frame=frame):
            return between((frame * about_axis(turn)).apply([0.0, 0.0, 1.0]), enu)[0]

        near = grid[np.argmin([miss(turn) for turn in grid])]
        step = grid[1] - grid[0]
        search = optimize.minimize_scalar(
            miss, bounds=(near - step, near + step), method="bounded", options={"xatol": 1e-10}
        )
        least.append(search.fun)
    found = kernels.single_axis(**points).incidence
    yield compare(
        "the incidence is the least of all rotations", "SciPy", found, least, 1e-9, points,
        "single_axis",
    )  # fmt: skip


def theta_of_the_trough(kernels):
    """The trough's z along the axis, turned by theta: it faces the sun, and container 1 sinks."""
    rotation = need("scipy.spatial.transform").Rotation
    points = anywhere(300, 72)
    azimuth, tilt = points["axis_azimuth"], points["axis_tilt"]
    down = direction(90.0 + np.degrees(tilt), np.degrees(azimuth))
    up = np.array([0.0, 0.0, 1.0]) - down * down[:, 2:]
    up /= np.linalg.norm(up, axis=1, keepdims=True)
    xi = np.cross(up, down)
    theta = kernels.single_axis(**points).rotation
    turn = rotation.from_rotvec(theta[:, None] * down)
    eta, side = turn.apply(up), turn.apply(xi)
    sun = points["enu"]
    left = np.stack([np.sum(sun * side, axis=1), np.minimum(np.sum(sun * eta, axis=1), 0)], axis=1)
    yield compare(
        "turned by it as theta the trough faces the sun: none to its xi, none behind", "SciPy",
        left, 0.0, 1e-13, points, "single_axis",
    )  # fmt: skip
    yield compare(
        "and its xi rises by the sine of theta, away from container 1", "SciPy",
        side[:, 2], np.sin(theta) * np.cos(tilt), 1e-13, points, "single_axis",
    )  # fmt: skip


QUARTER = np.pi / 2
# Sun, azimuth and tilt of the axis; rotation, incidence and status that must come of it.
AWKWARD = (
    ((0, 0, 1), 0.0, 0.0, 0.0, 0.0, Status.OK),
    ((0, 0, 1), 2.0, QUARTER, 0.0, QUARTER, Status.SINGULAR),
    ((0, 1, 0), 0.0, 0.0, 0.0, QUARTER, Status.SINGULAR),
    ((0, -1, 0), 0.0, 0.0, 0.0, QUARTER, Status.SINGULAR),
    ((1, 0, 0), -QUARTER, 0.0, 0.0, QUARTER, Status.SINGULAR),
    ((1, 0, 0), 0.0, 0.0, QUARTER, 0.0, Status.OK),
    ((-1, 0, 0), 0.0, 0.0, -QUARTER, 0.0, Status.OK),
    ((1, 0, 0), np.pi, 0.0, -QUARTER, 0.0, Status.OK),
    ((0, -1, 0), 0.0, QUARTER, np.pi, 0.0, Status.OK),
    ((0, 0, -1), 0.0, 0.0, np.pi, 0.0, Status.BELOW_HORIZON),
    ((0, 0, -1), 0.0, QUARTER, 0.0, QUARTER, Status.BELOW_HORIZON),
)


def awkward_suns(kernels):
    """Zenith and nadir, in the line of the axis, on the horizon; an axis that is vertical."""
    enu, azimuth, tilt, rotation, incidence, status = (
        np.array(column, dtype=float) for column in zip(*AWKWARD, strict=True)
    )
    points = {"enu": enu, "axis_azimuth": azimuth, "axis_tilt": tilt}
    found = kernels.single_axis(**points)
    wanted = np.stack([rotation, incidence], axis=1)
    yield compare(
        "zenith, nadir, horizon, the line of the axis, a vertical axis", "by hand",
        np.stack([found.rotation, found.incidence], axis=1), wanted, 1e-13, points, "single_axis",
        turn=True,
    )  # fmt: skip
    yield compare(
        "and what is told of them", "by hand", found.status, status, 0.0, points, "single_axis"
    )
    bearing = np.linspace(-3.1, 3.1, 63)
    circle = {"enu": direction(np.full(63, 70.0), np.degrees(bearing)), "axis_azimuth": 0.0}
    circle["axis_tilt"] = QUARTER
    found = kernels.single_axis(**circle)
    yield compare(
        "about a vertical axis it turns with the sun's azimuth, and misses its elevation",
        "by hand", np.stack([found.rotation, found.incidence], axis=1),
        np.stack([bearing, np.full(bearing.shape, np.radians(20.0))], axis=1), 1e-13, circle,
        "single_axis",
    )  # fmt: skip
