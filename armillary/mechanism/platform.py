"""Parallel platforms: a moving body on legs, and what follows from one pose of it.

A leg joins a point of the base to a point of the platform and changes its length. Its lower joint
is a revolute joint, which keeps the leg in one plane (RPS), or a universal joint, which keeps it
nowhere (UPS); its upper joint is spherical. Every motion of a leg is a row that multiplies the
platform's twist, and a row is a wrench: what a unit of force or moment at that joint does to the
platform. Like legs are one leg whose points are per part of an index.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from armillary.algebra.misuse import MisuseError
from armillary.algebra.rigid import Matrix, Twist, Wrench
from armillary.algebra.scalar import ZERO, Scalar, add
from armillary.algebra.vector import Vector, component, unit


class Carrier(Protocol):
    """What carries a vector from the platform's axes to the base's."""

    def __matmul__(self, inner: Vector, /) -> Vector: ...


class Placed(Protocol):
    """Where a platform is: a `Pose`, or anything else with an attitude and a position."""

    @property
    def rotation(self) -> Carrier: ...
    @property
    def position(self) -> Vector: ...


@dataclass(frozen=True, eq=False)
class Place:
    """A pose whose attitude is no product of elementary rotations."""

    rotation: Carrier
    position: Vector


@dataclass(frozen=True, eq=False)
class Leg:
    """A leg by its two joints.

    Attributes:
        base_joint: the lower joint, in the base frame.
        platform_joint: the upper joint, in the platform's frame.
        plane: axis of a revolute lower joint, in the base frame, of length 1: the normal of the
            plane that the leg is kept in; None for a universal joint.
    """

    base_joint: Vector
    platform_joint: Vector
    plane: Vector | None = None


@dataclass(frozen=True, eq=False)
class Platform:
    """A body on legs.

    Attributes:
        legs: one leg that stands for all like it, or as many unlike ones as there are.
    """

    pose: Placed
    legs: tuple[Leg, ...]

    @property
    def placed(self) -> tuple[PlacedLeg, ...]:
        """The legs in this pose."""
        return tuple(PlacedLeg(self.pose, leg) for leg in self.legs)

    @property
    def leg(self) -> PlacedLeg:
        """The leg that stands for all.

        Raises:
            MisuseError: if the legs are unlike.
        """
        if len(self.legs) != 1:
            raise MisuseError(
                f"the platform has {len(self.legs)} unlike legs", "take one of .placed"
            )
        return self.placed[0]

    def loop_closure(self, lengths: Sequence[Scalar]) -> tuple[Scalar, ...]:
        """What is zero, a leg each, where the legs have these lengths."""
        return tuple(leg.closure(length) for leg, length in zip(self.placed, lengths, strict=True))


@dataclass(frozen=True, eq=False)
class PlacedLeg:
    """A leg in a pose of the platform; everything in the base frame.

    A twist is that of the platform at its origin, a row is about that origin.
    """

    pose: Placed
    leg: Leg

    @property
    def arm(self) -> Vector:
        """From the platform's origin to the upper joint."""
        return self.pose.rotation @ self.leg.platform_joint

    @property
    def joint(self) -> Vector:
        """Position of the upper joint."""
        return self.pose.position + self.arm

    @property
    def vector(self) -> Vector:
        """From the lower joint to the upper one."""
        return self.joint - self.leg.base_joint

    @property
    def length(self) -> Scalar:
        return self.vector.norm()

    @property
    def direction(self) -> Vector:
        """Along the leg, of length 1; the leg may not be of length 0."""
        return unit(self.vector)

    def closure(self, length: Scalar) -> Scalar:
        """Zero where the leg has this length: a difference of squares, smooth everywhere."""
        vector = self.vector
        return vector.dot(vector) - length * length

    def joint_velocity(self, twist: Twist) -> Vector:
        """Velocity of the upper joint."""
        return twist.at(self.arm).linear

    # -- the length ---------------------------------------------------------------------------

    @property
    def row(self) -> Wrench:
        """Of the length: a unit of force along the leg."""
        return self.across(self.direction)

    def extension_rate(self, twist: Twist) -> Scalar:
        """Rate of the length."""
        return self.row.power(twist)

    # -- the plane ----------------------------------------------------------------------------

    @property
    def plane(self) -> Vector:
        """Axis of the revolute joint.

        Raises:
            MisuseError: if the leg has none.
        """
        if self.leg.plane is None:
            raise MisuseError(
                "a leg on a universal joint is kept in no plane", "give Leg(..., plane=axis)"
            )
        return self.leg.plane

    @property
    def plane_residual(self) -> Scalar:
        """Distance of the upper joint from the plane of the revolute joint: zero in a true pose."""
        return self.plane.dot(self.vector)

    @property
    def plane_row(self) -> Wrench:
        """Of that distance: a unit of force along the revolute joint's axis."""
        return self.across(self.plane)

    # -- turning ------------------------------------------------------------------------------

    @property
    def turn_row(self) -> Wrench:
        """Of the revolute joint's angle, right-handed about its axis: m^-1 and 1."""
        return self.across(self.plane.cross(self.direction) / self.length)

    def turn_rate(self, twist: Twist) -> Scalar:
        """Rate of the revolute joint's angle."""
        return self.turn_row.power(twist)

    def angular_velocity(self, twist: Twist) -> Vector:
        """Of the leg: about the revolute joint's axis, or square to a leg that does not spin."""
        if self.leg.plane is not None:
            return self.turn_rate(twist) * self.leg.plane
        return self.direction.cross(self.joint_velocity(twist)) / self.length

    def across(self, direction: Vector) -> Wrench:
        """The row of the upper joint's way along a direction."""
        return Wrench(self.arm.cross(direction), direction)


def stack_wrenches(*wrenches: Wrench) -> Matrix:
    """Rows that multiply twists: the linear part first, then the angular part."""
    return Matrix(
        tuple(
            tuple(component(part, k) for part in (w.force, w.moment) for k in range(3))
            for w in wrenches
        )
    )


def virtual_work(motions: Sequence[tuple[Wrench, Twist]]) -> Scalar:
    """The sum of what wrenches do along twists, each pair about one point."""
    done: Scalar = ZERO
    for wrench, twist in motions:
        done = add(done, wrench.power(twist))
    return done
