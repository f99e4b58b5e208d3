"""The numbers of a plot: kept as plain floats, and refused where they cannot be drawn."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

Value = float | None
CURVES = 6


class PlotError(ValueError):
    """Something that cannot be drawn; `mend` says how to make it so."""

    def __init__(self, problem: str, mend: str) -> None:
        self.problem, self.mend = problem, mend
        super().__init__(f"{problem}\n  mend: {mend}")


def values(given: Iterable[Any], name: str) -> tuple[Value, ...]:
    """Numbers to 9 digits; None where there is no value.

    Raises:
        PlotError: for an infinite one.
    """
    made: list[Value] = []
    for value in given:
        number = math.nan if value is None else float(value)
        if math.isinf(number):
            raise PlotError(
                f"{name} is infinite somewhere",
                "give None where there is no value, or cut it off at a stated bound",
            )
        made.append(None if math.isnan(number) else float(f"{number:.9g}") + 0.0)
    return tuple(made)


def centres(edges: Sequence[float]) -> list[float]:
    """The middles of the cells between edges, where a map is computed."""
    return [(float(a) + float(b)) / 2 for a, b in pairwise(edges)]


def keep(made: object, name: str, value: object) -> None:
    """Set a field of a frozen record while it is made."""
    object.__setattr__(made, name, value)


def keep_columns(made: Any, kind: str, *names: str) -> None:
    """Keep columns of numbers, which must be of one length."""
    for name in names:
        keep(made, name, values(getattr(made, name), f"{name} of the {kind} {made.name!r}"))
    if len({len(getattr(made, name)) for name in names}) > 1:
        found = ", ".join(f"{len(getattr(made, name))} of {name}" for name in names)
        raise PlotError(f"the {kind} {made.name!r} has {found}", "give as many of each")


def keep_edges(made: Any, name: str) -> None:
    """Keep the edges of cells, which must rise."""
    found = values(getattr(made, name), name)
    rising = all(a is not None and b is not None and a < b for a, b in pairwise(found))
    if len(found) < 2 or not rising:
        raise PlotError(
            f"{name}= does not rise from one edge to the next",
            "give each edge once, the smallest first: one more than there are cells",
        )
    keep(made, name, found)


def check_count(name: str, found: Sequence[object], wanted: int, what: str) -> None:
    """Refuse too many or too few, or none."""
    if len(found) != wanted or not wanted:
        raise PlotError(f"{name}: {len(found)} for {wanted} {what}", f"give one for each of {what}")


def check_several(found: Sequence[Any], what: str, most: int = CURVES) -> None:
    """Refuse none, too many, or names that do not tell them apart."""
    names = [one.name for one in found]
    if not found or len(found) > most:
        raise PlotError(
            f"a plot of {len(found)} {what}", f"give one to {most}; spread more over panels"
        )
    if len(set(names)) < len(names) or not all(name.strip() for name in names):
        raise PlotError(f"{what} without names of their own", f"name each of the {what} once")


def check_drawn(rows: Iterable[tuple[Value, ...]], name: str) -> None:
    """Refuse rows of which none is whole."""
    if not any(all(value is not None for value in row) for row in rows):
        raise PlotError(
            f"{name} has nothing to draw", "compute at least one value, or leave it out"
        )


def check_positive(found: Iterable[Value], name: str) -> None:
    """Refuse what has no logarithm."""
    if any(value is not None and value <= 0 for value in found):
        raise PlotError(
            f"{name} is not positive everywhere, and stands on a logarithmic scale",
            "give None where it is 0, its magnitude where the sign does not matter, or a linear "
            "scale",
        )
