"""a*x + b*x becomes (a + b)*x where both products are used only there.

So does the sum over an index of a*x, where a does not depend on it: a times the sum of x.
"""

from __future__ import annotations

from armillary.program.program import Op, Program, domains, index_of, turns
from armillary.program.rates import handed, is_handed, runs
from armillary.program.rewrite import Rewriter, uses


def factor_sums(program: Program) -> Program:
    """Take common factors out of sums until none is left."""
    while True:
        factored = _Factor(program).run()
        if factored.instructions == program.instructions:
            return factored
        program = factored


Pair = tuple[int, int]


class _Factor(Rewriter):
    def __init__(self, program: Program) -> None:
        super().__init__(program)
        self.uses, self.handed, self.runs = uses(program), handed(program), runs(program)

    def rewrite(self, number: int) -> int:
        i = self.program.instructions[number]
        if i.op is Op.ADD:
            left, right = (self._product(a) for a in i.args)
            if left and right:
                common = [f for f in left[1] if f in right[1]]
                if common and self._pays(number, common[0], left[1], right[1]):
                    return self._factored(common[0], left, right)
        if i.op is Op.SUM:
            found = self._outside(number)
            if found is not None:
                return found
        return super().rewrite(number)

    def _pays(self, number: int, common: int, left: Pair, right: Pair) -> bool:
        """Whether the sum of the other factors is not dearer, over all turns, than a product."""
        known, i = domains(self.program), self.program.instructions[number]
        first, second = (_other(pair, common) for pair in (left, right))
        free = self.handed[first] and self.handed[second]
        joint = known[first] | known[second]
        times = 0 if is_handed(free, joint) else turns(joint)
        return times <= sum(self.runs[a] for a in i.args)

    def _outside(self, number: int) -> int | None:
        """A sum of products or quotients with what is the same for all of them taken out."""
        i, known, b = self.program.instructions[number], domains(self.program), self.builder
        index, term = index_of(i), self.program.instructions[i.args[0]]
        assert index is not None
        if self.uses[i.args[0]] > 1 or term.op not in (Op.MULTIPLY, Op.DIVIDE):
            return None
        first, second = term.args
        if index not in known[second]:
            rest = b.sum(self.new[first], index)
            take = b.multiply if term.op is Op.MULTIPLY else b.divide
            return take(rest, self.new[second])
        if index not in known[first] and term.op is Op.MULTIPLY:
            return b.multiply(self.new[first], b.sum(self.new[second], index))
        return None

    def _product(self, number: int) -> tuple[bool, Pair] | None:
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
        return negative, (i.args[0], i.args[1])

    def _factored(self, common: int, left: tuple[bool, Pair], right: tuple[bool, Pair]) -> int:
        b = self.builder
        terms = []
        for negative, args in (left, right):
            term = self.new[_other(args, common)]
            terms.append(b.negate(term) if negative else term)
        return b.multiply(self.new[common], b.add(*terms))


def _other(pair: Pair, factor: int) -> int:
    return pair[1] if pair[0] == factor else pair[0]
