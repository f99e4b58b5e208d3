"""Serial chains: frames joined by translations along and rotations about their own axes."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from armillary.algebra import vector as v
from armillary.algebra.derivative import Differentiator, Seed, of_time
from armillary.algebra.rigid import Matrix, Pose, Twist, stack_twists
from armillary.algebra.rotation import (
    IDENTITY,
    Composed,
    Elementary,
    Rotation,
    factors,
    rotate,
    transpose,
)
from armillary.algebra.scalar import ONE, ZERO, Scalar, ScalarLike, Symbol, as_scalar, is_zero

X, Y, Z = 0, 1, 2


@dataclass(frozen=True, eq=False)
class Step:
    """One elementary motion; `turning` tells a rotation from a translation."""

    turning: bool
    axis: int
    amount: Scalar

    def carry(self, inner: v.Vector) -> v.Vector:
        """A position given after the step, in the frame before it."""
        if self.turning:
            return rotate(self.rotation, inner)
        return v.add_vectors(v.scale(self.amount, v.Basis(self.axis)), inner)

    @property
    def rotation(self) -> Rotation:
        return Elementary(self.axis, self.amount) if self.turning else IDENTITY


@dataclass(frozen=True, eq=False)
class Chain:
    """A chain of named frames, built outward from its base.

    Each call returns a new chain. `frame=` names the frame that the step arrives at:

        Chain("ground").translate(Z, L_0).rotate(Z, -gamma, frame="turntable")
    """

    base: str
    steps: tuple[Step, ...] = ()
    frames: dict[str, int] = field(default_factory=dict)

    def translate(self, axis: int, distance: ScalarLike, frame: str | None = None) -> Chain:
        """Move along an axis of the frame reached so far."""
        return self._extended(Step(False, _axis(axis), as_scalar(distance)), frame)

    def rotate(self, axis: int, angle: ScalarLike, frame: str | None = None) -> Chain:
        """Turn about an axis of the frame reached so far, actively and right-handed."""
        return self._extended(Step(True, _axis(axis), as_scalar(angle)), frame)

    def _extended(self, step: Step, frame: str | None) -> Chain:
        frames = dict(self.frames)
        if frame is not None:
            if frame == self.base or frame in frames:
                raise ValueError(f"the chain already has a frame named {frame!r}")
            frames[frame] = len(self.steps) + 1
        return replace(self, steps=(*self.steps, step), frames=frames)

    def position_of(self, frame: str) -> int:
        """Number of steps between the base and a frame."""
        if frame == self.base:
            return 0
        if frame not in self.frames:
            names = ", ".join([self.base, *self.frames])
            raise ValueError(f"no frame named {frame!r} in this chain; it has {names}")
        return self.frames[frame]

    def rotation(self, outer: str, inner: str) -> Rotation:
        """`outer_R_inner`."""
        first, last = self.position_of(outer), self.position_of(inner)
        if first > last:
            return transpose(self.rotation(inner, outer))
        return _rotation(self.steps[first:last])

    def pose(self, outer: str, inner: str) -> Pose:
        """`outer_T_inner`, between any two frames of the chain."""
        first, last = self.position_of(outer), self.position_of(inner)
        if first > last:
            return self.pose(inner, outer).inverse()
        steps = self.steps[first:last]
        return Pose(_rotation(steps), _position(steps))

    def twist(self, frame: str, point: v.Vector = v.NULL) -> Twist:
        """Motion of a frame, in the base frame: its angular velocity, and the velocity of
        `point` (given in the moving frame; its origin by default)."""
        steps = self.steps[: self.position_of(frame)]
        return Twist(_angular(steps, of_time), _linear(steps, of_time, point))

    def angular_velocity(self, frame: str) -> v.Vector:
        """`vee(Rdot R^T)`: angular velocity of a frame, in the base frame."""
        return self.twist(frame).angular

    def velocity(self, frame: str, point: v.Vector = v.NULL) -> v.Vector:
        """Velocity of a point of a frame (its origin by default), in the base frame."""
        return self.twist(frame, point).linear

    def body_angular_velocity(self, frame: str) -> v.Vector:
        """`vee(R^T Rdot)`: angular velocity of a frame, in that frame's own components."""
        d = Differentiator(of_time)
        spin: v.Vector = v.NULL
        for step in self.steps[: self.position_of(frame)]:
            if step.turning:
                own = v.scale(d.scalar(step.amount), v.Basis(step.axis))
                spin = v.add_vectors(rotate(transpose(step.rotation), spin), own)
        return spin

    def jacobian(
        self, frame: str, variables: tuple[Symbol, ...], point: v.Vector = v.NULL
    ) -> Matrix:
        """6 by k geometric Jacobian in the base frame: velocity of the point over angular
        velocity, one column for each variable."""
        steps = self.steps[: self.position_of(frame)]
        return stack_twists(tuple(_column(steps, q, point) for q in variables))


