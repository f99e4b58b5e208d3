"""Small changes of a derivation's source, of the kinds that slip into formulas by hand.

A change is made where mathematics is written: not in names, reasons, ranges, pictures, and not in
identities, which are themselves checks.
"""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterator
from dataclasses import dataclass

SIGN, FUNCTION, ORDER, TERM = "flipped sign", "sin for cos", "swapped factors", "dropped term"
# Calls that state no formula, and arguments that hold none.
_SILENT_CALLS = {
    "identity", "picture", "assume", "angle", "length", "scalar", "vector_quantity", "unit_vector",
    "time", "constant", "rotation_input", "Derivation", "use", "quantity", "rate",
}  # fmt: skip
_SILENT_KEYWORDS = {
    "because", "meaning", "latex", "printed", "caption", "at", "sun", "summary", "limits", "range",
    "inputs", "unit", "frame", "foot", "rate", "kind", "name", "drawn",
}  # fmt: skip
_CHAINED = {"rotate", "translate"}
_OTHER = {"sin": "cos", "cos": "sin"}


@dataclass(frozen=True)
class Mutant:
    """One change of one file.

    Attributes:
        kind: what was done, one of the four.
        line: line of the change, from 1.
        before: the expression as written.
        after: the expression as changed.
        source: the whole file after the change.
    """

    kind: str
    line: int
    before: str
    after: str
    source: str


Change = tuple[str, ast.expr]


def mutants(source: str) -> Iterator[Mutant]:
    """Every change of one file, in the order of its lines."""
    tree = ast.parse(source)
    for place in sorted(_places(tree), key=lambda p: (p.lineno, p.col_offset, -_length(p))):
        for kind, new in _changes(place):
            before = ast.unparse(place)
            after = ast.unparse(ast.fix_missing_locations(new))
            if before != after:
                changed = _replaced(tree, place, new)
                yield Mutant(kind, place.lineno, before, after, ast.unparse(changed))


def _length(node: ast.expr) -> int:
    return len(ast.unparse(node))


def _places(node: ast.AST) -> Iterator[ast.expr]:
    """Expressions that state mathematics."""
    if isinstance(node, ast.Call) and _called(node) in _SILENT_CALLS:
        # A method of a quantity's parent, as in d.parameter.length(...): nothing below counts.
        return
    if isinstance(node, ast.expr):
        yield node
    for field, value in ast.iter_fields(node):
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.keyword) and child.arg in _SILENT_KEYWORDS:
                continue
            if field in ("annotation", "returns", "decorator_list", "defaults", "slice"):
                continue
            if isinstance(child, ast.AST):
                yield from _places(child)


def _called(node: ast.Call) -> str:
    function = node.func
    return function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")


def _changes(node: ast.expr) -> Iterator[Change]:
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        yield SIGN, node.operand
    elif isinstance(node, ast.BinOp):
        yield from _of_operator(node)
    elif isinstance(node, ast.Call):
        yield from _of_call(node)


def _of_operator(node: ast.BinOp) -> Iterator[Change]:
    if _is_text(node):
        return
    if isinstance(node.op, (ast.Add, ast.Sub)):
        other: ast.operator = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
        yield SIGN, ast.BinOp(node.left, other, node.right)
        yield TERM, node.left
        yield TERM, node.right
    elif isinstance(node.op, (ast.MatMult, ast.Div)):
        yield ORDER, ast.BinOp(node.right, node.op, node.left)


def _is_text(node: ast.BinOp) -> bool:
    return any(
        isinstance(n, ast.JoinedStr) or (isinstance(n, ast.Constant) and isinstance(n.value, str))
        for n in (node.left, node.right)
    )


def _of_call(node: ast.Call) -> Iterator[Change]:
    name = _called(node)
    if isinstance(node.func, ast.Name):
        if name in _OTHER:
            yield FUNCTION, _with(node, func=ast.Name(_OTHER[name], ast.Load()))
        if name in ("atan2", "atan2_or_zero") and len(node.args) >= 2:
            swapped = [node.args[1], node.args[0], *node.args[2:]]
            yield ORDER, _with(node, args=swapped)
    elif isinstance(node.func, ast.Attribute):
        if name in _CHAINED:
            yield from _of_step(node, node.func)
        if name == "cross" and len(node.args) == 1:
            turned = ast.Attribute(node.args[0], "cross", ast.Load())
            yield ORDER, ast.Call(turned, [node.func.value], [])


def _of_step(node: ast.Call, function: ast.Attribute) -> Iterator[Change]:
    """A joint of a chain: turned the other way, left out, or exchanged with the one before."""
    axis, amount = node.args[0], node.args[1]
    if not (isinstance(amount, ast.UnaryOp) and isinstance(amount.op, ast.USub)):
        yield SIGN, _with(node, args=[axis, ast.UnaryOp(ast.USub(), amount)])
    named = [k for k in node.keywords if k.arg == "frame"]
    if not named:
        yield TERM, function.value
    before = function.value
    if isinstance(before, ast.Call) and _called(before) in _CHAINED:
        assert isinstance(before.func, ast.Attribute)
        yield ORDER, _exchanged(node, function, before, before.func)


def _exchanged(
    last: ast.Call, outer: ast.Attribute, first: ast.Call, inner: ast.Attribute
) -> ast.Call:
    """Two joints in the other order; a frame's name stays where it stood."""
    earlier = ast.Call(
        ast.Attribute(inner.value, outer.attr, ast.Load()), last.args, first.keywords
    )
    return ast.Call(ast.Attribute(earlier, inner.attr, ast.Load()), first.args, last.keywords)


def _with(node: ast.Call, **changed: object) -> ast.Call:
    parts: dict[str, object] = {"func": node.func, "args": node.args, "keywords": node.keywords}
    return ast.Call(**{**parts, **changed})  # type: ignore[arg-type]


def _replaced(tree: ast.Module, place: ast.expr, new: ast.expr) -> ast.Module:
    """A copy of the file with one expression in the place of another."""
    memo: dict[int, object] = {id(place): copy.deepcopy(new)}
    changed: ast.Module = copy.deepcopy(tree, memo)
    return ast.fix_missing_locations(changed)
