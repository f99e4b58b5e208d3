"""Orders in the small quantities: what a print keeps, and what of the same order it leaves out."""

from __future__ import annotations

from math import comb, factorial
from typing import Any

from armillary.algebra import scalar as s
from armillary.verify.audit.compare import DIGITS, Bench
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.points import with_small
from armillary.verify.audit.sides import Place, Sides, told

_STEP = "1e-10"
_SEEN = 1e-9  # of a coefficient of the series: less is what the step leaves over
_BEYOND = 2  # orders above the first missing one that are looked at


def mixed_order(sides: Sides, order: int) -> str:
    """Whether some entries keep terms of an order that others leave out; in words, or empty.

    Args:
        order: to which the print holds as a whole.
    """
    if not sides.bench.small:
        return ""
    lacks = [place for place in sides.places if _lacks(sides, place, order + 1)]
    if not lacks:
        return ""
    kept = []
    for k in range(order + 1, order + 1 + _BEYOND):
        keeps = [place for place in sides.places if place not in lacks and _keeps(sides, place, k)]
        if keeps:
            kept.append(f"{told(keeps)} {_verb(keeps, 'keep')} terms of order {k}")
    # A term with a wrong sign is told like one of several that were left out: both are not enough.
    others = [place for place in lacks if _keeps(sides, place, order + 1)]
    if others:
        kept.append(
            f"{told(others)} {_verb(others, 'print')} terms of order {order + 1} that are not "
            "those derived"
        )
    if not kept:
        return ""
    without = [place for place in lacks if place not in others]
    if without:
        kept.append(f"{told(without)} {_verb(without, 'lack')} those of order {order + 1}")
    return f"mixed order: {', '.join(kept)}"


def coefficient(bench: Bench, node: s.Scalar, k: int) -> Any:
    """The `k`-th coefficient of a value's series in the scale of the small quantities.

    One number per point, with 50 digits, by a central difference.
    """
    step = DIGITS.mp.mpf(_STEP)
    total = 0
    for j in range(k + 1):
        at = step * (DIGITS.mp.mpf(k) / 2 - j)
        values = Values(DIGITS, with_small(bench.first_few, bench.small, at))
        total = total + (-1) ** j * comb(k, j) * values.array(node)
    return total / (factorial(k) * step**k)


def _keeps(sides: Sides, place: Place, k: int) -> bool:
    printed, _ = sides.pair(place)
    return _size(coefficient(sides.bench, printed, k)) > _SEEN


def _lacks(sides: Sides, place: Place, k: int) -> bool:
    printed, derived = sides.pair(place)
    if sides.outcomes[place].exact:
        return False
    difference = coefficient(sides.bench, printed, k) - coefficient(sides.bench, derived, k)
    return _size(difference) > _SEEN


def _size(numbers: Any) -> float:
    sizes = [abs(x) for x in numbers if not DIGITS.mp.isnan(x)]
    return float(max(sizes, default=0))


def _verb(places: list[Place], word: str) -> str:
    return f"{word}s" if len(places) == 1 else word
