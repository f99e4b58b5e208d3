"""a*x + b*x becomes (a + b)*x where both products are used only there."""

from __future__ import annotations

from armillary.program.program import Op, Program
from armillary.program.rewrite import Rewriter, uses


def factor_sums(program: Program) -> Program:
    """Take common factors out of sums until none is left."""
    while True:
        factored = _Factor(program).run()
        if factored.instructions == program.instructions:
            return factored
        program = factored


class _Factor(Rewriter):
    def __init__(self, program: Program) -> None:
        super().__init__(program)
        self.uses = uses(program)

    def rewrite(self, number: int) -> int:
        i = self.program.instructions[number]
        if i.op is Op.ADD:
            left, right = (self._product(a) for a in i.args)
            if left and right:
                common = [f for f in left[1] if f in right[1]]
                if common:
                    return self._factored(common[0], left, right)
        return super().rewrite(number)

    def _product(self, number: int) -> tuple[bool, tuple[int, ...]] | None:
        """Sign and factors of a product that nothing else uses."""
        i = self.program.instructions[number]
        negative = i.op is Op.NEGATE
        if negative:
            if self.uses[number] > 1:
                return None
            number = i.args[0]
            i = self.program.instructions[number]
        if i.op is not Op.MULTIPLY or self.uses[number] > 1:
            return None
        return negative, i.args

    def _factored(
        self, common: int, left: tuple[bool, tuple[int, ...]], right: tuple[bool, tuple[int, ...]]
    ) -> int:
        b = self.builder
        terms = []
        for negative, args in (left, right):
            other = args[1] if args[0] == common else args[0]
            term = self.new[other]
            terms.append(b.negate(term) if negative else term)
        return b.multiply(self.new[common], b.add(*terms))
