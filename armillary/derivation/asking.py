"""What a derivation insists on when a kernel is asked for: each function raises or returns."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import sympy

from armillary.algebra import scalar as s
from armillary.algebra.index import Index
from armillary.algebra.indexed import indices
from armillary.algebra.misuse import not_a_condition, told
from armillary.algebra.rigid import Pose, Twist, Wrench
from armillary.derivation.checking import check_expression, check_parts, check_symbols, check_unit
from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.names import check_name
from armillary.derivation.quantity import (
    AnyQuantity,
    Constant,
    ConstantTable,
    Quantity,
    Role,
)
from armillary.derivation.statements import Block, Case, Kernel, Output
from armillary.derivation.status import Status
from armillary.derivation.symbols import leaves

if TYPE_CHECKING:
    from armillary.derivation.record import Derivation

_OF_GUARDS = (Status.NOT_FINITE, Status.OUT_OF_RANGE)


def as_inputs(
    d: Derivation, inputs: object, kernel: str, source: Source
) -> tuple[AnyQuantity, ...]:
    """The inputs of a kernel, each a quantity that is not a parameter."""
    return tuple(_as_input(d, q, kernel, source) for q in _several("inputs", inputs, source))


def _several(argument: str, value: object, source: Source) -> Iterable[object]:
    if not isinstance(value, Iterable) or isinstance(value, (str, *Block.__args__)):
        raise DerivationError(
            f"{argument}= is {told(value)}, not a list", f"write {argument}=[...]", source
        )
    return value


def _as_input(d: Derivation, quantity: object, kernel: str, source: Source) -> AnyQuantity:
    if not isinstance(quantity, AnyQuantity):
        raise DerivationError(
            f"an input of kernel {kernel} is not a quantity of {d.name}",
            "list quantities made by d.angle, d.length, ... or a quantity's rate()",
            source,
        )
    if quantity.facts.role is not Role.INPUT:
        raise DerivationError(
            f"{quantity.name} is a {quantity.facts.role.value}, not an input",
            "leave it out of inputs=: every kernel gets all parameters by itself",
            source,
        )
    return quantity


def as_outputs(
    d: Derivation, outputs: Sequence[Block] | Mapping[str, Block], kernel: str, source: Source
) -> tuple[Output, ...]:
    """The results of a kernel under their names."""
    named = as_named_outputs(d, outputs, kernel, source)
    return tuple(_as_output(d, name, value, source) for name, value in named.items())


def as_named_outputs(
    d: Derivation, outputs: Sequence[Block] | Mapping[str, Block], kernel: str, source: Source
) -> Mapping[str, Block]:
    """What a kernel returns, by name: definitions have one."""
    if not isinstance(outputs, Mapping):
        by_name: dict[str, Block] = {}
        for value in _several("outputs", outputs, source):
            definition = d.definition_of(value)
            if definition is None:
                raise DerivationError(
                    "an output is not a definition, so it has no name",
                    "d.define it, or give outputs={'name': expression}",
                    source,
                )
            by_name[definition.name] = definition.value
        outputs = by_name
    if not outputs:
        raise DerivationError(
            f"kernel {kernel} has no outputs",
            "list in outputs= the definitions that it returns",
            source,
        )
    return outputs


def as_states(
    d: Derivation, states: object, start: object, controller: str, source: Source
) -> tuple[Quantity, ...]:
    """The states of a controller, each with what becomes of it and what it starts from."""
    for argument, value in (("states", states), ("start", start)):
        if not isinstance(value, Mapping):
            raise DerivationError(
                f"{argument}= of {controller} is {told(value)}, not a mapping",
                f"write {argument}={{state: expression}}",
                source,
            )
    assert isinstance(states, Mapping)
    assert isinstance(start, Mapping)
    for state in (*states, *start):
        if not isinstance(state, Quantity) or state.facts.role is not Role.STATE:
            raise DerivationError(
                f"{told(state)} is no state of {controller}", "make it by d.state", source
            )
        if state not in states or state not in start:
            missing = "states" if state not in states else "start"
            raise DerivationError(
                f"{state.name} is not in {missing}= of {controller}",
                "give each state an expression to become and one to start from",
                source,
            )
    return tuple(states)


def check_no_state(
    states: Sequence[Quantity], results: Mapping[str, Block], controller: str, source: Source
) -> None:
    """The new states come back under their names, so no other result may have one."""
    for state in states:
        if state.name in results:
            raise DerivationError(
                f"{state.name} is a state and a result of {controller}", "rename one", source
            )


def as_numbers(
    name: str, value: object, per: Index | None, source: Source
) -> tuple[sympy.Expr, ...]:
    """The exact value of a constant, or one for each part of an index."""
    given = value if per is not None else (value,)
    if isinstance(given, (str, s.Scalar)) or not isinstance(given, Sequence):
        raise DerivationError(
            f"{name} is per {per}, but its value is {told(value)}",
            "give a value for each part, in a tuple",
            source,
        )
    exact = [s.as_scalar(one) for one in given]
    if per is not None and len(exact) != per.size:
        raise DerivationError(
            f"{name} has {len(exact)} values for {per.size} parts of {per}",
            "give a value for each part",
            source,
        )
    numbers = tuple(e.value for e in exact if isinstance(e, s.Number))
    if len(numbers) != len(exact):
        raise DerivationError(
            f"the value of {name} is not a number", "give a number or a decimal string", source
        )
    return numbers


def _as_output(d: Derivation, name: str, value: Block, source: Source) -> Output:
    check_name(name, "result", source)
    check_expression(f"result {name}", value, source)
    check_symbols(d, f"result {name}", value, source)
    definition = d.definition_of(value)
    unit = definition.unit if definition else check_unit(name, value, None, source)
    if isinstance(value, (Pose, Twist)):
        value = value.matrix()
    if isinstance(value, (Wrench, s.Condition)):
        raise DerivationError(
            f"result {name} is a {type(value).__name__.lower()}, which no kernel returns whole",
            "return its parts as vectors",
            source,
        )
    return Output(name, value, definition, unit, check_parts(d, f"result {name}", value, source))


def as_cases(cases: object, kernel: str, source: Source) -> tuple[Case, ...]:
    """The points of a kernel that have a status of their own."""
    return tuple(_as_case(case, kernel, source) for case in _several("cases", cases, source))


def _as_case(case: Any, kernel: str, source: Source) -> Case:
    if not isinstance(case, (tuple, list)) or len(case) != 3:
        raise DerivationError(
            f"a case of kernel {kernel} is not a triple",
            'write cases=[(Status.SINGULAR, condition, "what holds there")]',
            source,
        )
    status, condition, because = case
    if not isinstance(status, Status):
        problem, mend = f"begins with {told(status)}, not with a Status", "begin it with Status.X"
    elif status is Status.OK:
        problem, mend = "answers OK", "leave it out: a kernel answers OK where no case holds"
    elif status in _OF_GUARDS:
        problem = f"answers {status.name}, which belongs to the limits of the inputs"
        mend = "declare limits= on the quantity, or answer with another status"
    elif not isinstance(condition, s.Condition):
        wrong = not_a_condition(condition)
        problem, mend = f"has no condition: {wrong.problem}", wrong.mend
    elif not isinstance(because, str) or not because.strip():
        problem, mend = "says nothing", "end it with a sentence on what holds there"
    else:
        check_unit(f"the case {status.name} of kernel {kernel}", condition, None, source)
        if indices(condition):
            names = ", ".join(sorted(map(str, indices(condition))))
            problem = f"{status.name} has a condition for each {names}, and one status"
            mend = f"write any_of(condition, over={names.split(', ')[0]})"
            raise DerivationError(f"a case of kernel {kernel}: {problem}", mend, source)
        return Case(status, condition, because)
    raise DerivationError(f"a case of kernel {kernel} {problem}", mend, source)


def check_reach(kernel: Kernel) -> None:
    """Every symbol that the results and cases need must be an argument or a constant."""
    given = {id(q) for q in (*kernel.inputs, *kernel.parameters)}
    wanted: list[tuple[str, object]] = [(f"result {o.name}", o.value) for o in kernel.outputs]
    wanted += [(f"the case {c.status.name}", c.condition) for c in kernel.cases]
    for what, value in wanted:
        for leaf in leaves(value):
            if id(leaf) not in given and not isinstance(leaf, (Constant, ConstantTable)):
                role, mend = "neither an input of the kernel nor a parameter", "add it to inputs="
                if isinstance(leaf, AnyQuantity) and leaf.facts.role is Role.UNKNOWN:
                    role, mend = "an unknown outside its iteration", "use what solve(...) returned"
                raise DerivationError(
                    f"{what} of kernel {kernel.name} needs {leaf.name}, which is {role}",
                    mend.replace("it to", f"{leaf.name} to"),
                    kernel.source,
                )


def check_arguments(kernel: Kernel) -> None:
    """Two arguments may not print as one name: vectors and rotations print by part too."""
    names = kernel.argument_names()
    twice = next((name for k, name in enumerate(names) if name in names[:k]), None)
    if twice is not None:
        raise DerivationError(
            f"kernel {kernel.name} has two arguments that print as {twice}",
            "rename one of them; the components of a vector v print as v_x, v_y, v_z, "
            "the entries of a rotation R as R_11 to R_33",
            kernel.source,
        )
