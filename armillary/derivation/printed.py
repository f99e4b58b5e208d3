"""The prints of a paper: a numbered equation, or a sentence that a number could refute."""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix
from armillary.algebra.rotation import Rotation
from armillary.derivation.errors import Source
from armillary.derivation.printed_units import InUnit
from armillary.derivation.quantity import Quantity
from armillary.derivation.ranges import Between, Extremes, Hanging, LeastMoved
from armillary.derivation.statements import Block
from armillary.mechanism.chain import Chain


@dataclass(frozen=True, eq=False)
class Reading:
    """One way to read a print; `name` is empty where there is only one."""

    name: str
    printed: Block


@dataclass(frozen=True, eq=False)
class Meant:
    """What the names of a print may stand for instead: `words` say what is true then."""

    words: str
    names: tuple[tuple[Block, Block], ...]


@dataclass(frozen=True, eq=False)
class Equation:
    """A printed equation, or a sentence that states one.

    Attributes:
        key: its number, made unique ("11", "11'"), or a word for a sentence.
        words: what it is, in a few words.
        quote: the sentence as printed; empty for a numbered equation.
        claims: what is derived: the definition that the print claims to equal.
        readings: the print, entry by entry; several where a glyph is doubtful or lost.
        small: quantities the paper takes as small; it may hold to an order in them.
        product: the printed product of joints whose result this claims to be.
        frames: rotations by which a vector may have been left in another frame.
        given: where the print says that it holds; None is everywhere.
        meant: other things that its names may stand for, on both sides, by what is true then:
            "the components in {P}".
    """

    key: str
    words: str
    quote: str
    claims: Block
    readings: tuple[Reading, ...]
    small: tuple[Quantity, ...]
    product: Chain | None
    frames: tuple[tuple[str, Rotation], ...]
    given: s.Condition | None
    source: Source
    meant: tuple[Meant, ...] = ()


@dataclass(frozen=True, eq=False)
class Word:
    """A sentence that gives matrices a property by a word."""

    key: str
    quote: str
    word: str
    of: tuple[tuple[str, Matrix], ...]
    source: Source


@dataclass(frozen=True, eq=False)
class Negligible:
    """A sentence that calls one small quantity negligible, others of its size not.

    Attributes:
        of: the vector or scalar that is said not to feel `small`.
        beside: the quantities of the same size that the paper says must be kept.
    """

    key: str
    quote: str
    of: s.Scalar | v.Vector
    small: Quantity
    beside: tuple[Quantity, ...]
    source: Source


@dataclass(frozen=True, eq=False)
class Needed:
    """A sentence that says small quantities must be taken into account.

    Attributes:
        of: the vector or scalar that is said to feel them.
    """

    key: str
    quote: str
    of: s.Scalar | v.Vector
    small: tuple[Quantity, ...]
    source: Source


@dataclass(frozen=True, eq=False)
class Spans:
    """A sentence that calls three turns a combination of orientation angles."""

    key: str
    quote: str
    turns: Rotation
    angles: tuple[Quantity, ...]
    source: Source


@dataclass(frozen=True, eq=False)
class Unchecked:
    """A printed equation that states nothing a number could refute."""

    key: str
    words: str
    reason: str
    source: Source


Printed = (
    Equation
    | Word
    | Negligible
    | Needed
    | Between
    | Extremes
    | Hanging
    | InUnit
    | LeastMoved
    | Spans
    | Unchecked
)
