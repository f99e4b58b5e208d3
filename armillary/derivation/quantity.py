"""Quantities: what a derivation starts from, with meaning, unit, limits, range and rate."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum

import sympy

from armillary.algebra.index import Index
from armillary.algebra.indexed import Table
from armillary.algebra.rotation import RotationSymbol
from armillary.algebra.scalar import ZERO, Scalar, Symbol
from armillary.algebra.vector import AXIS_NAMES, NULL, Vector, VectorSymbol
from armillary.derivation.errors import DerivationError, Source, caller
from armillary.derivation.units import METRE, ONE, RADIAN, Unit


class Rate(Enum):
    """How often a quantity changes."""

    MOUNT = "mount"
    DAY = "day"
    TICK = "tick"


class Role(Enum):
    """How a quantity enters a kernel.

    A state is kept from call to call; an unknown has a value only inside an iteration.
    """

    INPUT = "input"
    PARAMETER = "parameter"
    CONSTANT = "constant"
    STATE = "state"
    UNKNOWN = "unknown"


class Kind(Enum):
    """What values have a physical meaning."""

    REAL = "real"
    NON_NEGATIVE = "non-negative"
    UNIT_VECTOR = "unit vector"
    ROTATION = "rotation"


@dataclass(frozen=True)
class Facts:
    """What is known of a quantity beside its name.

    `limits` bound what a kernel accepts; `range` is where error bounds are stated. `per` is the
    index of the like parts that have a value each.
    """

    meaning: str
    unit: Unit
    rate: Rate
    role: Role
    kind: Kind
    limits: tuple[float, float]
    range: tuple[float, float]
    latex: str
    source: Source
    per: Index | None = None


Box = tuple[float, float] | None
RateMaker = Callable[
    ["Quantity | VectorQuantity", str | None, str | None, Box, Box], "Symbol | VectorSymbol"
]


@dataclass(frozen=True, eq=False, repr=False)
class Quantity(Symbol):
    """A scalar quantity of a derivation."""

    facts: Facts
    make_rate: RateMaker
    known_rate: dict[str, Symbol]

    @property
    def unit(self) -> Unit:
        return self.facts.unit

    @property
    def per(self) -> Index | None:
        return self.facts.per

    @property
    def shape(self) -> tuple[int, ...]:
        return (self.per.size,) if self.per else ()

    @property
    def parts(self) -> tuple[str, ...]:
        """The names that its components have in printed code, row-major."""
        return _numbered(self.name, self.per)

    def rate(
        self,
        name: str | None = None,
        meaning: str | None = None,
        *,
        limits: Box = None,
        range: Box = None,
    ) -> Symbol:
        """The time derivative as a quantity of its own, `<name>_dot` unless named.

        Args:
            limits: it is refused beyond; the wide box of its unit, if not given.
            range: where it works; what is usual for its unit, if not given.

        Raises:
            DerivationError: if it has a rate already, of another name, meaning or box.
        """
        if "rate" not in self.known_rate:
            made = self.make_rate(self, name, meaning, limits, range)
            assert isinstance(made, Symbol)
            self.known_rate["rate"] = made
        _must_be_the_same(self.name, self.known_rate["rate"], name, meaning, limits, range)
        return self.known_rate["rate"]

    def velocity(self) -> Scalar:
        """Its time derivative: zero unless it changes from tick to tick or was given a rate."""
        if "rate" in self.known_rate:
            return self.known_rate["rate"]
        _must_be_held(self.name, self.facts)
        return ZERO


@dataclass(frozen=True, eq=False, repr=False)
class VectorQuantity(VectorSymbol):
    """A vector quantity of a derivation."""

    facts: Facts
    make_rate: RateMaker
    known_rate: dict[str, VectorSymbol]

    @property
    def unit(self) -> Unit:
        return self.facts.unit

    @property
    def per(self) -> Index | None:
        return self.facts.per

    @property
    def shape(self) -> tuple[int, ...]:
        return (self.per.size, 3) if self.per else (3,)

    @property
    def parts(self) -> tuple[str, ...]:
        """The names that its components have in printed code, row-major."""
        names = _numbered(self.name, self.per)
        return tuple(f"{name}_{axis}" for name in names for axis in AXIS_NAMES)

    @property
    def unit_norm(self) -> bool:
        return self.facts.kind is Kind.UNIT_VECTOR

    def rate(
        self,
        name: str | None = None,
        meaning: str | None = None,
        *,
        limits: Box = None,
        range: Box = None,
    ) -> VectorSymbol:
        """The time derivative as a quantity of its own, `<name>_dot` unless named.

        Args:
            limits: it is refused beyond; the wide box of its unit, if not given.
            range: where it works; what is usual for its unit, if not given.

        Raises:
            DerivationError: if it has a rate already, of another name, meaning or box.
        """
        if "rate" not in self.known_rate:
            made = self.make_rate(self, name, meaning, limits, range)
            assert isinstance(made, VectorSymbol)
            self.known_rate["rate"] = made
        _must_be_the_same(self.name, self.known_rate["rate"], name, meaning, limits, range)
        return self.known_rate["rate"]

    def velocity(self) -> Vector:
        """Its time derivative: null unless it changes from tick to tick or was given a rate."""
        if "rate" in self.known_rate:
            return self.known_rate["rate"]
        _must_be_held(self.name, self.facts)
        return NULL


@dataclass(frozen=True, eq=False, repr=False)
class RotationQuantity(RotationSymbol):
    """A rotation of a derivation, given by the entries of its matrix."""

    facts: Facts

    @property
    def unit(self) -> Unit:
        return self.facts.unit

    @property
    def shape(self) -> tuple[int, ...]:
        return (3, 3)

    @property
    def parts(self) -> tuple[str, ...]:
        """The names that its components have in printed code, row-major."""
        return tuple(f"{self.name}_{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3))

    @property
    def known_rate(self) -> dict[str, Symbol]:
        """None: a rotation that moves is built from quantities that have rates."""
        return {}

    def velocity(self) -> Vector:
        """Its angular velocity: null, for it must be held."""
        if _moves(self.facts):
            raise DerivationError(
                f"{self.name} changes every tick, and a rotation has no rate",
                "declare it with rate=Rate.DAY or Rate.MOUNT if it is held, "
                "or build it from angles, which have rates",
                self.facts.source,
            )
        return NULL


def _numbered(name: str, per: Index | None) -> tuple[str, ...]:
    """The name, or one for each part; parts are counted from 1, as papers do."""
    return tuple(f"{name}_{k + 1}" for k in range(per.size)) if per else (name,)


@dataclass(frozen=True, eq=False, repr=False)
class ConstantTable(Table):
    """A named number of the derivation for each part, exact, with a unit."""

    facts: Facts

    @property
    def unit(self) -> Unit:
        return self.facts.unit


@dataclass(frozen=True, eq=False, repr=False)
class Constant(Symbol):
    """A named number of the derivation, exact, with a unit."""

    value: sympy.Expr
    facts: Facts

    @property
    def unit(self) -> Unit:
        return self.facts.unit


def _moves(facts: Facts) -> bool:
    return facts.role is Role.INPUT and facts.rate is Rate.TICK


def _must_be_held(name: str, facts: Facts) -> None:
    """A quantity without a rate may be differentiated only if it does not move."""
    if _moves(facts):
        raise DerivationError(
            f"{name} changes every tick, but it has no rate to differentiate with",
            f"write {name}_dot = {name}.rate() before differentiating, "
            "or declare it with rate=Rate.DAY or Rate.MOUNT if it is held",
            facts.source,
        )


def _must_be_the_same(
    of: str,
    known: Symbol | VectorSymbol,
    name: str | None,
    meaning: str | None,
    limits: Box,
    range: Box,
) -> None:
    """A quantity has one rate: asking again may not ask for another name, meaning or box."""
    assert isinstance(known, (Quantity, VectorQuantity))
    facts = known.facts
    asked = ((name, known.name), (meaning, facts.meaning))
    boxes = (("limits", limits, facts.limits), ("range", range, facts.range))
    other = [(word, has) for word, box, has in boxes if box is not None and tuple(box) != has]
    if not other and all(wanted in (None, has) for wanted, has in asked):
        return
    told = "".join(f" with the {word} {has[0]:g} to {has[1]:g}" for word, has in other[:1])
    raise DerivationError(
        f"{of} already has the rate {known.name} ({facts.meaning}){told}",
        f"name it where it is first made, at {facts.source}, or ask for it by {of}.rate() alone",
        caller(),
    )


AnyQuantity = Quantity | VectorQuantity | RotationQuantity


def default_limits(unit: Unit, kind: Kind) -> tuple[float, float]:
    """The wide box of a unit: beyond it an input is refused."""
    if kind in (Kind.UNIT_VECTOR, Kind.ROTATION):
        return (-1.001, 1.001)
    wide = 1e3 if unit.agrees(ONE) else 1e6
    return (0.0 if kind is Kind.NON_NEGATIVE else -wide, wide)


def default_range(unit: Unit, kind: Kind) -> tuple[float, float]:
    """The working range of a unit: what trackers are made of."""
    if kind in (Kind.UNIT_VECTOR, Kind.ROTATION):
        return (-1.0, 1.0)
    half = {RADIAN: 3.2, METRE: 10.0}.get(unit, 1.0)
    return (0.0 if kind is Kind.NON_NEGATIVE else -half, half)
