"""Line plots as SVG: a box, round ticks, and up to four curves with a legend."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from armillary.site.svg import Drawing, Point2
from armillary.verify.curves import Plot

_WIDTH, _HEIGHT = 520.0, 260.0
Place = Callable[[float, float], Point2]


def plot_svg(plot: Plot, identifier: str) -> str:
    """A plot as SVG."""
    curves = plot.curves
    left, right = min(min(c.x) for c in curves), max(max(c.x) for c in curves)
    y = ticks(min(min(c.y) for c in curves), max(max(c.y) for c in curves))
    drawing = Drawing()

    def place(a: float, b: float) -> Point2:
        return ((a - left) / (right - left) * _WIDTH, (y[-1] - b) / (y[-1] - y[0]) * _HEIGHT)

    _grid(drawing, [t for t in ticks(left, right) if left <= t <= right], y, place)
    for k, curve in enumerate(curves, 1):
        points = [place(a, b) for a, b in zip(curve.x, curve.y, strict=True)]
        drawing.path(points, f"curve-{k}")
    drawing.path([(0, 0), (_WIDTH, 0), (_WIDTH, _HEIGHT), (0, _HEIGHT)], "frame", closed=True)
    drawing.text((_WIDTH / 2, _HEIGHT + 42), plot.across)
    drawing.text((0, -12), plot.up, anchor="start")
    _legend(drawing, [c.name for c in curves])
    return drawing.svg(identifier, plot.caption)


def ticks(low: float, high: float, about: int = 6) -> list[float]:
    """Round numbers from at or below `low` to at or above `high`."""
    span = (high - low) or 1.0
    rough = span / about
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(m * power for m in (1, 2, 2.5, 5, 10) if m * power >= rough * 0.999)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [round(k * step, 12) for k in range(first, last + 1)]


def _grid(drawing: Drawing, x: list[float], y: list[float], place: Place) -> None:
    for value in y:
        _, height = place(0.0, value)
        drawing.line((0, height), (_WIDTH, height), "grid")
        drawing.text((-8, height + 5), _plain(value), anchor="end")
    for value in x:
        along, _ = place(value, 0.0)
        drawing.line((along, 0), (along, _HEIGHT), "grid")
        drawing.text((along, _HEIGHT + 20), _plain(value))


def _plain(value: float) -> str:
    return f"{value:g}".replace("-", "−")


def _legend(drawing: Drawing, names: Sequence[str]) -> None:
    at = 0.0
    for k, name in enumerate(names, 1):
        low = _HEIGHT + 66
        drawing.line((at, low - 5), (at + 30, low - 5), f"curve-{k}")
        drawing.text((at + 38, low), name, anchor="start")
        at += 38 + 8.5 * len(name) + 24
