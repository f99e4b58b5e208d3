"""Plots as SVG: the same bytes every run, classes instead of colours, no script.

`plot_html(plot, identifier)` is what stands in a <figure>. One module draws one kind; axes, classes
of colour and legends are shared.
"""

from __future__ import annotations

from collections.abc import Sequence

from armillary.site.plots import bars, lines
from armillary.site.plots.axes import PANEL, TALL, WHOLE, Size
from armillary.site.plots.legend import Entry, colour_bar, legend
from armillary.site.plots.levels import classes_of
from armillary.site.plots.maps import heat_map
from armillary.site.plots.words import described, title
from armillary.site.svg import Drawing
from armillary.verify.plots import AnyPlot, Bars, HeatMap, Histogram, Panel, Panels, Plot, Value

_ROOM = 620.0  # width of a legend beneath panels


def plot_html(plot: AnyPlot, identifier: str) -> str:
    """A plot as SVG; panels as a box of them with their legend."""
    if not isinstance(plot, Panels):
        drawing = Drawing()
        _draw(drawing, plot, WHOLE, [plot])
        _legend(drawing, [plot], WHOLE, _beneath(plot))
        return drawing.svg(identifier, title(plot.caption), about=described(plot))
    made = [_panel(one, plot.plots, f"{identifier}-{k}") for k, one in enumerate(plot.plots, 1)]
    shared = Drawing()
    _legend(shared, plot.plots, Size(_ROOM, 0.0), 0.0)
    key = shared.svg(f"{identifier}-key", "Legend")
    return f'<div class="panels">{"".join(made)}</div><div class="panels-key">{key}</div>'


def _panel(plot: Panel, together: Sequence[Panel], identifier: str) -> str:
    drawing = Drawing()
    size = TALL if isinstance(plot, Plot) and plot.equal else PANEL
    _draw(drawing, plot, size, together)
    drawing.text((0 if _is_sky(plot) else size.width / 2, _head(plot)), plot.caption, "heading")
    return drawing.svg(identifier, title(plot.caption), about=described(plot))


def _draw(drawing: Drawing, plot: Panel, size: Size, together: Sequence[Panel]) -> None:
    """A plot without its legend, on the vertical scale or the classes of all in `together`."""
    if isinstance(plot, HeatMap):
        classes = classes_of([one for one in together if isinstance(one, HeatMap)])
        heat_map(drawing, plot, size, classes)
    elif isinstance(plot, Plot):
        lines.lines(drawing, plot, size, [one for one in together if isinstance(one, Plot)])
    elif isinstance(plot, Histogram):
        lines.steps(drawing, plot, size, _numbers(together))
    else:
        bars.bars(drawing, plot, size, _numbers(together))


def _numbers(together: Sequence[Panel]) -> list[Value]:
    counted = [one for one in together if isinstance(one, (Bars, Histogram))]
    found = [value for one in counted for series in one.series for value in series.values]
    levels = [m.value for o in counted if isinstance(o, Histogram) for m in o.marks if not m.across]
    return [*found, *levels]


def _legend(drawing: Drawing, together: Sequence[Panel], size: Size, top: float) -> None:
    plot = together[0]
    if isinstance(plot, HeatMap):
        classes = classes_of([one for one in together if isinstance(one, HeatMap)])
        left = -size.width / 2 if plot.sky and size.height else 0.0
        colour_bar(drawing, plot.quantity, classes, left, top, size.width)
        return
    found = _entries(plot)
    if found:
        legend(drawing, found, top, size.width)


def _entries(plot: Panel) -> list[Entry]:
    if isinstance(plot, Plot):
        return lines.entries(plot)
    if isinstance(plot, Histogram):
        return lines.step_entries(plot)
    return bars.entries(plot) if isinstance(plot, Bars) else []


def _is_sky(plot: Panel) -> bool:
    return isinstance(plot, HeatMap) and plot.sky


def _head(plot: Panel) -> float:
    """Where the heading of a panel stands: above the label of its vertical axis."""
    return -PANEL.height * 0.6 - 36 if _is_sky(plot) else -38


def _beneath(plot: Panel) -> float:
    """Where the legend of a single plot stands."""
    if _is_sky(plot):
        return WHOLE.height * 0.6 + 48
    if isinstance(plot, Bars):
        return WHOLE.height + 49 + 17 * bars.deepest(plot, WHOLE)
    return WHOLE.height + 66 + (6 if isinstance(plot, HeatMap) else 0)
