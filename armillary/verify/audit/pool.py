"""What may stand in place of a symbol: its neighbours first, then whatever has the same unit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.indexed import indices
from armillary.derivation.paper import Paper
from armillary.derivation.quantity import Constant, Quantity
from armillary.derivation.symbols import leaves
from armillary.derivation.units import RADIAN, Unit, UnitError, UnitOf
from armillary.verify.audit.plain import plain
from armillary.verify.audit.walking import parts

REFERENCES = (s.ScalarReference, v.VectorReference)


@dataclass(frozen=True)
class Instead:
    """Something that could have been meant; `near` is a neighbour by name or by index."""

    node: Any
    kind: str
    near: bool


class Pool:
    """The scalars and vectors that one print could have meant, in the order met.

    What the claim is named is not among them: to print the claim itself mends nothing.

    Args:
        printed: the print.
        claims: what is derived.
        paper: its symbols and shorthands come after those that were met.
    """

    def __init__(self, printed: object, claims: object, paper: Paper | None = None) -> None:
        self._units = UnitOf()
        met = (printed, claims)
        found: list[Any] = [n for n in parts(printed) if isinstance(n, REFERENCES)]
        found += [q for q in leaves(met) if not isinstance(q, Constant)]
        if paper is not None:
            found += [*paper.quantities.values()]
            found += [d.value for d in paper.definitions.values()]
        found += [rate for rate in map(_rate_of, found) if rate is not None]
        # A print that stands for one part says nothing of parts.
        opened = indices(met)
        found = [node for node in found if indices(node) <= opened]
        once = {id(node): node for node in found}
        near = {id(node) for node in leaves(met)} | {id(n) for n in parts(printed)}
        self.met = [n for n in once.values() if isinstance(n, s.Scalar) and id(n) in near]
        self.numbers = _numbers(met)
        self.scalars: list[s.Scalar] = [n for n in once.values() if isinstance(n, s.Scalar)]
        self.vectors: list[v.Vector] = [n for n in once.values() if isinstance(n, v.Vector)]

    def factors(self) -> Iterator[s.Scalar]:
        """What a term may have lost: a name that was met, or the sine or cosine of an angle."""
        for name in self.met:
            if self.unit(name) == RADIAN:
                yield s.Cosine(name)
                yield s.Sine(name)
            yield name

    def products(self) -> Iterator[s.Scalar]:
        """What a sum may have lost: two factors."""
        found = list(self.factors())
        for k, first in enumerate(found):
            for second in found[k + 1 :]:
                yield s.multiply(first, second)

    def instead(self, node: Any) -> Iterator[Instead]:
        """What may stand for a symbol, a shorthand or a component; neighbours first."""
        yield from _dotted(node, self.scalars)
        candidates = list(self._candidates(node))
        for near in (True, False):
            for other, is_near in candidates:
                if is_near is near:
                    yield Instead(other, "index", near)

    def _candidates(self, node: Any) -> Iterator[tuple[Any, bool]]:
        if isinstance(node, s.Component):
            for index in range(3):
                if index != node.index:
                    yield v.component(node.vector, index), True
            for vector in self.vectors:
                if vector is not node.vector and self._fits(vector, node.vector):
                    yield v.component(vector, node.index), True
        others = self.vectors if isinstance(node, v.Vector) else self.scalars
        for other in others:
            if other is not node and self._fits(other, node):
                yield other, _stem(other) == _stem(node)

    def _fits(self, other: Any, node: Any) -> bool:
        return self.unit(other) == self.unit(node)

    def unit(self, node: Any) -> Unit | None:
        """Its unit; None for zero and for what has none."""
        try:
            return self._units(node)
        except (UnitError, TypeError):
            return None


def is_name(node: object) -> bool:
    """Whether a print shows a node as one symbol."""
    return isinstance(node, (s.Symbol, s.Component, v.VectorSymbol, *REFERENCES))


def _dotted(node: Any, scalars: list[s.Scalar]) -> Iterator[Instead]:
    """A symbol with its dot, or without it."""
    rate = _rate_of(node)
    if rate is not None:
        yield Instead(rate, "lost dot", True)
    for other in scalars:
        if _rate_of(other) is node:
            yield Instead(other, "dot too many", True)


def _rate_of(node: Any) -> Any:
    return node.known_rate.get("rate") if isinstance(node, Quantity) else None


def _stem(node: Any) -> str:
    return plain(node).partition("_")[0]


def _numbers(blocks: object) -> list[s.Number]:
    """The numbers below an expression, names opened, each value once."""
    found: dict[Any, s.Number] = {}
    for node in parts(blocks, closed=(s.Symbol, v.VectorSymbol)):
        if isinstance(node, (s.Number, Constant)):
            found.setdefault(node.value, s.Number(node.value))
    return list(found.values())
