"""Small-angle truncation: expansions to a stated total order, with their leading error.

A product of two small quantities is of order two, so a matrix truncated to first order has no entry
theta psi. The series is taken through closed-form inverses too: quotients, roots, lengths, unit
vectors, direction angles and atan2, wherever these are regular with every small quantity at 0.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar, overload

from armillary.algebra import folding as f
from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.jets import Jets
from armillary.algebra.misuse import MisuseError, told
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation

Small = s.Symbol | v.VectorSymbol
Expression = s.Scalar | v.Vector | Rotation | Matrix | Pose | Twist | Wrench
Block = TypeVar("Block", s.Scalar, v.Vector, Matrix, Twist, Wrench)


@dataclass(frozen=True, eq=False)
class Truncated(Generic[Block]):
    """An expression up to a total order in its small quantities.

    Attributes:
        value: the sum of the terms; a rotation and a pose become matrices (3, 3) and (4, 4), as
            their truncations are no longer rotations.
        order: the total order kept.
        small: the quantities that were taken as small.
        remainder: the leading error, the terms of degree order + 1 of exact minus value; 0 where
            the expansion has none of that degree.
        terms: one block per degree, 0 to order; their sum is the value.
        exact: the expression that was truncated.
    """

    value: Block
    order: int
    small: tuple[Small, ...]
    remainder: Block
    terms: tuple[Block, ...]
    exact: Expression


@overload
def truncate(expression: s.Scalar, order: int, small: Sequence[Small]) -> Truncated[s.Scalar]: ...
@overload
def truncate(expression: v.Vector, order: int, small: Sequence[Small]) -> Truncated[v.Vector]: ...
@overload
def truncate(
    expression: Rotation | Matrix | Pose, order: int, small: Sequence[Small]
) -> Truncated[Matrix]: ...
@overload
def truncate(expression: Twist, order: int, small: Sequence[Small]) -> Truncated[Twist]: ...
@overload
def truncate(expression: Wrench, order: int, small: Sequence[Small]) -> Truncated[Wrench]: ...
def truncate(
    expression: Expression, order: int, small: Sequence[Small]
) -> (
    Truncated[s.Scalar]
    | Truncated[v.Vector]
    | Truncated[Matrix]
    | Truncated[Twist]
    | Truncated[Wrench]
):
    """The expansion of an expression in small quantities, to a total order of 1 or more.

    Definitions below the expression are opened where they stand on a small quantity; what does not
    is kept as it is. Of a `where`, the condition is taken with every small quantity at 0 and both
    sides are expanded, so the truncation is exact to its order away from the switch only. Likewise
    an `atan2` that lies on its cut where they are 0: it is right up to a whole turn.

    Raises:
        MisuseError: if the order is not a whole number from 1 up, a small quantity is no symbol, or
            the expression has no expansion where they are 0 (a quotient by, a root of, or the
            angle of what vanishes there).
    """
    named = _checked(order, small)
    jets = Jets(named, order + 1)
    if isinstance(expression, s.Scalar):
        return _cut(expression, jets.scalar(expression), named, f.total)
    if isinstance(expression, v.Vector):
        return _cut(expression, jets.vector(expression), named, f.total_vector)
    if isinstance(expression, Matrix):
        return _cut(expression, _matrix(expression, jets), named, _total_matrix)
    if isinstance(expression, (Rotation, Pose)):
        return _rigid(expression, jets, named)
    if isinstance(expression, Twist):
        pair = (jets.vector(expression.angular), jets.vector(expression.linear))
        return _pair(expression, Twist, *pair, named)
    if isinstance(expression, Wrench):
        pair = (jets.vector(expression.moment), jets.vector(expression.force))
        return _pair(expression, Wrench, *pair, named)
    raise MisuseError(
        f"only scalars, vectors, rotations, matrices, poses, twists and wrenches have series, "
        f"not {told(expression)}",
        "truncate the scalars a condition compares",
    )


def _checked(order: object, small: object) -> tuple[Small, ...]:
    if isinstance(order, bool) or not isinstance(order, int) or order < 1:
        raise MisuseError(
            f"a series is cut at a whole order from 1 up, not {told(order)}",
            "order=1 keeps what is linear in the small quantities",
        )
    if isinstance(small, (s.Symbol, v.VectorSymbol)):
        small = (small,)
    if not isinstance(small, Sequence) or isinstance(small, str) or not small:
        raise MisuseError(
            "no small quantity is named", "name them all: truncate(x, 1, small=(theta, psi))"
        )
    for item in small:
        if not isinstance(item, (s.Symbol, v.VectorSymbol)):
            raise MisuseError(
                f"a small quantity is a declared one, not {told(item)}",
                "declare it with d.angle or d.parameter.angle and name that",
            )
        if isinstance(item, v.VectorSymbol) and item.unit_norm:
            raise MisuseError(
                f"the unit vector {item.name} is not small", "name the angles that turn it"
            )
    return tuple(dict.fromkeys(small))


def _cut(
    exact: Expression,
    jet: Sequence[Block],
    small: tuple[Small, ...],
    total: Callable[[Sequence[Block]], Block],
) -> Truncated[Block]:
    """The last term of a jet is the remainder."""
    kept = tuple(jet[:-1])
    return Truncated(total(kept), len(kept) - 1, small, jet[-1], kept, exact)


def _matrix(matrix: Matrix, jets: Jets) -> list[Matrix]:
    entries = [[jets.scalar(entry) for entry in row] for row in matrix.rows]
    first = Matrix(tuple(tuple(jet[0] for jet in row) for row in entries))
    later = [
        Matrix(tuple(tuple(jet[k] for jet in row) for row in entries))
        for k in range(1, jets.order + 1)
    ]
    return [first if jets.depends(matrix) else matrix, *later]


def _total_matrix(terms: Sequence[Matrix]) -> Matrix:
    first = terms[0]
    if all(s.is_zero(entry) for term in terms[1:] for row in term.rows for entry in row):
        return first
    rows, columns = first.shape
    return Matrix(
        tuple(
            tuple(f.total([term.rows[i][j] for term in terms]) for j in range(columns))
            for i in range(rows)
        )
    )


def _rigid(exact: Rotation | Pose, jets: Jets, small: tuple[Small, ...]) -> Truncated[Matrix]:
    """The matrix of a rotation or a pose; its columns are added as vectors.

    So one rotation that is not small carries the sum.
    """
    rotation = exact.rotation if isinstance(exact, Pose) else exact
    columns = [jets.rotated(rotation, jets.still_vector(axis)) for axis in f.AXES]
    if isinstance(exact, Pose):
        columns.append(jets.vector(exact.position))

    def whole(vectors: Sequence[v.Vector], corner: s.Scalar) -> Matrix:
        rows = tuple(tuple(v.component(c, i) for c in vectors) for i in range(3))
        last = (s.ZERO, s.ZERO, s.ZERO, corner)
        return Matrix((*rows, last) if isinstance(exact, Pose) else rows)

    terms = [whole([jet[k] for jet in columns], s.ZERO if k else s.ONE) for k in range(jets.order)]
    value = whole([f.total_vector(jet[:-1]) for jet in columns], s.ONE)
    remainder = whole([jet[-1] for jet in columns], s.ZERO)
    return Truncated(value, jets.order - 1, small, remainder, tuple(terms), exact)


Screw = TypeVar("Screw", Twist, Wrench)


def _pair(
    exact: Screw,
    kind: Callable[[v.Vector, v.Vector], Screw],
    turning: Sequence[v.Vector],
    moving: Sequence[v.Vector],
    small: tuple[Small, ...],
) -> Truncated[Screw]:
    first = _cut(exact, turning, small, f.total_vector)
    second = _cut(exact, moving, small, f.total_vector)
    return Truncated(
        kind(first.value, second.value),
        first.order,
        small,
        kind(first.remainder, second.remainder),
        tuple(map(kind, first.terms, second.terms)),
        exact,
    )
