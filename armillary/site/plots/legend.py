"""Legends: what a curve, a band, a bar or a colour stands for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from armillary.site.plots.axes import label_of
from armillary.site.plots.levels import Classes
from armillary.site.svg import Drawing, Point2

# As wide as a letter gets on a telephone, where labels are set larger.
LETTER = 9.5
_DIGIT = 11.5  # digits are all of one width
_ROW = 24.0
Sample = Callable[[Drawing, Point2], None]


@dataclass(frozen=True)
class Entry:
    """A name, and how to draw a sample of 30 by 12 around a point on the left of it."""

    name: str
    sample: Sample


def legend(drawing: Drawing, entries: Sequence[Entry], top: float, width: float) -> None:
    """The entries in rows no wider than `width`, from `top` downward."""
    at, row = 0.0, top
    for entry in entries:
        needed = 38 + LETTER * len(entry.name) + 20
        if at > 0 and at + needed > width + 20:
            at, row = 0.0, row + _ROW
        entry.sample(drawing, (at, row - 5))
        drawing.text((at + 38, row), entry.name, anchor="start")
        at += needed


def colour_bar(
    drawing: Drawing, quantity: str, classes: Classes, left: float, top: float, width: float
) -> None:
    """A box for each class with the edges beneath, centred in `width` from `left`."""
    names = [label_of(edge) for edge in classes.edges]
    needed = _DIGIT * max(map(len, names)) + 8
    step = min(max(30.0, needed), max(width / classes.count, 24.0))
    start = left + (width - step * classes.count) / 2
    drawing.text((left + width / 2, top), quantity)
    for k in range(classes.count):
        box = _box(start + k * step, top + 10, step, 14)
        drawing.path(box, classes.kind(k), closed=True)
    drawing.path(_box(start, top + 10, step * classes.count, 14), "frame", closed=True)
    every = 1 if step >= needed else 2
    for k in range(0, classes.count + 1, every):
        drawing.text((start + k * step, top + 40), names[k])
    if classes.has_gaps:
        drawing.path(_box(left + width / 2 - 50, top + 52, 30, 14), "frame", closed=True)
        drawing.text((left + width / 2 - 12, top + 64), "no value", anchor="start")


def _box(x: float, y: float, width: float, height: float) -> list[Point2]:
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
