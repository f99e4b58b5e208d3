"""Walking through an expression as it was written: names are met, and not opened."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rotation import RotationReference, RotationSymbol

REFERENCES = (s.ScalarReference, v.VectorReference, s.ConditionReference, RotationReference)
_CLOSED = (s.Symbol, v.VectorSymbol, RotationSymbol, *REFERENCES)


def parts(node: Any, closed: tuple[type, ...] = _CLOSED) -> Iterator[Any]:
    """A node and what is below it, once each, in the order met; what is `closed` is not opened."""
    stack, seen = [node], set()
    while stack:
        part = stack.pop()
        if id(part) in seen:
            continue
        seen.add(id(part))
        yield part
        if not isinstance(part, closed):
            stack.extend(reversed(_children(part)))


def stands_in(node: Any, block: Any) -> bool:
    """Whether a node stands somewhere in a block."""
    return any(part is node for part in parts(block))


def replaced(node: Any, instead: Mapping[int, Any]) -> Any:
    """A copy with some nodes, by their ids, replaced wherever they stand."""
    if id(node) in instead:
        return instead[id(node)]
    if isinstance(node, tuple):
        made = tuple(replaced(part, instead) for part in node)
        return made if any(a is not b for a, b in zip(made, node, strict=True)) else node
    if not is_dataclass(node) or isinstance(node, (type, *_CLOSED)):
        return node
    now = {f.name: getattr(node, f.name) for f in fields(node)}
    then = {name: replaced(value, instead) for name, value in now.items()}
    return node if all(then[name] is now[name] for name in now) else replace(node, **then)


def _children(node: Any) -> Sequence[Any]:
    if isinstance(node, tuple):
        return node
    if is_dataclass(node):
        return [getattr(node, f.name) for f in fields(node)]
    return ()
