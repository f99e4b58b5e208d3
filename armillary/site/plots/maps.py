"""Maps in classes of colour: over two axes, and of the sky."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from armillary.site.plots.axes import Size, frame, grid, runs, scale, within
from armillary.site.plots.levels import Classes
from armillary.site.svg import Drawing, Point2, number
from armillary.verify.plots import Curve, HeatMap, Value

_WIDEST = 120.0  # degrees of a single arc: beyond half a turn SVG would want a flag
_NAMES = {0: "N", 90: "E", 180: "S", 270: "W"}


def heat_map(drawing: Drawing, plot: HeatMap, size: Size, classes: Classes) -> None:
    """A map without its legend."""
    if plot.sky:
        _sky(drawing, plot, min(size.width, size.height * 1.2) / 2, classes)
        return
    across, upward = plot.axes
    x = scale(across, plot.x, 0.0, size.width, size.across, snug=True)
    y = scale(upward, plot.y, size.height, 0.0, size.up, snug=True)
    grid(drawing, x, y)
    cells: dict[str, list[str]] = {}
    for (low, high), row in zip(pairwise(plot.y), plot.values, strict=True):
        for kind, left, right in _stretches(plot.x, row, classes):
            a, b = number(x.at(left)), number(x.at(right))
            c, d = number(y.at(low)), number(y.at(high))
            cells.setdefault(kind, []).append(f"M{a} {c}H{b}V{d}H{a}Z")
    corners = [(x.start, y.start), (x.end, y.end)]
    _fill(drawing, cells, corners)
    for k, curve in enumerate(plot.curves, 1):
        for run in runs(zip(curve.x, curve.y, strict=True)):
            for piece in within([(x.at(a), y.at(b)) for a, b in run], x, y):
                _over(drawing, piece, k)
        _name(drawing, curve, [(x.at(a), y.at(b)) for a, b in _middle(curve)])
    frame(drawing, x, y)


# -- the sky --------------------------------------------------------------------------------------


def _sky(drawing: Drawing, plot: HeatMap, radius: float, classes: Classes) -> None:
    cells: dict[str, list[str]] = {}
    for (low, high), row in zip(pairwise(plot.y), plot.values, strict=True):
        for kind, left, right in _stretches(plot.x, row, classes):
            parts = math.ceil((right - left) / _WIDEST)
            turns = [left + (right - left) * k / parts for k in range(parts + 1)]
            sectors = [_sector(radius, low, high, a, b) for a, b in pairwise(turns)]
            cells.setdefault(kind, []).extend(sectors)
    _fill(drawing, cells, [(-radius, -radius), (radius, radius)])
    for azimuth in range(0, 360, 30):
        drawing.line(at(radius, azimuth, 60), at(radius, azimuth, 0), "grid-over")
        x, y = at(radius + 16, azimuth, 0)
        drawing.text((x, y + 5), _NAMES.get(azimuth, str(azimuth)))
    for elevation in (30, 60):
        drawing.circle((0, 0), radius * (90 - elevation) / 90, "grid-over")
    drawing.circle((0, 0), radius, "frame")
    for k, curve in enumerate(plot.curves, 1):
        for run in runs(zip(curve.x, curve.y, strict=True)):
            _over(drawing, [at(radius, a, e) for a, e in run if e >= 0], k)
        _name(drawing, curve, [at(radius, a, e) for a, e in _middle(curve) if e >= 0])
    for elevation in (30, 60):
        drawing.text(at(radius, 195, elevation - 3), f"{elevation}°", "over")


def at(radius: float, azimuth: float, elevation: float) -> Point2:
    """The place of a direction: the zenith in the middle, the horizon on the circle."""
    out, turn = radius * (90.0 - elevation) / 90.0, math.radians(azimuth)
    return out * math.sin(turn), -out * math.cos(turn)


def _sector(radius: float, low: float, high: float, left: float, right: float) -> str:
    """A cell of the sky, along its outer arc clockwise and back along the inner one."""
    outer, inner = (number(radius * (90.0 - e) / 90.0) for e in (low, high))
    corners = [(left, low), (right, low), (right, high), (left, high)]
    a, b, c, d = (" ".join(map(number, at(radius, *corner))) for corner in corners)
    back = f"L{c}A{inner} {inner} 0 0 0 {d}" if high < 90.0 else "L0 0"
    return f"M{a}A{outer} {outer} 0 0 1 {b}{back}Z"


# -- both -----------------------------------------------------------------------------------------


def _stretches(
    edges: Sequence[float], row: Sequence[Value], classes: Classes
) -> Iterator[tuple[str, float, float]]:
    """Neighbours of one class as one cell: kind, first and last edge."""
    begin: tuple[str, float] | None = None
    for (left, _), value in zip(pairwise(edges), row, strict=True):
        kind = "" if value is None else classes.kind(classes.of(value))
        if begin is not None and begin[0] != kind:
            if begin[0]:
                yield begin[0], begin[1], left
            begin = None
        if begin is None:
            begin = kind, left
    if begin is not None and begin[0]:
        yield begin[0], begin[1], edges[-1]


def _fill(drawing: Drawing, cells: dict[str, list[str]], corners: Sequence[Point2]) -> None:
    for kind in sorted(cells):
        drawing.shape("".join(cells[kind]), kind, corners)


def _over(drawing: Drawing, points: Sequence[Point2], k: int) -> None:
    """A line that is seen upon every colour."""
    if len(points) > 1:
        drawing.path(points, "halo")
        drawing.path(points, f"over-{k}")


def _middle(curve: Curve) -> list[tuple[float, float]]:
    """The point of a curve that its name stands at."""
    points = [(a, b) for run in runs(zip(curve.x, curve.y, strict=True)) for a, b in run]
    return points[len(points) // 2 :][:1]


def _name(drawing: Drawing, curve: Curve, found: Sequence[Point2]) -> None:
    for x, y in found:
        drawing.text((x, y - 7), curve.name, "over")
