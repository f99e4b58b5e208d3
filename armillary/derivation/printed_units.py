"""Rows of a paper's nomenclature: the unit that is printed beside a symbol."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix
from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.units import (
    KILOGRAM,
    METRE,
    NEWTON,
    ONE,
    PASCAL,
    RADIAN,
    SECOND,
    WATT,
    Unit,
)

# The order is that in which one is tried for another.
UNITS = {
    "kg": KILOGRAM,
    "m": METRE,
    "s": SECOND,
    "N": NEWTON,
    "Pa": PASCAL,
    "W": WATT,
    "rad": RADIAN,
    "deg": RADIAN,
}
_FACTOR = re.compile(r"([A-Za-z]+)(?:\^(\d+))?")

Factors = tuple[tuple[str, int], ...]


@dataclass(frozen=True, eq=False)
class InUnit:
    """A row that gives a quantity a unit.

    Attributes:
        value: what the symbol stands for in the derivation; the entries of a matrix have one unit.
        factors: the unit as it is written, each with its power: N m^2 is ("N", 1), ("m", 2).
    """

    key: str
    quote: str
    value: s.Scalar | v.Vector | Matrix
    factors: Factors
    source: Source


def factors_of(text: str, source: Source) -> Factors:
    """A unit as it is written, "N m^2" or "m^3/s"; "1", of a row without one, has no factors.

    Raises:
        DerivationError: for a unit that is not in `UNITS`, or more than one "/".
    """
    if text == "1":
        return ()
    made = []
    parts = text.split("/")
    for sign, part in zip((1, -1), parts, strict=False):
        for word in part.split():
            found = _FACTOR.fullmatch(word)
            if found is None or found[1] not in UNITS:
                known = ", ".join(UNITS)
                raise DerivationError(f"{word!r} is no unit", f"write {known}, as in N m^2", source)
            made.append((found[1], sign * int(found[2] or 1)))
    if len(parts) > 2 or not made:
        raise DerivationError(f"{text!r} is no unit", 'write "m/s^2", with one / at most', source)
    return tuple(made)


def product_of(factors: Factors) -> Unit:
    """The unit that is written."""
    return reduce(lambda made, one: made * UNITS[one[0]] ** one[1], factors, ONE)


def _plain(name: str, power: int) -> str:
    return f"{name}^{power}" if power > 1 else name


def written(
    factors: Factors, factor: Callable[[str, int], str] = _plain, between: str = " "
) -> str:
    """That unit as text, "m^3/s".

    Args:
        factor: writes a unit with its power, which is positive on either side of the stroke.
        between: stands between two of them.
    """
    up, down = (
        between.join(factor(name, abs(n)) for name, n in factors if n * sign > 0)
        for sign in (1, -1)
    )
    return f"{up or '1'}/{down}" if down else up or "1"
