"""Runs a program on any number system: the reference that every target is compared with."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial, reduce
from math import prod
from typing import Any

from armillary.algebra.index import Index
from armillary.derivation.status import Status, worse
from armillary.program.arithmetic import Arithmetic, Reals
from armillary.program.guards import Guard
from armillary.program.program import Instruction, Program, place_of
from armillary.program.walk import Step, walk

Inputs = Mapping[str, Any]


@dataclass(frozen=True)
class Answer:
    """What a kernel returns; `results` is empty when the status is negative."""

    status: int
    results: dict[str, Any]


def evaluate(program: Program, inputs: Inputs, arithmetic: Arithmetic | None = None) -> Answer:
    """Run a program; scalars by name, vectors and rotations as flat sequences, without guards.

    Loops run turn by turn. Results are scalars or flat lists, row-major over indices and shape.
    """
    run, walked = _Run(inputs, arithmetic or Reals()), walk(program)
    values: list[Any] = []
    for step in walked.steps:
        values.append(run.step(program.instructions[step.number], step, values))
    status = int(Status.OK)
    for case, condition in program.cases:
        if values[walked.numbers[condition, ()]]:
            status = worse(status, int(case))
    if status < 0:
        return Answer(status, {})
    found = {r.name: [values[k] for k in walked.entries(program, r)] for r in program.results}
    return Answer(
        status, {r.name: found[r.name] if r.shape else found[r.name][0] for r in program.results}
    )


def guard_status(guards: Sequence[Guard], inputs: Mapping[str, Any]) -> int:
    """What the guards say of plain float inputs: 0, NOT_FINITE or OUT_OF_RANGE."""
    status = int(Status.OK)
    for guard in guards:
        value = _guarded(guard, inputs[guard.name])
        if guard.low <= value <= guard.high:
            continue
        finite = value == value and abs(value) != float("inf")
        status = worse(status, int(Status.OUT_OF_RANGE if finite else Status.NOT_FINITE))
    return status


def _guarded(guard: Guard, whole: Any) -> float:
    """The number that a guard bounds."""
    if guard.form is None:
        return float(whole if guard.index is None else whole[guard.index])
    return sum(sign * prod(float(whole[k]) for k in places) for sign, places in guard.form.terms)


class _Run:
    def __init__(self, inputs: Inputs, arithmetic: Arithmetic) -> None:
        self.inputs, self.a = inputs, arithmetic
        self.point: dict[Index, int] = {}

    def step(self, instruction: Instruction, step: Step, values: list[Any]) -> Any:
        rule = getattr(self, instruction.op.value)
        self.point = step.point
        return rule(instruction.data, *(values[k] for k in step.args))

    def constant(self, data: Any) -> Any:
        return self.a.constant(data)

    def input(self, data: Any) -> Any:
        if not isinstance(data, tuple):
            return self.inputs[data]
        return self.inputs[data[0]][place_of(data, self.point)]

    def table(self, data: Any) -> Any:
        return self.a.constant(data[1][self.point[data[0]]])

    def sum(self, _: Any, *terms: Any) -> Any:
        join = self.add_vectors if isinstance(terms[0], list) else self.add
        return reduce(partial(join, None), terms)

    def any(self, _: Any, *conditions: bool) -> bool:
        return any(conditions)

    def element(self, _: Any, x: Any) -> Any:
        return x

    def phi(self, _: Any, x: Any) -> Any:
        return x

    def negate(self, _: Any, x: Any) -> Any:
        return self.a.negate(x)

    def add(self, _: Any, x: Any, y: Any) -> Any:
        return self.a.add(x, y)

    def multiply(self, _: Any, x: Any, y: Any) -> Any:
        return self.a.multiply(x, y)

    def divide(self, _: Any, x: Any, y: Any) -> Any:
        return self.a.divide(x, y)

    def sqrt(self, _: Any, x: Any) -> Any:
        return self.a.sqrt(x)

    def sin(self, _: Any, x: Any) -> Any:
        return self.a.sin(x)

    def cos(self, _: Any, x: Any) -> Any:
        return self.a.cos(x)

    def atan2(self, _: Any, y: Any, x: Any) -> Any:
        return self.a.atan2(y, x)

    def absolute(self, _: Any, x: Any) -> Any:
        return self.a.absolute(x)

    def less(self, _: Any, x: Any, y: Any) -> bool:
        return self.a.less(x, y)

    def both(self, _: Any, x: bool, y: bool) -> bool:
        return x and y

    def select(self, _: Any, condition: bool, then: Any, otherwise: Any) -> Any:
        return then if condition else otherwise

    def pack(self, _: Any, *components: Any) -> Any:
        return list(components)

    def pick(self, data: Any, vector: Any) -> Any:
        return vector[data]

    def add_vectors(self, _: Any, x: Any, y: Any) -> Any:
        return [self.a.add(p, q) for p, q in zip(x, y, strict=True)]

    def negate_vector(self, _: Any, x: Any) -> Any:
        return [self.a.negate(p) for p in x]

    def scale(self, _: Any, factor: Any, x: Any) -> Any:
        return [self.a.multiply(factor, p) for p in x]

    def rotate(self, axis: Any, sine: Any, cosine: Any, x: Any) -> Any:
        first, second = (axis + 1) % 3, (axis + 2) % 3
        turned = list(x)
        m, n = self.a.multiply, self.a.negate
        turned[first] = self.a.add(m(cosine, x[first]), n(m(sine, x[second])))
        turned[second] = self.a.add(m(sine, x[first]), m(cosine, x[second]))
        return turned

    def cross(self, _: Any, x: Any, y: Any) -> Any:
        def minor(i: int, j: int) -> Any:
            return self.a.add(
                self.a.multiply(x[i], y[j]), self.a.negate(self.a.multiply(x[j], y[i]))
            )

        return [minor(1, 2), minor(2, 0), minor(0, 1)]

    def dot(self, _: Any, x: Any, y: Any) -> Any:
        terms = [self.a.multiply(p, q) for p, q in zip(x, y, strict=True)]
        return self.a.add(self.a.add(terms[0], terms[1]), terms[2])


# `not` is a keyword, so the rule of that name is attached by hand.
setattr(_Run, "not", lambda self, _, x: not x)
