"""Points at which kernels are checked: random ones, awkward ones, and ones to be refused."""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Mapping, Sequence
from itertools import permutations, product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from armillary.derivation.errors import DerivationError
from armillary.derivation.quantity import AnyQuantity, Kind, Role
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Kernel
from armillary.derivation.units import RADIAN
from armillary.program.arithmetic import Reals
from armillary.program.drawing import Drawing
from armillary.program.sample import rotation_of

Array = NDArray[np.float64]
Value = float | tuple[float, ...] | Array

# Zenith and horizon, quarter and half turns, and an angle that nobody normalised.
AWKWARD_ANGLES = (0.0, np.pi / 2, -np.pi / 2, np.pi, -np.pi, 2 * np.pi, 999.0, -999.0)
_AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
# A little off the vertical. The offsets are not round, so that no author's threshold meets them.
AWKWARD_DIRECTIONS: tuple[tuple[float, float, float], ...] = (
    *_AXES,
    *((-x, -y, -z) for x, y, z in _AXES),
    (3.3e-4, 0.0, float(np.sqrt(1 - 3.3e-4**2))),
    (-3.3e-9, 4.7e-9, 1.0),
    (0.0, -3.3e-4, -float(np.sqrt(1 - 3.3e-4**2))),
)

# Signed permutations of the axes: the identity first, quarter turns, half turns, third turns.
_PERMUTED = [np.eye(3)[list(p)] * np.array(s)[:, None] for p in permutations(range(3))
             for s in product((1.0, -1.0), repeat=3)]  # fmt: skip
_TILTS = (3.3e-4, -4.7e-9, np.pi / 2 - 3.3e-4, np.pi - 3.3e-4, np.pi - 4.7e-9)


def _turn(axis: int, angle: float) -> Array:
    turned = np.eye(3)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turned[i, i] = turned[j, j] = np.cos(angle)
    turned[i, j], turned[j, i] = -np.sin(angle), np.sin(angle)
    return turned


# Signed permutations, and small and nearly half tilts between turns in general position.
AWKWARD_ROTATIONS: tuple[Array, ...] = (
    *(m for m in _PERMUTED if np.linalg.det(m) > 0),
    *(_turn(2, 0.7) @ _turn(axis, tilt) @ _turn(2, -1.9) for axis in (0, 1) for tilt in _TILTS),
)


def quantities(record: Derivation | Kernel | Sequence[AnyQuantity]) -> list[AnyQuantity]:
    """The inputs and parameters of a kernel or a system, in the order declared."""
    if isinstance(record, Derivation):
        taken = (Role.INPUT, Role.PARAMETER)
        return [q for q in record.quantities.values() if q.facts.role in taken]
    if isinstance(record, Kernel):
        return [*record.inputs, *record.parameters]
    return list(record)


def random_points(
    record: Derivation | Kernel | Sequence[AnyQuantity], n: int, seed: int = 0
) -> dict[str, Array]:
    """`n` points spread evenly over the declared ranges.

    Arrays (n,), of vectors (n, 3), of rotations (n, 3, 3).
    Each quantity has a stream of its own, so a quantity added to a system moves no other's points.
    Inputs that a kernel draws as expressions have their values at the point.

    Raises:
        DerivationError: where such an expression has no value.
    """
    points = _in_ranges(quantities(record), n, seed)
    if isinstance(record, Kernel):
        _draw(record, points, seed)
    return points


def awkward_points(record: Derivation | Kernel | Sequence[AnyQuantity]) -> dict[str, Array]:
    """Points where formulas break.

    Each quantity at each of its awkward values, once with the others at random and once with every
    other at its plainest value; and the corners where all take their k-th awkward value together.
    """
    known = quantities(record)
    choices = {q.name: _awkward(q) for q in known}
    rows: list[dict[str, Value]] = []
    for q in known:
        for value in choices[q.name]:
            rows.append({q.name: value})
            rows.append({name: c[0] for name, c in choices.items()} | {q.name: value})
    longest = max((len(c) for c in choices.values()), default=0)
    for k in range(longest):
        rows.append({name: c[k % len(c)] for name, c in choices.items()})
    return _filled(record, rows, seed=1)


def illegal_points(record: Derivation | Kernel | Sequence[AnyQuantity]) -> dict[str, Array]:
    """Points that a kernel must refuse, one fault each; the rest is at random.

    The faults: NaN, infinities, beyond the limits, vectors that are no unit vectors, matrices that
    are no rotations.
    """
    known = quantities(record)
    rows = [{q.name: fault} for q in known for fault in _faults(q)]
    return _filled(record, rows, seed=2)


def directions(n: int, seed: int) -> Array:
    """`n` unit vectors spread evenly over the sphere, and the awkward ones: (n + some, 3)."""
    made = np.random.default_rng(seed).normal(size=(n, 3))
    made /= np.linalg.norm(made, axis=1, keepdims=True)
    return np.concatenate([made, np.array(AWKWARD_DIRECTIONS)])


def rotations(n: int, stream: np.random.Generator) -> Array:
    """`n` rotation matrices spread evenly over all attitudes: (n, 3, 3)."""
    made = stream.normal(size=(n, 4))
    quaternions = list((made / np.linalg.norm(made, axis=1, keepdims=True)).T)
    return np.stack(rotation_of(quaternions), axis=1).reshape(n, 3, 3)


def joined(first: Mapping[str, Array], second: Mapping[str, Array]) -> dict[str, Array]:
    """The points of both, one after the other."""
    return {name: np.concatenate([first[name], second[name]]) for name in first}


