"""Finds and loads derivations: `<root>/<name>/derivation.py`, one `derivation` each.

Its parts may stand in files beside it, which it imports with `from .part import ...`.
"""

from __future__ import annotations

import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from armillary.derivation import beside
from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.folders import names
from armillary.derivation.mends import told_and_mended
from armillary.derivation.record import Derivation

_loaded: ContextVar[dict[Path, Derivation] | None] = ContextVar("loaded", default=None)
_loading: ContextVar[tuple[Path, ...]] = ContextVar("loading", default=())


def load_all(root: Path) -> dict[str, Derivation]:
    """Every derivation below a folder; each file is run once."""
    with shared():
        return {name: load(root / name / "derivation.py") for name in names(root)}


def load(path: Path) -> Derivation:
    """The `derivation` of one file.

    Raises:
        DerivationError: with file, line and mend, for anything the file does wrong.
    """
    path = path.resolve()
    if not path.is_file():
        raise DerivationError(
            f"there is no {path}", "`armillary list` shows the systems of this project"
        )
    if path in _loading.get():
        ring = " -> ".join(p.parent.name for p in (*_loading.get(), path))
        raise DerivationError(f"derivations use each other in a ring: {ring}", "break the ring")
    with shared() as done:
        if path not in done:
            token = _loading.set((*_loading.get(), path))
            try:
                done[path] = _derivation_of(path)
            finally:
                _loading.reset(token)
        return done[path]


def load_beside(source: Source, name: str) -> Derivation:
    """The system `name` of the project that a derivation belongs to."""
    root = Path(source.path).resolve().parents[1]
    path = root / name / "derivation.py"
    if not path.is_file():
        raise DerivationError(
            f"there is no system {name!r} to use", f"there are {', '.join(names(root))}", source
        )
    return load(path)


@contextmanager
def shared() -> Iterator[dict[Path, Derivation]]:
    """One record per file within one call, so that two users share the same symbols."""
    done = _loaded.get()
    if done is not None:
        yield done
        return
    token = _loaded.set({})
    try:
        fresh = _loaded.get()
        assert fresh is not None
        yield fresh
    finally:
        _loaded.reset(token)


def run(path: Path) -> beside.Ran:
    """Run a file of an author.

    Raises:
        DerivationError: with file, line and mend, for whatever goes wrong in it.
    """
    try:
        return beside.run(path)
    except DerivationError:
        raise
    except Exception as problem:
        source = _last_line_of(path, problem)
        raise DerivationError(*told_and_mended(problem, source), source) from problem


def _derivation_of(path: Path) -> Derivation:
    ran = run(path)
    made = getattr(ran.module, "derivation", None)
    if not isinstance(made, Derivation):
        raise DerivationError(
            "the file makes no derivation",
            'write `derivation = d = Derivation("name", title="...")` at its top',
            Source(str(path), 1),
        )
    if made.name != path.parent.name:
        raise DerivationError(
            f"the derivation is named {made.name!r} but stands in the folder {path.parent.name!r}",
            "give both one name",
            made.source,
        )
    made.files = tuple(map(str, ran.files))
    return made


def _last_line_of(path: Path, problem: BaseException) -> Source:
    """The innermost line of a derivation's folder that a problem went through."""
    if isinstance(problem, SyntaxError) and problem.lineno is not None:
        return Source(problem.filename or str(path), problem.lineno)
    lines = [
        Source(f.filename, f.lineno)
        for f in traceback.extract_tb(problem.__traceback__)
        if Path(f.filename).resolve().parent == path.parent and f.lineno is not None
    ]
    return lines[-1] if lines else Source(str(path), 1)
