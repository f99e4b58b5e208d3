"""Factors of a product that stay the same in a loop are multiplied outside of it.

(a*x)*b, where x alone depends on an index, becomes x*(a*b): one multiplication a turn for two.
"""

from __future__ import annotations

from armillary.program.program import Domain, Op, Program, domains, turns
from armillary.program.rewrite import Rewriter, uses

# Factors with the indices they depend on; a part is multiplied before it meets the next one.
Part = tuple[Domain, list[int]]


def regroup_products(program: Program) -> Program:
    """Multiply what changes least often first, where that saves multiplications."""
    return _Regroup(program).run() if any(domains(program)) else program


class _Regroup(Rewriter):
    def __init__(self, program: Program) -> None:
        super().__init__(program)
        self.uses, self.domains = uses(program), domains(program)

    def rewrite(self, number: int) -> int:
        if self.program.instructions[number].op is not Op.MULTIPLY or not self.domains[number]:
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

    def _factors(self, number: int) -> tuple[list[int], int]:
        """What a product is made of, and the multiplications that it takes over all turns.

        A product inside it is opened if nothing else uses it and no definition names it.
        """
        found: list[int] = []
        stack, cost = [number], 0
        while stack:
            n = stack.pop()
            i = self.program.instructions[n]
            own = n == number or (self.uses[n] == 1 and n not in self.program.labels)
            if i.op is Op.MULTIPLY and own:
                cost += turns(self.domains[n])
                stack.extend(reversed(i.args))
            else:
                found.append(n)
        return found, cost

    def _parts(self, factors: list[int]) -> list[Part]:
        """Factors by what they depend on, those of the fewest turns first."""
        parts: dict[Domain, list[int]] = {}
        for factor in factors:
            parts.setdefault(self.domains[factor], []).append(factor)
        return sorted(parts.items(), key=lambda part: turns(part[0]))


def _cost(parts: list[Part]) -> int:
    """The multiplications over all turns."""
    total, joint = 0, Domain()
    for k, (domain, inner) in enumerate(parts):
        joint |= domain
        total += (len(inner) - 1) * turns(domain) + (turns(joint) if k else 0)
    return total
