"""The two boxes of a quantity: limits, beyond which it is refused, and the range where it works."""

from __future__ import annotations

import math

from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.quantity import Kind

Box = tuple[float, float]
WIDEST = 1e30


def check_limits(name: str, kind: Kind, limits: Box, source: Source) -> None:
    """Limits are an interval that single precision can hold, and what the kind allows."""
    _check_interval(name, "limits", limits, source)
    if kind is Kind.NON_NEGATIVE and limits[0] < 0:
        raise DerivationError(
            f"{name} is never negative, but its limits= begin at {limits[0]:g}",
            "begin them at 0; what may be negative is declared with "
            "d.scalar(..., unit=...), which takes any limits",
            source,
        )


def check_range(name: str, range: Box, limits: Box, source: Source) -> None:
    """A range is an interval inside the limits."""
    _check_interval(name, "range", range, source)
    if not (limits[0] <= range[0] and range[1] <= limits[1]):
        raise DerivationError(
            f"the range of {name}, {_told(range)}, is not inside its limits {_told(limits)}",
            "narrow range=, or widen limits=",
            source,
        )


def range_within(usual: Box, limits: Box) -> Box:
    """The usual range as far as the limits admit it; all of them if they admit nothing of it."""
    low, high = max(usual[0], limits[0]), min(usual[1], limits[1])
    return (low, high) if low < high else limits


def _check_interval(name: str, which: str, box: object, source: Source) -> None:
    problem = _problem(box)
    if problem is not None:
        raise DerivationError(
            f"{which}= of {name} {problem}", f"write {which}=(low, high), in SI units", source
        )


def _problem(box: object) -> str | None:
    if not isinstance(box, (tuple, list)) or len(box) != 2:
        return "is not a pair of numbers"
    for bound in box:
        if isinstance(bound, bool) or not isinstance(bound, (int, float)):
            return "is not a pair of numbers"
        if not math.isfinite(bound):
            return f"holds {bound}, which is not finite"
        if abs(bound) > WIDEST:
            return f"holds {bound:g}, which is beyond {WIDEST:g} and near the end of f32"
    low, high = box
    return None if low < high else f"is {_told((low, high))}: the first must be the smaller"


def _told(box: Box) -> str:
    return f"({box[0]:g}, {box[1]:g})"
