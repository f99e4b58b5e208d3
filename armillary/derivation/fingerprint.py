"""Digests of definitions, so that a regeneration can say which of them changed."""

from __future__ import annotations

import hashlib
from dataclasses import fields

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rotation import RotationReference
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Definition, Kernel

Reference = s.ScalarReference | s.ConditionReference | v.VectorReference | RotationReference
_REFERENCES = (s.ScalarReference, s.ConditionReference, v.VectorReference, RotationReference)


def definition_digest(definition: Definition) -> str:
    """A hash of what the definition says; other definitions count by id only."""
    return _Digest().of(definition.expression)[:16]


def kernel_definitions(derivation: Derivation, kernel: Kernel) -> dict[str, Definition]:
    """Every definition that a kernel's results and cases stand on, by id, in the order stated."""
    found: set[str] = set()
    seen: set[int] = set()
    stack: list[object] = [o.value for o in kernel.outputs] + [c.condition for c in kernel.cases]
    while stack:
        node = stack.pop()
        if id(node) in seen:
            continue
        seen.add(id(node))
        if isinstance(node, _REFERENCES):
            found.add(node.identifier)
        stack.extend(_parts(node))
    known = {d.identifier: d for used in derivation.used.values() for d in _all(used.derivation)}
    known.update({d.identifier: d for d in derivation.definitions.values()})
    return {identifier: d for identifier, d in known.items() if identifier in found}


def _all(derivation: Derivation) -> list[Definition]:
    nested = [d for used in derivation.used.values() for d in _all(used.derivation)]
    return [*nested, *derivation.definitions.values()]


def _parts(node: object) -> list[object]:
    if isinstance(node, (tuple, list)):
        return list(node)
    if isinstance(node, (s.Symbol, v.VectorSymbol, str, int, sympy.Basic)):
        return []
    if hasattr(node, "__dataclass_fields__"):
        return [getattr(node, f.name) for f in fields(node)]  # type: ignore[arg-type]
    return []


class _Digest:
    def __init__(self) -> None:
        self._done: dict[int, tuple[object, str]] = {}

    def of(self, node: object) -> str:
        known = self._done.get(id(node))
        if known is None:
            known = (node, hashlib.sha256(self._text(node).encode()).hexdigest())
            self._done[id(node)] = known
        return known[1]

    def _text(self, node: object) -> str:
        if isinstance(node, _REFERENCES):
            return f"reference {node.identifier} {node.name}"
        if isinstance(node, (s.Symbol, v.VectorSymbol)):
            value = getattr(node, "value", None)
            return f"symbol {node.name} {sympy.srepr(value) if value is not None else ''}"
        if isinstance(node, sympy.Basic):
            return str(sympy.srepr(node))
        inner = " ".join(self.of(part) for part in _parts(node))
        plain = repr(node) if isinstance(node, (str, int)) else ""
        return f"{type(node).__name__} {plain} {inner}"
