"""What a study or a simulation has to show, as data; the pages draw it.

Numbers may come as arrays. They are kept to 9 digits, so that the last bits of one machine's
arithmetic do not show; NaN and None mean that there is no value, and break a line. Infinite values
and plots of nothing are refused.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from armillary.verify.plot_values import (
    PlotError,
    Value,
    centres,
    check_count,
    check_drawn,
    check_positive,
    check_several,
    keep,
    keep_columns,
    keep_edges,
    values,
)

__all__ = [
    "LEVELS", "RAISED", "AnyPlot", "Axis", "Band", "Bars", "Curve", "HeatMap", "Histogram", "Mark",
    "Panel", "Panels", "Plot", "PlotError", "Series", "Value", "centres", "sky_map",
]  # fmt: skip
LEVELS = 9
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class Axis:
    """An axis of a plot.

    Attributes:
        label: what it measures, with its unit: "error, mrad".
        log: whether equal factors are equal lengths.
        low: where it begins; the data and round numbers decide unless given.
        high: where it ends.
    """

    label: str
    log: bool = False
    low: float | None = None
    high: float | None = None

    def __post_init__(self) -> None:
        if not self.label.strip():
            raise PlotError("an axis has no label", "say what it measures, and in which unit")
        for name in ("low", "high"):
            (end,) = values([getattr(self, name)], f"{name}= of the axis {self.label!r}")
            keep(self, name, end)
            if self.log and end is not None:
                check_positive([end], f"{name}= of the axis {self.label!r}")
        if self.low is not None and self.high is not None and not self.low < self.high:
            raise PlotError(
                f"the axis {self.label!r} runs from {self.low:g} to {self.high:g}",
                "give low= as the smaller and high= as the larger end",
            )


@dataclass(frozen=True)
class Curve:
    """Points with a name, one number of `x` for each of `y`.

    Attributes:
        style: "line", "points" (a scatter plot), or "both": a line with markers.
    """

    name: str
    x: Sequence[Value]
    y: Sequence[Value]
    style: Literal["line", "points", "both"] = "line"

    def __post_init__(self) -> None:
        keep_columns(self, "curve", "x", "y")
        if self.style not in ("line", "points", "both"):
            raise PlotError(
                f"the curve {self.name!r} has the style {self.style!r}",
                'write "line", "points" or "both"',
            )


@dataclass(frozen=True)
class Band:
    """The space between two curves, shaded."""

    name: str
    x: Sequence[Value]
    low: Sequence[Value]
    high: Sequence[Value]

    def __post_init__(self) -> None:
        keep_columns(self, "band", "x", "low", "high")


@dataclass(frozen=True)
class Mark:
    """A straight line with a label, which may be empty: at a height, or if `across` at a place."""

    value: float
    label: str
    across: bool = False

    def __post_init__(self) -> None:
        (kept,) = values([self.value], f"the mark {self.label!r}")
        if kept is None:
            raise PlotError(f"the mark {self.label!r} has no value", "leave it out, or compute it")
        keep(self, "value", kept)


@dataclass(frozen=True)
class Plot:
    """Curves, points and bands over two axes.

    Attributes:
        caption: what the plot shows, in a sentence; formulas between dollars.
        across: the horizontal axis, or its label.
        up: the vertical axis, or its label.
        equal: whether a unit is as long across as up, as in a drawing of a thing.
    """

    caption: str
    across: Axis | str
    up: Axis | str
    curves: Sequence[Curve]
    marks: Sequence[Mark] = ()
    bands: Sequence[Band] = ()
    equal: bool = False

    def __post_init__(self) -> None:
        _axes(self, "across", "up")
        if self.equal and any(axis.log for axis in self.axes):
            raise PlotError(
                "a plot with equal units on a logarithmic axis",
                "leave out equal=, or take linear axes",
            )
        _tuples(self, "curves", "marks", "bands")
        check_several(self.curves, "curves")
        for curve in self.curves:
            named = f"the curve {curve.name!r}"
            check_drawn(zip(curve.x, curve.y, strict=True), named)
            _fit(self, curve.x, [*curve.y], named)
        for band in self.bands:
            check_drawn(zip(band.x, band.low, band.high, strict=True), f"the band {band.name!r}")
            _fit(self, band.x, [*band.low, *band.high], f"the band {band.name!r}")
        _fit_marks(self)

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """Both axes, across and up."""
        return _axis(self.across), _axis(self.up)


@dataclass(frozen=True)
class Series:
    """One number for each group of bars, or for each cell of a histogram."""

    name: str
    values: Sequence[Value]

    def __post_init__(self) -> None:
        keep_columns(self, "series", "values")


@dataclass(frozen=True)
class Bars:
    """Groups of bars, labelled with their numbers: one bar of a group for each series."""

    caption: str
    across: str
    up: Axis | str
    groups: Sequence[str]
    series: Sequence[Series]
    digits: int = 3

    def __post_init__(self) -> None:
        _axes(self, "up")
        _tuples(self, "groups", "series")
        check_several(self.series, "series", 5)
        for series in self.series:
            check_count(series.name, series.values, len(self.groups), "groups")
            _fit(self, [], series.values, f"the series {series.name!r}")

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """Both axes; the horizontal one has no numbers."""
        return Axis(self.across), _axis(self.up)


@dataclass(frozen=True)
class Histogram:
    """How often values fall between edges; `series` hold the counts or shares of each cell."""

    caption: str
    across: Axis | str
    up: Axis | str
    edges: Sequence[float]
    series: Sequence[Series]
    marks: Sequence[Mark] = ()

    def __post_init__(self) -> None:
        _axes(self, "across", "up")
        _tuples(self, "series", "marks")
        keep_edges(self, "edges")
        check_several(self.series, "series")
        for series in self.series:
            check_count(series.name, series.values, len(self.edges) - 1, "cells")
            _fit(self, self.edges, series.values, f"the series {series.name!r}")
        _fit_marks(self)

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """Both axes, across and up."""
        return _axis(self.across), _axis(self.up)


@dataclass(frozen=True)
class HeatMap:
    """A number for each cell of a grid, in classes of colour.

    Attributes:
        quantity: what the colours measure, with its unit.
        x: edges of the columns, rising.
        y: edges of the rows, rising.
        values: a row of numbers for each row of cells, from the lowest.
        levels: edges of the classes, rising, at most 10; round numbers unless given.
        log: whether classes without levels= are factors of each other.
        curves: drawn upon the map, with their names.
        sky: whether it is a map of the sky: x is the azimuth from north, clockwise, and y the
            elevation, both in degrees.
    """

    caption: str
    across: Axis | str
    up: Axis | str
    quantity: str
    x: Sequence[float]
    y: Sequence[float]
    values: Sequence[Sequence[Value]]
    levels: Sequence[float] = ()
    log: bool = False
    curves: Sequence[Curve] = ()
    sky: bool = False

    def __post_init__(self) -> None:
        _axes(self, "across", "up")
        _tuples(self, "curves")
        for name in ("x", "y"):
            keep_edges(self, name)
        named = f"the map of {self.quantity!r}"
        rows = tuple(tuple(values(row, named)) for row in self.values)
        keep(self, "values", rows)
        check_count(named, rows, len(self.y) - 1, "rows of cells")
        for row in rows:
            check_count(named, row, len(self.x) - 1, "columns of cells")
        flat = [(value,) for row in rows for value in row]
        check_drawn(flat, named)
        if self.log:
            check_positive([value for (value,) in flat], named)
        keep(self, "levels", tuple(self.levels))
        if self.levels:
            keep_edges(self, "levels")
            _check_levels(named, self.levels, [value for (value,) in flat if value is not None])

    @property
    def axes(self) -> tuple[Axis, Axis]:
        """Both axes, across and up."""
        return _axis(self.across), _axis(self.up)


def sky_map(
    caption: str,
    quantity: str,
    azimuth: Sequence[float],
    elevation: Sequence[float],
    values: Sequence[Sequence[Value]],
    levels: Sequence[float] = (),
    *,
    log: bool = False,
    curves: Sequence[Curve] = (),
) -> HeatMap:
    """A map of the sky as one sees it on the ground: north above, east to the right, zenith inside.

    Args:
        azimuth: edges of the cells in degrees from north, clockwise.
        elevation: edges in degrees above the horizon, rising.
        values: a row for each cell of elevation, from the lowest.
        curves: ways over the sky, azimuth as x and elevation as y in degrees.
    """
    axes = Axis("azimuth, degrees"), Axis("elevation, degrees")
    made = HeatMap(
        caption, *axes, quantity, azimuth, elevation, values, levels, log, curves, sky=True
    )
    if made.x[-1] - made.x[0] > 360.0 or made.y[0] < 0.0 or made.y[-1] > 90.0:
        raise PlotError(
            "a map of the sky goes beyond a turn of azimuth, or 0 to 90 degrees of elevation",
            "give the edges in degrees: azimuth over at most 360, elevation from 0 to 90",
        )
    return made


Panel = Plot | Bars | Histogram | HeatMap


@dataclass(frozen=True)
class Panels:
    """Plots of one kind side by side, on one vertical scale and with one legend.

    The caption of each is its heading, and so should be short.
    """

    caption: str
    plots: Sequence[Panel]

    def __post_init__(self) -> None:
        _tuples(self, "plots")
        if not self.plots:
            raise PlotError("panels without a plot", "give at least one")
        if len({type(plot) for plot in self.plots}) > 1:
            raise PlotError("panels of several kinds", "make a figure of each kind")
        if len({_legend(plot) for plot in self.plots}) > 1:
            raise PlotError(
                "panels with different curves, axes or quantities",
                "give each panel curves (or series) of the same names in the same order, and the "
                "same vertical axis; panels share one legend",
            )


AnyPlot = Panel | Panels


def _legend(plot: Panel) -> tuple[object, ...]:
    if isinstance(plot, HeatMap):
        return plot.quantity, plot.levels, plot.log
    if isinstance(plot, Plot):
        names = [(c.name, c.style) for c in plot.curves], [b.name for b in plot.bands]
        return repr(names), plot.axes[1]
    return repr([s.name for s in plot.series]), plot.axes[1]


def _axis(given: Axis | str) -> Axis:
    return Axis(given) if isinstance(given, str) else given


def _axes(made: object, *names: str) -> None:
    for name in names:
        keep(made, name, _axis(getattr(made, name)))


def _tuples(made: object, *names: str) -> None:
    for name in names:
        keep(made, name, tuple(getattr(made, name)))


def _check_levels(name: str, levels: Sequence[float], found: Sequence[float]) -> None:
    """Refuse more classes than there are colours, and classes that leave values out."""
    if len(levels) > LEVELS + 1:
        raise PlotError(f"{name} has {len(levels) - 1} classes", f"give at most {LEVELS}")
    if min(found) < levels[0] or max(found) > levels[-1]:
        raise PlotError(
            f"{name} runs from {min(found):g} to {max(found):g}, its levels from {levels[0]:g} to "
            f"{levels[-1]:g}",
            "let levels= span the values, or give None where there should be no colour",
        )


def _fit_marks(plot: Plot | Histogram) -> None:
    for mark in plot.marks:
        x, y = ([mark.value], []) if mark.across else ([], [mark.value])
        _fit(plot, x, y, mark.label)


def _fit(plot: Plot | Histogram | Bars, x: Sequence[Value], y: Sequence[Value], name: str) -> None:
    across, up = plot.axes
    if across.log:
        check_positive(x, name)
    if up.log:
        check_positive(y, name)
