"""Prints exact numbers as the nearest float of a precision, in the fewest digits that keep it."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction

import mpmath
import sympy

# An irrational constant is taken to this many digits before it is rounded once.
DIGITS = 60


@dataclass(frozen=True)
class Precision:
    """A binary floating-point format.

    Attributes:
        bits: of the mantissa, the hidden one counted.
        smallest_exponent: of 2 in the smallest number above zero.
        largest_exponent: of 2, one beyond the largest number.
    """

    name: str
    bits: int
    smallest_exponent: int
    largest_exponent: int

    @property
    def epsilon(self) -> float:
        """Distance from 1 to the next number."""
        return float(2.0 ** (1 - self.bits))


F32 = Precision("f32", 24, -149, 128)
F64 = Precision("f64", 53, -1074, 1024)
PRECISIONS = {p.name: p for p in (F32, F64)}


def nearest(value: sympy.Expr | Fraction | float, precision: Precision) -> Fraction:
    """The exact value of the nearest number of a format, rounded once, ties to even.

    Raises:
        ValueError: if the format has no number so large.
    """
    rounded = _rounded(_exact(value), precision)
    if abs(rounded) >= Fraction(2) ** precision.largest_exponent:
        raise ValueError(f"the constant {value} is beyond the largest {precision.name}")
    return rounded


def _rounded(exact: Fraction, precision: Precision) -> Fraction:
    if exact == 0:
        return exact
    step = Fraction(2) ** max(_exponent(exact) - precision.bits + 1, precision.smallest_exponent)
    return round(exact / step) * step


def _exact(value: sympy.Expr | Fraction | float) -> Fraction:
    if not isinstance(value, sympy.Expr):
        return Fraction(value)
    if isinstance(value, sympy.Rational):
        return Fraction(int(value.p), int(value.q))
    context = mpmath.MPContext()
    context.dps = DIGITS
    sign, mantissa, exponent, _ = context.mpf(str(sympy.N(value, DIGITS)))._mpf_
    size = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -size if sign else size


def _exponent(value: Fraction) -> int:
    """The k with 2^k <= |value| < 2^(k+1)."""
    guess = abs(value.numerator).bit_length() - value.denominator.bit_length()
    return guess if abs(value) >= Fraction(2) ** guess else guess - 1


def shortest(value: sympy.Expr | Fraction | float, precision: Precision) -> str:
    """A decimal of the fewest digits that reads back as the nearest number, with a point."""
    target = nearest(value, precision)
    for digits in range(1, 10):
        # Every number of these formats is a Python float, whose repr is the shortest of a double.
        text = f"{float(target):.{digits}g}"
        if _rounded(Fraction(text), precision) == target:
            return _written(float(text))
    return _written(float(target))


def _written(number: float) -> str:
    """Plain where that is not much longer, else with an exponent: 86400.0, 0.001, 1.0e6, 1.0e-7."""
    exact = Decimal(repr(number)).normalize()
    if exact == 0:
        return "0.0"
    plain = f"{exact:f}"
    plain = plain if "." in plain else f"{plain}.0"
    sign, digits, _ = exact.as_tuple()
    rest = "".join(map(str, digits[1:])) or "0"
    scaled = f"{'-' * sign}{digits[0]}.{rest}e{exact.adjusted()}"
    return plain if len(plain) <= len(scaled) + 1 else scaled
