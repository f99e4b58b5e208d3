"""Runs `study.py` of a system when something that it stands on has changed.

What it yields is kept in `build/studies/<system>.json`, so that a build of the site need not run
again what takes seconds. A page whose engine is not installed says so.
"""

from __future__ import annotations

import hashlib
import json
import logging
import traceback
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, fields, is_dataclass
from pathlib import Path
from typing import Any

from armillary.derivation.beside import files_of, run
from armillary.derivation.fingerprint import system_digest
from armillary.derivation.record import Derivation
from armillary.site.errors import SiteError
from armillary.site.facts import Facts
from armillary.store.files import digest_of, replace_durably
from armillary.store.lock import locked
from armillary.verify import plots, study
from armillary.verify.engines import EngineMissing
from armillary.verify.implementations import forget, generated_module
from armillary.verify.plot_values import PlotError
from armillary.verify.study import Item

log = logging.getLogger("mkdocs.armillary")

_PYTHON = Path("generated") / "python"
_LOCK = Path("build") / "studies.lock"
_PARTS = (
    plots.Axis, plots.Band, plots.Bars, plots.Curve, plots.HeatMap, plots.Histogram, plots.Mark,
    plots.Panels, plots.Plot, plots.Series, study.Column, study.Heading, study.Prose, study.Table,
)  # fmt: skip
_KINDS = {kind.__name__: kind for kind in _PARTS}
_ITEMS = (
    plots.Bars, plots.HeatMap, plots.Histogram, plots.Panels, plots.Plot, study.Heading,
    study.Prose, study.Table,
)  # fmt: skip


@dataclass(frozen=True)
class Studied:
    """What a study found; or why it could not run here."""

    items: tuple[Item, ...] = ()
    missing: str = ""


def studied(root: Path, derivation: Derivation, facts: Facts) -> Studied:
    """The study of a system; empty where it has none or its kernels are not generated.

    Raises:
        SiteError: for anything that goes wrong in `study.py`, with its line.
    """
    path = root / "derivations" / derivation.name / "study.py"
    module = root / _PYTHON / facts.package / f"{derivation.name}.py"
    if not facts.package or not path.is_file() or not module.is_file():
        return Studied()
    key = _key(path, module, derivation)
    kept = root / "build" / "studies" / f"{derivation.name}.json"
    known = _read(kept, key)
    if known is not None:
        return Studied(known)
    log.info("studying %s", derivation.name)
    try:
        forget(facts.package)
        kernels = generated_module(root / _PYTHON, facts.package, derivation.name)
        found = _checked(run(path).module.study(kernels))
    except EngineMissing as missing:
        return Studied(missing=f"{missing.engine} is not installed")
    except Exception as problem:  # a study is the author's code: say which line of it
        raise _told(path, problem) from problem
    text = json.dumps({"key": key, "items": [_plain(item) for item in found]}, allow_nan=False)
    with locked(root / _LOCK, lambda: None):  # held for a moment only
        replace_durably(kept, (text + "\n").encode())
    return Studied(tuple(found))


@contextmanager
def telling(say: Callable[[str], None]) -> Iterator[None]:
    """Pass on which study is at work; MkDocs is quiet while it builds."""
    level, handler = log.level, logging.Handler()
    handler.emit = lambda record: say(record.getMessage())  # type: ignore[method-assign]
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    try:
        yield
    finally:
        log.removeHandler(handler)
        log.setLevel(level)


def _key(path: Path, module: Path, derivation: Derivation) -> str:
    """A hash of what a study stands on: the derivation, its own files, the generated kernels.

    One that names the package of the kernels may use those of any system.
    """
    own = files_of(path)
    package = module.parent.name
    others = any(package in file.read_text("utf-8") for file in own)
    used = {derivation.name, *_used(derivation)}
    read = [f for f in sorted(module.parent.glob("*.py")) if others or f.stem in used]
    parts = [system_digest(derivation), *(f"{f.name} {digest_of(f)}" for f in (*own, *read))]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def _used(derivation: Derivation) -> set[str]:
    found = set(derivation.used)
    return found.union(*(_used(used.derivation) for used in derivation.used.values()))


def _checked(found: Iterable[object]) -> list[Any]:
    items = list(found)
    for item in items:
        if not isinstance(item, _ITEMS):
            raise PlotError(
                f"the study yields {type(item).__name__}",
                f"yield {', '.join(kind.__name__ for kind in _ITEMS)}",
            )
    return items


def _told(path: Path, problem: Exception) -> SiteError:
    """A problem with the innermost line of the system's folder that it went through."""
    frames = traceback.extract_tb(problem.__traceback__)
    lines = [f for f in frames if Path(f.filename).parent == path.resolve().parent]
    place = f"{lines[-1].filename}:{lines[-1].lineno}" if lines else str(path)
    if isinstance(problem, PlotError):
        return SiteError(f"{place}: {problem.problem}", problem.mend)
    return SiteError(f"{place}: {type(problem).__name__}: {problem}", "mend this line of the study")


# -- as JSON --------------------------------------------------------------------------------------


def _plain(value: Any) -> Any:
    if is_dataclass(value):
        kept = {f.name: _plain(getattr(value, f.name)) for f in fields(value)}
        return {"is": type(value).__name__, **kept}
    return [_plain(one) for one in value] if isinstance(value, (tuple, list)) else value


def _made(value: Any) -> Any:
    if isinstance(value, dict):
        kind = _KINDS[value["is"]]
        return kind(**{name: _made(one) for name, one in value.items() if name != "is"})
    return tuple(_made(one) for one in value) if isinstance(value, list) else value


def _read(path: Path, key: str) -> tuple[Item, ...] | None:
    try:
        content = json.loads(path.read_text("utf-8"))
        if content["key"] != key:
            return None
        found: tuple[Item, ...] = _made(content["items"])
    except (FileNotFoundError, ValueError, KeyError, TypeError):
        return None
    return found
