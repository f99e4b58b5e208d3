"""Finds the cheapest direction of evaluation of a kernel.

With quantities that are known beforehand, cheap means a cheap step.

First every strategy for the kernel as a whole; then, from the best, one vector at a time is
computed in another way for as long as that pays. The search is greedy and always ends at the same
program: candidates are tried in the order the lowering meets them, and only a gain is kept.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from armillary.algebra.vector import Vector
from armillary.derivation.statements import Kernel
from armillary.program.cost import measure
from armillary.program.lower import Strategy, decisions, lower, strategies
from armillary.program.passes import STAGES
from armillary.program.program import Program

ROUNDS = 3


@dataclass(frozen=True)
class Found:
    """A program, and how its kernel is evaluated."""

    program: Program
    strategy: Strategy
    local: dict[Vector, str]

    @property
    def rank(self) -> tuple[int, int, int]:
        """What is compared: the measure of the cost, then the length of the program."""
        return *measure(self.program), len(self.program.instructions)


def cheapest(kernel: Kernel) -> Found:
    """The cheapest program of one call that was found."""
    return _Search(kernel, frozenset()).run([])


def cheapest_step(known: Found) -> Found:
    """The program with the cheapest step that was found, beginning with one that is known."""
    search = _Search(known.program.kernel, known.program.beforehand)
    return search.run([known, search.tried(known.strategy, known.local)])


class _Search:
    def __init__(self, kernel: Kernel, beforehand: frozenset[str]) -> None:
        self.kernel, self.beforehand = kernel, beforehand
        # Many directions are one, where a kernel leaves little open.
        self.made: dict[object, Program] = {}

    def run(self, candidates: list[Found]) -> Found:
        found = [*candidates, *(self.tried(strategy, {}) for strategy in strategies())]
        best = min(found, key=lambda f: f.rank)  # the first of equals: the plainest
        for _ in range(ROUNDS):
            refined = self.refined(best)
            if refined is best:
                break
            best = refined
        return best

    def refined(self, best: Found) -> Found:
        """One round: each vector in turn, in each other way."""
        for decision in decisions(self.kernel, best.strategy, best.local):
            for option in decision.options:
                other = self.tried(best.strategy, {**best.local, decision.node: option})
                if other.rank[0] < best.rank[0]:
                    best = other
        return best

    def tried(self, strategy: Strategy, local: Mapping[Vector, str]) -> Found:
        program = lower(self.kernel, strategy, local, self.beforehand)
        key = program.key()
        if key not in self.made:
            for step in STAGES:
                program = step(program)
            self.made[key] = program
        return Found(self.made[key], strategy, dict(local))
