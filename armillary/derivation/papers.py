"""Finds and loads what the papers print: `<root>/papers/<key>.py`, one `paper` each."""

from __future__ import annotations

from pathlib import Path

from armillary.derivation import beside
from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.load import last_line_of, shared
from armillary.derivation.mends import told_and_mended
from armillary.derivation.paper import Paper


def paper_names(root: Path) -> list[str]:
    """The papers of a project's derivations, sorted."""
    return sorted(p.stem for p in (root / "papers").glob("*.py") if not p.stem.startswith("_"))


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
        ran = _run(path)
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


def _run(path: Path) -> beside.Ran:
    try:
        return beside.run(path)
    except DerivationError:
        raise
    except Exception as problem:
        source = last_line_of(path, problem)
        raise DerivationError(*told_and_mended(problem, source), source) from problem
