"""The drives against pinocchio, against themselves, and at every point where they must say no."""

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare
from armillary.verify.points import chosen

from .rays import (
    COUNT,
    ERRORS,
    SLIGHT,
    cos_beta,
    drives_everywhere,
    exact,
    from_axis,
    lit,
    normals,
    skies,
    tilts,
    unit,
    wanted,
)

EDGE = 1e-6
BRANCHES = (("drive", 1), ("drive_back", -1))


def stand_by_pinocchio(kernels):
    """The normal for given drive angles."""
    points = drives_everywhere()
    yield compare(
        "normal", "pinocchio", kernels.normal(**exact(**points)).n,
        normals(points, points["alpha"], points["beta"]), 1e-14, points, "normal",
    )  # fmt: skip


def chain_by_scipy(kernels):
    """The three rotations of the paper as Euler angles."""
    rotation = need("scipy.spatial.transform").Rotation
    points = drives_everywhere(37)
    points["latitude"] = np.random.default_rng(38).uniform(-1.6, 1.6, len(points["alpha"]))
    found = kernels.chain(**exact(**points))

    def euler(axes, *angles):
        return rotation.from_euler(axes, np.stack(angles, axis=-1)).as_matrix()

    for name, matrix in (
        ("L_R_E", euler("Y", points["latitude"] - np.pi / 2)),
        ("I_R_L", euler("XY", points["psi"], points["theta"])),
        ("H_R_I", euler("YXZ", points["beta"], points["chi"], points["alpha"])),
    ):
        yield compare(name, "SciPy", getattr(found, name), matrix, 1e-14, points, "chain")


def drive_by_pinocchio(kernels):
    """The drive angles put the normal where it is wanted, on the branch that was asked for."""
    points = skies()
    for kernel, sign in BRANCHES:
        found = getattr(kernels, kernel)(**exact(**points))
        ok = found.status >= 0
        some, alpha, beta = chosen(points, ok), found.alpha[ok], found.beta[ok]
        there = kernels.normal(**exact(alpha=alpha, beta=beta, **chosen_errors(some))).n
        # On the azimuth axis the free angle is 0 and the normal off by what is called free.
        regular = from_axis(some, wanted(some)) > EDGE
        given = chosen(some, regular)
        yield compare(
            "normal, drive angles, normal", "round trip", there[regular], wanted(given), 1e-14,
            given, kernel,
        )  # fmt: skip
        yield compare(
            "the drive angles put the normal between sun and receiver", "pinocchio",
            normals(some, alpha, beta)[regular], wanted(given), 1e-14, given, kernel,
        )  # fmt: skip
        yield compare(
            "where the azimuth is free, alpha is 0 and the normal within the tolerance",
            "pinocchio", normals(some, alpha, beta)[~regular], wanted(chosen(some, ~regular)),
            2 * EDGE, chosen(some, ~regular), kernel,
        )  # fmt: skip
        short = np.minimum(sign * np.cos(beta), 0.0)
        claim = f"the branch is cos(beta) {'>=' if sign > 0 else '<='} 0"
        # The cosine of a rounded right angle may be below 0 by a rounding.
        yield compare(claim, "bounds", short, 0.0, 1e-16, some, kernel)


def chosen_errors(points):
    """The misalignments alone."""
    return {name: points[name] for name in ERRORS}


def angles_come_back(kernels):
    """Drive angles, normal, drive angles: to 1e-14 over the sine of the distance to the edge."""
    points = drives_everywhere(39)
    n = kernels.normal(**exact(**points)).n
    far = np.sin(np.abs(from_axis(points, n) - np.abs(points["chi"])))
    front = np.cos(points["beta"]) > 0
    for kernel, mask in (("drive", front), ("drive_back", ~front)):
        given = chosen(points, mask)
        found = getattr(kernels, kernel)(c=n[mask], b=n[mask], **exact(**chosen_errors(given)))
        for name in ("alpha", "beta"):
            apart = np.remainder(getattr(found, name) - given[name] + np.pi, 2 * np.pi) - np.pi
            yield compare(
                f"{name} comes back, times the sine of the distance to the blind edge",
                "round trip", apart * far[mask], 0.0, 1e-14, given, kernel,
            )  # fmt: skip


