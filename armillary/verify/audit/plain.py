"""Expressions in plain words, for the sentences of a finding."""

from __future__ import annotations

from functools import singledispatch
from typing import Any

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.direction import OfDirection
from armillary.algebra.indexed import AnyOf, At, Total, VectorAt, VectorTotal
from armillary.algebra.rotation import Elementary, Rotation, RotationReference, factors

_SUM, _SIGNED, _PRODUCT, _ATOM = range(4)
_FRACTION = 100  # the least denominator that is not told as a fraction
Text = tuple[str, int]


def plain(node: Any) -> str:
    """An expression as one would type it: `sin(gamma) cos(upsilon)`."""
    return _text(node)[0]


def _inside(node: Any, level: int) -> str:
    text, found = _text(node)
    return text if found >= level else f"({text})"


@singledispatch
def _text(node: Any) -> Text:
    return type(node).__name__, _ATOM


@_text.register
def _(node: s.Number) -> Text:
    text = _decimal(node.value) or str(node.value)
    return text, _ATOM if text.replace(".", "").isalnum() else _SUM


def _decimal(value: sympy.Expr) -> str:
    """A fraction that papers write with a point; empty for any other number."""
    if not isinstance(value, sympy.Rational) or value.q < _FRACTION:
        return ""
    text = str(sympy.Float(value, 15).round(12)).rstrip("0")
    return text if sympy.Rational(text) == value else ""


@_text.register
def _(node: s.Symbol | v.VectorSymbol | RotationReference) -> Text:
    return node.name, _ATOM


@_text.register
def _(node: s.ScalarReference | v.VectorReference | s.ConditionReference) -> Text:
    return node.name, _ATOM


@_text.register
def _(node: s.Add | v.VectorSum) -> Text:
    second, level = _text(node.right)
    if second.startswith("-") and level is not _SUM:
        return f"{plain(node.left)} - {second[1:]}", _SUM
    return f"{plain(node.left)} + {second}", _SUM


@_text.register
def _(node: s.Negate | v.VectorNegate) -> Text:
    return f"-{_inside(node.argument, _PRODUCT)}", _SIGNED


@_text.register
def _(node: s.Multiply) -> Text:
    return f"{_inside(node.left, _PRODUCT)} {_inside(node.right, _PRODUCT)}", _PRODUCT


@_text.register
def _(node: s.Divide) -> Text:
    return f"{_inside(node.numerator, _PRODUCT)} / {_inside(node.denominator, _ATOM)}", _PRODUCT


@_text.register
def _(node: s.SquareRoot) -> Text:
    return f"sqrt({plain(node.argument)})", _ATOM


@_text.register
def _(node: s.Sine) -> Text:
    return f"sin({plain(node.argument)})", _ATOM


@_text.register
def _(node: s.Cosine) -> Text:
    return f"cos({plain(node.argument)})", _ATOM


@_text.register
def _(node: s.ArcTangent) -> Text:
    return f"atan2({plain(node.y)}, {plain(node.x)})", _ATOM


@_text.register
def _(node: s.ArcSine) -> Text:
    return f"arcsin({plain(node.argument)})", _ATOM


@_text.register
def _(node: s.ArcCosine) -> Text:
    return f"arccos({plain(node.argument)})", _ATOM


@_text.register
def _(node: At | VectorAt) -> Text:
    return f"{_inside(node.term, _ATOM)}_{node.place + 1}", _ATOM


@_text.register
def _(node: Total | VectorTotal | AnyOf) -> Text:
    word = "any" if isinstance(node, AnyOf) else "sum"
    return f"{word}({plain(node.term)}, {node.over.name})", _ATOM


@_text.register
def _(node: s.Absolute) -> Text:
    return f"|{plain(node.argument)}|", _ATOM


@_text.register
def _(node: OfDirection) -> Text:
    return f"{type(node).__name__.lower()}({plain(node.vector)})", _ATOM


@_text.register
def _(node: s.Select) -> Text:
    then, otherwise = plain(node.then), plain(node.otherwise)
    return f"({then} if {plain(node.condition)} else {otherwise})", _ATOM


@_text.register
def _(node: s.Less) -> Text:
    return f"{plain(node.left)} < {plain(node.right)}", _SUM


@_text.register
def _(node: s.Both) -> Text:
    return f"{plain(node.left)} and {plain(node.right)}", _SUM


@_text.register
def _(node: s.Not) -> Text:
    return f"not {_inside(node.argument, _ATOM)}", _SUM


@_text.register
def _(node: s.Component) -> Text:
    return f"{_inside(node.vector, _ATOM)}_{v.AXIS_NAMES[node.index]}", _ATOM


@_text.register
def _(node: s.Dot) -> Text:
    return f"{_inside(node.left, _PRODUCT)} . {_inside(node.right, _PRODUCT)}", _SIGNED


@_text.register
def _(node: v.Components) -> Text:
    return f"({', '.join(map(plain, node.components))})", _ATOM


@_text.register
def _(node: v.Basis) -> Text:
    return f"e_{v.AXIS_NAMES[node.axis]}", _ATOM


@_text.register
def _(node: v.Scaled) -> Text:
    return f"{_inside(node.factor, _PRODUCT)} {_inside(node.vector, _PRODUCT)}", _PRODUCT


@_text.register
def _(node: v.Cross) -> Text:
    return f"{_inside(node.left, _ATOM)} x {_inside(node.right, _ATOM)}", _SIGNED


@_text.register
def _(node: v.Unit) -> Text:
    return f"unit({plain(node.vector)})", _ATOM


@_text.register
def _(node: v.Rotated) -> Text:
    return f"{_inside(node.rotation, _PRODUCT)} {_inside(node.vector, _ATOM)}", _PRODUCT


@_text.register
def _(node: v.Choice) -> Text:
    return _text(node.nested)


@_text.register
def _(node: Elementary) -> Text:
    return f"R{v.AXIS_NAMES[node.axis]}({plain(node.angle)})", _ATOM


@_text.register
def _(node: Rotation) -> Text:
    inner = factors(node)
    if inner == (node,):
        return str(getattr(node, "name", "R")), _ATOM
    return " ".join(map(plain, inner)) or "I", _PRODUCT
