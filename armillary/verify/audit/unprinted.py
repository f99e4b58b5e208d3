"""Figures of a paper that hang on quantities which it does not print."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from armillary.derivation.paper import Paper
from armillary.derivation.quantity import Quantity
from armillary.derivation.ranges import Figure, Hanging
from armillary.verify.audit import points as p
from armillary.verify.audit.numbers import Doubles
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.ranges import stated
from armillary.verify.audit.sentences import finding_of
from armillary.verify.audit.verdict import Finding, Verdict, steady
from armillary.verify.audit.words import number, unit_of

_STEPS = 61  # of what a figure is the largest of
_WIDE, _NARROW = 33, 17  # choices of a quantity on the first grid, and on those about the best
_FINE = 1e-3  # part of a range at which the search ends
_ALIKE = 1e-6
_AT_ONCE = 20000  # points


def hanging(paper: Paper, said: Hanging) -> Finding:
    """What comes out for what is assumed, and whether other choices give what is stated."""
    digit = float(np.ravel(Values(Doubles(), {})(said.to))[0])
    free = [quantity for quantity, _ in said.on]
    assumed = np.array([[p.numbers_of(value) for _, value in said.on]])
    there = _figures(said.figures, free, assumed)[0]
    place = _best(said, free, digit)
    found = _figures(said.figures, free, place[None, :])[0]
    off = _off(said.figures, found[None, :])[0]
    told = [
        f"With {said.words}, which the paper does not print, {_told(said.figures, there, True)}."
    ]
    where = ", ".join(
        f"{q.name} = {number(x, str(q.unit))}" for q, x in zip(free, place, strict=True)
    )
    if off.max() <= digit:
        told.append(
            f"With {where} {_told(said.figures, found, False)}: what is not printed decides."
        )
    else:
        told.append(
            f"No choice within {_ranges(free)} gives it: the nearest found, {where}, gives "
            f"{_values(said.figures, found)}."
        )
    told.append(said.see)
    says = " ".join(text for text in told if text)
    if off.max() <= digit:
        return Finding(
            paper.name, said.key, Verdict.NOT_CHECKABLE, None, "claim of the text", said.quote, says
        )
    return finding_of(
        paper, said.key, Verdict.WRONG, said.quote, says, unit=unit_of(said.figures[0].value),
        worst=steady(float(off.max()), 3),
    )  # fmt: skip


# -- the search ------------------------------------------------------------------------------------


def _best(said: Hanging, free: Sequence[Quantity], digit: float) -> Any:
    """A choice that gives all figures, else one with the least mean square off.

    Grids shrink about the best.
    """
    low, high = np.array([q.facts.range for q in free]).T
    place, width, count = (low + high) / 2, (high - low) / 2, _WIDE
    while True:
        ticks = [np.linspace(x - w, x + w, count) for x, w in zip(place, width, strict=True)]
        tried = np.stack([axis.ravel() for axis in np.meshgrid(*ticks, indexing="ij")], axis=-1)
        tried = tried[((tried >= low) & (tried <= high)).all(axis=1)]
        off = _off(said.figures, _figures(said.figures, free, tried))
        fits = (off <= digit).all(axis=1)
        square = np.where(fits | ~fits.any(), (off**2).sum(axis=1), np.inf)
        # Of many that are as good, one from their middle stands off the bounds. What is less
        # than a millionth of the rounding apart is as good on any machine.
        good = np.flatnonzero(square <= np.nanmin(square) + (_ALIKE * digit) ** 2)
        place = tried[good[len(good) // 2]]
        width, count = 4 * width / (count - 1), _NARROW
        if fits.any() or (width <= _FINE * (high - low)).all():
            return np.array([steady(x, 6) for x in place])


def _figures(figures: Sequence[Figure], free: Sequence[Quantity], places: Any) -> Any:
    """The largest of each value at each choice: (choices, figures)."""
    found = np.full((len(places), len(figures)), np.nan)
    alike: dict[tuple[p.Known, ...], list[int]] = {}  # what they share is evaluated once
    for k, figure in enumerate(figures):
        others = tuple(q for q in p.quantities(figure.value) if q not in free)
        alike.setdefault(others, []).append(k)
    for rest, numbers in alike.items():
        other = p.everywhere(rest, _STEPS, 5) if rest else {}
        each = max(1, p.count(other))
        for chosen in np.array_split(np.arange(len(places)), 1 + len(places) * each // _AT_ONCE):
            points = {q: np.concatenate([array] * len(chosen)) for q, array in other.items()}
            points |= {q: np.repeat(places[chosen, k], each) for k, q in enumerate(free)}
            values = Values(Doubles(), points)
            for k in numbers:
                value = values.array(figures[k].value).reshape(len(chosen), each)
                found[chosen, k] = value.max(axis=1)
    return found


def _off(figures: Sequence[Figure], found: Any) -> Any:
    """How far each figure is from what is stated; NaN is far."""
    off = np.zeros(found.shape)
    for k, figure in enumerate(figures):
        low, high = (
            edge if bound is None else p.numbers_of(bound)
            for bound, edge in ((figure.low, -np.inf), (figure.high, np.inf))
        )
        off[:, k] = np.maximum(0.0, np.maximum(low - found[:, k], found[:, k] - high))
    return np.where(np.isnan(found), np.inf, off)


# -- words -----------------------------------------------------------------------------------------


def _told(figures: Sequence[Figure], found: Any, whole: bool) -> str:
    """The figures found, with their names and what is stated of them, or by themselves."""
    if not whole:
        return f"{'it is' if len(figures) == 1 else 'they are'} {_values(figures, found)}"
    return "; ".join(
        f"{figure.words} is {number(float(x), unit_of(figure.value))}, stated is {_bounds(figure)}"
        for figure, x in zip(figures, found, strict=True)
    )


def _values(figures: Sequence[Figure], found: Any) -> str:
    return ", ".join(
        number(float(x), unit_of(figure.value)) for figure, x in zip(figures, found, strict=True)
    )


def _bounds(figure: Figure) -> str:
    low, high = (np.array(np.nan if b is None else p.numbers_of(b))
                 for b in (figure.low, figure.high))  # fmt: skip
    return stated(figure, low, high, unit_of(figure.value))


def _ranges(free: Sequence[Quantity]) -> str:
    return " and ".join(
        f"{number(q.facts.range[0])} to {number(q.facts.range[1], str(q.unit))} of {q.name}"
        for q in free
    )
