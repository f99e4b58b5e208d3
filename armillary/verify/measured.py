"""What a check found: the worst difference, where it was met, and what was allowed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

Point = dict[str, float | list[float]]


@dataclass(frozen=True)
class Measured:
    """One comparison over many points.

    Attributes:
        name: what is claimed, in words.
        engine: what it was compared with ("pinocchio", "SymPy", "dual numbers", ...).
        kernel: the kernel compared, if it is one.
        points: number of points.
        worst: the largest difference (NaN when a value was missing: that never passes).
        tolerance: what is allowed.
        at: the inputs at the worst point.
        why: what to know about this check, in a sentence; the residual when it fails.
    """

    name: str
    engine: str
    kernel: str | None
    points: int
    worst: float
    tolerance: float
    at: Point = field(default_factory=dict)
    why: str = ""

    @property
    def passed(self) -> bool:
        """Whether the worst difference is allowed; a NaN is not."""
        return bool(self.worst <= self.tolerance)


def exceeds(error: float, worst: float) -> bool:
    """Whether an error is worse than the worst so far; nothing is worse than NaN."""
    return not math.isnan(worst) and not error <= worst


@dataclass(frozen=True)
class Skipped:
    """A check that could not run here, for want of an engine."""

    name: str
    engine: str
    why: str


def compare(
    name: str,
    engine: str,
    found: Any,
    wanted: Any,
    tolerance: float,
    inputs: Mapping[str, Any],
    kernel: str | None = None,
    relative: bool = True,
    turn: bool = False,
) -> Measured:
    """Compare two arrays of shape (n, ...) point by point.

    Args:
        found: what the kernel returned.
        wanted: what the engine says, broadcastable to the same shape.
        tolerance: largest difference allowed.
        inputs: the inputs, arrays (n,), (n, 3) or (n, 3, 3), or scalars; they name the worst point.
        relative: divide by the largest entry of `wanted` at that point, where that is above 1;
            a pose whose arm is 1 mm long is thus held to absolute errors, as its rotation is.
        turn: the values are angles, equal when they differ by whole turns.

    Raises:
        ValueError: if the shapes do not fit, or there is no point to compare.
    """
    found, wanted = np.asarray(found, dtype=float), np.asarray(wanted, dtype=float)
    found, wanted = np.broadcast_arrays(np.atleast_1d(found), np.atleast_1d(wanted))
    if found.size == 0:
        raise ValueError(f"{name}: there is no point to compare")
    difference = np.abs(found - wanted)
    if turn:
        difference = np.abs(np.remainder(found - wanted + np.pi, 2 * np.pi) - np.pi)
    points = len(found)
    worst_of = difference.reshape(points, -1).max(axis=1)
    if relative:
        worst_of = worst_of / np.maximum(np.abs(wanted).reshape(points, -1).max(axis=1), 1.0)
    k = int(np.argmax(np.where(np.isnan(worst_of), np.inf, worst_of)))
    return Measured(
        name, engine, kernel, points, float(worst_of[k]), tolerance, point(inputs, k, points)
    )


def point(inputs: Mapping[str, Any], k: int, points: int) -> Point:
    """The inputs of point k of `points`, as plain numbers and lists."""
    found: Point = {}
    for name, value in inputs.items():
        array = np.asarray(value, dtype=float)
        if array.ndim and len(array) == points:
            array = array[k]
        found[name] = array.tolist()
    return found
