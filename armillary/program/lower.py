"""Lowers a kernel's expressions to a program, one direction of evaluation at a time.

A `Strategy` fixes what the algebra leaves open: how a vector is carried through several rotations,
in which direction a product of rotations is formed, and which of the equal forms of a vector is
computed. `search` lowers with every strategy and keeps the cheapest.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import singledispatchmethod
from itertools import product

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.direction import Azimuth, Elevation
from armillary.algebra.rigid import Matrix
from armillary.algebra.rotation import Elementary, Rotation, RotationReference, factors
from armillary.derivation.quantity import Constant
from armillary.derivation.statements import Kernel, Output
from armillary.program.builder import Builder
from armillary.program.program import Op, Program, Result

FORMS = ("nested", "summed", "merged", "inner")
CARRIES = ("steps", "matrix")


@dataclass(frozen=True)
class Strategy:
    """A direction of evaluation.

    Attributes:
        carry: "steps" turns a vector by one elementary rotation after another, "matrix" multiplies
            it with the product.
        compose: "inward" forms a product's columns from the innermost factor out, "outward" keeps
            every prefix of the product and mixes its columns.
        form: which of the equal forms of a vector is taken (see `Choice`); with "merged",
            products of rotations about one axis are merged too.
    """

    carry: str = "steps"
    compose: str = "inward"
    form: str = "nested"


def strategies() -> list[Strategy]:
    """Every direction of evaluation; the first is the plain one and wins ties."""
    return [
        Strategy(carry, compose, form)
        for form, carry, compose in product(FORMS, CARRIES, ("inward", "outward"))
    ]


Local = Mapping[v.Vector, str]


@dataclass(frozen=True)
class Decision:
    """A vector that can be computed in more than one way, and the ways."""

    node: v.Vector
    options: tuple[str, ...]


def lower(kernel: Kernel, strategy: Strategy, local: Local | None = None) -> Program:
    """The structured program of a kernel under one strategy, with local departures from it."""
    return _lowered(kernel, strategy, local)[0]


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


class _Lowering:
    def __init__(self, strategy: Strategy, local: Local) -> None:
        self.strategy, self.local = strategy, local
        self.decisions: list[Decision] = []
        self.builder = Builder()
        self._done: dict[object, int] = {}
        self._columns: dict[tuple[object, ...], tuple[int, int, int]] = {}

    def __call__(self, node: s.Scalar | s.Condition | v.Vector) -> int:
        if node not in self._done:
            self._done[node] = self.translate(node)
        return self._done[node]

    def decide(self, node: v.Vector, usual: str, options: tuple[str, ...]) -> str:
        """The way a vector is computed here."""
        taken = self.local.get(node, usual)
        self.decisions.append(Decision(node, tuple(o for o in options if o != taken)))
        return taken

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
        return Result(output.name, output.shape, entries)

    # -- vectors and rotations ----------------------------------------------------------------

    def pick(self, vector: int, index: int) -> int:
        instruction = self.builder.instructions[vector]
        if instruction.op is Op.PACK:
            return instruction.args[index]
        return self.builder.emit(Op.PICK, vector, data=index)

    def basis(self, axis: int) -> int:
        b = self.builder
        return b.emit(Op.PACK, *(b.constant(sympy.Integer(int(k == axis))) for k in range(3)))

    def turn(self, factor: Elementary, vector: int) -> int:
        angle = self(factor.angle)
        b = self.builder
        return b.emit(Op.ROTATE, b.sin(angle), b.cos(angle), vector, data=factor.axis)

    def scaled(self, factor: int, vector: int) -> int:
        return self.builder.emit(Op.SCALE, factor, vector)

    def combination(self, weights: tuple[int, ...], vectors: tuple[int, ...]) -> int:
        terms = [self.scaled(w, c) for w, c in zip(weights, vectors, strict=True)]
        total = terms[0]
        for term in terms[1:]:
            total = self.builder.emit(Op.ADD_VECTORS, total, term)
        return total

    def columns(self, rotation: Rotation) -> tuple[int, int, int]:
        """The columns of a rotation matrix."""
        found = self._product(self.chain(factors(rotation)))
        if isinstance(rotation, RotationReference):
            for j, column in enumerate(found):
                names = tuple(f"{rotation.name}_{i + 1}{j + 1}" for i in range(3))
                self.builder.label(column, names, rotation.identifier)
        return found

    def chain(self, given: tuple[Elementary, ...]) -> tuple[Elementary, ...]:
        """The factors of a product, those about one axis merged if the strategy says so."""
        if self.strategy.form != "merged":
            return given
        done: list[Elementary] = []
        for factor in given:
            if done and done[-1].axis == factor.axis:
                done[-1] = Elementary(factor.axis, s.add(done[-1].angle, factor.angle))
            else:
                done.append(factor)
        return tuple(done)

    def _product(self, chain: tuple[Elementary, ...]) -> tuple[int, int, int]:
        key = tuple((f.axis, self(f.angle)) for f in chain)
        if key not in self._columns:
            if self.strategy.compose == "inward" or not chain:
                found = tuple(self.carry(chain, self.basis(j)) for j in range(3))
            else:
                found = self._mixed(self._product(chain[:-1]), chain[-1])
            self._columns[key] = (found[0], found[1], found[2])
        return self._columns[key]

    def _mixed(self, before: tuple[int, int, int], last: Elementary) -> tuple[int, ...]:
        """Columns of P E from those of P: the two that are not on the axis are mixed."""
        b = self.builder
        angle = self(last.angle)
        sine, cosine = b.sin(angle), b.cos(angle)
        first, second = (last.axis + 1) % 3, (last.axis + 2) % 3
        mixed = list(before)
        pair = (before[first], before[second])
        mixed[first] = self.combination((cosine, sine), pair)
        mixed[second] = self.combination((b.negate(sine), cosine), pair)
        return tuple(mixed)

    def carry(self, chain: tuple[Elementary, ...], vector: int) -> int:
        for factor in reversed(chain):
            vector = self.turn(factor, vector)
        return vector

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
    def _(self, node: s.Absolute) -> int:
        return self.builder.absolute(self(node.argument))

    @translate.register
    def _(self, node: Azimuth) -> int:
        return self(node.explicit())

    @translate.register
    def _(self, node: Elevation) -> int:
        return self(node.explicit())

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
        if left is right and isinstance(_opened(left), v.Unit):
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
        b = self.builder
        return b.emit(Op.PACK, *(b.emit(Op.INPUT, data=(node.name, k)) for k in range(3)))

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
        b = self.builder
        length = b.sqrt(self(s.Dot(node.vector, node.vector)))
        return self.scaled(b.divide(b.constant(sympy.Integer(1)), length), self(node.vector))

    @translate.register
    def _(self, node: v.Rotated) -> int:
        chain, vector = _flattened(node)
        chain, inner = self.chain(chain), self(vector)
        usual = self.strategy.carry if len(chain) > 2 else "steps"
        if len(chain) < 2 or self.decide(node, usual, CARRIES) == "steps":
            return self.carry(chain, inner)
        parts = tuple(self.pick(inner, k) for k in range(3))
        return self.combination(parts, self._product(chain))

    @translate.register
    def _(self, node: v.Choice) -> int:
        return self(getattr(node, self.decide(node, self.strategy.form, FORMS)))

    @translate.register
    def _(self, node: v.VectorReference) -> int:
        number = self(node.expression)
        names = tuple(f"{node.name}_{axis}" for axis in v.AXIS_NAMES)
        self.builder.label(number, names, node.identifier)
        return number


def _opened(node: v.Vector) -> v.Vector:
    while isinstance(node, v.VectorReference):
        node = node.expression
    return node


def _flattened(node: v.Rotated) -> tuple[tuple[Elementary, ...], v.Vector]:
    """Nested rotations as one chain; a named vector inside stays a value of its own."""
    chain, inner = factors(node.rotation), node.vector
    while isinstance(inner, v.Rotated):
        chain, inner = chain + factors(inner.rotation), inner.vector
    return chain, inner


def _without_common_rotation(left: v.Vector, right: v.Vector) -> tuple[v.Vector, v.Vector]:
    """A rotation keeps norms: (R a).(R a) = a.a, whatever R is."""
    while left is right and isinstance(_opened(left), v.Rotated):
        opened = _opened(left)
        assert isinstance(opened, v.Rotated)
        left = right = opened.vector
    return left, right