# -- statuses -------------------------------------------------------------------------------------


def cones():
    """Normals in the blind cone, outside, and close to its edge on both sides; mirror on the sun.

    The angle from the azimuth axis is chi times 1 + x, so that its digits near the edge are known.
    """
    random = np.random.default_rng(41)
    tilted = tilts(4 * COUNT, 42)
    tilted["chi"][::7] = 0.0
    off = np.concatenate(
        [
            random.uniform(-SLIGHT, 1.2, 2 * COUNT),
            random.choice([-1, 1], 2 * COUNT) * 10 ** random.uniform(-14, -1, 2 * COUNT),
        ]
    )
    off = np.maximum(np.abs(tilted["chi"]) + off, 0.0) * random.choice([1, 1, 1, 0], 4 * COUNT)
    end = random.choice([-1.0, 1.0], 4 * COUNT)  # either end of the axis
    turn = random.uniform(-np.pi, np.pi, 4 * COUNT)
    frame = need("scipy.spatial.transform").Rotation.from_euler(
        "ZYX", np.stack([np.full(4 * COUNT, -np.pi / 2), -tilted["theta"], -tilted["psi"]], axis=1)
    )
    inner = [np.cos(turn) * np.sin(off), np.sin(turn) * np.sin(off), end * np.cos(off)]
    n = frame.apply(np.stack(inner, axis=1))
    return {**lit(unit(n), 43), **tilted}


def told(points):
    """What must be answered, and where rounding does not decide it."""
    n = wanted(points)
    past = from_axis(points, n) - np.abs(points["chi"])
    cosine = cos_beta(points, n)
    blind = (past < 0) & (points["chi"] != 0)
    steep = ~blind & (cosine < EDGE)
    # What rounding decides: a normal at the edge itself, or with cos(beta) at the tolerance.
    decided = (np.abs(past) > 1e-14) | (points["chi"] == 0)
    decided &= np.abs(cosine**2 - EDGE**2) > 1e-15
    return blind, steep, decided


def statuses_at_the_cone(kernels):
    """UNREACHABLE in the blind cone, SINGULAR at its edge, and nowhere else."""
    points = cones()
    blind, steep, decided = told(points)
    wanted_ = np.where(blind, Status.UNREACHABLE, np.where(steep, Status.SINGULAR, Status.OK))
    given = chosen(points, decided)
    c_dot = np.cross(points["c"], unit(np.ones(3)))
    for name in ("drive", "drive_back", "drive_sensitivity", "drive_response", "drive_rates"):
        more = {"c_dot": c_dot} if name == "drive_rates" else {}
        found = getattr(kernels, name)(**exact(**points), **more)
        yield compare(
            "the blind cone and its edge are told apart", "geometry", found.status[decided],
            wanted_[decided], 0.0, given, name,
        )  # fmt: skip
    found = kernels.drive_nearest(**exact(**points)).status
    on_axis = from_axis(points, wanted(points)) < EDGE
    clamped = np.where(blind & ~on_axis, Status.CLAMPED, Status.SINGULAR)
    yield compare(
        "in the cone the nearest pose is called clamped", "geometry", found[decided],
        np.where(blind | steep | on_axis, clamped, Status.OK)[decided], 0.0, given, "drive_nearest",
    )  # fmt: skip


