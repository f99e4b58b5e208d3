"""How a lowering carries vectors through rotations and forms their products."""

from __future__ import annotations

from abc import ABC, abstractmethod

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rotation import (
    Elementary,
    Factor,
    Rotation,
    RotationReference,
    RotationSymbol,
    Transposed,
    factors,
)
from armillary.program.builder import Builder
from armillary.program.program import Op
from armillary.program.strategy import CARRIES, Decision, Local, Strategy


class Carrying(ABC):
    """Instructions for vectors and rotations, in the directions that were decided."""

    def __init__(self, strategy: Strategy, local: Local) -> None:
        self.strategy, self.local = strategy, local
        self.decisions: list[Decision] = []
        self._decided: set[v.Vector] = set()
        self.builder = Builder()
        self._columns: dict[tuple[object, ...], tuple[int, int, int]] = {}

    @abstractmethod
    def __call__(self, node: s.Scalar | s.Condition | v.Vector) -> int:
        """The number of the instruction that computes a node."""

    def decide(self, node: v.Vector, usual: str, options: tuple[str, ...]) -> str:
        """The way a vector is computed here."""
        taken = self.local.get(node, usual)
        if node not in self._decided:
            self._decided.add(node)
            self.decisions.append(Decision(node, tuple(o for o in options if o != taken)))
        return taken

    def pick(self, vector: int, index: int) -> int:
        instruction = self.builder.instructions[vector]
        if instruction.op is Op.PACK:
            return instruction.args[index]
        return self.builder.emit(Op.PICK, vector, data=index)

    def basis(self, axis: int) -> int:
        b = self.builder
        return b.emit(Op.PACK, *(b.constant(sympy.Integer(int(k == axis))) for k in range(3)))

    def turn(self, factor: Factor, vector: int) -> int:
        if not isinstance(factor, Elementary):
            parts = (self.pick(vector, 0), self.pick(vector, 1), self.pick(vector, 2))
            return self.combination(parts, self.given(factor))
        angle = self(factor.angle)
        b = self.builder
        return b.emit(Op.ROTATE, b.sin(angle), b.cos(angle), vector, data=factor.axis)

    def given(self, factor: RotationSymbol | Transposed) -> tuple[int, int, int]:
        """The columns of a rotation that is an input."""
        b = self.builder
        inverse = isinstance(factor, Transposed)
        name = factor.symbol.name if isinstance(factor, Transposed) else factor.name
        places = [[i + 3 * j if inverse else 3 * i + j for i in range(3)] for j in range(3)]
        inputs = [[b.emit(Op.INPUT, data=(name, k)) for k in column] for column in places]
        first, second, third = (b.emit(Op.PACK, *column) for column in inputs)
        return first, second, third

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

    def chain(self, given: tuple[Factor, ...]) -> tuple[Factor, ...]:
        """The factors of a product, those about one axis merged if the strategy says so."""
        if self.strategy.form != "merged":
            return given
        done: list[Factor] = []
        for factor in given:
            last = done[-1] if done else None
            if (
                isinstance(last, Elementary)
                and isinstance(factor, Elementary)
                and last.axis == factor.axis
            ):
                done[-1] = Elementary(factor.axis, s.add(last.angle, factor.angle))
            else:
                done.append(factor)
        return tuple(done)

    def _product(self, chain: tuple[Factor, ...]) -> tuple[int, int, int]:
        key = tuple(self._key(f) for f in chain)
        if key not in self._columns:
            if self.strategy.compose == "inward" or not chain:
                found = tuple(self.carry(chain, self.basis(j)) for j in range(3))
            else:
                found = self._mixed(self._product(chain[:-1]), chain[-1])
            self._columns[key] = (found[0], found[1], found[2])
        return self._columns[key]

    def _key(self, factor: Factor) -> tuple[object, ...]:
        if isinstance(factor, Elementary):
            return factor.axis, self(factor.angle)
        return self.given(factor)

    def _mixed(self, before: tuple[int, int, int], last: Factor) -> tuple[int, ...]:
        """Columns of P E from those of P: the two that are not on the axis are mixed."""
        b = self.builder
        if not isinstance(last, Elementary):
            parts = [tuple(self.pick(c, i) for i in range(3)) for c in self.given(last)]
            return tuple(self.combination(weights, before) for weights in parts)
        angle = self(last.angle)
        sine, cosine = b.sin(angle), b.cos(angle)
        first, second = (last.axis + 1) % 3, (last.axis + 2) % 3
        mixed = list(before)
        pair = (before[first], before[second])
        mixed[first] = self.combination((cosine, sine), pair)
        mixed[second] = self.combination((b.negate(sine), cosine), pair)
        return tuple(mixed)

    def carry(self, chain: tuple[Factor, ...], vector: int) -> int:
        for factor in reversed(chain):
            vector = self.turn(factor, vector)
        return vector

    def turned(self, node: v.Rotated, chain: tuple[Factor, ...], inner: int) -> int:
        """A vector carried through a chain, step by step or by the product."""
        chain = self.chain(chain)
        usual = self.strategy.carry if len(chain) > 2 else "steps"
        if len(chain) < 2 or self.decide(node, usual, CARRIES) == "steps":
            return self.carry(chain, inner)
        parts = tuple(self.pick(inner, k) for k in range(3))
        return self.combination(parts, self._product(chain))
