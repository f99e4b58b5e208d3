"""How the names of a derivation are printed: every symbol of a page gets its LaTeX here."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import fields

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.index import Index
from armillary.algebra.rotation import RotationReference
from armillary.derivation.naming import latex_name
from armillary.derivation.quantity import AnyQuantity, Constant, ConstantTable, VectorQuantity
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Definition
from armillary.derivation.symbols import Leaf
from armillary.site.svg import LETTERS

Reference = s.ScalarReference | s.ConditionReference | v.VectorReference | RotationReference
REFERENCES = (s.ScalarReference, s.ConditionReference, v.VectorReference, RotationReference)

# A definition of a block lends its name to its parts; `%s` is the block's own name.
_PARTS = {
    "R": "R_{%s}",
    "p": r"\mathbf{p}_{%s}",
    "angular": r"\boldsymbol{\omega}_{%s}",
    "linear": r"\mathbf{v}_{%s}",
    "force": r"\mathbf{f}_{%s}",
    "moment": r"\mathbf{m}_{%s}",
}
_SUBSCRIPT = re.compile(
    r"(?P<base>.*)_(?:\{(?P<group>(?:[^{}]|\{[^{}]*\})*)\}|(?P<one>\\\w+\{[^{}]*\}|\\?\w+))\Z"
)
_ABOVE = re.compile(r"(?:'|\^(?:\{[^{}]*\}|\\?\w))+\Z")
_WORD = re.compile(r"(?<![\\A-Za-z])[A-Za-z]{2,}(?![A-Za-z])")


class Notation:
    """The names of one derivation and of those that it uses."""

    def __init__(self, derivation: Derivation) -> None:
        self.derivation = derivation
        self._leaves: dict[int, str] = {}
        self.definitions: dict[str, Definition] = {}
        self._collect(derivation)

    def _collect(self, derivation: Derivation) -> None:
        for used in derivation.used.values():
            self._collect(used.derivation)
        for leaf in (*derivation.quantities.values(), *derivation.constants.values()):
            self._leaves[id(leaf)] = quantity_latex(leaf)
        for definition in derivation.definitions.values():
            self.definitions[definition.identifier] = definition

    def leaf(self, node: Leaf) -> str:
        """LaTeX of a quantity."""
        return self._leaves.get(id(node)) or upright(latex_name(node.name))

    def reference(self, node: Reference) -> str:
        """LaTeX of a definition, or of the part of one that a reference names."""
        definition = self.definitions.get(node.identifier)
        if definition is None:
            return upright(latex_name(node.name))
        own = definition_latex(definition)
        part = node.name[len(definition.name) + 1 :]
        if not part:
            return own
        if part in _PARTS:
            return _PARTS[part] % own
        return subscripted(own, part)


def quantity_latex(quantity: AnyQuantity | Constant | ConstantTable) -> str:
    """LaTeX of a quantity: as its author wrote it, else made of its name; vectors are bold.

    What has one value a part gets the letter of the index.
    """
    latex, per = quantity.facts.latex, quantity.facts.per
    if latex == latex_name(quantity.name):
        latex = _pretty(quantity.name, isinstance(quantity, VectorQuantity))
    return _per_part(latex, (per,) if per else ())


def definition_latex(definition: Definition) -> str:
    """LaTeX of a definition's name, with the letters of the indices it is stated for."""
    latex = definition.latex
    if latex == latex_name(definition.name):
        latex = _pretty(definition.name, isinstance(definition.value, v.Vector))
    return _per_part(latex, definition.indices)


def _per_part(latex: str, indices: Sequence[Index]) -> str:
    """A name with the letters of the indices it runs over."""
    for index in indices:
        latex = subscripted(latex, index.letter)
    return latex


def _pretty(name: str, bold: bool) -> str:
    base = name.partition("_")[0]
    if len(base) > 1 and base not in LETTERS:
        return rf"\text{{{name.replace('_', ' ')}}}"
    latex = upright(latex_name(name))
    return _bold(latex) if bold else latex


def _bold(latex: str) -> str:
    found = re.match(r"(\\dot\{|\\ddot\{)?(\\[A-Za-z]+|[A-Za-z])", latex)
    if found is None:
        return latex
    command = r"\boldsymbol" if found[2].startswith("\\") else r"\mathbf"
    return f"{found[1] or ''}{command}{{{found[2]}}}{latex[found.end() :]}"


def upright(latex: str) -> str:
    """Whole words of a subscript are not products of letters: they stand upright."""
    base, mark, rest = latex.partition("_")
    return base + mark + _WORD.sub(lambda m: rf"\mathrm{{{m[0]}}}", rest)


def subscripted(latex: str, more: str) -> str:
    """A name with one more subscript; what stands above it goes on standing last."""
    above = _ABOVE.search(latex)
    name = latex[: above.start()] if above else latex
    found = _SUBSCRIPT.match(name)
    if found is None or found["base"].count("{") != found["base"].count("}"):
        return f"{latex}_{{{more}}}"
    return f"{found['base']}_{{{found['group'] or found['one']},{more}}}{latex[len(name) :]}"


def references_in(expression: object) -> Iterator[Reference]:
    """The definitions that an expression names, once each; what they stand on is not opened."""
    seen: set[int] = set()
    named: set[str] = set()
    stack = [expression]
    while stack:
        node = stack.pop()
        if id(node) in seen or isinstance(node, (str, int, sympy.Basic)):
            continue
        seen.add(id(node))
        if isinstance(node, REFERENCES):
            if node.identifier not in named:
                named.add(node.identifier)
                yield node
        elif isinstance(node, tuple):
            stack.extend(reversed(node))
        elif isinstance(node, v.Choice):
            stack.append(node.summed)
        elif hasattr(node, "__dataclass_fields__") and not isinstance(node, Leaf):
            stack.extend(reversed([getattr(node, f.name) for f in fields(node)]))  # type: ignore[arg-type]
