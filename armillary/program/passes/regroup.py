"""Factors of a product that stay the same in a loop are multiplied outside of it.

(a*x)*b, where x alone depends on an index, becomes x*(a*b): one multiplication a turn for two.
Factors that are known beforehand are multiplied by the set-up.
"""

from __future__ import annotations

from armillary.program.cost import measure
from armillary.program.program import Domain, Op, Program, domains, turns
from armillary.program.rates import handed, is_handed, runs
from armillary.program.rewrite import Rewriter, uses

# What tells factors apart: whether they are known beforehand, and the indices they depend on.
Sort = tuple[bool, Domain]
# Factors of a sort; a part is multiplied before it meets the next one.
Part = tuple[Sort, list[int]]


def regroup_products(program: Program) -> Program:
    """Multiply what changes least often first, where that saves multiplications."""
    if not any(domains(program)) and not program.beforehand:
        return program
    regrouped = _Regroup(program).run()
    return regrouped if measure(regrouped) <= measure(program) else program


class _Regroup(Rewriter):
    def __init__(self, program: Program) -> None:
        super().__init__(program)
        self.uses, self.domains = uses(program), domains(program)
        self.handed, self.runs = handed(program), runs(program)

    def rewrite(self, number: int) -> int:
        if self.program.instructions[number].op is not Op.MULTIPLY or self.is_plain(number):
            return super().rewrite(number)
        factors, before = self._factors(number)
        parts = self._parts(factors)
        if _cost(parts) >= before:
            return super().rewrite(number)
        b = self.builder
        whole: int | None = None
        for _, inner in parts:
            part = self.new[inner[0]]
            for factor in inner[1:]:
                part = b.multiply(part, self.new[factor])
            whole = part if whole is None else b.multiply(whole, part)
        assert whole is not None
        return whole

    def is_plain(self, number: int) -> bool:
        """Whether all factors run equally often."""
        return not self.domains[number] and not self.program.beforehand

    def _factors(self, number: int) -> tuple[list[int], int]:
        """What a product is made of, and the multiplications that it takes over all turns.

        A product inside it is opened if nothing else uses it and no definition names it; by a
        step also a named one, as the call shows the name.
        """
        found: list[int] = []
        stack, cost = [number], 0
        while stack:
            n = stack.pop()
            i = self.program.instructions[n]
            named = n in self.program.labels and not self.program.beforehand
            own = n == number or (self.uses[n] == 1 and not named)
            if i.op is Op.MULTIPLY and own:
                cost += self.runs[n]
                stack.extend(reversed(i.args))
            else:
                found.append(n)
        return found, cost

    def _parts(self, factors: list[int]) -> list[Part]:
        """Factors by their sort, those of the fewest turns first."""
        parts: dict[Sort, list[int]] = {}
        for factor in factors:
            parts.setdefault((self.handed[factor], self.domains[factor]), []).append(factor)
        return sorted(parts.items(), key=lambda part: (not part[0][0], turns(part[0][1])))


def _cost(parts: list[Part]) -> int:
    """The multiplications over all turns."""
    total = 0
    known, joint = True, Domain()
    for k, ((part_known, domain), inner) in enumerate(parts):
        known, joint = known and part_known, joint | domain
        total += (len(inner) - 1) * _runs(part_known, domain)
        total += _runs(known, joint) if k else 0
    return total


def _runs(known: bool, domain: Domain) -> int:
    return 0 if is_handed(known, domain) else turns(domain)
