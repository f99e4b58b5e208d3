"""The data of plots and tables as CSV: a line of heads with units; an empty cell for no value.

A plot is long rather than wide: a row is a point, and its other cells name its panel and its curve.
Numbers are as a study keeps them, to 9 digits.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Iterator, Sequence
from functools import singledispatch
from itertools import pairwise
from typing import Any

from armillary.verify.plots import Bars, HeatMap, Histogram, Mark, Panels, Plot, Value
from armillary.verify.study import Item, Table

LONGEST = 60  # letters of a name

Row = Sequence[object]


def names(items: Iterable[Item]) -> list[str]:
    """For each item the name of its file, made from its caption; empty for what has no data."""
    taken: dict[str, int] = {}
    found = []
    for item in items:
        if not has_data(item):
            found.append("")
            continue
        name = _slug(getattr(item, "caption", ""))
        taken[name] = taken.get(name, 0) + 1
        again = f"-{taken[name]}" if taken[name] > 1 else ""
        found.append(f"{name}{again}.csv")
    return found


def files(items: Sequence[Item]) -> dict[str, str]:
    """The contents of every file by its name."""
    return {name: text_of(item) for name, item in zip(names(items), items, strict=True) if name}


def has_data(item: Item) -> bool:
    """Whether an item is a table or a plot."""
    return hasattr(item, "caption") and _rows.dispatch(type(item)) is not _rows.dispatch(object)


def text_of(item: Any) -> str:
    """A table or a plot as the text of its file."""
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(
        ["" if cell is None else cell for cell in row] for row in _rows(item)
    )
    return out.getvalue()


def _slug(caption: str) -> str:
    words = re.sub(r"[^a-z0-9]+", "-", caption.lower()).strip("-") or "data"
    if len(words) <= LONGEST:
        return words
    return words[: LONGEST + 1].rpartition("-")[0] or words[:LONGEST]


# -- rows, the heads first ------------------------------------------------------------------------


@singledispatch
def _rows(item: Any) -> Iterator[Row]:
    raise TypeError(f"no data of {type(item).__name__}")


@_rows.register
def _(item: Table) -> Iterator[Row]:
    yield [f"{head.name}, {head.unit}" if head.unit else head.name for head in item.heads]
    yield from item.rows


@_rows.register
def _(item: Plot) -> Iterator[Row]:
    across, up = item.axes
    yield ["curve", across.label, up.label]
    for curve in item.curves:
        yield from ((curve.name, x, y) for x, y in zip(curve.x, curve.y, strict=True))
    for band in item.bands:
        for end in ("low", "high"):
            rows = zip(band.x, getattr(band, end), strict=True)
            yield from ((f"{band.name}, {end}", x, y) for x, y in rows)
    yield from _marks(item.marks)


@_rows.register
def _(item: Histogram) -> Iterator[Row]:
    across, up = item.axes
    yield ["series", f"{across.label}, from", f"{across.label}, to", up.label]
    for series in item.series:
        cells = zip(pairwise(item.edges), series.values, strict=True)
        yield from ((series.name, *ends, value) for ends, value in cells)
    for name, x, y in _marks(item.marks):
        yield [name, x, x, y]


@_rows.register
def _(item: Bars) -> Iterator[Row]:
    yield ["series", item.across, item.axes[1].label]
    for series in item.series:
        pairs = zip(item.groups, series.values, strict=True)
        yield from ((series.name, group, value) for group, value in pairs)


@_rows.register
def _(item: HeatMap) -> Iterator[Row]:
    across, up = (axis.label for axis in item.axes)
    ends = [f"{label}, {end}" for label in (across, up) for end in ("from", "to")]
    yield [*ends, item.quantity, "curve"]
    for (low, high), row in zip(pairwise(item.y), item.values, strict=True):
        for (left, right), value in zip(pairwise(item.x), row, strict=True):
            yield [left, right, low, high, value, None]
    for curve in item.curves:
        yield from ([x, x, y, y, None, curve.name] for x, y in zip(curve.x, curve.y, strict=True))


@_rows.register
def _(item: Panels) -> Iterator[Row]:
    heads: list[Row] = []
    rows: list[Row] = []
    for plot in item.plots:
        first, *rest = _rows(plot)
        heads.append(first)
        rows += ([plot.caption, *row] for row in rest)
    # Panels share their vertical axis; where another differs, its head names all.
    yield [
        "panel",
        *(" / ".join(dict.fromkeys(map(str, head))) for head in zip(*heads, strict=True)),
    ]
    yield from rows


def _marks(marks: Iterable[Mark]) -> Iterator[tuple[str, Value, Value]]:
    """A straight line has one number; those without a label too, for they are drawn."""
    for mark in marks:
        yield (mark.label, mark.value, None) if mark.across else (mark.label, None, mark.value)
