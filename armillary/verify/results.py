"""`build/checks.json`: what the checks found, and of what.

Each row carries a digest of the system as it was checked. A row with another digest says nothing
of the system as it stands.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any

from armillary.derivation.beside import files_of
from armillary.derivation.fingerprint import system_digest
from armillary.derivation.folders import names
from armillary.derivation.record import Derivation
from armillary.store.files import digest, digest_of, replace_durably
from armillary.store.lock import locked
from armillary.targets.manifest import read_manifest
from armillary.verify import parameters, tolerances
from armillary.verify.measured import Point

CHECKS = Path("build") / "checks.json"
_LOCK = Path("build") / "checks.lock"

Row = dict[str, Any]


@dataclass(frozen=True)
class Outcome:
    """One row of `build/checks.json`.

    A check that was skipped for want of an engine has neither passed nor failed.
    `worst` is None where no number was found; `digest` is of the system as it was checked.
    """

    system: str
    digest: str
    kernel: str | None
    name: str
    engine: str
    points: int
    worst: float | None
    tolerance: float
    passed: bool
    skipped: bool = False
    why: str = ""
    at: Point = field(default_factory=dict)

    @property
    def failed(self) -> bool:
        """Whether the project is wrong: a skipped check says nothing."""
        return not (self.passed or self.skipped)

    def __str__(self) -> str:
        state = "skipped" if self.skipped else "passed" if self.passed else "FAILED"
        kernel = f" {self.kernel}" if self.kernel else ""
        number = "" if self.worst is None or self.skipped else f" {self.worst:.2g}"
        bound = f" (<= {self.tolerance:.2g})" if number and self.tolerance else ""
        more = f": {self.why}" if self.why else ""
        return f"{state} {self.system}{kernel}: {self.name} [{self.engine}]{number}{bound}{more}"


@dataclass(frozen=True)
class Standing:
    """What is known of a system: the rows of its last check, unless it was edited since."""

    rows: tuple[Row, ...]
    outdated: bool


def standing(root: Path, record: Derivation, rows: Sequence[Row]) -> Standing:
    """Those of some rows that were found on a system as it stands."""
    mine = [row for row in rows if row["system"] == record.name]
    wanted = checked_digest(root, record) if mine else ""
    current = tuple(row for row in mine if row["digest"] == wanted)
    return Standing(current, bool(mine) and not current)


def checked_digest(root: Path, record: Derivation) -> str:
    """A hash of all that the checks of a system look at.

    What it states, its simulation with the files beside that it imports, its parameters and
    tolerances, and the files that were generated from it.
    """
    folder = root / "derivations" / record.name
    manifest = read_manifest(root / "generated")
    entry = manifest.systems.get(record.name) if manifest else None
    parts = [system_digest(record)]
    read = [*files_of(folder / "simulation.py"), folder / tolerances.NAME]
    read += [path for path in (folder / parameters.NAME,) if path.is_file()]
    parts += [f"{path.name} {digest_of(path)}" for path in read]
    parts += [f"{name} {made}" for name, made in sorted(entry.files.items())] if entry else []
    return digest("\n".join(parts).encode())[:16]


def write(root: Path, outcomes: Iterable[Outcome]) -> Path:
    """Put results into `<root>/build/checks.json`; those of other systems stay."""
    path = root / CHECKS
    fresh = [_plain(o) for o in outcomes]
    ran = {row["system"] for row in fresh}
    with locked(root / _LOCK, lambda: None):  # held for a moment only
        there = set(names(root / "derivations"))
        kept = [row for row in read(root) if row["system"] in there - ran]
        rows = sorted([*kept, *fresh], key=lambda row: str(row["system"]))
        replace_durably(path, (json.dumps(rows, indent=1, allow_nan=False) + "\n").encode())
    return path


def read(root: Path) -> list[Row]:
    """The rows of the last run; none before the first, or from a file that cannot be read."""
    try:
        found = json.loads((root / CHECKS).read_bytes())
    except (FileNotFoundError, ValueError):
        return []
    wanted = {f.name for f in fields(Outcome)}
    rows = found if isinstance(found, list) else []
    return [row for row in rows if isinstance(row, dict) and row.keys() == wanted]


def _plain(outcome: Outcome) -> Row:
    """As JSON has it: what is not a number is null, by name where it is an input."""
    plain = asdict(outcome)
    plain["at"] = {name: _number(value) for name, value in outcome.at.items()}
    return plain


def _number(value: Any) -> Any:
    if isinstance(value, list):
        return [_number(v) for v in value]
    return value if math.isfinite(value) else str(value)
