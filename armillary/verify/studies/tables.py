"""Tables of the parameters of a study."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from armillary.verify.parameters import Parameter, Parameters, Value, bounds_text
from armillary.verify.studies.errors import StudyError
from armillary.verify.study import Cell, Column, Item, ParameterTable, Table, text_of

_FORM = ".9g"


def shown(items: Iterable[Item], parameters: Parameters | None, path: Path) -> tuple[Item, ...]:
    """The items, with the tables of parameters filled in.

    Args:
        path: of the study, for errors.

    Raises:
        StudyError: for a table of parameters in a study that has none.
        ParameterError: for a section that is not there.
    """
    return tuple(
        _filled(item, parameters, path) if isinstance(item, ParameterTable) else item
        for item in items
    )


def _filled(item: ParameterTable, parameters: Parameters | None, path: Path) -> Table:
    if parameters is None:
        raise StudyError(
            f"{path}: a table of parameters, and there are none",
            "write parameters.toml beside the study, or leave the table out",
        )
    return parameter_table(item.caption, parameters, item.sections)


def parameter_table(caption: str, parameters: Parameters, sections: Iterable[str] = ()) -> Table:
    """The parameters of some sections, or of all, each with what is said of it.

    Raises:
        ParameterError: for a section that is not there.
    """
    chosen = parameters.records(sections)
    columns: list[Column | str] = [
        "name", Column("value", format=_FORM), "unit", "may be", "meaning", "from", "source",
    ]  # fmt: skip
    rows = [_row(one) for one in chosen]
    bounded = any(row[3] for row in rows)
    if not bounded:
        del columns[3]
        rows = [[*row[:3], *row[4:]] for row in rows]
    return Table(caption, columns, rows)


def _row(one: Parameter) -> list[Cell]:
    value = text(one.value) if isinstance(one.value, tuple) else one.value
    return [one.full, value, one.after.strip(), bounds_text(one), one.meaning, *origin(one)]


def origin(one: Parameter) -> tuple[str, str]:
    """Where a value is from, in a word and in a sentence."""
    if one.default is None:
        return one.provenance, one.source
    return "set", f"Set by hand; otherwise {text(one.default)} ({one.provenance})."


def text(value: Value) -> str:
    """A value as it is printed."""
    if isinstance(value, tuple):
        inner = [f"[{text(x)}]" if isinstance(x, tuple) else text(x) for x in value]
        return ", ".join(inner)
    return text_of(value, _FORM)
