"""How far a target may be from the exact value: measured, committed, and only ever met.

`derivations/<system>/tolerances.json` holds, for each kernel and target, four times the worst error
that was measured, rounded up to one digit: room for another libm, and none for another formula.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from decimal import ROUND_CEILING, Decimal
from pathlib import Path
from typing import Any

from armillary.derivation.errors import DerivationError, Source
from armillary.store.files import replace_durably

NAME = "tolerances.json"
MARGIN = 4.0
# What a kernel without a committed tolerance is held to, in rounding units.
DEFAULT_ROUNDINGS = 256

Tolerances = dict[str, dict[str, float]]


def read(folder: Path) -> Tolerances:
    """The committed tolerances of a system: {kernel: {target: tolerance}}; {} if there are none.

    Raises:
        DerivationError: when the file holds something else.
    """
    path = folder / NAME
    if not path.is_file():
        return {}
    try:
        content = json.loads(path.read_bytes())
    except ValueError as problem:
        raise _malformed(path, str(problem), getattr(problem, "lineno", 1)) from None
    if not isinstance(content, dict):
        raise _malformed(path, "it holds no object")
    return {kernel: _targets(path, kernel, found) for kernel, found in content.items()}


def _targets(path: Path, kernel: str, found: Any) -> dict[str, float]:
    if not isinstance(found, dict):
        raise _malformed(path, f"{kernel} has {found!r} instead of its targets")
    for target, value in found.items():
        number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not (number and 0 <= value < math.inf):
            raise _malformed(path, f"the tolerance of {kernel} for {target} is {value!r}")
    return {target: float(value) for target, value in found.items()}


def _malformed(path: Path, problem: str, line: int = 1) -> DerivationError:
    return DerivationError(
        f"the tolerances cannot be read: {problem}",
        'write {"kernel": {"numpy f64": 1e-15}}, or remove the file and run '
        f"`armillary check {path.parent.name} --update-tolerances`",
        Source(str(path), line),
    )


def rounded_up(worst: float, epsilon: float) -> float:
    """The tolerance for a measured error: with margin, one digit, at least four roundings."""
    wanted = max(MARGIN * worst, 4 * epsilon)
    if not math.isfinite(wanted):
        raise ValueError(f"no tolerance can be made from an error of {worst}")
    digit = Decimal(1).scaleb(Decimal(wanted).adjusted())
    return float(Decimal(wanted).quantize(digit, rounding=ROUND_CEILING))


def write(folder: Path, tolerances: Mapping[str, Mapping[str, float]]) -> None:
    """Write the tolerances of a system, sorted, in one step; two processes take a lock."""
    text = json.dumps(tolerances, indent=1, sort_keys=True) + "\n"
    replace_durably(folder / NAME, text.encode())


def merged(known: Tolerances, measured: Iterable[tuple[str, str, float]]) -> Tolerances:
    """The known tolerances with (kernel, target, tolerance) put in; of several the largest."""
    found = {kernel: dict(targets) for kernel, targets in known.items()}
    new: dict[tuple[str, str], float] = {}
    for kernel, target, tolerance in measured:
        new[kernel, target] = max(tolerance, new.get((kernel, target), 0.0))
    for (kernel, target), tolerance in new.items():
        found.setdefault(kernel, {})[target] = tolerance
    return found