def statuses_without_a_normal(kernels):
    """No normal at b = -c; NaN and infinities are refused, and so is what is no direction."""
    points = skies()
    hairs = np.random.default_rng(44).normal(size=points["c"].shape) * 1e-8
    opposite = {**points, "b": unit(hairs - points["c"])}
    for name in (
        "drive", "drive_back", "drive_nearest", "drive_first_order", "drive_second_order",
        "drive_sensitivity", "drive_response", "error_angles", "bisector",
    ):  # fmt: skip
        found = getattr(kernels, name)(**exact(**opposite)).status
        yield compare(
            "b = -c has no normal", "geometry", found, Status.UNREACHABLE, 0.0, points, name
        )
    nan, inf = (np.full_like(points["c"], v) for v in (np.nan, np.inf))
    for claim, given, status in (
        ("b of NaN is refused", {"b": nan}, Status.NOT_FINITE),
        ("c of infinity is refused", {"c": inf}, Status.NOT_FINITE),
        ("chi of NaN is refused", {"chi": nan[:, 0]}, Status.NOT_FINITE),
        ("theta of infinity is refused", {"theta": -inf[:, 0]}, Status.NOT_FINITE),
        ("what is no unit vector is refused", {"b": 0.9 * points["b"]}, Status.OUT_OF_RANGE),
        ("an elevation axis along the azimuth axis is refused", {"chi": 1.6}, Status.OUT_OF_RANGE),
    ):
        found = kernels.drive(**exact(**{**points, **given})).status
        yield compare(claim, "geometry", found, status, 0.0, points, "drive")


# -- the nearest pose -----------------------------------------------------------------------------


def nearest_by_scipy(kernels):
    """In the blind cone the pose is the one that SciPy's search over both drives ends at."""
    optimize = need("scipy.optimize")
    rotation = need("scipy.spatial.transform").Rotation
    points = cones()
    blind, _, decided = told(points)
    inside = np.flatnonzero(blind & decided & (np.abs(points["chi"]) > 0.02))[:20]
    given = {name: array[inside] for name, array in points.items()}
    found = kernels.drive_nearest(**exact(**given))
    posed = normals(given, found.alpha, found.beta)
    target = wanted(given)

    def searched(k):
        theta, psi, chi = (given[name][k] for name in ERRORS)
        base = rotation.from_euler("ZYX", [-np.pi / 2, -theta, -psi])

        def off(q):
            return base.apply(rotation.from_euler("ZXY", [-q[0], -chi, -q[1]]).apply([1, 0, 0]))

        starts = [(a, s * 1.2) for a in (0, 2, 4) for s in (-1, 1)]
        found = [
            optimize.least_squares(lambda q: off(q) - target[k], s, xtol=1e-15, ftol=1e-15,
                                   gtol=1e-15)
            for s in starts
        ]  # fmt: skip
        return np.sqrt(2 * min(f.cost for f in found))

    best = np.array([searched(k) for k in range(len(inside))])
    left = np.linalg.norm(posed - target, axis=1)
    yield compare(
        "no pose is nearer", "SciPy", np.maximum(left - best, 0.0), 0.0, 1e-12, given,
        "drive_nearest",
    )  # fmt: skip
    gap = 2 * np.sin((np.abs(given["chi"]) - from_axis(given, target)) / 2)
    yield compare(
        "the nearest pose is at the edge, at the same azimuth", "geometry", left, gap, 1e-13, given,
        "drive_nearest",
    )  # fmt: skip


# -- with the sun by the clock --------------------------------------------------------------------


def track_by_erfa(kernels):
    """The mirror that follows ERFA's sun throws it on the receiver."""
    erfa = need("erfa")
    random = np.random.default_rng(45)
    place = {
        "latitude": random.uniform(-1.5, 1.5, COUNT),
        "declination": random.uniform(-0.41, 0.41, COUNT),
        "hour_angle": random.uniform(-np.pi, np.pi, COUNT),
        "b": unit(random.normal(size=(COUNT, 3))),
        **tilts(COUNT, 46),
    }
    azimuth, elevation = erfa.hd2ae(place["hour_angle"], place["declination"], place["latitude"])
    north, east, up = np.moveaxis(erfa.s2c(azimuth, elevation), -1, 0)
    c = np.stack([east, north, up], axis=1)
    found = kernels.track(**exact(**place))
    clear = (found.status == Status.OK) & (np.linalg.norm(c + place["b"], axis=1) > 0.1)
    n = normals(place, found.alpha, found.beta)
    beam = 2 * np.sum(c * n, axis=1, keepdims=True) * n - c
    yield compare(
        "the beam of the tracked sun goes to the receiver", "ERFA, pinocchio", beam[clear],
        place["b"][clear], 1e-13, chosen(place, clear), "track",
    )  # fmt: skip
