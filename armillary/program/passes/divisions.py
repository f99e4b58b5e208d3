"""One reciprocal for several divisions by the same value.

A divide costs fourteen multiplications on a Cortex-M4F, so from the second on a shared reciprocal
pays; a single division stays one, because it also rounds once less.
"""

from __future__ import annotations

from collections import Counter

import sympy

from armillary.program.program import Op, Program
from armillary.program.rewrite import Rewriter


def share_reciprocals(program: Program) -> Program:
    """a/y and b/y become a*r and b*r with r = 1/y."""
    divisors = Counter(i.args[1] for i in program.instructions if i.op is Op.DIVIDE)
    return _Share(program, {d for d, times in divisors.items() if times > 1}).run()


class _Share(Rewriter):
    def __init__(self, program: Program, shared: set[int]) -> None:
        super().__init__(program)
        self.shared = shared

    def rewrite(self, number: int) -> int:
        i = self.program.instructions[number]
        if i.op is Op.DIVIDE and i.args[1] in self.shared:
            b = self.builder
            one = b.constant(sympy.Integer(1))
            return b.multiply(self.new[i.args[0]], b.divide(one, self.new[i.args[1]]))
        return super().rewrite(number)
