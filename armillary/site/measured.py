"""The curves of `simulation.py`, measured when something they stand on has changed.

They are kept in `build/plots/<system>.json`, so that a build of the site need not run an engine
that takes seconds to load. A page whose engine is not installed goes without the plot.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from armillary.site.facts import Facts
from armillary.store.files import replace_durably
from armillary.store.lock import locked
from armillary.verify.curves import Curve, Plot
from armillary.verify.engines import EngineMissing
from armillary.verify.implementations import generated_module
from armillary.verify.runner import simulation_module

_PYTHON = Path("generated") / "python"
_LOCK = Path("build") / "plots.lock"


def measured_plots(root: Path, system: str, facts: Facts) -> list[Plot]:
    """The plots of a system; none where it has no simulation or its kernels are not generated."""
    simulation = root / "derivations" / system / "simulation.py"
    module = root / _PYTHON / facts.package / f"{system}.py"
    if not facts.package or not simulation.is_file() or not module.is_file():
        return []
    text = simulation.read_text("utf-8")
    if "\ndef plots(" not in text:
        return []
    key = hashlib.sha256(text.encode() + module.read_bytes()).hexdigest()
    kept = root / "build" / "plots" / f"{system}.json"
    known = _read(kept, key)
    if known is not None:
        return known
    try:
        kernels = generated_module(root / _PYTHON, facts.package, system)
        found = list(simulation_module(simulation).plots(kernels))
    except EngineMissing:
        return []
    plain = json.dumps({"key": key, "plots": [asdict(plot) for plot in found]})
    with locked(root / _LOCK, lambda: None):  # held for a moment only
        replace_durably(kept, (plain + "\n").encode())
    return _plots(json.loads(plain)["plots"])


def _read(path: Path, key: str) -> list[Plot] | None:
    try:
        content = json.loads(path.read_text("utf-8"))
        return _plots(content["plots"]) if content["key"] == key else None
    except (FileNotFoundError, ValueError, KeyError, TypeError):
        return None


def _plots(content: list[dict[str, Any]]) -> list[Plot]:
    return [
        Plot(p["caption"], p["across"], p["up"], tuple(Curve(**curve) for curve in p["curves"]))
        for p in content
    ]
