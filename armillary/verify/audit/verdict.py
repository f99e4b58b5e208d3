"""What the audit says of a print."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Verdict(StrEnum):
    """The kinds of verdict, from the best to the least."""

    HOLDS = "holds"
    ORDER = "holds to order"
    MISPRINT = "misprint"
    SIGN = "sign"
    WRONG = "wrong"
    AMBIGUOUS = "ambiguous"
    NOT_CHECKABLE = "not checkable"


@dataclass(frozen=True)
class Repair:
    """The smallest change that makes a print hold.

    Attributes:
        kind: "sign", "function", "index", "lost dot", "dot too many", "lost d", "term",
            "lost term", "factor", "number", "unit", "axis", "half turn", "transposition",
            "order of factors", "copy", "frame", "definition", "special value" or "word"; several
            at once are joined by "and".
        words: the change in words, from what is printed to what holds: "sin for cos of omega".
        latex: what stands there after the change; empty where the change is not of the print.
        size: number of elementary changes.
        order: the order to which it holds after the change, where not exactly.
        elsewhere: whether the print may stand, but for something else than what it claims; the
            words then say for what.
    """

    kind: str
    words: str
    latex: str
    size: int
    order: int | None = None
    elsewhere: bool = False


@dataclass(frozen=True)
class Counterexample:
    """A point with round inputs at which print and derivation differ.

    Attributes:
        at: the inputs, by name: numbers, or lists of three.
        printed: value of the print there.
        derived: value of the derivation there.
        row: of the entry whose values these are, from 1.
        column: of that entry.
    """

    at: dict[str, float | list[float]]
    printed: float
    derived: float
    row: int = 1
    column: int = 1

    @property
    def error(self) -> float:
        return self.printed - self.derived


@dataclass(frozen=True)
class Entry:
    """The verdict on one entry of a printed equation (row and column from 1; 1, 1 for a scalar).

    Attributes:
        order: the order to which it holds in the small quantities, for ORDER.
        worst: the largest error over the working ranges, in SI units.
    """

    row: int
    column: int
    verdict: Verdict
    order: int | None = None
    repair: Repair | None = None
    worst: float = 0.0


@dataclass(frozen=True)
class Read:
    """The verdict on one reading of a print.

    Attributes:
        reading: how it is read; empty where there is one way only.
        whole: a repair of the whole: a transposition, another frame, another order of factors.
        entries: those of the print, row-major.
        properties: what the print violates or shows as a whole ("not orthonormal: ...").
        counterexample: of the worst entry; None where it holds.
    """

    reading: str
    verdict: Verdict
    order: int | None
    whole: Repair | None
    entries: tuple[Entry, ...]
    properties: tuple[str, ...] = ()
    counterexample: Counterexample | None = None
    worst: float = 0.0


@dataclass(frozen=True)
class Finding:
    """The verdict on one printed equation or sentence.

    Attributes:
        verdict: that of its readings where they agree, else AMBIGUOUS.
        words: what the print is.
        quote: the sentence, for a claim of the text.
        says: the finding in a sentence or two, with its number.
        claims: ids of the definitions it was compared with.
    """

    paper: str
    key: str
    verdict: Verdict
    order: int | None
    words: str
    quote: str
    says: str
    claims: tuple[str, ...] = ()
    readings: tuple[Read, ...] = ()
    unit: str = ""

    @property
    def label(self) -> str:
        """The verdict as a table shows it."""
        return f"{self.verdict} {self.order}" if self.verdict is Verdict.ORDER else self.verdict


def steady(value: float, digits: int) -> float:
    """A value that is the same on machines whose sines differ in the last bit."""
    return float(f"{value:.{digits}g}")
