"""Units of scalars and blocks, in SI base units with the radian as a tag.

The radian has no dimension, so an arc may be a length; the tag only tells an angle from a ratio on
the page. What fails is what can never be right: sin(length), a length added to an angle.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import singledispatchmethod

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.direction import Azimuth, Elevation, OfDirection
from armillary.algebra.indexed import AnyOf, At, OneLike, Total, VectorAt, VectorTotal
from armillary.algebra.iteration import Iterated
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Elementary, Rotation, factors

_BASES = ("m", "kg", "s", "K", "A")


@dataclass(frozen=True)
class Unit:
    """Powers of metre, kilogram, second, kelvin and ampere; `angle` counts radians."""

    powers: tuple[Fraction, ...] = (Fraction(0),) * len(_BASES)
    angle: int = 0

    def __mul__(self, other: Unit) -> Unit:
        powers = tuple(a + b for a, b in zip(self.powers, other.powers, strict=True))
        return Unit(powers, self.angle + other.angle)

    def __truediv__(self, other: Unit) -> Unit:
        return self * other**-1

    def __pow__(self, exponent: int | Fraction) -> Unit:
        return Unit(tuple(p * exponent for p in self.powers), int(self.angle * exponent))

    @property
    def dimensionless(self) -> bool:
        return not any(self.powers)

    def agrees(self, other: Unit) -> bool:
        """Whether the two may be added: the radian does not count."""
        return self.powers == other.powers

    def __str__(self) -> str:
        # A radian times a length is an arc: the tag is shown only where nothing absorbs it.
        angle = self.angle if not self.powers[0] else 0
        parts = [("rad", Fraction(angle)), *zip(_BASES, self.powers, strict=True)]
        names = {m: n for n, m in _DERIVED.items()}
        if self.powers in names and not angle:
            return names[self.powers]
        up = [_power(n, p) for n, p in parts if p > 0]
        down = [_power(n, -p) for n, p in parts if p < 0]
        return ("*".join(up) or "1") + ("/" + "/".join(down) if down else "")


def _power(name: str, power: Fraction) -> str:
    return name if power == 1 else f"{name}^{power}"


def _unit(**powers: int) -> Unit:
    return Unit(tuple(Fraction(powers.get(base, 0)) for base in _BASES))


ONE = Unit()
RADIAN = Unit(angle=1)
METRE = _unit(m=1)
KILOGRAM = _unit(kg=1)
SECOND = _unit(s=1)
KELVIN = _unit(K=1)
NEWTON = _unit(kg=1, m=1, s=-2)
NEWTON_METRE = _unit(kg=1, m=2, s=-2)
WATT = _unit(kg=1, m=2, s=-3)
PASCAL = _unit(kg=1, m=-1, s=-2)
AMPERE = _unit(A=1)
OHM = _unit(kg=1, m=2, s=-3, A=-2)
_DERIVED = {
    "N": NEWTON.powers,
    "N*m": NEWTON_METRE.powers,
    "W": WATT.powers,
    "Pa": PASCAL.powers,
    "ohm": OHM.powers,
    "N*m/A": (NEWTON_METRE / AMPERE).powers,
}


_SUMS = (
    "every term of a sum needs one unit, and angles go into sines; "
    "check the symbols of this line in the notation table"
)
_POSE = "a position is made of lengths: multiply an angle by the length of its arm"
_TWIST = "Twist(angular, linear) takes an angular velocity in rad/s first, then a velocity in m/s"
_WRENCH = "Wrench(moment, force) takes a moment in N*m first, then a force in N"


class UnitError(Exception):
    """Two units do not fit."""

    def __init__(self, problem: str, mend: str = _SUMS) -> None:
        self.mend = mend
        super().__init__(problem)


class UnitOf:
    """Infers units; None stands for the number zero, which fits everywhere."""

    def __init__(self) -> None:
        self._done: dict[int, tuple[object, Unit | None]] = {}

    def __call__(self, node: s.Scalar | v.Vector) -> Unit | None:
        known = self._done.get(id(node))
        if known is None:
            known = (node, self.infer(node))
            self._done[id(node)] = known
        return known[1]

    def common(self, nodes: list[s.Scalar | v.Vector], what: str) -> Unit | None:
        found = [u for u in map(self, nodes) if u is not None]
        for other in found[1:]:
            if not found[0].agrees(other):
                raise UnitError(f"{what}: {found[0]} and {other} do not fit")
        return found[0] if found else None

    def _angle(self, node: s.Scalar, function: str) -> Unit:
        unit = self(node)
        if unit is not None and not unit.dimensionless:
            raise UnitError(
                f"{function} of a quantity in {unit}: it takes an angle",
                "divide by a quantity of the same unit, or correct the unit= of the symbol",
            )
        return ONE

    @singledispatchmethod
    def infer(self, node: object) -> Unit | None:
        raise TypeError(f"no unit rule for {type(node).__name__}")

    @infer.register
    def _(self, node: s.Number) -> Unit | None:
        return None if node.value == 0 else ONE

    @infer.register
    def _(self, node: s.Symbol) -> Unit | None:
        return getattr(node, "unit", ONE)

    @infer.register
    def _(self, node: s.Add) -> Unit | None:
        return self.common([node.left, node.right], "a sum")

    @infer.register
    def _(self, node: s.Multiply) -> Unit | None:
        left, right = self(node.left), self(node.right)
        return None if left is None or right is None else left * right

    @infer.register
    def _(self, node: s.Negate) -> Unit | None:
        return self(node.argument)

    @infer.register
    def _(self, node: s.Absolute) -> Unit | None:
        return self(node.argument)

    @infer.register
    def _(self, node: s.Divide) -> Unit | None:
        top, bottom = self(node.numerator), self(node.denominator)
        return None if top is None else top / (bottom or ONE)

    @infer.register
    def _(self, node: s.SquareRoot) -> Unit | None:
        unit = self(node.argument)
        return None if unit is None else unit ** Fraction(1, 2)

    @infer.register
    def _(self, node: s.Sine) -> Unit | None:
        return self._angle(node.argument, "the sine")

    @infer.register
    def _(self, node: s.Cosine) -> Unit | None:
        return self._angle(node.argument, "the cosine")

    @infer.register
    def _(self, node: s.ArcTangent) -> Unit | None:
        self.common([node.y, node.x], "atan2(y, x)")
        return RADIAN

    @infer.register
    def _(self, node: s.ArcSine | s.ArcCosine) -> Unit | None:
        unit = self(node.argument)
        if unit is not None and not unit.dimensionless:
            what = "sine" if isinstance(node, s.ArcSine) else "cosine"
            raise UnitError(
                f"the arc {what} of a quantity in {unit}: it takes a ratio",
                "divide by a quantity of the same unit, or correct the unit= of the symbol",
            )
        return RADIAN

    @infer.register
    def _(self, node: OfDirection) -> Unit | None:
        self(node.vector)
        return RADIAN if isinstance(node, (Azimuth, Elevation)) else ONE

    @infer.register
    def _(self, node: s.Select) -> Unit | None:
        self.condition(node.condition)
        return self.common([node.then, node.otherwise], "the two sides of a where")

    @infer.register
    def _(self, node: s.Component) -> Unit | None:
        return self(node.vector)

    @infer.register
    def _(self, node: s.Dot) -> Unit | None:
        left, right = self(node.left), self(node.right)
        return None if left is None or right is None else left * right

    @infer.register
    def _(self, node: Total | VectorTotal | At | VectorAt) -> Unit | None:
        return self(node.term)

    @infer.register
    def _(self, node: OneLike) -> Unit | None:
        return self(node.like)

    @infer.register
    def _(self, node: Iterated) -> Unit | None:
        given = node.iteration
        if id(given) not in self._done:
            self._done[id(given)] = (given, None)
            for unknown, start, after in zip(
                given.unknowns, given.start, given.following, strict=True
            ):
                what = f"the unknown {unknown.name}, its start and what a step makes of it"
                self.common([unknown, start, after], what)
        return self(node.unknown)

    @infer.register
    def _(self, node: s.ScalarReference) -> Unit | None:
        return self(node.expression)

    @infer.register
    def _(self, node: v.Components) -> Unit | None:
        return self.common(list(node.components), "the components of a vector")

    @infer.register
    def _(self, node: v.Basis) -> Unit | None:
        return ONE

    @infer.register
    def _(self, node: v.VectorSymbol) -> Unit | None:
        return getattr(node, "unit", ONE)

    @infer.register
    def _(self, node: v.VectorSum) -> Unit | None:
        return self.common([node.left, node.right], "a sum of vectors")

    @infer.register
    def _(self, node: v.VectorNegate) -> Unit | None:
        return self(node.argument)

    @infer.register
    def _(self, node: v.Scaled) -> Unit | None:
        factor, unit = self(node.factor), self(node.vector)
        return None if factor is None or unit is None else factor * unit

    @infer.register
    def _(self, node: v.Cross) -> Unit | None:
        left, right = self(node.left), self(node.right)
        return None if left is None or right is None else left * right

    @infer.register
    def _(self, node: v.Unit) -> Unit | None:
        self(node.vector)
        return ONE

    @infer.register
    def _(self, node: v.Rotated) -> Unit | None:
        self.rotation(node.rotation)
        return self(node.vector)

    @infer.register
    def _(self, node: v.Choice) -> Unit | None:
        return self(node.nested)

    @infer.register
    def _(self, node: v.VectorReference) -> Unit | None:
        return self(node.expression)

    def rotation(self, rotation: Rotation) -> None:
        """A rotation turns by angles."""
        for factor in factors(rotation):
            if isinstance(factor, Elementary):
                self._angle(factor.angle, "a rotation")

    def condition(self, condition: s.Condition) -> None:
        """Compare like with like."""
        if isinstance(condition, s.Less):
            self.common([condition.left, condition.right], "a comparison")
        elif isinstance(condition, s.Both):
            self.condition(condition.left)
            self.condition(condition.right)
        elif isinstance(condition, s.Not):
            self.condition(condition.argument)
        elif isinstance(condition, AnyOf):
            self.condition(condition.term)
        elif isinstance(condition, s.ConditionReference):
            self.condition(condition.expression)


Block = Pose | Twist | Wrench | Matrix | Rotation | s.Scalar | v.Vector | s.Condition


def check_block(value: Block) -> Unit | None:
    """Check a whole block; the unit of a scalar or vector is returned.

    Raises:
        UnitError: with the two units that do not fit.
    """
    units = UnitOf()
    if isinstance(value, (s.Scalar, v.Vector)):
        return units(value)
    if isinstance(value, s.Condition):
        units.condition(value)
    elif isinstance(value, Rotation):
        units.rotation(value)
    elif isinstance(value, Pose):
        units.rotation(value.rotation)
        _fits(units(value.position), METRE, "the position of a pose", _POSE)
    elif isinstance(value, Twist):
        _fits(units(value.angular), RADIAN / SECOND, "the angular part of a twist", _TWIST)
        _fits(units(value.linear), METRE / SECOND, "the linear part of a twist", _TWIST)
    elif isinstance(value, Wrench):
        _fits(units(value.moment), NEWTON_METRE, "the moment of a wrench", _WRENCH)
        _fits(units(value.force), NEWTON, "the force of a wrench", _WRENCH)
    else:
        for row in value.rows:
            for entry in row:
                units(entry)
    return None


def _fits(unit: Unit | None, wanted: Unit, what: str, mend: str) -> None:
    if unit is not None and not unit.agrees(wanted):
        raise UnitError(f"{what} is in {unit}, it should be in {wanted}", mend)
