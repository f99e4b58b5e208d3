"""What a plot shows, in words, for those who listen to the page."""

from __future__ import annotations

from collections.abc import Iterable

from armillary.site.plots.axes import label_of
from armillary.verify.plots import Bars, HeatMap, Histogram, Panel, Plot, Value


def title(caption: str) -> str:
    """The first sentence of a caption, without the dollars of formulas."""
    head, stop, _ = caption.replace("$", "").partition(". ")
    return head + stop.strip()


def described(plot: Panel) -> str:
    """Axes, names and extremes."""
    across, up = plot.axes
    if isinstance(plot, HeatMap):
        cells = [value for row in plot.values for value in row]
        kind = "Map of the sky" if plot.sky else f"Map over {across.label} and {up.label}"
        return f"{kind}. {_extremes(plot.quantity, cells)}."
    if isinstance(plot, Bars):
        groups = "; ".join(
            f"{group}: "
            + ", ".join(f"{s.name} {_value(s.values[g], plot.digits)}" for s in plot.series)
            for g, group in enumerate(plot.groups)
        )
        return f"Bars of {up.label}. {groups}."
    if isinstance(plot, Histogram):
        ends = f"from {label_of(plot.edges[0])} to {label_of(plot.edges[-1])}"
        names = "; ".join(_extremes(s.name, s.values) for s in plot.series)
        return f"Histogram over {across.label}, {ends}, of {up.label}. {names}."
    return f"{_plot(plot, across.label, up.label)}."


def _plot(plot: Plot, across: str, up: str) -> str:
    known = [value for curve in plot.curves for value in curve.x if value is not None]
    ends = f"from {label_of(min(known))} to {label_of(max(known))}"
    parts = [_extremes(curve.name, curve.y) for curve in plot.curves]
    parts += [f"shaded: {band.name}" for band in plot.bands]
    parts += [f"line at {label_of(mark.value)}: {mark.label}" for mark in plot.marks if mark.label]
    return f"{up} over {across}, {ends}. {'; '.join(parts)}"


def _extremes(name: str, found: Iterable[Value]) -> str:
    known = [value for value in found if value is not None]
    if not known:
        return f"{name} without values"
    low, high = (label_of(float(f"{v:.3g}")) for v in (min(known), max(known)))
    return f"{name} from {low} to {high}"


def _value(value: Value, digits: int) -> str:
    return "none" if value is None else label_of(float(f"{value:.{digits}g}"))
