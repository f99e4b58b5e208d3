"""Arithmetic for expansions: what is zero, one or a plain number is folded where it is met.

The constructors of `scalar` and `vector` keep what an author wrote. The coefficients of a series
are written by nobody, so here signs come outside, numbers are multiplied out, and vectors that are
known by components stay so.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rotation import Rotation, rotate

AXES = (v.Basis(0), v.Basis(1), v.Basis(2))


def negative(node: s.Scalar) -> s.Scalar:
    """The other sign; of a number, the number."""
    if isinstance(node, s.Number) and not s.is_zero(node):
        return s.number(-node.value)
    return s.negate(node)


def plus(left: s.Scalar, right: s.Scalar) -> s.Scalar:
    """The sum; numbers are added, and a term meets its opposite."""
    if s.is_zero(left) or s.is_zero(right):
        return s.add(left, right)
    if isinstance(left, s.Number) and isinstance(right, s.Number):
        return s.number(left.value + right.value)
    if (isinstance(right, s.Negate) and right.argument is left) or (
        isinstance(left, s.Negate) and left.argument is right
    ):
        return s.ZERO
    return s.add(left, right)


def minus(left: s.Scalar, right: s.Scalar) -> s.Scalar:
    """The difference."""
    return plus(left, negative(right))


def times(left: s.Scalar, right: s.Scalar) -> s.Scalar:
    """The product; its sign is outside and its number in front."""
    if isinstance(left, s.Negate):
        return negative(times(left.argument, right))
    if isinstance(right, s.Negate):
        return negative(times(left, right.argument))
    if isinstance(right, s.Number) and not isinstance(left, s.Number):
        left, right = right, left
    if not isinstance(left, s.Number):
        return s.multiply(left, right)
    if isinstance(right, s.Number):
        return s.number(left.value * right.value)
    if left.value.is_negative:
        return negative(times(s.number(-left.value), right))
    if isinstance(right, s.Multiply) and isinstance(right.left, s.Number):
        return times(s.number(left.value * right.left.value), right.right)
    if isinstance(right, s.Add) and _numbered(right):
        return plus(times(left, right.left), times(left, right.right))
    return s.multiply(left, right)


def _numbered(node: s.Scalar) -> bool:
    """Whether every term of a sum has a number of its own, so that another one costs nothing."""
    if isinstance(node, s.Add):
        return _numbered(node.left) and _numbered(node.right)
    if isinstance(node, s.Negate):
        return _numbered(node.argument)
    return isinstance(node, s.Number) or (
        isinstance(node, s.Multiply) and isinstance(node.left, s.Number)
    )


def over(numerator: s.Scalar, denominator: s.Scalar) -> s.Scalar:
    """The quotient; a number below becomes a number in front."""
    if isinstance(denominator, s.Number):
        return times(s.number(1 / denominator.value), numerator)
    if isinstance(numerator, s.Negate):
        return negative(over(numerator.argument, denominator))
    return s.divide(numerator, denominator)


def root(node: s.Scalar) -> s.Scalar:
    """The square root; that of the square of a length is the length."""
    if isinstance(node, s.Number):
        return s.number(sympy.sqrt(node.value))
    if isinstance(node, s.Multiply) and node.left is node.right:
        if isinstance(node.left, (s.SquareRoot, s.Absolute)):
            return node.left
        return s.Absolute(node.left)
    return s.SquareRoot(node)


def sine(angle: s.Scalar) -> s.Scalar:
    """The sine; of a number, a number."""
    return s.number(sympy.sin(angle.value)) if isinstance(angle, s.Number) else s.Sine(angle)


def cosine(angle: s.Scalar) -> s.Scalar:
    """The cosine; of a number, a number."""
    return s.number(sympy.cos(angle.value)) if isinstance(angle, s.Number) else s.Cosine(angle)


def angle(y: s.Scalar, x: s.Scalar) -> s.Scalar:
    """The angle of a point; of numbers, a number."""
    if isinstance(y, s.Number) and isinstance(x, s.Number):
        return s.number(sympy.atan2(y.value, x.value))
    return s.ArcTangent(y, x)


def arc_sine(sine: s.Scalar) -> s.Scalar:
    """The angle of a sine; of a number, a number."""
    return s.number(sympy.asin(sine.value)) if isinstance(sine, s.Number) else s.ArcSine(sine)


def total(terms: Sequence[s.Scalar]) -> s.Scalar:
    """The sum of terms in their order."""
    found: s.Scalar = s.ZERO
    for term in terms:
        found = plus(found, term)
    return found


def _opened(node: v.Vector) -> v.Components | None:
    """A vector by its components, if it is known by them."""
    if isinstance(node, v.Basis):
        x, y, z = (v.component(node, i) for i in range(3))
        return v.Components((x, y, z))
    return node if isinstance(node, v.Components) else None


def plus_vector(left: v.Vector, right: v.Vector) -> v.Vector:
    """The sum; vectors known by components are added by components."""
    if v.is_null(left) or v.is_null(right):
        return v.add_vectors(left, right)
    a, b = _opened(left), _opened(right)
    if a is None or b is None:
        return v.add_vectors(left, right)
    x, y, z = (plus(p, q) for p, q in zip(a.components, b.components, strict=True))
    return v.Components((x, y, z))


def negative_vector(node: v.Vector) -> v.Vector:
    """The opposite; of components, by components."""
    if isinstance(node, v.Components) and not v.is_null(node):
        x, y, z = (negative(c) for c in node.components)
        return v.Components((x, y, z))
    return v.negate_vector(node)


def scaled(factor: s.Scalar, node: v.Vector) -> v.Vector:
    """A multiple; of components, by components."""
    if s.is_zero(factor) or v.is_null(node):
        return v.NULL
    if s.is_one(factor):
        return node
    if isinstance(node, v.VectorNegate):
        return negative_vector(scaled(factor, node.argument))
    if isinstance(node, v.Scaled):
        return scaled(times(factor, node.factor), node.vector)
    known = _opened(node)
    if known is None:
        return v.scale(factor, node)
    x, y, z = (times(factor, c) for c in known.components)
    return v.Components((x, y, z))


def turned(axis: int, node: v.Vector) -> v.Vector:
    """The cross product of a basis vector with a vector."""
    if v.is_null(node):
        return v.NULL
    if isinstance(node, v.Basis):
        if node.axis == axis:
            return v.NULL
        third = 3 - axis - node.axis
        return AXES[third] if (axis + 1) % 3 == node.axis else v.VectorNegate(AXES[third])
    if isinstance(node, v.VectorNegate):
        return negative_vector(turned(axis, node.argument))
    if isinstance(node, v.Scaled):
        return scaled(node.factor, turned(axis, node.vector))
    if isinstance(node, v.Components):
        entries: list[s.Scalar] = [s.ZERO] * 3
        second, third = (axis + 1) % 3, (axis + 2) % 3
        entries[second] = negative(node.components[third])
        entries[third] = node.components[second]
        return v.Components((entries[0], entries[1], entries[2]))
    return v.cross(AXES[axis], node)


def cross(left: v.Vector, right: v.Vector) -> v.Vector:
    """The cross product; with a basis vector it only moves components."""
    if isinstance(left, v.Basis):
        return turned(left.axis, right)
    if isinstance(right, v.Basis):
        return negative_vector(turned(right.axis, left))
    return v.cross(left, right)


def dot(left: v.Vector, right: v.Vector) -> s.Scalar:
    """The dot product; numbers are multiplied out."""
    a, b = _opened(left), _opened(right)
    if a is None or b is None:
        return v.dot(left, right)
    products = [times(p, q) for p, q in zip(a.components, b.components, strict=True)]
    open_ended = [p for p in products if not isinstance(p, s.Number)]
    return total(products) if len(open_ended) < 2 else v.dot(left, right)


def total_vector(terms: Sequence[v.Vector]) -> v.Vector:
    """The sum of terms in their order; what is carried by one rotation is carried once."""
    terms = [t for t in terms if not v.is_null(t)]
    carried = [t for t in terms if isinstance(t, v.Rotated)]
    if len(terms) > 1 and len(carried) == len(terms):
        rotation: Rotation = carried[0].rotation
        if all(t.rotation is rotation for t in carried):
            return rotate(rotation, total_vector([t.vector for t in carried]))
    found: v.Vector = v.NULL
    for term in terms:
        found = plus_vector(found, term)
    return found
