"""Whether a scalar is 0 everywhere: there a quotient, a root or an angle has no expansion."""

from __future__ import annotations

from collections.abc import Iterator

import mpmath
import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.explicit import Explicit
from armillary.algebra.misuse import MisuseError

_POINTS = 3
_DIGITS = 40


def refuse_zero(first: s.Scalar, what: str, node: s.Scalar | v.Vector) -> None:
    """Refuse to expand a function where it has no expansion.

    Raises:
        MisuseError: if the first term is 0.
    """
    if vanishes(first):
        told = str(Explicit(named=True)(node))
        told = told if len(told) < 80 else told[:77] + "..."
        raise MisuseError(
            f"{what} vanishes where the small quantities are 0, so there is no expansion: {told}",
            "expand what the kernel needs before this step, cancel the common factor, "
            "or guard it with where(condition, value, 1), not 0",
        )


def vanishes(node: s.Scalar) -> bool:
    """Whether a scalar is 0 everywhere, or on one side of a `where`.

    What is not seen from the structure is evaluated to 40 digits at three points: an expression
    that is 0 there is taken to be 0.
    """
    if isinstance(node, s.Number):
        return bool(node.value.equals(0))
    if isinstance(node, s.Select):
        return vanishes(node.then) or vanishes(node.otherwise)
    if isinstance(node, s.ScalarReference):
        return vanishes(node.expression)
    if isinstance(node, (s.Negate, s.SquareRoot, s.Absolute)):
        return vanishes(node.argument)
    if isinstance(node, s.Multiply):
        return vanishes(node.left) or vanishes(node.right)
    if isinstance(node, (s.Symbol, s.Sine)):
        return isinstance(node, s.Sine) and vanishes(node.argument)
    values = list(_values(node))
    return bool(values) and all(abs(x) < mpmath.mpf(10) ** (8 - _DIGITS) for x in values)


def _values(node: s.Scalar) -> Iterator[mpmath.mpf]:
    """Values at a few points that no author's threshold meets; those that are real and finite."""
    form = Explicit()(node)
    symbols = sorted(form.free_symbols, key=lambda x: str(x))
    function = sympy.lambdify(symbols, form, modules="mpmath", cse=True)
    with mpmath.workdps(_DIGITS):
        for k in range(_POINTS):
            # Multiples of the golden ratio, modulo 1, never repeat and have no simple relation.
            places = [mpmath.frac(mpmath.phi * (7 * k + 3 * i + 1)) for i in range(len(symbols))]
            try:
                value = function(*(mpmath.mpf("0.1") + place for place in places))
            except (ZeroDivisionError, ValueError):
                continue
            if isinstance(value, (int, float, mpmath.mpf)) and mpmath.isfinite(value):
                yield mpmath.mpf(value)
