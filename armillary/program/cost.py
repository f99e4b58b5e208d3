"""What a program costs: operations by kind, and one weighted figure."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

from armillary.program.program import Op, Program, domains, index_of, is_vector, turns
from armillary.program.rates import in_step

# A vector operation counts as what it would cost if nothing of it were zero.
_OPENED: dict[Op, dict[Op, int]] = {
    Op.ADD_VECTORS: {Op.ADD: 3},
    Op.SCALE: {Op.MULTIPLY: 3},
    Op.ROTATE: {Op.MULTIPLY: 4, Op.ADD: 2},
    Op.CROSS: {Op.MULTIPLY: 6, Op.ADD: 3},
    Op.DOT: {Op.MULTIPLY: 3, Op.ADD: 2},
}


@dataclass(frozen=True)
class Cost:
    """Operation counts; guards, signs, comparisons and selections are apart."""

    add: int
    multiply: int
    divide: int
    sqrt: int
    trigonometry: int
    inverse: int

    @property
    def flops(self) -> int:
        return self.add + self.multiply + self.divide + self.sqrt

    @property
    def weighted(self) -> int:
        cheap = self.add + self.multiply
        return cheap + 14 * (self.divide + self.sqrt) + 40 * (self.trigonometry + self.inverse)

    def __str__(self) -> str:
        return (
            f"{self.flops} flops ({self.multiply} mul, {self.add} add, {self.divide} div, "
            f"{self.sqrt} sqrt), {self.trigonometry} sin/cos, {self.inverse} atan2"
        )


def cost(program: Program) -> Cost:
    """The cost of one call: over all turns of its loops."""
    return _counted(program, range(len(program.instructions)))


def step_cost(program: Program) -> Cost:
    """The cost of one step: without what follows from what is known beforehand."""
    return _counted(program, sorted(in_step(program)))


def measure(program: Program) -> tuple[int, int]:
    """What is made small: the weighted cost of a step if there are any, then that of a call."""
    whole = cost(program).weighted
    return step_cost(program).weighted if program.beforehand else whole, whole


def _counted(program: Program, numbers: Iterable[int]) -> Cost:
    count: Counter[Op] = Counter()
    known = domains(program)
    for number in numbers:
        instruction, domain = program.instructions[number], known[number]
        for op, times in _OPENED.get(instruction.op, {instruction.op: 1}).items():
            count[op] += times * turns(domain)
        index = index_of(instruction)
        if instruction.op is Op.SUM and index is not None:
            width = 3 if is_vector(program.instructions, instruction.args[0]) else 1
            count[Op.ADD] += width * turns(domain | {index})
    return Cost(
        count[Op.ADD],
        count[Op.MULTIPLY],
        count[Op.DIVIDE],
        count[Op.SQRT],
        count[Op.SIN] + count[Op.COS],
        count[Op.ATAN2],
    )
