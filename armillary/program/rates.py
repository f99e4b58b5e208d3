"""What a set-up can compute ahead of the steps: all that stands on known quantities alone.

The quantities that a program is told beforehand (`Program.beforehand`) change so seldom that what
follows from them costs a step nothing. A step is handed numbers, and arrays over one index: what
runs over more stays with the step.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from armillary.derivation.quantity import Rate
from armillary.derivation.statements import Kernel
from armillary.program.program import Domain, Op, Program, asked_once, domains, input_name, turns


def mounted(kernel: Kernel) -> frozenset[str]:
    """The names of a kernel's quantities that change with the mount only."""
    quantities = (*kernel.inputs, *kernel.parameters)
    return frozenset(q.name for q in quantities if q.facts.rate is Rate.MOUNT)


@asked_once
def known(program: Program) -> tuple[bool, ...]:
    """Whether each value follows from what is known beforehand."""
    if not program.beforehand:
        return (False,) * len(program.instructions)
    found = _followed(program, frozenset())
    while True:
        # What is carried is known only if what it goes on with is.
        torn = {phi for phi, after in program.carried.items() if found[phi] and not found[after]}
        if not torn:
            return found
        open_phis = torn | {phi for phi in program.carried if not found[phi]}
        found = _followed(program, frozenset(open_phis))


def _followed(program: Program, open_phis: frozenset[int]) -> tuple[bool, ...]:
    found: list[bool] = []
    for number, i in enumerate(program.instructions):
        if i.op is Op.INPUT:
            found.append(input_name(i) in program.beforehand)
        else:
            found.append(number not in open_phis and all(found[a] for a in i.args))
    return tuple(found)


def is_handed(is_known: bool, domain: Domain) -> bool:
    """Whether a step need not compute a value of this domain."""
    return is_known and len(domain) <= 1 and not any(index.sequential for index in domain)


@asked_once
def handed(program: Program) -> tuple[bool, ...]:
    """Whether a step is handed each value, if it needs it."""
    return tuple(
        is_handed(is_known, domain)
        for is_known, domain in zip(known(program), domains(program), strict=True)
    )


@asked_once
def in_step(program: Program) -> frozenset[int]:
    """The instructions that run in every step."""
    given = handed(program)
    asked = [e for result in program.results for e in result.entries]
    asked += [condition for _, condition in program.cases]
    return frozenset(reached(program, asked, lambda number: given[number]))


def reached(
    program: Program, start: Iterable[int], at_hand: Callable[[int], bool] = lambda _: False
) -> set[int]:
    """The instructions that some values are computed by, as far as those are not at hand."""
    stack, found = list(start), set[int]()
    while stack:
        number = stack.pop()
        if number not in found and not at_hand(number):
            found.add(number)
            stack.extend(program.instructions[number].args)
            if number in program.carried:
                stack.append(program.carried[number])
    return found


@asked_once
def runs(program: Program) -> tuple[int, ...]:
    """How often each instruction runs in a step; in a call, where nothing is known beforehand."""
    step = in_step(program)
    return tuple(
        turns(domain) if number in step else 0 for number, domain in enumerate(domains(program))
    )
