"""Digests of definitions, kernels and systems.

By them a regeneration says which definitions changed, and a reader of costs and checks sees whether
these belong to the derivation as it stands. Words for the reader of a page do not count.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from dataclasses import fields

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rotation import RotationReference
from armillary.derivation.quantity import AnyQuantity
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Definition, Kernel
from armillary.derivation.symbols import Leaf

Reference = s.ScalarReference | s.ConditionReference | v.VectorReference | RotationReference
_REFERENCES = (s.ScalarReference, s.ConditionReference, v.VectorReference, RotationReference)


def definition_digest(definition: Definition) -> str:
    """A hash of what the definition says; other definitions count by id only."""
    return _Digest().of(definition.expression)[:16]


def kernel_digest(derivation: Derivation, kernel: Kernel) -> str:
    """A hash of all that a kernel is made from.

    Its name, its arguments in order with rates, limits and ranges, its results, its cases, and the
    definitions that these stand on.
    """
    digest = _Digest()
    parts = [f"kernel {kernel.system} {kernel.name}"]
    parts += [f"input {_argument(q)}" for q in kernel.inputs]
    parts += [f"parameter {_argument(q)}" for q in kernel.parameters]
    parts += [f"result {o.name} {o.unit} {digest.of(o.value)}" for o in kernel.outputs]
    parts += [f"case {int(c.status)} {digest.of(c.condition)}" for c in kernel.cases]
    parts += _definitions(kernel_definitions(derivation, kernel).values())
    return _hash(parts)


def blocks_digest(derivation: Derivation, *blocks: object) -> str:
    """A hash of expressions and of all definitions that they stand on."""
    digest = _Digest()
    parts = [digest.of(block) for block in blocks]
    return _hash([*parts, *_definitions(_reached(derivation, blocks).values())])


def system_digest(derivation: Derivation) -> str:
    """A hash of all that a system states.

    Its definitions and identities, those of other systems that they stand on, and its kernels.
    """
    digest = _Digest()
    parts = [f"system {derivation.name}"]
    parts += [f"quantity {_argument(q)}" for q in derivation.quantities.values()]
    stated: list[object] = [d.value for d in derivation.definitions.values()]
    for identity in derivation.identities:
        sides = identity.left, identity.right
        parts.append(f"identity {identity.claim} {' '.join(digest.of(side) for side in sides)}")
        stated += sides
    parts += _definitions(derivation.definitions.values())
    parts += _definitions(_reached(derivation, stated).values())
    parts += [kernel_digest(derivation, kernel) for kernel in derivation.kernels.values()]
    parts += [
        f"drawn {kernel.name} {one.quantity.name} {blocks_digest(derivation, one.output.value)} "
        f"{one.by}"
        for kernel in derivation.kernels.values()
        for one in kernel.drawn
    ]
    return _hash(parts)


def _definitions(definitions: Iterable[Definition]) -> list[str]:
    return [f"definition {d.identifier} {definition_digest(d)}" for d in definitions]


def _argument(quantity: AnyQuantity) -> str:
    facts = quantity.facts
    kind = f"{facts.role.value} {facts.rate.value} {facts.kind.value} {facts.unit}"
    return f"{quantity.name} {quantity.shape} {kind} {facts.limits} {facts.range}"


def _hash(parts: Iterable[str]) -> str:
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]


def kernel_definitions(derivation: Derivation, kernel: Kernel) -> dict[str, Definition]:
    """Every definition that a kernel's results and cases stand on, by id, in the order stated."""
    values: list[object] = [o.value for o in kernel.outputs]
    return _reached(derivation, [*values, *(c.condition for c in kernel.cases)])


def _reached(derivation: Derivation, values: Iterable[object]) -> dict[str, Definition]:
    """Every definition that some values stand on, by id, in the order stated."""
    found: set[str] = set()
    seen: set[int] = set()
    stack = list(values)
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
    if isinstance(node, (Leaf, str, int, sympy.Basic)):
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
            given = getattr(node, "given", None)
            pairs = " ".join(self.of(pair) for pair in given.pairs) if given else ""
            return f"reference {node.identifier} {node.name} {pairs}".rstrip()
        if isinstance(node, Leaf):
            values = getattr(node, "values", None)
            if values is not None:
                return f"table {node.name} {' '.join(sympy.srepr(x) for x in values)}"
            value = getattr(node, "value", None)
            return f"symbol {node.name} {sympy.srepr(value) if value is not None else ''}"
        if isinstance(node, sympy.Basic):
            return str(sympy.srepr(node))
        inner = " ".join(self.of(part) for part in _parts(node))
        plain = repr(node) if isinstance(node, (str, int)) else ""
        return f"{type(node).__name__} {plain} {inner}"
