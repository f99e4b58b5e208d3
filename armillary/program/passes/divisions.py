"""One reciprocal for several divisions by the same value, or by a root and what it is the root of.

A divide costs fourteen multiplications on a Cortex-M4F, so from the second on a shared reciprocal
pays, and so does one taken outside the loop of its division, or by a set-up; a single division
beside its divisor stays one, because it also rounds once less.
"""

from __future__ import annotations

from collections import Counter

import sympy

from armillary.program.program import Op, Program, domains, turns
from armillary.program.rates import handed
from armillary.program.rewrite import Rewriter


def share_reciprocals(program: Program) -> Program:
    """a/y and b/y become a*r and b*r with r = 1/y; a/y becomes a*(r*r) if r is that of its root."""
    divisors = Counter(i.args[1] for i in program.instructions if i.op is Op.DIVIDE)
    roots = {
        i.args[0]: number
        for number, i in enumerate(program.instructions)
        if i.op is Op.SQRT and number in divisors and i.args[0] in divisors
    }
    shared = {d for d, times in divisors.items() if times > 1} | set(roots.values())
    known, free = domains(program), handed(program)
    for number, i in enumerate(program.instructions):
        if i.op is Op.DIVIDE:
            divisor = i.args[1]
            outside = turns(known[divisor]) < turns(known[number])
            if outside or (free[divisor] and not free[number]):
                shared.add(divisor)
    return _Share(program, shared, set(roots)).run()


class _Share(Rewriter):
    def __init__(self, program: Program, shared: set[int], squares: set[int]) -> None:
        super().__init__(program)
        self.shared, self.squares = shared, squares

    def rewrite(self, number: int) -> int:
        i = self.program.instructions[number]
        if i.op is Op.DIVIDE:
            b, divisor = self.builder, i.args[1]
            if divisor in self.squares:
                inverse = self._reciprocal(b.sqrt(self.new[divisor]))
                return b.multiply(self.new[i.args[0]], b.multiply(inverse, inverse))
            if divisor in self.shared:
                return b.multiply(self.new[i.args[0]], self._reciprocal(self.new[divisor]))
        return super().rewrite(number)

    def _reciprocal(self, divisor: int) -> int:
        return self.builder.divide(self.builder.constant(sympy.Integer(1)), divisor)
