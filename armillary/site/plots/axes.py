"""Axes: where a value stands, round ticks, the grid and the labels."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from armillary.site.svg import Drawing, Point2
from armillary.verify.plots import RAISED, Axis, Value


@dataclass(frozen=True)
class Size:
    """Room for the plot itself, and about how many ticks stand on its axes."""

    width: float
    height: float
    across: int = 6
    up: int = 6


WHOLE = Size(520.0, 260.0)
PANEL = Size(230.0, 190.0, 4, 5)
TALL = Size(170.0, 330.0, 3, 6)  # a panel of a drawing with equal units


@dataclass(frozen=True)
class Scale:
    """From values to places on the paper.

    Attributes:
        ticks: values that get a line and a number.
        minor: values that get a line only.
    """

    axis: Axis
    low: float
    high: float
    start: float
    end: float
    ticks: tuple[float, ...]
    minor: tuple[float, ...] = ()

    def at(self, value: float) -> float:
        """The place of a value."""
        low, high, value = (self._even(v) for v in (self.low, self.high, value))
        return self.start + (value - low) / (high - low) * (self.end - self.start)

    def _even(self, value: float) -> float:
        return math.log10(value) if self.axis.log else value


def scale(
    axis: Axis, found: Iterable[Value], start: float, end: float, about: int, snug: bool = False
) -> Scale:
    """The scale of an axis for some values.

    Args:
        snug: whether it ends with the data; else with round numbers.
    """
    known = [value for value in found if value is not None]
    low = axis.low if axis.low is not None else min(known, default=axis.high or 1.0)
    high = axis.high if axis.high is not None else max(known, default=axis.low or 1.0)
    low, high = _apart(axis, low, high)
    marks = log_ticks(low, high) if axis.log else ticks(low, high, about)
    if not snug:
        low = low if axis.low is not None else marks[0]
        high = high if axis.high is not None else marks[-1]
    room = (high / low - 1 if axis.log else high - low) * 1e-9
    inside = [t for t in marks if low - abs(room) <= t <= high + abs(room)]
    return Scale(axis, low, high, start, end, tuple(inside), tuple(_minor(axis, low, high)))


def equal(
    axes: tuple[Axis, Axis], across: Iterable[Value], up: Iterable[Value], size: Size
) -> tuple[Axis, Axis]:
    """Both axes with one unit, such that the data stand in the middle of the room."""
    spans = []
    for axis, found in zip(axes, (across, up), strict=True):
        known = [value for value in found if value is not None]
        low = axis.low if axis.low is not None else min(known)
        high = axis.high if axis.high is not None else max(known)
        spans.append(_apart(axis, low, high))
    rooms = size.width, size.height
    unit = max(1.06 * (high - low) / room for (low, high), room in zip(spans, rooms, strict=True))
    made = [
        replace(axis, low=(low + high - unit * room) / 2, high=(low + high + unit * room) / 2)
        for axis, (low, high), room in zip(axes, spans, rooms, strict=True)
    ]
    return made[0], made[1]


def ticks(low: float, high: float, about: int = 6) -> list[float]:
    """Round numbers from at or below `low` to at or above `high`."""
    span = (high - low) or 1.0
    rough = span / about
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(m * power for m in (1, 2, 2.5, 5, 10) if m * power >= rough * 0.999)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    digits = 2 - math.floor(math.log10(step))
    return [round(k * step, max(digits, 0)) + 0.0 for k in range(first, last + 1)]


def log_ticks(low: float, high: float) -> list[float]:
    """Round numbers of a logarithmic axis: decades, or 1, 2, 5 where these are few."""
    decades = math.log10(high / low)
    if decades > 2:
        step = math.ceil(decades / 7)
        first = math.floor(math.log10(low) / step + 1e-9) * step
        last = math.ceil(math.log10(high) / step - 1e-9) * step
        return [10.0**k for k in range(first, last + 1, step)]
    exponents = range(math.floor(math.log10(low)) - 1, math.ceil(math.log10(high)) + 2)
    parts = (1.0, 2.0, 5.0) if decades > 0.5 else (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0)
    round_ones = [float(f"{m}e{k}") for k in exponents for m in parts]
    first_at = max(i for i, t in enumerate(round_ones) if t <= low * (1 + 1e-9))
    last_at = min(i for i, t in enumerate(round_ones) if t >= high * (1 - 1e-9))
    return round_ones[first_at : last_at + 1]


def _minor(axis: Axis, low: float, high: float) -> list[float]:
    """The numbers between decades, as long as their lines stand apart."""
    if not axis.log or math.log10(high / low) > 4:
        return []
    exponents = range(math.floor(math.log10(low)), math.ceil(math.log10(high)))
    return [
        value
        for k in exponents
        for m in range(2, 10)
        if low <= (value := float(f"{m}e{k}")) <= high
    ]


def _apart(axis: Axis, low: float, high: float) -> tuple[float, float]:
    """Two ends that are not one."""
    if low < high:
        return low, high
    if axis.log:
        low, high = min(low, high) / 2, max(low, high) * 2
    else:
        room = abs(low) / 10 or 0.5
        low, high = min(low, high) - room, max(low, high) + room
    return (
        axis.low if axis.low is not None else low,
        axis.high if axis.high is not None else high,
    )


def label_of(value: float, powers: bool = False) -> str:
    """A number as an axis shows it; very small and large ones as powers, or all if `powers`."""
    if value == 0:
        return "0"
    exponent = math.floor(math.log10(abs(value)) + 1e-12)
    if -4 <= exponent < 6 and not powers:
        return f"{value:.6g}".replace("-", "−")
    head = f"{value / 10.0**exponent:.3g}".replace("-", "−")
    power = f"10{str(exponent).translate(RAISED)}"
    return power if head == "1" else f"{head}·{power}"


def _labels(scale: Scale) -> list[str]:
    """The numbers of the ticks; those of many decades are written alike."""
    found = [label_of(value) for value in scale.ticks]
    raised = any(letter in RAISED.values() for text in found for letter in map(ord, text))
    many = scale.axis.log and raised
    return [label_of(value, powers=True) for value in scale.ticks] if many else found


def grid(drawing: Drawing, x: Scale, y: Scale) -> None:
    """The lines of all ticks, and their numbers."""
    for value in y.minor:
        drawing.line((x.start, y.at(value)), (x.end, y.at(value)), "grid minor")
    for value in x.minor:
        drawing.line((x.at(value), y.start), (x.at(value), y.end), "grid minor")
    for value, label in zip(y.ticks, _labels(y), strict=True):
        drawing.line((x.start, y.at(value)), (x.end, y.at(value)), "grid")
        drawing.text((x.start - 8, y.at(value) + 5), label, anchor="end")
    for value, label in zip(x.ticks, _labels(x), strict=True):
        drawing.line((x.at(value), y.start), (x.at(value), y.end), "grid")
        drawing.text((x.at(value), y.start + 20), label)


def frame(drawing: Drawing, x: Scale, y: Scale, drop: float = 42.0) -> None:
    """The box, and what the axes measure; `drop` is how far below it the lower label stands."""
    corners = [(x.start, y.end), (x.end, y.end), (x.end, y.start), (x.start, y.start)]
    drawing.path(corners, "frame", closed=True)
    drawing.text(((x.start + x.end) / 2, y.start + drop), x.axis.label)
    drawing.text((x.start, y.end - 12), y.axis.label, anchor="start")


def runs(points: Iterable[Sequence[Value]]) -> list[list[tuple[float, ...]]]:
    """Stretches of points without a gap."""
    found: list[list[tuple[float, ...]]] = [[]]
    for point in points:
        whole = tuple(value for value in point if value is not None)
        if len(whole) == len(point):
            found[-1].append(whole)
        elif found[-1]:
            found.append([])
    return [run for run in found if run]


def cut(a: Point2, b: Point2, x: Scale, y: Scale) -> tuple[Point2, Point2] | None:
    """The part of a stretch that lies in the box (Liang and Barsky); None when nothing does."""
    enter, leave = 0.0, 1.0
    delta = b[0] - a[0], b[1] - a[1]
    for k, (one, other) in enumerate(((x.start, x.end), (y.start, y.end))):
        low, high = sorted((one, other))
        if delta[k] == 0:
            if not low <= a[k] <= high:
                return None
            continue
        first, last = sorted(((low - a[k]) / delta[k], (high - a[k]) / delta[k]))
        enter, leave = max(enter, first), min(leave, last)
    if enter > leave:
        return None
    begin = (a[0] + enter * delta[0], a[1] + enter * delta[1]) if enter > 0 else a
    end = (a[0] + leave * delta[0], a[1] + leave * delta[1]) if leave < 1 else b
    return begin, end


def within(points: Sequence[Point2], x: Scale, y: Scale) -> list[list[Point2]]:
    """A line through points, cut to the box."""
    found: list[list[Point2]] = []
    for a, b in pairwise(points):
        piece = cut(a, b, x, y)
        if piece is None:
            continue
        if found and found[-1][-1] == piece[0]:
            found[-1].append(piece[1])
        else:
            found.append(list(piece))
    return found
