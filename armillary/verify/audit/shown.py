"""Numbers of a finding as people read them, in the terminal and on a page."""

from __future__ import annotations

import math
from collections.abc import Iterator

from armillary.derivation.paper import Equation, Printed, Unchecked
from armillary.derivation.quantity import AnyQuantity
from armillary.derivation.record import Derivation
from armillary.derivation.units import RADIAN, Unit
from armillary.verify.audit.verdict import Finding, Read, Verdict

_MINUS = "\u2212"
# A multiple of this is told in degrees, any other angle in radians.
_DEGREES = 0.5


def known_units(record: Derivation) -> dict[str, Unit]:
    """The unit of every quantity that a paper or a system it uses declares, by name."""
    found: dict[str, Unit] = {}
    for quantity in _quantities(record):
        found.setdefault(quantity.name, quantity.unit)
    return found


def _quantities(record: Derivation) -> Iterator[AnyQuantity]:
    yield from record.quantities.values()
    for used in record.used.values():
        yield from _quantities(used.derivation)


def about(printed: Printed) -> str:
    """What is printed, in a few words; a sentence that has none, itself."""
    return printed.words if isinstance(printed, (Equation, Unchecked)) else f"“{printed.quote}”"


def input_text(value: float | list[float], unit: Unit | None) -> str:
    """An input of a counterexample: 30°, 0.01 rad, (0, 0.6, 0.8)."""
    if isinstance(value, list):
        return f"({', '.join(map(figure, value))}){_behind(unit)}"
    if unit is not None and unit == RADIAN and _is_round(math.degrees(value)):
        return f"{figure(round(math.degrees(value) / _DEGREES) * _DEGREES)}°"
    return f"{figure(value)}{_behind(unit)}"


def figure(value: float) -> str:
    """A value to six digits."""
    return _signed(f"{value + 0.0:.6g}")


def size(value: float, unit: str = "") -> str:
    """The size of an error, to two digits; nothing where none was met."""
    if math.isinf(value):
        return "∞"
    if not value > 0 and not value < 0:
        return "0" if value == 0 else ""
    return _signed(f"{value:.2g}") + (f" {unit}" if unit and unit != "1" else "")


def worst(finding: Finding) -> float:
    """The largest error of a print over the working ranges, however it is read."""
    return max((read.worst for read in finding.readings if read.worst > 0), default=0.0)


def error_text(finding: Finding) -> str:
    """That error with its unit; of readings that differ, from the least to the largest."""
    largest = worst(finding)
    if not largest:
        return ""
    least = min((read.worst for read in finding.readings if read.worst >= 0), default=largest)
    if finding.verdict is Verdict.AMBIGUOUS and size(least) != size(largest):
        return f"{size(least)} to {size(largest, finding.unit)}"
    return size(largest, finding.unit)


def label(read: Read) -> str:
    """The verdict on a reading as a table shows it."""
    return f"{read.verdict} {read.order}" if read.verdict is Verdict.ORDER else read.verdict


def _is_round(degrees: float) -> bool:
    steps = degrees / _DEGREES
    return abs(degrees) > 0.1 and abs(steps - round(steps)) < 1e-9


def _behind(unit: Unit | None) -> str:
    return "" if unit is None or str(unit) == "1" else f" {unit}"


def _signed(text: str) -> str:
    return text.replace("e-0", "e-").replace("e+0", "e").replace("-", _MINUS)
