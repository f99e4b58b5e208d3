"""Functions of scalars, as a derivation writes them."""

from __future__ import annotations

import sympy

from armillary.algebra.indexed import one_like
from armillary.algebra.scalar import (
    ONE,
    Absolute,
    ArcCosine,
    ArcSine,
    ArcTangent,
    Condition,
    Cosine,
    Number,
    Scalar,
    ScalarLike,
    Select,
    Sine,
    SquareRoot,
    add,
    as_condition,
    as_scalar,
    divide,
    multiply,
)


def sin(angle: ScalarLike) -> Scalar:
    """Sine of an angle in radians."""
    return Sine(as_scalar(angle))


def cos(angle: ScalarLike) -> Scalar:
    """Cosine of an angle in radians."""
    return Cosine(as_scalar(angle))


def sqrt(value: ScalarLike) -> Scalar:
    """Square root; the argument must be non-negative wherever the kernel is called."""
    return SquareRoot(as_scalar(value))


def atan2(y: ScalarLike, x: ScalarLike) -> Scalar:
    """Angle of the point (x, y), in [-pi, pi]; guard (0, 0) with `where`."""
    return ArcTangent(as_scalar(y), as_scalar(x))


def arcsin(sine: ScalarLike) -> Scalar:
    """Angle in [-pi/2, pi/2] with this sine, which must lie in [-1, 1].

    It is for what a paper prints; a derivation keeps its digits with `atan2`.
    """
    return ArcSine(as_scalar(sine))


def arccos(cosine: ScalarLike) -> Scalar:
    """Angle in [0, pi] with this cosine, which must lie in [-1, 1]; for prints, as `arcsin`."""
    return ArcCosine(as_scalar(cosine))


def absolute(value: ScalarLike) -> Scalar:
    """Absolute value."""
    return Absolute(as_scalar(value))


def hypot(x: ScalarLike, y: ScalarLike) -> Scalar:
    """sqrt(x^2 + y^2)."""
    x, y = as_scalar(x), as_scalar(y)
    return SquareRoot(add(multiply(x, x), multiply(y, y)))


def where(condition: Condition, then: ScalarLike, otherwise: ScalarLike) -> Scalar:
    """`then` where the condition holds, else `otherwise`; both are evaluated."""
    return Select(as_condition(condition), as_scalar(then), as_scalar(otherwise))


def reciprocal_or_zero(value: ScalarLike, zero: Condition) -> Scalar:
    """One over a value, and 0 where `zero` holds: there the value may be 0, and is not divided."""
    value = as_scalar(value)
    return where(zero, 0, divide(ONE, where(zero, one_like(value), value)))


def wrap(angle: ScalarLike) -> Scalar:
    """The same angle in [-pi, pi]."""
    angle = as_scalar(angle)
    return ArcTangent(Sine(angle), Cosine(angle))


def degrees(value: ScalarLike) -> Scalar:
    """A number of degrees, in radians."""
    value = as_scalar(value)
    if isinstance(value, Number):
        return Number(value.value * sympy.pi / 180)
    return multiply(value, Number(sympy.pi / 180))
