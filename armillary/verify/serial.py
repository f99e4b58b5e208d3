"""What every serial mechanism owes: to move as pinocchio's model of it moves."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from armillary.verify.engines.rigid import Mechanism
from armillary.verify.measured import Measured, compare
from armillary.verify.points import count, rows_of

Array = NDArray[np.float64]
Points = Mapping[str, Array]
Build = Callable[[Mapping[str, float]], Mechanism]

TOLERANCE = 1e-13
_DURATION, _NODES = 1.0, 24


def serial_checks(
    kernels: Any, build: Build, drives: Sequence[str], points: Points
) -> Iterator[Measured]:
    """Pose, Jacobian and velocity of the tip against a mechanism built by hand.

    Args:
        kernels: the generated module of the system, with `pose`, `jacobian` and `velocity`.
        build: makes the mechanism from the parameters of one point.
        drives: names of the drives, in the order of the mechanism's moving joints.
        points: parameters, drives, and the rate `<drive>_dot` of each, as arrays (n,).
    """
    models = [build(row) for row in rows_of(points)]
    still = {name: a for name, a in points.items() if not name.endswith("_dot")}
    q = np.stack([points[name] for name in drives], axis=1)
    q_dot = np.stack([points[f"{name}_dot"] for name in drives], axis=1)
    pairs = list(zip(models, q, strict=True))
    triples = list(zip(models, q, q_dot, strict=True))

    pose = np.stack([m.pose(at) for m, at in pairs])
    yield compare("pose", "pinocchio", kernels.pose(**still).M, pose, TOLERANCE, still, "pose")
    columns = np.stack([m.jacobian(at) for m, at in pairs])
    yield compare(
        "Jacobian", "pinocchio", kernels.jacobian(**still).J, columns, TOLERANCE, still, "jacobian"
    )
    motion = np.stack([m.velocity(at, by) for m, at, by in triples])
    body = np.stack([m.body_velocity(at, by) for m, at, by in triples])
    linear, angular = motion[:, :3], motion[:, 3:]
    at_base = linear - np.cross(angular, pose[:, :3, 3])
    matrix = np.zeros((count(points), 4, 4))
    matrix[:, :3, :3] = np.cross(angular[:, None, :], np.eye(3)).swapaxes(1, 2)
    matrix[:, :3, 3] = at_base
    found = kernels.velocity(**points)
    for name, claim, wanted in (
        ("v_origin", "velocity of the origin", linear),
        ("Omega_space", "angular velocity in the base frame", angular),
        ("Omega_body", "angular velocity in the moving frame", body[:, 3:]),
        ("v_spatial", "velocity of the point at the base origin", at_base),
        ("V_space", "velocity matrix", matrix),
    ):
        yield compare(
            claim, "pinocchio", getattr(found, name), wanted, TOLERANCE, points, "velocity"
        )
    yield _displacement(kernels, drives, points)


def _displacement(kernels: Any, drives: Sequence[str], points: Points) -> Measured:
    """The velocity adds up to the way travelled, over a second of all drives running."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    times, weights = _DURATION * (nodes + 1) / 2, _DURATION * weights / 2

    def at(time: Array | float) -> dict[str, Array]:
        moved = {name: points[name] + time * points[f"{name}_dot"] for name in drives}
        return {**points, **moved}

    def position(time: float) -> Array:
        still = {name: a for name, a in at(time).items() if not name.endswith("_dot")}
        return np.asarray(kernels.pose(**still).M)[:, :3, 3]

    speeds = [np.asarray(kernels.velocity(**at(time)).v_origin) for time in times]
    way = np.tensordot(weights, np.stack(speeds), axes=1)
    return compare(
        "the velocity adds up to the way travelled in a second", "balance",
        way, position(_DURATION) - position(0.0), 1e-12, points, "velocity",
    )  # fmt: skip
