"""Sine and cosine of an angle that came out of atan2, without calling the library back.

With h = hypot(x, y), sin(atan2(y, x)) is y/h and cos(atan2(y, x)) is x/h: a division instead of a
call. At (0, 0) the quotients have no value while the angle is 0, so the pass works only where a
guard, `where(h < tolerance, ..)` on both arguments, shows that h is at least the tolerance.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from armillary.program.program import Instruction, Op, Program
from armillary.program.rewrite import Rewriter


def open_arc_tangents(program: Program) -> Program:
    """Replace sines and cosines of guarded arc tangents by quotients."""
    return _Open(program).run()


@dataclass(frozen=True)
class _Guarded:
    """Arguments that are (0, 1) where the condition holds; elsewhere their length is not 0."""

    y: int
    x: int
    condition: int
    length: int
    squared: bool


class _Open(Rewriter):
    def rewrite(self, number: int) -> int:
        i = self.program.instructions[number]
        found = self._guarded(i.args[0]) if i.op in (Op.SIN, Op.COS) else None
        if found is None:
            return super().rewrite(number)
        b = self.builder
        length = self.new[found.length]
        if found.squared:
            length = b.sqrt(length)
        # Where the angle is free, its arguments are (0, 1): so is their quotient by 1.
        one = b.constant(sympy.Integer(1))
        length = b.select(self.new[found.condition], one, length)
        return b.divide(self.new[found.y if i.op is Op.SIN else found.x], length)

    def _guarded(self, number: int) -> _Guarded | None:
        angle = self._at(number)
        if angle.op is not Op.ATAN2:
            return None
        numbers = angle.args[0], angle.args[1]
        y, x = (self._at(a) for a in numbers)
        if y.op is not Op.SELECT or x.op is not Op.SELECT or y.args[0] != x.args[0]:
            return None
        if not (self._is(y.args[1], 0) and self._is(x.args[1], 1)):
            return None
        condition = self._at(y.args[0])
        if condition.op is not Op.LESS or not self._is_positive(condition.args[1]):
            return None
        length = condition.args[0]
        squared = self._at(length).op is not Op.SQRT
        square = length if squared else self._at(length).args[0]
        if self._squares(square) != {self._unsigned(y.args[2]), self._unsigned(x.args[2])}:
            return None
        return _Guarded(*numbers, y.args[0], length, squared)

    def _at(self, number: int) -> Instruction:
        return self.program.instructions[number]

    def _is(self, number: int, value: int) -> bool:
        i = self._at(number)
        return i.op is Op.CONSTANT and i.data == value

    def _is_positive(self, number: int) -> bool:
        i = self._at(number)
        return i.op is Op.CONSTANT and isinstance(i.data, sympy.Expr) and bool(i.data > 0)

    def _unsigned(self, number: int) -> int:
        i = self._at(number)
        return i.args[0] if i.op is Op.NEGATE else number

    def _squares(self, number: int) -> set[int] | None:
        """What is squared in a sum of two squares."""
        i = self._at(number)
        terms = [self._at(a) for a in i.args]
        if i.op is not Op.ADD or any(
            t.op is not Op.MULTIPLY or t.args[0] != t.args[1] for t in terms
        ):
            return None
        return {t.args[0] for t in terms}
