"""Formulas written out: the SymPy form of a definition, in compact LaTeX."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

import sympy
from sympy.printing.latex import LatexPrinter

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.explicit import Explicit, Node
from armillary.algebra.indexed import Closing
from armillary.algebra.iteration import Iterated
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation, RotationSymbol
from armillary.derivation.statements import Definition
from armillary.derivation.symbols import Leaf
from armillary.site.idioms import entry_of, number_latex
from armillary.site.notation import REFERENCES, Notation, definition_latex, subscripted
from armillary.site.structure import array

# Longer entries of a matrix get a name and a line of their own.
LONGEST_ENTRY = 40
# A scalar that is longer when written out is better read as it was written.
LONGEST_SCALAR = 80
# Longer formulas are set from the left, so that they break well.
LONG = 160
# A written-out form with more operations than this helps nobody.
_TOO_MANY = 400
# What LaTeX needs and a reader does not see.
_UNSEEN = re.compile(
    r"\\(left|right|boldsymbol|mathbf|mathrm|text|dot|frac|sqrt)(?![A-Za-z])|[{}\\,]"
)


@dataclass(frozen=True)
class Formula:
    """One display formula."""

    latex: str

    @property
    def long(self) -> bool:
        """Whether it is to be set from the left."""
        return len(self.latex) > LONG and r"\begin" not in self.latex


class PageForm(Explicit):
    """The explicit form with every name of the page as a symbol of its own."""

    def __init__(self, notation: Notation) -> None:
        super().__init__(named=True)
        self.notation = notation
        self.names: dict[str, str] = {}

    def __call__(self, node: Node) -> sympy.Basic:
        if isinstance(node, (s.Symbol, s.ScalarReference, s.ConditionReference)):
            return self._symbol(self._latex(node))
        if isinstance(node, (v.VectorSymbol, v.VectorReference)):
            latex = self._latex(node)
            return sympy.Matrix([self._symbol(subscripted(latex, axis)) for axis in v.AXIS_NAMES])
        if isinstance(node, RotationSymbol):
            latex = self._latex(node)
            return sympy.Matrix(
                3, 3, lambda i, j: self._symbol(subscripted(latex, f"{i + 1}{j + 1}"))
            )
        if isinstance(node, s.Number):
            return self._number(node.value)
        return super().__call__(node)

    def _latex(self, node: Node) -> str:
        if isinstance(node, REFERENCES):
            return self.notation.reference(node)
        assert isinstance(node, Leaf)
        return self.notation.leaf(node)

    def _symbol(self, latex: str) -> sympy.Symbol:
        return sympy.Symbol(latex, real=True)

    def _number(self, value: sympy.Expr) -> sympy.Expr:
        """Whole numbers stay; a decimal prints as it was written."""
        if value.is_Integer or value == sympy.pi or value.is_Rational:
            return value
        return self._symbol(number_latex(value))


class Printer(LatexPrinter):
    """LaTeX with c and s for the cosine and sine of a plain angle."""

    def __init__(self) -> None:
        super().__init__({"mul_symbol": r"\,", "fold_short_frac": False})
        self.compact: set[str] = set()

    def _print_Symbol(self, expr: sympy.Symbol, style: str = "plain") -> str:
        name = str(expr.name)
        return rf"\left({name}\right)" if " + " in name or " - " in name else name

    def _print_Rational(self, expr: sympy.Rational) -> str:
        return number_latex(expr)

    def _print_sin(self, expr: sympy.Expr, exp: str | None = None) -> str:
        return self._trigonometric("s", expr, exp)

    def _print_cos(self, expr: sympy.Expr, exp: str | None = None) -> str:
        return self._trigonometric("c", expr, exp)

    def _trigonometric(self, letter: str, expr: sympy.Expr, exp: str | None) -> str:
        angle = expr.args[0]
        power = f"^{{{exp}}}" if exp else ""
        if _is_plain(angle):
            latex = self._print(angle)
            self.compact.add(latex)
            return f"{letter}_{{{latex}}}{power}"
        word = r"\sin" if letter == "s" else r"\cos"
        return rf"{word}{power}\left({self._print(angle)}\right)"

    def _print_atan2(self, expr: sympy.Expr) -> str:
        y, x = (self._print(a) for a in expr.args)
        return rf"\operatorname{{atan2}}\left({y},\; {x}\right)"


def _is_plain(angle: sympy.Expr) -> bool:
    if angle.is_Symbol:
        return True
    terms = angle.args if angle.is_Add else ()
    return len(terms) == 2 and all(t.is_Symbol or (-t).is_Symbol for t in terms)


@dataclass(frozen=True)
class WrittenOut:
    """A definition written out: the formula, its named entries, and angles that were shortened."""

    formula: Formula
    entries: tuple[Formula, ...]
    compact: frozenset[str]


def written_out(notation: Notation, definition: Definition) -> WrittenOut | None:
    """The explicit form of a definition; None where it would show nothing new."""
    expression = definition.expression
    if not _has_structure(expression) or _runs(expression):
        return None
    if isinstance(expression, Twist):
        expression = expression.matrix()
    found = PageForm(notation)(expression)
    name, printer = definition_latex(definition), Printer()
    if not isinstance(found, sympy.MatrixBase):
        if sympy.count_ops(found) > _TOO_MANY:
            return None
        latex = printer.doprint(_shortest(found))
        if visible_length(latex) > LONGEST_SCALAR:
            return None
        formula = Formula(f"{name} = {latex}")
        return WrittenOut(formula, (), frozenset(printer.compact))
    if sum(sympy.count_ops(entry) for entry in found) > _TOO_MANY:
        return None
    body, entries = _matrix(name, found, printer)
    return WrittenOut(Formula(f"{name} = {body}"), tuple(entries), frozenset(printer.compact))


def _matrix(name: str, matrix: sympy.MatrixBase, printer: Printer) -> tuple[str, list[Formula]]:
    """A matrix with its long entries named, and those entries."""
    rows: list[list[str]] = []
    entries: list[Formula] = []
    column = matrix.cols == 1
    for i in range(matrix.rows):
        row: list[str] = []
        for j in range(matrix.cols):
            latex = printer.doprint(_shortest(matrix[i, j]))
            if visible_length(latex) > LONGEST_ENTRY:
                index = (
                    "xyz"[i] if column and matrix.rows == 3 else f"{i + 1}{'' if column else j + 1}"
                )
                entry = subscripted(name, index)
                entries.append(Formula(f"{entry} = {latex}"))
                latex = entry
            row.append(latex)
        rows.append(row)
    return array("bmatrix", rows), entries


def visible_length(latex: str) -> int:
    """About how many characters of a formula are seen."""
    return len(re.sub(r"\\[A-Za-z]+", "x", re.sub(r"[\s_^]", "", _UNSEEN.sub("", latex))))


def _shortest(entry: sympy.Expr) -> sympy.Expr:
    """The form of an entry with the fewest operations, of those that are quick to find."""
    if not isinstance(entry, sympy.Expr) or entry.is_Atom:
        return entry
    forms = [entry, sympy.expand(entry), sympy.factor_terms(entry), _summed_angles(entry)]
    return min(forms, key=sympy.count_ops)


def _summed_angles(entry: sympy.Expr) -> sympy.Expr:
    """Common factors taken out of the expanded entry."""
    return sympy.collect_const(sympy.factor_terms(sympy.expand(entry)))


def _has_structure(expression: object) -> bool:
    """Whether an expression holds blocks that the explicit form opens."""
    blocks = (v.Rotated, v.Cross, v.Unit, v.Choice, s.Dot, Rotation, Pose, Twist, Wrench, Matrix)
    return any(isinstance(node, blocks) for node in _nodes(expression))


def _runs(expression: object) -> bool:
    """Whether an expression sums, picks or iterates: it reads best as it was written."""
    return any(
        isinstance(node, (*Closing, Iterated)) or getattr(node, "given", None) is not None
        for node in _nodes(expression)
    )


def _nodes(expression: object) -> Iterator[object]:
    seen: set[int] = set()
    stack = [expression]
    while stack:
        node = stack.pop()
        if id(node) in seen or isinstance(node, (sympy.Basic, str, int)):
            continue
        seen.add(id(node))
        yield node
        if isinstance(node, (*REFERENCES, Leaf)):
            continue
        if isinstance(node, s.Component) and entry_of(node) is not None:
            continue
        if isinstance(node, tuple):
            stack.extend(node)
        elif hasattr(node, "__dataclass_fields__"):
            stack.extend(getattr(node, name) for name in node.__dataclass_fields__)
