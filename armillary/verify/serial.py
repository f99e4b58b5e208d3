"""What every serial mechanism owes: to move, and to aim, as pinocchio's model of it does.

What needs no engine is compared first, so that it is compared where pinocchio is missing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from armillary.derivation.status import Status
from armillary.verify.engines.rigid import Mechanism
from armillary.verify.measured import Measured, compare
from armillary.verify.points import chosen, rows_of

Array = NDArray[np.float64]
Points = Mapping[str, Array]
Build = Callable[[Mapping[str, float]], Mechanism]

TOLERANCE = 1e-13
AIMED = 1e-14
FREE = 2e-6  # twice the distance from the singularity within which an angle is called free
AXES = ("first", "second", "third")
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
    still = _still(points)
    yield _displacement(kernels, drives, points)
    models = [build(row) for row in rows_of(points)]
    q, q_dot = _stacked(points, drives), _stacked(points, [f"{name}_dot" for name in drives])

    pose = np.stack([m.pose(at) for m, at in zip(models, q, strict=True)])
    yield compare("pose", "pinocchio", kernels.pose(**still).M, pose, TOLERANCE, still, "pose")
    columns = np.stack([m.jacobian(at) for m, at in zip(models, q, strict=True)])
    yield compare(
        "Jacobian", "pinocchio", kernels.jacobian(**still).J, columns, TOLERANCE, still, "jacobian"
    )
    found = kernels.velocity(**points)
    for name, (claim, wanted) in _velocities(models, q, q_dot).items():
        yield compare(
            claim, "pinocchio", getattr(found, name), wanted, TOLERANCE, points, "velocity"
        )


def aim_checks(
    kernels: Any,
    build: Build,
    drives: Sequence[str],
    points: Points,
    *,
    axis: int,
    branch: tuple[str, Callable[[Any], Array]],
) -> Iterator[Measured]:
    """The drive angles of `aim` put one axis of the tip on the sun, on the branch it promises.

    Args:
        kernels: the generated module of the system, with `aim` and `pose`.
        build: makes the mechanism from the parameters of one point.
        drives: names of the drives, in the order of the mechanism's moving joints.
        points: the parameters, and `enu`, the direction to the sun, as arrays.
        axis: the tip's axis that is aimed: 0, 1 or 2.
        branch: what is claimed of the angles, and from what `aim` returns, what must not be
            negative where it holds.
    """
    aimed = kernels.aim(**points)
    angles = {name: np.asarray(getattr(aimed, name)) for name in drives}
    regular = aimed.status == Status.OK
    given = {name: a for name, a in points.items() if name != "enu"}

    claim, margin = branch
    short = np.minimum(margin(aimed), 0.0)
    yield compare(f"the branch is {claim}", "bounds", short, 0.0, 0.0, points, "aim")
    posed = np.asarray(kernels.pose(**angles, **given).M)[:, :3, axis]
    yield _faces("aim and pose undo each other", "round trip", posed, points, regular, AIMED)
    models = [build(row) for row in rows_of(points)]
    drawn = zip(models, _stacked(angles, drives), strict=True)
    faced = np.stack([m.pose(q)[:3, axis] for m, q in drawn])
    claim = f"the aimed {AXES[axis]} axis is on the sun"
    yield _faces(claim, "pinocchio", faced, points, regular, AIMED)
    claim = "where an angle is free it is there within the tolerance of the singularity"
    yield _faces(claim, "pinocchio", faced, points, ~regular, FREE)


def _faces(
    claim: str, engine: str, axes: Array, points: Points, mask: NDArray[np.bool_], tolerance: float
) -> Measured:
    """Axes that are on the sun wherever the mask holds."""
    some = chosen(points, mask)
    return compare(claim, engine, axes[mask], some["enu"], tolerance, some, "aim")


def _still(points: Points) -> dict[str, Array]:
    """The points without the rates."""
    return {name: a for name, a in points.items() if not name.endswith("_dot")}


def _stacked(points: Points, names: Sequence[str]) -> Array:
    """Some of the values, a column each."""
    return np.stack([points[name] for name in names], axis=1)


def _velocities(
    models: Sequence[Mechanism], q: Array, q_dot: Array
) -> dict[str, tuple[str, Array]]:
    """What `velocity` returns, by name: in words, and as pinocchio has it."""
    triples = list(zip(models, q, q_dot, strict=True))
    motion = np.stack([m.velocity(at, by) for m, at, by in triples])
    body = np.stack([m.body_velocity(at, by) for m, at, by in triples])
    origin = np.stack([m.pose(at)[:3, 3] for m, at, _ in triples])
    linear, angular = motion[:, :3], motion[:, 3:]
    at_base = linear - np.cross(angular, origin)
    matrix = np.zeros((len(q), 4, 4))
    matrix[:, :3, :3] = np.cross(angular[:, None, :], np.eye(3)).swapaxes(1, 2)
    matrix[:, :3, 3] = at_base
    return {
        "v_origin": ("velocity of the origin", linear),
        "Omega_space": ("angular velocity in the base frame", angular),
        "Omega_body": ("angular velocity in the moving frame", body[:, 3:]),
        "v_spatial": ("velocity of the point at the base origin", at_base),
        "V_space": ("velocity matrix", matrix),
    }


def _displacement(kernels: Any, drives: Sequence[str], points: Points) -> Measured:
    """The velocity adds up to the way travelled, over a second of all drives running."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    times, weights = _DURATION * (nodes + 1) / 2, _DURATION * weights / 2

    def at(time: Array | float) -> dict[str, Array]:
        moved = {name: points[name] + time * points[f"{name}_dot"] for name in drives}
        return {**points, **moved}

    def position(time: float) -> Array:
        return np.asarray(kernels.pose(**_still(at(time))).M)[:, :3, 3]

    speeds = [np.asarray(kernels.velocity(**at(time)).v_origin) for time in times]
    way = np.tensordot(weights, np.stack(speeds), axes=1)
    return compare(
        "the velocity adds up to the way travelled in a second", "balance",
        way, position(_DURATION) - position(0.0), 1e-12, points, "velocity",
    )  # fmt: skip
