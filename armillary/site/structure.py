"""Formulas as they were written: the structure of a definition, in LaTeX."""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntEnum
from functools import singledispatchmethod
from typing import Any

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.direction import OfDirection
from armillary.algebra.indexed import AnyOf, At, OneLike, Total, VectorAt, VectorTotal
from armillary.algebra.iteration import Iterated
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import (
    Elementary,
    Factor,
    Rotation,
    RotationReference,
    RotationSymbol,
    Transposed,
    factors,
)
from armillary.site.idioms import (
    chain_steps,
    entry_of,
    full_turn_of,
    number_latex,
    same,
    sources_of_columns,
    wrapped_angle,
)
from armillary.site.notation import Notation, subscripted

Text = tuple[str, "Level"]
AXES = "xyz"


class Level(IntEnum):
    """How tightly a piece of LaTeX holds together."""

    SUM = 1
    SIGNED = 2
    PRODUCT = 3
    FUNCTION = 4
    ATOM = 5


class Structure:
    """Prints expressions of one derivation without opening what they name."""

    def __init__(self, notation: Notation) -> None:
        self.notation = notation

    def __call__(self, node: Any) -> str:
        return self.text(node)[0]

    def inside(self, node: Any, level: Level) -> str:
        """LaTeX that holds together at least this tightly."""
        latex, found = self.text(node)
        return latex if found >= level else rf"\left({latex}\right)"

    @singledispatchmethod
    def text(self, node: Any) -> Text:
        raise TypeError(f"no LaTeX for {type(node).__name__}")

    # -- scalars ------------------------------------------------------------------------------

    @text.register
    def _(self, node: s.Number) -> Text:
        latex = number_latex(node.value)
        return latex, Level.SIGNED if latex.startswith("-") else Level.ATOM

    @text.register
    def _(self, node: s.Symbol | v.VectorSymbol | RotationSymbol) -> Text:
        return self.notation.leaf(node), Level.ATOM

    @text.register
    def _(self, node: Transposed) -> Text:
        return rf"{self(node.symbol)}^\top", Level.ATOM

    @text.register
    def _(
        self, node: s.ScalarReference | v.VectorReference | RotationReference | s.ConditionReference
    ) -> Text:
        latex = self.notation.reference(node)
        given = getattr(node, "given", None)
        if given is not None:
            pairs = ",\\,".join(f"{self(old)} = {self(new)}" for old, new in given.pairs)
            return rf"{latex}\big\rvert_{{{pairs}}}", Level.ATOM
        return latex, Level.SUM if " + " in latex or " - " in latex else Level.ATOM

    @text.register
    def _(self, node: s.Add | v.VectorSum) -> Text:
        return self._sum(node.left, node.right)

    def _sum(self, left: Any, right: Any) -> Text:
        second, level = self.text(right)
        sign = "+"
        if second.startswith("-") and level is not Level.SUM:
            sign, second = "-", second[1:].lstrip()
        elif second.startswith("-"):
            second = rf"\left({second}\right)"
        return f"{self(left)} {sign} {second}", Level.SUM

    @text.register
    def _(self, node: s.Negate | v.VectorNegate) -> Text:
        return f"-{self.inside(node.argument, Level.PRODUCT)}", Level.SIGNED

    @text.register
    def _(self, node: s.Multiply) -> Text:
        if same(node.left, node.right):
            return f"{{{self.inside(node.left, Level.ATOM)}}}^2", Level.PRODUCT
        left = self.inside(node.left, Level.SIGNED)
        right = self.inside(node.right, Level.PRODUCT)
        dot = r" \cdot " if right[:1].isdigit() or right.startswith(r"\frac{") else r"\,"
        return f"{left}{dot}{right}", Level.SIGNED if left.startswith("-") else Level.PRODUCT

    @text.register
    def _(self, node: s.Divide) -> Text:
        top, below = node.numerator, self(node.denominator)
        if isinstance(top, s.Divide):  # one fraction instead of a fraction of fractions
            inner, outer = (
                self.inside(n, Level.FUNCTION) for n in (top.denominator, node.denominator)
            )
            below = f"{{{inner}}}^2" if inner == outer else rf"{inner}\,{outer}"
            top = top.numerator
        return rf"\frac{{{self(top)}}}{{{below}}}", Level.PRODUCT

    @text.register
    def _(self, node: s.SquareRoot) -> Text:
        inner = node.argument
        if isinstance(inner, s.Dot) and inner.left is inner.right:
            return rf"\left\lVert {self(inner.left)} \right\rVert", Level.ATOM
        return rf"\sqrt{{{self(inner)}}}", Level.ATOM

    @text.register
    def _(self, node: s.Sine) -> Text:
        return self._function(r"\sin", node.argument)

    @text.register
    def _(self, node: s.Cosine) -> Text:
        return self._function(r"\cos", node.argument)

    def _function(self, name: str, argument: s.Scalar) -> Text:
        return f"{name} {self.inside(argument, Level.ATOM)}", Level.FUNCTION

    @text.register
    def _(self, node: Total | VectorTotal) -> Text:
        over = node.over
        inner = self.inside(node.term, Level.PRODUCT)
        return rf"\sum_{{{over.letter}=1}}^{{{over.size}}} {inner}", Level.SUM

    @text.register
    def _(self, node: At | VectorAt) -> Text:
        latex, level = self.text(node.term)
        place = f"{node.over.letter}={node.place + 1}"
        inner = latex if level is Level.ATOM else rf"\left({latex}\right)"
        return rf"{inner}\big\rvert_{{{place}}}", Level.ATOM

    @text.register
    def _(self, node: AnyOf) -> Text:
        over = node.over
        inner = self.inside(node.term, Level.ATOM)
        return rf"{inner} \text{{ for any }} {over.letter}", Level.SUM

    @text.register
    def _(self, node: OneLike) -> Text:
        return "1", Level.ATOM

    @text.register
    def _(self, node: Iterated) -> Text:
        return rf"{self.notation.leaf(node.unknown)}^{{\ast}}", Level.ATOM

    @text.register
    def _(self, node: s.ArcTangent) -> Text:
        angle = wrapped_angle(node)
        if angle is not None:
            return rf"\operatorname{{wrap}}\left({self(angle)}\right)", Level.ATOM
        return (
            rf"\operatorname{{atan2}}\left({self(node.y)},\; {self(node.x)}\right)",
            Level.ATOM,
        )

    @text.register
    def _(self, node: s.ArcSine) -> Text:
        return rf"\arcsin\left({self(node.argument)}\right)", Level.ATOM

    @text.register
    def _(self, node: s.ArcCosine) -> Text:
        return rf"\arccos\left({self(node.argument)}\right)", Level.ATOM

    @text.register
    def _(self, node: OfDirection) -> Text:
        return self.text(node.explicit())

    @text.register
    def _(self, node: s.Absolute) -> Text:
        return rf"\left\lvert {self(node.argument)} \right\rvert", Level.ATOM

    @text.register
    def _(self, node: s.Select) -> Text:
        angle = full_turn_of(node)
        if angle is not None:
            return rf"{self.inside(angle, Level.ATOM)} \bmod 2 \pi", Level.SUM
        rows: list[list[str]] = []
        rest: s.Scalar = node
        while isinstance(rest, s.Select):
            rows.append([self(rest.then), rf"\text{{if }} {self(rest.condition)}"])
            rest = rest.otherwise
        rows.append([self(rest), r"\text{otherwise}"])
        return array("cases", rows), Level.ATOM

    @text.register
    def _(self, node: s.Component) -> Text:
        entry = entry_of(node)
        if entry is not None:
            given, row, column = entry
            return subscripted(self(given), f"{row + 1}{column + 1}"), Level.ATOM
        latex, level = self.text(node.vector)
        if level < Level.ATOM or latex.startswith(r"\begin") or r"\rvert_" in latex:
            return rf"\left({latex}\right)_{AXES[node.index]}", Level.ATOM
        return subscripted(latex, AXES[node.index]), Level.ATOM

    @text.register
    def _(self, node: s.Dot) -> Text:
        left, right = (self.inside(n, Level.PRODUCT) for n in (node.left, node.right))
        return rf"{left} \cdot {right}", Level.SIGNED

    # -- conditions ---------------------------------------------------------------------------

    @text.register
    def _(self, node: s.Less) -> Text:
        if isinstance(node.left, s.Number):
            return f"{self(node.right)} > {self(node.left)}", Level.SUM
        return f"{self(node.left)} < {self(node.right)}", Level.SUM

    @text.register
    def _(self, node: s.Both) -> Text:
        return rf"{self(node.left)} \text{{ and }} {self(node.right)}", Level.SUM

    @text.register
    def _(self, node: s.Not) -> Text:
        inner = node.argument
        if isinstance(inner, s.Less):
            return rf"{self(inner.left)} \ge {self(inner.right)}", Level.SUM
        return rf"\text{{not }} {self.inside(inner, Level.ATOM)}", Level.SUM

    # -- vectors ------------------------------------------------------------------------------

    @text.register
    def _(self, node: v.Components) -> Text:
        if v.is_null(node):
            return r"\mathbf{0}", Level.ATOM
        ones = [k for k, c in enumerate(node.components) if s.is_one(c)]
        if len(ones) == 1 and sum(map(s.is_zero, node.components)) == 2:
            return self.text(v.Basis(ones[0]))
        return array("bmatrix", [[self(c)] for c in node.components]), Level.ATOM

    @text.register
    def _(self, node: v.Basis) -> Text:
        return rf"\mathbf{{e}}_{AXES[node.axis]}", Level.ATOM

    @text.register
    def _(self, node: v.Scaled) -> Text:
        factor = node.factor
        if isinstance(factor, s.Divide) and s.is_one(factor.numerator):
            return rf"\frac{{{self(node.vector)}}}{{{self(factor.denominator)}}}", Level.PRODUCT
        left = self.inside(factor, Level.SIGNED)
        return rf"{left}\,{self.inside(node.vector, Level.PRODUCT)}", (
            Level.SIGNED if left.startswith("-") else Level.PRODUCT
        )

    @text.register
    def _(self, node: v.Cross) -> Text:
        left, right = (self.inside(n, Level.PRODUCT) for n in (node.left, node.right))
        return rf"{left} \times {right}", Level.SIGNED

    @text.register
    def _(self, node: v.Unit) -> Text:
        inner = self(node.vector)
        return rf"\frac{{{inner}}}{{\left\lVert {inner} \right\rVert}}", Level.PRODUCT

    @text.register
    def _(self, node: v.Rotated) -> Text:
        if not _turning(node.rotation):
            return self.text(node.vector)
        inner = node.vector
        if isinstance(inner, v.VectorNegate):
            return f"-{self(v.Rotated(node.rotation, inner.argument))}", Level.SIGNED
        return rf"{self(node.rotation)}\,{self.inside(inner, Level.PRODUCT)}", Level.PRODUCT

    @text.register
    def _(self, node: v.Choice) -> Text:
        return min((self.text(form) for form in (node.nested, node.summed)), key=_length)

    # -- rotations and blocks -----------------------------------------------------------------

    @text.register
    def _(self, node: Elementary) -> Text:
        return rf"R_{AXES[node.axis]}\left({self(node.angle)}\right)", Level.ATOM

    @text.register
    def _(self, node: Rotation) -> Text:
        return r"\,".join(map(self, _turning(node))) or "I", Level.PRODUCT

    @text.register
    def _(self, node: Pose) -> Text:
        steps = chain_steps(node)
        if steps is not None:
            return r"\,".join(map(self._step, steps)), Level.PRODUCT
        top = [self(node.rotation), self(node.position)]
        return array("bmatrix", [top, [r"\mathbf{0}^\top", "1"]]), Level.ATOM

    def _step(self, step: Elementary | v.Vector) -> str:
        if isinstance(step, Elementary):
            return self(step)
        scale, axis = (step.factor, step.vector) if isinstance(step, v.Scaled) else (s.ONE, step)
        if isinstance(axis, v.Basis):
            return rf"T_{AXES[axis.axis]}\left({self(scale)}\right)"
        return rf"T\left({self(step)}\right)"

    @text.register
    def _(self, node: Twist) -> Text:
        hat = rf"\left[{self(node.angular)}\right]_\times"
        rows = [[hat, self(node.linear)], [r"\mathbf{0}^\top", "0"]]
        return array("bmatrix", rows), Level.ATOM

    @text.register
    def _(self, node: Wrench) -> Text:
        return array("bmatrix", [[self(node.force)], [self(node.moment)]]), Level.ATOM

    @text.register
    def _(self, node: Matrix) -> Text:
        blocks = sources_of_columns(node)
        rows = blocks if blocks is not None else node.rows
        return array("bmatrix", [[self(entry) for entry in row] for row in rows]), Level.ATOM


def _turning(rotation: Rotation) -> list[Factor]:
    """The factors of a product that turn anything."""
    found = factors(rotation)
    return [f for f in found if not (isinstance(f, Elementary) and s.is_zero(f.angle))]


def _length(text: Text) -> int:
    return len(text[0])


def array(environment: str, rows: Sequence[Sequence[str]]) -> str:
    """A LaTeX array of one of the matrix environments."""
    inner = r" \\ ".join(" & ".join(row) for row in rows)
    return rf"\begin{{{environment}}} {inner} \end{{{environment}}}"
