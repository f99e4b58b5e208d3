"""Units that a nomenclature prints, against those that the derivation has."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix
from armillary.derivation.paper import Paper
from armillary.derivation.printed_units import UNITS, Factors, InUnit, product_of, written
from armillary.derivation.units import ONE, RADIAN, Unit, UnitError, check_block
from armillary.verify.audit.claims import claimed
from armillary.verify.audit.sentences import finding_of
from armillary.verify.audit.verdict import Finding, Repair, Verdict

_POWERS = (1, 2, 3, 4)


def in_unit(paper: Paper, said: InUnit) -> Finding:
    """The printed unit beside the derived one; where they differ, the smallest change."""
    derived = _unit(said)
    told = _told(derived)
    repair = None
    if product_of(said.factors).agrees(derived):
        verdict, says = Verdict.HOLDS, f"It holds: derived is {told}."
    else:
        mended = next((f for f in _changed(said.factors) if product_of(f).agrees(derived)), None)
        if mended is None:
            verdict, says = Verdict.WRONG, f"Derived is {told}, and no small change mends it."
        else:
            words = f"{written(mended)} for {written(said.factors)}"
            repair = Repair("unit", words, "", 1)
            verdict, says = Verdict.MISPRINT, f"It holds with {words}."
    made = finding_of(paper, said.key, verdict, said.quote, says, repair)
    found = [claimed(entry, paper) for entry in _entries(said)]
    claims = tuple(dict.fromkeys(d.identifier for d in found if d is not None))
    return replace(made, words="row of the nomenclature", claims=claims)


def _entries(said: InUnit) -> list[s.Scalar | v.Vector]:
    """What the symbol stands for; the entries of a matrix one by one."""
    if not isinstance(said.value, Matrix):
        return [said.value]
    return [entry for row in said.value.rows for entry in row]


def _unit(said: InUnit) -> Unit:
    """The unit that follows from the derivation; entries of a matrix must agree.

    Raises:
        UnitError: where they do not.
    """
    units = [check_block(entry) or ONE for entry in _entries(said)]
    if not all(units[0].agrees(other) for other in units):
        raise UnitError(f"the entries of {said.key} have several units")
    return units[0]


def _told(unit: Unit) -> str:
    return "an angle" if unit == RADIAN else "a ratio" if unit == ONE else str(unit)


def _changed(factors: Factors) -> Iterator[Factors]:
    """What a slip makes of a unit: another power, powers exchanged, another unit."""
    for k, (name, power) in enumerate(factors):
        sign = 1 if power > 0 else -1
        for other in _POWERS:
            yield (*factors[:k], (name, sign * other), *factors[k + 1 :])
    for i in range(len(factors)):
        for j in range(i + 1, len(factors)):
            yield _exchanged(factors, i, j)
    for k, (_, power) in enumerate(factors):
        for name in UNITS:
            yield (*factors[:k], (name, power), *factors[k + 1 :])


def _exchanged(factors: Factors, i: int, j: int) -> Factors:
    """The powers of two units in each other's place; what is divided by stays divided by."""
    made = list(factors)
    for here, there in ((i, j), (j, i)):
        name, power = factors[here]
        made[here] = name, (1 if power > 0 else -1) * abs(factors[there][1])
    return tuple(made)
