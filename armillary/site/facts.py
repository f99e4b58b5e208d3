"""What the pages read besides the derivations: the manifest of the kernels, and the checks.

Both are results of other commands. A page shows them only where they belong to the derivation as
it stands, and otherwise says which command to run.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from armillary.derivation.fingerprint import kernel_digest
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Kernel
from armillary.program.cost import Cost
from armillary.targets.manifest import Entry, read_manifest
from armillary.verify.results import Row, Standing, standing
from armillary.verify.results import read as read_checks


@dataclass(frozen=True)
class PrintedStage:
    """A set-up or a step as it was generated: its prototypes by precision."""

    signatures: Mapping[str, str]
    cost: Cost


@dataclass(frozen=True)
class Printed:
    """A kernel as it was generated: its prototypes by precision, and its stages."""

    signatures: Mapping[str, str]
    cost: Cost
    digest: str
    stages: Mapping[str, PrintedStage]


@dataclass(frozen=True)
class Facts:
    """Manifest and checks of the project in a folder."""

    root: Path
    systems: Mapping[str, Entry]
    checks: tuple[Row, ...]

    @property
    def package(self) -> str:
        """Name of the generated Python package; empty before the first generation."""
        for entry in self.systems.values():
            for name in entry.files:
                if name.startswith("python/"):
                    return name.split("/")[1]
        return ""

    def printed(self, derivation: Derivation, kernel: Kernel) -> Printed | None:
        """A kernel's facts; None when it was not generated from the derivation as it stands."""
        entry = self.systems.get(derivation.name)
        found = entry.kernels.get(kernel.name) if entry else None
        if found is None or found["stated"] != kernel_digest(derivation, kernel):
            return None
        stages = {
            name: PrintedStage(stage["signatures"], Cost(**stage["cost"]))
            for name, stage in found["stages"].items()
        }
        ordered = {name: stages[name] for name in ("setup", "step") if name in stages}
        return Printed(found["signatures"], Cost(**found["cost"]), found["digest"], ordered)

    def checks_of(self, derivation: Derivation) -> Standing:
        """The checks of one system, in the order they ran; none of before its last edit."""
        return standing(self.root, derivation, self.checks)


def read_facts(root: Path) -> Facts:
    """What is on disk; empty where nothing was generated or checked."""
    manifest = read_manifest(root / "generated")
    return Facts(root, manifest.systems if manifest else {}, tuple(read_checks(root)))