def _axis(axis: int) -> int:
    if axis not in (X, Y, Z):
        raise ValueError(f"an axis is X, Y or Z, not {axis!r}")
    return axis


def _rotation(steps: tuple[Step, ...]) -> Rotation:
    return Composed(tuple(f for step in steps for f in factors(step.rotation)))


def _position(steps: tuple[Step, ...], point: v.Vector = v.NULL) -> v.Vector:
    """Position of a point of the last frame in the first, nested or summed: what is cheaper."""
    for step in reversed(steps):
        point = step.carry(point)
    return point


def _summed_position(steps: tuple[Step, ...], point: v.Vector) -> v.Vector:
    """The same position as a sum of steps, each carried by the rotations before it."""
    total: v.Vector = v.NULL
    for k, step in enumerate(steps):
        if not step.turning:
            offset = v.scale(step.amount, v.Basis(step.axis))
            total = v.add_vectors(total, rotate(_rotation(steps[:k]), offset))
    return v.add_vectors(total, rotate(_rotation(steps), point))


def _angular(steps: tuple[Step, ...], seed: Seed) -> v.Vector:
    nested = Differentiator(seed).angular_velocity(_rotation(steps))
    d = Differentiator(seed)
    summed: v.Vector = v.NULL
    for k, step in enumerate(steps):
        if step.turning:
            spin = v.scale(d.scalar(step.amount), rotate(_rotation(steps[:k]), v.Basis(step.axis)))
            summed = v.add_vectors(summed, spin)
    return _choice(nested, summed)


def _linear(steps: tuple[Step, ...], seed: Seed, point: v.Vector) -> v.Vector:
    """Velocity carried outward joint by joint: each adds axis x arm where the axis is a basis."""
    d = Differentiator(seed)
    velocity = d.vector(point)
    for step in reversed(steps):
        speed = d.scalar(step.amount)
        point = step.carry(point)
        if step.turning:
            turning = v.scale(speed, v.cross(v.Basis(step.axis), point))
            velocity = v.add_vectors(turning, rotate(step.rotation, velocity))
        else:
            velocity = v.add_vectors(v.scale(speed, v.Basis(step.axis)), velocity)
    return velocity


def _column(steps: tuple[Step, ...], variable: Symbol, point: v.Vector) -> Twist:
    """The twist per unit speed of one variable."""
    d = Differentiator(lambda leaf: _rate_of(leaf, variable))
    moving = [k for k, step in enumerate(steps) if not is_zero(d.scalar(step.amount))]
    angular: v.Vector = v.NULL
    local: v.Vector = v.NULL
    based: v.Vector = v.NULL
    tip = _summed_position(steps, point)
    for k in moving:
        step, before = steps[k], _rotation(steps[:k])
        speed = d.scalar(step.amount)
        axis = v.Basis(step.axis)
        carried = v.scale(speed, rotate(before, axis))
        if step.turning:
            angular = v.add_vectors(angular, carried)
            arm = _position(steps[k:], point)
            push = rotate(before, v.scale(speed, v.cross(axis, arm)))
            local = v.add_vectors(local, push)
            base_arm = tip - _summed_position(steps[:k], v.NULL)
            based = v.add_vectors(based, v.cross(carried, base_arm))
        else:
            local = v.add_vectors(local, carried)
            based = v.add_vectors(based, carried)
    return Twist(angular, _choice(local, based))


def _choice(first: v.Vector, second: v.Vector) -> v.Vector:
    return first if v.is_null(first) else v.Choice((first, second))


def _rate_of(leaf: Symbol | v.VectorSymbol, variable: Symbol) -> Scalar | v.Vector:
    if isinstance(leaf, v.VectorSymbol):
        return v.NULL
    return ONE if leaf is variable else ZERO
