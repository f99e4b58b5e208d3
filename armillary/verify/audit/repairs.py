"""The smallest change of one printed entry that makes it hold."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from typing import Any

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.verify.audit.changes import RANKS, Change, Changes
from armillary.verify.audit.compare import Bench
from armillary.verify.audit.sides import Place, Sides, told
from armillary.verify.audit.verdict import Repair

LIKELY = 3  # two changes at once are tried of the likely ranks only
_PAIRS = 2500
_SINGLES = 4000


def entry_repair(
    bench: Bench,
    printed: s.Scalar,
    derived: s.Scalar,
    changes: Changes,
    latex: Callable[[Any], str] | None = None,
    deep: bool = True,
) -> Repair | None:
    """One change, the likeliest first; then, if `deep`, two at once of the likely kinds."""
    singles = [c for c in changes.whole(printed) if not _names_the_claim(c, derived)]
    singles = singles[:_SINGLES]
    for change in singles:
        outcome = bench.tried(change.node, derived)
        # To add the first term of a series would mend any truncated one: a lost term must fit.
        if outcome.exact or (outcome.holds and change.kind != "lost term"):
            return _repair((change,), outcome.order, latex)
    if not deep:
        return None
    for pair in islice(_pairs(singles, changes), _PAIRS):
        outcome = bench.tried(pair[1].node, derived)
        if outcome.holds:
            return _repair(pair, outcome.order, latex)
    return None


def repeated(sides: Sides, place: Place) -> Repair | None:
    """Another entry of what is derived, if that is what is printed at a place."""
    printed, _ = sides.pair(place)
    if isinstance(printed, s.Number):  # a 0 or a 1 is nothing that one would copy
        return None
    for other in sides.places:
        if other != place and sides.bench.tried(printed, sides.pair(other)[1]).exact:
            return Repair("copy", f"repeats {told([other])}", "", 1)
    return None


def _pairs(singles: list[Change], changes: Changes) -> Iterator[tuple[Change, Change]]:
    for change in singles:
        if change.rank <= LIKELY:
            for second in changes.whole(change.node):
                if second.rank <= LIKELY:
                    yield change, second


def _repair(
    made: tuple[Change, ...], order: int | None, latex: Callable[[Any], str] | None
) -> Repair:
    words = " and ".join(change.words for change in made)
    text = latex(made[-1].node) if latex is not None else ""
    return Repair(kinds_of(made), words, text, len(made), order)


def kinds_of(made: Sequence[Change]) -> str:
    """The kinds of some changes made at once."""
    return " and ".join(
        sorted({change.kind for change in made}, key=lambda kind: (RANKS[kind], kind))
    )


def _names_the_claim(change: Change, derived: s.Scalar) -> bool:
    """Whether a copy is the name of what is derived: to print the claim itself mends nothing."""
    node = change.node
    if change.kind != "index":
        return False
    if isinstance(node, s.Component) and isinstance(derived, s.Component):
        same = node.vector is derived.vector and node.index == derived.index
        return same and isinstance(node.vector, v.VectorReference)
    return node is derived and isinstance(node, s.ScalarReference)
