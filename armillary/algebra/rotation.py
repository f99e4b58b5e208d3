"""Rotations, kept as products of factors: elementary rotations, and those given from outside.

`a_R_b` maps components in b to components in a. Elementary rotations are active and right-handed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, overload

from armillary.algebra.misuse import MisuseError, told, told_shortly
from armillary.algebra.scalar import Scalar, ScalarLike, as_scalar, negate
from armillary.algebra.vector import NULL, Rotated, Vector, component

if TYPE_CHECKING:
    from armillary.algebra.rigid import Matrix


@dataclass(frozen=True, eq=False, repr=False)
class Rotation:
    """A proper orthonormal 3 by 3 matrix."""

    def __repr__(self) -> str:
        # The whole expression would take for ever: what is shared would be written each time.
        return told_shortly(self)

    @overload
    def __matmul__(self, other: Rotation) -> Rotation: ...
    @overload
    def __matmul__(self, other: Vector) -> Vector: ...
    def __matmul__(self, other: Rotation | Vector) -> Rotation | Vector:
        if isinstance(other, Vector):
            return rotate(self, other)
        return compose(self, other)

    def transpose(self) -> Rotation:
        return transpose(self)

    def column(self, index: int) -> Vector:
        """Axis 0 (x), 1 (y) or 2 (z) of the inner frame, in the outer one."""
        from armillary.algebra.vector import Basis

        return rotate(self, Basis(_axis(index)))

    def entry(self, row: int, column: int) -> Scalar:
        """One entry of the matrix; rows and columns count from 0, so X, Y and Z name them."""
        return component(self.column(column), _axis(row))

    def matrix(self) -> Matrix:
        """The nine entries."""
        from armillary.algebra.rigid import Matrix

        columns = [self.column(j) for j in range(3)]
        return Matrix(tuple(tuple(component(c, i) for c in columns) for i in range(3)))


@dataclass(frozen=True, eq=False, repr=False)
class Elementary(Rotation):
    """Rotation by an angle about axis 0 (x), 1 (y) or 2 (z)."""

    axis: int
    angle: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class RotationSymbol(Rotation):
    """A named rotation: the nine entries of its matrix come from outside the derivation."""

    name: str

    def velocity(self) -> Vector:
        """Its angular velocity in the outer frame; a plain symbol is held."""
        return NULL


@dataclass(frozen=True, eq=False, repr=False)
class Transposed(Rotation):
    """The inverse of a named rotation."""

    symbol: RotationSymbol


Factor = Elementary | RotationSymbol | Transposed


@dataclass(frozen=True, eq=False, repr=False)
class Composed(Rotation):
    """The product of its factors, outermost first; the identity when there are none."""

    factors: tuple[Factor, ...]


@dataclass(frozen=True, eq=False, repr=False)
class RotationReference(Rotation):
    """A defined rotation: the name stands for the product, which is kept."""

    name: str
    identifier: str
    expression: Rotation


IDENTITY = Composed(())


def elementary(axis: int, angle: ScalarLike) -> Rotation:
    """The active right-handed rotation about one axis of the frame."""
    return Elementary(axis, as_scalar(angle))


def factors(rotation: Rotation) -> tuple[Factor, ...]:
    """What a rotation is the product of, outermost first."""
    if isinstance(rotation, Factor):
        return (rotation,)
    if isinstance(rotation, Composed):
        return rotation.factors
    if isinstance(rotation, RotationReference):
        return factors(rotation.expression)
    raise TypeError(f"not a product of rotations: {rotation!r}")


def keeps_norms(rotation: Rotation) -> bool:
    """Whether it keeps norms by its form; one given by its entries does so within their errors."""
    return all(isinstance(f, Elementary) for f in factors(rotation))


def compose(left: Rotation, right: Rotation) -> Rotation:
    """The product of two rotations, as one chain of factors."""
    return Composed(factors(left) + factors(right))


def transpose(rotation: Rotation) -> Rotation:
    """The inverse rotation: the reversed chain of inverse factors."""
    return Composed(tuple(_inverse(f) for f in reversed(factors(rotation))))


def _inverse(factor: Factor) -> Factor:
    if isinstance(factor, Elementary):
        return Elementary(factor.axis, negate(factor.angle))
    return factor.symbol if isinstance(factor, Transposed) else Transposed(factor)


def rotate(rotation: Rotation, vector: Vector) -> Vector:
    """A vector carried into the outer frame; the null vector and the identity change nothing."""
    from armillary.algebra.vector import is_null

    if is_null(vector) or not factors(rotation):
        return vector
    return Rotated(rotation, vector)


def _axis(index: int) -> int:
    if index not in (0, 1, 2):
        raise MisuseError(
            f"a rotation has no row or column {told(index)}",
            "rows and columns count from 0 to 2: X, Y and Z name them",
        )
    return index
