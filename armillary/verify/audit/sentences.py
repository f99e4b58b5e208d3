"""Claims of a paper's text: properties, negligible quantities, combinations of turns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.derivative import Differentiator, partial_seed
from armillary.derivation.entries import rows_of
from armillary.derivation.paper import (
    PROPERTIES,
    Needed,
    Negligible,
    Paper,
    Spans,
    Word,
)
from armillary.derivation.quantity import Quantity
from armillary.verify.audit import points as p
from armillary.verify.audit import properties
from armillary.verify.audit.compare import CLOSE
from armillary.verify.audit.numbers import Doubles
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.sides import each
from armillary.verify.audit.verdict import Counterexample, Finding, Read, Repair, Verdict
from armillary.verify.audit.words import number

_POINTS = 2000
_PART = 0.1  # an effect below this part of another is negligible beside it
# A word that one matrix has, and that the others miss this much less, is the one that was meant.
_FITS = 0.5
_SIZE = 1e-3  # at which effects of small quantities are compared


def word(paper: Paper, said: Word) -> Finding:
    """A property given by a word: held by all the matrices, or another word was meant."""
    sizes = {w: [_violation(w, matrix) for _, matrix in said.of] for w in PROPERTIES}
    own = max(sizes[said.word])
    if own <= CLOSE:
        return finding_of(paper, said.key, Verdict.HOLDS, said.quote, f"They are {said.word}.")
    told = [
        _matrix_told(name, said.word, matrix)
        for (name, matrix), size in zip(said.of, sizes[said.word], strict=True)
        if size > CLOSE
    ]
    says = f"They are not {said.word}: {'; '.join(told)}."
    meant = min(PROPERTIES, key=lambda w: max(sizes[w]))
    if min(sizes[meant]) > CLOSE or max(sizes[meant]) > _FITS * own:
        return finding_of(paper, said.key, Verdict.WRONG, said.quote, says)
    names = [name for name, _ in said.of]
    off = [
        f"{name} by up to {number(size)}"
        for name, size in zip(names, sizes[meant], strict=True)
        if size > CLOSE
    ]
    says += f" What fits is {meant}" + (
        f", though it is missed by {', '.join(off)}." if off else "."
    )
    repair = Repair("word", f"{meant} for {said.word}", "", 1)
    return finding_of(paper, said.key, Verdict.MISPRINT, said.quote, says, repair)


def _violation(word: str, matrix: object) -> float:
    rows = rows_of(matrix)  # type: ignore[arg-type]
    return properties.largest(properties.violations(word, _values(matrix), rows))


def _matrix_told(name: str, word: str, matrix: object) -> str:
    rows = rows_of(matrix)  # type: ignore[arg-type]
    values = _values(matrix)
    if word == "singular":
        low, high = properties.determinant_range(values, rows)
        bounds = number(low) if high - low < CLOSE else f"{number(low)} to {number(high)}"
        return f"the determinant of {name} is {bounds}"
    return f"{name} is off by up to {number(_violation(word, matrix))}"


def negligible(paper: Paper, said: Negligible) -> Finding:
    """Largest effects of quantities of one size, everything else at random, compared."""
    effects = _effects(said.of, (said.small, *said.beside))
    own = effects[said.small.name]
    others = [effects[q.name] for q in said.beside]
    moved = _moved(effects, said.small)
    if own <= _PART * min(others, default=np.inf):
        says = f"{said.small.name} may be neglected beside the others. {moved}"
        return finding_of(paper, said.key, Verdict.HOLDS, said.quote, says)
    ratio = own / max(others, default=own)
    says = (
        f"{said.small.name} is not negligible: its effect is {number(ratio)} times "
        f"the largest of the others. {moved}"
    )
    return finding_of(paper, said.key, Verdict.WRONG, said.quote, says)


def needed(paper: Paper, said: Needed) -> Finding:
    """Whether each of some small quantities moves a value by a fair part of its own size."""
    effects = _effects(said.of, said.small)
    moved = _moved(effects, said.small[0])
    idle = [name for name, size in effects.items() if size <= _PART * _SIZE]
    if idle:
        says = f"It hardly feels {' and '.join(idle)}. {moved}"
        return finding_of(paper, said.key, Verdict.WRONG, said.quote, says)
    return finding_of(paper, said.key, Verdict.HOLDS, said.quote, moved)


def _moved(effects: Mapping[str, float], small: Quantity) -> str:
    told = ", ".join(f"{name} {number(size)}" for name, size in effects.items())
    return f"Of {_SIZE:g} {small.unit} each, the largest effects are: {told}."


def _effects(of: s.Scalar | v.Vector, small: Sequence[Quantity]) -> dict[str, float]:
    """How far a value moves when one small quantity rises from 0, the other small ones at 0."""
    points = p.sample(p.quantities(of, *small), _POINTS, 5)
    for q in small:
        points = p.with_value(points, q, 0.0)
    still = Values(Doubles(), points)
    found = {}
    for q in small:
        moved = Values(Doubles(), p.with_value(points, q, _SIZE))
        square = sum((moved.array(e) - still.array(e)) ** 2 for e in each(rows_of(of)))
        found[q.name] = properties.largest(np.sqrt(square))
    return found


def spans(paper: Paper, said: Spans) -> Finding:
    """The rank of the map from the angles' rates to the angular velocity."""
    columns = []
    for q in said.angles:
        spin = Differentiator(partial_seed(q)).angular_velocity(said.turns)
        columns.append([v.component(spin, i) for i in range(3)])
    known = p.quantities(said.turns)
    _, most = properties.rank(Values(Doubles(), p.sample(known, 50, 5)), columns)
    if most == 3:
        says = "The three rates give every angular velocity: rank 3, but for single values."
        return finding_of(paper, said.key, Verdict.HOLDS, said.quote, says)
    says = (
        f"The three rates give angular velocities of rank {most} only, wherever the angles stand: "
        "the turns reach a surface of orientations, not all."
    )
    return finding_of(paper, said.key, Verdict.WRONG, said.quote, says)


def _values(matrix: object) -> Values:
    known = p.quantities(matrix)
    return Values(Doubles(), p.joined(p.sample(known, 200, 5), p.ends(known, 200, 6)))


def finding_of(
    paper: Paper,
    key: str,
    verdict: Verdict,
    quote: str,
    says: str,
    repair: Repair | None = None,
    example: Counterexample | None = None,
    unit: str = "",
    worst: float = 0.0,
) -> Finding:
    """The finding on a sentence."""
    one = Read("", verdict, None, repair, (), counterexample=example, worst=worst)
    words = "claim of the text"
    return Finding(paper.name, key, verdict, None, words, quote, says, (), (one,), unit)
