"""How far a target may be from the exact value: measured, committed, and only ever met.

`derivations/<system>/tolerances.json` holds, for each kernel and target, four times the worst error
that was measured, rounded up to one digit: room for another libm, and none for another formula.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterable, Mapping
from decimal import ROUND_CEILING, Decimal
from pathlib import Path

NAME = "tolerances.json"
MARGIN = 4.0
# What a kernel without a committed tolerance is held to, in rounding units.
DEFAULT_ROUNDINGS = 256

Tolerances = dict[str, dict[str, float]]


def read(folder: Path) -> Tolerances:
    """The committed tolerances of a system: {kernel: {target: tolerance}}; {} if there are none."""
    path = folder / NAME
    if not path.is_file():
        return {}
    content = json.loads(path.read_text("utf-8"))
    return {kernel: {t: float(x) for t, x in found.items()} for kernel, found in content.items()}


def rounded_up(worst: float, epsilon: float) -> float:
    """The tolerance for a measured error: with margin, one digit, at least four roundings."""
    wanted = max(MARGIN * worst, 4 * epsilon)
    if not math.isfinite(wanted):
        raise ValueError(f"no tolerance can be made from an error of {worst}")
    digit = Decimal(1).scaleb(Decimal(wanted).adjusted())
    return float(Decimal(wanted).quantize(digit, rounding=ROUND_CEILING))


def write(folder: Path, tolerances: Mapping[str, Mapping[str, float]]) -> None:
    """Write the tolerances of a system, sorted, in one step."""
    text = json.dumps(tolerances, indent=1, sort_keys=True) + "\n"
    write_atomically(folder / NAME, text)


def merged(known: Tolerances, measured: Iterable[tuple[str, str, float]]) -> Tolerances:
    """The known tolerances with (kernel, target, tolerance) put in."""
    found = {kernel: dict(targets) for kernel, targets in known.items()}
    for kernel, target, tolerance in measured:
        found.setdefault(kernel, {})[target] = tolerance
    return found


def write_atomically(path: Path, text: str) -> None:
    """A reader sees the old file or the new one, never a part."""
    path.parent.mkdir(parents=True, exist_ok=True)
    draft = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        draft.write_text(text, "utf-8")
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)
