"""How a derivation declares its quantities."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armillary.algebra.index import Index
from armillary.derivation.boxes import check_limits, check_range, range_within
from armillary.derivation.checking import check_meaning, check_per
from armillary.derivation.errors import DerivationError, caller
from armillary.derivation.names import check_name
from armillary.derivation.naming import latex_name
from armillary.derivation.quantity import (
    Facts,
    Kind,
    Quantity,
    Rate,
    Role,
    RotationQuantity,
    VectorQuantity,
    default_limits,
    default_range,
)
from armillary.derivation.units import METRE, ONE, RADIAN, SECOND, Unit

if TYPE_CHECKING:
    from armillary.derivation.record import Derivation


class Quantities:
    """Declares quantities of one role: `d.length(...)` inputs, `d.parameter.length(...)`."""

    def __init__(self, record: Derivation, role: Role, rate: Rate) -> None:
        self._record, self._role, self._rate = record, role, rate

    def scalar(
        self,
        name: str,
        meaning: str,
        *,
        unit: Unit = ONE,
        rate: Rate | None = None,
        kind: Kind = Kind.REAL,
        limits: tuple[float, float] | None = None,
        range: tuple[float, float] | None = None,
        latex: str | None = None,
        per: Index | None = None,
    ) -> Quantity:
        """A scalar in any unit; `limits` are refused beyond, `range` is where it works.

        With `per`, each part of an index has one: an array in every language.
        """
        facts = self._facts(name, meaning, unit, rate, kind, limits, range, latex, per)
        return self._record._declare(Quantity(name, facts, self._record._make_rate, {}))

    def angle(self, name: str, meaning: str, **more: object) -> Quantity:
        """An angle in radians; every finite angle up to 1000 rad is legal."""
        return self.scalar(name, meaning, unit=RADIAN, **more)  # type: ignore[arg-type]

    def length(self, name: str, meaning: str, **more: object) -> Quantity:
        """A length in metres that may not be negative."""
        return self.scalar(name, meaning, unit=METRE, kind=Kind.NON_NEGATIVE, **more)  # type: ignore[arg-type]

    def time(self, name: str, meaning: str, **more: object) -> Quantity:
        """A time in seconds."""
        return self.scalar(name, meaning, unit=SECOND, **more)  # type: ignore[arg-type]

    def vector(
        self,
        name: str,
        meaning: str,
        *,
        unit: Unit = ONE,
        rate: Rate | None = None,
        kind: Kind = Kind.REAL,
        limits: tuple[float, float] | None = None,
        range: tuple[float, float] | None = None,
        latex: str | None = None,
        per: Index | None = None,
    ) -> VectorQuantity:
        """A vector of three components in one unit; with `per`, one for each part of an index."""
        facts = self._facts(name, meaning, unit, rate, kind, limits, range, latex, per)
        return self._record._declare(VectorQuantity(name, facts, self._record._make_rate, {}))

    def unit_vector(self, name: str, meaning: str, **more: object) -> VectorQuantity:
        """A vector of norm 1; refused when its square is off by more than 1e-3."""
        if more.get("per") is not None:
            raise DerivationError(
                f"{name} is a unit vector per {more['per']}, which no kernel takes",
                "give d.vector(..., per=...) and normalise it with unit(...)",
                caller(),
            )
        return self.vector(name, meaning, kind=Kind.UNIT_VECTOR, **more)  # type: ignore[arg-type]

    def rotation(
        self, name: str, meaning: str, *, rate: Rate | None = None, latex: str | None = None
    ) -> RotationQuantity:
        """A rotation, by the nine entries of its matrix; refused when they are of no rotation.

        That is: a column's square, or two columns' dot product, off by more than 1e-3, or a
        reflection.
        """
        facts = self._facts(name, meaning, ONE, rate, Kind.ROTATION, None, None, latex, None)
        return self._record._declare(RotationQuantity(name, facts))

    def _facts(
        self,
        name: str,
        meaning: str,
        unit: Unit,
        rate: Rate | None,
        kind: Kind,
        limits: tuple[float, float] | None,
        range: tuple[float, float] | None,
        latex: str | None,
        per: Index | None,
    ) -> Facts:
        source = caller()
        check_name(name, "quantity", source)
        check_per(self._record, name, per, source)
        check_meaning(name, meaning, source)
        if limits is None:
            limits = default_limits(unit, kind)
        check_limits(name, kind, limits, source)
        if range is None:
            range = range_within(default_range(unit, kind), limits)
        check_range(name, range, limits, source)
        return Facts(
            meaning=meaning,
            unit=unit,
            rate=rate or self._rate,
            role=self._role,
            kind=kind,
            limits=limits,
            range=range,
            latex=latex or latex_name(name),
            source=source,
            per=per,
        )
