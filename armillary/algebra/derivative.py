"""Derivative rules of the structural expressions.

One rule serves time derivatives and partial derivatives: `seed` says how fast each symbol moves.
A rotation is never differentiated entry by entry: rotating a vector adds the cross product with the
rotation's own axis, taken in the frame where that axis is a basis vector.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import singledispatch
from typing import overload

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.direction import (
    Azimuth,
    AzimuthCosine,
    AzimuthSine,
    Elevation,
    ElevationTangent,
)
from armillary.algebra.indexed import At, OneLike, Total, VectorAt, VectorTotal, at, indices
from armillary.algebra.misuse import MisuseError
from armillary.algebra.rotation import (
    Elementary,
    Factor,
    Rotation,
    RotationSymbol,
    Transposed,
    factors,
    rotate,
)
from armillary.algebra.turning import Turning, azimuth_rate, elevation_rate, turning

Leaf = s.Symbol | v.VectorSymbol | RotationSymbol
# How fast a symbol moves: a rotation by its angular velocity in the outer frame.
Seed = Callable[[Leaf], "s.Scalar | v.Vector"]
# A value, met by identity, and its derivative; whoever states it answers for it.
Known = Mapping["s.Scalar | v.Vector", "s.Scalar | v.Vector"]


class Differentiator:
    """Derivatives under one seed; each node of the graph is visited once."""

    def __init__(self, seed: Seed, known: Known | None = None) -> None:
        self.seed = seed
        self._scalars: dict[s.Scalar, s.Scalar] = {}
        self._vectors: dict[v.Vector, v.Vector] = {}
        for node, change in (known or {}).items():
            if isinstance(node, v.Vector) and isinstance(change, v.Vector):
                self._vectors[node] = change
            else:
                assert isinstance(node, s.Scalar)
                self._scalars[node] = s.as_scalar(change)
        self._turnings: dict[v.Vector, Turning] = {}

    def scalar(self, node: s.Scalar) -> s.Scalar:
        if node not in self._scalars:
            self._scalars[node] = _scalar(node, self)
        return self._scalars[node]

    def vector(self, node: v.Vector) -> v.Vector:
        if node not in self._vectors:
            self._vectors[node] = _vector(node, self)
        return self._vectors[node]

    def turning(self, node: v.Vector) -> Turning:
        """How the direction of a vector moves."""
        if node not in self._turnings:
            self._turnings[node] = turning(node, self)
        return self._turnings[node]

    def angular_velocity(self, rotation: Rotation) -> v.Vector:
        """The vector w with d(R x) = w cross (R x) + R dx, in the outer frame."""
        total: v.Vector = v.NULL
        for factor in reversed(factors(rotation)):
            # An axis is left alone by its own rotation, so it may be added before or after it.
            total = v.add_vectors(self.spin(factor), rotate(factor, total))
        return total

    def spin(self, factor: Factor) -> v.Vector:
        """The angular velocity of one factor of a product, in the frame outside it."""
        if isinstance(factor, Elementary):
            return v.scale(self.scalar(factor.angle), v.Basis(factor.axis))
        symbol = factor.symbol if isinstance(factor, Transposed) else factor
        moved = self.seed(symbol)
        assert isinstance(moved, v.Vector)
        return v.negate_vector(rotate(factor, moved)) if factor is not symbol else moved


def of_time(leaf: Leaf) -> s.Scalar | v.Vector:
    """The seed of time derivatives: each symbol says how fast it moves."""
    return leaf.velocity()


@overload
def time_derivative(node: s.Scalar, known: Known | None = None) -> s.Scalar: ...
@overload
def time_derivative(node: v.Vector, known: Known | None = None) -> v.Vector: ...
def time_derivative(node: s.Scalar | v.Vector, known: Known | None = None) -> s.Scalar | v.Vector:
    """Time derivative of a scalar, or of a vector's components in its own frame.

    Args:
        known: derivatives that have a name already, by the value that they are of.
    """
    return _derivative(node, of_time, known)


@overload
def partial(node: s.Scalar, symbol: s.Symbol, known: Known | None = None) -> s.Scalar: ...
@overload
def partial(node: v.Vector, symbol: s.Symbol, known: Known | None = None) -> v.Vector: ...
def partial(
    node: s.Scalar | v.Vector, symbol: s.Symbol, known: Known | None = None
) -> s.Scalar | v.Vector:
    """Partial derivative of a scalar or a vector by one symbol, all others held.

    Args:
        known: derivatives by that symbol that have a name already, by the value they are of.
    """
    return _derivative(node, partial_seed(symbol), known)


def _derivative(node: s.Scalar | v.Vector, seed: Seed, known: Known | None) -> s.Scalar | v.Vector:
    d = Differentiator(seed, known)
    return d.vector(node) if isinstance(node, v.Vector) else d.scalar(node)


def partial_seed(symbol: s.Symbol) -> Seed:
    """The seed of partial derivatives: one symbol moves, all others are held."""

    def seed(leaf: Leaf) -> s.Scalar | v.Vector:
        if not isinstance(leaf, s.Symbol):
            return v.NULL
        return s.ONE if leaf is symbol else s.ZERO

    return seed


@singledispatch
def _scalar(node: s.Scalar, d: Differentiator) -> s.Scalar:
    iteration = getattr(node, "iteration", None)  # a class that stands on this module
    if iteration is None:
        raise TypeError(f"no derivative rule for {type(node).__name__}")
    if all(s.is_zero(d.scalar(residual)) for residual in iteration.residuals):
        return s.ZERO
    raise MisuseError(
        "the result of an iteration has no derivative",
        "differentiate the residuals that it makes zero, and solve for the rates",
    )


@_scalar.register
def _(node: s.Number, d: Differentiator) -> s.Scalar:
    return s.ZERO


@_scalar.register
def _(node: s.Symbol, d: Differentiator) -> s.Scalar:
    moved = d.seed(node)
    assert isinstance(moved, s.Scalar)
    return moved


@_scalar.register
def _(node: s.Add, d: Differentiator) -> s.Scalar:
    return s.add(d.scalar(node.left), d.scalar(node.right))


@_scalar.register
def _(node: s.Multiply, d: Differentiator) -> s.Scalar:
    return s.add(
        s.multiply(d.scalar(node.left), node.right), s.multiply(node.left, d.scalar(node.right))
    )


@_scalar.register
def _(node: s.Negate, d: Differentiator) -> s.Scalar:
    return s.negate(d.scalar(node.argument))


@_scalar.register
def _(node: s.Divide, d: Differentiator) -> s.Scalar:
    # (n / m)' = (n' - (n / m) m') / m: the quotient itself is used again.
    change = s.add(d.scalar(node.numerator), s.negate(s.multiply(node, d.scalar(node.denominator))))
    return s.divide(change, node.denominator)


@_scalar.register
def _(node: s.SquareRoot, d: Differentiator) -> s.Scalar:
    inner = node.argument
    if isinstance(inner, s.Dot) and inner.left is inner.right:
        # |v|' = v.v' / |v| without the factor two that comes and goes.
        return s.divide(v.dot(inner.left, d.vector(inner.left)), node)
    return s.divide(d.scalar(inner), s.multiply(s.number(2), node))


@_scalar.register
def _(node: s.Sine, d: Differentiator) -> s.Scalar:
    return s.multiply(s.Cosine(node.argument), d.scalar(node.argument))


@_scalar.register
def _(node: s.Cosine, d: Differentiator) -> s.Scalar:
    return s.negate(s.multiply(s.Sine(node.argument), d.scalar(node.argument)))


@_scalar.register
def _(node: s.ArcTangent, d: Differentiator) -> s.Scalar:
    # Never y/x: the derivative is regular on the axes too.
    dy, dx = d.scalar(node.y), d.scalar(node.x)
    turn = s.add(s.multiply(node.x, dy), s.negate(s.multiply(node.y, dx)))
    square = s.add(s.multiply(node.x, node.x), s.multiply(node.y, node.y))
    return s.divide(turn, square)


@_scalar.register
def _(node: s.ArcSine, d: Differentiator) -> s.Scalar:
    return s.divide(d.scalar(node.argument), node.cosine())


@_scalar.register
def _(node: s.ArcCosine, d: Differentiator) -> s.Scalar:
    return s.negate(s.divide(d.scalar(node.argument), node.sine()))


@_scalar.register
def _(node: Azimuth, d: Differentiator) -> s.Scalar:
    return azimuth_rate(node.vector, d.turning(node.vector))


@_scalar.register
def _(node: Elevation, d: Differentiator) -> s.Scalar:
    return elevation_rate(node.vector, d.turning(node.vector))


@_scalar.register
def _(node: AzimuthSine, d: Differentiator) -> s.Scalar:
    return s.multiply(AzimuthCosine(node.vector), d.scalar(Azimuth(node.vector)))


@_scalar.register
def _(node: AzimuthCosine, d: Differentiator) -> s.Scalar:
    return s.negate(s.multiply(AzimuthSine(node.vector), d.scalar(Azimuth(node.vector))))


@_scalar.register
def _(node: ElevationTangent, d: Differentiator) -> s.Scalar:
    # 1 + tan^2: the tangent itself is used again.
    growth = s.add(s.ONE, s.multiply(node, node))
    return s.multiply(growth, d.scalar(Elevation(node.vector)))


@_scalar.register
def _(node: s.Absolute, d: Differentiator) -> s.Scalar:
    change = d.scalar(node.argument)
    return s.Select(s.Less(node.argument, s.ZERO), s.negate(change), change)


@_scalar.register
def _(node: s.Select, d: Differentiator) -> s.Scalar:
    then, otherwise = d.scalar(node.then), d.scalar(node.otherwise)
    if s.is_zero(then) and s.is_zero(otherwise):
        return s.ZERO
    return s.Select(node.condition, then, otherwise)


@_scalar.register
def _(node: s.Component, d: Differentiator) -> s.Scalar:
    return v.component(d.vector(node.vector), node.index)


@_scalar.register
def _(node: s.Dot, d: Differentiator) -> s.Scalar:
    if node.left is node.right:
        return s.multiply(s.number(2), v.dot(node.left, d.vector(node.left)))
    return s.add(v.dot(d.vector(node.left), node.right), v.dot(node.left, d.vector(node.right)))


@_scalar.register
def _(node: s.ScalarReference, d: Differentiator) -> s.Scalar:
    return d.scalar(node.expression)


@_scalar.register
def _(node: OneLike, d: Differentiator) -> s.Scalar:
    return s.ZERO


@_scalar.register
def _(node: Total, d: Differentiator) -> s.Scalar:
    change = d.scalar(node.term)
    if node.over in indices(change):
        return Total(change, node.over)
    return s.multiply(s.number(node.over.size), change)


@_scalar.register
def _(node: At, d: Differentiator) -> s.Scalar:
    return at(d.scalar(node.term), node.over, node.place)


@singledispatch
def _vector(node: v.Vector, d: Differentiator) -> v.Vector:
    raise TypeError(f"no derivative rule for {type(node).__name__}")


@_vector.register
def _(node: v.Components, d: Differentiator) -> v.Vector:
    x, y, z = (d.scalar(c) for c in node.components)
    return v.NULL if all(s.is_zero(c) for c in (x, y, z)) else v.Components((x, y, z))


@_vector.register
def _(node: v.Basis, d: Differentiator) -> v.Vector:
    return v.NULL


@_vector.register
def _(node: v.VectorSymbol, d: Differentiator) -> v.Vector:
    moved = d.seed(node)
    assert isinstance(moved, v.Vector)
    return moved


@_vector.register
def _(node: v.VectorSum, d: Differentiator) -> v.Vector:
    return v.add_vectors(d.vector(node.left), d.vector(node.right))


@_vector.register
def _(node: v.VectorNegate, d: Differentiator) -> v.Vector:
    return v.negate_vector(d.vector(node.argument))


@_vector.register
def _(node: v.Scaled, d: Differentiator) -> v.Vector:
    return v.add_vectors(
        v.scale(d.scalar(node.factor), node.vector), v.scale(node.factor, d.vector(node.vector))
    )


@_vector.register
def _(node: v.Cross, d: Differentiator) -> v.Vector:
    return v.add_vectors(
        v.cross(d.vector(node.left), node.right), v.cross(node.left, d.vector(node.right))
    )


@_vector.register
def _(node: v.Unit, d: Differentiator) -> v.Vector:
    # u' = (v' - u (u.v')) / |v|: what is along u cannot turn it.
    change = d.vector(node.vector)
    if v.is_null(change):
        return v.NULL
    along = v.scale(v.dot(node, change), node)
    return v.scale(s.divide(s.ONE, v.norm(node.vector)), change - along)


@_vector.register
def _(node: v.Rotated, d: Differentiator) -> v.Vector:
    value, change = node.vector, d.vector(node.vector)
    for factor in reversed(factors(node.rotation)):
        if isinstance(factor, Elementary):
            speed = d.scalar(factor.angle)
            turning = v.scale(speed, v.cross(v.Basis(factor.axis), rotate(factor, value)))
        else:
            turning = v.cross(d.spin(factor), rotate(factor, value))
        value, change = rotate(factor, value), v.add_vectors(turning, rotate(factor, change))
    return change


@_vector.register
def _(node: v.Choice, d: Differentiator) -> v.Vector:
    return d.vector(node.nested)


@_vector.register
def _(node: VectorTotal, d: Differentiator) -> v.Vector:
    change = d.vector(node.term)
    if node.over in indices(change):
        return VectorTotal(change, node.over)
    return v.scale(s.number(node.over.size), change)


@_vector.register
def _(node: VectorAt, d: Differentiator) -> v.Vector:
    return at(d.vector(node.term), node.over, node.place)


@_vector.register
def _(node: v.VectorReference, d: Differentiator) -> v.Vector:
    return d.vector(node.expression)
