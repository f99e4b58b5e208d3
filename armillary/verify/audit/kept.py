"""Findings kept in `build/audit.json`, each paper's with a digest of what they stand on.

The form is stable, and is what `armillary audit --json` prints:

    {"format": 1,
     "papers": {KEY: {"digest": ..., "counts": {VERDICT: n}, "findings": [FINDING, ...]}}}

A finding has the fields of `verdict.Finding`, its readings those of `Read`, and so on down. All
verdicts stand in `counts`, those that nothing has with 0. Values are in SI units; one that is not
finite is a string: "nan", "inf", "-inf".
"""

from __future__ import annotations

import json
import math
from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass
from functools import cache
from importlib.metadata import version as version_of
from pathlib import Path
from typing import Any

import armillary
from armillary.derivation.paper import Paper
from armillary.derivation.record import Derivation
from armillary.store.files import digest, digest_of, replace_durably
from armillary.store.lock import locked
from armillary.targets.manifest import engine_versions
from armillary.verify.audit.verdict import Counterexample, Entry, Finding, Read, Repair, Verdict
from armillary.verify.parameters import NAME

AUDIT = Path("build") / "audit.json"
FORMAT = 1
_LOCK = Path("build") / "audit.lock"
# Parts of the package that decide what an audit says; the last ones print repairs.
_ENGINE = (
    "algebra", "derivation", "mechanism", "program", "verify",
    "site/idioms.py", "site/notation.py", "site/structure.py",
)  # fmt: skip


@dataclass(frozen=True)
class Audit:
    """The findings on one paper; `digest` is of all they stand on."""

    digest: str
    findings: tuple[Finding, ...]


def counts(findings: Collection[Finding]) -> dict[Verdict, int]:
    """How many findings have each verdict, from the best to the least."""
    return {verdict: sum(f.verdict is verdict for f in findings) for verdict in Verdict}


def current(paper: Paper, kept: Mapping[str, Audit]) -> Audit | None:
    """The audit of a paper, unless something it stands on has changed since."""
    found = kept.get(paper.name)
    return found if found is not None and found.digest == audit_digest(paper) else None


def audit_digest(paper: Paper) -> str:
    """A hash of the files of a paper and of the systems it uses, and of what audits them."""
    parts = [f"{Path(file).name} {digest_of(Path(file))}" for file in sorted(_files(paper))]
    return digest("\n".join([paper.name, *parts, _engine()]).encode())[:16]


def _files(record: Derivation) -> set[str]:
    mine = {*record.files, record.source.path}
    # A paper may take dimensions from where the study of a system has them.
    beside = {Path(file).with_name(NAME) for file in mine}
    mine |= {str(file) for file in beside if file.is_file()}
    return mine.union(*(_files(used.derivation) for used in record.used.values()))


@cache
def _engine() -> str:
    package = Path(armillary.__file__).parent
    parts = [
        f"{path.relative_to(package).as_posix()} {digest_of(path)}"
        for name in _ENGINE
        for path in ([package / name] if name.endswith(".py") else _below(package / name))
    ]
    versions = {**engine_versions(), "numpy": version_of("numpy")}
    return digest(json.dumps([parts, versions], sort_keys=True).encode())


def _below(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.py"))


def write(root: Path, audits: Mapping[str, Audit], there: Collection[str]) -> Path:
    """Put audits into `<root>/build/audit.json`; others stay if their paper is still there."""
    path = root / AUDIT
    with locked(root / _LOCK, lambda: None):  # held for a moment only
        known = {key: audit for key, audit in read(root).items() if key in there}
        replace_durably(path, as_json({**known, **audits}).encode())
    return path


def as_json(audits: Mapping[str, Audit]) -> str:
    """Audits in the documented form, papers sorted by key."""
    papers = {
        key: {
            "digest": audits[key].digest,
            "counts": counts(audits[key].findings),
            "findings": [_plain(asdict(finding)) for finding in audits[key].findings],
        }
        for key in sorted(audits)
    }
    content = {"format": FORMAT, "papers": papers}
    return json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def read(root: Path) -> dict[str, Audit]:
    """The audits that were kept; none from a file that is not there or cannot be read."""
    try:
        content = json.loads((root / AUDIT).read_bytes())
        if content["format"] != FORMAT:
            return {}
        return {
            key: Audit(entry["digest"], tuple(map(_finding, entry["findings"])))
            for key, entry in content["papers"].items()
        }
    except (FileNotFoundError, ValueError, KeyError, TypeError, AttributeError):
        return {}


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(inner) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(inner) for inner in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value


def _finding(row: dict[str, Any]) -> Finding:
    known = {"claims": tuple(row["claims"]), "readings": tuple(map(_read, row["readings"]))}
    return Finding(**{**row, **known, "verdict": Verdict(row["verdict"])})


def _read(row: dict[str, Any]) -> Read:
    known = {
        "verdict": Verdict(row["verdict"]),
        "whole": _repair(row["whole"]),
        "entries": tuple(map(_entry, row["entries"])),
        "properties": tuple(row["properties"]),
        "counterexample": _counterexample(row["counterexample"]),
        "worst": float(row["worst"]),
    }
    return Read(**{**row, **known})


def _entry(row: dict[str, Any]) -> Entry:
    known = {
        "verdict": Verdict(row["verdict"]),
        "repair": _repair(row["repair"]),
        "worst": float(row["worst"]),
    }
    return Entry(**{**row, **known})


def _repair(row: dict[str, Any] | None) -> Repair | None:
    return None if row is None else Repair(**row)


def _counterexample(row: dict[str, Any] | None) -> Counterexample | None:
    if row is None:
        return None
    at = {
        name: [float(x) for x in value] if isinstance(value, list) else float(value)
        for name, value in row["at"].items()
    }
    known = {"at": at, "printed": float(row["printed"]), "derived": float(row["derived"])}
    return Counterexample(**{**row, **known})
