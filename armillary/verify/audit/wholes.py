"""One change that explains every bad entry of a print at once: of the print, or of the claim."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix, Pose
from armillary.algebra.rotation import Rotation
from armillary.derivation.entries import Rows, rows_of
from armillary.derivation.paper import Equation, Paper
from armillary.derivation.statements import Block
from armillary.mechanism.chain import Chain
from armillary.verify.audit.changes import Change, Changes
from armillary.verify.audit.claims import other_claims
from armillary.verify.audit.compare import Outcome
from armillary.verify.audit.plain import plain
from armillary.verify.audit.products import misprints, pose_of
from armillary.verify.audit.repairs import LIKELY, kinds_of
from armillary.verify.audit.sides import Place, Sides
from armillary.verify.audit.verdict import Repair
from armillary.verify.audit.walking import replaced, stands_in

_PAIRS = 1500


@dataclass(frozen=True, eq=False)
class Whole:
    """One candidate: one side replaced.

    Attributes:
        block: the changed print where that is one expression, for its LaTeX.
        elsewhere: whether the derived side is replaced.
        derived: the derived side, where both are replaced.
    """

    kind: str
    words: str
    rows: Rows
    block: Block | None = None
    size: int = 1
    elsewhere: bool = False
    derived: Rows | None = None


def whole_repair(
    sides: Sides, equation: Equation, paper: Paper, printed: Block, changes: Changes
) -> tuple[Repair, Block | None] | None:
    """The first candidate that makes all entries hold, and what is printed then."""
    places = _bad_first(sides)
    for whole in _candidates(sides, equation, paper, printed, changes):
        if whole.derived is not None:
            found = sides.agrees(places, printed=whole.rows, derived=whole.derived)
        elif whole.elsewhere:
            found = sides.agrees(places, derived=whole.rows)
        else:
            found = sides.agrees(places, printed=whole.rows)
        if found is not None:
            repair = Repair(
                whole.kind, whole.words, "", whole.size, found.order, whole.elsewhere
            )  # fmt: skip
            return repair, whole.block
    return None


def is_written_out(printed: Block) -> bool:
    """Whether a print gives its entries one by one."""
    return isinstance(printed, (Matrix, v.Components, s.Scalar))


def _bad_first(sides: Sides) -> list[Place]:
    bad = sides.bad
    return bad + [place for place in sides.places if place not in bad]


def _candidates(
    sides: Sides, equation: Equation, paper: Paper, printed: Block, changes: Changes
) -> Iterator[Whole]:
    singles = [] if is_written_out(printed) else _singles(sides, equation, printed, changes)
    for change in singles:
        yield _written(change.kind, change.words, change.node)
    yield from _meant(equation, printed)
    claims = [
        Whole(c.kind, c.words, c.derived, size=c.size, elsewhere=True)
        for c in other_claims(sides, equation, paper)
    ]
    yield from (c for c in claims if c.kind in ("sign", "transposition"))
    if sides.shape != (1, 1) and is_written_out(printed):
        yield from _renamed(printed, changes)
        yield from _exchanged(sides.printed)
    yield from (c for c in claims if c.kind not in ("sign", "transposition"))
    for first, second in islice(_pairs(singles, changes), _PAIRS):
        words = f"{first.words} and {second.words}"
        yield _written(kinds_of((first, second)), words, second.node, size=2)


def _meant(equation: Equation, printed: Block) -> Iterator[Whole]:
    """Both sides, with all names standing for what else they may mean."""
    for meant in equation.meant:
        instead = {id(name): other for name, other in meant.names}
        rows = rows_of(replaced(printed, instead))
        derived = rows_of(replaced(equation.claims, instead))
        yield Whole("frame", meant.words, rows, elsewhere=True, derived=derived)


def _written(kind: str, words: str, block: Block, size: int = 1) -> Whole:
    return Whole(kind, words, rows_of(block), block, size)


def _singles(sides: Sides, equation: Equation, printed: Block, changes: Changes) -> list[Change]:
    """Single changes of a print that is one expression: they change all its entries."""
    if isinstance(printed, Pose):
        if equation.product is not None and _is_product(sides, equation.product):
            return misprints(equation.product.steps, changes)
        return [
            Change(c.kind, c.words, c.rank, Pose(c.node, printed.position))
            for c in changes.whole(printed.rotation)
        ]
    if isinstance(printed, (v.Vector, Rotation)):
        return changes.whole(printed)
    return []


def _is_product(sides: Sides, product: Chain) -> bool:
    """Whether the print is that product of joints itself, not what somebody made of it."""
    rows = rows_of(pose_of(product.steps))
    return sides.agrees(sides.places, derived=rows) == Outcome(exact=True)


def _pairs(singles: list[Change], changes: Changes) -> Iterator[tuple[Change, Change]]:
    for first in singles:
        if first.rank <= LIKELY and isinstance(first.node, (v.Vector, Rotation)):
            for second in changes.whole(first.node):
                if second.rank <= LIKELY:
                    yield first, second


def _renamed(printed: Block, changes: Changes) -> Iterator[Whole]:
    """A symbol with the other sign, or another symbol, wherever it stands."""
    names = [q for q in changes.pool.scalars if stands_in(q, printed)]
    for q in names:
        words = f"-{plain(q)} for {plain(q)} throughout"
        yield _written("sign", words, replaced(printed, {id(q): s.negate(q)}))
    for k, q in enumerate(names):
        for other in names[k + 1 :]:
            if changes.pool.unit(q) == changes.pool.unit(other):
                words = f"{plain(q)} and {plain(other)} exchanged"
                yield _written("index", words, replaced(printed, {id(q): other, id(other): q}))
    for q in names:
        for meant in changes.pool.instead(q):
            words = f"{plain(meant.node)} for {plain(q)} throughout"
            yield _written(meant.kind, words, replaced(printed, {id(q): meant.node}))


def _exchanged(rows: Rows) -> Iterator[Whole]:
    """Two rows, or two columns of a square matrix, in each other's place."""
    count = len(rows)
    for i in range(count):
        for j in range(i + 1, count):
            order = list(range(count))
            order[i], order[j] = j, i
            moved = tuple(rows[k] for k in order)
            yield Whole("index", f"rows {i + 1} and {j + 1} exchanged", moved)
            if len(rows[0]) == count:
                moved = tuple(tuple(row[k] for k in order) for row in rows)
                yield Whole("index", f"columns {i + 1} and {j + 1} exchanged", moved)
