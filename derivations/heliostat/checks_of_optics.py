"""Normal, beam, target and miss by plain linear algebra."""

import numpy as np

from armillary import Status
from armillary.verify.measured import compare
from armillary.verify.points import chosen

from .rays import COUNT, drives_everywhere, exact, lit, normals, skies, tilts, unit


def optics_by_householder(kernels):
    """The mirror as a reflection matrix."""
    points = skies()
    n = kernels.bisector(**exact(**points)).n
    yield compare(
        "the normal has length 1", "NumPy", np.linalg.norm(n, axis=1), 1.0, 1e-15, points,
        "bisector",
    )  # fmt: skip
    through = np.eye(3) - 2 * n[:, :, None] * n[:, None, :]
    thrown = -np.einsum("kij,kj->ki", through, points["c"])
    yield compare(
        "the bisector sends the sun to the receiver", "Householder", thrown, points["b"], 1e-14,
        points, "bisector",
    )  # fmt: skip
    given = {"c": points["c"], "n": n}
    stand = {name: points[name] for name in ("theta", "psi", "chi")}
    yield compare(
        "reflected direction", "Householder", kernels.reflect(**exact(**given, **stand)).b, thrown,
        1e-14, given, "reflect",
    )  # fmt: skip


def beam_by_pinocchio(kernels):
    """The beam of given drive angles: the sun's direction turned half round the normal."""
    points = drives_everywhere(51)
    n = normals(points, points["alpha"], points["beta"])
    points["c"] = lit(n, 52)["c"]
    half_turn = 2 * n[:, :, None] * n[:, None, :] - np.eye(3)
    yield compare(
        "beam", "pinocchio", kernels.beam(**exact(**points)).b,
        np.einsum("kij,kj->ki", half_turn, points["c"]), 1e-14, points, "beam",
    )  # fmt: skip


def receivers():
    """Mirrors, drive angles a little off, and aim points from 1 m to 1 km away."""
    random = np.random.default_rng(53)
    n = unit(random.normal(size=(COUNT, 3)))
    points = {**lit(n, 54), **tilts(COUNT, 55)}
    points["position"] = random.uniform(-100, 100, (COUNT, 3))
    away = 10 ** random.uniform(0, 3, (COUNT, 1))
    points["aim_point"] = points["position"] + away * points["b"]
    return points, random


def miss_by_intersection(kernels):
    """Where ray and plane meet, by solving three equations."""
    points, random = receivers()
    place = {name: a for name, a in points.items() if name not in ("b", "c")}
    seen = kernels.target(**exact(**place))
    way = points["aim_point"] - points["position"]
    yield compare(
        "distance", "NumPy", seen.distance, np.linalg.norm(way, axis=1), 1e-15, place, "target"
    )
    yield compare("direction", "NumPy", seen.b, unit(way), 1e-15, place, "target")
    stand = {name: points[name] for name in ("theta", "psi", "chi")}
    aimed = kernels.drive(**exact(c=points["c"], b=seen.b, **stand))
    ok = aimed.status == Status.OK
    off = random.choice([0.0, 1e-6, 1e-3, 0.3], (2, COUNT)) * random.normal(size=(2, COUNT))
    given = {name: a for name, a in points.items() if name != "b"}
    given |= {"alpha": aimed.alpha + off[0], "beta": aimed.beta + off[1]}
    given, way = chosen(given, ok), way[ok]
    found = kernels.miss(**exact(**given))
    n = normals(given, given["alpha"], given["beta"])
    ray = 2 * np.sum(given["c"] * n, axis=1, keepdims=True) * n - given["c"]
    astray = np.sum(ray * way, axis=1) <= 1e-6 * np.linalg.norm(way, axis=1)
    astray |= np.sum(given["c"] * n, axis=1) <= 0
    yield compare(
        "a beam that goes elsewhere is told", "geometry", found.status,
        np.where(astray, Status.UNREACHABLE, Status.OK), 0.0, given, "miss",
    )  # fmt: skip
    wanted = [_landed(r, w) for r, w in zip(ray[~astray], way[~astray], strict=True)]
    reach = np.maximum(np.linalg.norm(way[~astray], axis=1), wanted)
    yield compare(
        "miss, relative to the distance", "numpy.linalg.solve", found.miss[~astray] / reach,
        np.array(wanted) / reach, 1e-12, chosen(given, ~astray), "miss",
    )  # fmt: skip
    turned = {**given, "alpha": given["alpha"] + np.pi, "beta": -given["beta"]}
    facing = np.sum(given["c"] * normals(turned, turned["alpha"], turned["beta"]), axis=1)
    dark = chosen(turned, facing < 0)
    yield compare(
        "a mirror that turns its back to the sun is told", "geometry",
        kernels.miss(**exact(**dark)).status, Status.UNREACHABLE, 0.0, dark, "miss",
    )  # fmt: skip


def _landed(ray, way):
    """Distance from the aim point to where the ray meets the plane through it."""
    plane = np.linalg.svd(way[None, :])[2][1:]  # two directions across the way
    solved = np.linalg.solve(np.stack([ray, *plane], axis=1), way)
    return float(np.hypot(*solved[1:]))


def on_the_mirror(kernels):
    """An aim point on the mirror has no direction."""
    points, _ = receivers()
    place = {name: points[name] for name in ("position", "theta", "psi", "chi")}
    found = kernels.target(**exact(**place, aim_point=points["position"]))
    yield compare(
        "distance 0 is unreachable", "geometry", found.status, Status.UNREACHABLE, 0.0, place,
        "target",
    )  # fmt: skip
