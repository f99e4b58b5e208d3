"""Two expressions compared: at many points in double precision, then at a few with 50 digits."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from armillary.algebra import scalar as s
from armillary.algebra.index import Index
from armillary.derivation.quantity import Quantity
from armillary.derivation.units import RADIAN, UnitError, UnitOf
from armillary.verify.audit import points as p
from armillary.verify.audit.numbers import Digits, Doubles
from armillary.verify.audit.numeric import Leaf, Values

CLOSE = 1e-9
EQUAL = 1e-40
# Beyond double precision nothing smaller would be met; 50 digits then say what it is.
_NEAR = 1e-4
_NEAR_CLOSE = 1e-7
_ROUNDING = 0.2  # part of the points at which doubles may fail what is equal
_SCALES = (1e-6, 1e-8)
_RANDOM, _EXACT, _MANY, _ENDS = 24, 6, 2000, 500
_BOUNDLESS = 1e6  # times the size of what is derived: no error of a bounded print is as large
DIGITS = Digits()


@dataclass(frozen=True)
class Outcome:
    """How far two expressions agree.

    Attributes:
        exact: whether they are equal wherever both are defined.
        order: the order in the small quantities to which they are; None where that has no meaning.
    """

    exact: bool
    order: int | None = None

    @property
    def holds(self) -> bool:
        """Equal, or equal at least to first order in the small quantities."""
        return self.exact or (self.order is not None and self.order >= 1)


class Bench:
    """The points at which the two sides of one print are compared.

    Args:
        sides: all expressions that will be compared.
        small: quantities that the paper takes as small.
        given: where the print says that it holds.
        pool: further quantities that repairs may bring in.
    """

    def __init__(
        self,
        sides: Sequence[object],
        small: Sequence[Quantity] = (),
        given: s.Condition | None = None,
        pool: Sequence[object] = (),
    ) -> None:
        self.known = p.quantities(*sides)
        everything = p.quantities(*sides, *pool)
        self.everything = everything
        self.small, self.given = tuple(small), given
        self.points = p.usual(everything, self.known, _RANDOM, 0, given)
        self.floats = Values(Doubles(), self.points)
        self._few = p.usual(everything, self.known, _EXACT, 2, given)
        self._scales: dict[s.Scalar, float] = {}
        self._units = UnitOf()

    @cached_property
    def near(self) -> Values:
        """The points with the small quantities much smaller."""
        return Values(Doubles(), p.with_small(self.points, self.small, _NEAR))

    @cached_property
    def digits(self) -> Values:
        """A few points, with 50 digits."""
        return Values(DIGITS, p.exact(self._few, DIGITS))

    @cached_property
    def shrinking(self) -> tuple[Values, Values]:
        """A few points, with the small quantities at two scales."""
        first, second = (
            Values(DIGITS, p.with_small(self.first_few, self.small, DIGITS.mp.mpf(str(scale))))
            for scale in _SCALES
        )
        return first, second

    @cached_property
    def first_few(self) -> dict[Leaf | Index, Any]:
        """The random ones of the points with 50 digits."""
        return p.exact(p.first(self._few, _EXACT), DIGITS)

    @cached_property
    def many(self) -> Values:
        """Many points, spread over the working ranges."""
        drawn = p.where(p.sample(self.everything, _MANY, 5), self.given)
        return Values(Doubles(), drawn)

    @cached_property
    def widest(self) -> Values:
        """Many points and ends of the ranges, for the size of an error: it is largest there."""
        drawn = p.joined(p.sample(self.everything, _MANY, 5), p.ends(self.everything, _ENDS, 6))
        return Values(Doubles(), p.where(drawn, self.given))

    def outcome(self, found: s.Scalar, wanted: s.Scalar) -> Outcome:
        """How far `found` agrees with `wanted`."""
        turns = self.turns(wanted) or self.turns(found)
        if self._agree(found, wanted, turns):
            return Outcome(exact=True)
        order = self.order(found, wanted, turns) if self.small else None
        return Outcome(exact=False, order=order)

    def tried(self, found: s.Scalar, wanted: s.Scalar) -> Outcome:
        """The same for a copy that is soon forgotten; most fail at the first, cheap look."""
        turns = self.turns(wanted)
        if self._agree(found, wanted, turns):
            return Outcome(exact=True)
        if self.small:
            far = self._far(self.near, found, wanted, turns, _NEAR_CLOSE)
            if far is not None and far.mean() <= _ROUNDING:
                return Outcome(exact=False, order=self.order(found, wanted, turns))
        return Outcome(exact=False)

    def order(self, found: s.Scalar, wanted: s.Scalar, turns: bool = False) -> int | None:
        """Order of the error in the small quantities, less one; None where there is no error.

        -1 says that the two differ where all small quantities are 0.
        """
        sizes = []
        for values in self.shrinking:
            with values.trying():
                error = self.difference(values, found, wanted, turns)
            sizes.append([abs(e) for e in error])
        mp = DIGITS.mp
        decades = np.log10(_SCALES[0] / _SCALES[1])
        slopes = []
        for large, little in zip(*sizes, strict=True):
            if mp.isnan(large) or mp.isnan(little) or large < mp.mpf("1e-52"):
                continue
            little = max(little, mp.mpf("1e-70"))
            slopes.append(float(mp.log10(large / little)) / decades)
        return round(min(slopes)) - 1 if slopes else None

    def difference(
        self, values: Values, found: s.Scalar, wanted: s.Scalar, turns: bool | None = None
    ) -> Any:
        """`found` less `wanted` at each point; angles that differ by whole turns are one."""
        with np.errstate(all="ignore"):
            error = values.array(found) - values.array(wanted)
            if turns is None:
                turns = self.turns(wanted)
            if not turns:
                return error
            turn = 2 * values.numbers.number(s.PI.value)
            return error - turn * _rounded(error / turn)

    def worst(self, found: s.Scalar, wanted: s.Scalar) -> float:
        """The largest error over the working ranges; infinite where it has no bound."""
        with self.widest.trying():
            error = np.abs(self.difference(self.widest, found, wanted))
        there = error[~np.isnan(error)]
        largest = float(there.max()) if len(there) else float("nan")
        return float("inf") if largest > _BOUNDLESS * self.scale(wanted) else largest

    def undefined(self, found: s.Scalar, wanted: s.Scalar) -> float:
        """The part of the working ranges where `wanted` has a value and `found` has none."""
        with self.many.trying(), np.errstate(all="ignore"):
            has, lacks = self.many.array(wanted), self.many.array(found)
            there = np.isfinite(has)
            missing = there & ~np.isfinite(lacks)
        return float(missing.sum() / max(1, there.sum()))

    # -- parts --------------------------------------------------------------------------------

    def turns(self, wanted: s.Scalar) -> bool:
        """Whether a value is an angle, of which whole turns do not count."""
        try:
            unit = self._units(wanted)
        except (UnitError, TypeError):
            return False
        return unit is not None and unit.agrees(RADIAN) and unit.angle == 1

    def scale(self, wanted: s.Scalar) -> float:
        """The largest value of the derived side at the random points, at least 1e-3."""
        if wanted not in self._scales:
            with np.errstate(all="ignore"):
                sizes = np.abs(self.floats.array(wanted))[:_RANDOM]
            finite = sizes[np.isfinite(sizes)]
            self._scales[wanted] = max(1e-3, float(finite.max()) if len(finite) else 0.0)
        return self._scales[wanted]

    def _agree(self, found: s.Scalar, wanted: s.Scalar, turns: bool) -> bool:
        """Whether two are equal: in doubles, where that is enough, and with 50 digits."""
        far = self._far(self.floats, found, wanted, turns, CLOSE)
        if far is None or far.mean() > _ROUNDING:
            return False
        if far.any():
            # At an awkward point doubles may have lost all digits: fifty settle it.
            left = {q: array[far] for q, array in self.points.items()}
            if not self._equal(Values(DIGITS, p.exact(left, DIGITS)), found, wanted, turns):
                return False
        with self.digits.trying():
            return self._equal(self.digits, found, wanted, turns)

    def _far(
        self, values: Values, found: s.Scalar, wanted: s.Scalar, turns: bool, bound: float
    ) -> Any:
        """The points at which two differ in doubles; None where they are never both defined."""
        with values.trying():
            error = np.abs(self.difference(values, found, wanted, turns))
        defined = np.isfinite(error)
        if not defined.any():
            return None
        return defined & ~(error <= bound * self.scale(wanted))

    def _equal(self, values: Values, found: s.Scalar, wanted: s.Scalar, turns: bool) -> bool:
        mp = DIGITS.mp
        error = [abs(e) for e in self.difference(values, found, wanted, turns)]
        defined = [e for e in error if not mp.isnan(e)]
        return bool(defined) and max(defined) <= EQUAL * self.scale(wanted)


def _rounded(turns: Any) -> Any:
    if turns.dtype == object:
        return np.frompyfunc(DIGITS.mp.nint, 1, 1)(turns)
    return np.round(turns)
