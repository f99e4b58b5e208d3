"""Prints that hold only where a quantity takes a special value, or on one branch."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from armillary.derivation.quantity import Quantity
from armillary.verify.audit import points as p
from armillary.verify.audit.compare import CLOSE
from armillary.verify.audit.numbers import Doubles
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.properties import largest
from armillary.verify.audit.sides import Sides
from armillary.verify.audit.verdict import Repair

_ANGLES = ((0.0, "0"), (90.0, "90 deg"), (-90.0, "-90 deg"), (180.0, "180 deg"))
_BRANCH = "the cosine of the derived angle is not negative"
_ENOUGH = 5  # points on a branch that may speak for it


def special_repair(sides: Sides) -> Repair | None:
    """The values, or the branch, to which the bad entries are confined to hold."""
    everywhere = sides.bench.points
    if _on_branch(sides, everywhere):
        return _repair([_BRANCH], 1)
    found = [(words, points) for words, points in _restrictions(sides)]
    held = [words for words, points in found if _at_all(sides, points)]
    if held:
        return _repair(held, 1)
    held = [words for words, points in found if _on_branch(sides, points)]
    return _repair([f"{words} and {_BRANCH}" for words in held], 2) if held else None


def _repair(where: Sequence[str], size: int) -> Repair:
    return Repair(
        "special value", f"holds only where {', or where '.join(where)}", "", size, None, True
    )


def _restrictions(sides: Sides) -> Iterator[tuple[str, p.Sample]]:
    """Each quantity held at a special value: the small ones first, and 0 before any other."""
    bench = sides.bench
    known = [q for q in bench.known if isinstance(q, Quantity)]
    known.sort(key=lambda q: q not in bench.small)
    held = [(q, value, words) for q in known for value, words in _values(q)]
    for q, value, words in sorted(held, key=lambda one: one[1] != 0):
        low, high = q.facts.range
        if low <= value <= high:
            # A value outside the print's own condition says nothing of it.
            held_there = p.where(p.with_value(bench.points, q, value), bench.given)
            yield f"{q.name} = {words}", held_there


def _at_all(sides: Sides, points: p.Sample) -> bool:
    agree, _ = _agreement(sides, Values(Doubles(), points))
    return agree is not None and bool(agree.all())


def _on_branch(sides: Sides, points: p.Sample) -> bool:
    agree, branch = _agreement(sides, Values(Doubles(), points))
    return (
        agree is not None
        and branch is not None
        and branch.sum() >= _ENOUGH
        and bool(agree[branch].all())
    )


def _values(q: Quantity) -> list[tuple[float, str]]:
    if p.is_angle(q):
        return [(float(np.radians(degrees)), words) for degrees, words in _ANGLES]
    return [(0.0, "0"), (1.0, "1")]


def _agreement(sides: Sides, values: Values) -> tuple[Any, Any]:
    """Where all bad entries agree, and where the cosine of a derived angle is not negative.

    None where nothing is compared: neither side is defined, or all that is derived is 0.
    """
    agree = np.ones(values.count, dtype=bool)
    branch = None
    compared = False
    for place in sides.bad:
        printed, derived = sides.pair(place)
        error = np.abs(sides.bench.difference(values, printed, derived))
        wanted = values.array(derived)
        defined = np.isfinite(error)
        compared |= int(defined.sum()) >= _ENOUGH
        agree &= ~defined | (error <= CLOSE * sides.bench.scale(derived))
        if sides.bench.turns(derived) and sides.shape == (1, 1):
            branch = defined & (np.cos(wanted) >= 0)
    return (agree if compared and _tells(sides, values) else None), branch


def _tells(sides: Sides, values: Values) -> bool:
    """Whether something is left to agree on: with all lengths 0, all positions do."""
    places = sides.places
    if sides.shape == (4, 4):
        moved = sides.bad[0][1] == 3
        places = [(i, j) for i, j in places if i < 3 and (j == 3) == moved]
    return any(largest(np.abs(values.array(sides.pair(place)[1]))) > CLOSE for place in places)
