"""What a paper prints: its numbered equations as they stand there, and the claims of its text.

`derivations/papers/KEY.py` makes one `Paper`. It says what is printed and which definition is
claimed, never whether that is right: the audit computes the verdict.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import UnionType

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.index import Index
from armillary.algebra.indexed import indices
from armillary.algebra.rigid import Matrix
from armillary.algebra.rotation import Rotation
from armillary.derivation.checking import check_expression, check_symbols
from armillary.derivation.entries import shape_of
from armillary.derivation.errors import DerivationError, Source, caller
from armillary.derivation.printed import (
    Equation,
    Meant,
    Needed,
    Negligible,
    Printed,
    Reading,
    Spans,
    Unchecked,
    Word,
)
from armillary.derivation.printed_units import InUnit, factors_of
from armillary.derivation.quantity import AnyQuantity, Constant, ConstantTable, Quantity
from armillary.derivation.ranges import Between, Extremes, Figure, Hanging, LeastMoved
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Block
from armillary.derivation.symbols import leaves
from armillary.mechanism.chain import Chain

__all__ = [
    "PROPERTIES",
    "Equation",
    "Meant",
    "Needed",
    "Negligible",
    "Paper",
    "Printed",
    "Reading",
    "Spans",
    "Unchecked",
    "Word",
]

PROPERTIES = ("singular", "orthogonal", "symmetric", "skew-symmetric", "diagonal")


# What one statement says of its figures: a value, and the least and largest that are stated of it.
Stated = tuple[s.Scalar, s.ScalarLike | None, s.ScalarLike | None]


class Paper(Derivation):
    """One paper: symbols of its own, and what it prints, in the order printed.

    Its symbols are declared and its shorthands defined as in any derivation. `use` gives the
    systems whose definitions it claims.

    Args:
        key: name of the file and of the table in `references.toml`.
    """

    def __init__(self, key: str, *, title: str = "") -> None:
        super().__init__(key, title=title or key, paper=key)
        self.printed: dict[str, Printed] = {}
        self.examples: dict[AnyQuantity, Block] = {}

    def example_at(self, values: Mapping[AnyQuantity, Block]) -> None:
        """Counterexamples are sought at these values, the paper's own, before any others.

        Args:
            values: constants, of the shape and the index of what they stand for.
        """
        source = caller()
        for quantity, value in values.items():
            _check_kind(quantity, AnyQuantity, "what an example has", "a quantity", source)
            self._check("example", value, source)
            if shape_of(quantity) != shape_of(value) or any(
                not isinstance(leaf, Constant | ConstantTable) for leaf in leaves(value)
            ):
                raise DerivationError(
                    f"what {quantity.name} has in an example is not its value",
                    "give constants of its shape",
                    source,
                )
        self.examples.update(values)

    def equation(
        self,
        key: str,
        *,
        claims: Block,
        printed: Block | Mapping[str, Block],
        words: str,
        quote: str = "",
        small: Sequence[Quantity] = (),
        product: Chain | None = None,
        frames: Mapping[str, Rotation] | None = None,
        given: s.Condition | None = None,
        meant: Mapping[str, Mapping[Block, Block]] | None = None,
    ) -> None:
        """A numbered equation; with `quote`, a sentence that states one.

        Args:
            claims: the definition it claims to equal, from a system that is used.
            printed: what stands there; a mapping from how it is read, where that is doubtful.
            meant: other things that its names may stand for, from what is true then ("the
                components in {P}") to a mapping from names, on either side, to those things.
        """
        source = caller()
        readings = printed if isinstance(printed, Mapping) else {"": printed}
        if not readings:
            raise DerivationError(
                f"equation ({key}) has no reading", "give one way to read it at least", source
            )
        self._check(key, claims, source)
        if given is not None:
            _check_kind(given, s.Condition, f"equation ({key}), given=", "a condition", source)
            self._check(key, given, source)
        _check_small(key, small, source)
        for block in readings.values():
            self._check(key, block, source)
            _check_shape(key, claims, block, source)
        others = tuple(Meant(words, tuple(named.items())) for words, named in (meant or {}).items())
        for other in others:
            for pair in other.names:
                self._check_meant(key, *pair, source)
        made = tuple(Reading(name, block) for name, block in readings.items())
        turned, few = tuple((frames or {}).items()), tuple(small)
        self._state(
            Equation(key, words, quote, claims, made, few, product, turned, given, source, others)
        )

    def word(self, key: str, quote: str, word: str, of: Mapping[str, Matrix]) -> None:
        """A sentence that says matrices have a property: one of `PROPERTIES`."""
        source = caller()
        if word not in PROPERTIES:
            raise DerivationError(
                f"{word!r} is no property of a matrix", f"say {', '.join(PROPERTIES)}", source
            )
        if not of:
            raise DerivationError(f"{key!r} is said of no matrix", "name one in of={...}", source)
        for name, matrix in of.items():
            self._check(key, matrix, source)
            rows, columns = shape_of(matrix)
            if rows != columns:
                raise DerivationError(
                    f"{name} is {rows} by {columns}", f"only square matrices are {word}", source
                )
        self._state(Word(key, quote, word, tuple(of.items()), source))

    def negligible(
        self,
        key: str,
        quote: str,
        small: Quantity,
        *,
        of: s.Scalar | v.Vector,
        beside: Sequence[Quantity],
    ) -> None:
        """A sentence that calls `small` negligible beside others of its size."""
        source = caller()
        self._check(key, of, source)
        if not beside:
            raise DerivationError(
                f"{key!r} compares with nothing", "name what is not small in beside=[...]", source
            )
        _check_small(key, (small, *beside), source)
        self._state(Negligible(key, quote, of, small, tuple(beside), source))

    def needed(
        self, key: str, quote: str, small: Sequence[Quantity], *, of: s.Scalar | v.Vector
    ) -> None:
        """A sentence that says `small` must be taken into account."""
        source = caller()
        self._check(key, of, source)
        _check_small(key, small, source)
        self._state(Needed(key, quote, of, tuple(small), source))

    def between(
        self,
        key: str,
        quote: str,
        value: s.Scalar,
        low: s.ScalarLike | None,
        high: s.ScalarLike | None,
        *,
        words: str,
        given: s.Condition | None = None,
    ) -> None:
        """A sentence that bounds a value; `words` say which: "the angle between the axes"."""
        source = caller()
        least, largest = (None if b is None else s.as_scalar(b) for b in (low, high))
        for block in (value, least, largest, given):
            if block is not None:
                self._check(key, block, source)
        self._state(Between(key, quote, words, value, least, largest, source, given))

    def extremes(
        self,
        key: str,
        quote: str,
        value: s.Scalar,
        least: s.ScalarLike | None,
        largest: s.ScalarLike | None,
        *,
        to: s.ScalarLike,
        words: str,
    ) -> None:
        """A sentence that names the least or the largest of a value, rounded to `to`."""
        source = caller()
        self._check(key, value, source)
        low, high = (None if number is None else s.as_scalar(number) for number in (least, largest))
        self._state(Extremes(key, quote, words, value, low, high, s.as_scalar(to), source))

    def hanging(
        self,
        key: str,
        quote: str,
        figures: Mapping[str, Stated],
        *,
        on: Mapping[Quantity, s.ScalarLike],
        words: str,
        to: s.ScalarLike = 0,
        see: str = "",
    ) -> None:
        """A sentence whose figures hang on quantities that are not printed.

        It is wrong where no choice of them in their ranges gives all its figures, else not
        checkable.

        Args:
            figures: by words for it, each value with the least and the largest that are stated of
                its largest.
            on: those quantities, with what is assumed of them.
            words: what is assumed: "the mass centre at o".
            to: the rounding of the figures.
            see: where more is said of it, a sentence.
        """
        source = caller()
        made = tuple(
            Figure(name, value, *(None if b is None else s.as_scalar(b) for b in bounds))
            for name, (value, *bounds) in figures.items()
        )
        for figure in made:
            for block in (figure.value, figure.low, figure.high):
                if block is not None:
                    self._check(key, block, source)
        if not made or not on:
            raise DerivationError(
                f"{key!r} has no figures, or hangs on nothing", "give figures and on={...}", source
            )
        _check_small(key, tuple(on), source)
        assumed = tuple((q, s.as_scalar(value)) for q, value in on.items())
        self._state(Hanging(key, quote, made, s.as_scalar(to), assumed, words, see.strip(), source))

    def least_moved(
        self, key: str, quote: str, value: s.Scalar, *, over: Index, part: int, words: str
    ) -> None:
        """A sentence that says part number `part` of an index, from 0, changes least."""
        source = caller()
        self._check(key, value, source)
        if over not in indices(value) or not 0 <= part < over.size:
            raise DerivationError(
                f"{key!r} compares part {part} of {over.name} with the others",
                f"give a value per {over.name} and a part from 0 to {over.size - 1}",
                source,
            )
        self._state(LeastMoved(key, quote, words, value, over, part, source))

    def spans(self, key: str, quote: str, turns: Rotation, angles: Sequence[Quantity]) -> None:
        """A sentence that says three turns reach every orientation."""
        source = caller()
        self._check(key, turns, source)
        if len(angles) != 3:
            raise DerivationError(
                f"{key!r} names {len(angles)} angles of three turns", "name all three", source
            )
        self._state(Spans(key, quote, turns, tuple(angles), source))

    def in_unit(self, key: str, quote: str, value: s.Scalar | v.Vector | Matrix, unit: str) -> None:
        """A row of the nomenclature: the unit, as it is written there, of what a symbol means.

        Args:
            value: a matrix where one row names several things, all of that unit.
            unit: "N m^2", "m^3/s"; "1" where the row has none.
        """
        source = caller()
        self._check(key, value, source)
        self._state(InUnit(key, quote, value, factors_of(unit, source), source))

    def unchecked(self, key: str, words: str, reason: str) -> None:
        """A numbered equation that only names things; `reason` says why none can refute it."""
        self._state(Unchecked(key, words, reason.strip(), caller()))

    def _check(self, key: str, block: Block, source: Source) -> None:
        check_expression(f"equation ({key})", block, source)
        check_symbols(self, f"equation ({key})", block, source)

    def _check_meant(self, key: str, name: Block, other: Block, source: Source) -> None:
        self._check(key, name, source)
        self._check(key, other, source)
        if shape_of(name) != shape_of(other):
            raise DerivationError(
                f"what a name of equation ({key}) may stand for has another shape",
                "put a scalar for a scalar and a vector for a vector",
                source,
            )

    def _state(self, made: Printed) -> None:
        if made.key in self.printed:
            raise DerivationError(
                f"two prints of {self.name} have the key {made.key!r}",
                "number the second one with a dash: 11'",
                made.source,
            )
        self.printed[made.key] = made


def _check_small(key: str, small: Sequence[Quantity], source: Source) -> None:
    for quantity in small:
        words = f"what is small in ({key})"
        _check_kind(quantity, Quantity, words, "a quantity that was declared", source)


def _check_kind(
    value: object, kind: type | UnionType, words: str, wanted: str, source: Source
) -> None:
    if not isinstance(value, kind):
        raise DerivationError(f"{words} is {value!r}", f"give {wanted}", source)


def _check_shape(key: str, claims: Block, printed: Block, source: Source) -> None:
    """A print has as many entries as what it claims to equal."""
    rows, columns = shape_of(printed)
    wanted_rows, wanted_columns = shape_of(claims)
    if (rows, columns) != (wanted_rows, wanted_columns):
        raise DerivationError(
            f"equation ({key}) prints {rows} by {columns} entries, "
            f"but what it claims has {wanted_rows} by {wanted_columns}",
            "claim the part that is printed: a rotation, a position, a component",
            source,
        )
