"""Serial chains: frames joined by translations along and rotations about their own axes."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from armillary.algebra import vector as v
from armillary.algebra.derivative import Differentiator, Seed, of_time, partial_seed
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
from armillary.algebra.scalar import Scalar, ScalarLike, Symbol, add, as_scalar

X, Y, Z = 0, 1, 2


@dataclass(frozen=True, eq=False)
class Turn:
    """A rotation about an axis of the frame reached so far."""

    axis: int
    angle: Scalar

    @property
    def rotation(self) -> Rotation:
        return Elementary(self.axis, self.angle)

    def carry(self, inner: v.Vector) -> v.Vector:
        """A position given after the step, in the frame before it."""
        return rotate(self.rotation, inner)


@dataclass(frozen=True, eq=False)
class Shift:
    """A translation, given in the frame reached so far."""

    offset: v.Vector

    @property
    def rotation(self) -> Rotation:
        return IDENTITY

    def carry(self, inner: v.Vector) -> v.Vector:
        """A position given after the step, in the frame before it."""
        return v.add_vectors(self.offset, inner)


Step = Turn | Shift


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
        return self._extended(Shift(v.scale(as_scalar(distance), v.Basis(_axis(axis)))), frame)

    def rotate(self, axis: int, angle: ScalarLike, frame: str | None = None) -> Chain:
        """Turn about an axis of the frame reached so far, actively and right-handed."""
        return self._extended(Turn(_axis(axis), as_scalar(angle)), frame)

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
        position = v.choice(_position(steps), _summed(steps), _position(merged(steps)))
        return Pose(_rotation(steps), position)

    def twist(self, frame: str, point: v.Vector = v.NULL) -> Twist:
        """Motion of a frame, in the base frame.

        Its angular velocity, and the velocity of `point` (given in the moving frame; its origin
        by default).
        """
        steps = self.steps[: self.position_of(frame)]
        return Twist(_angular(steps, of_time), _linear(steps, of_time, point))

    def angular_velocity(self, frame: str) -> v.Vector:
        """`vee(Rdot R^T)`: angular velocity of a frame, in the base frame."""
        return self.twist(frame).angular

    def velocity(self, frame: str, point: v.Vector = v.NULL) -> v.Vector:
        """Velocity of a point of a frame (its origin by default), in the base frame."""
        return self.twist(frame, point).linear

    def spatial_velocity(self, frame: str) -> v.Vector:
        """Velocity of the body point that passes the base origin: last column of `Mdot M^-1`."""
        steps = self.steps[: self.position_of(frame)]
        nested = _velocity_at_base(steps)
        return v.choice(nested, nested, _velocity_at_base(merged(steps)))

    def body_angular_velocity(self, frame: str) -> v.Vector:
        """`vee(R^T Rdot)`: angular velocity of a frame, in that frame's own components."""
        d = Differentiator(of_time)
        spin: v.Vector = v.NULL
        for step in self.steps[: self.position_of(frame)]:
            if isinstance(step, Turn):
                own = v.scale(d.scalar(step.angle), v.Basis(step.axis))
                spin = v.add_vectors(rotate(transpose(step.rotation), spin), own)
        return spin

    def jacobian(
        self, frame: str, variables: tuple[Symbol, ...], point: v.Vector = v.NULL
    ) -> Matrix:
        """6 by k geometric Jacobian in the base frame.

        Rows are the velocity of the point over the angular velocity; a column a variable.
        """
        steps = self.steps[: self.position_of(frame)]
        return stack_twists(tuple(_column(steps, q, point) for q in variables))


def _axis(axis: int) -> int:
    if axis not in (X, Y, Z):
        raise ValueError(f"an axis is X, Y or Z, not {axis!r}")
    return axis


def merged(steps: tuple[Step, ...]) -> tuple[Step, ...]:
    """The same chain with parallel axes turned by the sum of their angles.

    R(a) shift R(b) about one axis is a shift by R(a) offset, then R(a + b): the joint between
    needs no sine of its own.
    """
    done: list[Step] = []
    for step in steps:
        if isinstance(step, Turn):
            last = _last_turn(done)
            if last is not None and _parallel(done[last], step):
                turned, shifts = done[last], done[last + 1 :]
                assert isinstance(turned, Turn)
                moved = [Shift(turned.carry(s.offset)) for s in shifts if isinstance(s, Shift)]
                total = Turn(step.axis, add(turned.angle, step.angle))
                done[last:] = [*moved, total]
                continue
        done.append(step)
    return tuple(done)


def _last_turn(steps: list[Step]) -> int | None:
    turns = [k for k, step in enumerate(steps) if isinstance(step, Turn)]
    return turns[-1] if turns else None


def _parallel(first: Step, second: Turn) -> bool:
    return isinstance(first, Turn) and first.axis == second.axis


def _rotation(steps: tuple[Step, ...]) -> Rotation:
    return Composed(tuple(f for step in steps for f in factors(step.rotation)))


def _position(steps: tuple[Step, ...], point: v.Vector = v.NULL) -> v.Vector:
    """Position of a point of the last frame in the first, from the inside out."""
    for step in reversed(steps):
        point = step.carry(point)
    return point


