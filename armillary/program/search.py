"""Finds the cheapest direction of evaluation of a kernel.

First every strategy for the kernel as a whole; then, from the best, one vector at a time is
computed in another way for as long as that pays. The search is greedy and always ends at the same
program: candidates are tried in the order the lowering meets them, and only a gain is kept.
"""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra.vector import Vector
from armillary.derivation.statements import Kernel
from armillary.program.cost import cost
from armillary.program.lower import Strategy, decisions, lower, strategies
from armillary.program.passes import PASSES
from armillary.program.program import Program
from armillary.program.scalarise import scalarise

ROUNDS = 3


@dataclass(frozen=True)
class Found:
    """A program, and how its kernel is evaluated."""

    program: Program
    strategy: Strategy
    local: dict[Vector, str]

    @property
    def rank(self) -> tuple[int, int]:
        """What is compared: the weighted cost, then the length of the program."""
        return cost(self.program).weighted, len(self.program.instructions)


def cheapest(kernel: Kernel) -> Found:
    """The cheapest program that was found."""
    found = [_tried(kernel, strategy, {}) for strategy in strategies()]
    best = min(found, key=lambda f: f.rank)  # the first of equals: the plainest
    for _ in range(ROUNDS):
        refined = _refined(kernel, best)
        if refined is best:
            break
        best = refined
    return best


def _refined(kernel: Kernel, best: Found) -> Found:
    """One round: each vector in turn, in each other way."""
    for decision in decisions(kernel, best.strategy, best.local):
        for option in decision.options:
            other = _tried(kernel, best.strategy, {**best.local, decision.node: option})
            if other.rank[0] < best.rank[0]:
                best = other
    return best


def _tried(kernel: Kernel, strategy: Strategy, local: dict[Vector, str]) -> Found:
    program = lower(kernel, strategy, local)
    for step in (scalarise, *PASSES):
        program = step(program)
    return Found(program, strategy, local)
