"""`armillary study`: what a study found, as text."""

from __future__ import annotations

from collections.abc import Iterator

from armillary.derivation.load import load
from armillary.project.config import Project
from armillary.project.errors import ProjectError
from armillary.project.generate import Say
from armillary.site.facts import read_facts
from armillary.site.studies import studied, telling
from armillary.verify.study import Heading, Item, Prose, Table


def study(project: Project, system: str, tell: Say) -> Iterator[str]:
    """The study of a system in lines; a plot is its caption.

    Args:
        tell: hears that the study is at work.

    Raises:
        ProjectError: for a system that is not there, has no study, or misses its engine.
        SiteError: for anything that goes wrong in `study.py`.
    """
    project.chosen((system,))
    folder = project.derivations / system
    if not (folder / "study.py").is_file():
        raise ProjectError(f"{system} has no study", f"write {folder / 'study.py'}")
    derivation = load(folder / "derivation.py")
    with telling(tell):
        found = studied(project.root, derivation, read_facts(project.root))
    if found.missing:
        raise ProjectError(f"the study of {system}: {found.missing}", "install it beside armillary")
    if not found.items:
        raise ProjectError(
            f"the study of {system} found nothing",
            "run `armillary generate` first; let `study` yield tables and plots",
        )
    for item in found.items:
        yield from _lines(item)
        yield ""


def _lines(item: Item) -> list[str]:
    if isinstance(item, Heading):
        return [item.title, "=" * len(item.title)]
    if isinstance(item, Prose):
        return [item.text]
    return _table(item) if isinstance(item, Table) else [f"[figure] {item.caption}"]


def _table(table: Table) -> list[str]:
    heads = [f"{c.name}, {c.unit}" if c.unit else c.name for c in table.heads]
    rows = [heads, *table.texts()]
    widths = [max(len(row[k]) for row in rows) for k in range(len(heads))]
    lines = [
        "  ".join(
            cell.rjust(width) if table.is_number(k) else cell.ljust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    ]
    return [table.caption, lines[0], "-" * len(lines[0]), *lines[1:]]
