"""Prints exact numbers as the nearest float of a precision, in the fewest digits that keep it."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import mpmath
import sympy


@dataclass(frozen=True)
class Precision:
    """A binary floating-point format."""

    name: str
    bits: int
    smallest_exponent: int

    @property
    def epsilon(self) -> float:
        """Distance from 1 to the next number."""
        return float(2.0 ** (1 - self.bits))


F32 = Precision("f32", 24, -149)
F64 = Precision("f64", 53, -1074)
PRECISIONS = {p.name: p for p in (F32, F64)}


def nearest(value: sympy.Expr | Fraction | float, precision: Precision) -> Fraction:
    """The exact value of the nearest number of a format, rounded once."""
    context = mpmath.MPContext()
    context.dps = 60
    if isinstance(value, sympy.Expr):
        exact = context.mpf(str(sympy.N(value, 60)))
    else:
        fraction = Fraction(value)
        exact = context.mpf(fraction.numerator) / fraction.denominator
    if exact == 0:
        return Fraction(0)
    context.prec = precision.bits
    sign, mantissa, exponent, _ = (+exact)._mpf_
    magnitude = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -magnitude if sign else magnitude


def shortest(value: sympy.Expr | Fraction | float, precision: Precision) -> str:
    """The shortest decimal that reads back as the nearest number, always with a point."""
    target = nearest(value, precision)
    if target == 0:
        return "0.0"
    for digits in range(1, 18):
        text = f"{float(target):.{digits}g}"
        if nearest(Fraction(text), precision) == target:
            break
    if "e" in text:
        mantissa, exponent = text.split("e")
        mantissa = mantissa if "." in mantissa else mantissa + ".0"
        return f"{mantissa}e{int(exponent)}"
    return text if "." in text else text + ".0"
