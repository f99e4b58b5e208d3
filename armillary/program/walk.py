"""Every value of a program, one by one: at each point of its domain, in an order that runs.

This is what a loop means, told without loops: what schedules and printed loops are compared with.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from armillary.algebra.index import Index
from armillary.program.program import (
    CLOSING_OPS,
    Domain,
    Op,
    Program,
    Result,
    asked_once,
    domains,
    index_of,
)

# The place of each index that matters, in the order of their names.
Point = tuple[tuple[Index, int], ...]
Place = tuple[int, Point]


@dataclass(frozen=True)
class Step:
    """One instruction at one point; `args` are numbers of earlier steps.

    A SUM or ANY has an argument for each point of its index; an ELEMENT and a PHI stand for their
    only argument.
    """

    number: int
    args: tuple[int, ...]
    point: dict[Index, int]


@dataclass(frozen=True)
class Walk:
    """All steps, and the number of the step of each value at each point."""

    steps: tuple[Step, ...]
    numbers: dict[Place, int]

    def entries(self, program: Program, result: Result) -> list[int]:
        """The steps of a result's numbers, row-major over its indices and shape."""
        known = domains(program)
        return [
            self.numbers[entry, _cut(point, known[entry])]
            for point in points(result.indices)
            for entry in result.entries
        ]


@asked_once
def walk(program: Program) -> Walk:
    """The steps of a program: every value that a result or a case needs, each once."""
    walker = _Walker(program)
    for target in _targets(program):
        walker.visit(target)
    return Walk(tuple(walker.steps), walker.numbers)


def points(indices: tuple[Index, ...]) -> Iterator[dict[Index, int]]:
    """Every point of some indices, the last index fastest."""
    if not indices:
        yield {}
        return
    for place in range(indices[0].size):
        for rest in points(indices[1:]):
            yield {indices[0]: place, **rest}


def _targets(program: Program) -> Iterator[Place]:
    known = domains(program)
    # In the order of the instructions where that runs, so that a program without loops is itself.
    for number, domain in enumerate(known):
        if not domain:
            yield number, ()
    for result in program.results:
        for point in points(result.indices):
            for entry in result.entries:
                yield entry, _cut(point, known[entry])


def _cut(point: dict[Index, int], domain: Domain) -> Point:
    kept = [(index, place) for index, place in point.items() if index in domain]
    return tuple(sorted(kept, key=lambda pair: (pair[0].name, pair[0].size)))


class _Walker:
    def __init__(self, program: Program) -> None:
        self.program, self.domains = program, domains(program)
        self.steps: list[Step] = []
        self.numbers: dict[Place, int] = {}

    def visit(self, target: Place) -> None:
        """Append the steps that a value needs, and its own; on a stack of its own.

        Raises:
            ValueError: if an iteration needs what it only finds later.
        """
        stack, begun = [target], set[Place]()
        while stack:
            place = stack[-1]
            if place in self.numbers:
                stack.pop()
                continue
            needs = self.needs(place)
            waiting = [need for need in needs if need not in self.numbers]
            if begun.intersection(waiting):
                raise ValueError(f"instruction {place[0]} of {self.program.name} needs itself")
            if waiting:
                begun.add(place)
                stack.extend(reversed(waiting))
                continue
            stack.pop()
            self.numbers[place] = len(self.steps)
            args = tuple(self.numbers[need] for need in needs)
            self.steps.append(Step(place[0], args, dict(place[1])))

    def needs(self, place: Place) -> list[Place]:
        """The values at points that a value is made of."""
        number, at = place
        instruction, point = self.program.instructions[number], dict(at)
        index = index_of(instruction)
        if instruction.op is Op.PHI and index is not None:
            return [self.before(number, index, point)]
        if instruction.op is Op.ELEMENT and index is not None:
            point[index] = instruction.data[1]  # type: ignore[index,assignment]
        elif instruction.op in CLOSING_OPS and index is not None:
            (term,) = instruction.args
            return [self.placed(term, {**point, index: k}) for k in range(index.size)]
        return [self.placed(a, point) for a in instruction.args]

    def before(self, phi: int, index: Index, point: dict[Index, int]) -> Place:
        """Where what a phi carries comes from."""
        turn = point[index]
        if turn == 0:
            return self.placed(self.program.instructions[phi].args[0], point)
        return self.placed(self.program.carried[phi], {**point, index: turn - 1})

    def placed(self, number: int, point: dict[Index, int]) -> Place:
        return number, _cut(point, self.domains[number])
