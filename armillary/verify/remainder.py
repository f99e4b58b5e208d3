"""The size of a truncation's error over the declared ranges: measured, and bounded."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import mpmath
import numpy as np

from armillary.algebra import scalar as s
from armillary.algebra.misuse import MisuseError
from armillary.algebra.rotation import Elementary, Rotation, factors
from armillary.algebra.series import Small, Truncated
from armillary.derivation.quantity import AnyQuantity, Quantity, VectorQuantity
from armillary.derivation.symbols import leaves
from armillary.program.arithmetic import DIGITS
from armillary.verify.exact import largest, text_book
from armillary.verify.measured import Measured, Point, exceeds
from armillary.verify.points import random_points, rows_of

Keep = Callable[[Point], bool]
POINTS = 256
# At this part of their values the leading term of an error is all of it but a few millionths.
_NEAR = 1e-5
# Below this an error at 50 digits is rounding.
_ROUNDING = 1e-48


@dataclass(frozen=True)
class RemainderSize:
    """How large an error is over the declared ranges.

    Attributes:
        worst: the largest |exact - truncated| of any entry; NaN where a value was missing.
        at: the point where it was met.
        leading: the largest entry of the derived leading term.
        leading_at: the point where that was met.
        points: how many points were tried.
    """

    worst: float
    at: Point
    leading: float
    leading_at: Point
    points: int


def remainder_size(
    truncated: Truncated[Any],
    n: int = POINTS,
    seed: int = 0,
    keep: Keep | None = None,
    turn: bool = False,
) -> RemainderSize:
    """The error of a truncation at points of the declared ranges, at 50 digits.

    Half of the points are random. At the others each small quantity is at an end of its range, all
    combinations in turn, and the rest is random.

    Args:
        n: number of points, raised until every combination of ends is met.
        keep: which points count; those where a formula is singular do not.
        turn: the values are angles, equal when they differ by whole turns.

    Raises:
        ValueError: if `keep` leaves no point.
    """
    exact, value = text_book(truncated.exact), text_book(truncated.value)
    remainder = text_book(truncated.remainder)
    size: RemainderSize | None = None
    for row in _points(truncated, n, seed, keep):
        error = float(_error(exact(row), value(row), turn))
        leading = float(largest([_real(x) for x in remainder(row)]))
        size = _worse(size, RemainderSize(error, row, leading, row, 1))
    if size is None:
        raise ValueError("no point is left to measure a remainder at")
    return size


def _worse(size: RemainderSize | None, found: RemainderSize) -> RemainderSize:
    """The sizes with one more point."""
    if size is None:
        return found
    worst = found if exceeds(found.worst, size.worst) else size
    leading = found if exceeds(found.leading, size.leading) else size
    return RemainderSize(
        worst.worst, worst.at, leading.leading, leading.leading_at, size.points + 1
    )


def remainder_check(
    name: str,
    truncated: Truncated[Any],
    tolerance: float,
    n: int = POINTS,
    keep: Keep | None = None,
    turn: bool = False,
) -> Measured:
    """The largest error over the declared ranges, as a check against a stated size."""
    size = remainder_size(truncated, n, keep=keep, turn=turn)
    why = f"the leading term of the error is at most {size.leading:.2g}"
    return Measured(name, "50 digits", None, size.points, size.worst, tolerance, size.at, why)


def remainder_order(
    truncated: Truncated[Any],
    n: int = 16,
    seed: int = 0,
    keep: Keep | None = None,
    turn: bool = False,
) -> float:
    """The power by which an error falls, the least of some points; infinite where there is none.

    All small quantities are scaled to 1e-5 of their value and halved together: log2 of the error's
    ratio, order + 1 unless the leading term vanishes there.
    """
    exact, value = text_book(truncated.exact), text_book(truncated.value)
    least = math.inf
    for row in _points(truncated, n, seed, keep):
        rows = [_shrunk(row, truncated.small, part) for part in (_NEAR, _NEAR / 2)]
        once, half = (_error(exact(near), value(near), turn) for near in rows)
        if min(once, half) > _ROUNDING:
            with mpmath.workdps(DIGITS):
                least = min(least, float(mpmath.log(once / half, 2)))
    return least


def rotation_bound(rotation: Rotation, order: int, small: Sequence[Small]) -> float:
    """A proven bound of |R - R_n| over the declared ranges, in the spectral norm.

    Every angle must be linear in the small quantities. With S the sum of the sizes of the small
    parts of all angles, the derivative of order n + 1 along the ray to a point is a sum of products
    of rotations and unit skew matrices with norm at most S^(n + 1), so by Taylor's theorem the
    remainder is at most S^(n + 1) / (n + 1)!. No entry's error is larger.

    Raises:
        MisuseError: if an angle is not linear, or a small quantity has no declared range.
    """
    turns = [f for f in factors(rotation) if isinstance(f, Elementary)]
    total = sum(_reach(turn.angle, small) for turn in turns)
    bound = total ** (order + 1) / math.factorial(order + 1)
    # The few operations here round by far less than this.
    return bound * (1 + 1e-12)


def _reach(angle: s.Scalar, small: Sequence[Small]) -> float:
    """The largest size of the part of an angle that is linear in the small quantities."""
    found = _coefficients(angle, small)
    return sum(abs(c) * _largest_of(q) for q, c in found.items())


def _coefficients(node: s.Scalar, small: Sequence[Small]) -> dict[s.Symbol, float]:
    """The numbers that small quantities are multiplied by."""
    if not any(leaf in small for leaf in leaves(node)):
        return {}
    if isinstance(node, s.Symbol):
        return {node: 1.0}
    if isinstance(node, s.ScalarReference):
        return _coefficients(node.expression, small)
    if isinstance(node, s.Negate):
        return {q: -c for q, c in _coefficients(node.argument, small).items()}
    if isinstance(node, s.Add):
        left, right = _coefficients(node.left, small), _coefficients(node.right, small)
        return {q: left.get(q, 0.0) + right.get(q, 0.0) for q in (*left, *right)}
    if isinstance(node, s.Multiply):
        for factor, rest in ((node.left, node.right), (node.right, node.left)):
            if isinstance(factor, s.Number):
                scaled = _coefficients(rest, small)
                return {q: float(factor.value) * c for q, c in scaled.items()}
    if isinstance(node, s.Divide) and isinstance(node.denominator, s.Number):
        scaled = _coefficients(node.numerator, small)
        return {q: c / float(node.denominator.value) for q, c in scaled.items()}
    raise MisuseError(
        "an angle of this rotation is not linear in the small quantities: the bound is not proven",
        "use remainder_size, which measures the error",
    )


def _largest_of(quantity: s.Symbol) -> float:
    if not isinstance(quantity, Quantity):
        raise MisuseError(
            f"{quantity.name} has no declared range", "declare it as a quantity with range=(...)"
        )
    return max(map(abs, quantity.facts.range))


def _points(truncated: Truncated[Any], n: int, seed: int, keep: Keep | None) -> Iterator[Point]:
    """Random points, and in every other one the ends of the small quantities' ranges."""
    found = leaves((truncated.exact, truncated.value, truncated.remainder))
    known = [q for q in found if isinstance(q, AnyQuantity)]
    small = [q for q in truncated.small if isinstance(q, (Quantity, VectorQuantity)) and q in known]
    ends = [end for q in small for end in [q.facts.range] * int(np.prod(q.shape, dtype=int))]
    corners = list(product(*ends))
    points = random_points(known, max(n, 2 * len(corners)), seed)
    for k in range(0, len(next(iter(points.values()), ())), 2):
        values = iter(corners[(k // 2) % len(corners)])
        for q in small:
            taken = [next(values) for _ in range(int(np.prod(q.shape, dtype=int)))]
            points[q.name][k] = taken if q.shape else taken[0]
    yield from (row for row in rows_of(points) if keep is None or keep(row))


def _shrunk(row: Point, small: Sequence[Small], part: float) -> Point:
    made = dict(row)
    for q in small:
        value = made.get(q.name)
        if isinstance(value, list):
            made[q.name] = [part * x for x in value]
        elif value is not None:
            made[q.name] = part * value
    return made


def _error(exact: Sequence[Any], value: Sequence[Any], turn: bool) -> Any:
    """The largest difference of two rows of entries; NaN where one is not real."""
    with mpmath.workdps(DIGITS):
        apart = [_real(e) - _real(v) for e, v in zip(exact, value, strict=True)]
        whole = 2 * mpmath.pi
        return largest([d - whole * mpmath.nint(d / whole) if turn else d for d in apart])


def _real(value: Any) -> Any:
    return mpmath.nan if isinstance(value, mpmath.mpc) else mpmath.mpf(value)
