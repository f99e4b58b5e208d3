"""Small linear systems in scalars, by Cramer's rule: their entries may have different units."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

from armillary.algebra.misuse import MisuseError
from armillary.algebra.scalar import Scalar, add, divide, multiply, negate

Rows = Sequence[Sequence[Scalar]]
LARGEST = 3


def determinant(rows: Rows) -> Scalar:
    """The determinant of a matrix of 1 to 3 rows."""
    _check(rows)
    if len(rows) == 1:
        return rows[0][0]
    return _products(rows[0], _cofactors(rows, 0))


def solved(rows: Rows, right: Sequence[Scalar], det: Scalar | None = None) -> tuple[Scalar, ...]:
    """The x with `rows` x = `right`.

    Args:
        det: the determinant if it is known, kept from being 0 by the caller.
    """
    _check(rows)
    if det is None:
        det = determinant(rows)
    if len(rows) == 1:
        return (divide(right[0], det),)
    lines = [_cofactors(rows, k) for k in range(len(rows))]
    return tuple(
        divide(_products([line[j] for line in lines], right), det) for j in range(len(rows))
    )


def _cofactors(rows: Rows, k: int) -> list[Scalar]:
    """The cofactors of a row's entries."""
    if len(rows) == 2:
        a, b = rows[1 - k]
        return [b, negate(a)] if k == 0 else [negate(b), a]
    first, second = rows[(k + 1) % 3], rows[(k + 2) % 3]
    found = []
    for j in range(3):
        p, q = (j + 1) % 3, (j + 2) % 3
        found.append(add(multiply(first[p], second[q]), negate(multiply(first[q], second[p]))))
    return found


def _products(left: Sequence[Scalar], right: Sequence[Scalar]) -> Scalar:
    return reduce(add, (multiply(a, b) for a, b in zip(left, right, strict=True)))


def _check(rows: Rows) -> None:
    if not 1 <= len(rows) <= LARGEST or any(len(row) != len(rows) for row in rows):
        shape = f"{len(rows)} by {len(rows[0]) if rows else 0}"
        raise MisuseError(
            f"a linear system of {shape}", f"give a square matrix of 1 to {LARGEST} rows"
        )
