"""What the pages read besides the derivations: the manifest of the kernels, and the checks.

Both are results of other commands. A page shows them only where they belong to the derivation as
it stands, and otherwise says which command to run.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from armillary.derivation.fingerprint import definition_digest, kernel_definitions
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Kernel
from armillary.program.cost import Cost
from armillary.verify.runner import read as read_checks


@dataclass(frozen=True)
class Printed:
    """A kernel as it was generated."""

    signature: str
    cost: Cost
    digest: str


@dataclass(frozen=True)
class Facts:
    """Manifest and checks of a project."""

    manifest: Mapping[str, Any]
    checks: list[dict[str, Any]]

    @property
    def package(self) -> str:
        """Name of the generated Python package; empty before the first generation."""
        for entry in self.manifest.values():
            for name in entry["files"]:
                if name.startswith("python/"):
                    return str(name.split("/")[1])
        return ""

    def printed(self, derivation: Derivation, kernel: Kernel) -> Printed | None:
        """A kernel's facts; None when it was not generated from the derivation as it stands."""
        kernels = self.manifest.get(derivation.name, {}).get("kernels", {})
        found = kernels.get(kernel.name)
        if found is None:
            return None
        stated = kernel_definitions(derivation, kernel)
        digests = {name: definition_digest(d) for name, d in stated.items()}
        if digests != found["definitions"]:
            return None
        return Printed(found["signature"], Cost(**found["cost"]), found["digest"])

    def checks_of(self, system: str) -> list[dict[str, Any]]:
        """The checks of one system, in the order they ran."""
        return [check for check in self.checks if check["system"] == system]


def read_facts(root: Path) -> Facts:
    """What is on disk; empty where nothing was generated or checked."""
    path = root / "generated" / "manifest.json"
    try:
        systems = json.loads(path.read_bytes())["systems"]
    except (FileNotFoundError, ValueError, KeyError, TypeError):
        systems = {}
    return Facts(systems, read_checks(root))
