"""Definitions printed out entry by entry, as a text-book has them, and single changes of prints.

Nothing here is taken from the audit: a change is made by walking the tree, by rules of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields, is_dataclass, replace
from functools import reduce
from typing import Any

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.explicit import Explicit
from armillary.algebra.functions import atan2, cos, sin, sqrt
from armillary.algebra.indexed import children
from armillary.algebra.rigid import Matrix
from armillary.algebra.rotation import RotationSymbol
from armillary.derivation.entries import rows_of
from armillary.derivation.quantity import Constant
from armillary.derivation.symbols import leaves
from armillary.mechanism.chain import Chain

LARGEST = 40  # operations of an entry that a text-book would still print
LONGEST = 20000  # nodes of a block with every name opened: SymPy takes minutes with more


class TooLong(Exception):
    """A text-book would not print this entry by entry."""


def printed_out(block: Any) -> Matrix | s.Scalar:
    """A block, entry by entry, in sums of products of sines and cosines.

    Raises:
        TooLong: for what is too long, or not made of these.
    """
    if _size(block, {}) > LONGEST:
        raise TooLong
    explicit, names = Explicit(), _names(block)
    rows = [[_read(_short(explicit(e)), names) for e in row] for row in rows_of(block)]
    return rows[0][0] if isinstance(block, s.Scalar) else Matrix(tuple(map(tuple, rows)))


def _size(node: object, known: dict[int, int]) -> int:
    if id(node) not in known:
        known[id(node)] = 1 + sum(_size(child, known) for child in children(node))
    return known[id(node)]


def _short(form: sympy.Expr) -> sympy.Expr:
    if form.has(sympy.Piecewise) or form.count_ops() > LARGEST:
        raise TooLong
    return form


def _names(block: Any) -> dict[str, s.Scalar]:
    names: dict[str, s.Scalar] = {}
    for leaf in leaves(block):
        if isinstance(leaf, v.VectorSymbol):
            names |= {f"{leaf.name}_{a}": v.component(leaf, k) for k, a in enumerate("xyz")}
        elif isinstance(leaf, RotationSymbol):
            at = [(i, j) for i in range(3) for j in range(3)]
            names |= {f"{leaf.name}_{i + 1}{j + 1}": leaf.entry(i, j) for i, j in at}
        else:
            names[leaf.name] = leaf
    return names


def _read(form: sympy.Expr, names: dict[str, s.Scalar]) -> s.Scalar:
    if form.is_number:
        return s.negate(s.number(-form)) if form.could_extract_minus_sign() else s.number(form)
    if form.is_Symbol:
        if form.name not in names:  # the result of an iteration, or one part of several
            raise TooLong
        return names[form.name]
    if form.is_Add:
        return reduce(s.add, (_read(part, names) for part in form.as_ordered_terms()))
    if form.is_Mul:
        if form.could_extract_minus_sign():
            return s.negate(_read(-form, names))
        top, below = form.as_numer_denom()
        if below != 1:
            return s.divide(_read(top, names), _read(below, names))
        return reduce(s.multiply, (_read(part, names) for part in form.as_ordered_factors()))
    if form.is_Pow:
        base, power = form.as_base_exp()
        if power == sympy.Rational(1, 2):
            return sqrt(_read(base, names))
        if power.is_Integer and power > 0:
            return _read(base, names) ** int(power)
        if power.is_negative:
            return s.divide(s.ONE, _read(base**-power, names))
    if isinstance(form, (sympy.sin, sympy.cos)):
        of = sin if isinstance(form, sympy.sin) else cos
        return of(_read(form.args[0], names))
    if isinstance(form, sympy.atan2):
        return atan2(_read(form.args[0], names), _read(form.args[1], names))
    raise TooLong


@dataclass(frozen=True, eq=False)
class Slip:
    """A print with one thing changed: what kind of thing, and in which entry (from 1).

    A product of joints that is printed with a slip stands in `product`.
    """

    kind: str
    words: str
    printed: Any
    place: tuple[int, int]
    product: Chain | None = None


def slips(printed: Any, symbols: list[s.Scalar]) -> list[Slip]:
    """Every single slip of sign, function or index in an entry of a print."""
    if isinstance(printed, Matrix):
        rows = printed.rows
        return [
            Slip(kind, words, Matrix(_with(rows, i, j, new)), (i + 1, j + 1))
            for i, row in enumerate(rows)
            for j, entry in enumerate(row)
            for kind, words, new in _slips(entry, symbols)
        ]
    if isinstance(printed, v.Components):
        return [
            Slip(kind, words, v.Components(tuple(_put(printed.components, i, new))), (i + 1, 1))
            for i, entry in enumerate(printed.components)
            for kind, words, new in _slips(entry, symbols)
        ]
    return [Slip(kind, words, new, (1, 1)) for kind, words, new in _slips(printed, symbols)]


def _slips(entry: s.Scalar, symbols: list[s.Scalar]) -> Iterator[tuple[str, str, s.Scalar]]:
    yield "sign", "the entry", s.negate(entry)
    for node, rebuild in _places(entry, lambda new: new):
        if isinstance(node, s.Add):
            yield "sign", "a left term", rebuild(s.add(s.negate(node.left), node.right))
            yield "sign", "a right term", rebuild(s.add(node.left, s.negate(node.right)))
        elif isinstance(node, s.Sine):
            yield "function", "cos for sin", rebuild(s.Cosine(node.argument))
        elif isinstance(node, s.Cosine):
            yield "function", "sin for cos", rebuild(s.Sine(node.argument))
        elif isinstance(node, s.Component):
            for index in range(3):
                if index != node.index:
                    yield (
                        "index",
                        f"{index} for {node.index}",
                        rebuild(v.component(node.vector, index)),
                    )
        elif isinstance(node, (s.Symbol, s.ScalarReference)) and not isinstance(node, Constant):
            for other in symbols:
                if other is not node and _unit(other) == _unit(node):
                    yield "index", f"{other.name} for {node.name}", rebuild(other)


def _unit(node: Any) -> Any:
    return getattr(node, "unit", None)


def _places(
    node: Any, rebuild: Callable[[Any], s.Scalar]
) -> Iterator[tuple[Any, Callable[[Any], s.Scalar]]]:
    """Every node of a tree, with a function that puts another in its place."""
    yield node, rebuild
    closed = (s.Symbol, v.VectorSymbol, s.ScalarReference, v.VectorReference, s.Component)
    if not is_dataclass(node) or isinstance(node, closed):
        return
    for f in fields(node):
        child = getattr(node, f.name)
        if isinstance(child, (s.Scalar, v.Vector)):

            def put(new: Any, name: str = f.name) -> s.Scalar:
                return rebuild(replace(node, **{name: new}))

            yield from _places(child, put)


def _put(parts: tuple[Any, ...], k: int, new: Any) -> tuple[Any, ...]:
    return (*parts[:k], new, *parts[k + 1 :])


def _with(rows: Any, i: int, j: int, new: s.Scalar) -> Any:
    return _put(rows, i, _put(rows[i], j, new))
