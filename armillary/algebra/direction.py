"""Direction angles of a vector, as nodes with a derivative rule of their own.

Through atan2 and hypot, the chain rule would differentiate the length of the vector and divide by
it again. But a direction has no length, and a rotation turns it without knowing one: with sine and
cosine of the azimuth and the tangent of the elevation, the angles of a vector that turns with the
angular velocity w change by t (w_x sin + w_y cos) - w_z and by w_x cos - w_y sin. The rules are in
`derivative`; the nodes, which depend on nothing but the direction, are here.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.functions import atan2, hypot, where
from armillary.algebra.rotation import keeps_norms


@dataclass(frozen=True, eq=False, repr=False)
class OfDirection(s.Scalar, ABC):
    """A scalar that is the same for every positive multiple of the vector."""

    vector: v.Vector

    @abstractmethod
    def explicit(self) -> s.Scalar:
        """The same by the vector's components."""


@dataclass(frozen=True, eq=False, repr=False)
class Azimuth(OfDirection):
    """Angle from the y axis towards the x axis: from north, clockwise, in east-north-up axes."""

    def explicit(self) -> s.Scalar:
        return s.ArcTangent(self.vector.x, self.vector.y)


@dataclass(frozen=True, eq=False, repr=False)
class Elevation(OfDirection):
    """Angle above the xy plane."""

    def explicit(self) -> s.Scalar:
        return s.ArcTangent(self.vector.z, horizontal_length(self.vector))


@dataclass(frozen=True, eq=False, repr=False)
class AzimuthSine(OfDirection):
    """Sine of the azimuth; not defined on the z axis, like the next two."""

    def explicit(self) -> s.Scalar:
        return s.Divide(self.vector.x, horizontal_length(self.vector))


@dataclass(frozen=True, eq=False, repr=False)
class AzimuthCosine(OfDirection):
    """Cosine of the azimuth."""

    def explicit(self) -> s.Scalar:
        return s.Divide(self.vector.y, horizontal_length(self.vector))


@dataclass(frozen=True, eq=False, repr=False)
class ElevationTangent(OfDirection):
    """Tangent of the elevation."""

    def explicit(self) -> s.Scalar:
        return s.Divide(self.vector.z, horizontal_length(self.vector))


def direction_angles(vector: v.Vector) -> tuple[s.Scalar, s.Scalar]:
    """Azimuth in [-pi, pi] and elevation in [-pi/2, pi/2]; the azimuth is free at the zenith."""
    return Azimuth(vector), Elevation(vector)


def atan2_or_zero(y: s.ScalarLike, x: s.ScalarLike, free: s.Condition) -> s.Scalar:
    """`atan2(y, x)`, and 0 where the angle is free: (0, 0) is not met there."""
    return atan2(where(free, s.ZERO, y), where(free, s.ONE, x))


def full_turn(angle: s.Scalar) -> s.Scalar:
    """An angle from [-pi, pi] in [0, 2 pi); what rounds to 2 pi becomes 0."""
    turn = s.multiply(s.number(2), s.PI)
    positive = where(s.Less(angle, s.ZERO), s.add(angle, turn), angle)
    return where(s.Less(positive, turn), positive, s.ZERO)


def horizontal_length(vector: v.Vector) -> s.Scalar:
    """Length of a vector's projection on the xy plane."""
    return hypot(vector.x, vector.y)


def is_unit(node: v.Vector) -> bool:
    """Whether a vector is known to have norm 1."""
    if isinstance(node, (v.Basis, v.Unit)):
        return True
    if isinstance(node, v.Rotated):
        return keeps_norms(node.rotation) and is_unit(node.vector)
    if isinstance(node, v.VectorNegate):
        return is_unit(node.argument)
    if isinstance(node, v.VectorReference):
        return is_unit(node.expression)
    return isinstance(node, v.VectorSymbol) and node.unit_norm


def of_the_same_length(node: v.Vector) -> v.Vector:
    """The vector inside turns, signs and names, which leave a length alone."""
    while True:
        if isinstance(node, v.Rotated) and keeps_norms(node.rotation):
            node = node.vector
        elif isinstance(node, v.VectorNegate):
            node = node.argument
        elif isinstance(node, v.VectorReference):
            node = node.expression
        else:
            return node


def normalised_in(node: v.Vector) -> v.Unit | None:
    """The unit vector that a vector is, but for turns, names and its sign."""
    inner = of_the_same_length(node)
    return inner if isinstance(inner, v.Unit) else None
