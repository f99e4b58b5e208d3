"""How a lowering normalises vectors, and takes directions from them."""

from __future__ import annotations

import sympy

from armillary.algebra import vector as v
from armillary.algebra.direction import normalised_in
from armillary.algebra.rotation import Factor, factors
from armillary.program.carrying import Carrying
from armillary.program.program import Op
from armillary.program.strategy import NORMALISED, Local, Strategy


class Directing(Carrying):
    """Instructions for unit vectors, each turned before it is normalised, or after."""

    def __init__(self, strategy: Strategy, local: Local) -> None:
        super().__init__(strategy, local)
        self._unscaled: dict[v.Vector, int] = {}
        self._squares: dict[v.Unit, int] = {}

    def normalised(self, root: v.Unit, vector: int) -> int:
        """A turned copy of what `root` normalises, divided by the length that all copies have."""
        b = self.builder
        length = b.sqrt(self._squares[root])
        return self.scaled(b.divide(b.constant(sympy.Integer(1)), length), vector)

    def is_normalised_last(self, root: v.Unit) -> bool:
        """Whether the turned copies of a unit vector are turned first and then normalised."""
        return self.decide(root, "first", NORMALISED) == "last"

    def unscaled(self, node: v.Vector) -> int:
        """A vector along `node` that is not normalised."""
        if node not in self._unscaled:
            self._unscaled[node] = self._along(node)
        return self._unscaled[node]

    def _along(self, node: v.Vector) -> int:
        if normalised_in(node) is None:
            return self(node)
        if isinstance(node, v.Unit):
            return self(node.vector)  # normalised in itself, if it is: _squares is of this one
        if isinstance(node, v.Rotated):
            chain, inner = flattened(node)
            return self.turned(node, chain, self.unscaled(inner))
        if isinstance(node, v.VectorNegate):
            return self.builder.emit(Op.NEGATE_VECTOR, self.unscaled(node.argument))
        assert isinstance(node, v.VectorReference)
        return self.unscaled(node.expression)

    def direction(self, node: v.Vector) -> tuple[int, int, int, int]:
        """Components of a vector along `node`, and its horizontal length.

        Any length will do, so nothing is normalised for the sake of a direction.
        """
        b, root = self.builder, normalised_in(node)
        plain = root is not None and (opened(node) is root or self.is_normalised_last(root))
        vector = self.unscaled(node) if plain else self(node)
        x, y, z = (self.pick(vector, k) for k in range(3))
        return x, y, z, b.sqrt(b.add(b.multiply(x, x), b.multiply(y, y)))


def opened(node: v.Vector) -> v.Vector:
    """The vector that a name stands for."""
    while isinstance(node, v.VectorReference):
        node = node.expression
    return node


def flattened(node: v.Rotated) -> tuple[tuple[Factor, ...], v.Vector]:
    """Nested rotations as one chain; a named vector inside stays a value of its own."""
    chain, inner = factors(node.rotation), node.vector
    while isinstance(inner, v.Rotated):
        chain, inner = chain + factors(inner.rotation), inner.vector
    return chain, inner
