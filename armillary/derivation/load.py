"""Finds and loads derivations: `<root>/<name>/derivation.py`, one `derivation` each."""

from __future__ import annotations

import sys
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.mends import told_and_mended
from armillary.derivation.record import Derivation

_loaded: ContextVar[dict[Path, Derivation] | None] = ContextVar("loaded", default=None)
_loading: ContextVar[tuple[Path, ...]] = ContextVar("loading", default=())


def names(root: Path) -> list[str]:
    """The systems of a project, sorted."""
    return sorted(p.parent.name for p in root.glob("*/derivation.py"))


def load_all(root: Path) -> dict[str, Derivation]:
    """Every derivation below a folder; each file is run once."""
    with _shared():
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
    with _shared() as done:
        if path not in done:
            token = _loading.set((*_loading.get(), path))
            try:
                done[path] = _run(path)
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
def _shared() -> Iterator[dict[Path, Derivation]]:
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


def _run(path: Path) -> Derivation:
    spec = spec_from_file_location(f"_armillary_derivation_{path.parent.name}", path)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    keep, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    try:
        spec.loader.exec_module(module)
    except DerivationError:
        raise
    except Exception as problem:
        source = _last_line_in(path, problem)
        raise DerivationError(*told_and_mended(problem, source), source) from problem
    finally:
        sys.dont_write_bytecode = keep
    made = getattr(module, "derivation", None)
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
    return made


def _last_line_in(path: Path, problem: BaseException) -> Source:
    if isinstance(problem, SyntaxError) and problem.lineno is not None:
        return Source(problem.filename or str(path), problem.lineno)
    lines = [
        f.lineno
        for f in traceback.extract_tb(problem.__traceback__)
        if Path(f.filename).resolve() == path and f.lineno is not None
    ]
    return Source(str(path), lines[-1] if lines else 1)
