"""Claims of a paper's text on the values that something takes: bounds, extremes, least changes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any

import numpy as np

from armillary.algebra import scalar as s
from armillary.algebra.index import Index
from armillary.derivation.paper import Paper
from armillary.derivation.ranges import Between, Extremes, Figure, LeastMoved
from armillary.verify.audit import points as p
from armillary.verify.audit.compare import CLOSE, DIGITS, EQUAL
from armillary.verify.audit.numbers import Doubles
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.properties import largest
from armillary.verify.audit.sentences import finding_of
from armillary.verify.audit.verdict import Counterexample, Finding, Verdict, steady
from armillary.verify.audit.words import at, number, unit_of

_POINTS = 2000
_FEW = 12
_ROUNDING = 1e-14
_STEPS = 701  # along one quantity, at every part of the indices: a minute each of 9 to 16 h, and so


def between(paper: Paper, said: Between) -> Finding:
    """Least and largest value over the working ranges against the bounds."""
    known = p.quantities(*_blocks(said))
    values = Values(Doubles(), p.where(_points(known), said.given))
    value, low, high = _bounded(said, values)
    scale = max(largest(np.abs(value)), 1e-12)
    unit = unit_of(said.value)
    says = f"Over the working ranges {said.words} is {span(value, value, unit)}"
    beyond = largest(np.maximum(low - value, value - high))
    if beyond <= CLOSE * scale or (beyond <= CLOSE and _exactly_within(said, known)):
        return finding_of(paper, said.key, Verdict.HOLDS, said.quote, f"{says}.")
    says += f"; stated is {stated(said, low, high, unit)}."
    example = _outside(paper, said, known)
    if example is not None and example.at:
        says += f" {at(example, unit)}"
    return finding_of(
        paper, said.key, Verdict.WRONG, said.quote, says, example=example, unit=unit,
        worst=steady(beyond, 6),
    )  # fmt: skip


def extremes(paper: Paper, said: Extremes) -> Finding:
    """Least and largest value over the working ranges against those that are printed."""
    values = Values(Doubles(), _points(p.quantities(said.value)))
    value, digit = values.array(said.value), float(values(said.to))
    unit = unit_of(said.value)
    told, off = [], 0.0
    for word, found, stated in (
        ("at least", float(np.nanmin(value)), said.least),
        ("at most", float(np.nanmax(value)), said.largest),
    ):
        if stated is not None:
            wanted = float(values(stated))
            off = max(off, abs(found - wanted))
            numbers = [f"{_precise(number, digit)} {unit}" for number in (found, wanted)]
            told.append(f"{word} {numbers[0]}, stated is {numbers[1]}")
    says = f"Over the working ranges {said.words} is {'; it is '.join(told)}."
    verdict = Verdict.HOLDS if off <= digit else Verdict.WRONG
    worst = 0.0 if verdict is Verdict.HOLDS else steady(off, 6)
    return finding_of(paper, said.key, verdict, said.quote, says, unit=unit, worst=worst)


def least_moved(paper: Paper, said: LeastMoved) -> Finding:
    """How far each part goes over the working ranges, at each part of the other indices."""
    known = p.quantities(said.value)
    over = [q for q in known if isinstance(q, Index) and q != said.over]
    points = _points(known)
    value = Values(Doubles(), points).array(said.value)
    unit = unit_of(said.value)
    rows = [
        (words, [float(np.ptp(value[there & _stands(points, said.over, k)]))
                 for k in range(said.over.size)])
        for words, there in _corners(points, over)
    ]  # fmt: skip
    beaten = [words for words, changes in rows if changes[said.part] > min(changes)]
    told = "; ".join(
        f"{words}{', '.join(number(change) for change in changes)}" for words, changes in rows
    )
    says = f"Over the working ranges {said.words}, by {said.over.name}, is, in {unit}: {told}."
    if not beaten:
        return finding_of(paper, said.key, Verdict.HOLDS, said.quote, says)
    says += f" Number {said.part + 1} is not the least in {len(beaten)} of {len(rows)}."
    return finding_of(paper, said.key, Verdict.WRONG, said.quote, says, unit=unit)


# -- parts -----------------------------------------------------------------------------------------


def _points(known: Sequence[p.Known]) -> p.Sample:
    if any(isinstance(q, Index) for q in known):
        return p.everywhere(known, _STEPS, 5)
    drawn = p.joined(p.sample(known, _POINTS, 5), p.awkward(known, 6, known))
    return p.joined(drawn, p.ends(known, _POINTS, 7))


def _blocks(said: Between) -> list[s.Scalar | s.Condition]:
    found = (said.value, said.low, said.high, said.given)
    return [block for block in found if block is not None]


def _bounded(said: Between, values: Values) -> tuple[Any, Any, Any]:
    """The value and its bounds at each point; infinite where nothing is stated."""
    low, high = (
        np.full(values.count, bound) if stated is None else values.array(stated)
        for stated, bound in ((said.low, -np.inf), (said.high, np.inf))
    )
    return values.array(said.value), low, high


def _exactly_within(said: Between, known: Sequence[p.Known]) -> bool:
    """Whether the value keeps to its bounds with 50 digits: one that is 0 has no scale."""
    few = p.where(p.sample(known, _FEW, 7), said.given)
    value, low, high = _bounded(said, Values(DIGITS, p.exact(few, DIGITS)))
    return all(x <= EQUAL for x in np.maximum(low - value, value - high))


def stated(said: Between | Figure, low: Any, high: Any, unit: str) -> str:
    """What is stated of a value: "at most 2 m", "1 to 2 m"."""
    if said.low is None:
        return f"at most {number(float(np.nanmax(high)), unit)}"
    if said.high is None:
        return f"at least {number(float(np.nanmin(low)), unit)}"
    return span(low, high, unit)


def span(low: Any, high: Any, unit: str) -> str:
    """The least and the largest of some values: "0 to 3.14 rad"."""
    ends = np.array([np.nanmin(low), np.nanmax(high)], dtype=float)
    # Beside the other end, what is left of a rounding is 0.
    least, most = np.where(np.abs(ends) <= _ROUNDING * np.abs(ends).max(), 0.0, ends).tolist()
    first = number(least)
    return number(most, unit) if number(most) == first else f"{first} to {number(most, unit)}"


def _precise(value: float, digit: float) -> str:
    """A value with one digit more than is printed."""
    return f"{value:.{max(0, 1 - int(np.floor(np.log10(digit))))}f}"


def _outside(paper: Paper, said: Between, known: Sequence[p.Known]) -> Counterexample | None:
    def beyond(points: p.Sample) -> Any:
        value, low, high = _bounded(said, Values(Doubles(), points))
        return np.maximum(0.0, np.maximum(low - value, value - high))

    where = p.worst_round(known, (), said.given, beyond, paper.examples)
    if where is None:
        return None
    found = _bounded(said, Values(Doubles(), p.stacked([where], known)))
    value, low, high = (float(x[0]) for x in found)
    bound = low if value < low else high
    return Counterexample(where.told(), steady(bound, 14), steady(value, 14))


def _corners(points: p.Sample, over: Sequence[Index]) -> Iterator[tuple[str, Any]]:
    """Every part of some indices, in words, and where the points stand there."""
    for places in product(*(range(index.size) for index in over)):
        there = np.ones(p.count(points), dtype=bool)
        for index, place in zip(over, places, strict=True):
            there &= _stands(points, index, place)
        names = ", ".join(f"{i.name} {k + 1}" for i, k in zip(over, places, strict=True))
        yield (f"{names}: " if names else ""), there


def _stands(points: p.Sample, index: Index, place: int) -> Any:
    return points[index] == place
