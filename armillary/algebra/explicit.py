"""The text-book form: every structural expression as SymPy scalars and matrices.

This is the proof side of the house. The program never sees these matrices; the page shows them, and
an identity holds when their difference reduces to zero.
"""

from __future__ import annotations

from collections.abc import Mapping
from copy import copy
from functools import singledispatchmethod
from itertools import islice
from typing import Any

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.direction import OfDirection
from armillary.algebra.index import Index
from armillary.algebra.indexed import (
    AnyOf,
    At,
    OneLike,
    Table,
    Total,
    VectorAt,
    VectorTotal,
    indices,
)
from armillary.algebra.iteration import Iterated, Iteration
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import (
    Elementary,
    Rotation,
    RotationSymbol,
    Transposed,
    factors,
)

_SHORT = 200  # nodes of a condition
Node = s.Scalar | s.Condition | v.Vector | Rotation | Pose | Twist | Wrench | Matrix


class Explicit:
    """Translates nodes to SymPy; one instance shares what the derivation shares.

    `named` keeps references as symbols of their own instead of opening them. `at` says at which
    part of an index an expression is wanted; an index that it leaves out stays open, and what is
    per part keeps one name for all. The result of an iteration is a symbol of its own:
    `iterations` collects under its name what it stands for, and at which parts.
    """

    def __init__(self, named: bool = False, at: Mapping[Index, int] | None = None) -> None:
        self.named = named
        self.at: dict[Index, int] = dict(at or {})
        self.iterations: dict[str, tuple[Iteration, Explicit]] = {}
        self._done: dict[int, tuple[Node, sympy.Basic]] = {}
        self._elsewhere: dict[tuple[Index, int], Explicit] = {}

    def __call__(self, node: Node) -> sympy.Basic:
        known = self._done.get(id(node))
        if known is None:
            known = (node, self.translate(node))  # the node is held, so its id stays its own
            self._done[id(node)] = known
        return known[1]

    def moved(self, over: Index, place: int) -> Explicit:
        """The same translation at one part of an index."""
        key = over, place
        if key not in self._elsewhere:
            other = copy(self)
            other.at, other._done, other._elsewhere = {**self.at, over: place}, {}, {}
            self._elsewhere[key] = other
        return self._elsewhere[key]

    def name(self, node: s.Symbol | s.ScalarReference | v.VectorSymbol | v.VectorReference) -> str:
        """The name of a symbol or a definition, with the numbers of the parts it is wanted at."""
        return "_".join([node.name, *self._places(node)])

    def _places(self, node: object) -> list[str]:
        if not self.at:
            return []
        return [str(self.at[i] + 1) for i in sorted(indices(node), key=str) if i in self.at]

    @singledispatchmethod
    def translate(self, node: Node) -> sympy.Basic:
        raise TypeError(f"no explicit form for {type(node).__name__}")

    @translate.register
    def _(self, node: s.Number) -> sympy.Basic:
        return node.value

    @translate.register
    def _(self, node: s.Symbol) -> sympy.Basic:
        return symbol(self.name(node))

    @translate.register
    def _(self, node: Table) -> sympy.Basic:
        known = self.at.get(node.per)
        return symbol(node.name) if known is None else node.values[known]

    @translate.register
    def _(self, node: OneLike) -> sympy.Basic:
        return sympy.Integer(1)

    @translate.register
    def _(self, node: Total) -> sympy.Basic:
        parts = (self.moved(node.over, k)(node.term) for k in range(node.over.size))
        return sum(parts, sympy.Integer(0))

    @translate.register
    def _(self, node: VectorTotal) -> sympy.Basic:
        parts = (self.moved(node.over, k)(node.term) for k in range(node.over.size))
        return sum(parts, sympy.zeros(3, 1))

    @translate.register
    def _(self, node: At | VectorAt) -> sympy.Basic:
        return self.moved(node.over, node.place)(node.term)

    @translate.register
    def _(self, node: AnyOf) -> sympy.Basic:
        return sympy.Or(*(self.moved(node.over, k)(node.term) for k in range(node.over.size)))

    @translate.register
    def _(self, node: Iterated) -> sympy.Basic:
        given, copies = node.iteration, 1
        key = first = "_".join([given.turns.name, *self._places(node)])
        while self.iterations.setdefault(key, (given, self))[0] is not given:
            copies += 1
            key = f"{first}_copy{copies}"
        return symbol(f"{key}_{node.unknown.name}")

    @translate.register
    def _(self, node: s.Add) -> sympy.Basic:
        return self(node.left) + self(node.right)

    @translate.register
    def _(self, node: s.Multiply) -> sympy.Basic:
        return self(node.left) * self(node.right)

    @translate.register
    def _(self, node: s.Negate) -> sympy.Basic:
        return -self(node.argument)

    @translate.register
    def _(self, node: s.Divide) -> sympy.Basic:
        return self(node.numerator) / self(node.denominator)

    @translate.register
    def _(self, node: s.SquareRoot) -> sympy.Basic:
        return sympy.sqrt(self(node.argument))

    @translate.register
    def _(self, node: s.Sine) -> sympy.Basic:
        return sympy.sin(self(node.argument))

    @translate.register
    def _(self, node: s.Cosine) -> sympy.Basic:
        return sympy.cos(self(node.argument))

    @translate.register
    def _(self, node: s.ArcTangent) -> sympy.Basic:
        return sympy.atan2(self(node.y), self(node.x))

    @translate.register
    def _(self, node: s.ArcSine) -> sympy.Basic:
        return sympy.asin(self(node.argument))

    @translate.register
    def _(self, node: s.ArcCosine) -> sympy.Basic:
        return sympy.acos(self(node.argument))

    @translate.register
    def _(self, node: OfDirection) -> sympy.Basic:
        return self(node.explicit())

    @translate.register
    def _(self, node: s.Absolute) -> sympy.Basic:
        return sympy.Abs(self(node.argument))

    @translate.register
    def _(self, node: s.Select) -> sympy.Basic:
        condition = self(node.condition)
        then, otherwise = self(node.then), self(node.otherwise)
        if _is_short(condition):
            return sympy.Piecewise((then, condition), (otherwise, True))
        return _Chosen(condition, then, otherwise)

    @translate.register
    def _(self, node: s.Component) -> sympy.Basic:
        return self(node.vector)[node.index]

    @translate.register
    def _(self, node: s.Dot) -> sympy.Basic:
        left, right = self(node.left), self(node.right)
        return sum((left[i] * right[i] for i in range(3)), sympy.Integer(0))

    @translate.register
    def _(self, node: s.ScalarReference) -> sympy.Basic:
        return symbol(self.name(node)) if self.named else self(node.expression)

    @translate.register
    def _(self, node: s.Less) -> sympy.Basic:
        return self(node.left) < self(node.right)

    @translate.register
    def _(self, node: s.Both) -> sympy.Basic:
        return sympy.And(self(node.left), self(node.right))

    @translate.register
    def _(self, node: s.Not) -> sympy.Basic:
        return sympy.Not(self(node.argument))

    @translate.register
    def _(self, node: s.ConditionReference) -> sympy.Basic:
        return self(node.expression)

    @translate.register
    def _(self, node: v.Components) -> sympy.Basic:
        return sympy.Matrix([self(c) for c in node.components])

    @translate.register
    def _(self, node: v.Basis) -> sympy.Basic:
        return sympy.eye(3)[:, node.axis]

    @translate.register
    def _(self, node: v.VectorSymbol) -> sympy.Basic:
        return vector_symbol(self.name(node))

    @translate.register
    def _(self, node: v.VectorSum) -> sympy.Basic:
        return self(node.left) + self(node.right)

    @translate.register
    def _(self, node: v.VectorNegate) -> sympy.Basic:
        return -self(node.argument)

    @translate.register
    def _(self, node: v.Scaled) -> sympy.Basic:
        return self(node.factor) * self(node.vector)

    @translate.register
    def _(self, node: v.Cross) -> sympy.Basic:
        return self(node.left).cross(self(node.right))

    @translate.register
    def _(self, node: v.Unit) -> sympy.Basic:
        inner = self(node.vector)
        return inner / sympy.sqrt(sum(c**2 for c in inner))

    @translate.register
    def _(self, node: v.Rotated) -> sympy.Basic:
        return self(node.rotation) * self(node.vector)

    @translate.register
    def _(self, node: v.Choice) -> sympy.Basic:
        return self(node.nested)

    @translate.register
    def _(self, node: v.VectorReference) -> sympy.Basic:
        return vector_symbol(self.name(node)) if self.named else self(node.expression)

    @translate.register
    def _(self, node: Rotation) -> sympy.Basic:
        product = sympy.eye(3)
        for factor in factors(node):
            product = product * self(factor)
        return product

    @translate.register
    def _(self, node: Elementary) -> sympy.Basic:
        return elementary_matrix(node.axis, self(node.angle))

    @translate.register
    def _(self, node: RotationSymbol) -> sympy.Basic:
        return rotation_symbol(node.name)

    @translate.register
    def _(self, node: Transposed) -> sympy.Basic:
        return self(node.symbol).T

    @translate.register
    def _(self, node: Pose) -> sympy.Basic:
        top = self(node.rotation).row_join(self(node.position))
        return top.col_join(sympy.Matrix([[0, 0, 0, 1]]))

    @translate.register
    def _(self, node: Twist) -> sympy.Basic:
        return self(node.linear).col_join(self(node.angular))

    @translate.register
    def _(self, node: Wrench) -> sympy.Basic:
        return self(node.force).col_join(self(node.moment))

    @translate.register
    def _(self, node: Matrix) -> sympy.Basic:
        return sympy.Matrix([[self(entry) for entry in row] for row in node.rows])


