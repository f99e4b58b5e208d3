"""Shapes of an expression that have a shorter name on paper than their nodes would give."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix, Pose
from armillary.algebra.rotation import Elementary, Rotation, RotationSymbol, factors

# Multiples of pi with these denominators are printed as such; other angles in degrees.
_PLAIN_PARTS = (1, 2, 3, 4, 6, 8, 12)


def number_latex(value: sympy.Expr) -> str:
    """An exact number: decimals as decimals, angles in degrees where those are rounder."""
    if value.is_Rational:
        return rational_latex(Fraction(int(value.p), int(value.q)))
    turns = sympy.nsimplify(value / sympy.pi) if value.has(sympy.pi) else None
    if turns is not None and turns.is_Rational:
        part = Fraction(int(turns.p), int(turns.q))
        if part.denominator in _PLAIN_PARTS:
            return str(sympy.latex(value))
        if _is_decimal(part * 180):
            return rf"{rational_latex(part * 180)}^\circ"
    return str(sympy.latex(value))


def rational_latex(value: Fraction) -> str:
    """A rational number, as a decimal where that ends soon."""
    if value.denominator == 1:
        return str(value.numerator)
    if not _is_decimal(value):
        sign = "-" if value < 0 else ""
        return rf"{sign}\tfrac{{{abs(value.numerator)}}}{{{value.denominator}}}"
    digits = f"{float(abs(value)):.15g}"
    if abs(value) >= Fraction(1, 10**6) and "e" in digits:
        digits = f"{float(abs(value)):.15f}".rstrip("0")
    if "e" in digits:
        mantissa, power = digits.split("e")
        digits = rf"{mantissa} \cdot 10^{{{int(power)}}}".removeprefix(r"1 \cdot ")
    return f"-{digits}" if value < 0 else digits


def _is_decimal(value: Fraction) -> bool:
    rest = value.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest == 1 and value.denominator <= 10**15


def same(left: s.Scalar, right: s.Scalar) -> bool:
    """Whether two factors are one value, so that their product is a square."""
    if left is right:
        return True
    if isinstance(left, s.Component) and isinstance(right, s.Component):
        return left.vector is right.vector and left.index == right.index
    if isinstance(left, (s.Sine, s.Cosine)) and type(left) is type(right):
        return left.argument is right.argument
    return False


def wrapped_angle(node: s.ArcTangent) -> s.Scalar | None:
    """The angle that `wrap` was given."""
    y, x = node.y, node.x
    if isinstance(y, s.Sine) and isinstance(x, s.Cosine) and y.argument is x.argument:
        return y.argument
    return None


def full_turn_of(node: s.Select) -> s.Scalar | None:
    """The angle that `full_turn` was given."""
    inner = node.then
    if not (s.is_zero(node.otherwise) and isinstance(inner, s.Select)):
        return None
    test, outer = inner.condition, node.condition
    if not (isinstance(test, s.Less) and s.is_zero(test.right) and test.left is inner.otherwise):
        return None
    return inner.otherwise if isinstance(outer, s.Less) and outer.left is inner else None


def chain_steps(pose: Pose) -> list[Elementary | v.Vector] | None:
    """The translations and rotations whose product a pose is; None when it is no such product."""
    rest = _turns(pose.rotation)
    if rest is None:
        return None
    steps: list[Elementary | v.Vector] = []
    position = pose.position.nested if isinstance(pose.position, v.Choice) else pose.position
    while not v.is_null(position):
        if isinstance(position, v.Rotated):
            turned = _turns(position.rotation)
            if turned is None or len(turned) > len(rest) or not _equal(turned, rest[: len(turned)]):
                return None
            steps += turned
            del rest[: len(turned)]
            position = position.vector
        elif isinstance(position, v.VectorSum) and _is_step(position.left):
            steps.append(position.left)
            position = position.right
        elif _is_step(position):
            steps.append(position)
            position = v.NULL
        else:
            return None
    return [*steps, *rest]


def _turns(rotation: Rotation) -> list[Elementary] | None:
    """The elementary rotations of a product; None when something else is among them."""
    found = factors(rotation)
    turns = [f for f in found if isinstance(f, Elementary)]
    return turns if len(turns) == len(found) else None


def _is_step(node: v.Vector) -> bool:
    inner = node.vector if isinstance(node, v.Scaled) else node
    return isinstance(inner, (v.Basis, v.Components, v.VectorSymbol))


def _equal(some: Sequence[Elementary], others: Sequence[Elementary]) -> bool:
    pairs = zip(some, others, strict=True)
    return all(a.axis == b.axis and a.angle is b.angle for a, b in pairs)


def entry_of(node: s.Component) -> tuple[RotationSymbol, int, int] | None:
    """The entry of a given rotation that a component is: the rotation, row and column."""
    inner = node.vector
    if not (isinstance(inner, v.Rotated) and isinstance(inner.vector, v.Basis)):
        return None
    found = factors(inner.rotation)
    if len(found) == 1 and isinstance(found[0], RotationSymbol):
        return found[0], node.index, inner.vector.axis
    return None


def sources_of_columns(matrix: Matrix) -> list[list[v.Vector]] | None:
    """The vectors that the columns of a matrix are stacked from; None for any other matrix."""
    if len(matrix.rows) % 3:
        return None
    blocks: list[list[v.Vector]] = []
    for top in range(0, len(matrix.rows), 3):
        block: list[v.Vector] = []
        for column in range(len(matrix.rows[0])):
            found = _source([matrix.rows[top + i][column] for i in range(3)])
            if found is None:
                return None
            block.append(found)
        blocks.append(block)
    return blocks if any(not isinstance(x, v.Components) for b in blocks for x in b) else None


def _source(entries: list[s.Scalar]) -> v.Vector | None:
    first = entries[0]
    if all(isinstance(e, s.Number) for e in entries):
        values = [s.is_one(e) for e in entries]
        if sum(values) == 1 and all(s.is_zero(e) or s.is_one(e) for e in entries):
            return v.Basis(values.index(True))
        return v.Components((entries[0], entries[1], entries[2]))
    if not isinstance(first, s.Component):
        return None
    for k, entry in enumerate(entries):
        if not (isinstance(entry, s.Component) and entry.vector is first.vector):
            return None
        if entry.index != k:
            return None
    return first.vector
