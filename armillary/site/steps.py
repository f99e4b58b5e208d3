"""The steps of a derivation as a page shows them: quantities, definitions and identities."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.derivation.quantity import AnyQuantity, Constant, ConstantTable, Kind, Role
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Block, Definition, Identity
from armillary.derivation.symbols import leaves
from armillary.derivation.units import Unit
from armillary.site.explicit import Formula, written_out
from armillary.site.idioms import number_latex
from armillary.site.notation import Notation, definition_latex, quantity_latex, references_in
from armillary.site.structure import Structure


@dataclass(frozen=True)
class Link:
    """A name that leads somewhere."""

    text: str
    href: str
    is_latex: bool = False


@dataclass(frozen=True)
class Row:
    """One line of the notation table."""

    latex: str
    meaning: str
    unit: str
    code: str
    changes: str
    range: str
    limits: str
    value_latex: str = ""


@dataclass(frozen=True)
class Step:
    """One definition of the page."""

    number: int
    identifier: str
    latex: str
    meaning: str
    because: str
    printed: str | None
    written: Formula
    explicit: Formula | None
    entries: tuple[Formula, ...]
    compact: frozenset[str]
    unit: str
    code: str
    stands_on: tuple[Link, ...]


@dataclass(frozen=True)
class Claim:
    """One identity of the page."""

    sentence: str
    formula: Formula | None


def unit_text(unit: Unit | None) -> str:
    """A unit in running text: m·s⁻² is written m/s²."""
    if unit is None:
        return ""
    text = str(unit)
    if text == "1":
        return ""
    for plain, raised in (("^2", "²"), ("^3", "³"), ("*", "·")):
        text = text.replace(plain, raised)
    return text


def notation_rows(derivation: Derivation) -> list[Row]:
    """The quantities of a system, those it borrows, and its constants."""
    own = list(derivation.quantities.values())
    borrowed = [q for q in _inputs(derivation) if all(q is not o for o in own)]
    inputs = [q for q in own if q.facts.role is not Role.PARAMETER]
    parameters = [q for q in own if q.facts.role is Role.PARAMETER]
    rows = [quantity_row(q) for q in (*inputs, *borrowed, *parameters)]
    return rows + [_constant_row(c) for c in derivation.constants.values()]


def _inputs(derivation: Derivation) -> list[AnyQuantity]:
    found: dict[int, AnyQuantity] = {}
    for kernel in derivation.kernels.values():
        for quantity in kernel.inputs:
            found[id(quantity)] = quantity
    return list(found.values())


def quantity_row(q: AnyQuantity) -> Row:
    """The line of one quantity."""
    facts = q.facts
    named = (Role.PARAMETER, Role.STATE, Role.UNKNOWN)
    return Row(
        quantity_latex(q),
        facts.meaning,
        unit_text(facts.unit) or "1",
        q.name,
        facts.role.value if facts.role in named else facts.rate.value,
        *values_text(q),
    )


def values_text(q: AnyQuantity) -> tuple[str, str]:
    """The working range of a quantity, and the limits beyond which it is refused."""
    if q.facts.kind is Kind.UNIT_VECTOR:
        return "length 1", "length² 1 ± 0.001"
    if q.facts.kind is Kind.ROTATION:
        return "rotations", f"{q.name}ᵀ{q.name} = 1 ± 0.001"
    return _interval(*q.facts.range), _interval(*q.facts.limits)


def _interval(low: float, high: float) -> str:
    return f"±{_plain(high)}" if low == -high else f"{_plain(low)} … {_plain(high)}"


def _plain(value: float) -> str:
    return f"{value:g}".replace("e+0", "e").replace("-", "\u2212")


def _constant_row(c: Constant | ConstantTable) -> Row:
    values = c.values if isinstance(c, ConstantTable) else (c.value,)
    return Row(
        quantity_latex(c),
        c.facts.meaning,
        unit_text(c.facts.unit) or "1",
        c.name,
        "constant",
        "",
        "",
        r",\;".join(map(number_latex, values)),
    )


def steps(derivation: Derivation, notation: Notation) -> Iterator[Step]:
    """The definitions in the order they were stated."""
    structure = Structure(notation)
    for number, definition in enumerate(derivation.definitions.values(), 1):
        latex = definition_latex(definition)
        expression = definition.expression
        equals = r"\;\Leftrightarrow\;" if isinstance(expression, s.Condition) else "="
        written = Formula(f"{latex} {equals} {structure(expression)}")
        out = written_out(notation, definition)
        if out is not None and out.formula.latex == written.latex:
            out = None
        yield Step(
            number,
            definition.identifier,
            latex,
            definition.meaning,
            definition.because,
            definition.printed,
            written,
            out.formula if out else None,
            out.entries if out else (),
            out.compact if out else frozenset(),
            unit_text(definition.unit),
            definition.name,
            tuple(_links(derivation, notation, definition)),
        )


def _links(derivation: Derivation, notation: Notation, definition: Definition) -> Iterator[Link]:
    for reference in references_in(definition.expression):
        found = notation.definitions.get(reference.identifier)
        if found is not None:
            yield definition_link(derivation, found)


def definition_link(derivation: Derivation, definition: Definition) -> Link:
    """A link to the step of a definition, on this page or another."""
    system = definition.identifier.partition("-")[0]
    page = "" if system == derivation.name else f"{system}.html"
    return Link(definition_latex(definition), f"{page}#eq-{definition.identifier}", True)


def claim(identity: Identity, notation: Notation) -> Claim:
    """An identity, with both its sides."""
    structure = Structure(notation)
    left, right = structure(identity.left), structure(identity.right)
    return Claim(identity.claim, Formula(f"{left} = {right}"))


def reads(block: Block) -> set[str]:
    """The names of the quantities that a block stands on."""
    return {leaf.name for leaf in leaves(block)}
