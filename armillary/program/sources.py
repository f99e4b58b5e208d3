"""What a value is made of, seen through what is written in place: signs, inputs, single elements.

Such an instruction has no line of its own: it is written wherever it is used.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from armillary.algebra.index import Index
from armillary.program.program import Op, Program, asked_once, index_of

_IN_PLACE = frozenset({Op.CONSTANT, Op.INPUT, Op.TABLE, Op.NEGATE})

# An index whose loop is over: the place that is used, None if it is not one place.
Fixed = tuple[tuple[Index, int | None], ...]


@dataclass(frozen=True)
class Source:
    """A value with a line of its own, and the indices whose loops must be over."""

    number: int
    fixed: Fixed = ()


def has_line(program: Program, number: int) -> bool:
    """Whether a value is written on its own, not where it is used."""
    op = program.instructions[number].op
    return op not in _IN_PLACE and (op is not Op.ELEMENT or number in program.labels)


def sources(program: Program, number: int, fixed: Fixed = ()) -> Iterator[Source]:
    """The values behind one that is used."""
    stack = [(number, fixed)]
    while stack:
        number, fixed = stack.pop()
        instruction = program.instructions[number]
        index = index_of(instruction)
        if has_line(program, number):
            if instruction.op in (Op.SUM, Op.ANY) and index is not None:
                fixed = (*fixed, (index, None))
            yield Source(number, fixed)
            continue
        if instruction.op is Op.ELEMENT:
            fixed = (*fixed, taken(program, number))
        stack.extend((a, fixed) for a in instruction.args)


def taken(program: Program, number: int) -> tuple[Index, int]:
    """The index and the place of an ELEMENT."""
    data = program.instructions[number].data
    assert isinstance(data, tuple)
    index, place = data[0], data[1]
    assert isinstance(index, Index)
    assert isinstance(place, int)
    return index, place


@asked_once
def needs(program: Program) -> tuple[tuple[Source, ...], ...]:
    """The sources of each instruction's arguments; an ELEMENT fixes its own."""
    found = []
    for number, instruction in enumerate(program.instructions):
        fixed: Fixed = (taken(program, number),) if instruction.op is Op.ELEMENT else ()
        found.append(tuple(s for a in instruction.args for s in sources(program, a, fixed)))
    return tuple(found)
