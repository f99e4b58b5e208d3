"""Sentences of a paper on the values that something takes, everywhere it is used."""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.algebra.index import Index
from armillary.derivation.errors import Source
from armillary.derivation.quantity import Quantity


@dataclass(frozen=True, eq=False)
class Between:
    """A sentence that says a value lies between two others, everywhere it is used.

    Attributes:
        words: what the value is: "the angle between the axes".
        low: the least that is stated; None where nothing is.
        high: the largest.
        given: where it is said; None is everywhere.
    """

    key: str
    quote: str
    words: str
    value: s.Scalar
    low: s.Scalar | None
    high: s.Scalar | None
    source: Source
    given: s.Condition | None = None


@dataclass(frozen=True, eq=False)
class Extremes:
    """A sentence that names the least or the largest of a value, or both, as it rounds them.

    Attributes:
        to: the unit of the last digit that it prints, in the unit of the value.
    """

    key: str
    quote: str
    words: str
    value: s.Scalar
    least: s.Scalar | None
    largest: s.Scalar | None
    to: s.Scalar
    source: Source


@dataclass(frozen=True, eq=False)
class LeastMoved:
    """A sentence that says which of some like parts changes least.

    Attributes:
        value: what changes, per part.
        over: the index of the parts.
        part: the one that is said to change least, from 0.
    """

    key: str
    quote: str
    words: str
    value: s.Scalar
    over: Index
    part: int
    source: Source


@dataclass(frozen=True, eq=False)
class Figure:
    """A number that a paper reads off: the largest of a value is between two others.

    Attributes:
        words: what the value is: "the largest force of three drives".
        low: the least that is stated; None where nothing is.
        high: the largest.
    """

    words: str
    value: s.Scalar
    low: s.Scalar | None
    high: s.Scalar | None


@dataclass(frozen=True, eq=False)
class Hanging:
    """A sentence with figures that hang on quantities which the paper does not print.

    Attributes:
        figures: all that must come out at one choice of those quantities.
        to: the rounding of the figures, in their unit.
        on: those quantities, each with what is assumed of it.
        words: what is assumed: "the mass centre at o".
        see: where more is said of them, a sentence.
    """

    key: str
    quote: str
    figures: tuple[Figure, ...]
    to: s.Scalar
    on: tuple[tuple[Quantity, s.Scalar], ...]
    words: str
    see: str
    source: Source
