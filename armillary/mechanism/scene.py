"""What a picture of a mechanism shows beside a chain: frames, rods, plates and curves.

Positions are expressions in the base frame. One that is per part of an index is drawn for each.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from armillary.algebra.index import Index
from armillary.algebra.scalar import Symbol
from armillary.algebra.vector import Vector


class Axes(Protocol):
    """What has three axes: a rotation, or anything else with columns."""

    def column(self, index: int, /) -> Vector: ...


@dataclass(frozen=True, eq=False)
class Frame:
    """A frame by its origin and axes, drawn as three arrows with its name beside them."""

    name: str
    origin: Vector
    axes: Axes
    size: float = 1.0


@dataclass(frozen=True, eq=False)
class Rod:
    """A straight part between two joints."""

    start: Vector
    end: Vector
    name: str = ""


@dataclass(frozen=True, eq=False)
class Plate:
    """A flat part through one corner for each part of an index."""

    corner: Vector
    over: Index
    kind: str = "joint"


@dataclass(frozen=True, eq=False)
class Trace:
    """The way of a point while one symbol runs from low to high."""

    point: Vector
    symbol: Symbol
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class Ray:
    """A dashed line from a point along a direction, to the sun if `sun`."""

    start: Vector
    direction: Vector
    length: float = 1.0
    sun: bool = False


Part = Frame | Rod | Plate | Trace | Ray


@dataclass(frozen=True, eq=False)
class Scene:
    """Parts that are drawn together, the first one first."""

    parts: tuple[Part, ...]
