"""The two sides of one reading: entries printed and derived, and how far each pair agrees."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.derivation.entries import Rows, rows_of
from armillary.derivation.statements import Block
from armillary.verify.audit.compare import Bench, Outcome

Place = tuple[int, int]


@dataclass(frozen=True, eq=False)
class Sides:
    """A print beside what is derived; rows and columns count from 0."""

    bench: Bench
    printed: Rows
    derived: Rows
    outcomes: dict[Place, Outcome]

    @property
    def places(self) -> list[Place]:
        """Every entry, row-major."""
        return list(self.outcomes)

    @property
    def bad(self) -> list[Place]:
        """The entries that do not hold."""
        return [place for place, outcome in self.outcomes.items() if not outcome.holds]

    @property
    def shape(self) -> Place:
        return len(self.printed), len(self.printed[0])

    def pair(self, place: Place) -> tuple[s.Scalar, s.Scalar]:
        """The printed and the derived entry."""
        row, column = place
        return self.printed[row][column], self.derived[row][column]

    def agrees(
        self, places: Sequence[Place], printed: Rows | None = None, derived: Rows | None = None
    ) -> Outcome | None:
        """The worst outcome at some places, with one side replaced; None where one fails."""
        printed, derived = printed or self.printed, derived or self.derived
        order: int | None = None
        for row, column in places:
            outcome = self.bench.tried(printed[row][column], derived[row][column])
            if not outcome.holds:
                return None
            if not outcome.exact:
                assert outcome.order is not None
                order = outcome.order if order is None else min(order, outcome.order)
        return Outcome(exact=order is None, order=order)


def sides_of(bench: Bench, printed: Block, derived: Block) -> Sides:
    """Two blocks of one shape, compared entry by entry."""
    left, right = rows_of(printed), rows_of(derived)
    outcomes = {
        (i, j): bench.outcome(left[i][j], right[i][j])
        for i in range(len(left))
        for j in range(len(left[0]))
    }
    return Sides(bench, left, right, outcomes)


def negated(rows: Rows) -> Rows:
    """All entries with the other sign."""
    return tuple(tuple(s.negate(entry) for entry in row) for row in rows)


def transposed(rows: Rows) -> Rows:
    """Rows as columns; of a 4 by 4 matrix the rotation only."""
    if len(rows) != 4:
        return tuple(zip(*rows, strict=True))
    inner = transposed(tuple(row[:3] for row in rows[:3]))
    return (*((*inner[i], rows[i][3]) for i in range(3)), rows[3])


def blocks(shape: Place, places: Sequence[Place]) -> str:
    """What part of a matrix some places are, in words."""
    if shape == (4, 4) and places:
        if all(j == 3 for _, j in places):
            return "the translation column"
        if all(i < 3 and j < 3 for i, j in places):
            return "the rotation"
    return ""


def told(places: Sequence[Place]) -> str:
    """Places in words, counted from 1."""
    named = [f"({i + 1}, {j + 1})" for i, j in places]
    if len(named) == 1:
        return f"entry {named[0]}"
    return f"entries {', '.join(named[:-1])} and {named[-1]}"


def each(rows: Rows) -> Iterator[s.Scalar]:
    """The entries, row-major."""
    for row in rows:
        yield from row
