"""Lowers a kernel's expressions to a program, one direction of evaluation at a time.

A `Strategy` fixes what the algebra leaves open; `search` lowers with every strategy and keeps the
cheapest.
"""

from __future__ import annotations

from dataclasses import replace
from functools import singledispatchmethod

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.direction import (
    Azimuth,
    AzimuthCosine,
    AzimuthSine,
    Elevation,
    ElevationTangent,
    normalised_in,
)
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
from armillary.algebra.rigid import Matrix
from armillary.algebra.rotation import (
    Rotation,
    keeps_norms,
)
from armillary.derivation.quantity import Constant, Quantity
from armillary.derivation.statements import Kernel, Output
from armillary.program.directing import Directing, flattened, opened
from armillary.program.program import Data, Op, Program, Result
from armillary.program.strategy import (
    FORMS,
    Decision,
    Local,
    Strategy,
    strategies,
)

__all__ = ["Strategy", "decisions", "lower", "strategies"]


def lower(
    kernel: Kernel,
    strategy: Strategy,
    local: Local | None = None,
    beforehand: frozenset[str] = frozenset(),
) -> Program:
    """The structured program of a kernel under one strategy, with local departures from it.

    `beforehand` names the quantities that a set-up is told.
    """
    return replace(_lowered(kernel, strategy, local)[0], beforehand=beforehand)


def decisions(kernel: Kernel, strategy: Strategy, local: Local) -> list[Decision]:
    """Where a kernel leaves the direction open, in the order met, with the ways not taken."""
    return _lowered(kernel, strategy, local)[1]


def _lowered(
    kernel: Kernel, strategy: Strategy, local: Local | None
) -> tuple[Program, list[Decision]]:
    lowering = _Lowering(strategy, local or {})
    results = tuple(lowering.result(output) for output in kernel.outputs)
    cases = tuple((case.status, lowering(case.condition)) for case in kernel.cases)
    return lowering.builder.finish(kernel, results, cases), lowering.decisions


