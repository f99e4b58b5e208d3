"""Number systems the evaluator runs on: 50-digit reals, dual numbers, plain floats."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Protocol

import mpmath
import sympy

DIGITS = 50


class Arithmetic(Protocol):
    """What the evaluator needs of a number system."""

    def constant(self, value: sympy.Expr) -> Any: ...
    def add(self, a: Any, b: Any) -> Any: ...
    def multiply(self, a: Any, b: Any) -> Any: ...
    def negate(self, a: Any) -> Any: ...
    def divide(self, a: Any, b: Any) -> Any: ...
    def sqrt(self, a: Any) -> Any: ...
    def sin(self, a: Any) -> Any: ...
    def cos(self, a: Any) -> Any: ...
    def atan2(self, y: Any, x: Any) -> Any: ...
    def absolute(self, a: Any) -> Any: ...
    def less(self, a: Any, b: Any) -> bool: ...


class _Fields:
    def add(self, a: Any, b: Any) -> Any:
        return a + b

    def multiply(self, a: Any, b: Any) -> Any:
        return a * b

    def negate(self, a: Any) -> Any:
        return -a

    def divide(self, a: Any, b: Any) -> Any:
        return a / b

    def less(self, a: Any, b: Any) -> bool:
        return bool(a < b)

    def absolute(self, a: Any) -> Any:
        return abs(a)


class Reals(_Fields):
    """Real numbers at a fixed number of digits, apart from mpmath's global setting."""

    def __init__(self, digits: int = DIGITS) -> None:
        self.mp = mpmath.MPContext()
        self.mp.dps = digits
        self.digits = digits
        self._constants: dict[sympy.Expr, Any] = {}

    def number(self, value: object) -> Any:
        """An exact input: floats are taken bit by bit."""
        return self.mp.mpf(value)

    def constant(self, value: sympy.Expr) -> Any:
        if value not in self._constants:
            self._constants[value] = self.mp.mpf(str(sympy.N(value, self.digits + 10)))
        return self._constants[value]

    def sqrt(self, a: Any) -> Any:
        return self.mp.sqrt(a)

    def sin(self, a: Any) -> Any:
        return self.mp.sin(a)

    def cos(self, a: Any) -> Any:
        return self.mp.cos(a)

    def atan2(self, y: Any, x: Any) -> Any:
        """An angle, radians.

        Raises:
            TypeError: as an ordering does, if an argument is not real.
        """
        if any(hasattr(a, "_mpc_") for a in (y, x)):
            raise TypeError(f"no angle of ({x}, {y}): a root of a negative number stands before it")
        return self.mp.atan2(y, x)


class Floats(_Fields):
    """Double precision, as the f64 kernels compute."""

    def constant(self, value: sympy.Expr) -> float:
        return float(sympy.N(value, 40))

    sqrt = staticmethod(math.sqrt)
    sin = staticmethod(math.sin)
    cos = staticmethod(math.cos)
    atan2 = staticmethod(math.atan2)


@dataclass(frozen=True)
class Dual:
    """A value and its derivative along one direction."""

    value: Any
    slope: Any


class Duals:
    """Dual numbers over the 50-digit reals: derivatives without any symbolic rule."""

    def __init__(self, reals: Reals) -> None:
        self.reals = reals

    def constant(self, value: sympy.Expr) -> Dual:
        return Dual(self.reals.constant(value), self.reals.number(0))

    def add(self, a: Dual, b: Dual) -> Dual:
        return Dual(a.value + b.value, a.slope + b.slope)

    def multiply(self, a: Dual, b: Dual) -> Dual:
        return Dual(a.value * b.value, a.slope * b.value + a.value * b.slope)

    def negate(self, a: Dual) -> Dual:
        return Dual(-a.value, -a.slope)

    def divide(self, a: Dual, b: Dual) -> Dual:
        quotient = a.value / b.value
        return Dual(quotient, (a.slope - quotient * b.slope) / b.value)

    def sqrt(self, a: Dual) -> Dual:
        root = self.reals.sqrt(a.value)
        return Dual(root, a.slope / (2 * root))

    def sin(self, a: Dual) -> Dual:
        return Dual(self.reals.sin(a.value), self.reals.cos(a.value) * a.slope)

    def cos(self, a: Dual) -> Dual:
        return Dual(self.reals.cos(a.value), -self.reals.sin(a.value) * a.slope)

    def atan2(self, y: Dual, x: Dual) -> Dual:
        square = x.value**2 + y.value**2
        return Dual(
            self.reals.atan2(y.value, x.value), (x.value * y.slope - y.value * x.slope) / square
        )

    def absolute(self, a: Dual) -> Dual:
        return self.negate(a) if a.value < 0 else a

    def less(self, a: Dual, b: Dual) -> bool:
        return bool(a.value < b.value)