def chosen(points: Mapping[str, Array], mask: NDArray[np.bool_]) -> dict[str, Array]:
    """The points where the mask holds."""
    return {name: array[mask] for name, array in points.items()}


def count(points: Mapping[str, Array]) -> int:
    """How many points there are; a kernel without quantities has one."""
    return min((len(a) for a in points.values()), default=1)


def rows_of(points: Mapping[str, Array]) -> Iterator[dict[str, Any]]:
    """The points one by one: floats, and flat lists of floats, row-major."""
    for k in range(count(points)):
        yield {
            name: array[k].ravel().tolist() if array.ndim > 1 else array[k].tolist()
            for name, array in points.items()
        }


def _stream(name: str, seed: int) -> np.random.Generator:
    return np.random.default_rng([seed, zlib.crc32(name.encode())])


def _random(q: AnyQuantity, n: int, stream: np.random.Generator) -> Array:
    if q.facts.kind is Kind.UNIT_VECTOR:
        made = stream.normal(size=(n, 3))
        return np.asarray(made / np.linalg.norm(made, axis=1, keepdims=True))
    if q.facts.kind is Kind.ROTATION:
        return rotations(n, stream)
    low, high = q.facts.range
    return stream.uniform(low, high, size=(n, *q.shape))


def _awkward(q: AnyQuantity) -> list[Value]:
    """Awkward values inside the limits of one quantity; the first is the plainest."""
    low, high = q.facts.limits
    if q.facts.kind is Kind.UNIT_VECTOR:
        return list(AWKWARD_DIRECTIONS)
    if q.facts.kind is Kind.ROTATION:
        return list(AWKWARD_ROTATIONS)
    scalars: list[float] = []
    for value in (*(AWKWARD_ANGLES if _is_angle(q) else (0.0,)), *q.facts.range, low, high):
        if low <= value <= high and value not in scalars:
            scalars.append(float(value))
    if q.shape == ():
        return list(scalars)
    size, rest = int(np.prod(q.shape)), _middle(q)
    # Like parts are treated alike: each value comes to one of them, the next value to the next.
    places = [(k % size,) if q.facts.per else range(size) for k in range(len(scalars))]
    spikes = [
        tuple(v if k == i else rest for k in range(size))
        for v, where in zip(scalars, places, strict=True)
        for i in where
    ]
    return list(dict.fromkeys(spikes))


def _is_angle(q: AnyQuantity) -> bool:
    return q.unit.agrees(RADIAN) and q.unit.angle == 1


def _faults(q: AnyQuantity) -> list[Value]:
    low, high = q.facts.limits
    beyond = [low - max(1.0, abs(low)) * 0.01, high + max(1.0, abs(high)) * 0.01, 1e30, -1e30]
    bad = [float("nan"), float("inf"), -float("inf"), *beyond]
    if q.shape == ():
        return list(bad)
    if q.facts.kind is Kind.ROTATION:
        return _no_rotations(bad)
    size, rest = int(np.prod(q.shape)), _middle(q)
    faults: list[Value] = [
        tuple(value if i == k % size else rest for i in range(size)) for k, value in enumerate(bad)
    ]
    if q.facts.kind is Kind.UNIT_VECTOR:
        faults += [(0.0, 0.0, 0.0), (0.6, 0.6, 0.6), (0.0, 0.0, 0.99)]
    return faults


def _middle(q: AnyQuantity) -> float:
    """A plain value inside the limits."""
    low, high = q.facts.limits
    return 0.0 if low <= 0.0 <= high else low


def _no_rotations(bad: Sequence[float]) -> list[Value]:
    """The identity with one bad entry; matrices that are singular, scaled, sheared, mirrored."""
    faults: list[Value] = []
    for k, value in enumerate(bad):
        matrix = np.eye(3)
        matrix[k % 3, (k + 1) % 3] = value
        faults.append(matrix)
    sheared, mirror = np.eye(3), _turn(2, 0.7) @ np.diag((1.0, 1.0, -1.0))
    sheared[0, 1] = 0.02
    return [*faults, np.zeros((3, 3)), 0.99 * np.eye(3), sheared, sheared.T, mirror, -np.eye(3)]


def _filled(
    record: Derivation | Kernel | Sequence[AnyQuantity],
    rows: Sequence[Mapping[str, Value]],
    seed: int,
) -> dict[str, Array]:
    """What a row leaves open is taken at random, or drawn by the values of the row."""
    points = _in_ranges(quantities(record), len(rows), seed)
    _put(points, rows)
    if isinstance(record, Kernel):
        _draw(record, points, seed, lenient=True)
        _put(points, rows)
    return points


def _put(points: dict[str, Array], rows: Sequence[Mapping[str, Value]]) -> None:
    for k, row in enumerate(rows):
        for name, value in row.items():
            points[name][k] = np.reshape(value, points[name][k].shape)


def _in_ranges(known: Sequence[AnyQuantity], n: int, seed: int) -> dict[str, Array]:
    return {q.name: _random(q, n, _stream(q.name, seed)) for q in known}


def _draw(kernel: Kernel, points: dict[str, Array], seed: int, lenient: bool = False) -> None:
    """Put in what inputs are drawn as; where that has no value, a lenient one leaves them."""
    if not kernel.drawn:
        return
    drawing, reals = Drawing(kernel), Reals()
    others = _in_ranges(drawing.others, count(points), seed)
    for k, row in enumerate(rows_of({**points, **others})):
        try:
            drawn = drawing.at(row, reals)
        except DerivationError:
            if not lenient:
                raise
            continue
        for name, value in drawn.items():
            flat = [float(x) for x in value] if isinstance(value, list) else float(value)
            points[name][k] = np.reshape(flat, points[name][k].shape)
