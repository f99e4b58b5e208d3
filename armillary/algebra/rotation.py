"""Rotations, kept as products of elementary rotations.

`a_R_b` maps components in b to components in a. Elementary rotations are active and right-handed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import overload

from armillary.algebra.scalar import Scalar, ScalarLike, as_scalar, negate
from armillary.algebra.vector import Rotated, Vector


@dataclass(frozen=True, eq=False)
class Rotation:
    """A proper orthonormal 3 by 3 matrix."""

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
        from armillary.algebra.vector import Basis

        return rotate(self, Basis(index))


@dataclass(frozen=True, eq=False)
class Elementary(Rotation):
    """Rotation by an angle about axis 0 (x), 1 (y) or 2 (z)."""

    axis: int
    angle: Scalar


@dataclass(frozen=True, eq=False)
class Composed(Rotation):
    """The product of its factors, outermost first; the identity when there are none."""

    factors: tuple[Elementary, ...]


@dataclass(frozen=True, eq=False)
class RotationReference(Rotation):
    """A defined rotation: the name stands for the product, which is kept."""

    name: str
    identifier: str
    expression: Rotation


IDENTITY = Composed(())


def elementary(axis: int, angle: ScalarLike) -> Rotation:
    """The active right-handed rotation about one axis of the frame."""
    return Elementary(axis, as_scalar(angle))


def factors(rotation: Rotation) -> tuple[Elementary, ...]:
    """The elementary rotations of a product, outermost first."""
    if isinstance(rotation, Elementary):
        return (rotation,)
    if isinstance(rotation, Composed):
        return rotation.factors
    if isinstance(rotation, RotationReference):
        return factors(rotation.expression)
    raise TypeError(f"not a product of elementary rotations: {rotation!r}")


def compose(left: Rotation, right: Rotation) -> Rotation:
    """The product of two rotations, as one chain of elementary ones."""
    return Composed(factors(left) + factors(right))


def transpose(rotation: Rotation) -> Rotation:
    """The inverse rotation: the reversed chain with opposite angles."""
    reverse = reversed(factors(rotation))
    return Composed(tuple(Elementary(f.axis, negate(f.angle)) for f in reverse))


def rotate(rotation: Rotation, vector: Vector) -> Vector:
    """A vector carried into the outer frame; the null vector and the identity change nothing."""
    from armillary.algebra.vector import is_null

    if is_null(vector) or not factors(rotation):
        return vector
    return Rotated(rotation, vector)
