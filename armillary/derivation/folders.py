"""Where the files of a project's derivations stand; nothing is read, so that asking is quick."""

from __future__ import annotations

from pathlib import Path


def names(root: Path) -> list[str]:
    """The systems of a project, sorted: `<root>/<name>/derivation.py`."""
    return sorted(p.parent.name for p in root.glob("*/derivation.py"))


def paper_names(root: Path) -> list[str]:
    """The papers of a project, sorted: `<root>/papers/<key>.py`; `_part.py` is part of one."""
    return sorted(p.stem for p in (root / "papers").glob("*.py") if not p.stem.startswith("_"))
