"""Expressions that run over like parts: sums, single parts, and which indices are left open."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, overload

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.index import Index
from armillary.algebra.misuse import MisuseError, told

if TYPE_CHECKING:
    import sympy


@dataclass(frozen=True, eq=False, repr=False)
class Table(s.Symbol):
    """A named number for each part, exact."""

    values: tuple[sympy.Expr, ...]
    per: Index


@dataclass(frozen=True, eq=False, repr=False)
class Total(s.Scalar):
    """The sum of a scalar over all parts."""

    term: s.Scalar
    over: Index


@dataclass(frozen=True, eq=False, repr=False)
class VectorTotal(v.Vector):
    """The sum of a vector over all parts."""

    term: v.Vector
    over: Index


@dataclass(frozen=True, eq=False, repr=False)
class At(s.Scalar):
    """A scalar at one part."""

    term: s.Scalar
    over: Index
    place: int


@dataclass(frozen=True, eq=False, repr=False)
class VectorAt(v.Vector):
    """A vector at one part."""

    term: v.Vector
    over: Index
    place: int


@dataclass(frozen=True, eq=False, repr=False)
class AnyOf(s.Condition):
    """Whether a condition holds at some part."""

    term: s.Condition
    over: Index


@dataclass(frozen=True, eq=False, repr=False)
class OneLike(s.Scalar):
    """The number 1 in the unit of another scalar: what stands in for a divisor that is 0."""

    like: s.Scalar


Closing = (Total, VectorTotal, At, VectorAt, AnyOf)


@overload
def total(term: s.Scalar, over: Index) -> s.Scalar: ...
@overload
def total(term: v.Vector, over: Index) -> v.Vector: ...
def total(term: s.Scalar | v.Vector, over: Index) -> s.Scalar | v.Vector:
    """The sum over all parts of an index."""
    _runs_over(term, over, "total")
    return VectorTotal(term, over) if isinstance(term, v.Vector) else Total(term, over)


@overload
def at(term: s.Scalar, over: Index, place: int) -> s.Scalar: ...
@overload
def at(term: v.Vector, over: Index, place: int) -> v.Vector: ...
def at(term: s.Scalar | v.Vector, over: Index, place: int) -> s.Scalar | v.Vector:
    """The value at one part; parts count from 0."""
    if not 0 <= place < over.size:
        raise MisuseError(
            f"{over.name} has no part {told(place)}", f"its parts count from 0 to {over.size - 1}"
        )
    if over not in indices(term):
        return term
    return VectorAt(term, over, place) if isinstance(term, v.Vector) else At(term, over, place)


def any_of(condition: s.Condition, over: Index) -> s.Condition:
    """Whether a condition holds at some part of an index."""
    _runs_over(condition, over, "any_of")
    return AnyOf(condition, over)


def one_like(like: s.Scalar) -> s.Scalar:
    """The number 1 in the unit of `like`, for a `where` that keeps a divisor from being 0."""
    return OneLike(like)


def _runs_over(term: object, over: Index, word: str) -> None:
    if over not in indices(term):
        raise MisuseError(
            f"{word} runs over {over.name}, which its term does not depend on",
            f"give it a term made of quantities declared with per={over.name}, or leave it out",
        )


def indices(expression: object) -> frozenset[Index]:
    """The indices that an expression is left open in: it stands for a value at each part."""
    known: dict[int, frozenset[Index]] = {}
    stack = [expression]
    held: list[object] = []  # a node that is held keeps its id
    while stack:
        node = stack[-1]
        waiting = [c for c in children(node) if id(c) not in known]
        if id(node) in known or not waiting:
            stack.pop()
            held.append(node)
            known.setdefault(id(node), _open(node, known))
        else:
            stack.extend(waiting)
    return known[id(expression)]


def _open(node: object, known: dict[int, frozenset[Index]]) -> frozenset[Index]:
    per = getattr(node, "per", None)
    if isinstance(per, Index):
        return frozenset({per})
    inner = frozenset[Index]().union(*(known[id(c)] for c in children(node)))
    return inner - {node.over} if isinstance(node, Closing) else inner


def is_leaf(node: object) -> bool:
    """Whether a node is a symbol, a quantity or a table: nothing stands below it."""
    return isinstance(node, (s.Symbol, v.VectorSymbol)) or hasattr(node, "facts")


def children(node: object) -> list[object]:
    """The expressions that an expression is made of; a symbol has none."""
    if isinstance(node, (tuple, list)):
        return list(_expressions(node))
    if is_leaf(node):
        return []
    if hasattr(node, "__dataclass_fields__") and not isinstance(node, Index):
        return list(_expressions(getattr(node, f.name) for f in fields(node)))  # type: ignore[arg-type]
    return []


def _expressions(parts: Iterable[object]) -> Iterator[object]:
    for part in parts:
        if isinstance(part, tuple) or (
            hasattr(part, "__dataclass_fields__") and not isinstance(part, Index)
        ):
            yield part
