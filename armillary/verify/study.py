"""What a study says: headings, prose, tables and plots, in the order of the page.

`study.py` beside a derivation has a function `study(kernels)` that yields these: the questions of
the paper, answered with the kernels. A long study has `parts = [("name", function), ...]` instead,
each such a function; they run apart. Random numbers come from a generator that it seeds itself.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from numbers import Integral
from typing import Any

from armillary.verify import plots
from armillary.verify.plot_values import PlotError, keep, values

Cell = float | int | str | None


@dataclass(frozen=True)
class Heading:
    """Begins a part of the study; the page gives it an address."""

    title: str


@dataclass(frozen=True)
class Prose:
    """A paragraph in Markdown, with formulas between dollars and numbers already filled in."""

    text: str


@dataclass(frozen=True)
class Column:
    """A column of a table.

    Attributes:
        format: how its numbers are written, as Python's format(); whole numbers stay whole.
    """

    name: str
    unit: str = ""
    format: str = ".3g"

    def __post_init__(self) -> None:
        try:
            format(1.5, self.format)
        except ValueError:
            raise PlotError(
                f"the column {self.name!r} has the format {self.format!r}",
                'give one of Python\'s formats for numbers, such as ".3g" or ".2f"',
            ) from None


@dataclass(frozen=True)
class Table:
    """Numbers and words in rows; None and NaN mean that there is no value.

    Attributes:
        caption: what the table shows, in a sentence; formulas between dollars.
        columns: a name alone stands for a column without a unit.
    """

    caption: str
    columns: Sequence[Column | str]
    rows: Sequence[Sequence[Cell]]

    def __post_init__(self) -> None:
        keep(self, "columns", tuple(_column(c) for c in self.columns))
        keep(self, "rows", tuple(tuple(_cell(c, self.caption) for c in row) for row in self.rows))
        if not self.rows or not self.columns:
            raise PlotError("a table of nothing", "give at least one row, or leave it out")
        for row in self.rows:
            if len(row) != len(self.columns):
                raise PlotError(
                    f"a row of {len(row)} cells in a table of {len(self.columns)} columns",
                    "give a cell for each column; None where there is no value",
                )

    @property
    def heads(self) -> list[Column]:
        """The columns."""
        return [_column(c) for c in self.columns]

    def texts(self) -> list[list[str]]:
        """The cells as they are printed."""
        return [
            [text_of(c, head.format) for c, head in zip(row, self.heads, strict=True)]
            for row in self.rows
        ]

    def is_number(self, column: int) -> bool:
        """Whether a column holds numbers only."""
        return not any(isinstance(row[column], str) for row in self.rows)


@dataclass(frozen=True)
class ParameterTable:
    """The parameters of the study with unit, meaning and source, as they are when it is shown.

    Attributes:
        sections: of `parameters.toml`; all unless given.
    """

    caption: str
    sections: Sequence[str] = ()

    def __post_init__(self) -> None:
        if isinstance(self.sections, str):
            raise PlotError(f"sections={self.sections!r}", f"give a list: [{self.sections!r}]")
        keep(self, "sections", tuple(self.sections))


@dataclass(frozen=True)
class Result:
    """What a part leaves to those that need it; not shown.

    Attributes:
        value: numbers, strings, and lists, mappings and arrays of these; kept as JSON keeps them.
    """

    name: str
    value: Any

    def __post_init__(self) -> None:
        try:
            keep(self, "value", json.loads(json.dumps(self.value, default=_listed)))
        except (TypeError, ValueError):
            raise PlotError(
                f"the result {self.name!r} cannot be kept",
                "give numbers, strings, and lists, mappings with names, or arrays of these",
            ) from None


@dataclass(frozen=True)
class Part:
    """A part of a study, which runs by itself.

    Attributes:
        run: yields items. Its first argument is the kernels; others that it names are given:
            `parameters`, `tell`, `results`, `native`, or a system of the project for its kernels.
        needs: names of the parts whose results it takes.
    """

    name: str
    run: Callable[..., Iterable[object]]
    needs: Sequence[str] = ()


@dataclass(frozen=True)
class Absent:
    """Stands where a part would, for want of something on this machine; `why` says of what."""

    part: str
    why: str


Item = Heading | Prose | Table | plots.AnyPlot | ParameterTable | Absent


def text_of(cell: Cell, form: str) -> str:
    """A cell as it is printed, with a true minus sign and powers of ten."""
    if cell is None:
        return "–"
    if isinstance(cell, str):
        return cell
    text = str(cell) if isinstance(cell, int) else format(cell, form)
    head, mark, power = text.partition("e")
    raised = "10" + str(int(power)).translate(plots.RAISED) if mark else ""
    return head.replace("-", "−") + ("·" if mark else "") + raised


def _listed(given: Any) -> Any:
    """An array, or a number of one, as lists and numbers."""
    if hasattr(given, "tolist"):
        return given.tolist()
    raise TypeError


def _column(given: Column | str) -> Column:
    return Column(given) if isinstance(given, str) else given


def _cell(given: object, caption: str) -> Cell:
    if isinstance(given, str):
        return given
    if isinstance(given, bool):
        return "yes" if given else "no"
    if isinstance(given, Integral):
        return int(given)
    return values([given], f"the table {caption!r}")[0]