def _summed(steps: tuple[Step, ...], point: v.Vector = v.NULL) -> v.Vector:
    """The same position as a sum of steps, each carried by the rotations before it."""
    total: v.Vector = v.NULL
    for k, step in enumerate(steps):
        if isinstance(step, Shift):
            total = v.add_vectors(total, rotate(_rotation(steps[:k]), step.offset))
    return v.add_vectors(total, rotate(_rotation(steps), point))


def _angular(steps: tuple[Step, ...], seed: Seed) -> v.Vector:
    d = Differentiator(seed)
    summed: v.Vector = v.NULL
    for k, step in enumerate(steps):
        if isinstance(step, Turn):
            spin = v.scale(d.scalar(step.angle), rotate(_rotation(steps[:k]), v.Basis(step.axis)))
            summed = v.add_vectors(summed, spin)
    return v.choice(
        d.angular_velocity(_rotation(steps)), summed, d.angular_velocity(_rotation(merged(steps)))
    )


def _linear(steps: tuple[Step, ...], seed: Seed, point: v.Vector) -> v.Vector:
    nested, parallel = _nested_velocity(steps, seed, point), merged(steps)
    return v.choice(nested, nested, _nested_velocity(parallel, seed, point))


def _nested_velocity(steps: tuple[Step, ...], seed: Seed, point: v.Vector) -> v.Vector:
    """Velocity carried outward joint by joint: each adds axis x arm where the axis is a basis."""
    d = Differentiator(seed)
    velocity = d.vector(point)
    for step in reversed(steps):
        point = step.carry(point)
        if isinstance(step, Turn):
            turning = v.scale(d.scalar(step.angle), v.cross(v.Basis(step.axis), point))
            velocity = v.add_vectors(turning, rotate(step.rotation, velocity))
        else:
            velocity = v.add_vectors(d.vector(step.offset), velocity)
    return velocity


def _velocity_at_base(steps: tuple[Step, ...]) -> v.Vector:
    """The twist carried outward joint by joint, always about the origin reached so far."""
    d = Differentiator(of_time)
    spin: v.Vector = v.NULL
    velocity: v.Vector = v.NULL
    for step in reversed(steps):
        if isinstance(step, Turn):
            own = v.scale(d.scalar(step.angle), v.Basis(step.axis))
            spin = v.add_vectors(own, rotate(step.rotation, spin))
            velocity = rotate(step.rotation, velocity)
        else:
            moment = v.cross(step.offset, spin)
            velocity = v.add_vectors(v.add_vectors(d.vector(step.offset), moment), velocity)
    return velocity


def _column(steps: tuple[Step, ...], variable: Symbol, point: v.Vector) -> Twist:
    """The twist per unit speed of one variable."""
    seed = partial_seed(variable)
    parallel = merged(steps)
    linear = v.choice(
        _local_push(steps, seed, point),
        _base_push(steps, seed, point),
        _local_push(parallel, seed, point),
        _local_push(steps, seed, point, inner=True),
    )
    d = Differentiator(seed)
    angular = v.choice(_spin(steps, d), _spin(steps, d), _spin(parallel, d))
    return Twist(angular, linear)


def _spin(steps: tuple[Step, ...], d: Differentiator) -> v.Vector:
    total: v.Vector = v.NULL
    for k, step in enumerate(steps):
        if isinstance(step, Turn):
            axis = v.scale(d.scalar(step.angle), v.Basis(step.axis))
            total = v.add_vectors(total, rotate(_rotation(steps[:k]), axis))
    return total


def _local_push(
    steps: tuple[Step, ...], seed: Seed, point: v.Vector, inner: bool = False
) -> v.Vector:
    """Axis x arm in a frame where the axis is a basis vector, then carried to the base.

    The axis is one before and after the joint's own turn. With `inner` the product is taken after
    it, where an arm that is not turned yet may be a basis vector too.
    """
    d = Differentiator(seed)
    total = rotate(_rotation(steps), d.vector(point))
    for k, step in enumerate(steps):
        if isinstance(step, Turn):
            at = k + 1 if inner else k
            arm = _position(steps[at:], point)
            push = v.scale(d.scalar(step.angle), v.cross(v.Basis(step.axis), arm))
        else:
            at, push = k, d.vector(step.offset)
        total = v.add_vectors(total, rotate(_rotation(steps[:at]), push))
    return total


def _base_push(steps: tuple[Step, ...], seed: Seed, point: v.Vector) -> v.Vector:
    """Axis x arm, both in the base frame: the arm is a difference of two positions."""
    d = Differentiator(seed)
    tip = _summed(steps, point)
    total = rotate(_rotation(steps), d.vector(point))
    for k, step in enumerate(steps):
        before = _rotation(steps[:k])
        if isinstance(step, Turn):
            axis = v.scale(d.scalar(step.angle), rotate(before, v.Basis(step.axis)))
            push = v.cross(axis, tip - _summed(steps[:k]))
        else:
            push = rotate(before, d.vector(step.offset))
        total = v.add_vectors(total, push)
    return total
