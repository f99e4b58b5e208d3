"""`armillary study`: what a study found, as text and as data; its parameters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from pathlib import Path

from armillary.project.config import Project
from armillary.project.errors import ProjectError
from armillary.project.generate import Say
from armillary.site.studies import studied, telling
from armillary.store.files import replace_durably
from armillary.verify.parameters import (
    NAME,
    ParameterError,
    Parameters,
    bounds_text,
    read_parameters,
)
from armillary.verify.parameters import with_settings as with_set
from armillary.verify.studies.data import files
from armillary.verify.studies.tables import origin
from armillary.verify.studies.tables import text as text_of_value
from armillary.verify.study import Absent, Heading, Item, Prose, Table


def study(
    project: Project,
    system: str,
    tell: Say,
    settings: Sequence[str] = (),
    only: Sequence[str] = (),
    folder: Path | None = None,
) -> Iterator[str]:
    """The study of a system in lines; a plot is its caption.

    Args:
        tell: hears how the study goes on.
        settings: parameters that are set by hand, as "name=value".
        only: names of parts; all unless given.
        folder: where the data of plots and tables are written as CSV.

    Raises:
        ProjectError: for a system that is not there, has no study, or misses its engine.
        SiteError: for anything that goes wrong in the files of the study.
    """
    path = _path(project, system)
    if not path.is_file():
        raise ProjectError(f"{system} has no study", f"write {path}")
    changed = _changed(path, settings)
    with telling(tell):
        found = studied(project.root, project.kernels, system, settings, only)
    if found.missing:
        raise ProjectError(f"the study of {system}: {found.missing}", "install it beside armillary")
    if not found.items:
        raise ProjectError(
            f"the study of {system} found nothing",
            "run `armillary generate` first; let `study` yield tables and plots",
        )
    if folder is not None:
        data = files(found.items)
        for name, text in data.items():
            replace_durably(folder / name, text.encode())
        tell(f"wrote {len(data)} files to {folder}")
    if changed:
        yield from (*changed, "")
    for item in found.items:
        yield from (*_lines(item), "")


def parameters(project: Project, system: str, settings: Sequence[str] = ()) -> list[str]:
    """The parameters of the study of a system, section by section, in lines.

    Raises:
        ProjectError: for a system that is not there, and for anything wrong with its parameters.
    """
    path = _path(project, system)
    if not path.with_name(NAME).is_file():
        raise ProjectError(f"{system} has no parameters", f"write {path.with_name(NAME)}")
    lines: list[str] = []
    for section, group in groupby(_parameters(path, settings).records(), lambda one: one.section):
        lines.append(f"[{section}]")
        for one in group:
            bounds = bounds_text(one)
            value = f"{one.name} = {text_of_value(one.value)}{one.after}"
            lines.append(f"  {value}{f' ({bounds})' if bounds else ''}: {one.meaning}")
            lines.append(f"      {': '.join(origin(one))}")
    return lines


def _path(project: Project, system: str) -> Path:
    project.chosen((system,))
    return project.derivations / system / "study.py"


def _parameters(path: Path, settings: Sequence[str]) -> Parameters:
    try:
        return with_set(read_parameters(path.with_name(NAME)), settings)
    except ParameterError as problem:
        raise ProjectError(problem.problem, problem.mend) from problem


def _changed(path: Path, settings: Sequence[str]) -> list[str]:
    """A line for each parameter that was set, for who reads the numbers later."""
    if not settings:
        return []
    records = _parameters(path, settings).records()
    return [
        f"[set] {one.full} = {text_of_value(one.value)}{one.after}, "
        f"otherwise {text_of_value(one.default)}"
        for one in records
        if one.default is not None
    ]


def _lines(item: Item) -> list[str]:
    if isinstance(item, Heading):
        return [item.title, "=" * len(item.title)]
    if isinstance(item, Prose):
        return [item.text]
    if isinstance(item, Absent):
        return [f"[not computed here] {item.part}: {item.why}"]
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
