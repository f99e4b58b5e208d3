"""sin(2x), cos(3x), ... from sin(x) and cos(x) by the Chebyshev recurrence.

A series in harmonics of one angle then calls the library twice, however many terms it has:
cos(nx) = 2 cos(x) cos((n-1)x) - cos((n-2)x), and the same for the sine.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from armillary.program.cost import cost
from armillary.program.program import Op, Program
from armillary.program.rewrite import Rewriter

HIGHEST = 8  # beyond it the recurrence loses digits that the library keeps


@dataclass(frozen=True)
class Harmonic:
    """The argument `base`, taken `order` times."""

    base: int
    order: int


def expand_multiple_angles(program: Program) -> Program:
    """Replace whole multiples of an angle, where that saves more calls than it costs."""
    harmonics = _harmonics(program)
    kept: dict[int, Harmonic] = {}
    best = program
    for base in sorted({h.base for h in harmonics.values()}):
        # cos(8x) beside a lone sin(x) would need a cosine of x, and the recurrence on top.
        tried = kept | {n: h for n, h in harmonics.items() if h.base == base}
        found = _Expand(program, tried).run()
        if cost(found).weighted < cost(best).weighted:
            kept, best = tried, found
    return best


def _harmonics(program: Program) -> dict[int, Harmonic]:
    """Which trigonometric arguments are whole multiples of another."""
    groups: dict[int, list[tuple[sympy.Expr, int]]] = {}
    taken = {i.args[0] for i in program.instructions if i.op in (Op.SIN, Op.COS)}
    for number in sorted(taken):
        factor, of = _scaled(program, number)
        groups.setdefault(of, []).append((factor, number))
    found: dict[int, Harmonic] = {}
    for group in groups.values():
        smallest, base = min(group, key=lambda pair: float(pair[0]))
        orders = [(sympy.nsimplify(factor / smallest), number) for factor, number in group]
        if all(order.is_Integer and order <= HIGHEST for order, _ in orders):
            found.update({n: Harmonic(base, int(order)) for order, n in orders if order > 1})
    return found


def _scaled(program: Program, number: int) -> tuple[sympy.Expr, int]:
    """An argument as a constant times a value."""
    i = program.instructions[number]
    if i.op is Op.MULTIPLY:
        first = program.instructions[i.args[0]]
        if first.op is Op.CONSTANT:
            assert isinstance(first.data, sympy.Expr)
            return first.data, i.args[1]
    return sympy.Integer(1), number


class _Expand(Rewriter):
    def __init__(self, program: Program, harmonics: dict[int, Harmonic]) -> None:
        super().__init__(program)
        self.harmonics = harmonics

    def rewrite(self, number: int) -> int:
        i = self.program.instructions[number]
        if i.op in (Op.SIN, Op.COS) and i.args[0] in self.harmonics:
            harmonic = self.harmonics[i.args[0]]
            return self._recurrence(i.op, self._placed(harmonic.base), harmonic.order)
        return super().rewrite(number)

    def _placed(self, base: int) -> int:
        """The base angle, brought forward where a multiple of it stands before it."""
        if base < len(self.new):
            return self.new[base]
        factor, of = _scaled(self.program, base)
        return self.builder.multiply(self.builder.constant(factor), self.new[of])

    def _recurrence(self, op: Op, base: int, order: int) -> int:
        b = self.builder
        if order == 0:
            return b.constant(sympy.Integer(int(op is Op.COS)))
        if order == 1:
            return b.sin(base) if op is Op.SIN else b.cos(base)
        double = b.multiply(b.constant(sympy.Integer(2)), b.cos(base))
        before = self._recurrence(op, base, order - 1)
        return b.add(b.multiply(double, before), b.negate(self._recurrence(op, base, order - 2)))
