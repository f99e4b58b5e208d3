"""Bars: told apart by their filling, not by colour alone, and labelled with their numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from armillary.site.plots.axes import Size, frame, grid, label_of, scale
from armillary.site.plots.legend import LETTER, Entry, Sample
from armillary.site.svg import Drawing, Point2
from armillary.verify.plots import Axis, Bars, Value

_HATCH = 7.0


def bars(drawing: Drawing, plot: Bars, size: Size, up: Sequence[Value]) -> None:
    """Bars without their legend; `up` are the numbers that the vertical scale must hold."""
    _, upward = plot.axes
    y = scale(upward, up if upward.log else [0.0, *up], size.height, 0.0, size.up)
    x = replace(scale(Axis(plot.across), [0.0, 1.0], 0.0, size.width, 2, snug=True), ticks=())
    grid(drawing, x, y)
    room = size.width / len(plot.groups)
    width = 0.8 * room / len(plot.series)
    ground = y.start if upward.log else y.at(0.0)
    shown = _labels(plot, width)
    for k, series in enumerate(plot.series, 1):
        for g, value in enumerate(series.values):
            left = (g + 0.1) * room + (k - 1) * width
            if value is not None:
                _bar(drawing, (left, y.at(value)), (left + 0.9 * width, ground), k)
                at = (left + 0.45 * width, min(y.at(value), ground) - 6)
                if shown:
                    drawing.text(at, _number(value, plot.digits), "over")
    _names(drawing, plot.groups, room, size.height)
    drawing.line((x.start, ground), (x.end, ground), "frame")
    frame(drawing, x, y, drop=25 + 17 * deepest(plot, size))


def deepest(plot: Bars, size: Size) -> int:
    """How many lines the names of the groups take."""
    return max(len(_wrapped(name, size.width / len(plot.groups))) for name in plot.groups)


def entries(plot: Bars) -> list[Entry]:
    """The legend of bars."""
    return [Entry(series.name, _sample(k)) for k, series in enumerate(plot.series, 1)]


def _labels(plot: Bars, width: float) -> bool:
    """Whether the numbers fit above the bars."""
    known = [v for series in plot.series for v in series.values if v is not None]
    return all(LETTER * len(_number(v, plot.digits)) <= width + 12 for v in known)


def _number(value: float, digits: int) -> str:
    return label_of(float(f"{value:.{digits}g}"))


def _bar(drawing: Drawing, a: Point2, b: Point2, k: int) -> None:
    """A bar between two corners: solid, hollow, hatched one way, both ways, or level."""
    (left, top), (right, low) = (a[0], min(a[1], b[1])), (b[0], max(a[1], b[1]))
    box = [(left, top), (right, top), (right, low), (left, low)]
    drawing.path(box, f"bar-{k}", closed=True)
    for falling in {3: (False,), 4: (False, True)}.get(k, ()):
        for start, end in _hatch(left, top, right, low, falling):
            drawing.line(start, end, f"hatch-{k}")
    if k == 5:
        for step in range(1, int((low - top) / _HATCH) + 1):
            drawing.line((left, low - step * _HATCH), (right, low - step * _HATCH), f"hatch-{k}")


def _hatch(
    left: float, top: float, right: float, low: float, falling: bool
) -> Iterator[tuple[Point2, Point2]]:
    """Lines at 45 degrees across a box."""
    width, height = right - left, low - top
    along = _HATCH
    while along < width + height:
        first = (min(along, width), max(along - width, 0.0))
        last = (max(along - height, 0.0), min(along, height))
        if falling:
            yield (right - first[0], top + first[1]), (right - last[0], top + last[1])
        else:
            yield (left + first[0], top + first[1]), (left + last[0], top + last[1])
        along += _HATCH


def _sample(k: int) -> Sample:
    def sample(drawing: Drawing, at: Point2) -> None:
        _bar(drawing, (at[0], at[1] - 6), (at[0] + 30, at[1] + 6), k)

    return sample


def _names(drawing: Drawing, groups: Sequence[str], room: float, top: float) -> None:
    for g, name in enumerate(groups):
        for k, line in enumerate(_wrapped(name, room)):
            drawing.text(((g + 0.5) * room, top + 20 + 17 * k), line)


def _wrapped(name: str, room: float) -> list[str]:
    """A name in lines that fit, broken at spaces."""
    found: list[str] = []
    for word in name.split():
        if found and LETTER * (len(found[-1]) + 1 + len(word)) <= room:
            found[-1] += f" {word}"
        else:
            found.append(word)
    return found
