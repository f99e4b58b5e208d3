"""A program in two: a set-up that runs once a mount, and the step that it hands its values to.

Only what a step reads is handed over, a number or an array over one index; the field of each is
named like what it holds. A result that is known beforehand is still told by the step. A case that
is known beforehand is told by the set-up: a negative one ends there, since no step follows; any
other the steps repeat.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field, replace

from armillary.algebra.vector import AXIS_NAMES
from armillary.derivation.names import CLAIMED_IN_HEADERS
from armillary.derivation.quantity import AnyQuantity
from armillary.derivation.statements import Case, Kernel
from armillary.derivation.status import Status
from armillary.program.cost import Cost, cost
from armillary.program.program import (
    CONDITION_OPS,
    Field,
    Instruction,
    Op,
    Program,
    Result,
    domains,
    input_name,
)
from armillary.program.rates import handed, in_step, mounted, reached

# What costs nothing where it is written: a step has its own.
_WRITTEN = frozenset({Op.CONSTANT, Op.TABLE})
# The field of every context that a set-up writes last: a step runs only where it finds its mark.
READY = "ready"


@dataclass(frozen=True)
class Stages:
    """The two programs; the results of the set-up are the fields that the step reads."""

    setup: Program
    step: Program

    @property
    def fields(self) -> tuple[Field, ...]:
        """What the set-up hands over, in order."""
        return self.step.fields


def has_stages(kernel: Kernel, read: Collection[str]) -> bool:
    """Whether a kernel reads quantities of the mount, and others; a controller is not divided."""
    asked = {q.name for q in kernel.inputs} | set(read)
    held = mounted(kernel) & set(read)
    return bool(held and asked - mounted(kernel) and not kernel.stateful)


def gains(stages: Stages, whole: Cost) -> bool:
    """Whether a step costs less than the call of the undivided kernel, weighted."""
    return cost(stages.step).weighted < whole.weighted


def divided(program: Program) -> Stages:
    """The set-up and the step of a program that is told some quantities beforehand."""
    return _Division(program).run()


@dataclass
class _Division:
    """The walk that copies what runs in a step."""

    program: Program
    steps: list[Instruction] = field(default_factory=list)
    new: dict[int, int] = field(default_factory=dict)
    fields: dict[int, Field] = field(default_factory=dict)
    told: list[int] = field(init=False)

    def __post_init__(self) -> None:
        given, cases = handed(self.program), self.program.cases
        self.told = [k for k, (_, condition) in enumerate(cases) if given[condition]]

    def run(self) -> Stages:
        program, inside = self.program, in_step(self.program)
        phis = [n for n in program.carried if n in inside]
        for number in sorted(inside):
            i = program.instructions[number]
            self.add(number, replace(i, args=tuple(self.of(a) for a in i.args)))
        results = tuple(
            replace(r, entries=tuple(self.of(e) for e in r.entries)) for r in program.results
        )
        left = [k for k, (status, _) in enumerate(program.cases) if not self.ends(k, status)]
        cases = tuple((program.cases[k][0], self.of(program.cases[k][1])) for k in left)
        step = Program(
            _step_kernel(program, _those(program.kernel.cases, left)),
            tuple(self.steps),
            results,
            cases,
            {self.new[n]: ls for n, ls in program.labels.items() if n in inside},
            {self.new[n]: self.new[program.carried[n]] for n in phis},
            {self.new[n]: program.phi_domains[n] for n in phis},
            fields=tuple(self.fields.values()),
        )
        return Stages(self.setup(), step)

    def ends(self, case: int, status: Status) -> bool:
        """Whether no step follows where a case holds."""
        return case in self.told and status < 0

    def add(self, number: int, instruction: Instruction) -> int:
        self.steps.append(instruction)
        self.new[number] = len(self.steps) - 1
        return self.new[number]

    def of(self, number: int) -> int:
        """A value in the step: computed there, written there, or handed over."""
        if number in self.new:
            return self.new[number]
        i = self.program.instructions[number]
        if i.op in _WRITTEN:
            return self.add(number, i)
        if i.op is Op.NEGATE:
            return self.add(number, replace(i, args=(self.of(i.args[0]),)))
        made = self.made(number)
        self.fields[number] = made
        data = made.name if made.index is None else (made.name, made.index, 1, 0)
        return self.add(number, Instruction(Op.INPUT, (), data))

    def made(self, number: int) -> Field:
        """The field that a value is handed over in."""
        program, i = self.program, self.program.instructions[number]
        taken = _names(program) | {f.name for f in self.fields.values()}
        label = program.labels.get(number, ())
        index = next(iter(domains(program)[number]), None)
        while i.op is Op.ELEMENT:
            i = program.instructions[i.args[0]]
        return Field(
            _free(_wanted(program, number), taken),
            index,
            i.op in CONDITION_OPS,
            tuple(one.identifier for one in label),
        )

    def setup(self) -> Program:
        """What the fields and the cases need, with a result for each field."""
        program = self.program
        cases = [program.cases[k] for k in self.told]
        kept = sorted(reached(program, [*self.fields, *(condition for _, condition in cases)]))
        new = {old: k for k, old in enumerate(kept)}
        instructions = (program.instructions[old] for old in kept)
        phis = [n for n in program.carried if n in new]
        return Program(
            _setup_kernel(program, _those(program.kernel.cases, self.told)),
            tuple(replace(i, args=tuple(new[a] for a in i.args)) for i in instructions),
            tuple(_result(made, new[number]) for number, made in self.fields.items()),
            tuple((status, new[condition]) for status, condition in cases),
            {new[n]: ls for n, ls in program.labels.items() if n in new},
            {new[n]: new[program.carried[n]] for n in phis},
            {new[n]: program.phi_domains[n] for n in phis},
        )


def _result(made: Field, number: int) -> Result:
    indices = () if made.index is None else (made.index,)
    return Result(made.name, tuple(i.size for i in indices), (number,), indices)


def _those(cases: tuple[Case, ...], places: list[int]) -> tuple[Case, ...]:
    return tuple(cases[k] for k in places)


def _setup_kernel(program: Program, cases: tuple[Case, ...]) -> Kernel:
    kernel = program.kernel
    return replace(
        kernel,
        name=f"{kernel.name}_setup",
        inputs=_held(kernel.inputs, program.beforehand),
        outputs=(),
        cases=cases,
        stage="setup",
        whole=kernel.name,
    )


def _step_kernel(program: Program, cases: tuple[Case, ...]) -> Kernel:
    kernel, used = program.kernel, program.inputs_used()
    moving = [q for q in kernel.parameters if q.name in used]
    return replace(
        kernel,
        name=f"{kernel.name}_step",
        inputs=tuple(q for q in kernel.inputs if q.name not in program.beforehand),
        parameters=tuple(q for q in moving if q.name not in program.beforehand),
        cases=cases,
        stage="step",
        whole=kernel.name,
    )


def _held(quantities: tuple[AnyQuantity, ...], names: frozenset[str]) -> tuple[AnyQuantity, ...]:
    return tuple(q for q in quantities if q.name in names)


def _names(program: Program) -> set[str]:
    """What a field may not be called: it stands in a header, and beside others in a step."""
    kernel, told = program.kernel, program.beforehand
    moving = [q for q in (*kernel.inputs, *kernel.parameters) if q.name not in told]
    names = {n for q in moving for n in (q.name, *q.parts)} | CLAIMED_IN_HEADERS | {READY}
    return names | {n for o in kernel.outputs for n in (o.name, kernel.result_argument(o.name))}


def _wanted(program: Program, number: int) -> str:
    """The definition's name, the quantity's, that of the angle it is the sine of; m1, m2, ..."""
    i, label = program.instructions[number], program.labels.get(number)
    if label:
        return label[0].names[0]
    if i.op is Op.INPUT:
        return _read(program.kernel, i)
    if i.op in (Op.SIN, Op.COS) and program.instructions[i.args[0]].op is Op.INPUT:
        return f"{i.op.value}_{_read(program.kernel, program.instructions[i.args[0]])}"
    return ""


def _read(kernel: Kernel, i: Instruction) -> str:
    """The name of what an INPUT reads: a quantity, or a part of one."""
    name, data = input_name(i), i.data
    if not isinstance(data, tuple):
        return name
    if len(data) == 2:
        quantity = next(q for q in (*kernel.inputs, *kernel.parameters) if q.name == name)
        assert isinstance(data[1], int)
        return quantity.parts[data[1]]
    _, _, stride, offset = data
    return name if stride == 1 else f"{name}_{AXIS_NAMES[int(offset)]}"


def _free(wanted: str, taken: set[str]) -> str:
    """The name wanted, or one like it that nothing has."""
    if wanted and wanted not in taken:
        return wanted
    stem, k = f"{wanted}_m" if wanted else "m", 1
    while f"{stem}{k}" in taken:
        k += 1
    return f"{stem}{k}"
