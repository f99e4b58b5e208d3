"""Values of algebra nodes at many points at once.

This walks the derivation's own nodes and knows nothing of programs, so it checks them from outside.
A node is met once: copies of an expression that differ in one place share the rest with it.

At each point an index stands at one part, which is drawn as the values of the quantities are: what
is per part is then one number there, and a sum over the parts looks at all of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import singledispatchmethod
from typing import Any

import numpy as np
import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.index import Index
from armillary.algebra.indexed import (
    AnyOf,
    At,
    Closing,
    OneLike,
    Table,
    Total,
    VectorAt,
    VectorTotal,
    children,
)
from armillary.algebra.iteration import Iterated, Iteration
from armillary.algebra.rotation import Elementary, RotationSymbol, Transposed, factors
from armillary.derivation.quantity import Constant
from armillary.verify.audit.numbers import Numbers

Leaf = s.Symbol | v.VectorSymbol | RotationSymbol
Triple = tuple[Any, Any, Any]
Place = tuple[tuple[Index, int], ...]  # indices that are held at a part, by a sum around them


_NUMBERS: dict[tuple[type, sympy.Expr], Any] = {}


class Values:
    """Values of nodes at the points given for their leaves.

    Args:
        numbers: the number system.
        leaves: scalars (n,), vectors (n, 3), rotations (n, 3, 3), by node; with the parts of an
            index before the last axes. Of an index itself its part at each point (n,), from 0.
    """

    def __init__(self, numbers: Numbers, leaves: Mapping[Leaf | Index, Any]) -> None:
        self.numbers = numbers
        self._leaves: dict[int, Any] = {}
        self._parts: dict[Index, Any] = {}
        for leaf, array in leaves.items():
            if isinstance(leaf, Index):
                self._parts[leaf] = np.asarray(array, dtype=int)
            else:
                self._leaves[id(leaf)] = numbers.array(array)
        self._given = tuple(leaves)  # their ids stay theirs
        self.count = min(
            (len(a) for a in (*self._leaves.values(), *self._parts.values())), default=1
        )
        self._done: dict[tuple[int, Place], tuple[Any, Any]] = {}
        self._place: Place = ()
        self._open: dict[int, tuple[Any, frozenset[Index]]] = {}

    def __call__(self, node: Any) -> Any:
        """A scalar's values (n,), or one number of a constant; a vector's as three of them."""
        key = id(node), self._place_of(node)
        known = self._done.get(key)
        if known is None:
            known = (node, self.value(node))
            self._done[key] = known
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

    # -- parts of an index --------------------------------------------------------------------

    def at_part(self, node: Any, over: Index, k: int) -> Any:
        """The values of a node with an index held at one part."""
        before, parts = self._place, self._parts
        self._place = (*(held for held in before if held[0] != over), (over, k))
        self._parts = {**parts, over: np.full(self.count, k)}
        try:
            return self(node)
        finally:
            self._place, self._parts = before, parts

    def _place_of(self, node: Any) -> Place:
        """The held indices that a node is open in."""
        if not self._place:
            return ()
        opened = self._opened(node)
        return tuple(held for held in self._place if held[0] in opened)

    def _opened(self, node: Any) -> frozenset[Index]:
        known = self._open.get(id(node))
        if known is None:
            known = node, self._opened_anew(node)
            self._open[id(node)] = known
        return known[1]

    def _opened_anew(self, node: Any) -> frozenset[Index]:
        per = getattr(node, "per", None)
        if isinstance(per, Index):
            return frozenset({per})
        inner = frozenset[Index]().union(*map(self._opened, children(node)))
        return inner - {node.over} if isinstance(node, Closing) else inner

    def _of_part(self, array: Any, over: Index) -> Any:
        """Of values for every part (n, parts, ...), those of the part at each point."""
        return array[np.arange(len(array)), self._parts[over]]

    # -- nodes --------------------------------------------------------------------------------

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
        array, per = self._leaves[id(node)], getattr(node, "per", None)
        return array if per is None else self._of_part(array, per)

    @value.register
    def _(self, node: Table) -> Any:
        listed = np.array([self.numbers.number(exact) for exact in node.values])
        return listed[self._parts[node.per]]

    @value.register
    def _(self, node: OneLike) -> Any:
        return self(s.ONE)

    @value.register
    def _(self, node: Total) -> Any:
        return sum(self.at_part(node.term, node.over, k) for k in range(node.over.size))

    @value.register
    def _(self, node: At | VectorAt) -> Any:
        return self.at_part(node.term, node.over, node.place)

    @value.register
    def _(self, node: Iterated) -> Any:
        return self(node.iteration)[node.slot]

    @value.register
    def _(self, node: Iteration) -> list[Any]:
        """The unknowns after the last turn; each turn forgets the values of the one before."""
        found = [self.array(start) for start in node.start]
        for _ in range(node.turns.size):
            turn = Values(self.numbers, {})
            turn.count, turn._parts = self.count, self._parts
            turn._leaves = {**self._leaves, **dict(zip(map(id, node.unknowns), found, strict=True))}
            found = [turn.array(value) for value in node.following]
        return found

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
    def _(self, node: AnyOf) -> Any:
        parts = [self.at_part(node.term, node.over, k) for k in range(node.over.size)]
        return np.logical_or.reduce(np.broadcast_arrays(*parts))

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
        array, per = self._leaves[id(node)], getattr(node, "per", None)
        if per is not None:
            array = self._of_part(array, per)
        return array[:, 0], array[:, 1], array[:, 2]

    @value.register
    def _(self, node: VectorTotal) -> Triple:
        parts = [self.at_part(node.term, node.over, k) for k in range(node.over.size)]
        x, y, z = (sum(part[i] for part in parts) for i in range(3))
        return x, y, z

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
