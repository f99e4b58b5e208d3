"""What the inputs of a kernel are drawn as for its checks, where their ranges alone will not do."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from armillary.algebra.misuse import told
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation
from armillary.algebra.scalar import Condition
from armillary.derivation.checking import check_expression, check_parts, check_symbols, check_unit
from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.quantity import (
    AnyQuantity,
    Constant,
    ConstantTable,
    Kind,
    Role,
)
from armillary.derivation.statements import Block, Drawn, Kernel, Output
from armillary.derivation.symbols import leaves

if TYPE_CHECKING:
    from armillary.derivation.record import Derivation

_KNOWN = (Role.INPUT, Role.PARAMETER)


@dataclass(frozen=True, eq=False)
class Near:
    """An expression that is met but for `by`, in each component."""

    value: Block
    by: float


def near(value: Block, *, by: float) -> Near:
    """In `drawn=` of a kernel: not the value itself, but up to `by` off it in each component.

    Args:
        by: in the unit of the input that is drawn.
    """
    return Near(value, by)


def as_drawn(
    d: Derivation, drawn: object, inputs: tuple[AnyQuantity, ...], kernel: str, source: Source
) -> tuple[Drawn, ...]:
    """What each input or parameter that is named is drawn as; ranges are what the others have."""
    if not isinstance(drawn, Mapping):
        raise DerivationError(
            f"drawn= of kernel {kernel} is {told(drawn)}, not a mapping",
            "write drawn={input: expression}",
            source,
        )
    known = (*inputs, *d.parameters)
    for quantity, value in drawn.items():
        if quantity not in known:
            name = quantity.name if isinstance(quantity, AnyQuantity) else told(quantity)
            raise DerivationError(
                f"drawn= of kernel {kernel} tells what {name} is, which is no input or "
                "parameter of it",
                "name its inputs and parameters only",
                source,
            )
        _check_leaves(quantity.name, value, tuple(drawn), kernel, source)
    return tuple(_as_drawn(d, q, value, kernel, source) for q, value in drawn.items())


def others(kernel: Kernel) -> tuple[AnyQuantity, ...]:
    """The quantities that inputs are drawn by and the kernel does not take."""
    taken = {*kernel.inputs, *kernel.parameters}
    found = [leaf for one in kernel.drawn for leaf in leaves(one.output.value)]
    wanted = [q for q in found if isinstance(q, AnyQuantity) and q not in taken]
    return tuple(dict.fromkeys(wanted))


def _as_drawn(
    d: Derivation, quantity: AnyQuantity, value: object, kernel: str, source: Source
) -> Drawn:
    what = f"what {quantity.name} of kernel {kernel} is drawn as"
    by = 0.0
    if isinstance(value, Near):
        by = _as_distance(what, quantity, value.by, source)
        value = value.value
    check_expression(what, value, source)
    assert isinstance(value, Block)
    check_symbols(d, what, value, source)
    entries = [e for row in value.rows for e in row] if isinstance(value, Matrix) else [value]
    for entry in entries:
        check_unit(what, entry, quantity.unit, source)
    shape: object = "no value of an input"
    if not isinstance(value, (Pose, Twist, Wrench, Condition)):
        made = Output(
            quantity.name, value, None, quantity.unit, check_parts(d, what, value, source)
        )
        if made.shape == quantity.shape and _is_kind(quantity, value):
            return Drawn(quantity, made, by)
        shape = made.shape or "a scalar"
    raise DerivationError(
        f"{what} is {shape}, and {quantity.name} is {quantity.shape or 'a scalar'}",
        "give an expression of the input's own shape; what is per an index runs over it",
        source,
    )


def _is_kind(quantity: AnyQuantity, value: Block) -> bool:
    return isinstance(value, Rotation) == (quantity.facts.kind is Kind.ROTATION)


def _as_distance(what: str, quantity: AnyQuantity, by: object, source: Source) -> float:
    if quantity.facts.kind in (Kind.UNIT_VECTOR, Kind.ROTATION):
        raise DerivationError(
            f"{what} is near a {quantity.facts.kind.value}, which would be none",
            "give an expression that has the kind: turn it by a quantity of its own",
            source,
        )
    if isinstance(by, bool) or not isinstance(by, (int, float)) or not 0 < by < math.inf:
        raise DerivationError(
            f"{what} is off by {told(by)}", "give by= as a number above 0", source
        )
    return float(by)


def _check_leaves(
    name: str, value: object, drawn: tuple[AnyQuantity, ...], kernel: str, source: Source
) -> None:
    """What an input is drawn as stands on what has a range of its own."""
    for leaf in leaves(value):
        if isinstance(leaf, (Constant, ConstantTable)):
            continue
        if leaf in drawn:
            problem = f"{leaf.name}, which is drawn by an expression too"
        elif isinstance(leaf, AnyQuantity) and leaf.facts.role not in _KNOWN:
            article = "an" if leaf.facts.role is Role.UNKNOWN else "a"
            problem = f"{leaf.name}, which is {article} {leaf.facts.role.value}"
        else:
            continue
        raise DerivationError(
            f"{name} of kernel {kernel} is drawn as an expression of {problem}",
            "give an expression of inputs and parameters that are drawn from their ranges",
            source,
        )
