"""Scalars: the leaves and the arithmetic of every derivation.

A node is immutable and compared by identity: a derivation is a graph, and sharing a Python object
*is* sharing the value. Nothing is simplified here beyond zeros and ones; the structure that was
written is the structure that is kept.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Union

import sympy

from armillary.algebra.misuse import (
    MisuseError,
    not_a_condition,
    not_a_number,
    not_real,
    told,
    told_shortly,
)

if TYPE_CHECKING:
    from armillary.algebra.vector import Vector

ScalarLike = Union["Scalar", int, float, Fraction, str]


@dataclass(frozen=True, eq=False, repr=False)
class Scalar:
    """A real number of the derivation; operators build new nodes."""

    def __repr__(self) -> str:
        # The whole expression would take for ever: what is shared would be written each time.
        return told_shortly(self)

    def __add__(self, other: ScalarLike) -> Scalar:
        return add(self, as_scalar(other))

    def __radd__(self, other: ScalarLike) -> Scalar:
        return add(as_scalar(other), self)

    def __sub__(self, other: ScalarLike) -> Scalar:
        return add(self, negate(as_scalar(other)))

    def __rsub__(self, other: ScalarLike) -> Scalar:
        return add(as_scalar(other), negate(self))

    def __mul__(self, other: ScalarLike) -> Scalar:
        if not isinstance(other, (Scalar, int, float, Fraction, str)):
            return NotImplemented
        return multiply(self, as_scalar(other))

    def __rmul__(self, other: ScalarLike) -> Scalar:
        return multiply(as_scalar(other), self)

    def __truediv__(self, other: ScalarLike) -> Scalar:
        return divide(self, as_scalar(other))

    def __rtruediv__(self, other: ScalarLike) -> Scalar:
        return divide(as_scalar(other), self)

    def __neg__(self) -> Scalar:
        return negate(self)

    def __pow__(self, exponent: float) -> Scalar:
        if not isinstance(exponent, int) or exponent < 1:
            raise MisuseError(
                f"only whole powers from 1 up are kept as products, not {told(exponent)}",
                "use sqrt(x) for x**0.5 and 1 / x**2 for x**-2",
            )
        return self if exponent == 1 else multiply(self ** (exponent - 1), self)

    def __lt__(self, other: ScalarLike) -> Condition:
        return Less(self, as_scalar(other))

    def __gt__(self, other: ScalarLike) -> Condition:
        return Less(as_scalar(other), self)

    def __le__(self, other: ScalarLike) -> Condition:
        raise MisuseError("<= does not compare here", "write ~(a > b) for a <= b")

    def __ge__(self, other: ScalarLike) -> Condition:
        raise MisuseError(">= does not compare here", "write ~(a < b) for a >= b")


@dataclass(frozen=True, eq=False, repr=False)
class Number(Scalar):
    """An exact number (a rational, pi, or an exact expression of them)."""

    value: sympy.Expr


@dataclass(frozen=True, eq=False, repr=False)
class Symbol(Scalar):
    """A named scalar whose value comes from outside the derivation."""

    name: str

    def velocity(self) -> Scalar:
        """Its time derivative; a plain symbol is held."""
        return ZERO


@dataclass(frozen=True, eq=False, repr=False)
class Add(Scalar):
    """A sum of two."""

    left: Scalar
    right: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class Multiply(Scalar):
    """A product of two."""

    left: Scalar
    right: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class Negate(Scalar):
    """The same with the other sign."""

    argument: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class Divide(Scalar):
    """A quotient; the denominator may not be 0 where the kernel is called."""

    numerator: Scalar
    denominator: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class SquareRoot(Scalar):
    """A square root of something that is never negative."""

    argument: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class Sine(Scalar):
    """The sine of an angle."""

    argument: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class Cosine(Scalar):
    """The cosine of an angle."""

    argument: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class ArcTangent(Scalar):
    """The angle of the point (x, y), in [-pi, pi]."""

    y: Scalar
    x: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class ArcSine(Scalar):
    """The angle in [-pi/2, pi/2] that has a sine; for prints, which write it so."""

    argument: Scalar

    def cosine(self) -> Scalar:
        """The cosine of the angle: of a product, where 1 - x^2 would lose digits near 1."""
        below, above = add(ONE, negate(self.argument)), add(ONE, self.argument)
        return SquareRoot(multiply(below, above))

    def explicit(self) -> Scalar:
        return ArcTangent(self.argument, self.cosine())


@dataclass(frozen=True, eq=False, repr=False)
class ArcCosine(Scalar):
    """The angle in [0, pi] that has a cosine; for prints, which write it so."""

    argument: Scalar

    def sine(self) -> Scalar:
        """The sine of the angle, as a product too."""
        return ArcSine(self.argument).cosine()

    def explicit(self) -> Scalar:
        return ArcTangent(self.sine(), self.argument)


@dataclass(frozen=True, eq=False, repr=False)
class Absolute(Scalar):
    """An absolute value."""

    argument: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class Select(Scalar):
    """One of two values; the other is never used, but it is evaluated, so it must stay finite."""

    condition: Condition
    then: Scalar
    otherwise: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class Component(Scalar):
    """One component of a vector: 0 is x, 1 is y, 2 is z."""

    vector: Vector
    index: int


@dataclass(frozen=True, eq=False, repr=False)
class Dot(Scalar):
    """The dot product of two vectors in one frame."""

    left: Vector
    right: Vector


class Given:
    """Replacements in a definition: pairs of a node and what took its place.

    No dataclass, so that nothing that walks through an expression walks into it.
    """

    def __init__(self, pairs: tuple[tuple[object, object], ...]) -> None:
        self.pairs = pairs


@dataclass(frozen=True, eq=False, repr=False)
class ScalarReference(Scalar):
    """A defined scalar: the name stands for the expression, which is kept.

    `given` tells what `substitute` replaced in it.
    """

    name: str
    identifier: str
    expression: Scalar
    given: Given | None = None


@dataclass(frozen=True, eq=False, repr=False)
class Condition:
    """A truth value that a `where` or a status depends on."""

    def __repr__(self) -> str:
        # The whole expression would take for ever: what is shared would be written each time.
        return told_shortly(self)

    def __and__(self, other: Condition) -> Condition:
        return Both(self, as_condition(other))

    def __rand__(self, other: Condition) -> Condition:
        return Both(as_condition(other), self)

    def __or__(self, other: Condition) -> Condition:
        raise MisuseError("| does not join conditions", "write ~(~a & ~b) for a | b")

    def __invert__(self) -> Condition:
        return Not(self)

    def __bool__(self) -> bool:
        raise MisuseError(
            "a condition has no value while the derivation is written",
            "use where(condition, a, b) instead of if, & and ~ instead of and, or, not",
        )


@dataclass(frozen=True, eq=False, repr=False)
class Less(Condition):
    """Whether one scalar is below another."""

    left: Scalar
    right: Scalar


@dataclass(frozen=True, eq=False, repr=False)
class Both(Condition):
    """Whether two conditions hold."""

    left: Condition
    right: Condition


@dataclass(frozen=True, eq=False, repr=False)
class Not(Condition):
    """Whether a condition does not hold."""

    argument: Condition


@dataclass(frozen=True, eq=False, repr=False)
class ConditionReference(Condition):
    """A defined condition: the name stands for the expression, which is kept."""

    name: str
    identifier: str
    expression: Condition


ZERO = Number(sympy.Integer(0))
ONE = Number(sympy.Integer(1))
PI = Number(sympy.pi)


def number(value: int | float | Fraction | str | sympy.Expr) -> Number:
    """The exact number that was written: 23.45 is 2345/100, not its nearest binary fraction."""
    if isinstance(value, sympy.Expr):
        if value.free_symbols or value is sympy.nan or value.is_real is False:
            raise not_real(value)
        return Number(value)
    if isinstance(value, bool):
        raise not_a_number(value)
    try:
        exact = Fraction(str(value)) if isinstance(value, (float, str)) else Fraction(value)
    except (ValueError, TypeError, ArithmeticError):
        raise not_a_number(value) from None
    if exact == 0:
        return ZERO
    if exact == 1:
        return ONE
    return Number(sympy.Rational(exact.numerator, exact.denominator))


def as_scalar(value: Any) -> Scalar:
    """A scalar as it is, a number as an exact one."""
    if isinstance(value, Scalar):
        return value
    if isinstance(value, (int, float, Fraction, str, sympy.Expr)):
        return number(value)
    raise MisuseError(
        f"expected a scalar or a number, not {told(value)}",
        "take a component (.x, .y, .z), a norm or a dot product of a vector; "
        "turn other numbers into int, float or a decimal string",
    )


def as_condition(value: Any) -> Condition:
    """A condition as it is; anything else is refused."""
    if not isinstance(value, Condition):
        raise not_a_condition(value)
    return value


def is_zero(node: Scalar) -> bool:
    """Whether a node is the number 0."""
    return isinstance(node, Number) and node.value == 0


def is_one(node: Scalar) -> bool:
    """Whether a node is the number 1."""
    return isinstance(node, Number) and node.value == 1


def add(left: Scalar, right: Scalar) -> Scalar:
    """The sum, without a term that is 0."""
    if is_zero(left):
        return right
    if is_zero(right):
        return left
    return Add(left, right)


def multiply(left: Scalar, right: Scalar) -> Scalar:
    """The product, without a factor that is 1."""
    if is_zero(left) or is_zero(right):
        return ZERO
    if is_one(left):
        return right
    if is_one(right):
        return left
    return Multiply(left, right)


def negate(argument: Scalar) -> Scalar:
    """The negative; two signs cancel."""
    if is_zero(argument):
        return argument
    if isinstance(argument, Negate):
        return argument.argument
    return Negate(argument)


def divide(numerator: Scalar, denominator: Scalar) -> Scalar:
    """The quotient."""
    if is_zero(denominator):
        raise ZeroDivisionError("division by the number 0 in a derivation")
    if is_zero(numerator):
        return ZERO
    return numerator if is_one(denominator) else Divide(numerator, denominator)
