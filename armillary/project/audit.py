"""`armillary audit`: what papers print, compared with what is derived, as a table."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from textwrap import wrap

from armillary.derivation.paper import Paper
from armillary.derivation.papers import load_paper
from armillary.derivation.units import Unit
from armillary.project.config import Project
from armillary.project.generate import Say
from armillary.site.notation import Notation
from armillary.site.structure import Structure
from armillary.verify.audit.audit import audit as compare
from armillary.verify.audit.kept import Audit, audit_digest, counts, current, read, write
from armillary.verify.audit.shown import (
    about,
    error_text,
    figure,
    input_text,
    known_units,
    label,
    size,
)
from armillary.verify.audit.verdict import Counterexample, Entry, Finding, Read, Verdict

WIDTH = 100
LONGEST_KEY = 10  # a longer one has a line of its own
NONE = "no paper yet: derivations/papers/KEY.py holds what a paper prints"


def audit(project: Project, names: tuple[str, ...], say: Say) -> dict[str, tuple[Paper, Audit]]:
    """Audit some papers, or all, and keep the findings in `build/audit.json`.

    A paper whose findings stand on files that did not change since is not audited anew.

    Args:
        say: takes lines on how the work goes on.

    Raises:
        ProjectError: for a name that no paper has.
        DerivationError: for anything that a paper's file does wrong.
    """
    kept, there = read(project.root), project.papers()
    done: dict[str, tuple[Paper, Audit]] = {}
    for name in project.chosen_papers(names):
        paper = load_paper(project.derivations / "papers" / f"{name}.py")
        known = current(paper, kept)
        if known is None:
            say(f"auditing {name}: {len(paper.printed)} prints")
            known = Audit(audit_digest(paper), _findings(paper))
            write(project.root, {name: known}, there)
        else:
            say(f"{name} is as it was when it was audited")
        done[name] = paper, known
    if set(kept) - set(there) or not done:
        write(project.root, {}, there)
    return done


def _findings(paper: Paper) -> tuple[Finding, ...]:
    return compare(paper, Structure(Notation(paper)))


def table(paper: Paper, found: Audit, verbose: bool) -> Iterator[str]:
    """The lines on one paper: a row for each print, and the count of each verdict.

    Args:
        verbose: tell every reading, entry and counterexample too.
    """
    yield paper.name if paper.title == paper.name else f"{paper.name}: {paper.title}"
    columns = _columns(found.findings)
    yield _line(columns, "key", "verdict", "error up to", "finding")
    units = known_units(paper)
    for finding in found.findings:
        yield from row(about(paper.printed[finding.key]), finding, columns)
        if verbose:
            for reading in finding.readings:
                yield from _reading(reading, finding.unit, units)
    yield f"  {summary(found.findings)}"


def row(printed: str, finding: Finding, columns: tuple[int, ...]) -> Iterator[str]:
    """One finding: what is printed and what of it, wrapped beside key, verdict and error."""
    said = f"{printed}: {finding.says}"
    first, *rest = wrap(said, WIDTH - sum(columns) - 2 - len(columns)) or [""]
    key = finding.key
    if len(key) > columns[0]:
        yield f"  {key}"
        key = ""
    yield _line(columns, key, finding.label, error_text(finding), first)
    for line in rest:
        yield _line(columns, "", "", "", line)


def _columns(findings: Iterable[Finding]) -> tuple[int, ...]:
    """The widths of what stands before the words."""
    found = [(len(f.key), len(f.label), len(error_text(f))) for f in findings]
    heads = len("key"), len("verdict"), len("error up to")
    key, *others = map(max, zip(heads, *found, strict=True))
    return min(key, LONGEST_KEY), *others


def _line(columns: tuple[int, ...], *texts: str) -> str:
    padded = [f"{text:<{width}}" for text, width in zip(texts, columns, strict=False)]
    return "  " + " ".join([*padded, texts[-1]]).rstrip()


def summary(findings: Iterable[Finding]) -> str:
    """How many have which verdict: "12 holds, 3 misprint"."""
    numbers = counts(tuple(findings))
    told = [f"{number} {_plural(verdict)}" for verdict, number in numbers.items() if number]
    return ", ".join(told) or "nothing is printed"


def _plural(verdict: Verdict) -> str:
    return {Verdict.HOLDS: "hold", Verdict.ORDER: "hold to an order"}.get(verdict, verdict)


def _reading(read: Read, unit: str, units: Mapping[str, Unit]) -> Iterator[str]:
    """A reading with its entries and its counterexample."""
    name = f"read as {read.reading}: " if read.reading else ""
    repair = f"; {read.whole.words}" if read.whole else ""
    yield f"      {name}{label(read)}{repair}"
    for fact in read.properties:
        yield from wrap(fact, WIDTH, initial_indent=" " * 8, subsequent_indent=" " * 10)
    if len(read.entries) > 1:
        yield from (f"        {_entry(entry, unit)}" for entry in read.entries)
    if read.counterexample is not None:
        lines = counterexample(read.counterexample, unit, units, len(read.entries) > 1)
        yield from wrap(lines, WIDTH, initial_indent=" " * 8, subsequent_indent=" " * 10)


def _entry(entry: Entry, unit: str) -> str:
    verdict = f"{entry.verdict} {entry.order}" if entry.verdict is Verdict.ORDER else entry.verdict
    repair = f": {entry.repair.words}" if entry.repair else ""
    error = f", error up to {size(entry.worst, unit)}" if entry.worst else ""
    return f"row {entry.row}, column {entry.column}: {verdict}{repair}{error}"


def counterexample(
    found: Counterexample, unit: str, units: Mapping[str, Unit], several: bool = False
) -> str:
    """A point at which print and derivation differ, in a line; its entry, if there are several."""
    at = ", ".join(f"{name} = {input_text(v, units.get(name))}" for name, v in found.at.items())
    behind = f" {unit}" if unit not in ("", "1") else ""
    place = f"row {found.row}, column {found.column} " if several else ""
    where = f"{place}{f'at {at}' if at else 'everywhere'}"
    return (
        f"{where}: printed {figure(found.printed)}, derived {figure(found.derived)}{behind}, "
        f"difference {size(found.error, unit)}"
    )
