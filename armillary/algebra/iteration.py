"""Newton's iteration with a fixed number of steps, as an expression."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from armillary.algebra import scalar as s
from armillary.algebra.derivative import partial
from armillary.algebra.functions import absolute, where
from armillary.algebra.index import Index
from armillary.algebra.indexed import at, indices, one_like, total
from armillary.algebra.linear import determinant, solved
from armillary.algebra.misuse import MisuseError, told
from armillary.algebra.scalar import Scalar, ScalarLike, Symbol, as_scalar

LARGEST = 3
# Slopes are squared twice in the determinant of normal equations: one over it must stay finite.
LEAST = s.number("1e-30")
Bounds = tuple[ScalarLike, ScalarLike]


@dataclass(frozen=True, eq=False, repr=False)
class Iteration:
    """Values that are carried from turn to turn.

    Attributes:
        turns: the index that counts them.
        unknowns: symbols that stand, inside, for the values of the turn before.
        start: their values in the first turn.
        following: what each turn makes of them.
        residuals: what the iteration is to make zero, in the unknowns.
    """

    turns: Index
    unknowns: tuple[Symbol, ...]
    start: tuple[Scalar, ...]
    following: tuple[Scalar, ...]
    residuals: tuple[Scalar, ...]


@dataclass(frozen=True, eq=False, repr=False)
class Iterated(Scalar):
    """The value of one unknown after the last turn."""

    iteration: Iteration
    slot: int

    @property
    def unknown(self) -> Symbol:
        return self.iteration.unknowns[self.slot]


def solve(
    residuals: Scalar | Sequence[Scalar],
    unknowns: Mapping[Symbol, ScalarLike],
    *,
    name: str,
    steps: int = 8,
    within: Mapping[Symbol, Bounds] | None = None,
    over: Index | None = None,
) -> tuple[Scalar, ...]:
    """The unknowns after a fixed number of Newton steps; nothing says that they converged.

    A kernel that returns them needs a case with NOT_CONVERGED on what is left of the residuals:
    `substitute` puts the values found into them. Write it `~(left < bound)`: what is no number is
    not converged either.

    With `over`, the sum of the squares of a residual per part is made least, by Gauss and Newton's
    steps: those find the residuals linear. What such an iteration makes zero are the derivatives of
    that sum, and a case on residuals would refuse what does not quite fit.

    Args:
        residuals: what should become zero: as many scalars as there are unknowns, at most three,
            or one that is per part of an index of that size.
        unknowns: symbols made by `d.unknown`, each with the value it starts from.
        name: of the iteration, which is a loop in C.
        within: bounds that an unknown is held to after each step, though not at the start.
        over: the index of more residuals than there are unknowns.
    """
    symbols = tuple(unknowns)
    if over is None:
        rows, matrix = _system(residuals, symbols)
    else:
        rows, matrix = _least_squares(residuals, symbols, over)
    det = determinant(matrix)
    least = s.ZERO if over is None else LEAST * one_like(det)
    regular = where(absolute(det) > least, det, one_like(det))
    steps_taken = solved(matrix, rows, regular)
    bounds = within or {}
    following = tuple(
        _held(u - step, bounds.get(u)) for u, step in zip(symbols, steps_taken, strict=True)
    )
    if type(steps) is not int or steps < 1:
        raise MisuseError(f"an iteration of {told(steps)} steps", "give a whole number from 1 up")
    start = tuple(as_scalar(value) for value in unknowns.values())
    turns = Index(name, steps, sequential=True, letter="k")
    made = Iteration(turns, symbols, start, following, tuple(rows))
    return tuple(Iterated(made, slot) for slot in range(len(symbols)))


def _system(
    residuals: Scalar | Sequence[Scalar], unknowns: tuple[Symbol, ...]
) -> tuple[list[Scalar], list[list[Scalar]]]:
    """The residuals one by one, and their derivatives by the unknowns, a row each."""
    count = _counted(unknowns)
    if isinstance(residuals, Scalar):
        open_in = [i for i in indices(residuals) if i.size == count]
        if count > 1 and len(open_in) == 1:
            slopes = [partial(residuals, u) for u in unknowns]
            parts = range(count)
            matrix = [[at(slope, open_in[0], k) for slope in slopes] for k in parts]
            return [at(residuals, open_in[0], k) for k in parts], matrix
        residuals = [residuals]
    rows = list(residuals)
    if len(rows) != count:
        raise MisuseError(
            f"solve has {len(rows)} residuals for {count} unknowns",
            "give as many of the one as of the other",
        )
    return rows, [[partial(row, u) for u in unknowns] for row in rows]


def _least_squares(
    residual: Scalar | Sequence[Scalar], unknowns: tuple[Symbol, ...], over: Index
) -> tuple[list[Scalar], list[list[Scalar]]]:
    """The normal equations: slopes of half the sum of squares, and their products' sums."""
    if not isinstance(residual, Scalar) or over not in indices(residual):
        raise MisuseError(
            f"solve makes least what is not per {over.name}", f"give one residual, per {over.name}"
        )
    if over.size < _counted(unknowns):
        raise MisuseError(
            f"solve has {over.size} residuals for {len(unknowns)} unknowns",
            "give at least as many of the one as of the other",
        )
    slopes = [partial(residual, u) for u in unknowns]

    def sum_of(term: Scalar) -> Scalar:
        return total(term, over=over) if over in indices(term) else over.size * term

    rows = [sum_of(slope * residual) for slope in slopes]
    return rows, [[sum_of(a * b) for b in slopes] for a in slopes]


def _counted(unknowns: tuple[Symbol, ...]) -> int:
    """How many unknowns there are, if a system of so many can be solved."""
    if not 1 <= len(unknowns) <= LARGEST:
        raise MisuseError(
            f"solve has {len(unknowns)} unknowns",
            f"it takes 1 to {LARGEST}: eliminate some by hand",
        )
    return len(unknowns)


def _held(value: Scalar, bounds: Bounds | None) -> Scalar:
    if bounds is None:
        return value
    low, high = (as_scalar(b) for b in bounds)
    return where(value < low, low, where(value > high, high, value))


def with_fresh_unknowns(iteration: Iteration) -> dict[Symbol, Symbol]:
    """Unknowns of their own for a copy of an iteration: the two may stand in one kernel."""
    return {u: replace(u) for u in iteration.unknowns}
