"""What a derivation insists on when something is stated: each function raises or returns."""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.index import Index
from armillary.algebra.indexed import indices
from armillary.algebra.misuse import told
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation
from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.statements import Block
from armillary.derivation.symbols import leaves
from armillary.derivation.units import Unit, UnitError, check_block
from armillary.mechanism.chain import Chain

if TYPE_CHECKING:
    from armillary.derivation.record import Derivation


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


def check_parts(d: Derivation, what: str, value: object, source: Source) -> tuple[Index, ...]:
    """The indices that an expression is left open in, in the order declared."""
    open_in = indices(value)
    known = d.all_indices()
    missing = sorted(i.name for i in open_in if i not in known)
    if missing:
        raise DerivationError(
            f"{what} runs over {missing[0]}, which is no index of {d.name}",
            f'declare it with d.index("{missing[0]}", ...)',
            source,
        )
    return tuple(i for i in known if i in open_in)


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


def check_per(d: Derivation, name: str, per: object, source: Source) -> None:
    """What a quantity is per is an index of the derivation, or of one that it uses."""
    if per is None:
        return
    if not isinstance(per, Index):
        mend = 'write leg = d.index("leg", 3) before, and give per=leg'
        raise DerivationError(f"{name} is per {told(per)}, not per an index", mend, source)
    if per not in d.all_indices():
        names = ", ".join(str(i) for i in d.all_indices()) or "none yet"
        raise DerivationError(
            f"{name} is per {per}, which is no index of {d.name}",
            f"declare it with d.index(...); it has {names}",
            source,
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
    check_parts(d, what, (left, right), source)
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
