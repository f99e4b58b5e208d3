"""Mirrors, suns and receivers that the heliostat's kernels are tried on."""

from itertools import product

import numpy as np

from armillary.verify.engines.rigid import Fixed, Mechanism, Revolute
from armillary.verify.points import directions, rows_of

COUNT = 400
SLIGHT = 0.3  # rad, the largest misalignment tried
TURN = 2 * np.pi
ERRORS = ("theta", "psi", "chi")
DOWN, NORTH, EAST, WEST = (0, 0, -1), (-1, 0, 0), (0, 1, 0), (0, -1, 0)  # in south, east, up
HAIRS = (0.0, 1e-3, -1e-6, 1e-9)


def exact(**given):
    """Encoders without an error, and whatever is given."""
    return {"alpha_0": 0.0, "beta_0": 0.0, "collimation": 0.0, **given}


def build(point):
    """The stand in pinocchio; its tip is the mirror's frame, its base east, north and up.

    The leans are joints too, so that the Jacobian tells what they do: theta, psi, alpha, chi, beta.
    """
    return Mechanism(
        [
            Fixed(rpy=(0, 0, -np.pi / 2)),
            Revolute(WEST),
            Revolute(NORTH),
            Revolute(DOWN),
            Revolute(NORTH),
            Revolute(WEST),
        ]
    )


JOINTS = ("theta", "psi", "alpha", "chi", "beta")


def poses(points, alpha, beta):
    """Rotations of the mirror by pinocchio, (n, 3, 3)."""
    turned = {**points, "alpha": alpha, "beta": beta}
    q = np.stack(np.broadcast_arrays(*(turned[name] for name in JOINTS)), axis=-1)
    return build(None).pose(q)[:, :3, :3]


def normals(points, alpha, beta):
    """Normals by pinocchio."""
    return poses(points, alpha, beta)[:, :, 0]


def leaning_axis(points):
    """The azimuth axis in east, north and up, by the angles it leans by."""
    theta, psi = points["theta"], points["psi"]
    parts = (np.sin(psi), np.sin(theta) * np.cos(psi), np.cos(theta) * np.cos(psi))
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


def from_axis(points, n):
    """Angle between a direction and the azimuth axis's line, in [0, pi/2], with all its digits."""
    axis = leaning_axis(points)
    sine = np.linalg.norm(np.cross(axis, n), axis=-1)
    return np.arctan2(sine, np.abs(np.sum(axis * n, axis=-1)))


def unit(v):
    """Vectors of length 1."""
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def tilts(n, seed):
    """Random misalignments of every sign."""
    random = np.random.default_rng(seed)
    return {name: random.uniform(-SLIGHT, SLIGHT, n) for name in ERRORS}


def lit(n, seed):
    """A sun and a receiver for each normal; every fourth receiver is the sun itself."""
    random = np.random.default_rng(seed)
    across = unit(np.cross(n, random.normal(size=n.shape)))
    incidence = random.uniform(0, 1.3, (len(n), 1))
    incidence[::4] = 0.0
    along, aside = n * np.cos(incidence), across * np.sin(incidence)
    c = unit(along + aside)
    b = np.where(incidence == 0, c, unit(along - aside))
    return {"c": c, "b": b}


def awkward_normals():
    """Zenith, nadir and the horizon to all sides, and hairs off each."""
    turns = np.arange(-2, 3) * np.pi / 2
    found = [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0)]
    for turn, hair in product(turns, HAIRS):
        for height in (hair, np.pi / 4, np.pi / 2 - hair, hair - np.pi / 2):
            level = np.cos(height)
            found.append((np.sin(turn) * level, np.cos(turn) * level, np.sin(height)))
    return np.array(found)


def skies():
    """Suns, receivers and stands: random ones, and the awkward with zero and full misalignment."""
    n = directions(COUNT, seed=31)
    at_random = {**lit(n, 32), **tilts(len(n), 33)}
    normal = awkward_normals()
    corners = np.array(list(product((-SLIGHT, 0.0, SLIGHT), repeat=3)))
    many = np.repeat(normal, len(corners), axis=0)
    tilted = np.tile(corners, (len(normal), 1))
    awkward = {**lit(many, 34), **dict(zip(ERRORS, tilted.T, strict=True))}
    return {name: np.concatenate([at_random[name], awkward[name]]) for name in at_random}


def wanted(points):
    """The direction that sun and receiver ask for."""
    return unit(points["b"] + points["c"])


def cos_beta(points, n):
    """Cosine of the elevation drive for a normal, 0 in the blind cone, with all its digits."""
    t, chi = from_axis(points, n), np.abs(points["chi"])
    product_ = np.sin(t - chi) * np.sin(t + chi)
    return np.sqrt(np.maximum(product_, 0.0)) / np.cos(chi)


def drives_everywhere(seed=35):
    """Drive angles all over and near the edge of the blind cone, with random misalignments."""
    random = np.random.default_rng(seed)
    near = 10 ** random.uniform(-5, 0, COUNT)
    side = random.choice([-1.0, 1.0], COUNT)
    return {
        "alpha": random.uniform(-np.pi, np.pi, 2 * COUNT),
        "beta": np.append(random.uniform(-np.pi, np.pi, COUNT), side * (np.pi / 2 - near)),
        **tilts(2 * COUNT, seed + 1),
    }


def rows(points):
    """The points one by one."""
    return list(rows_of(points))