class _Chosen(sympy.Expr):
    """One of two values by a long condition, which is left as it is: SymPy would take minutes."""

    is_real = is_commutative = True

    def _mpmathcode(self, printer: Any) -> str:
        condition, then, otherwise = map(printer._print, self.args)
        return f"(({then}) if ({condition}) else ({otherwise}))"


def _is_short(form: sympy.Basic) -> bool:
    return next(islice(sympy.preorder_traversal(form), _SHORT, None), None) is None


def symbol(name: str) -> sympy.Symbol:
    """The SymPy symbol of a scalar name; every quantity is real."""
    return sympy.Symbol(name, real=True)


def vector_symbol(name: str) -> sympy.Matrix:
    """A column of the symbols of a vector's components."""
    return sympy.Matrix([symbol(f"{name}_{axis}") for axis in v.AXIS_NAMES])


def rotation_symbol(name: str) -> sympy.Matrix:
    """A matrix of the symbols of a rotation's entries."""
    return sympy.Matrix(3, 3, lambda i, j: symbol(f"{name}_{i + 1}{j + 1}"))


def elementary_matrix(axis: int, angle: sympy.Expr) -> sympy.Matrix:
    """The text-book matrix, entry by entry: active, right-handed."""
    c, n = sympy.cos(angle), sympy.sin(angle)
    return sympy.Matrix(
        {
            0: [[1, 0, 0], [0, c, -n], [0, n, c]],
            1: [[c, 0, n], [0, 1, 0], [-n, 0, c]],
            2: [[c, -n, 0], [n, c, 0], [0, 0, 1]],
        }[axis]
    )


def reduce_trigonometry(expression: sympy.Expr) -> sympy.Expr:
    """A normal form that is zero for every polynomial identity of sines and cosines."""
    opened = sympy.expand(sympy.expand_trig(expression))
    opened = sympy.together(opened)
    numerator, denominator = sympy.fraction(opened)
    numerator = sympy.expand(numerator)
    replaced: dict[sympy.Expr, sympy.Symbol] = {}
    for sine in sorted(numerator.atoms(sympy.sin), key=sympy.default_sort_key):
        replaced[sine] = sympy.Dummy("s")
    reduced = numerator.subs(replaced)
    for sine, placeholder in replaced.items():
        square = 1 - sympy.cos(sine.args[0]) ** 2
        polynomial = sympy.Poly(reduced, placeholder)
        even_odd = [sympy.Integer(0), sympy.Integer(0)]
        for (power,), coefficient in polynomial.terms():
            even_odd[power % 2] += coefficient * square ** (power // 2)
        reduced = sympy.expand(even_odd[0] + even_odd[1] * placeholder)
    back = {placeholder: sine for sine, placeholder in replaced.items()}
    return sympy.expand(reduced).subs(back) / denominator
