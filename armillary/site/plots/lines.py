"""Line and scatter plots."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from armillary.site.plots.axes import Scale, Size, equal, frame, grid, runs, scale, within
from armillary.site.plots.legend import Entry, Sample
from armillary.site.svg import Drawing, Point2, number
from armillary.verify.plots import Band, Curve, Histogram, Mark, Plot, Value

# Markers by number of the curve, so that they differ without colour: each a path from a point.
_MARKERS = (
    "m-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0",
    "m-3 -3h6v6h-6z",
    "m0 -4l4 7h-8z",
    "m0 -4.5l4 4.5l-4 4.5l-4 -4.5z",
    "m-4 -3h8l-4 7z",
    "m-3.5 -3.5l7 7m0 -7l-7 7",
)
_FEW = 60  # with more points than this a line keeps its markers apart


def heights(plot: Plot) -> Iterator[Value]:
    """All that the vertical axis must hold."""
    for curve in plot.curves:
        yield from curve.y
    for band in plot.bands:
        yield from (*band.low, *band.high)
    yield from (mark.value for mark in plot.marks if not mark.across)


def widths(plot: Plot) -> Iterator[Value]:
    """All that the horizontal axis must hold."""
    for curve in plot.curves:
        yield from curve.x
    for band in plot.bands:
        yield from band.x
    yield from (mark.value for mark in plot.marks if mark.across)


def lines(drawing: Drawing, plot: Plot, size: Size, together: Sequence[Plot]) -> None:
    """A plot without its legend, on the vertical scale (and the unit) of all in `together`."""
    across, upward = plot.axes
    up = [value for one in together for value in heights(one)]
    if plot.equal:
        across, upward = equal(plot.axes, [v for one in together for v in widths(one)], up, size)
    x = scale(across, widths(plot), 0.0, size.width, size.across, snug=True)
    y = scale(upward, up, size.height, 0.0, size.up)
    grid(drawing, x, y)
    for k, band in enumerate(plot.bands, 1):
        _band(drawing, band, f"band-{k}", x, y)
    marks(drawing, plot.marks, x, y)
    for k, curve in enumerate(plot.curves, 1):
        _curve(drawing, curve, k, x, y)
    frame(drawing, x, y)
    mark_labels(drawing, plot.marks, x, y)


def entries(plot: Plot) -> list[Entry]:
    """The legend of a plot."""
    found = [_entry(curve, k) for k, curve in enumerate(plot.curves, 1)]
    for k, band in enumerate(plot.bands, 1):
        found.append(Entry(band.name, _swatch(f"band-{k}")))
    return found


def marks(drawing: Drawing, found: Sequence[Mark], x: Scale, y: Scale) -> None:
    """Straight lines across the box."""
    for mark in found:
        if mark.across:
            drawing.line((x.at(mark.value), y.start), (x.at(mark.value), y.end), "mark")
        else:
            drawing.line((x.start, y.at(mark.value)), (x.end, y.at(mark.value)), "mark")


def mark_labels(drawing: Drawing, found: Sequence[Mark], x: Scale, y: Scale) -> None:
    """The labels of marks, upon all that is drawn."""
    for mark in (mark for mark in found if mark.label):
        if mark.across:
            late = x.at(mark.value) > (x.start + x.end) / 2
            at = (x.at(mark.value) + (-5 if late else 5), y.end + 16)
            drawing.text(at, mark.label, "over", anchor="end" if late else "start")
        else:
            drawing.text((x.end - 6, y.at(mark.value) - 5), mark.label, "over", anchor="end")


def steps(drawing: Drawing, plot: Histogram, size: Size, up: Sequence[Value]) -> None:
    """A histogram without its legend: an outline for each series, one alone also filled."""
    across, upward = plot.axes
    places = [*plot.edges, *(mark.value for mark in plot.marks if mark.across)]
    x = scale(across, places, 0.0, size.width, size.across, snug=True)
    y = scale(upward, up if upward.log else [0.0, *up], size.height, 0.0, size.up)
    grid(drawing, x, y)
    marks(drawing, plot.marks, x, y)
    for k, series in enumerate(plot.series, 1):
        outline: list[Point2] = [(x.at(plot.edges[0]), y.start)]
        for (left, right), value in zip(pairwise(plot.edges), series.values, strict=True):
            height = y.start if value is None else y.at(value)
            outline += [(x.at(left), height), (x.at(right), height)]
        outline.append((x.at(plot.edges[-1]), y.start))
        if len(plot.series) == 1:
            drawing.path(outline, "band-1", closed=True)
        for piece in within(outline, x, y):
            drawing.path(piece, f"curve-{k}")
    frame(drawing, x, y)
    mark_labels(drawing, plot.marks, x, y)


def step_entries(plot: Histogram) -> list[Entry]:
    """The legend of a histogram."""
    return [_entry(Curve(s.name, [0.0], [0.0], "line"), k) for k, s in enumerate(plot.series, 1)]


def _curve(drawing: Drawing, curve: Curve, k: int, x: Scale, y: Scale) -> None:
    pieces = runs(zip(curve.x, curve.y, strict=True))
    placed = [[(x.at(a), y.at(b)) for a, b in piece] for piece in pieces]
    if curve.style != "points":
        for piece in placed:
            for part in within(piece, x, y):
                drawing.path(part, f"curve-{k}")
    points = [point for piece in placed for point in piece if _inside(point, x, y)]
    if curve.style == "both":
        points = points[:: -(-len(points) // _FEW)]
    elif curve.style == "line":  # a point between two gaps would not be seen
        points = [piece[0] for piece in placed if len(piece) == 1 and _inside(piece[0], x, y)]
    if points:
        markers(drawing, points, k)


def markers(drawing: Drawing, points: Sequence[Point2], k: int) -> None:
    """The marker of the k-th curve at some points, as one path."""
    marker = _MARKERS[k - 1]
    path = "".join(f"M{number(a)} {number(b)}{marker}" for a, b in points)
    drawing.shape(path, f"marker-{k}", points)


def _inside(point: Point2, x: Scale, y: Scale) -> bool:
    return x.start <= point[0] <= x.end and y.end <= point[1] <= y.start


def _band(drawing: Drawing, band: Band, kind: str, x: Scale, y: Scale) -> None:
    for run in runs(zip(band.x, band.low, band.high, strict=True)):
        lower = [(x.at(a), _held(y.at(low), y)) for a, low, _ in run]
        upper = [(x.at(a), _held(y.at(high), y)) for a, _, high in run]
        drawing.path([*lower, *reversed(upper)], kind, closed=True)


def _held(height: float, y: Scale) -> float:
    return min(max(height, y.end), y.start)


def _entry(curve: Curve, k: int) -> Entry:
    def sample(drawing: Drawing, at: Point2) -> None:
        if curve.style != "points":
            drawing.line(at, (at[0] + 30, at[1]), f"curve-{k}")
        if curve.style != "line":
            markers(drawing, [(at[0] + 15, at[1])], k)

    return Entry(curve.name, sample)


def _swatch(kind: str) -> Sample:
    def sample(drawing: Drawing, at: Point2) -> None:
        a, b = at
        drawing.path([(a, b - 6), (a + 30, b - 6), (a + 30, b + 6), (a, b + 6)], kind, closed=True)

    return sample
