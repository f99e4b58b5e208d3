"""What a derivation insists on when something is stated: each function raises or returns."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.misuse import not_a_condition, told
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation
from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.names import check_name
from armillary.derivation.quantity import (
    AnyQuantity,
    Constant,
    Role,
)
from armillary.derivation.statements import Block, Case, Kernel, Output
from armillary.derivation.status import Status
from armillary.derivation.symbols import leaves
from armillary.derivation.units import Unit, UnitError, check_block
from armillary.mechanism.chain import Chain

if TYPE_CHECKING:
    from armillary.derivation.record import Derivation

_OF_GUARDS = (Status.NOT_FINITE, Status.OUT_OF_RANGE)


def check_expression(what: str, value: object, source: Source) -> None:
    """Only expressions can be stated, no numbers, lists or whole mechanisms."""
    if isinstance(value, Block):
        return
    raise DerivationError(f"{what} is {told(value)}, not an expression", _mend_of(value), source)


def _mend_of(value: object) -> str:
    if isinstance(value, bool):
        return "== does not compare here: use < and >"
    if value is None:
        return "give an expression; a function that makes one needs a return"
    if isinstance(value, (int, float, str)):
        return "wrap numbers in number(...)"
    if isinstance(value, sympy.Basic):
        return (
            "wrap numbers in number(...), and write the rest in quantities and words of armillary"
        )
    if isinstance(value, Chain):
        return 'ask the chain for what is wanted, as in chain.pose("ground", "tip")'
    if callable(value):
        return "call it, with its arguments in parentheses"
    return (
        "state scalars, vectors, rotations, poses, twists, wrenches and matrices; "
        "vector(x, y, z) makes a vector of three scalars, and number(...) wraps a number"
    )


def check_symbols(d: Derivation, what: str, expression: Block, source: Source) -> None:
    """Every symbol must be known here or in a system that is used."""
    for leaf in leaves(expression):
        known = d.quantities.get(leaf.name) or d.constants.get(leaf.name)
        if known is leaf or any(leaf in used for used in d.used.values()):
            continue
        raise DerivationError(
            f"{what} of {d.name} uses {leaf.name}, which {d.name} does not define",
            f"declare it in this derivation, or take it from its own with "
            f'd.use("<system>").quantity("{leaf.name}")',
            source,
        )


def check_unit(name: str, expression: Block, unit: Unit | None, source: Source) -> Unit | None:
    """The unit of an expression, which must be what was stated if anything was."""
    try:
        found = check_block(expression)
    except UnitError as problem:
        raise DerivationError(f"units in {name}: {problem}", problem.mend, source) from None
    if unit is not None and found is not None and not unit.agrees(found):
        raise DerivationError(
            f"{name} is stated in {unit}, but its expression is in {found}",
            "correct the unit= or the expression",
            source,
        )
    return unit or found


def check_reason(name: str, because: object, source: Source) -> str:
    """A definition says why."""
    if isinstance(because, str) and because.strip():
        return because.strip()
    raise DerivationError(
        f"{name} gives no reason", "say in because= why this step is taken", source
    )


def check_meaning(name: str, meaning: object, source: Source) -> None:
    """A quantity says what it is: the page and the headers print it."""
    if not isinstance(meaning, str) or not meaning.strip():
        raise DerivationError(
            f"{name} has no meaning", "say in a few words what it is, after its name", source
        )


# -- identities ------------------------------------------------------------------------------


def check_identity(d: Derivation, claim: str, left: Block, right: Block, source: Source) -> None:
    """Both sides are expressions of one kind, shape and unit."""
    what = f"identity {claim!r}"
    sides, units = (("the left side", left), ("the right side", right)), []
    for side, value in sides:
        check_expression(f"{side} of {what}", value, source)
        check_symbols(d, what, value, source)
        units.append(check_unit(f"{side} of {what}", value, None, source))
    kinds = [_kind(claim, value, source) for value in (left, right)]
    if kinds[0] != kinds[1]:
        raise DerivationError(
            f"{what} compares {kinds[0]} with {kinds[1]}",
            "give both sides one shape: take components, or make a vector of scalars",
            source,
        )
    if None not in units and not units[0].agrees(units[1]):  # type: ignore[union-attr,arg-type]
        raise DerivationError(
            f"{what} compares {units[0]} with {units[1]}",
            "a factor with a unit is missing on one side, or a symbol has a wrong unit=",
            source,
        )


def _kind(claim: str, value: Block, source: Source) -> str:
    if isinstance(value, s.Condition):
        raise DerivationError(
            f"identity {claim!r} compares conditions",
            "compare the scalars that the conditions compare",
            source,
        )
    if isinstance(value, (Twist, Wrench)):
        return f"a {type(value).__name__.lower()}"
    shape = _shape(value)
    if not shape:
        return "a scalar"
    return "a vector" if shape == (3, 1) else f"a {shape[0]} by {shape[1]} matrix"


def _shape(value: Pose | Matrix | Rotation | s.Scalar | v.Vector) -> tuple[int, ...]:
    if isinstance(value, s.Scalar):
        return ()
    if isinstance(value, v.Vector):
        return (3, 1)
    if isinstance(value, Rotation):
        return (3, 3)
    return value.shape if isinstance(value, Matrix) else (4, 4)


# -- kernels ---------------------------------------------------------------------------------


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
    return tuple(_as_output(d, name, value, source) for name, value in outputs.items())


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
    return Output(name, value, definition, unit)


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
        return Case(status, condition, because)
    raise DerivationError(f"a case of kernel {kernel} {problem}", mend, source)


def check_reach(kernel: Kernel) -> None:
    """Every symbol that the results and cases need must be an argument or a constant."""
    given = {id(q) for q in (*kernel.inputs, *kernel.parameters)}
    wanted: list[tuple[str, object]] = [(f"result {o.name}", o.value) for o in kernel.outputs]
    wanted += [(f"the case {c.status.name}", c.condition) for c in kernel.cases]
    for what, value in wanted:
        for leaf in leaves(value):
            if id(leaf) not in given and not isinstance(leaf, Constant):
                raise DerivationError(
                    f"{what} of kernel {kernel.name} needs {leaf.name}, "
                    "which is neither an input of the kernel nor a parameter",
                    f"add {leaf.name} to inputs=",
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
