"""Direction angles of a vector, as nodes with a derivative rule of their own.

Through atan2 and hypot, the chain rule would differentiate the length of the vector and divide by
it again; for a unit vector that length is 1 and cannot change, so the rule is shorter:
with rho the horizontal length, d(azimuth) = (y dx - x dy) / rho^2 and d(elevation) = dz / rho.
"""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.algebra import vector as v


@dataclass(frozen=True, eq=False)
class Azimuth(s.Scalar):
    """Angle from the y axis towards the x axis: from north, clockwise, in east-north-up axes."""

    vector: v.Vector

    def explicit(self) -> s.Scalar:
        return s.ArcTangent(self.vector.x, self.vector.y)


@dataclass(frozen=True, eq=False)
class Elevation(s.Scalar):
    """Angle above the xy plane."""

    vector: v.Vector

    def explicit(self) -> s.Scalar:
        return s.ArcTangent(self.vector.z, horizontal_length(self.vector))


def direction_angles(vector: v.Vector) -> tuple[s.Scalar, s.Scalar]:
    """Azimuth in [-pi, pi] and elevation in [-pi/2, pi/2]; the azimuth is free at the zenith."""
    return Azimuth(vector), Elevation(vector)


def atan2_or_zero(y: s.ScalarLike, x: s.ScalarLike, free: s.Condition) -> s.Scalar:
    """`atan2(y, x)`, and 0 where the angle is free: (0, 0) is not met there."""
    return s.atan2(s.where(free, s.ZERO, y), s.where(free, s.ONE, x))


def full_turn(angle: s.Scalar) -> s.Scalar:
    """An angle from [-pi, pi] in [0, 2 pi); what rounds to 2 pi becomes 0."""
    turn = s.multiply(s.number(2), s.PI)
    positive = s.where(s.Less(angle, s.ZERO), s.add(angle, turn), angle)
    return s.where(s.Less(positive, turn), positive, s.ZERO)


def horizontal_length(vector: v.Vector) -> s.Scalar:
    """Length of a vector's projection on the xy plane."""
    return s.hypot(vector.x, vector.y)


def is_unit(node: v.Vector) -> bool:
    """Whether a vector is known to have norm 1."""
    if isinstance(node, (v.Basis, v.Unit)):
        return True
    if isinstance(node, v.Rotated):
        return is_unit(node.vector)
    if isinstance(node, v.VectorNegate):
        return is_unit(node.argument)
    if isinstance(node, v.VectorReference):
        return is_unit(node.expression)
    return isinstance(node, v.VectorSymbol) and node.unit_norm
