"""Pictures of chains: the frames and joints of a mechanism, drawn from the chain itself."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import sympy
from numpy.typing import NDArray

from armillary.algebra.explicit import Explicit
from armillary.algebra.scalar import Scalar
from armillary.algebra.vector import Scaled, Vector
from armillary.derivation.quantity import Constant, Quantity, Rate
from armillary.derivation.statements import Picture
from armillary.derivation.symbols import leaves
from armillary.derivation.units import RADIAN
from armillary.mechanism.chain import Shift, Turn, X, Y, Z
from armillary.mechanism.scene import Scene
from armillary.site.notation import Notation
from armillary.site.projection import Paper
from armillary.site.scenes import scene_svg
from armillary.site.svg import Drawing, Point2, plain

Array = NDArray[np.float64]

_KINDS = ("axis-x", "axis-y", "axis-z")
_COMPASS = ("E", "N", "U")
# The axis whose turn shows the angle: north for a vertical axis, the zenith for a level one.
_SHOWN = {X: Z, Y: Z, Z: Y}


@dataclass(frozen=True)
class Place:
    """A frame on its way along the chain: where it is, how it lies."""

    origin: Array
    axes: Array


def picture_svg(picture: Picture, notation: Notation, identifier: str) -> str:
    """The SVG of a picture."""
    if isinstance(picture.shown, Scene):
        return scene_svg(picture, picture.shown, identifier)
    posed = Posed(picture, notation)
    if any(isinstance(step, Shift) for step in picture.chain.steps):
        _mechanism(posed)
    else:
        _sky(posed)
    return posed.drawing.svg(identifier, picture.caption)


class Posed:
    """A chain at one pose, with paper to draw it on."""

    def __init__(self, picture: Picture, notation: Notation) -> None:
        self.picture, self.notation = picture, notation
        self.drawing = Drawing()
        self.values = [self._value(step) for step in picture.chain.steps]
        self.places = [Place(np.zeros(3), np.eye(3))]
        for step, value in zip(picture.chain.steps, self.values, strict=True):
            self.places.append(moved(self.places[-1], step, value))
        reach = max(float(np.linalg.norm(p.origin)) for p in self.places)
        self.size = reach if reach > 0 else 1.0
        self.paper = Paper(self.size)

    def _value(self, step: Turn | Shift) -> Array:
        """The angle, or the offset, in numbers."""
        if isinstance(step, Turn):
            return np.array([self._number(step.angle)])
        return np.array([self._number(step.offset[k]) for k in range(3)])

    def _number(self, node: Scalar) -> float:
        given = {sympy.Symbol(leaf.name, real=True): self._given(leaf) for leaf in leaves(node)}
        return float(Explicit()(node).subs(given))

    def _given(self, leaf: object) -> sympy.Expr:
        if isinstance(leaf, Constant):
            return leaf.value
        assert isinstance(leaf, Quantity)
        usual = 0.5 if leaf.unit == RADIAN else 1.0
        return sympy.Float(self.picture.at.get(leaf.name, usual))

    def name(self, node: Scalar | Vector) -> str:
        """The symbol that a joint turns by or a link is long by."""
        inner = node.factor if isinstance(node, Scaled) else node
        found = leaves(inner)
        return plain(self.notation.leaf(found[0])) if len(found) == 1 else ""

    @property
    def last(self) -> Place:
        return self.places[-1]


def moved(place: Place, step: Turn | Shift, value: Array) -> Place:
    """The frame after a step."""
    if isinstance(step, Shift):
        return Place(place.origin + place.axes @ value, place.axes)
    return Place(place.origin, place.axes @ turning(step.axis, float(value[0])))


def turning(axis: int, angle: float) -> Array:
    """The rotation matrix about one axis of a frame."""
    c, n = np.cos(angle), np.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(3)
    matrix[i, i] = matrix[j, j] = c
    matrix[i, j], matrix[j, i] = -n, n
    return matrix


# -- a mechanism ----------------------------------------------------------------------------------


def _mechanism(posed: Posed) -> None:
    size, chain = posed.size, posed.picture.chain
    _circle(posed, np.zeros(3), np.eye(3)[:, :2], 0.34 * size, "ground")
    if posed.picture.sun is not None:
        _collector(posed, posed.picture.sun)
    for k, step in enumerate(chain.steps):
        if isinstance(step, Shift):
            _link(posed, posed.places[k], posed.places[k + 1], posed.name(step.offset))
    _axes(posed, posed.places[0], 0.46 * size, _COMPASS)
    stacked = 0
    for k, step in enumerate(chain.steps):
        if isinstance(step, Turn):
            first = k == 0 or np.allclose(posed.places[k].origin, posed.places[k - 1].origin)
            stacked = stacked + 1 if first and k else 0
            _joint(posed, k, step, 0.2 * size * (1 + 0.35 * stacked))
    _axes(posed, posed.last, 0.34 * size, ("x", "y", "z"))


def _link(posed: Posed, start: Place, end: Place, name: str) -> None:
    a, b = posed.paper(start.origin), posed.paper(end.origin)
    posed.drawing.line(a, b, "link")
    if name:
        across = 16.0 if abs(b[0] - a[0]) < abs(b[1] - a[1]) else 0.0
        middle = ((a[0] + b[0]) / 2 - across, (a[1] + b[1]) / 2 + (4 if across else 20))
        posed.drawing.text(middle, name, anchor="end" if across else "middle")


def _joint(posed: Posed, k: int, step: Turn, radius: float) -> None:
    place, after = posed.places[k], posed.places[k + 1]
    axis = place.axes[:, step.axis]
    reach = 0.3 * posed.size
    ends = [posed.paper(place.origin + sign * reach * axis) for sign in (-1, 1)]
    posed.drawing.line(ends[0], ends[1], "dim", dashed=True)
    shown = _SHOWN[step.axis]
    arm = posed.paper(place.origin + radius * place.axes[:, shown])
    posed.drawing.line(posed.paper(place.origin), arm, "dim")
    _arc(posed, place, step, float(posed.values[k][0]), shown, radius)
    turned = posed.paper(place.origin + radius * after.axes[:, shown])
    posed.drawing.line(posed.paper(place.origin), turned, "dim")
    posed.drawing.circle(posed.paper(place.origin), 6, "joint")


def _arc(posed: Posed, place: Place, step: Turn, angle: float, shown: int, radius: float) -> None:
    """The way of one axis of a frame while a joint turns, with the joint's angle beside it."""
    arm = np.eye(3)[:, shown] * radius
    steps = [place.axes @ turning(step.axis, t * angle) @ arm for t in np.linspace(0, 1, 33)]
    points = [posed.paper(place.origin + s) for s in steps]
    posed.drawing.path(points, "dim")
    posed.drawing.head(points[-4], points[-1], "dim")
    name = posed.name(step.angle)
    if name:
        posed.drawing.text(_beside(posed, place.origin, steps[len(steps) // 2]), name)


def _beside(posed: Posed, origin: Array, arm: Array) -> Point2:
    """A place for a label a little beyond the end of an arm."""
    a, b = posed.paper(origin), posed.paper(origin + arm)
    if abs(b[0] - a[0]) < 1.0:  # upright: beside it, for a column may go on beyond its end
        return b[0] + 14, b[1] + 8
    length = max(((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5, 1e-6)
    return b[0] + 15 * (b[0] - a[0]) / length, b[1] + 15 * (b[1] - a[1]) / length + 5


def _collector(posed: Posed, sun: int) -> None:
    """The plate that is held square to the sun, and the sun."""
    place, half = posed.last, 0.17 * posed.size
    one, two = (place.axes[:, (sun + k) % 3] * half for k in (1, 2))
    corners = [one + two, one - two, -one - two, -one + two]
    posed.drawing.path([posed.paper(place.origin + c) for c in corners], "joint", closed=True)
    _sun(posed, place.origin, place.axes[:, sun], 0.75 * posed.size)


def _sun(posed: Posed, origin: Array, direction: Array, reach: float) -> None:
    tip = posed.paper(origin + reach * direction)
    posed.drawing.line(posed.paper(origin), tip, "sun", dashed=True)
    posed.drawing.circle(tip, 10, "sun")


# -- directions on the sky ------------------------------------------------------------------------


def _sky(posed: Posed) -> None:
    """A chain of rotations alone: where the last axis points, and the circles it is carried on."""
    chain, sun = posed.picture.chain, posed.picture.sun
    pointed = Z if sun is None else sun
    _circle(posed, np.zeros(3), np.eye(3)[:, :2], 1.0, "ground")
    _axes(posed, posed.places[0], 1.12, _COMPASS)
    tip = posed.last.axes[:, pointed]
    for k, step in enumerate(chain.steps):
        if not isinstance(step, Turn):
            continue
        if _ticks(step):
            _daily_circle(posed, k, step, pointed)
        last = k == len(chain.steps) - 1
        shown = pointed if last else {X: Y, Y: Z, Z: Y}[step.axis]
        radius = 1.0 if last else 0.62
        for place in posed.places[k : k + 2]:
            arm = posed.paper(radius * place.axes[:, shown])
            posed.drawing.line(posed.paper(np.zeros(3)), arm, "dim", dashed=True)
        _arc(posed, posed.places[k], step, float(posed.values[k][0]), shown, radius)
    foot = np.array([tip[0], tip[1], 0.0])
    posed.drawing.line(posed.paper(tip), posed.paper(foot), "dim")
    posed.drawing.line(posed.paper(np.zeros(3)), posed.paper(foot), "dim")
    _sun(posed, np.zeros(3), tip, 1.0)


def _ticks(step: Turn) -> bool:
    return any(
        isinstance(leaf, Quantity) and leaf.facts.rate is Rate.TICK for leaf in leaves(step.angle)
    )


def _daily_circle(posed: Posed, k: int, step: Turn, pointed: int) -> None:
    before = posed.places[k].axes
    inner = posed.places[k + 1].axes.T @ posed.last.axes[:, pointed]
    turns = np.linspace(0, 2 * np.pi, 97)
    circle = [before @ turning(step.axis, t) @ inner for t in turns]
    posed.drawing.path([posed.paper(c) for c in circle], "curve-2")
    pole = before[:, step.axis]
    posed.drawing.arrow(posed.paper(np.zeros(3)), posed.paper(1.05 * pole), "dim")


# -- shared ---------------------------------------------------------------------------------------


def _axes(posed: Posed, place: Place, length: float, names: tuple[str, str, str]) -> None:
    for k, (kind, name) in enumerate(zip(_KINDS, names, strict=True)):
        arm = length * place.axes[:, k]
        posed.drawing.arrow(posed.paper(place.origin), posed.paper(place.origin + arm), kind)
        posed.drawing.text(_beside(posed, place.origin, arm), name, kind)


def _circle(posed: Posed, centre: Array, plane: Array, radius: float, kind: str) -> None:
    turns = np.linspace(0, 2 * np.pi, 73)
    points = [centre + radius * (plane @ np.array([np.cos(t), np.sin(t)])) for t in turns]
    posed.drawing.path([posed.paper(p) for p in points], kind, closed=True)
