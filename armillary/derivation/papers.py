"""Finds and loads what the papers print: `<root>/papers/<key>.py`, one `paper` each."""

from __future__ import annotations

from pathlib import Path

from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.folders import paper_names
from armillary.derivation.load import run, shared
from armillary.derivation.paper import Paper


def load_papers(root: Path) -> dict[str, Paper]:
    """Every paper of a project; systems that several use are loaded once."""
    with shared():
        return {name: load_paper(root / "papers" / f"{name}.py") for name in paper_names(root)}


def load_paper(path: Path) -> Paper:
    """The `paper` of one file.

    Raises:
        DerivationError: with file, line and mend, for anything the file does wrong.
    """
    path = path.resolve()
    if not path.is_file():
        known = ", ".join(paper_names(path.parents[1])) or "none"
        raise DerivationError(f"there is no {path}", f"the papers of this project are: {known}")
    with shared():
        ran = run(path)
    made = getattr(ran.module, "paper", None)
    if not isinstance(made, Paper):
        raise DerivationError(
            "the file makes no paper",
            f'write `paper = Paper("{path.stem}")` at its top',
            Source(str(path), 1),
        )
    if made.name != path.stem:
        raise DerivationError(
            f"the paper is named {made.name!r} but its file {path.name!r}",
            "give both one name, the key of references.toml",
            made.source,
        )
    made.files = tuple(map(str, ran.files))
    return made
