"""Copies of a printed expression that differ from it in one place, as misprints would have it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import singledispatchmethod
from typing import Any

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.derivative import Differentiator, partial_seed
from armillary.algebra.indexed import At, Total, at, indices
from armillary.algebra.rotation import Composed, Elementary, Rotation, RotationReference, factors
from armillary.derivation.units import RADIAN
from armillary.verify.audit.plain import plain
from armillary.verify.audit.pool import Pool, is_name
from armillary.verify.audit.terms import (
    factors_of,
    multiplied,
    summed,
    terms_of,
    vector_terms,
    vectors_summed,
)

# What a reader would think of first.
RANKS = {
    "sign": 0,
    "function": 1,
    "index": 2,
    "lost dot": 3,
    "lost d": 3,
    "dot too many": 3,
    "axis": 2,
    "order of factors": 4,
    "half turn": 4,
    "transposition": 4,
    "term": 5,
    "lost term": 5,
    "factor": 6,
    "number": 7,
}
LOST = 7  # a factor or a term that is not there any more
FAR = 8  # another symbol altogether
PRODUCT = 9  # a term of two factors that is not there any more


@dataclass(frozen=True)
class Change:
    """One copy of an expression.

    Attributes:
        words: the change from the print to the copy: "cos for sin of omega".
        rank: how far-fetched it is; see `RANKS`.
        node: the copy.
    """

    kind: str
    words: str
    rank: int
    node: Any


Rebuild = Callable[[Any], Any]


class Changes:
    """Enumerates the changes of expressions, with the symbols of one pool."""

    def __init__(self, pool: Pool) -> None:
        self.pool = pool

    def whole(self, node: Any) -> list[Change]:
        """All single changes of an entry or block, the likely ones first."""
        if isinstance(node, s.Scalar):
            made = list(self.sum(node, top=True))
        elif isinstance(node, v.Vector):
            made = list(self.vector_sum(node, top=True))
        else:
            made = list(self.inside(node))
        return sorted(made, key=lambda change: change.rank)

    # -- sums ---------------------------------------------------------------------------------

    def sum(self, node: s.Scalar, top: bool = False) -> Iterator[Change]:
        """Changes of the terms; `top` also turns the sign of a lone term, and of the whole."""
        terms = terms_of(node)
        if len(terms) > 1 and top:
            yield _change("sign", "the other sign of the whole", s.negate(node))
        for k, (negative, term) in enumerate(terms):

            def put(new: s.Scalar, k: int = k, negative: bool = negative) -> s.Scalar:
                return summed([*terms[:k], (negative, new), *terms[k + 1 :]])

            if len(terms) > 1 or top:
                flipped = summed([*terms[:k], (not negative, term), *terms[k + 1 :]])
                yield _change("sign", f"{_sign(not negative)} for {_sign(negative)} before "
                              f"{plain(term)}", flipped)  # fmt: skip
            if len(terms) > 1:
                without = summed([*terms[:k], *terms[k + 1 :]])
                yield _change("term", f"the term {plain(term)} left out", without)
            if (len(terms) > 1 or top) and not isinstance(term, s.Number):
                yield _change("factor", f"twice {plain(term)}", put(s.multiply(s.number(2), term)))
                for lost in self.pool.factors():
                    more = put(s.multiply(term, lost))
                    yield Change("factor", f"{plain(term)} times {plain(lost)}", LOST, more)
                    less = put(s.divide(term, lost))
                    yield Change("factor", f"{plain(term)} divided by {plain(lost)}", LOST, less)
                for count in self.pool.numbers:
                    if s.is_zero(count) or s.is_one(count):
                        continue
                    less = put(s.divide(term, count))
                    yield Change("factor", f"{plain(term)} divided by {plain(count)}", LOST, less)
            yield from _carried(self.product(term), put)
        if top:
            yield from self._lost_terms(node)

    def _lost_terms(self, node: s.Scalar) -> Iterator[Change]:
        unit = self.pool.unit(node)
        lost = [(name, LOST) for name in self.pool.met]
        if not isinstance(node, s.Number):  # nothing was lost beside a printed 0
            lost += [(product, PRODUCT) for product in self.pool.products()]
        for term, rank in lost:
            if unit is None or self.pool.unit(term) == unit:
                for done, more in (("added", term), ("subtracted", s.negate(term))):
                    yield Change("lost term", f"{plain(term)} {done}", rank, s.add(node, more))

    def product(self, node: s.Scalar) -> Iterator[Change]:
        """Changes of the factors of a term."""
        if not isinstance(node, s.Multiply):
            yield from self.inside(node)
            return
        parts = factors_of(node)
        for k, part in enumerate(parts):

            def put(new: s.Scalar, k: int = k) -> s.Scalar:
                return multiplied([*parts[:k], new, *parts[k + 1 :]])

            without = multiplied([*parts[:k], *parts[k + 1 :]])
            yield _change("factor", f"the factor {plain(part)} left out", without)
            if not isinstance(part, s.Number):
                twice = put(s.multiply(part, part))
                yield _change("factor", f"the square of {plain(part)}", twice)
            yield from _carried(self.inside(part), put)

    # -- single nodes -------------------------------------------------------------------------

    def name(self, node: Any) -> Iterator[Change]:
        """Other symbols in place of one."""
        for other in self.pool.instead(node):
            rank = RANKS[other.kind] if other.near else FAR
            yield Change(other.kind, f"{plain(other.node)} for {plain(node)}", rank, other.node)

    @singledispatchmethod
    def inside(self, node: Any) -> Iterator[Change]:
        """Changes of one node that is neither a sum nor a product."""
        if is_name(node):
            yield from self.name(node)

    @inside.register
    def _(self, node: s.Add | s.Multiply | s.Negate) -> Iterator[Change]:
        yield from self.sum(node)

    @inside.register
    def _(self, node: s.Number) -> Iterator[Change]:
        for other in self.pool.numbers:
            if other.value != node.value:
                yield _change("number", f"{plain(other)} for {plain(node)}", other)

    @inside.register
    def _(self, node: s.Divide) -> Iterator[Change]:
        top, below = node.numerator, node.denominator
        yield _change("factor", f"the divisor {plain(below)} left out", top)
        yield _change("factor", f"times {plain(below)} for divided by it", s.multiply(top, below))
        if isinstance(below, s.Symbol):
            words = f"the derivative of {plain(top)} by {plain(below)} for their quotient"
            yield _change("lost d", words, Differentiator(partial_seed(below)).scalar(top))
        yield from _carried(self.inside(top), lambda new: s.divide(new, below))
        yield from _carried(self.inside(below), lambda new: s.divide(top, new))

    @inside.register
    def _(self, node: s.SquareRoot) -> Iterator[Change]:
        inner = node.argument
        yield _change("function", "the root left out", inner)
        if isinstance(inner, s.Dot) and isinstance(inner.left, v.Cross):
            cross = inner.left
            if inner.right is cross:
                words = f"the dot product for the cross product of {_both(cross)}"
                yield _change("function", words, v.dot(cross.left, cross.right))
        yield from _carried(self.inside(inner), s.SquareRoot)

    @inside.register
    def _(self, node: s.Sine) -> Iterator[Change]:
        inner = node.argument
        yield _change("function", f"cos for sin of {plain(inner)}", s.Cosine(inner))
        for other in self._angles_beside(inner):
            words = f"cos of {plain(other)} for sin of {plain(inner)}"
            yield Change("function", words, FAR, s.Cosine(other))
        yield from _carried(self.inside(inner), s.Sine)

    @inside.register
    def _(self, node: s.Cosine) -> Iterator[Change]:
        inner = node.argument
        yield _change("function", f"sin for cos of {plain(inner)}", s.Sine(inner))
        for other in self._angles_beside(inner):
            words = f"sin of {plain(other)} for cos of {plain(inner)}"
            yield Change("function", words, FAR, s.Sine(other))
        yield from _carried(self.inside(inner), s.Cosine)

    def _angles_beside(self, inner: s.Scalar) -> list[s.Scalar]:
        """The angles that were met, but for one: a slip of the eye takes one term's for another."""
        return [a for a in self.pool.met if a is not inner and self.pool.unit(a) == RADIAN]

    @inside.register
    def _(self, node: s.ArcTangent) -> Iterator[Change]:
        y, x = node.y, node.x
        yield _change("function", "the arguments of atan2 exchanged", s.ArcTangent(x, y))
        yield from _carried(self.sum(y, top=True), lambda new: s.ArcTangent(new, x))
        yield from _carried(self.sum(x, top=True), lambda new: s.ArcTangent(y, new))

    @inside.register
    def _(self, node: s.ArcSine) -> Iterator[Change]:
        yield _change("function", "arccos for arcsin", s.ArcCosine(node.argument))
        yield from _carried(self.sum(node.argument, top=True), s.ArcSine)

    @inside.register
    def _(self, node: s.ArcCosine) -> Iterator[Change]:
        yield _change("function", "arcsin for arccos", s.ArcSine(node.argument))
        yield from _carried(self.sum(node.argument, top=True), s.ArcCosine)

    @inside.register
    def _(self, node: At) -> Iterator[Change]:
        yield from _carried(self.inside(node.term), lambda new: at(new, node.over, node.place))
        for k in range(node.over.size):
            if k != node.place:
                other = at(node.term, node.over, k)
                yield _change("index", f"{plain(other)} for {plain(node)}", other)

    @inside.register
    def _(self, node: Total) -> Iterator[Change]:
        for change in self.sum(node.term, top=True):
            if node.over in indices(change.node):
                new = Total(change.node, node.over)
                yield Change(change.kind, change.words, change.rank, new)

    @inside.register
    def _(self, node: s.Absolute) -> Iterator[Change]:
        yield _change("function", "the absolute value left out", node.argument)
        yield from _carried(self.inside(node.argument), s.Absolute)

    @inside.register
    def _(self, node: s.Select) -> Iterator[Change]:
        c, then, otherwise = node.condition, node.then, node.otherwise
        yield _change("function", "the two cases exchanged", s.Select(c, otherwise, then))
        yield from _carried(self.sum(then, top=True), lambda new: s.Select(c, new, otherwise))
        yield from _carried(self.sum(otherwise, top=True), lambda new: s.Select(c, then, new))

    @inside.register
    def _(self, node: s.Component) -> Iterator[Change]:
        if is_name(node.vector):
            yield from self.name(node)
        else:
            for index in range(3):
                if index != node.index:
                    other = v.component(node.vector, index)
                    yield _change("index", f"{plain(other)} for {plain(node)}", other)
            yield from _carried(
                self.vector_sum(node.vector, top=True), lambda new: v.component(new, node.index)
            )

    @inside.register
    def _(self, node: s.Dot) -> Iterator[Change]:
        left, right = node.left, node.right
        yield from _carried(self.inside(left), lambda new: v.dot(new, right))
        yield from _carried(self.inside(right), lambda new: v.dot(left, new))

    # -- vectors ------------------------------------------------------------------------------

    def vector_sum(self, node: v.Vector, top: bool = False) -> Iterator[Change]:
        """Changes of a vector's terms, as of a scalar's."""
        terms = vector_terms(node)
        for k, (negative, term) in enumerate(terms):

            def put(new: v.Vector, k: int = k, negative: bool = negative) -> v.Vector:
                return vectors_summed([*terms[:k], (negative, new), *terms[k + 1 :]])

            if len(terms) > 1 or top:
                flipped = vectors_summed([*terms[:k], (not negative, term), *terms[k + 1 :]])
                yield _change("sign", f"{_sign(not negative)} for {_sign(negative)} before "
                              f"{plain(term)}", flipped)  # fmt: skip
            if len(terms) > 1:
                without = vectors_summed([*terms[:k], *terms[k + 1 :]])
                yield _change("term", f"the term {plain(term)} left out", without)
            yield from _carried(self.inside(term), put)

    @inside.register
    def _(self, node: v.VectorSum | v.VectorNegate) -> Iterator[Change]:
        yield from self.vector_sum(node)

    @inside.register
    def _(self, node: v.Components) -> Iterator[Change]:
        parts = node.components
        for k in range(3):
            for change in self.sum(parts[k], top=True):
                x, y, z = (change.node if i == k else parts[i] for i in range(3))
                yield Change(change.kind, change.words, change.rank, v.Components((x, y, z)))

    @inside.register
    def _(self, node: v.Scaled) -> Iterator[Change]:
        factor, vector = node.factor, node.vector
        yield _change("factor", f"the factor {plain(factor)} left out", vector)
        yield from _carried(self.inside(factor), lambda new: v.scale(new, vector))
        yield from _carried(self.inside(vector), lambda new: v.scale(factor, new))

    @inside.register
    def _(self, node: v.Cross) -> Iterator[Change]:
        left, right = node.left, node.right
        yield from _carried(self.inside(left), lambda new: v.cross(new, right))
        yield from _carried(self.inside(right), lambda new: v.cross(left, new))

    @inside.register
    def _(self, node: v.Unit) -> Iterator[Change]:
        yield _change("function", "the division by the length left out", node.vector)
        yield from _carried(self.inside(node.vector), v.Unit)

    @inside.register
    def _(self, node: v.Rotated) -> Iterator[Change]:
        rotation, vector = node.rotation, node.vector
        yield from _carried(self.inside(rotation), lambda new: v.Rotated(new, vector))
        yield from _carried(self.inside(vector), lambda new: v.Rotated(rotation, new))

    # -- rotations ----------------------------------------------------------------------------

    @inside.register
    def _(self, node: Rotation) -> Iterator[Change]:
        parts = factors(node)
        if len(parts) > 1 or isinstance(node, RotationReference):
            yield _change("transposition", f"the transpose of {plain(node)}", node.transpose())
        if isinstance(node, RotationReference):
            return
        for k, part in enumerate(parts):

            def put(new: Any, k: int = k) -> Rotation:
                return Composed((*parts[:k], *factors(new), *parts[k + 1 :]))

            if isinstance(part, Elementary):
                yield from _carried(self.turn(part), put)
            if k + 1 < len(parts):
                swapped = (*parts[:k], parts[k + 1], part, *parts[k + 2 :])
                words = f"{plain(parts[k + 1])} before {plain(part)}"
                yield _change("order of factors", words, Composed(swapped))

    def turn(self, part: Elementary) -> Iterator[Change]:
        """Changes of one elementary rotation."""
        yield _change(
            "sign",
            f"{plain(part)} turning the other way",
            Elementary(part.axis, s.negate(part.angle)),
        )
        for axis in range(3):
            if axis != part.axis:
                words = f"axis {v.AXIS_NAMES[axis]} for {v.AXIS_NAMES[part.axis]} of {plain(part)}"
                yield _change("axis", words, Elementary(axis, part.angle))
        further = Elementary(part.axis, s.add(part.angle, s.PI))
        yield _change("half turn", f"{plain(part)} turning half a turn further", further)
        yield from _carried(self.inside(part.angle), lambda new: Elementary(part.axis, new))


def _both(cross: v.Cross) -> str:
    return f"{plain(cross.left)} and {plain(cross.right)}"


def _sign(negative: bool) -> str:
    return "minus" if negative else "plus"


def _change(kind: str, words: str, node: Any) -> Change:
    return Change(kind, words, RANKS[kind], node)


def _carried(changes: Iterator[Change], rebuild: Rebuild) -> Iterator[Change]:
    """Changes of a part, as changes of what it is part of."""
    for change in changes:
        try:
            yield Change(change.kind, change.words, change.rank, rebuild(change.node))
        except ZeroDivisionError:
            continue  # the part was a divisor, and the copy is 0
