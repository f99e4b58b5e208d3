"""Runs one part of a study and keeps what it found."""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from armillary.store.files import digest_of
from armillary.store.lock import locked
from armillary.verify.engines import EngineMissing
from armillary.verify.implementations import forget, generated_module, need_compiler
from armillary.verify.parameters import NAME, Parameters, read_parameters, with_settings
from armillary.verify.studies.errors import StudyError, told
from armillary.verify.studies.kept import FOLDER, Kept, checked, find, keep
from armillary.verify.studies.parts import STUDY, Found
from armillary.verify.studies.reads import PYTHON, Surroundings, Watched
from armillary.verify.studies.versions import versions_of

FORMAT = 1  # of what is kept, and of what the key is made from
EVERY = 5.0  # s between two lines of progress

Tell = Callable[[float, str], None]


@dataclass(frozen=True)
class Study:
    """The study of a system of a project.

    Attributes:
        package: name of the generated Python package.
        settings: parameters that are set by hand, as "name=value".
    """

    root: Path
    package: str
    system: str
    settings: tuple[str, ...] = ()

    @property
    def path(self) -> Path:
        """Its file."""
        return self.root / "derivations" / self.system / STUDY

    def parameters(self) -> Parameters | None:
        """Its parameters; None where it has none.

        Raises:
            ParameterError: for anything wrong in their file, or in the settings.
        """
        path = self.path.with_name(NAME)
        if not path.is_file() and not self.settings:
            return None
        return with_settings(read_parameters(path), self.settings)

    def folder(self, part: str) -> Path:
        """Where what a part found is kept."""
        return self.root / FOLDER / self.system / part

    def surroundings(self) -> Surroundings:
        """What its parts can read."""
        return Surroundings(self.root, self.package, self.parameters())


def key_of(study: Study, part: Found, results: Mapping[str, Any]) -> str:
    """A hash of what a part stands on besides what it reads while it runs.

    A part that names the package of the kernels, the derivation, or the file of the parameters may
    use all that is in it.
    """
    lines = [f"format {FORMAT}", *versions_of(part.files)]
    lines += [f"{file.name} {digest_of(file)}" for file in part.files]
    lines += [json.dumps(results, sort_keys=True)]
    texts = [file.read_text("utf-8") for file in part.files]
    if any(study.package in text for text in texts):
        folder = study.root / PYTHON / study.package
        lines += [f"{file.name} {digest_of(file)}" for file in sorted(folder.glob("*.py"))]
    if any(NAME in text for text in texts):
        lines.append(f"{NAME} {digest_of(study.path.with_name(NAME))}")
    derivation = study.path.with_name("derivation.py")
    if derivation in part.files:
        lines.append(_stated(derivation))
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]


def _stated(derivation: Path) -> str:
    """A digest of all that a derivation states, with those that it uses."""
    # SymPy takes a second to import, in each worker, and most parts do without.
    from armillary.derivation.fingerprint import system_digest
    from armillary.derivation.load import load

    return system_digest(load(derivation))


def compute(
    study: Study,
    part: Found,
    results: Mapping[str, Any],
    tell: Tell,
    waiting: Callable[[], None],
) -> Kept:
    """Run a part and keep what it found; another run of it at the same time is waited for.

    Args:
        results: of the parts that it needs.
        tell: hears how far it is, and in words.
        waiting: hears that another run is at it.

    Raises:
        EngineMissing: if something is not installed that it needs.
        StudyError: for anything else that goes wrong, with its line.
    """
    folder = study.folder(part.name)
    with locked(folder.with_suffix(".lock"), waiting):
        surroundings = study.surroundings()
        key = key_of(study, part, results)
        found = find(folder, key, surroundings.are)  # by the run that was waited for
        if found is None:
            reads, begun = _Reads(surroundings), time.monotonic()
            items = _items(study, part, _given(study, part, results, _Teller(tell), reads))
            found = Kept(key, reads.found, round(time.monotonic() - begun, 1), items)
            keep(folder, found)
    return found


def _items(study: Study, part: Found, given: Mapping[str, Any]) -> tuple[Any, ...]:
    """What a part yields."""
    try:
        return tuple(checked(part.run(given[""], **{name: given[name] for name in part.wants})))
    except EngineMissing:
        raise
    except Exception as problem:  # a study is the author's code: say which line of it
        raise told(study.path, problem) from problem


def _given(
    study: Study, part: Found, results: Mapping[str, Any], tell: Tell, reads: _Reads
) -> dict[str, Any]:
    """What a part may take, by name; the kernels of its own system under ""."""
    forget(study.package)
    given: dict[str, Any] = {"": _kernels(study, study.system, reads), "tell": tell}
    for name in part.wants:
        if name == "parameters":
            given[name] = _parameters(study, part, reads)
        elif name == "results":
            given[name] = dict(results)
        elif name == "native":
            given[name] = _native(study, reads)
        elif name != "tell":
            given[name] = _kernels(study, name, reads)
    return given


def _parameters(study: Study, part: Found, reads: _Reads) -> Parameters:
    known = reads.surroundings.parameters
    if known is None:
        raise StudyError(
            f"{study.path}: the part {part.name!r} takes parameters, and there is no "
            f"{study.path.with_name(NAME)}",
            "write it, or leave the argument out",
        )
    return known.watched(lambda name: reads.touch(f"parameter {name}"))


def _kernels(study: Study, system: str, reads: _Reads) -> Watched:
    reads.surroundings.state(f"kernel {system}.")  # as it is now, when it is imported
    try:
        module = generated_module(study.root / PYTHON, study.package, system)
    except ModuleNotFoundError as problem:
        raise StudyError(
            f"{study.path}: there are no kernels of {system}", "run `armillary generate`"
        ) from problem
    return Watched(module, lambda name: reads.touch(f"kernel {system}.{name}"))


def _native(study: Study, reads: _Reads) -> Watched:
    need_compiler()
    module = generated_module(study.root / PYTHON, study.package, "native")
    kernels = getattr(module, study.system)
    return Watched(kernels, lambda name: reads.touch(f"native {study.system}.{name}"))


class _Reads:
    """What a part has touched, as it was then."""

    def __init__(self, surroundings: Surroundings) -> None:
        self.surroundings = surroundings
        self.found: dict[str, str] = {}

    def touch(self, key: str) -> None:
        if key not in self.found:
            self.found[key] = self.surroundings.state(key)


class _Teller:
    """Passes on how far a part is, now and then."""

    def __init__(self, tell: Tell) -> None:
        self._tell, self._last = tell, time.monotonic()

    def __call__(self, fraction: float, words: str = "") -> None:
        if time.monotonic() - self._last >= EVERY:
            self._last = time.monotonic()
            self._tell(min(max(float(fraction), 0.0), 1.0), words)
