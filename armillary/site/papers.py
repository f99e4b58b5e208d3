"""The pages of papers: every printed equation with its verdict, as the last audit found it.

A page shows findings only where they stand on the record as it is, and otherwise says which
command to run.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from armillary.derivation.paper import Negligible, Paper, Spans
from armillary.derivation.papers import load_papers
from armillary.derivation.quantity import Quantity, VectorQuantity
from armillary.derivation.symbols import leaves
from armillary.site.explicit import Formula
from armillary.site.notation import Notation, definition_latex
from armillary.site.pages import Figure, first_sentence, render
from armillary.site.plots import plot_html
from armillary.site.prints import anchors, named_formula, print_views
from armillary.site.references import Reference, reference_of
from armillary.site.steps import Row, quantity_row
from armillary.site.structure import Structure
from armillary.site.verdicts import Badge, PrintLink, Prints, badge, key_label, plain_key
from armillary.verify.audit.kept import counts, current, read
from armillary.verify.audit.shown import about, error_text, label
from armillary.verify.audit.verdict import Finding, Verdict
from armillary.verify.plots import Axis, Bars, Series

PAPERS = "papers"  # folder of the pages
MEANINGS = {
    Verdict.HOLDS: "equal to what is derived, for all values",
    Verdict.ORDER: "equal up to products of more small quantities than the number says",
    Verdict.MISPRINT: "a small change makes it hold: another function, index, symbol, unit, axis "
    "or word, a lost dot, a term or factor dropped or doubled, rows and columns exchanged, an "
    "entry printed twice",
    Verdict.SIGN: "the smallest change that makes it hold is a sign",
    Verdict.WRONG: "no small change makes it hold; where it holds all the same is said",
    Verdict.AMBIGUOUS: "it can be read in several ways, and their verdicts differ",
    Verdict.NOT_CHECKABLE: "it states nothing that a number could refute, or hangs on what the "
    "paper does not print",
}
# The least first: what a reader of the overview should see.
_TELLING = (Verdict.WRONG, Verdict.MISPRINT, Verdict.SIGN, Verdict.AMBIGUOUS, Verdict.ORDER)
_SHOWN = 7
_BARS = 5


@dataclass(frozen=True)
class Audited:
    """A paper with its findings by key; none where it was not audited as it stands."""

    paper: Paper
    findings: Mapping[str, Finding]
    outdated: bool


@dataclass(frozen=True)
class Count:
    """How many prints have a verdict."""

    badge: Badge
    number: int
    meaning: str


@dataclass(frozen=True)
class Line:
    """One finding in a table."""

    href: str
    label: str
    badge: Badge
    words: str
    says: str
    error: str


@dataclass(frozen=True)
class Name:
    """A name that the paper gives to something derived."""

    formula: Formula
    because: str


def audited_papers(root: Path) -> list[Audited]:
    """Every paper of a project, sorted by key, with what the last audit found.

    Raises:
        DerivationError: for anything wrong in a paper's file.
    """
    kept = read(root)
    made = []
    for paper in load_papers(root / "derivations").values():
        found = current(paper, kept)
        findings = {f.key: f for f in found.findings} if found else {}
        made.append(Audited(paper, findings, found is None and paper.name in kept))
    return made


def paper_texts(
    audited: Sequence[Audited], references: dict[str, Reference], explained: bool
) -> dict[str, str]:
    """The pages of all papers by file name; none where there is no paper.

    Args:
        explained: whether the site has a chapter on the audit.

    Raises:
        SiteError: for a paper that is not in the project's table of references.
    """
    if not audited:
        return {}
    cited = {a.paper.name: reference_of(references, a.paper.name, a.paper.name) for a in audited}
    texts = {f"{a.paper.name}.md": paper_page(a, cited[a.paper.name], explained) for a in audited}
    return {"index.md": papers_index(audited, cited, explained), **texts}


def paper_page(audited: Audited, reference: Reference, explained: bool = False) -> str:
    """The page of one paper."""
    paper = audited.paper
    views = print_views(paper, audited.findings)
    return render(
        "paper.md.j2",
        key=paper.name,
        reference=reference,
        summary=paper.summary,
        audited=bool(audited.findings),
        outdated=audited.outdated,
        explained=explained,
        counts=verdict_counts(audited.findings.values()),
        lines=_lines(audited),
        rows=_quantity_rows(paper),
        names=_names(paper),
        assumptions=paper.assumptions,
        prints=views,
        boxed=any(reading.marked for view in views for reading in view.readings),
    )


def papers_index(
    audited: Sequence[Audited], references: Mapping[str, Reference], explained: bool = False
) -> str:
    """The page that leads to the papers."""
    papers: list[dict[str, Any]] = [
        {
            "key": a.paper.name,
            "reference": references[a.paper.name],
            "prints": len(a.paper.printed),
            "outdated": a.outdated,
            "audited": bool(a.findings),
            "counts": verdict_counts(a.findings.values()),
            "telling": _telling(a),
        }
        for a in audited
    ]
    tally = zip(*(paper["counts"] for paper in papers), strict=True)
    figure = _figure(audited, references)
    return render(
        "papers_index.md.j2", papers=papers, tally=tally, figure=figure, explained=explained
    )


def _figure(audited: Sequence[Audited], references: Mapping[str, Reference]) -> Figure | None:
    """Bars of the verdicts on each paper; None where there are none, or too many to tell apart."""
    series = [
        Series(references[a.paper.name].short, [*counts(tuple(a.findings.values())).values()])
        for a in audited
        if a.findings
    ]
    if not 0 < len(series) <= _BARS:
        return None
    caption = "Verdicts on what each paper prints."
    most = max(value for one in series for value in one.values if value is not None)
    up = Axis("prints", low=0, high=most + 2)  # room for the number above the highest bar
    bars = Bars(caption, "verdict", up, [str(verdict) for verdict in Verdict], series)
    return Figure("fig-verdicts", plot_html(bars, "fig-verdicts"), caption)


def verdict_counts(findings: Iterable[Finding]) -> list[Count]:
    """How many prints have each verdict."""
    numbers = counts(tuple(findings))
    return [
        Count(badge(verdict, verdict), number, MEANINGS[verdict])
        for verdict, number in numbers.items()
    ]


def prints_of(audited: Iterable[Audited], references: Mapping[str, Reference]) -> Prints:
    """Every print whose audit is current, for the pages of the systems."""
    by_key: dict[tuple[str, str], PrintLink] = {}
    by_definition: dict[str, tuple[PrintLink, ...]] = {}
    for one in audited:
        places, name = anchors(one.paper), one.paper.name
        short = references[name].short if name in references else name
        for key, finding in one.findings.items():
            made = badge(finding.verdict, finding.label)
            href = f"../{PAPERS}/{name}.html#{places[key]}"
            link = PrintLink(name, key, f"{short} {key_label(key)}", href, made)
            by_key[name, plain_key(key)] = link
            for identifier in finding.claims:
                by_definition[identifier] = (*by_definition.get(identifier, ()), link)
    return Prints(by_key, by_definition)


def _lines(audited: Audited, chosen: Sequence[Finding] | None = None) -> list[Line]:
    places = anchors(audited.paper)
    page = "" if chosen is None else f"{audited.paper.name}.html"
    findings = audited.findings.values() if chosen is None else chosen
    return [
        Line(
            f"{page}#{places[f.key]}", key_label(f.key), badge(f.verdict, f.label),
            about(audited.paper.printed[f.key]), _in_short(f), error_text(f),
        )
        for f in findings
    ]  # fmt: skip


def _in_short(finding: Finding) -> str:
    if finding.verdict is Verdict.AMBIGUOUS:
        return "; ".join(f"{read.reading}: {label(read)}" for read in finding.readings)
    return first_sentence(finding.says)


def _telling(audited: Audited) -> list[Line]:
    """The findings that matter most: conclusions first, then numbered equations."""
    bad = [f for f in audited.findings.values() if f.verdict in _TELLING]

    def rank(finding: Finding) -> tuple[int, int]:
        printed = audited.paper.printed[finding.key]
        conclusion = isinstance(printed, (Negligible, Spans))
        return (_TELLING.index(finding.verdict), 0 if conclusion else 2 if finding.quote else 1)

    return _lines(audited, sorted(bad, key=rank)[:_SHOWN])


def _quantity_rows(paper: Paper) -> list[Row]:
    """The quantities that the prints stand on, in the order met."""
    found = {
        id(leaf): leaf
        for printed in paper.printed.values()
        for leaf in leaves(printed)
        if isinstance(leaf, (Quantity, VectorQuantity))
    }
    return [quantity_row(quantity) for quantity in found.values()]


def _names(paper: Paper) -> list[Name]:
    structure = Structure(Notation(paper))
    return [
        Name(named_formula(definition_latex(d), structure(d.expression)), d.because)
        for d in paper.definitions.values()
    ]
