"""Pictures of scenes: platforms and whatever else is no serial chain."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
import sympy
from numpy.typing import NDArray

from armillary.algebra.explicit import Explicit
from armillary.algebra.index import Index
from armillary.algebra.indexed import indices
from armillary.algebra.scalar import Symbol
from armillary.algebra.vector import Vector
from armillary.derivation.quantity import Constant, Quantity
from armillary.derivation.statements import Picture
from armillary.derivation.symbols import leaves
from armillary.derivation.units import RADIAN
from armillary.mechanism.scene import Frame, Part, Plate, Ray, Rod, Scene, Trace
from armillary.site.projection import Paper
from armillary.site.svg import Drawing

Array = NDArray[np.float64]
_KINDS = ("axis-x", "axis-y", "axis-z")
_STEPS = 48


class Numbers:
    """Positions in numbers, at the values that a picture is posed at."""

    def __init__(self, at: Mapping[str, float]) -> None:
        self.at = dict(at)
        self.explicit = Explicit()

    def __call__(self, node: Vector, explicit: Explicit | None = None) -> Array:
        form = (explicit or self.explicit)(node)
        names = {leaf.name: leaf for leaf in leaves(node)}
        given = {s: self._given(s.name, names) for s in form.free_symbols}
        return np.array([float(x) for x in form.subs(given)])

    def _given(self, name: str, names: Mapping[str, object]) -> sympy.Expr:
        leaf = names.get(name)
        if isinstance(leaf, Constant):
            return leaf.value
        angle = isinstance(leaf, Quantity) and leaf.unit == RADIAN
        return sympy.Float(self.at.get(name, 0.5 if angle else 1.0))

    def parts(self, *nodes: Vector, held: Index | None = None) -> Iterator[Explicit]:
        """The translation at each part of the indices that positions are left open in."""
        found = [self.explicit]
        for index in sorted(indices(nodes), key=str):
            if index != held:
                found = [e.moved(index, k) for e in found for k in range(index.size)]
        yield from found


def scene_svg(picture: Picture, scene: Scene, identifier: str) -> str:
    """The SVG of a scene."""
    numbers, drawing = Numbers(picture.at), Drawing()
    points = [p for part in scene.parts for p in _reach(part, numbers)]
    paper = Paper(max(float(np.linalg.norm(p)) for p in points))
    for part in scene.parts:
        _draw(part, numbers, drawing, paper)
    return drawing.svg(identifier, picture.caption)


def _reach(part: Part, numbers: Numbers) -> list[Array]:
    if isinstance(part, (Rod, Ray)):
        return [numbers(part.start, e) for e in numbers.parts(part.start)]
    if isinstance(part, Frame):
        return [numbers(part.origin, e) + part.size for e in numbers.parts(part.origin)]
    if isinstance(part, Plate):
        return [numbers(part.corner, e) for e in numbers.parts(part.corner)]
    return [p for line in _traced(part, numbers) for p in line]


def _traced(part: Trace, numbers: Numbers) -> Iterator[list[Array]]:
    held: Symbol = part.symbol
    for explicit in numbers.parts(part.point):
        line = []
        for value in np.linspace(part.low, part.high, _STEPS + 1):
            moved = Numbers({**numbers.at, held.name: float(value)})
            line.append(moved(part.point, explicit))
        yield line


def _draw(part: Part, numbers: Numbers, drawing: Drawing, paper: Paper) -> None:
    if isinstance(part, Frame):
        _frame(part, numbers, drawing, paper)
    elif isinstance(part, Rod):
        for explicit in numbers.parts(part.start, part.end):
            a, b = paper(numbers(part.start, explicit)), paper(numbers(part.end, explicit))
            drawing.line(a, b, "link")
            for joint in (a, b):
                drawing.circle(joint, 3, "joint")
        if part.name:
            drawing.text(((a[0] + b[0]) / 2 + 12, (a[1] + b[1]) / 2), part.name, anchor="start")
    elif isinstance(part, Plate):
        for explicit in numbers.parts(part.corner, held=part.over):
            places = (explicit.moved(part.over, k) for k in range(part.over.size))
            corners = [paper(numbers(part.corner, e)) for e in places]
            drawing.path(corners, part.kind, closed=True)
    elif isinstance(part, Trace):
        for line in _traced(part, numbers):
            drawing.path([paper(p) for p in line], "curve-2")
    else:
        _ray(part, numbers, drawing, paper)


def _frame(part: Frame, numbers: Numbers, drawing: Drawing, paper: Paper) -> None:
    for explicit in numbers.parts(part.origin, *(part.axes.column(k) for k in range(3))):
        origin = numbers(part.origin, explicit)
        start = paper(origin)
        for k, (kind, letter) in enumerate(zip(_KINDS, "xyz", strict=True)):
            tip = paper(origin + part.size * numbers(part.axes.column(k), explicit))
            drawing.arrow(start, tip, kind)
            away = np.array(tip) - np.array(start)
            way = away / max(float(np.linalg.norm(away)), 1e-6)
            drawing.text((tip[0] + 12 * way[0], tip[1] + 12 * way[1] + 5), letter, kind)
        drawing.text((start[0] - 8, start[1] + 18), part.name, anchor="end")


def _ray(part: Ray, numbers: Numbers, drawing: Drawing, paper: Paper) -> None:
    for explicit in numbers.parts(part.start, part.direction):
        start = numbers(part.start, explicit)
        tip = paper(start + part.length * numbers(part.direction, explicit))
        drawing.line(paper(start), tip, "sun", dashed=True)
        if part.sun:
            drawing.circle(tip, 10, "sun")