class _Lowering(Directing):
    def __init__(self, strategy: Strategy, local: Local) -> None:
        super().__init__(strategy, local)
        self._done: dict[object, int] = {}
        self._after: dict[int, list[int]] = {}

    def __call__(self, node: s.Scalar | s.Condition | v.Vector) -> int:
        if node not in self._done:
            self._done[node] = self.translate(node)
        return self._done[node]

    def result(self, output: Output) -> Result:
        value = output.value
        if isinstance(value, Matrix):
            entries = tuple(self(e) for row in value.rows for e in row)
        elif isinstance(value, Rotation):
            columns = self.columns(value)
            entries = tuple(self.pick(columns[j], i) for i in range(3) for j in range(3))
        elif isinstance(value, v.Vector):
            entries = tuple(self.pick(self(value), i) for i in range(3))
        else:
            entries = (self(value),)
        return Result(output.name, output.shape, entries, output.indices)

    # -- one rule a node ----------------------------------------------------------------------

    @singledispatchmethod
    def translate(self, node: object) -> int:
        raise TypeError(f"no lowering for {type(node).__name__}")

    @translate.register
    def _(self, node: s.Number) -> int:
        return self.builder.constant(node.value)

    @translate.register
    def _(self, node: Constant) -> int:
        return self.builder.constant(node.value)

    @translate.register
    def _(self, node: s.Symbol) -> int:
        return self.builder.emit(Op.INPUT, data=node.name)

    @translate.register
    def _(self, node: Quantity) -> int:
        data = node.name if node.per is None else (node.name, node.per, 1, 0)
        return self.builder.emit(Op.INPUT, data=data)

    @translate.register
    def _(self, node: Table) -> int:
        return self.builder.table(node.per, node.values)

    @translate.register
    def _(self, node: OneLike) -> int:
        return self.builder.constant(sympy.Integer(1))

    @translate.register
    def _(self, node: Total) -> int:
        return self.builder.sum(self(node.term), node.over)

    @translate.register
    def _(self, node: At) -> int:
        return self.builder.element(self(node.term), node.over, node.place)

    @translate.register
    def _(self, node: Iterated) -> int:
        given = node.iteration
        if id(given) not in self._after:
            self._after[id(given)] = self.iterated(given)
        return self._after[id(given)][node.slot]

    def iterated(self, given: Iteration) -> list[int]:
        """The values of the unknowns after the last turn."""
        b, turns = self.builder, given.turns
        # Every unknown is carried, so each one's start must say which indices the values run over.
        open_in = indices((given.start, given.following)) - {turns}
        phis = [
            b.phi(self(start), turns, unknown.name, open_in)
            for start, unknown in zip(given.start, given.unknowns, strict=True)
        ]
        self._done.update(zip(given.unknowns, phis, strict=True))
        following = [self(value) for value in given.following]
        for phi, value in zip(phis, following, strict=True):
            b.carry(phi, value)
        return [b.element(value, turns, turns.size - 1) for value in following]

    @translate.register
    def _(self, node: s.Add) -> int:
        return self.builder.add(self(node.left), self(node.right))

    @translate.register
    def _(self, node: s.Multiply) -> int:
        return self.builder.multiply(self(node.left), self(node.right))

    @translate.register
    def _(self, node: s.Negate) -> int:
        return self.builder.negate(self(node.argument))

    @translate.register
    def _(self, node: s.Divide) -> int:
        return self.builder.divide(self(node.numerator), self(node.denominator))

    @translate.register
    def _(self, node: s.SquareRoot) -> int:
        return self.builder.sqrt(self(node.argument))

    @translate.register
    def _(self, node: s.Sine) -> int:
        return self.builder.sin(self(node.argument))

    @translate.register
    def _(self, node: s.Cosine) -> int:
        return self.builder.cos(self(node.argument))

    @translate.register
    def _(self, node: s.ArcTangent) -> int:
        return self.builder.atan2(self(node.y), self(node.x))

    @translate.register
    def _(self, node: s.ArcSine | s.ArcCosine) -> int:
        return self(node.explicit())

    @translate.register
    def _(self, node: s.Absolute) -> int:
        return self.builder.absolute(self(node.argument))

    @translate.register
    def _(self, node: Azimuth) -> int:
        x, y, _, _ = self.direction(node.vector)
        return self.builder.atan2(x, y)

    @translate.register
    def _(self, node: Elevation) -> int:
        _, _, z, rho = self.direction(node.vector)
        return self.builder.atan2(z, rho)

    @translate.register
    def _(self, node: AzimuthSine) -> int:
        x, _, _, rho = self.direction(node.vector)
        return self.builder.divide(x, rho)

    @translate.register
    def _(self, node: AzimuthCosine) -> int:
        _, y, _, rho = self.direction(node.vector)
        return self.builder.divide(y, rho)

    @translate.register
    def _(self, node: ElevationTangent) -> int:
        _, _, z, rho = self.direction(node.vector)
        return self.builder.divide(z, rho)

    @translate.register
    def _(self, node: s.Select) -> int:
        parts = (self(node.condition), self(node.then), self(node.otherwise))
        return self.builder.select(*parts)

    @translate.register
    def _(self, node: s.Component) -> int:
        return self.pick(self(node.vector), node.index)

    @translate.register
    def _(self, node: s.Dot) -> int:
        left, right = _without_common_rotation(node.left, node.right)
        if left is right and isinstance(opened(left), v.Unit):
            return self.builder.constant(sympy.Integer(1))
        return self.builder.emit(Op.DOT, self(left), self(right))

    @translate.register
    def _(self, node: s.ScalarReference) -> int:
        number = self(node.expression)
        self.builder.label(number, (node.name,), node.identifier)
        return number

    @translate.register
    def _(self, node: s.Less) -> int:
        return self.builder.less(self(node.left), self(node.right))

    @translate.register
    def _(self, node: s.Both) -> int:
        return self.builder.both(self(node.left), self(node.right))

    @translate.register
    def _(self, node: s.Not) -> int:
        return self.builder.invert(self(node.argument))

    @translate.register
    def _(self, node: AnyOf) -> int:
        return self.builder.any_of(self(node.term), node.over)

    @translate.register
    def _(self, node: s.ConditionReference) -> int:
        number = self(node.expression)
        self.builder.label(number, (node.name,), node.identifier)
        return number

    @translate.register
    def _(self, node: v.Components) -> int:
        return self.builder.emit(Op.PACK, *(self(c) for c in node.components))

    @translate.register
    def _(self, node: v.Basis) -> int:
        return self.basis(node.axis)

    @translate.register
    def _(self, node: v.VectorSymbol) -> int:
        b, per = self.builder, getattr(node, "per", None)
        places: list[Data] = [(node.name, k) for k in range(3)]
        if per is not None:
            places = [(node.name, per, 3, k) for k in range(3)]
        return b.emit(Op.PACK, *(b.emit(Op.INPUT, data=place) for place in places))

    @translate.register
    def _(self, node: VectorTotal) -> int:
        b, term = self.builder, self(node.term)
        return b.emit(Op.PACK, *(b.sum(self.pick(term, k), node.over) for k in range(3)))

    @translate.register
    def _(self, node: VectorAt) -> int:
        b, term = self.builder, self(node.term)
        parts = (b.element(self.pick(term, k), node.over, node.place) for k in range(3))
        return b.emit(Op.PACK, *parts)

    @translate.register
    def _(self, node: v.VectorSum) -> int:
        return self.builder.emit(Op.ADD_VECTORS, self(node.left), self(node.right))

    @translate.register
    def _(self, node: v.VectorNegate) -> int:
        return self.builder.emit(Op.NEGATE_VECTOR, self(node.argument))

    @translate.register
    def _(self, node: v.Scaled) -> int:
        return self.scaled(self(node.factor), self(node.vector))

    @translate.register
    def _(self, node: v.Cross) -> int:
        return self.builder.emit(Op.CROSS, self(node.left), self(node.right))

    @translate.register
    def _(self, node: v.Unit) -> int:
        if node not in self._squares:
            self._squares[node] = self(s.Dot(node.vector, node.vector))
        return self.normalised(node, self(node.vector))

    @translate.register
    def _(self, node: v.Rotated) -> int:
        root = normalised_in(node)
        if root is not None and self.is_normalised_last(root):
            turned = self.unscaled(node)
            if root not in self._squares:
                self._squares[root] = self.builder.emit(Op.DOT, turned, turned)
            return self.normalised(root, turned)
        chain, vector = flattened(node)
        return self.turned(node, chain, self(vector))

    @translate.register
    def _(self, node: v.Choice) -> int:
        return self(getattr(node, self.decide(node, self.strategy.form, FORMS)))

    @translate.register
    def _(self, node: v.VectorReference) -> int:
        number = self(node.expression)
        names = tuple(f"{node.name}_{axis}" for axis in v.AXIS_NAMES)
        self.builder.label(number, names, node.identifier)
        return number


def _without_common_rotation(left: v.Vector, right: v.Vector) -> tuple[v.Vector, v.Vector]:
    """A rotation keeps norms: (R a).(R a) = a.a, if R is one by its form, not by its entries."""
    while left is right:
        plain = opened(left)
        if not isinstance(plain, v.Rotated) or not keeps_norms(plain.rotation):
            break
        left = right = plain.vector
    return left, right
