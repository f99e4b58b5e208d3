"""What a recipe is written in: a tool's scalars, and matrices as lists of rows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

Scalar = Any
Vector = list[Scalar]
Matrix = list[Vector]


class Ops(Protocol):
    """What a tool must offer for a recipe to be written in it."""

    def sin(self, x: Scalar, /) -> Scalar:
        """Sine."""

    def cos(self, x: Scalar, /) -> Scalar:
        """Cosine."""

    def sqrt(self, x: Scalar, /) -> Scalar:
        """Square root."""

    def atan2(self, y: Scalar, x: Scalar, /) -> Scalar:
        """Angle of the point (x, y)."""

    def jacobian(self, values: Vector, variables: Vector, /) -> Matrix:
        """Derivatives of `values` (rows) by `variables` (columns), by the tool's own rules."""

    def named(self, values: Vector, /) -> Vector:
        """The values as variables of their own, where a tool would write them out otherwise."""


Recipe = Callable[[Ops, Vector], Vector]


def total(terms: Sequence[Scalar]) -> Scalar:
    """Sum without a leading zero, which some tools would keep as an addition."""
    result = terms[0]
    for term in terms[1:]:
        result = result + term
    return result


def dot(a: Vector, b: Vector) -> Scalar:
    """Scalar product."""
    return total([x * y for x, y in zip(a, b, strict=True)])


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product in three dimensions."""
    return [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]


def plus(*vectors: Vector) -> Vector:
    """Sum of vectors, entry by entry."""
    return [total(entries) for entries in zip(*vectors, strict=True)]


def minus(a: Vector, b: Vector) -> Vector:
    """Difference of two vectors."""
    return [x - y for x, y in zip(a, b, strict=True)]


def times(factor: Scalar, v: Vector) -> Vector:
    """Multiple of a vector."""
    return [factor * x for x in v]


def transpose(m: Matrix) -> Matrix:
    """Rows become columns."""
    return [list(column) for column in zip(*m, strict=True)]


def product(*factors: Matrix) -> Matrix:
    """Matrix product, evaluated from the left."""
    result = factors[0]
    for factor in factors[1:]:
        columns = transpose(factor)
        result = [[dot(row, column) for column in columns] for row in result]
    return result


def apply(m: Matrix, v: Vector) -> Vector:
    """Matrix times column."""
    return [dot(row, v) for row in m]


def diagonal(v: Vector) -> Matrix:
    """Matrix with these entries on its diagonal."""
    return [[v[i] if i == j else 0 for j in range(3)] for i in range(3)]


def flat(m: Matrix) -> Vector:
    """Row-major list of the entries."""
    return [entry for row in m for entry in row]


def turn_matrix(axis: str, c: Scalar, s: Scalar) -> Matrix:
    """Active right-handed rotation about a coordinate axis, by the cosine and sine."""
    if axis == "x":
        return [[1, 0, 0], [0, c, -s], [0, s, c]]
    if axis == "y":
        return [[c, 0, s], [0, 1, 0], [-s, 0, c]]
    return [[c, -s, 0], [s, c, 0], [0, 0, 1]]


def rotation(ops: Ops, axis: str, angle: Scalar) -> Matrix:
    """Active right-handed rotation about a coordinate axis."""
    return turn_matrix(axis, ops.cos(angle), ops.sin(angle))


def turn(ops: Ops, axis: str, angle: Scalar) -> Matrix:
    """Homogeneous 4x4 form of a rotation."""
    return [[*row, 0] for row in rotation(ops, axis, angle)] + [[0, 0, 0, 1]]


def shift(axis: str, length: Scalar) -> Matrix:
    """Homogeneous 4x4 form of a translation along a coordinate axis."""
    return [
        [1, 0, 0, length if axis == "x" else 0],
        [0, 1, 0, length if axis == "y" else 0],
        [0, 0, 1, length if axis == "z" else 0],
        [0, 0, 0, 1],
    ]


def column(m: Matrix, axis: str | None = None) -> Vector:
    """Upper three entries of an axis' column; of the last column (the origin) without an axis."""
    j = "xyz".index(axis) if axis else 3
    return [m[i][j] for i in range(3)]
