"""Rigid transforms, twists and wrenches, hat and vee, and matrices of scalars."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from armillary.algebra.rotation import Rotation, rotate, transpose
from armillary.algebra.scalar import ONE, ZERO, Scalar, ScalarLike, as_scalar, negate
from armillary.algebra.vector import (
    Components,
    Vector,
    add_vectors,
    component,
    cross,
    negate_vector,
)


@dataclass(frozen=True, eq=False, repr=False)
class Matrix:
    """A rectangular array of scalars."""

    rows: tuple[tuple[Scalar, ...], ...]

    def __post_init__(self) -> None:
        if len({len(row) for row in self.rows}) != 1:
            raise ValueError("the rows of a matrix must have one length")

    @property
    def shape(self) -> tuple[int, int]:
        return len(self.rows), len(self.rows[0])

    def column_vector(self, index: int) -> Vector:
        """The first three entries of a column."""
        return Components((self.rows[0][index], self.rows[1][index], self.rows[2][index]))


@dataclass(frozen=True, eq=False, repr=False)
class Pose:
    """`a_T_b`: the rotation `a_R_b` and the position `a_p_b` of b's origin in a."""

    rotation: Rotation
    position: Vector

    def __matmul__(self, other: Pose) -> Pose:
        return Pose(
            self.rotation @ other.rotation,
            add_vectors(self.position, rotate(self.rotation, other.position)),
        )

    def inverse(self) -> Pose:
        back = transpose(self.rotation)
        return Pose(back, negate_vector(rotate(back, self.position)))

    def point(self, inner: Vector) -> Vector:
        """Coordinates in a of a point given in b."""
        return add_vectors(self.position, rotate(self.rotation, inner))

    def matrix(self) -> Matrix:
        """The homogeneous 4 by 4 matrix."""
        columns = [self.rotation.column(j) for j in range(3)] + [self.position]
        top = tuple(tuple(component(c, i) for c in columns) for i in range(3))
        return Matrix((*top, (ZERO, ZERO, ZERO, ONE)))


@dataclass(frozen=True, eq=False, repr=False)
class Twist:
    """Angular velocity and the velocity of one point, both in one frame."""

    angular: Vector
    linear: Vector

    def matrix(self) -> Matrix:
        """The 4 by 4 velocity matrix [hat(angular), linear; 0, 0]."""
        skew = hat(self.angular).rows
        top = tuple((*skew[i], component(self.linear, i)) for i in range(3))
        return Matrix((*top, (ZERO, ZERO, ZERO, ZERO)))

    def at(self, offset: Vector) -> Twist:
        """The same motion seen at the point displaced by `offset`."""
        return Twist(self.angular, add_vectors(self.linear, cross(self.angular, offset)))


@dataclass(frozen=True, eq=False, repr=False)
class Wrench:
    """A force and the moment about one point, both in one frame."""

    moment: Vector
    force: Vector

    def power(self, twist: Twist) -> Scalar:
        """Power on a motion given about the same point."""
        return self.force.dot(twist.linear) + self.moment.dot(twist.angular)


def matrix(*rows: Sequence[ScalarLike]) -> Matrix:
    """A matrix, row by row."""
    return Matrix(tuple(tuple(map(as_scalar, row)) for row in rows))


def hat(vector: Vector) -> Matrix:
    """The skew matrix whose product with b is the cross product with b."""
    x, y, z = (component(vector, i) for i in range(3))
    return Matrix(((ZERO, negate(z), y), (z, ZERO, negate(x)), (negate(y), x, ZERO)))


def vee(matrix: Matrix) -> Vector:
    """The vector of a skew matrix: the inverse of `hat`."""
    rows = matrix.rows
    return Components((rows[2][1], rows[0][2], rows[1][0]))


def stack_twists(twists: tuple[Twist, ...]) -> Matrix:
    """A 6 by k Jacobian: rows are the linear part over the angular part."""
    linear = tuple(tuple(component(t.linear, i) for t in twists) for i in range(3))
    angular = tuple(tuple(component(t.angular, i) for t in twists) for i in range(3))
    return Matrix(linear + angular)
