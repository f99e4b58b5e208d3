"""Power series along a ray: each small quantity is multiplied by s, and s is expanded at 0.

A jet is the tuple of the coefficients of s^0, s^1, ... s^n. The coefficient of s^k is homogeneous
of degree k in the small quantities together, so a cut jet is consistent in order.
A node that stands on no small quantity is its own series: the node itself is kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from functools import singledispatch

from armillary.algebra import folding as f
from armillary.algebra import power_series as ps
from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.direction import Elevation, OfDirection, is_unit, of_the_same_length
from armillary.algebra.misuse import MisuseError
from armillary.algebra.power_series import ScalarJet, VectorJet
from armillary.algebra.rotation import (
    Composed,
    Elementary,
    Factor,
    Rotation,
    RotationSymbol,
    factors,
    rotate,
)
from armillary.algebra.scale import of_the_same_direction
from armillary.algebra.vanishing import refuse_zero, vanishes


class Jets:
    """Series of nodes in some small symbols, to one order; each node is visited once."""

    def __init__(self, small: Sequence[s.Symbol | v.VectorSymbol], order: int) -> None:
        self.order = order
        self._small = frozenset(small)
        self._depends: dict[int, tuple[object, bool]] = {}
        self._scalars: dict[s.Scalar, ScalarJet] = {}
        self._vectors: dict[v.Vector, VectorJet] = {}
        self._angles: dict[s.Scalar, tuple[ScalarJet, ScalarJet]] = {}
        self._directions: dict[v.Vector, v.Vector] = {}
        self._conditions: dict[s.Condition, s.Condition | bool] = {}

    def scalar(self, node: s.Scalar) -> ScalarJet:
        if node not in self._scalars:
            self._scalars[node] = _scalar(node, self) if self.depends(node) else self.still(node)
        return self._scalars[node]

    def vector(self, node: v.Vector) -> VectorJet:
        if node not in self._vectors:
            moved = self.depends(node)
            self._vectors[node] = _vector(node, self) if moved else self.still_vector(node)
        return self._vectors[node]

    def still(self, node: s.Scalar) -> ScalarJet:
        """The series of what does not change."""
        return (node, *[s.ZERO] * self.order)

    def still_vector(self, node: v.Vector) -> VectorJet:
        """The series of a vector that does not change."""
        return (node, *[v.NULL] * self.order)

    def depends(self, node: object) -> bool:
        """Whether a small quantity stands anywhere below a node."""
        known = self._depends.get(id(node))
        if known is None:
            known = (node, self._looked(node))  # the node is held, so its id stays its own
            self._depends[id(node)] = known
        return known[1]

    def _looked(self, node: object) -> bool:
        if isinstance(node, (s.Symbol, v.VectorSymbol)):
            return node in self._small
        if isinstance(node, RotationSymbol):
            return False
        if isinstance(node, v.Choice):
            return self.depends(node.nested)
        if isinstance(node, tuple):
            return any(self.depends(part) for part in node)
        if not hasattr(node, "__dataclass_fields__"):
            return False
        return any(self.depends(getattr(node, field.name)) for field in fields(node))  # type: ignore[arg-type]

    def sine_cosine(self, angle: s.Scalar) -> tuple[ScalarJet, ScalarJet]:
        """Sine and cosine of an angle, together, as each derivative needs the other."""
        if angle not in self._angles:
            jet = self.scalar(angle)
            self._angles[angle] = ps.wave(jet, f.sine(jet[0]), f.cosine(jet[0]))
        return self._angles[angle]

    # ---- lengths and turns ----

    def half_square(self, node: v.Vector) -> ScalarJet:
        """Half the square of a length; a turn and a sign leave it alone."""
        inner = of_the_same_length(node)
        if isinstance(inner, (v.Basis, v.Unit)):
            return self.still(ps.HALF)
        return ps.half_square(self.vector(inner), f.dot)

    def norm(self, node: v.Vector) -> ScalarJet:
        """The length of a vector."""
        half = self.half_square(node)
        first = f.root(f.times(s.number(2), half[0]))
        inner = self.vector(of_the_same_length(node))[0]
        if isinstance(first, s.SquareRoot):
            first = v.norm(inner)  # the node that every length is
        refuse_zero(half[0], "the length of a vector", node)
        return ps.root(first, half)

    def direction(self, node: v.Vector) -> v.Vector:
        """A vector of the same direction that need not be normalised."""
        if node not in self._directions:
            self._directions[node] = of_the_same_direction(node)
        return self._directions[node]

    def rotated(self, rotation: Rotation, jet: VectorJet) -> VectorJet:
        """A series carried by a rotation: whole where nothing is small, a series where it is."""
        if not self.depends(rotation):
            return tuple(rotate(rotation, w) for w in jet)
        held: list[Factor] = []
        for factor in reversed(factors(rotation)):
            if not (isinstance(factor, Elementary) and self.depends(factor)):
                held.insert(0, factor)
                continue
            jet = self.turned(factor, _carried(held, jet))
            held = []
        return _carried(held, jet)

    def turned(self, turn: Elementary, jet: VectorJet) -> VectorJet:
        """One elementary rotation by a small angle, or by a finite angle and a small rest.

        The rest d is about the same axis e: 1 + sin(d) e x + (1 - cos(d)) e x e x.
        """
        angle = self.scalar(turn.angle)
        if not s.is_zero(angle[0]):
            jet = _carried([Elementary(turn.axis, angle[0])], jet)
        up, down = ps.wave((s.ZERO, *angle[1:]), s.ZERO, s.ONE)
        away = (s.ZERO, *(f.negative(c) for c in down[1:]))
        once = tuple(f.turned(turn.axis, w) for w in jet)
        twice = tuple(f.turned(turn.axis, w) for w in once)
        first, second = ps.scaled(up, once), ps.scaled(away, twice)
        return tuple(map(f.plus_vector, map(f.plus_vector, jet, first), second))

    # ---- conditions ----

    def condition(self, node: s.Condition) -> s.Condition | bool:
        """A condition with every small quantity at 0; a truth value where that decides it."""
        if not self.depends(node):
            return node
        if node not in self._conditions:
            self._conditions[node] = self._at_zero(node)
        return self._conditions[node]

    def _at_zero(self, node: s.Condition) -> s.Condition | bool:
        if isinstance(node, s.ConditionReference):
            return self.condition(node.expression)
        if isinstance(node, s.Not):
            inner = self.condition(node.argument)
            return not inner if isinstance(inner, bool) else s.Not(inner)
        if isinstance(node, s.Both):
            left, right = self.condition(node.left), self.condition(node.right)
            if isinstance(left, bool):
                return left and right
            if isinstance(right, bool):
                return right and left
            return s.Both(left, right)
        if not isinstance(node, s.Less):
            raise TypeError(f"no series of {type(node).__name__}")
        low, high = self.scalar(node.left)[0], self.scalar(node.right)[0]
        if vanishes(f.plus(low, f.negative(high))):
            raise MisuseError(
                "a condition changes where the small quantities are 0: "
                "there is no one expansion on both sides",
                "expand each side of the where by itself",
            )
        if isinstance(low, s.Number) and isinstance(high, s.Number):
            return bool(low.value < high.value)
        return s.Less(low, high)


def _carried(held: Sequence[Factor], jet: VectorJet) -> VectorJet:
    """A series carried by turns that are not small."""
    if not held:
        return jet
    rotation = held[0] if len(held) == 1 else Composed(tuple(held))
    return tuple(rotate(rotation, w) for w in jet)


@singledispatch
def _scalar(node: s.Scalar, jets: Jets) -> ScalarJet:
    explicit = getattr(node, "explicit", None)
    if explicit is None:
        raise TypeError(f"no series of {type(node).__name__}")
    return jets.scalar(explicit())


@_scalar.register
def _(node: s.Symbol, jets: Jets) -> ScalarJet:
    return (s.ZERO, node, *[s.ZERO] * (jets.order - 1))


@_scalar.register
def _(node: s.Add, jets: Jets) -> ScalarJet:
    return tuple(map(f.plus, jets.scalar(node.left), jets.scalar(node.right)))


@_scalar.register
def _(node: s.Multiply, jets: Jets) -> ScalarJet:
    if node.left is node.right:
        return ps.square(jets.scalar(node.left), f.times)
    return ps.product(jets.scalar(node.left), jets.scalar(node.right), f.times)


@_scalar.register
def _(node: s.Negate, jets: Jets) -> ScalarJet:
    return tuple(f.negative(c) for c in jets.scalar(node.argument))


@_scalar.register
def _(node: s.Divide, jets: Jets) -> ScalarJet:
    denominator = jets.scalar(node.denominator)
    refuse_zero(denominator[0], "a denominator", node.denominator)
    return ps.quotient(jets.scalar(node.numerator), denominator)


@_scalar.register
def _(node: s.SquareRoot, jets: Jets) -> ScalarJet:
    inner = node.argument
    if isinstance(inner, s.Dot) and inner.left is inner.right:
        return jets.norm(inner.left)
    jet = jets.scalar(inner)
    refuse_zero(jet[0], "what stands under a square root", inner)
    half = tuple(f.times(ps.HALF, c) for c in jet)
    return ps.root(f.root(jet[0]), half)


@_scalar.register
def _(node: s.Sine, jets: Jets) -> ScalarJet:
    return jets.sine_cosine(node.argument)[0]


@_scalar.register
def _(node: s.Cosine, jets: Jets) -> ScalarJet:
    return jets.sine_cosine(node.argument)[1]


@_scalar.register
def _(node: s.ArcTangent, jets: Jets) -> ScalarJet:
    y, x = jets.scalar(node.y), jets.scalar(node.x)
    square = tuple(map(f.plus, ps.square(x, f.times), ps.square(y, f.times)))
    refuse_zero(square[0], "the point of an atan2", node)
    return ps.arc_tangent(y, x, square)


@_scalar.register
def _(node: s.ArcSine, jets: Jets) -> ScalarJet:
    cosine = jets.scalar(node.cosine())
    return ps.arc_sine(jets.scalar(node.argument), cosine)


@_scalar.register
def _(node: s.ArcCosine, jets: Jets) -> ScalarJet:
    return jets.scalar(node.explicit())


@_scalar.register
def _(node: OfDirection, jets: Jets) -> ScalarJet:
    return jets.scalar(replace(node, vector=jets.direction(node.vector)).explicit())


@_scalar.register
def _(node: Elevation, jets: Jets) -> ScalarJet:
    # The square of the length is kept by every turn: most of its terms are never made.
    vector = jets.direction(node.vector)
    explicit = Elevation(vector).explicit()
    assert isinstance(explicit, s.ArcTangent)
    y, x = jets.scalar(explicit.y), jets.scalar(explicit.x)
    if is_unit(vector):
        return ps.arc_tangent(y, x, jets.still(s.ONE))
    square = tuple(f.times(s.number(2), c) for c in jets.half_square(vector))
    refuse_zero(square[0], "the length of a vector", vector)
    return ps.arc_tangent(y, x, square)


@_scalar.register
def _(node: s.Absolute, jets: Jets) -> ScalarJet:
    jet = jets.scalar(node.argument)
    refuse_zero(jet[0], "an absolute value", node.argument)
    if isinstance(jet[0], s.Number):
        return tuple(f.negative(c) for c in jet) if jet[0].value < 0 else jet
    below = s.Less(jet[0], s.ZERO)
    later = [c if s.is_zero(c) else s.Select(below, f.negative(c), c) for c in jet[1:]]
    return (s.Absolute(jet[0]), *later)


@_scalar.register
def _(node: s.Select, jets: Jets) -> ScalarJet:
    condition = jets.condition(node.condition)
    if isinstance(condition, bool):
        return jets.scalar(node.then if condition else node.otherwise)
    then, otherwise = jets.scalar(node.then), jets.scalar(node.otherwise)
    return tuple(
        t if t is o or (s.is_zero(t) and s.is_zero(o)) else s.Select(condition, t, o)
        for t, o in zip(then, otherwise, strict=True)
    )


@_scalar.register
def _(node: s.Component, jets: Jets) -> ScalarJet:
    return tuple(v.component(w, node.index) for w in jets.vector(node.vector))


@_scalar.register
def _(node: s.Dot, jets: Jets) -> ScalarJet:
    if node.left is node.right:
        return ps.square(jets.vector(of_the_same_length(node.left)), f.dot)
    return ps.product(jets.vector(node.left), jets.vector(node.right), f.dot)


@_scalar.register
def _(node: s.ScalarReference, jets: Jets) -> ScalarJet:
    return jets.scalar(node.expression)


@singledispatch
def _vector(node: v.Vector, jets: Jets) -> VectorJet:
    raise TypeError(f"no series of {type(node).__name__}")


@_vector.register
def _(node: v.Components, jets: Jets) -> VectorJet:
    columns = zip(*(jets.scalar(c) for c in node.components), strict=True)
    return tuple(
        v.NULL if all(s.is_zero(c) for c in (x, y, z)) else v.Components((x, y, z))
        for x, y, z in columns
    )


@_vector.register
def _(node: v.VectorSymbol, jets: Jets) -> VectorJet:
    return (v.NULL, node, *[v.NULL] * (jets.order - 1))


@_vector.register
def _(node: v.VectorSum, jets: Jets) -> VectorJet:
    return tuple(map(f.plus_vector, jets.vector(node.left), jets.vector(node.right)))


@_vector.register
def _(node: v.VectorNegate, jets: Jets) -> VectorJet:
    return tuple(f.negative_vector(w) for w in jets.vector(node.argument))


@_vector.register
def _(node: v.Scaled, jets: Jets) -> VectorJet:
    return ps.scaled(jets.scalar(node.factor), jets.vector(node.vector))


@_vector.register
def _(node: v.Cross, jets: Jets) -> VectorJet:
    return ps.cross(jets.vector(node.left), jets.vector(node.right))


@_vector.register
def _(node: v.Unit, jets: Jets) -> VectorJet:
    return ps.direction(jets.vector(node.vector), jets.norm(node.vector))


@_vector.register
def _(node: v.Rotated, jets: Jets) -> VectorJet:
    return jets.rotated(node.rotation, jets.vector(node.vector))


@_vector.register
def _(node: v.Choice, jets: Jets) -> VectorJet:
    return jets.vector(node.nested)


@_vector.register
def _(node: v.VectorReference, jets: Jets) -> VectorJet:
    return jets.vector(node.expression)
