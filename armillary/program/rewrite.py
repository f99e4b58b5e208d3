"""The base of a pass: walks a program once and builds the next."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from armillary.program.builder import Builder
from armillary.program.program import Instruction, Op, Program, domains


class Rewriter:
    """Copies a program; a pass overrides `rewrite` for the operations it changes."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.builder = Builder()
        self.new: list[int] = []

    def run(self) -> Program:
        for number in range(len(self.program.instructions)):
            self.new.append(self.rewrite(number))
            self.carry_labels(number)
        p = self.program
        for phi, following in p.carried.items():
            self.builder.carry(self.new[phi], self.new[following])
        results = tuple(
            replace(r, entries=tuple(self.new[e] for e in r.entries)) for r in p.results
        )
        cases = tuple((status, self.new[c]) for status, c in p.cases)
        return self.builder.finish(p.kernel, results, cases, p.beforehand)

    def rewrite(self, number: int) -> int:
        """The number of the instruction that takes this one's place."""
        instruction = self.program.instructions[number]
        args = [self.new[a] for a in instruction.args]
        b = self.builder
        data: Any = instruction.data
        if instruction.op is Op.PHI:
            over = domains(self.program)[number] - {data[0]}
            return b.phi(args[0], data[0], data[1], over)
        if instruction.op is Op.SUM:
            return b.sum(args[0], data)
        if instruction.op is Op.ANY:
            return b.any_of(args[0], data)
        if instruction.op is Op.ELEMENT:
            return b.element(args[0], data[0], data[1])
        if instruction.op is Op.TABLE:
            return b.table(data[0], data[1])
        return rebuilt(b, instruction, args)

    def carry_labels(self, number: int) -> None:
        """Names move with the value they name."""
        for label in self.program.labels.get(number, ()):
            self.builder.label(self.new[number], label.names, label.identifier)


def rebuilt(b: Builder, instruction: Instruction, args: list[int]) -> int:
    """An instruction that no index comes into or leaves, of other arguments."""
    rules: dict[Op, Callable[..., int]] = {
        Op.NEGATE: b.negate,
        Op.ADD: b.add,
        Op.MULTIPLY: b.multiply,
        Op.DIVIDE: b.divide,
        Op.SQRT: b.sqrt,
        Op.SIN: b.sin,
        Op.COS: b.cos,
        Op.ATAN2: b.atan2,
        Op.ABSOLUTE: b.absolute,
        Op.LESS: b.less,
        Op.BOTH: b.both,
        Op.NOT: b.invert,
        Op.SELECT: b.select,
    }
    if instruction.op in rules:
        return rules[instruction.op](*args)
    return b.emit(instruction.op, *args, data=instruction.data)


def uses(program: Program) -> list[int]:
    """How often each value is used: by instructions, the next turn, results and cases."""
    count = [0] * len(program.instructions)
    for instruction in program.instructions:
        for a in instruction.args:
            count[a] += 1
    for following in program.carried.values():
        count[following] += 1
    for result in program.results:
        for e in result.entries:
            count[e] += 1
    for _, condition in program.cases:
        count[condition] += 1
    return count


def appearances(program: Program) -> list[int]:
    """How often each value would be written out if nothing but signs had no name of its own."""
    count = uses(program)
    for number in reversed(range(len(program.instructions))):
        i = program.instructions[number]
        if i.op is Op.NEGATE:
            # The sign goes where the value goes: as many times as both together.
            count[i.args[0]] += count[number] - 1
    return count
