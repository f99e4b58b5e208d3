"""The number systems in which prints are compared: double precision, and fifty digits."""

from __future__ import annotations

from typing import Any, Protocol

import mpmath
import numpy as np
import sympy

DIGITS = 50


class Numbers(Protocol):
    """The functions of one number system, on arrays or on single numbers."""

    sin: Any
    cos: Any
    sqrt: Any
    atan2: Any
    divide: Any

    def number(self, exact: sympy.Expr) -> Any: ...
    def array(self, values: Any) -> Any: ...


class Doubles:
    """Double precision; what is not real, or is divided by 0, is NaN or infinite."""

    sin: Any = np.sin
    cos: Any = np.cos
    sqrt: Any = np.sqrt
    atan2: Any = np.arctan2
    divide: Any = np.divide

    def number(self, exact: sympy.Expr) -> Any:
        return np.float64(sympy.N(exact, 30))

    def array(self, values: Any) -> Any:
        return np.asarray(values, dtype=float)


class Digits:
    """Fifty digits, on arrays of objects; what is not real is NaN.

    As many again are carried, for what cancels: at a right angle 1 - sin loses 33 of them.
    """

    def __init__(self, digits: int = DIGITS) -> None:
        self.mp = mpmath.MPContext()
        self.mp.dps = 2 * digits
        mp = self.mp

        def root(x: Any) -> Any:
            return mp.sqrt(x) if x >= 0 else mp.nan

        def quotient(x: Any, y: Any) -> Any:
            return x / y if y != 0 else mp.nan

        self.sin: Any = np.frompyfunc(mp.sin, 1, 1)
        self.cos: Any = np.frompyfunc(mp.cos, 1, 1)
        self.sqrt: Any = np.frompyfunc(root, 1, 1)
        self.atan2: Any = np.frompyfunc(mp.atan2, 2, 1)
        self.divide: Any = np.frompyfunc(quotient, 2, 1)
        self._mpf = np.frompyfunc(mp.mpf, 1, 1)

    def number(self, exact: sympy.Expr) -> Any:
        return self.mp.mpf(str(sympy.N(exact, self.mp.dps + 10)))

    def array(self, values: Any) -> Any:
        return self._mpf(np.asarray(values, dtype=object))
