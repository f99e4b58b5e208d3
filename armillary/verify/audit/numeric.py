"""Values of algebra nodes at many points at once.

This walks the derivation's own nodes and knows nothing of programs, so it checks them from outside.
A node is met once: copies of an expression that differ in one place share the rest with it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import singledispatchmethod
from typing import Any, Protocol

import mpmath
import numpy as np
import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rotation import Elementary, RotationSymbol, Transposed, factors
from armillary.derivation.quantity import Constant

DIGITS = 50
Leaf = s.Symbol | v.VectorSymbol | RotationSymbol
Triple = tuple[Any, Any, Any]


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


_NUMBERS: dict[tuple[type, sympy.Expr], Any] = {}


class Values:
    """Values of nodes at the points given for their leaves.

    Args:
        numbers: the number system.
        leaves: scalars (n,), vectors (n, 3), rotations (n, 3, 3), by node.
    """

    def __init__(self, numbers: Numbers, leaves: Mapping[Leaf, Any]) -> None:
        self.numbers = numbers
        self._leaves = {id(leaf): numbers.array(array) for leaf, array in leaves.items()}
        self._held = tuple(leaves)  # their ids stay theirs
        self.count = min((len(a) for a in self._leaves.values()), default=1)
        self._done: dict[int, tuple[Any, Any]] = {}

    def __call__(self, node: Any) -> Any:
        """A scalar's values (n,), or one number of a constant; a vector's as three of them."""
        known = self._done.get(id(node))
        if known is None:
            known = (node, self.value(node))
            self._done[id(node)] = known
        return known[1]

    def array(self, node: s.Scalar) -> Any:
        """A scalar's values as an array (n,), constants too."""
        with np.errstate(all="ignore"):
            return np.broadcast_to(self(node), (self.count,))

    @contextmanager
    def trying(self) -> Iterator[None]:
        """What is met inside is forgotten afterwards: it was tried on a copy."""
        before = len(self._done)
        try:
            yield
        finally:
            while len(self._done) > before:
                self._done.popitem()

    @singledispatchmethod
    def value(self, node: Any) -> Any:
        """The rule of one node; a node that knows an explicit form has its values."""
        explicit = getattr(node, "explicit", None)
        if explicit is None:
            raise TypeError(f"no values for {type(node).__name__}")
        return self(explicit())

    @value.register
    def _(self, node: s.Number) -> Any:
        key = (type(self.numbers), node.value)
        if key not in _NUMBERS:
            _NUMBERS[key] = self.numbers.number(node.value)
        return _NUMBERS[key]

    @value.register
    def _(self, node: s.Symbol) -> Any:
        if isinstance(node, Constant) and id(node) not in self._leaves:
            return self.numbers.number(node.value)
        return self._leaves[id(node)]

    @value.register
    def _(self, node: s.Add) -> Any:
        return self(node.left) + self(node.right)

    @value.register
    def _(self, node: s.Multiply) -> Any:
        return self(node.left) * self(node.right)

    @value.register
    def _(self, node: s.Negate) -> Any:
        return -self(node.argument)

    @value.register
    def _(self, node: s.Divide) -> Any:
        return self.numbers.divide(self(node.numerator), self(node.denominator))

    @value.register
    def _(self, node: s.SquareRoot) -> Any:
        return self.numbers.sqrt(self(node.argument))

    @value.register
    def _(self, node: s.Sine) -> Any:
        return self.numbers.sin(self(node.argument))

    @value.register
    def _(self, node: s.Cosine) -> Any:
        return self.numbers.cos(self(node.argument))

    @value.register
    def _(self, node: s.ArcTangent) -> Any:
        return self.numbers.atan2(self(node.y), self(node.x))

    @value.register
    def _(self, node: s.Absolute) -> Any:
        return abs(self(node.argument))

    @value.register
    def _(self, node: s.Select) -> Any:
        # The other side may be NaN: it is not used.
        return np.where(self(node.condition), self(node.then), self(node.otherwise))

    @value.register
    def _(self, node: s.Component) -> Any:
        return self(node.vector)[node.index]

    @value.register
    def _(self, node: s.Dot) -> Any:
        (a, b, c), (x, y, z) = self(node.left), self(node.right)
        return a * x + b * y + c * z

    @value.register
    def _(self, node: s.ScalarReference | v.VectorReference | s.ConditionReference) -> Any:
        return self(node.expression)

    @value.register
    def _(self, node: s.Less) -> Any:
        return np.asarray(self(node.left) < self(node.right), dtype=bool)

    @value.register
    def _(self, node: s.Both) -> Any:
        return self(node.left) & self(node.right)

    @value.register
    def _(self, node: s.Not) -> Any:
        return ~self(node.argument)

    @value.register
    def _(self, node: v.Components) -> Triple:
        x, y, z = node.components
        return self(x), self(y), self(z)

    @value.register
    def _(self, node: v.Basis) -> Triple:
        one, zero = self(s.ONE), self(s.ZERO)
        x, y, z = (one if k == node.axis else zero for k in range(3))
        return x, y, z

    @value.register
    def _(self, node: v.VectorSymbol) -> Triple:
        array = self._leaves[id(node)]
        return array[:, 0], array[:, 1], array[:, 2]

    @value.register
    def _(self, node: v.VectorSum) -> Triple:
        (a, b, c), (x, y, z) = self(node.left), self(node.right)
        return a + x, b + y, c + z

    @value.register
    def _(self, node: v.VectorNegate) -> Triple:
        x, y, z = self(node.argument)
        return -x, -y, -z

    @value.register
    def _(self, node: v.Scaled) -> Triple:
        factor, (x, y, z) = self(node.factor), self(node.vector)
        return factor * x, factor * y, factor * z

    @value.register
    def _(self, node: v.Cross) -> Triple:
        (a, b, c), (x, y, z) = self(node.left), self(node.right)
        return b * z - c * y, c * x - a * z, a * y - b * x

    @value.register
    def _(self, node: v.Unit) -> Triple:
        x, y, z = self(node.vector)
        length = self.numbers.sqrt(x * x + y * y + z * z)
        divide = self.numbers.divide
        return divide(x, length), divide(y, length), divide(z, length)

    @value.register
    def _(self, node: v.Rotated) -> Triple:
        turned: Triple = self(node.vector)
        for factor in reversed(factors(node.rotation)):
            turned = self._turned(factor, turned)
        return turned

    @value.register
    def _(self, node: v.Choice) -> Triple:
        nested: Triple = self(node.nested)
        return nested

    def _turned(self, factor: Any, vector: Triple) -> Triple:
        if isinstance(factor, (RotationSymbol, Transposed)):
            named = factor.symbol if isinstance(factor, Transposed) else factor
            matrix = self._leaves[id(named)]
            if factor is not named:
                matrix = matrix.transpose(0, 2, 1)
            x, y, z = (sum(matrix[:, i, j] * vector[j] for j in range(3)) for i in range(3))
            return x, y, z
        assert isinstance(factor, Elementary)
        angle = self(factor.angle)
        cosine, sine = self.numbers.cos(angle), self.numbers.sin(angle)
        k = factor.axis
        i, j = (k + 1) % 3, (k + 2) % 3
        turned = list(vector)
        turned[i] = cosine * vector[i] - sine * vector[j]
        turned[j] = sine * vector[i] + cosine * vector[j]
        return turned[0], turned[1], turned[2]
