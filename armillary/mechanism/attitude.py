"""Attitudes that no product of elementary rotations makes: by their axes, and by their normal.

A platform on three legs that may not turn about its own normal is tilted without torsion: about a
level axis, by the shortest way. The tilt follows from the normal alone, without an angle:

    R v = v - ((z + n).v) / (1 + n_z) (z + n) + 2 v_z n
"""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra.rigid import Matrix
from armillary.algebra.scalar import ONE, Scalar
from armillary.algebra.vector import (
    NULL,
    Basis,
    Vector,
    add_vectors,
    component,
    cross,
    scale,
    vector,
)

_Z = Basis(2)


@dataclass(frozen=True, eq=False)
class Axes:
    """A rotation by its three axes, components in the outer frame; nobody checks that it is one."""

    x: Vector
    y: Vector
    z: Vector

    def __matmul__(self, inner: Vector) -> Vector:
        """A vector carried into the outer frame."""
        if isinstance(inner, Basis):
            return self.column(inner.axis)
        carried: Vector = NULL
        for k in range(3):
            carried = add_vectors(carried, scale(component(inner, k), self.column(k)))
        return carried

    @property
    def columns(self) -> tuple[Vector, Vector, Vector]:
        """The three axes."""
        return self.x, self.y, self.z

    def column(self, index: int) -> Vector:
        """Axis 0 (x), 1 (y) or 2 (z) of the inner frame, in the outer one."""
        return self.columns[index]

    def matrix(self) -> Matrix:
        """The nine entries."""
        return Matrix(tuple(tuple(component(c, i) for c in self.columns) for i in range(3)))

    def back(self, outer: Vector) -> Vector:
        """A vector of the outer frame in the inner one."""
        return vector(self.x.dot(outer), self.y.dot(outer), self.z.dot(outer))


def tilted(normal: Vector, lean: Scalar | None = None) -> Axes:
    """The rotation without torsion that takes the z axis to a normal of length 1.

    Args:
        lean: 1 + n_z where it is known, kept from being 0 by the caller.
    """
    divisor = lean if lean is not None else ONE + normal.z
    a, b = normal.x / divisor, normal.y / divisor
    mixed = -(a * normal.y)
    return Axes(
        vector(1 - a * normal.x, mixed, -normal.x),
        vector(mixed, 1 - b * normal.y, -normal.y),
        normal,
    )


def tilting(normal: Vector, change: Vector, lean: Scalar | None = None) -> Vector:
    """Angular velocity of `tilted(normal)` while the normal changes at the rate `change`.

    (z + n) cross n' / (1 + n_z): a tilt that stays without torsion still turns about its normal.
    """
    divisor = lean if lean is not None else ONE + normal.z
    return cross(add_vectors(_Z, normal), change) / divisor
