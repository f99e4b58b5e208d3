"""One print of a paper as a page shows it: what stands there, what is derived, the finding."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from armillary.algebra import scalar as s
from armillary.algebra.rigid import Pose
from armillary.algebra.rotation import IDENTITY
from armillary.derivation.paper import (
    Equation,
    Paper,
    Printed,
    Reading,
    Unchecked,
)
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Block, Definition
from armillary.mechanism.chain import Chain, Shift
from armillary.site.claims import claim_latex, entries_of
from armillary.site.explicit import Formula
from armillary.site.notation import Notation, definition_latex, quantity_latex
from armillary.site.steps import Link
from armillary.site.structure import Structure, array
from armillary.site.verdicts import Badge, badge, key_label
from armillary.verify.audit.shown import figure, input_text, known_units, label, size
from armillary.verify.audit.verdict import Entry, Finding, Read, Repair, Verdict
from armillary.verify.audit.words import reading as told

_HOLDING = (Verdict.HOLDS, Verdict.ORDER)
_READABLE = 3000  # letters of LaTeX


@dataclass(frozen=True)
class EntryRow:
    """One entry that does not hold: where it stands, as printed, and as repaired."""

    place: str
    latex: str
    badge: Badge
    repair: str
    repaired: str
    error: str


@dataclass(frozen=True)
class Example:
    """A counterexample: its entry, the inputs with their LaTeX, and the two values."""

    entry: str
    at: tuple[tuple[str, str], ...]
    printed: str
    derived: str
    error: str
    unit: str


@dataclass(frozen=True)
class ReadingView:
    """One reading; without a verdict where there is no audit.

    Attributes:
        says: the finding on this reading, where there are several.
    """

    name: str
    says: str
    formulas: tuple[Formula, ...]
    badge: Badge | None
    repaired: str
    rows: tuple[EntryRow, ...]
    holding: int
    marked: bool
    example: Example | None
    error: str

    @property
    def repairs(self) -> bool:
        """Whether any entry has a repair of its own."""
        return any(row.repair for row in self.rows)

    @property
    def shown(self) -> bool:
        """Whether the print shows each entry, or is written as a whole."""
        return any(row.latex for row in self.rows)


@dataclass(frozen=True)
class Derived:
    """The definition that a print is compared with."""

    link: Link
    meaning: str
    formula: Formula


@dataclass(frozen=True)
class Note:
    """A condition under which a print is judged, or the product whose result it is."""

    words: str
    formula: Formula
    inline: bool = True


@dataclass(frozen=True)
class PrintView:
    """One print."""

    anchor: str
    label: str
    words: str
    quote: str
    badge: Badge | None
    says: str
    notes: tuple[Note, ...]
    readings: tuple[ReadingView, ...]
    derived: tuple[Derived, ...]


def anchors(paper: Paper) -> dict[str, str]:
    """The address of every print on its page, by key."""
    made: dict[str, str] = {}
    for key in paper.printed:
        name = "print-" + re.sub(r"[^0-9A-Za-z]+", "-", key.replace("'", "-prime")).strip("-")
        taken = set(made.values())
        made[key] = next(
            free for k in range(1, len(made) + 2)
            if (free := name if k == 1 else f"{name}-{k}") not in taken
        )  # fmt: skip
    return made


def print_views(paper: Paper, findings: Mapping[str, Finding]) -> list[PrintView]:
    """The prints of a paper in their order; those that `findings` lacks have no verdict."""
    return list(_Views(paper).all(findings))


class _Views:
    """Makes the views of one paper, whose notation and units they share."""

    def __init__(self, paper: Paper) -> None:
        self.paper = paper
        self.notation = Notation(paper)
        self.structure = Structure(self.notation)
        self.units, self.names = known_units(paper), _input_names(paper)

    def all(self, findings: Mapping[str, Finding]) -> Iterator[PrintView]:
        places = anchors(self.paper)
        for key, printed in self.paper.printed.items():
            yield self.view(places[key], printed, findings.get(key))

    def view(self, anchor: str, printed: Printed, finding: Finding | None) -> PrintView:
        return PrintView(
            anchor,
            key_label(printed.key),
            printed.words if isinstance(printed, (Equation, Unchecked)) else "",
            "" if isinstance(printed, Unchecked) else printed.quote,
            badge(finding.verdict, finding.label) if finding else None,
            _says(printed, finding),
            tuple(self._notes(printed)),
            tuple(self._readings(printed, finding)),
            tuple(self._derived(printed, finding)),
        )

    # -- what is derived ----------------------------------------------------------------------

    def _derived(self, printed: Printed, finding: Finding | None) -> Iterator[Derived]:
        claimed = list(finding.claims) if finding else []
        if not claimed and isinstance(printed, Equation):
            own = self.paper.definition_of(printed.claims)
            claimed = [own.identifier] if own else []
        for identifier in claimed:
            found = self.notation.definitions.get(identifier)
            if found is not None and not identifier.startswith(f"{self.paper.name}-"):
                yield self._derived_as(found)

    def _derived_as(self, found: Definition) -> Derived:
        system = found.identifier.partition("-")[0]
        name = definition_latex(found)
        link = Link(name, f"../systems/{system}.html#eq-{found.identifier}", True)
        # The names of a system are its own; those of the paper may differ from them.
        return Derived(link, found.meaning, named_formula(name, self.structure(found.expression)))

    # -- what is printed ----------------------------------------------------------------------

    def _notes(self, printed: Printed) -> Iterator[Note]:
        if not isinstance(printed, Equation):
            return
        if printed.given is not None:
            yield Note("Said to hold where", Formula(self.structure(printed.given)))
        if printed.small:
            names = r",\; ".join(map(quantity_latex, printed.small))
            yield Note("Taken as small:", Formula(names))
        if printed.product is not None:
            yield Note("The printed product:", Formula(self._product(printed.product)), False)

    def _product(self, chain: Chain) -> str:
        parts = (
            Pose(IDENTITY, step.offset) if isinstance(step, Shift) else step.rotation
            for step in chain.steps
        )
        return r"\,".join(map(self.structure, parts))

    def _readings(self, printed: Printed, finding: Finding | None) -> Iterator[ReadingView]:
        reads = {read.reading: read for read in finding.readings} if finding else {}
        unit = finding.unit if finding else ""
        if isinstance(printed, Equation):
            for reading in printed.readings:
                yield self._equation(printed, reading, reads.get(reading.name), unit)
            return
        formulas = tuple(Formula(latex) for latex in claim_latex(printed, self.structure))
        for read in reads.values():
            yield self._view_of(read, formulas, unit)
            formulas = ()  # they stand once, above the first
        if formulas:
            yield self._view_of(None, formulas, unit)

    def _equation(
        self, printed: Equation, reading: Reading, read: Read | None, unit: str
    ) -> ReadingView:
        entries = read.entries if read else ()
        bad = {(e.row, e.column) for e in entries if e.verdict not in _HOLDING}
        body, marked = self._body(reading.printed, bad if len(entries) > 1 else set())
        equals = r"\;\Leftrightarrow\;" if isinstance(reading.printed, s.Condition) else "="
        formula = Formula(f"{self._left(printed.claims)} {equals} {body}")
        name, whole = reading.name, entries_of(reading.printed)
        view = self._view_of(read, (formula,), unit, name)
        if read is not None and len(printed.readings) > 1:
            view = replace(view, says=told(read, [q.name for q in printed.small], unit))
        if len(entries) < 2:
            return view
        rows = tuple(
            self._row(entry, whole, unit) for entry in entries if entry.verdict is not Verdict.HOLDS
        )
        return replace(view, rows=rows, holding=len(entries) - len(rows), marked=marked)

    def _left(self, claims: Block) -> str:
        """What a print is compared with, by its name in the derivation."""
        definition = self.paper.definition_of(claims)
        return definition_latex(definition) if definition else self.structure(claims)

    def _body(self, block: Block, bad: set[tuple[int, int]]) -> tuple[str, bool]:
        """A print, with those entries boxed that do not hold; whether any is."""
        rows = entries_of(block)
        if not bad or rows is None:
            return self.structure(block), False
        boxed = [
            [
                rf"\boxed{{{self.structure(entry)}}}" if (i, j) in bad else self.structure(entry)
                for j, entry in enumerate(row, 1)
            ]
            for i, row in enumerate(rows, 1)
        ]
        # A box needs more room than a row has.
        return array("bmatrix", boxed).replace(r" \\ ", r" \\[.4em] "), True

    def _row(self, entry: Entry, whole: list[list[s.Scalar]] | None, unit: str) -> EntryRow:
        latex = self.structure(whole[entry.row - 1][entry.column - 1]) if whole else ""
        order = f" {entry.order}" if entry.verdict is Verdict.ORDER else ""
        return EntryRow(
            f"{entry.row}, {entry.column}",
            latex,
            badge(entry.verdict, f"{entry.verdict}{order}"),
            repair_words(entry.repair),
            entry.repair.latex if entry.repair else "",
            size(entry.worst, unit),
        )

    # -- the finding --------------------------------------------------------------------------

    def _view_of(
        self,
        read: Read | None,
        formulas: tuple[Formula, ...],
        unit: str,
        name: str = "",
    ) -> ReadingView:
        if read is None:
            return ReadingView(name, "", formulas, None, "", (), 0, False, None, "")
        # A print of one entry keeps its repair there.
        alone = read.entries[0].repair if len(read.entries) == 1 else None
        repair = read.whole or alone
        return ReadingView(
            name or read.reading,
            "",
            formulas,
            badge(read.verdict, label(read)),
            repair.latex if repair else "",
            (),
            0,
            False,
            self._example(read, unit),
            size(read.worst, unit) if read.worst else "",
        )

    def _example(self, read: Read, unit: str) -> Example | None:
        found = read.counterexample
        if found is None:
            return None
        at = tuple(
            (self.names.get(name) or _word(name), input_text(value, self.units.get(name)))
            for name, value in found.at.items()
        )
        behind = "" if unit == "1" else unit
        entry = f"{found.row}, {found.column}" if len(read.entries) > 1 else ""
        return Example(
            entry, at, figure(found.printed), figure(found.derived), figure(found.error), behind
        )


def named_formula(name: str, expression: str) -> Formula:
    """A definition in one line; by its name alone where no reader would follow the rest."""
    return Formula(f"{name} = {expression}" if len(expression) <= _READABLE else name)


def _input_names(record: Derivation) -> dict[str, str]:
    """LaTeX of the quantities of a paper and of the systems it uses; its own go first."""
    found = {name: quantity_latex(q) for name, q in record.quantities.items()}
    for used in record.used.values():
        found = {**_input_names(used.derivation), **found}
    return found


def _says(printed: Printed, finding: Finding | None) -> str:
    """The finding in words; of several readings each has its own."""
    if isinstance(printed, Unchecked):
        return printed.reason
    several = isinstance(printed, Equation) and len(printed.readings) > 1
    return finding.says if finding and not several else ""


def _word(name: str) -> str:
    return rf"\text{{{name.replace('_', ' ')}}}"


def repair_words(repair: Repair | None) -> str:
    """A repair in words, with the order to which the repaired print holds."""
    if repair is None:
        return ""
    return repair.words + (f"; then it holds to order {repair.order}" if repair.order else "")
