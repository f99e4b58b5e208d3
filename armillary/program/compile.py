"""From a kernel to its cheapest program, each pass proved on the way."""

from __future__ import annotations

from dataclasses import dataclass, replace

from armillary.derivation.errors import DerivationError
from armillary.derivation.statements import Kernel
from armillary.derivation.status import worse
from armillary.program.arithmetic import Reals
from armillary.program.cost import Cost, cost, measure
from armillary.program.evaluate import Answer, evaluate
from armillary.program.lower import Strategy, lower
from armillary.program.passes import STAGES
from armillary.program.program import Program
from armillary.program.rates import mounted
from armillary.program.sample import sample_points
from armillary.program.search import Found, cheapest, cheapest_step
from armillary.program.stages import Stages, divided, gains, has_stages

AGREEMENT = "1e-40"


class PassError(AssertionError):
    """A pass changed a value or raised the cost: a defect of the pass."""


@dataclass(frozen=True)
class Compiled:
    """A kernel's program with the direction of evaluation that was chosen.

    `local` counts the vectors that are computed in another way than the strategy's.
    """

    found: Found
    cost: Cost

    @property
    def program(self) -> Program:
        return self.found.program

    @property
    def strategy(self) -> Strategy:
        return self.found.strategy

    @property
    def local(self) -> int:
        return len(self.found.local)


def compile_kernel(kernel: Kernel) -> Compiled:
    """Find the cheapest program and prove every pass that led to it.

    Raises:
        DerivationError: when the kernel has no real value somewhere in its range.
    """
    try:
        found = cheapest(kernel)
        _prove(kernel, found)
    except (ArithmeticError, TypeError, ValueError) as problem:
        culprit = _without_value(kernel)
        if culprit is None:
            raise
        raise DerivationError(
            f"{culprit} of kernel {kernel.name} of {kernel.system} has no real value "
            "everywhere in the range of its inputs: a root of something negative, "
            "or a division by 0",
            "guard it with where(condition, value, 1) before the root or the division, "
            "or narrow range= of the quantities it stands on",
            kernel.source,
        ) from problem
    return Compiled(found, cost(found.program))


def compile_stages(made: Compiled) -> Stages | None:
    """The set-up and the step of a kernel, proved too.

    None where it reads only one of the two, and where the step would cost no less than the call:
    a context would then be held for nothing. The step is the cheapest, counted without what the
    set-up does; it may be that of another program than the call's.
    """
    program, kernel = made.program, made.program.kernel
    if not has_stages(kernel, program.inputs_used()):
        return None
    plain = replace(made.found, program=replace(program, beforehand=mounted(kernel)))
    found = cheapest_step(plain)
    if found.program.inputs_used() != program.inputs_used():
        found = plain  # what is refused must be the same
    if found is not plain:
        _prove(kernel, found)
    stages = divided(found.program)
    if not gains(stages, made.cost):
        return None
    for point in sample_points(kernel, 2):
        whole = evaluate(program, point, Reals())
        _compare("division", program, _flat(_in_two(stages, point, whole)), _flat(whole))
    return stages


def _in_two(stages: Stages, point: dict[str, object], whole: Answer) -> Answer:
    """What a set-up and a step say together.

    Nothing follows a set-up that refuses: what the call says beyond that is not asked.
    """
    before = evaluate(stages.setup, point, Reals())
    if before.status < 0:
        return replace(before, status=min(before.status, whole.status))
    after = evaluate(stages.step, {**point, **before.results}, Reals())
    return replace(after, status=worse(before.status, after.status))


def _without_value(kernel: Kernel) -> str | None:
    """The first result or case that cannot be computed, each tried by itself."""
    parts = [(f"result {o.name}", replace(kernel, outputs=(o,), cases=())) for o in kernel.outputs]
    parts += [
        (f"the case {c.status.name}", replace(kernel, outputs=(), cases=(c,))) for c in kernel.cases
    ]
    points = sample_points(kernel, 2)
    for name, part in parts:
        try:
            program = lower(part, Strategy())
            for point in points:
                _compare("nothing", program, _values(program, point), _values(program, point))
        except (ArithmeticError, TypeError, ValueError):
            return name
    return None


def _prove(kernel: Kernel, found: Found) -> None:
    """Run the passes again, comparing values and cost after each."""
    program = lower(kernel, found.strategy, found.local, found.program.beforehand)
    plain = lower(kernel, Strategy())
    points = sample_points(kernel, 2)
    expected = [_values(plain, point) for point in points]
    before = measure(program)[0]
    for step in (_same, *STAGES):
        program = step(program)
        after = measure(program)[0]
        if after > before:
            raise PassError(
                f"{step.__name__} raised the cost of {program.name}: {before} to {after}"
            )
        before = after
        for point, wanted in zip(points, expected, strict=True):
            _compare(step.__name__, program, _values(program, point), wanted)


def _same(program: Program) -> Program:
    return program


def _values(program: Program, point: dict[str, object]) -> list[object]:
    return _flat(evaluate(program, point, Reals()))


def _flat(answer: Answer) -> list[object]:
    flat: list[object] = [answer.status]
    for value in answer.results.values():
        flat.extend(value if isinstance(value, list) else [value])
    return flat


def _compare(step: str, program: Program, found: list[object], wanted: list[object]) -> None:
    reals = Reals()
    for a, b in zip(found, wanted, strict=True):
        difference = abs(reals.number(a) - reals.number(b))
        if difference > reals.number(AGREEMENT) * (1 + abs(reals.number(b))):
            raise PassError(f"{step} changed a value of {program.name} by {difference}")
