"""Dual numbers of any nesting over mpmath's, and vectors of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath

Number = Any
Numbers = list[Number]

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)


@dataclass(frozen=True)
class Dual:
    """A value and its slope along one direction. Either may itself be dual: second derivatives."""

    value: Number
    slope: Number

    def __add__(self, other: Number) -> Dual:
        """Sum."""
        value, slope = parts(other)
        return Dual(self.value + value, self.slope + slope)

    __radd__ = __add__

    def __neg__(self) -> Dual:
        """Opposite."""
        return Dual(-self.value, -self.slope)

    def __sub__(self, other: Number) -> Dual:
        """Difference."""
        value, slope = parts(other)
        return Dual(self.value - value, self.slope - slope)

    def __rsub__(self, other: Number) -> Dual:
        """Difference, from a number that is not dual."""
        return Dual(other - self.value, -self.slope)

    def __mul__(self, other: Number) -> Dual:
        """Product."""
        value, slope = parts(other)
        return Dual(self.value * value, self.slope * value + self.value * slope)

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Dual:
        """Quotient."""
        value, slope = parts(other)
        quotient = self.value / value
        return Dual(quotient, (self.slope - quotient * slope) / value)

    def __rtruediv__(self, other: Number) -> Dual:
        """Quotient, of a number that is not dual."""
        return Dual(other, 0 * other) / self


def parts(x: Number) -> tuple[Number, Number]:
    """Value and slope; a plain number is constant."""
    return (x.value, x.slope) if isinstance(x, Dual) else (x, 0)


def derivative(f: Callable[[Numbers], Numbers], at: Numbers, along: Sequence[Number]) -> Numbers:
    """Slope of every output of `f` at a point along a direction. Nests."""
    outputs = f([Dual(x, d) for x, d in zip(at, along, strict=True)])
    return [parts(y)[1] for y in outputs]


def sin(x: Number) -> Number:
    """Sine."""
    return Dual(sin(x.value), x.slope * cos(x.value)) if isinstance(x, Dual) else mpmath.sin(x)


def cos(x: Number) -> Number:
    """Cosine."""
    return Dual(cos(x.value), -x.slope * sin(x.value)) if isinstance(x, Dual) else mpmath.cos(x)


def sqrt(x: Number) -> Number:
    """Square root."""
    if not isinstance(x, Dual):
        return mpmath.sqrt(x)
    root = sqrt(x.value)
    return Dual(root, x.slope / (2 * root))


def atan2(y: Number, x: Number) -> Number:
    """Angle of the point (x, y)."""
    if not isinstance(y, Dual) and not isinstance(x, Dual):
        return mpmath.atan2(y, x)
    (y, y_slope), (x, x_slope) = parts(y), parts(x)
    return Dual(atan2(y, x), (x * y_slope - y * x_slope) / (x * x + y * y))


# --- vectors ------------------------------------------------------------------------------------


def dot(a: Sequence[Number], b: Sequence[Number]) -> Number:
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def rotate(axis: Sequence[Number], angle: Number, v: Sequence[Number]) -> Numbers:
    """Turn a vector about a unit axis: Rodrigues' formula."""
    c, s, along = cos(angle), sin(angle), dot(axis, v)
    k = axis
    beside = [k[1] * v[2] - k[2] * v[1], k[2] * v[0] - k[0] * v[2], k[0] * v[1] - k[1] * v[0]]
    return [c * v[i] + s * beside[i] + (1 - c) * along * k[i] for i in range(3)]


def unit(length: int, place: int) -> list[int]:
    """A one among zeros."""
    return [int(i == place) for i in range(length)]
