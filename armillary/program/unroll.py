"""A program without its loops: what they are worth, and what they are compared with."""

from __future__ import annotations

from dataclasses import replace
from functools import reduce
from typing import Any

from armillary.program.builder import Builder
from armillary.program.program import Instruction, Op, Program, domains, place_of
from armillary.program.rewrite import rebuilt
from armillary.program.walk import Step, walk


def unrolled(program: Program) -> Program:
    """The same values with every turn written out, and folded where it can be.

    Only what depends on no index keeps its definition's name.
    """
    builder, walked = Builder(), walk(program)
    new: list[int] = []
    for step in walked.steps:
        args = [new[k] for k in step.args]
        number = _turn(builder, program.instructions[step.number], args, step)
        new.append(number)
        if not domains(program)[step.number]:
            for label in program.labels.get(step.number, ()):
                builder.label(number, label.names, label.identifier)
    results = tuple(
        replace(r, entries=tuple(new[k] for k in walked.entries(program, r)), indices=())
        for r in program.results
    )
    cases = tuple((status, new[walked.numbers[c, ()]]) for status, c in program.cases)
    return builder.finish(program.kernel, results, cases, program.beforehand)


def _turn(b: Builder, instruction: Instruction, args: list[int], step: Step) -> int:
    """One instruction at one point."""
    data: Any = instruction.data
    if instruction.op is Op.TABLE:
        return b.constant(data[1][step.point[data[0]]])
    if instruction.op is Op.INPUT and isinstance(data, tuple):
        return b.emit(Op.INPUT, data=(data[0], place_of(data, step.point)))
    if instruction.op is Op.SUM:
        return reduce(b.add, args)
    if instruction.op is Op.ANY:
        return reduce(lambda x, y: b.invert(b.both(b.invert(x), b.invert(y))), args)
    if instruction.op in (Op.ELEMENT, Op.PHI):
        return args[0]
    return rebuilt(b, instruction, args)
