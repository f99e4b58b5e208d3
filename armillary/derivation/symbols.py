"""The leaves of an expression: which quantities it stands on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.iteration import Iteration
from armillary.algebra.rotation import RotationSymbol

Leaf = s.Symbol | v.VectorSymbol | RotationSymbol


def leaves(expression: object) -> list[Leaf]:
    """Every symbol below an expression, once, in the order met."""
    found: dict[int, Leaf] = {}
    seen: set[int] = set()
    stack = [expression]
    while stack:
        node = stack.pop()
        if id(node) in seen:
            continue
        seen.add(id(node))
        if isinstance(node, Leaf):
            found[id(node)] = node
        else:
            stack.extend(reversed(list(_children(node))))
    return list(found.values())


def _children(node: object) -> Iterator[object]:
    if isinstance(node, tuple):
        yield from node
    elif isinstance(node, v.Choice):
        # Its forms are equal; the first one names everything the others may.
        yield node.nested
    elif isinstance(node, Iteration):
        yield node.start
        # Inside an iteration its unknowns have values: nothing outside gives them.
        inner = leaves((node.following, node.residuals))
        yield from (leaf for leaf in inner if leaf not in node.unknowns)
    elif hasattr(node, "__dataclass_fields__"):
        for f in fields(node):  # type: ignore[arg-type]
            yield getattr(node, f.name)
