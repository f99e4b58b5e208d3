"""Legs on universal joints: two crossed axes make a leg spin about itself.

The first axis is fixed to the base, the second is square to it and to the leg. In the leg's axes
(y along the leg, x along the second axis, z = x cross y) everything is short: the first axis is
(0, s, c) there, with the sine and cosine of the angle psi about the second. An angular velocity
has no part square to both axes, so that a leg which is turned about x cross y spins about y by
the tangent of psi. A leg that is taken as free of spin, as papers do, has none.
"""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra.rigid import Wrench
from armillary.algebra.scalar import ONE, ZERO, Scalar
from armillary.algebra.vector import Vector, vector
from armillary.mechanism.attitude import Axes


def second_axis(direction: Vector, first: Vector) -> Vector:
    """Along the second axis of the joint, as long as the cosine of psi.

    Args:
        direction: along the leg, of length 1.
        first: the first axis, of length 1, in the same frame.
    """
    return direction.cross(first)


def leg_axes(direction: Vector, second: Vector) -> Axes:
    """The leg's axes, by its direction and the second axis of its joint, both of length 1."""
    return Axes(second, direction, second.cross(direction))


@dataclass(frozen=True, eq=False)
class UniversalLeg:
    """A leg on a universal joint, everything in its own axes.

    The motion of a leg is told by the rate of its direction, (x, 0, z), and by the acceleration of
    its direction, of which y follows from the rate.

    Attributes:
        tangent: of psi; None for a leg without spin.
    """

    length: Scalar
    tangent: Scalar | None = None

    def turning(self, velocity: Vector) -> Vector:
        """Rate of the direction, by the velocity of the leg's end."""
        return vector(velocity.x / self.length, ZERO, velocity.z / self.length)

    def turning_rate(self, velocity: Vector, acceleration: Vector, turning: Vector) -> Vector:
        """Acceleration of the direction, by the velocity and acceleration of the leg's end."""
        extension = 2 * velocity.y
        return vector(
            (acceleration.x - extension * turning.x) / self.length,
            -(turning.x * turning.x + turning.z * turning.z),
            (acceleration.z - extension * turning.z) / self.length,
        )

    def spin(self, turning: Vector) -> Scalar:
        """Angular velocity about itself."""
        return ZERO if self.tangent is None else -(turning.x * self.tangent)

    def spin_rate(self, turning: Vector, turning_rate: Vector) -> Scalar:
        """Angular acceleration about itself."""
        if self.tangent is None:
            return ZERO
        carried = turning.x * turning.z * (ONE + 2 * (self.tangent * self.tangent))
        return -(self.tangent * turning_rate.x + carried)

    def angular_velocity(self, turning: Vector, spin: Scalar) -> Vector:
        """Direction cross its rate, and the spin."""
        return vector(turning.z, spin, -turning.x)

    def angular_acceleration(
        self, turning: Vector, turning_rate: Vector, spin: Scalar, spin_rate: Scalar
    ) -> Vector:
        """Rate of the angular velocity, as a vector of the base."""
        return vector(
            turning_rate.z + spin * turning.x, spin_rate, spin * turning.z - turning_rate.x
        )

    def asked(self, demand: Wrench) -> Vector:
        """The force f at its end that does the work of a demand.

        For every velocity v of the end f.v = moment.omega + force.y v.y, with the angular velocity
        omega that the joint (or freedom from spin) gives the leg then. The joint itself takes the
        part of the moment that does no work.

        Args:
            demand: about the joint: the moment that moves the whole leg, and the force that moves
                what slides, of which only the part along the leg is taken. What its parts across
                the leg do is in the moment.

        Returns:
            The force, in the leg's axes.
        """
        moment = demand.moment
        across = moment.z if self.tangent is None else moment.z + self.tangent * moment.y
        return vector(-(across / self.length), demand.force.y, moment.x / self.length)
