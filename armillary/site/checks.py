"""What was checked, as a page shows it: the lines of `build/checks.json`, in groups."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from armillary.derivation.record import Derivation
from armillary.verify.parity import STATUSES, VALUES

GROUPS = {
    "proofs": "Identities",
    "engines": "Independent engines",
    "forms": "Derivatives and text-book forms",
    "targets": "Generated code",
}
ABOUT = {
    "proofs": "Claims of the derivation, reduced to zero by SymPy for all values.",
    "engines": "The generated kernels, compared with models that share no formula with this page.",
    "forms": "The programs that are printed, compared at 50 digits with the explicit forms above "
    "and with derivatives by dual numbers.",
    "targets": "Each language and precision, compared with the same program at 50 digits.",
}
# A reader opens these when they want them: a line for every kernel and language.
FOLDED = ("forms", "targets")


@dataclass(frozen=True)
class Line:
    """One check."""

    claim: str
    kernel: str
    engine: str
    points: str
    worst: str
    tolerance: str
    state: str
    why: str


@dataclass(frozen=True)
class Group:
    """Checks of one kind."""

    key: str
    title: str
    about: str
    lines: tuple[Line, ...]

    @property
    def folded(self) -> bool:
        """Whether the lines stand behind a summary."""
        return self.key in FOLDED

    def count(self, state: str) -> int:
        """How many checks are in one state."""
        return sum(line.state == state for line in self.lines)


def groups(derivation: Derivation, checks: Iterable[Mapping[str, Any]]) -> list[Group]:
    """The checks of a system by kind; kinds without any are left out."""
    claims = {identity.claim for identity in derivation.identities}
    kinds: dict[str, list[Line]] = {key: [] for key in GROUPS}
    for check in checks:
        kinds[_kind(check, claims)].append(_line(check, derivation))
    return [
        Group(key, GROUPS[key], ABOUT[key], tuple(lines)) for key, lines in kinds.items() if lines
    ]


def _kind(check: Mapping[str, Any], claims: set[str]) -> str:
    if check["name"] in claims and not check["kernel"]:
        return "proofs"
    if check["name"] in (VALUES, STATUSES):
        return "targets"
    engine = str(check["engine"])
    if engine.startswith(("SymPy", "50 digits", "dual numbers")):
        return "forms"
    return "engines"


def _line(check: Mapping[str, Any], derivation: Derivation) -> Line:
    state = "skip" if check["skipped"] else "pass" if check["passed"] else "fail"
    worst, points = check["worst"], int(check["points"])
    return Line(
        str(check["name"]),
        str(check["kernel"] or ""),
        str(check["engine"]),
        str(points) if points else "",
        scientific(worst) if worst is not None and points and state != "skip" else "",
        scientific(check["tolerance"]) if points else "",
        state,
        str(check["why"]) if state != "pass" or not points else "",
    )


def scientific(value: float) -> str:
    """A residual with two digits."""
    return "0" if value == 0 else f"{value:.1e}".replace("e-0", "e-").replace("e+0", "e")
