"""Classes of colour: round edges, and which class a value belongs to."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from armillary.site.plots.axes import log_ticks, ticks
from armillary.verify.plots import LEVELS, HeatMap


@dataclass(frozen=True)
class Classes:
    """Edges of the classes, and whether there are cells without a value."""

    edges: tuple[float, ...]
    has_gaps: bool

    @property
    def count(self) -> int:
        """How many classes there are."""
        return len(self.edges) - 1

    def of(self, value: float) -> int:
        """The class of a value, from 0; an edge belongs to the class above it."""
        return min(max(bisect_right(self.edges, value) - 1, 0), self.count - 1)

    def kind(self, index: int) -> str:
        """The CSS class of a class: few classes are spread over all shades."""
        if self.count == 1:
            return "level-5"
        return f"level-{1 + round(index * (LEVELS - 1) / (self.count - 1))}"


def classes_of(maps: Sequence[HeatMap]) -> Classes:
    """The classes that some maps of one quantity share."""
    cells = [value for one in maps for row in one.values for value in row]
    known = [value for value in cells if value is not None]
    edges = maps[0].levels or _round_edges(known, maps[0].log)
    return Classes(tuple(edges), len(known) < len(cells))


def _round_edges(known: Iterable[float], log: bool) -> list[float]:
    low, high = min(known), max(known)
    if low == high:
        return [low / 2, low * 2] if log else ticks(low - (abs(low) or 1), low + (abs(low) or 1), 2)
    if not log:
        return next(e for e in (ticks(low, high, n) for n in (7, 6, 5, 4)) if len(e) <= LEVELS + 1)
    edges = log_ticks(low, high)
    return edges[:: -(-(len(edges) - 1) // LEVELS)] if len(edges) > LEVELS + 1 else edges
