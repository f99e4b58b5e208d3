"""Vectors of three components, kept whole until the program is printed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from armillary.algebra.misuse import told_shortly
from armillary.algebra.scalar import (
    ONE,
    ZERO,
    Component,
    Divide,
    Dot,
    Given,
    Negate,
    Scalar,
    ScalarLike,
    SquareRoot,
    as_scalar,
    is_one,
    is_zero,
    negate,
)

if TYPE_CHECKING:
    from armillary.algebra.rotation import Rotation

AXIS_NAMES = "xyz"


@dataclass(frozen=True, eq=False, repr=False)
class Vector:
    """Three components in one frame."""

    def __repr__(self) -> str:
        # The whole expression would take for ever: what is shared would be written each time.
        return told_shortly(self)

    @property
    def x(self) -> Scalar:
        return component(self, 0)

    @property
    def y(self) -> Scalar:
        return component(self, 1)

    @property
    def z(self) -> Scalar:
        return component(self, 2)

    def __getitem__(self, index: int) -> Scalar:
        return component(self, index)

    def __add__(self, other: Vector) -> Vector:
        return add_vectors(self, other)

    def __sub__(self, other: Vector) -> Vector:
        return add_vectors(self, negate_vector(other))

    def __neg__(self) -> Vector:
        return negate_vector(self)

    def __mul__(self, factor: ScalarLike) -> Vector:
        return scale(as_scalar(factor), self)

    __rmul__ = __mul__

    def __truediv__(self, divisor: ScalarLike) -> Vector:
        return scale(Divide(ONE, as_scalar(divisor)), self)

    def dot(self, other: Vector) -> Scalar:
        return dot(self, other)

    def cross(self, other: Vector) -> Vector:
        return cross(self, other)

    def norm(self) -> Scalar:
        return norm(self)


@dataclass(frozen=True, eq=False, repr=False)
class Components(Vector):
    """A vector written by its components."""

    components: tuple[Scalar, Scalar, Scalar]


@dataclass(frozen=True, eq=False, repr=False)
class Basis(Vector):
    """One of the unit vectors of the frame it is written in (0 is x, 1 is y, 2 is z)."""

    axis: int


@dataclass(frozen=True, eq=False, repr=False)
class VectorSymbol(Vector):
    """A named vector whose components come from outside the derivation."""

    name: str

    @property
    def unit_norm(self) -> bool:
        """Whether its norm is known to be 1."""
        return False

    def velocity(self) -> Vector:
        """Its time derivative; a plain symbol is held."""
        return NULL


@dataclass(frozen=True, eq=False, repr=False)
class VectorSum(Vector):
    """A sum of two vectors in one frame."""

    left: Vector
    right: Vector


@dataclass(frozen=True, eq=False, repr=False)
class VectorNegate(Vector):
    """The opposite vector."""

    argument: Vector


@dataclass(frozen=True, eq=False, repr=False)
class Scaled(Vector):
    """A vector times a scalar."""

    factor: Scalar
    vector: Vector


@dataclass(frozen=True, eq=False, repr=False)
class Cross(Vector):
    """The cross product of two vectors in one frame."""

    left: Vector
    right: Vector


@dataclass(frozen=True, eq=False, repr=False)
class Unit(Vector):
    """The direction of a vector: known to have norm 1."""

    vector: Vector


@dataclass(frozen=True, eq=False, repr=False)
class Rotated(Vector):
    """A vector carried into the outer frame of a rotation."""

    rotation: Rotation
    vector: Vector


@dataclass(frozen=True, eq=False, repr=False)
class Choice(Vector):
    """Equal expressions of one vector; the program takes the direction that costs least.

    Attributes:
        nested: carried from the innermost frame out.
        summed: a sum of terms, each carried to the base by itself.
        merged: nested, with parallel axes turned by the sum of their angles.
        inner: cross products with a joint's axis taken after the joint's own turn.
    """

    nested: Vector
    summed: Vector
    merged: Vector
    inner: Vector


@dataclass(frozen=True, eq=False, repr=False)
class VectorReference(Vector):
    """A defined vector: the name stands for the expression, which is kept.

    `given` tells what `substitute` replaced in it.
    """

    name: str
    identifier: str
    expression: Vector
    given: Given | None = None


NULL = Components((ZERO, ZERO, ZERO))


def vector(x: ScalarLike, y: ScalarLike, z: ScalarLike) -> Vector:
    """A vector from its components."""
    return Components((as_scalar(x), as_scalar(y), as_scalar(z)))


def is_null(node: Vector) -> bool:
    """Whether a vector is the null vector."""
    return isinstance(node, Components) and all(is_zero(c) for c in node.components)


def component(node: Vector, index: int) -> Scalar:
    """One component, opened where it is known."""
    if isinstance(node, Components):
        return node.components[index]
    if isinstance(node, Basis):
        return ONE if node.axis == index else ZERO
    return Component(node, index)


def add_vectors(left: Vector, right: Vector) -> Vector:
    """The sum, without a null term."""
    if is_null(left):
        return right
    if is_null(right):
        return left
    return VectorSum(left, right)


def negate_vector(node: Vector) -> Vector:
    """The opposite; two signs cancel."""
    if is_null(node):
        return node
    return node.argument if isinstance(node, VectorNegate) else VectorNegate(node)


def scale(factor: Scalar, node: Vector) -> Vector:
    """A multiple, with its sign outside."""
    if is_zero(factor) or is_null(node):
        return NULL
    if is_one(factor):
        return node
    if isinstance(factor, Negate):
        return negate_vector(scale(negate(factor), node))
    return Scaled(factor, node)


def dot(left: Vector, right: Vector) -> Scalar:
    """The dot product; with a basis vector it is a component."""
    if is_null(left) or is_null(right):
        return ZERO
    if isinstance(left, Basis):
        return component(right, left.axis)
    if isinstance(right, Basis):
        return component(left, right.axis)
    return Dot(left, right)


def cross(left: Vector, right: Vector) -> Vector:
    """The cross product; null if a factor is."""
    if is_null(left) or is_null(right):
        return NULL
    return Cross(left, right)


def choice(nested: Vector, summed: Vector, merged: Vector, inner: Vector | None = None) -> Vector:
    """One vector in its equal forms; a null vector has no form to choose."""
    return nested if is_null(nested) else Choice(nested, summed, merged, inner or nested)


def norm(node: Vector) -> Scalar:
    """The length of a vector."""
    return SquareRoot(Dot(node, node))


def unit(node: Vector) -> Vector:
    """The direction of a vector that is never null where the kernel is called."""
    return Unit(node)
