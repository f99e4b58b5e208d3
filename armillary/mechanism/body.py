"""Rigid bodies: what moves them, in their own axes.

A body is asked for nothing but its motion: the wrench that it takes to give it that motion against
its weight. What a wrench does along the motions that a mechanism permits is its virtual work.
"""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra.rigid import Wrench
from armillary.algebra.scalar import Scalar
from armillary.algebra.vector import Vector, vector


@dataclass(frozen=True, eq=False)
class Body:
    """A rigid body about its centre of mass, or about a point of it that stands still.

    Attributes:
        inertia: principal moments about that point, in the axes that the motion is given in.
    """

    mass: Scalar
    inertia: Vector

    def angular_momentum(self, spin: Vector) -> Vector:
        """About that point, at an angular velocity."""
        a, b, c = (self.inertia[k] for k in range(3))
        return vector(a * spin.x, b * spin.y, c * spin.z)

    def moment(self, spin: Vector, spin_rate: Vector) -> Vector:
        """The moment that turns it so, about that point: Euler's equations.

        Args:
            spin: its angular velocity, in its own axes.
            spin_rate: its angular acceleration, which is a vector of the base, in its own axes.
        """
        a, b, c = (self.inertia[k] for k in range(3))
        return vector(
            a * spin_rate.x + (c - b) * (spin.y * spin.z),
            b * spin_rate.y + (a - c) * (spin.z * spin.x),
            c * spin_rate.z + (b - a) * (spin.x * spin.y),
        )

    def force(self, acceleration: Vector) -> Vector:
        """The force that accelerates its centre of mass so.

        Args:
            acceleration: less that of free fall, where the force has to carry its weight too.
        """
        return self.mass * acceleration

    def demand(self, acceleration: Vector, spin: Vector, spin_rate: Vector) -> Wrench:
        """The wrench about its centre of mass that moves it so."""
        return Wrench(self.moment(spin, spin_rate), self.force(acceleration))

    def kinetic_energy(self, velocity: Vector, spin: Vector) -> Scalar:
        """Of its centre of mass, and of its turning about it.

        For a body that turns about a point that stands still the velocity is null.
        """
        turning = spin.dot(self.angular_momentum(spin))
        return (self.mass * velocity.dot(velocity) + turning) / 2
