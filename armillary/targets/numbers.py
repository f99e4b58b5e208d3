"""Prints exact numbers as the nearest float of a precision, in the fewest digits that keep it."""

from __future__ import annotations

from dataclasses import dataclass
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
    """The shortest decimal that reads back as the nearest number, always with a point."""
    target = nearest(value, precision)
    if target == 0:
        return "0.0"
    text = next(t for t in _decimals(target) if _rounded(Fraction(t), precision) == target)
    if "e" in text:
        mantissa, exponent = text.split("e")
        mantissa = mantissa if "." in mantissa else mantissa + ".0"
        return f"{mantissa}e{int(exponent)}"
    return text if "." in text else text + ".0"


def _decimals(target: Fraction) -> list[str]:
    """Decimals of 1 to 17 digits; every number of these formats is a Python float."""
    return [f"{float(target):.{digits}g}" for digits in range(1, 18)]
