"""The verdict on one reading of a printed equation."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from armillary.derivation.errors import DerivationError
from armillary.derivation.paper import Equation, Paper
from armillary.derivation.statements import Block
from armillary.verify.audit import points as p
from armillary.verify.audit.changes import Changes
from armillary.verify.audit.claims import instead
from armillary.verify.audit.compare import Bench
from armillary.verify.audit.numbers import Doubles
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.order import mixed_order
from armillary.verify.audit.pool import Pool
from armillary.verify.audit.properties import not_orthonormal
from armillary.verify.audit.repairs import entry_repair, repeated
from armillary.verify.audit.sides import Place, Sides, sides_of
from armillary.verify.audit.special import special_repair
from armillary.verify.audit.verdict import (
    Counterexample,
    Entry,
    Read,
    Repair,
    Verdict,
    steady,
)
from armillary.verify.audit.wholes import is_written_out, whole_repair

Latex = Callable[[Any], str]
ORDERED = list(Verdict)
# A print that holds for another thing of these kinds was no slip of the pen.
_FAR = ("frame", "definition", "special value", "order of factors")
_UNDEFINED = 0.05
_PATIENCE = 2  # entries without a small repair, after which the others get no deep search


@dataclass(frozen=True, eq=False)
class Explained:
    """How the bad entries of a print are explained."""

    whole: Repair | None
    verdict: Verdict
    repairs: dict[Place, Repair]


def read(equation: Equation, name: str, printed: Block, paper: Paper, latex: Latex | None) -> Read:
    """Compare one reading with what it claims, and look for the smallest repair."""
    pool = Pool(printed, equation.claims, paper)
    extra = [*pool.scalars, *pool.vectors, *instead(equation, paper)]
    bench = Bench((printed, equation.claims), equation.small, equation.given, extra)
    if not p.count(bench.points):
        raise DerivationError(
            f"the condition of ({equation.key}) holds at no point that was tried",
            "give a condition that is met over the working ranges",
            equation.source,
        )
    sides = sides_of(bench, printed, equation.claims)
    explained = _explained(sides, equation, paper, printed, Changes(pool), latex)
    entries = tuple(_entry(sides, place, explained) for place in sides.places)
    verdict, order = _overall(entries, explained)
    failing = verdict is not Verdict.HOLDS
    return Read(
        reading=name,
        verdict=verdict,
        order=order,
        whole=explained.whole if explained else None,
        entries=entries,
        properties=_properties(sides, order, explained) if failing else (),
        counterexample=_counterexample(sides, entries, paper) if failing else None,
        worst=max((e.worst for e in entries if not np.isnan(e.worst)), default=0.0),
    )


def _explained(
    sides: Sides,
    equation: Equation,
    paper: Paper,
    printed: Block,
    changes: Changes,
    latex: Latex | None,
) -> Explained | None:
    bad = sides.bad
    if not bad:
        return None
    one = sides.shape == (1, 1)
    whole: tuple[Repair, Block | None] | None = None
    repairs = _entry_repairs(sides, changes, latex, deep=False) if one else {}
    if not repairs:
        whole = whole_repair(sides, equation, paper, printed, changes)
    if not repairs and (whole is None or whole[0].size >= (2 if one else len(bad))):
        repairs = _entry_repairs(sides, changes, latex) if is_written_out(printed) else {}
    if len(repairs) == len(bad) and (
        whole is None or whole[0].size >= sum(r.size for r in repairs.values())
    ):
        return Explained(None, worst_of(map(verdict_of, repairs.values())), repairs)
    if whole is not None:
        repair, block = whole
        if block is not None and latex is not None:
            repair = replace(repair, latex=latex(block))
        return Explained(repair, verdict_of(repair), {})
    special = special_repair(sides)
    return Explained(special, Verdict.WRONG, repairs)


def _entry_repairs(
    sides: Sides, changes: Changes, latex: Latex | None, deep: bool = True
) -> dict[Place, Repair]:
    """The smallest repair of each bad entry that has one; `deep` tries two changes at once."""
    found = {}
    failed = 0 if deep else _PATIENCE
    for place in sides.bad:
        printed, derived = sides.pair(place)
        repair = entry_repair(
            sides.bench, printed, derived, changes, latex, deep=failed < _PATIENCE
        )
        repair = repair or repeated(sides, place)
        if repair is None:
            failed += 1
        else:
            found[place] = repair
    return found


def verdict_of(repair: Repair) -> Verdict:
    """What a print is that one repair mends."""
    if repair.elsewhere and repair.kind in _FAR:
        return Verdict.WRONG
    return Verdict.SIGN if repair.kind == "sign" else Verdict.MISPRINT


def worst_of(verdicts: Iterable[Verdict]) -> Verdict:
    """The worst; a misprint is worse than a sign, for a reader must look harder to mend it."""
    return max(verdicts, key=ORDERED.index)


def _entry(sides: Sides, place: Place, explained: Explained | None) -> Entry:
    outcome = sides.outcomes[place]
    row, column = place[0] + 1, place[1] + 1
    if outcome.exact:
        return Entry(row, column, Verdict.HOLDS)
    worst = steady(sides.bench.worst(*sides.pair(place)), 6)
    if outcome.holds:
        return Entry(row, column, Verdict.ORDER, outcome.order, worst=worst)
    assert explained is not None
    repair = explained.repairs.get(place)
    if repair is not None:
        return Entry(row, column, verdict_of(repair), outcome.order, repair, worst)
    verdict = explained.verdict if explained.whole is not None else Verdict.WRONG
    return Entry(row, column, verdict, outcome.order, worst=worst)


def _overall(entries: Sequence[Entry], explained: Explained | None) -> tuple[Verdict, int | None]:
    if explained is not None:
        bad = [e for e in entries if e.verdict not in (Verdict.HOLDS, Verdict.ORDER)]
        orders = [e.order for e in bad if e.order is not None]
        return explained.verdict, min(orders, default=None)
    orders = [e.order for e in entries if e.order is not None]
    if not orders:
        return Verdict.HOLDS, None
    return Verdict.ORDER, min(orders)


def _properties(sides: Sides, order: int | None, explained: Explained | None) -> tuple[str, ...]:
    told = [not_orthonormal(sides)]
    # Against a transpose, terms that merely stand elsewhere would count as kept and as lacking.
    whole = explained.whole if explained else None
    moved = whole is not None and whole.kind != "special value"
    if order is not None and order >= 0 and not moved:
        told.append(mixed_order(sides, order))
    for place in sides.bad:
        part = sides.bench.undefined(*sides.pair(place))
        if part > _UNDEFINED:
            told.append(f"undefined on {part:.0%} of the working ranges")
            break
    return tuple(t for t in told if t)


def _counterexample(sides: Sides, entries: Sequence[Entry], paper: Paper) -> Counterexample | None:
    """Of the entry that errs most against its size, at round inputs; of those that fail, if any."""
    failing = [e for e in entries if e.verdict not in (Verdict.HOLDS, Verdict.ORDER)]
    failing = failing or [e for e in entries if e.verdict is not Verdict.HOLDS]
    worst = max(failing, key=lambda e: _against_size(sides, e))
    printed, derived = sides.pair((worst.row - 1, worst.column - 1))
    bench = sides.bench
    spare = [q for q in bench.everything if q not in bench.known]

    def values_at(points: p.Sample) -> Values:
        count = next((len(a) for a in points.values()), 1)
        return Values(Doubles(), points | p.sample(spare, count, 0))

    def error(points: p.Sample) -> Any:
        return bench.difference(values_at(points), printed, derived)

    where = p.worst_round(bench.known, bench.small, bench.given, error, paper.examples)
    if where is None:
        return None
    values = values_at(p.stacked([where], bench.known))
    wanted = float(values.array(derived)[0])
    found = wanted + float(bench.difference(values, printed, derived)[0])
    return Counterexample(
        where.told(), steady(found, 14), steady(wanted, 14), worst.row, worst.column
    )


def _against_size(sides: Sides, entry: Entry) -> float:
    scale = sides.bench.scale(sides.derived[entry.row - 1][entry.column - 1])
    return 0.0 if np.isnan(entry.worst) else entry.worst / scale
