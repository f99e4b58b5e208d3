"""What a kernel accepts: one guard for each scalar input, one more for each unit vector."""

from __future__ import annotations

from dataclasses import dataclass

from armillary.derivation.quantity import AnyQuantity, Kind

UNIT_SQUARE_TOLERANCE = 1e-3


@dataclass(frozen=True)
class Guard:
    """Bounds of one scalar input, or (with `norm`) of the square of a unit vector."""

    name: str
    index: int | None
    low: float
    high: float
    norm: bool = False


def guards_of(quantity: AnyQuantity) -> tuple[Guard, ...]:
    """The guards of one quantity."""
    low, high = quantity.facts.limits
    if quantity.shape == ():
        return (Guard(quantity.name, None, low, high),)
    found = [Guard(quantity.name, k, low, high) for k in range(3)]
    if quantity.facts.kind is Kind.UNIT_VECTOR:
        square = (1 - UNIT_SQUARE_TOLERANCE, 1 + UNIT_SQUARE_TOLERANCE)
        found.append(Guard(quantity.name, None, *square, norm=True))
    return tuple(found)
