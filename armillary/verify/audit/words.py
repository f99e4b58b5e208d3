"""Findings in plain sentences, each with the number that shows it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from armillary.derivation.statements import Block
from armillary.derivation.units import UnitError, check_block
from armillary.verify.audit.sides import told
from armillary.verify.audit.verdict import Counterexample, Entry, Read, Repair, Verdict

NO_BOUND = "without bound"


def unit_of(block: Block) -> str:
    """The unit of a block in words; empty where its entries differ in it, or have none."""
    try:
        unit = check_block(block)
    except UnitError:
        return ""
    return "" if unit is None else str(unit)


def number(value: float, unit: str = "") -> str:
    """A value with three digits and its unit."""
    return _with(f"{value:.3g}", unit)


def two_numbers(first: float, second: float, unit: str) -> tuple[str, str]:
    """Two values with as many digits as it takes to tell them apart, and their unit."""
    a, b = f"{first:.3g}", f"{second:.3g}"
    for digits in range(4, 17):
        apart = abs(float(a) - float(b))
        if abs(apart - abs(first - second)) <= 0.1 * abs(first - second):
            break
        # Zeros at the end stay: they say that the digits agree so far.
        a, b = (f"{value:#.{digits}g}".rstrip(".") for value in (first, second))
    return _with(a, unit), _with(b, unit)


def at(point: Counterexample, unit: str, several: bool = False) -> str:
    """A counterexample in one sentence, with its entry where a print has several."""
    what = f"entry ({point.row}, {point.column})" if several else "it"
    where = ", ".join(f"{name} = {_value(value)}" for name, value in point.at.items())
    where = f"At {where} {what}" if where else f"{what[0].upper()}{what[1:]}"
    printed, derived = two_numbers(point.printed, point.derived, unit)
    return f"{where} gives {printed}; derived is {derived}."


def _with(text: str, unit: str) -> str:
    return text if unit in ("", "1") else f"{text} {unit}"


def reading(read: Read, small: Sequence[str], unit: str) -> str:
    """What is said of one reading."""
    parts = [_verdict(read, small)]
    if read.verdict is not Verdict.HOLDS:
        bound = f"by up to {number(read.worst, unit)}" if np.isfinite(read.worst) else NO_BOUND
        parts.append(f"As printed it errs {bound}.")
    parts += [f"{text[0].upper()}{text[1:]}." for text in read.properties]
    if read.counterexample is not None:
        parts.append(at(read.counterexample, unit, len(read.entries) > 1))
    return " ".join(parts)


def several(reads: Sequence[Read], small: Sequence[str], unit: str) -> str:
    """What is said of a print with several readings."""
    return " ".join(f"Read as {r.reading}: {reading(r, small, unit)}" for r in reads)


def _verdict(read: Read, small: Sequence[str]) -> str:
    names = ", ".join(small)
    if read.verdict is Verdict.HOLDS:
        return "It holds."
    if read.verdict is Verdict.ORDER:
        return f"It holds to order {read.order} in {names}."
    sentences = [_whole(read.whole, names)] if read.whole is not None else []
    if read.whole is None or read.whole.kind == "special value":
        sentences = [*_repaired(read, names), *_broken(read, names), *sentences]
    return " ".join(sentences)


def _whole(whole: Repair, names: str) -> str:
    then = _then(whole, names)
    if not whole.elsewhere:
        return f"It holds with {whole.words}{then}."
    if whole.kind in ("special value", "order of factors"):
        words = whole.words if "belongs" in whole.words else f"it {whole.words}"
        return f"{words[0].upper()}{words[1:]}{then}."
    return f"It is {whole.words}{then}."


def _repaired(read: Read, names: str) -> Iterator[str]:
    """Entries that hold with a small change, those with the same change together."""
    alike: dict[tuple[str, int | None], list[Entry]] = {}
    for entry in read.entries:
        if entry.repair is not None:
            alike.setdefault((entry.repair.words, entry.repair.order), []).append(entry)
    for entries in alike.values():
        repair = entries[0].repair
        assert repair is not None
        if repair.kind == "copy":
            yield f"{_subject(entries, read)} {repair.words}."
            continue
        holds = "holds" if len(entries) == 1 else "hold"
        yield f"{_subject(entries, read)} {holds} with {repair.words}{_then(repair, names)}."


def _broken(read: Read, names: str) -> Iterator[str]:
    """Entries that no small change mends, by the order to which they hold."""
    bad = [e for e in read.entries if e.verdict is Verdict.WRONG and e.repair is None]
    zero = [e for e in bad if names and e.order == 0]
    # Where a special value explains the others, its own sentence says how they fail.
    rest = [] if read.whole is not None else [e for e in bad if e not in zero]
    for entries, s, words in (
        (zero, "holds", f"to order 0 in {names} only"),
        (rest, "fails", ""),
    ):
        if entries:
            verb = s if len(entries) == 1 else s[:-1]
            said = " ".join(part for part in (_subject(entries, read), verb, words) if part)
            yield f"{said}, and no small change mends {'it' if len(entries) == 1 else 'them'}."


def _subject(entries: Sequence[Entry], read: Read) -> str:
    if len(read.entries) == 1:
        return "It"
    places = told([(e.row - 1, e.column - 1) for e in entries])
    return places[0].upper() + places[1:]


def _then(repair: Repair, names: str) -> str:
    return "" if repair.order is None else f" (then to order {repair.order} in {names})"


def _value(value: float | list[float]) -> str:
    if isinstance(value, list):
        return f"({', '.join(f'{x:.3g}' for x in value)})"
    degrees = np.degrees(value)
    if value and abs(degrees - round(degrees)) < 1e-9 and abs(degrees) >= 5:
        return f"{round(degrees)} deg"
    return f"{value:.3g}"
