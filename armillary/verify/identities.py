"""Proofs: what an author claims, and what every derivation owes without being asked.

An identity is first tried at points, because a number that is not zero settles it at once, and then
reduced to zero by SymPy, which settles it for good.
"""

from __future__ import annotations

from collections.abc import Iterator

import mpmath
import sympy

from armillary.algebra.explicit import Explicit, reduce_trigonometry
from armillary.algebra.indexed import is_leaf
from armillary.algebra.rigid import Pose
from armillary.algebra.rotation import (
    Composed,
    Elementary,
    Rotation,
    RotationSymbol,
    factors,
)
from armillary.algebra.scalar import Condition
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Block, Definition, Identity, Kernel
from armillary.derivation.symbols import leaves
from armillary.program.arithmetic import DIGITS, Reals
from armillary.program.program import Program
from armillary.verify import exact
from armillary.verify.measured import Measured, Point, exceeds
from armillary.verify.points import random_points, rows_of

AGREEMENT = 1e-40
POINTS = 8
# Above this many operations a normal form would take minutes; the points must do.
_REDUCIBLE = 3000


class NotComparableError(Exception):
    """The two sides of an identity have different shapes."""


def prove(identity: Identity) -> Measured:
    """One identity of the author: at points, then for all values.

    `engine` is "SymPy" where the difference was reduced to zero, and "50 digits" where SymPy
    could not and only the points speak; `why` then says so, with the residual.
    """
    sides, explicit = (identity.left, identity.right), Explicit()
    difference = [
        entry
        for place in exact.everywhere(explicit, sides)
        for entry in _difference(identity.left, identity.right, place)
    ]
    return _zero(identity.claim, exact.Function(difference, leaves(sides), explicit.iterations))


def text_book_rotation(definition: Definition) -> Measured | None:
    """R^T R = 1 and det R = 1 for a definition that holds a rotation; None for any other.

    At points it is held to this as it is defined, where its computed angles must be real numbers;
    then for all values of its angles.

    None too for one that stands on entries given from outside: those are for the guards to judge.
    """
    block = definition.expression
    rotation = block.rotation if isinstance(block, Pose) else block
    if not isinstance(rotation, Rotation):
        return None
    if any(isinstance(leaf, RotationSymbol) for leaf in leaves(rotation)):
        return None
    claim = f"the rotation of {definition.name} is orthonormal and proper"
    bad, at = _off_a_rotation(exact.text_book(rotation))
    if not bad <= AGREEMENT:
        why = "its computed angles give no real rotation there"
        return Measured(claim, "50 digits", None, POINTS, bad, AGREEMENT, at, why)
    rotation = _by_free_angles(rotation)
    explicit, defects = Explicit(), list[sympy.Expr]()
    for place in exact.everywhere(explicit, rotation):
        matrix = sympy.Matrix(place(rotation))
        defects += [*(matrix.T * matrix - sympy.eye(3)), matrix.det(method="berkowitz") - 1]
    return _zero(claim, exact.Function(defects, leaves(rotation), explicit.iterations))


def _off_a_rotation(entries: exact.Function) -> tuple[float, Point]:
    """How far some matrices are from real rotations at points, and where most; NaN counts as far.

    The entries are those of one matrix after another.
    """
    bad = 0.0
    at: Point = {}
    for row in rows_of(random_points(entries.quantities, POINTS, seed=4)):
        values = entries(row)
        for k in range(0, len(values), 9):
            with mpmath.workdps(DIGITS):
                matrix = mpmath.matrix([values[k + i : k + i + 3] for i in (0, 3, 6)])
                off = [*(matrix.H * matrix - mpmath.eye(3)), mpmath.det(matrix) - 1]
                off += [mpmath.im(entry) for entry in matrix]
                error = float(max(map(abs, off)))
            if exceeds(error, bad):
                bad, at = error, dict(row)
    return bad, at


def _by_free_angles(rotation: Rotation) -> Rotation:
    """The same product with a free angle for each that is computed.

    SymPy could not reduce the computed ones; that they are real numbers, points tell.
    """
    angles = Derivation("angles", title="Free angles")
    return Composed(
        tuple(
            Elementary(f.axis, angles.angle(f"angle_{k}", "any angle"))
            if isinstance(f, Elementary) and not is_leaf(f.angle)
            else f
            for k, f in enumerate(factors(rotation))
        )
    )


def text_book_expression(kernel: Kernel, program: Program) -> Iterator[Measured]:
    """Each result of the program equals the explicit expression of its definition."""
    reals = Reals()
    rows = list(rows_of(random_points(kernel, POINTS, seed=3)))
    answers = [exact.run(program, row, reals) for row in rows]
    for output in kernel.outputs:
        book = exact.text_book(output.value, output.indices)
        bad, tried = 0.0, 0
        at: Point = {}
        for row, answer in zip(rows, answers, strict=True):
            if answer.status >= 0:
                tried += 1
                error = exact.worst(exact.flat(answer.results[output.name]), book(row))
                if exceeds(error, bad):
                    bad, at = error, dict(row)
        yield Measured(
            f"{output.name}: the program equals the text-book expression",
            "SymPy, 50 digits", kernel.name, tried, bad if tried else float("nan"), AGREEMENT, at,
            "" if tried else "no point of the range has a non-negative status",
        )  # fmt: skip


def _difference(left: Block, right: Block, explicit: Explicit) -> list[sympy.Expr]:
    if isinstance(left, Condition) or isinstance(right, Condition):
        raise NotComparableError("an identity compares values, not conditions")
    a, b = explicit(left), explicit(right)
    shapes = [getattr(x, "shape", ()) for x in (a, b)]
    if shapes[0] != shapes[1]:
        raise NotComparableError(
            f"the left side has the shape {shapes[0]}, the right side {shapes[1]}"
        )
    return exact.entries_of(a - b)


def _zero(claim: str, function: exact.Function) -> Measured:
    """Whether all entries of a function are zero."""
    bad, at = _at_points(function)
    if not bad <= AGREEMENT:
        residual = next(e for e in function.entries if e != 0)
        why = f"residual: {_short(residual)}"
        return Measured(claim, "50 digits", None, POINTS, bad, AGREEMENT, at, why)
    left_over = _reduced(function.entries)
    if left_over is None:
        return Measured(claim, "SymPy", None, 0, 0.0, 0.0, {}, "proved for all values")
    why = f"not proved for all values, it holds at {POINTS} points; residual: {_short(left_over)}"
    return Measured(claim, "50 digits", None, POINTS, bad, AGREEMENT, at, why)


def _at_points(function: exact.Function) -> tuple[float, Point]:
    """The largest entry met, and where; NaN counts as large."""
    bad = 0.0
    at: Point = {}
    for row in rows_of(random_points(function.quantities, POINTS, seed=4)):
        error = float(exact.largest(function(row)))
        if exceeds(error, bad):
            bad, at = error, dict(row)
    return bad, at


def _reduced(entries: list[sympy.Expr]) -> sympy.Expr | None:
    """What SymPy could not reduce to zero; None when nothing is left."""
    for entry in entries:
        if sympy.count_ops(entry) > _REDUCIBLE:
            return entry
        try:
            left_over = reduce_trigonometry(entry)
        except sympy.PolynomialError:  # a sine below a root or an arc tangent
            left_over = sympy.simplify(entry)
        if left_over != 0:
            return left_over
    return None


def _short(expression: sympy.Expr) -> str:
    text = str(expression)
    return text if len(text) <= 200 else text[:197] + "..."
