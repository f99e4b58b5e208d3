"""Points at which a print is compared: spread over the working ranges, and a few round ones."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from armillary.algebra import scalar as s
from armillary.algebra.index import Index
from armillary.algebra.indexed import indices
from armillary.derivation.quantity import (
    AnyQuantity,
    Constant,
    Kind,
    Quantity,
    RotationQuantity,
    VectorQuantity,
)
from armillary.derivation.statements import Block
from armillary.derivation.symbols import leaves
from armillary.derivation.units import RADIAN
from armillary.verify.audit.numbers import Digits, Doubles
from armillary.verify.audit.numeric import Leaf, Values
from armillary.verify.points import random_points

Array = NDArray[np.float64]
Known = AnyQuantity | Index  # what differs from point to point
Sample = dict[Leaf | Index, Array]

_DEGREES = (30, 45, 60, 20, 10, 75, -30, -60, 120, 150)
_PLAIN = (1.0, 0.5, 2.0, 0.2, 0.1, -1.0, 10.0)
_SMALL = (0.01, 0.02, 0.005, -0.01, 0.001)
# Directions with short decimals, none of them on an axis or in a plane of two.
_DIRECTIONS = (
    (0.48, 0.6, 0.64),
    (-0.36, 0.48, 0.8),
    (0.48, -0.36, 0.8),
    (0.64, 0.48, 0.6),
    (-0.48, -0.64, 0.6),
)
_ROTATIONS = (
    np.array([[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]]),
    np.array([[0.64, -0.48, 0.6], [0.6, 0.8, 0.0], [-0.48, 0.36, 0.8]]),
    np.array([[0.8, 0.0, 0.6], [0.36, 0.8, -0.48], [-0.48, 0.6, 0.64]]),
)
_CHOICES = 3  # round values of a quantity; with fewer there are parts of its range, too
_SHOWN = 1e-12  # an error that is no rounding
_TRIED = 3000  # points drawn where a condition narrows the range


def quantities(*expressions: object) -> list[Known]:
    """The quantities that expressions stand on, constants apart, and the indices left open."""
    kinds = (Quantity, VectorQuantity, RotationQuantity)
    found = leaves(expressions)
    known: list[Known] = [q for q in found if isinstance(q, kinds) and not isinstance(q, Constant)]
    opened = {index for expression in expressions for index in indices(expression)}
    # An indexed quantity is drawn for all its parts, one of which is looked at.
    opened |= {q.per for q in known if (isinstance(q, (Quantity, VectorQuantity))) and q.per}
    return known + sorted(opened, key=lambda index: index.name)


def sample(known: Sequence[Known], n: int, seed: int) -> Sample:
    """`n` random points of the working ranges; two quantities of one name get streams apart."""
    made: Sample = {}
    names: dict[str, int] = {}
    for q in known:
        met = names[q.name] = names.get(q.name, -1) + 1
        if isinstance(q, Index):
            stream = np.random.default_rng([seed, zlib.crc32(q.name.encode())])
            made[q] = stream.integers(q.size, size=n).astype(float)
        else:
            made[q] = random_points([q], n, seed + 1000 * met)[q.name]
    return made


def everywhere(known: Sequence[Known], n: int, seed: int) -> Sample:
    """At least `n` points at every part of the indices.

    One scalar alone is stepped from end to end of its range; several are drawn.
    """
    moving = [q for q in known if not isinstance(q, Index)]
    over = [index for index in known if isinstance(index, Index)]
    if len(moving) == 1 and isinstance(moving[0], Quantity) and moving[0].per is None:
        few: Sample = {moving[0]: np.linspace(*moving[0].facts.range, n)}
    else:
        few = joined(sample(moving, n, seed), awkward(moving, seed + 1, moving))
        few = joined(few, ends(moving, n, seed + 2))
    places = list(product(*(range(index.size) for index in over)))
    stepped = max(1, count(few))
    made: Sample = {q: np.concatenate([array] * len(places)) for q, array in few.items()}
    for k, index in enumerate(over):
        made[index] = np.repeat([float(place[k]) for place in places], stepped)
    return made


def awkward(known: Sequence[Known], seed: int, of: Sequence[Known]) -> Sample:
    """One scalar at a time, of some, at 0, a quarter or half turn, or an end of its range."""
    rows = [(q, x) for q in of if isinstance(q, Quantity) for x in _awkward(q)]
    made = sample(known, len(rows), seed)
    for k, (q, x) in enumerate(rows):
        made[q][k] = x
    return made


def ends(known: Sequence[Known], n: int, seed: int) -> Sample:
    """`n` points at which every scalar is at an awkward value, most of them ends of its range."""
    made = sample(known, n, seed)
    stream = np.random.default_rng(seed)
    for q in known:
        if isinstance(q, Quantity):
            low, high = q.facts.range
            made[q] = stream.choice([low, high, *_awkward(q)], made[q].shape)
    return made


def joined(first: Sample, second: Sample) -> Sample:
    """The points of both."""
    return {q: np.concatenate([first[q], second[q]]) for q in first}


def where(points: Sample, given: s.Condition | None) -> Sample:
    """The points at which a condition holds."""
    if given is None:
        return points
    with np.errstate(all="ignore"):
        held = np.asarray(Values(Doubles(), points)(given), dtype=bool)
    count = Values(Doubles(), points).count
    mask = np.broadcast_to(held, (count,))
    return {q: array[mask] for q, array in points.items()}


def usual(
    known: Sequence[Known],
    of: Sequence[Known],
    n: int,
    seed: int,
    given: s.Condition | None,
) -> Sample:
    """`n` random points at which the condition holds, and points awkward for the quantities `of`.

    Of these, too, those at which it holds.
    """
    if given is None:
        return joined(sample(known, n, seed), awkward(known, seed + 1, of))
    drawn = first(where(sample(known, _TRIED, seed), given), n)
    return joined(drawn, where(awkward(known, seed + 1, of), given))


def first(points: Sample, n: int) -> Sample:
    """The first `n` points."""
    return {q: array[:n] for q, array in points.items()}


def exact(points: Sample, digits: Digits) -> dict[Leaf | Index, Any]:
    """The same points with 50 digits; directions are brought to norm 1 again, to all of them."""
    made: dict[Leaf | Index, Any] = {}
    for q, array in points.items():
        if isinstance(q, Index):
            made[q] = array
            continue
        made[q] = digits.array(array)
        if isinstance(q, RotationQuantity):
            x = _normalised(made[q][:, :, 0], digits)
            inside = made[q][:, :, 1] - (x * made[q][:, :, 1]).sum(axis=1, keepdims=True) * x
            y = _normalised(inside, digits)
            z = x[:, [1, 2, 0]] * y[:, [2, 0, 1]] - x[:, [2, 0, 1]] * y[:, [1, 2, 0]]
            made[q] = np.stack([x, y, z], axis=2)
        elif isinstance(q, VectorQuantity) and q.unit_norm:
            made[q] = _normalised(made[q], digits)
    return made


def _normalised(vectors: Any, digits: Digits) -> Any:
    return vectors / digits.sqrt((vectors * vectors).sum(axis=1, keepdims=True))


def with_small(
    points: Mapping[Leaf | Index, Any], small: Sequence[Quantity], scale: Any
) -> dict[Leaf | Index, Any]:
    """The same points with the small quantities scaled down."""
    return {q: array * scale if q in small else array for q, array in points.items()}


def with_value(points: Sample, q: Leaf, value: float) -> Sample:
    """The same points with one quantity held."""
    return points | {q: np.full_like(points[q], value)}


@dataclass(frozen=True)
class Round:
    """A point with round inputs."""

    values: Mapping[Leaf | Index, Any]

    def told(self) -> dict[str, float | list[float]]:
        """By name: numbers, lists of three, rotations as lists of nine, and parts from 1."""
        made: dict[str, float | list[float]] = {}
        for q, value in self.values.items():
            array = np.asarray(value) + (1 if isinstance(q, Index) else 0)
            made[q.name] = float(array) if array.ndim == 0 else array.ravel().tolist()
        return made


def round_points(
    known: Sequence[Known],
    small: Sequence[Quantity],
    n: int = 60,
    held: Mapping[Leaf | Index, Any] | None = None,
) -> list[Round]:
    """Points made of round values, the plainest first; some quantities are held at one."""
    held = held or {}
    stream = np.random.default_rng(7)
    made: list[Round] = []
    for k in range(n):
        values: dict[Leaf | Index, Any] = {}
        for i, q in enumerate(known):
            choices = [held[q]] if q in held else _round(q, small)
            pick = i + k if k < 3 else int(stream.integers(len(choices)))
            values[q] = choices[pick % len(choices)]
        made.append(Round(values))
    return made


def stacked(points: Sequence[Round], known: Sequence[Known]) -> Sample:
    """Round points as arrays."""
    return {q: np.array([p.values[q] for p in points], dtype=float) for q in known}


def worst_round(
    known: Sequence[Known],
    small: Sequence[Quantity],
    given: s.Condition | None,
    error: Callable[[Sample], Array],
    examples: Mapping[AnyQuantity, Block] | None = None,
) -> Round | None:
    """The plainest round point whose error is at least half of the largest among them.

    Quantities that a paper's own examples name are held at those, unless nothing shows there.
    """
    held: dict[Leaf | Index, Any] = {
        q: numbers_of(block) for q, block in (examples or {}).items() if q in known
    }
    for kept in [held, {}] if held else [held]:
        points = [p for p in round_points(known, small, held=kept) if _holds(p, known, given)]
        if not points:
            continue
        errors = np.nan_to_num(np.abs(error(stacked(points, known))), nan=-1.0, posinf=-1.0)
        largest = float(errors.max())
        if largest > (_SHOWN if kept else 0.0):
            return points[int(np.argmax(errors >= largest / 2))]
    return None


def numbers_of(block: Block) -> Any:
    """The numbers of a constant scalar or vector; of one per part of an index, a row for each."""
    values = Values(Doubles(), {})
    over = next(iter(indices(block)), None)
    if over is None:
        return _plain(values(block))
    return [_plain(values.at_part(block, over, k)) for k in range(over.size)]


def _plain(value: Any) -> Any:
    """One number, or three, of values at one point."""
    if isinstance(value, tuple):
        return [float(np.ravel(x)[0]) for x in value]
    return float(np.ravel(value)[0])


def is_angle(q: Leaf | Index) -> bool:
    """Whether a quantity is an angle in radians."""
    unit = getattr(q, "unit", None)
    return isinstance(q, Quantity) and unit is not None and unit.agrees(RADIAN) and unit.angle == 1


def _holds(point: Round, known: Sequence[Known], given: s.Condition | None) -> bool:
    return given is None or bool(count(where(stacked([point], known), given)))


def count(points: Sample) -> int:
    """How many points there are; one where nothing varies."""
    return min((len(a) for a in points.values()), default=1)


def _awkward(q: Quantity) -> list[float]:
    low, high = q.facts.range
    quarter = float(np.pi / 2)
    wanted = (0.0, *((quarter, -quarter, 2 * quarter, -2 * quarter) if is_angle(q) else ()))
    return [x for x in dict.fromkeys((*wanted, low, high)) if low <= x <= high]


def _round(q: Known, small: Sequence[Quantity]) -> list[Any]:
    """Round values inside the range of one quantity; for each of its parts, if it has some."""
    if isinstance(q, Index):
        return list(range(q.size))
    per = q.per if isinstance(q, (Quantity, VectorQuantity)) else None
    if per is not None:
        choices = _round_values(q, small)
        count = len(choices)
        return [[choices[(i + k) % count] for k in range(per.size)] for i in range(count)]
    return _round_values(q, small)


def _round_values(q: AnyQuantity, small: Sequence[Quantity]) -> list[Any]:
    if isinstance(q, RotationQuantity):
        return list(_ROTATIONS)
    if isinstance(q, VectorQuantity):
        scale = 1.0 if q.facts.kind is Kind.UNIT_VECTOR else min(1.0, q.facts.range[1])
        return [tuple(scale * x for x in d) for d in _DIRECTIONS]
    low, high = q.facts.range
    wide = (high - low) / 2
    if q in small or (is_angle(q) and wide <= 0.35):
        choices = list(_SMALL)
    elif is_angle(q):
        choices = [float(np.radians(d)) for d in _DEGREES]
    else:
        choices = list(_PLAIN)
    inside = [x for x in choices if low <= x <= high]
    if len(inside) < _CHOICES:
        inside += [_part_of(low, high, part) for part in (0.5, 0.25, 0.75, 0, 1)]
    return list(dict.fromkeys(x for x in inside if low <= x <= high)) or [low]


def _part_of(low: float, high: float, part: float) -> float:
    """So far from low to high, to two digits; 0 where rounding alone keeps it from 0."""
    value = low + part * (high - low)
    return float(f"{value:.2g}") if abs(value) > _SHOWN * (high - low) else 0.0
