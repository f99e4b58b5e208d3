"""The parts of a study: what `study.py` says that is to be run."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from armillary.derivation.beside import files_of, run
from armillary.derivation.folders import names
from armillary.verify.studies.errors import StudyError
from armillary.verify.study import Part

STUDY = "study.py"
ALONE = "study"  # name of the part of a study that has but one function
GIVEN = ("parameters", "tell", "results", "native")
_NAME = re.compile(r"[a-z0-9][a-z0-9_-]*\Z")
_MEND = 'write parts = [("name", function), ...], or a function study(kernels)'


@dataclass(frozen=True)
class Found:
    """A part as it was found.

    Attributes:
        files: its file, and those beside that this imports; an edit of one runs it again.
        wants: names of what it takes besides the kernels.
    """

    name: str
    run: Callable[..., Any]
    needs: tuple[str, ...]
    files: tuple[Path, ...]
    wants: tuple[str, ...]


def parts_of(path: Path) -> tuple[Found, ...]:
    """The parts of a study in the order of the page; its file is run.

    Raises:
        StudyError: for parts that are written wrongly. What else goes wrong in the file is passed
            on as it is.
    """
    path = path.resolve()
    module = run(path).module
    listed = getattr(module, "parts", None)
    if listed is None:
        alone = getattr(module, "study", None)
        if not callable(alone):
            raise StudyError(f"{path} has no study", _MEND)
        return (_found(path, Part(ALONE, alone)),)
    if not isinstance(listed, Sequence) or not listed:
        raise StudyError(f"{path}: `parts` is no list of parts", _MEND)
    found = tuple(_found(path, _part(path, one)) for one in listed)
    _check_needs(path, found)
    return found


def with_needed(parts: Sequence[Found], chosen: Sequence[str]) -> tuple[Found, ...]:
    """The chosen parts, or all of them, and what they need.

    Raises:
        StudyError: for a name that no part has.
    """
    known = {part.name: part for part in parts}
    wanted: set[str] = set()
    open_ = list(chosen or known)
    while open_:
        name = open_.pop()
        if name not in known:
            raise StudyError(f"the study has no part {name!r}", f"choose from {', '.join(known)}")
        if name not in wanted:
            wanted.add(name)
            open_ += known[name].needs
    return tuple(part for part in parts if part.name in wanted)


def _part(path: Path, given: Any) -> Part:
    part: Any = Part(*given) if isinstance(given, tuple) and len(given) == 2 else given
    if not isinstance(part, Part):
        raise StudyError(f"{path}: {given!r} is no part", _MEND)
    if not _NAME.match(str(part.name)):
        raise StudyError(
            f"{path}: a part has the name {part.name!r}",
            "use small letters, digits, hyphens and underscores: its file is named like it",
        )
    function: Any = part.run
    if not callable(function) or isinstance(part.needs, str):
        raise StudyError(
            f"{path}: the part {part.name!r} has no function, or its needs are no list",
            'write Part("name", function, needs=["other"])',
        )
    return part


def _found(path: Path, part: Part) -> Found:
    found = Found(part.name, part.run, tuple(part.needs), (), ())
    return replace(found, files=_files(path, part.run), wants=_wants(path, part))


def _files(path: Path, function: Any) -> tuple[Path, ...]:
    """The file of a plain function; of anything else nobody knows, so it counts on `study.py`."""
    if inspect.isfunction(function) and function.__closure__ is None:
        own = Path(function.__code__.co_filename)
        if own.parent == path.parent and not hasattr(function, "__wrapped__"):
            return tuple(files_of(own))
    return tuple(files_of(path))


def _wants(path: Path, part: Part) -> tuple[str, ...]:
    """What a part takes besides the kernels."""
    taken = [p for p in inspect.signature(part.run).parameters.values() if p.default is p.empty]
    systems = names(path.parents[1])
    for one in taken[1:]:
        if one.kind in (one.POSITIONAL_ONLY, one.VAR_POSITIONAL, one.VAR_KEYWORD):
            raise StudyError(
                f"{path}: the part {part.name!r} takes {one}", "give each argument its name"
            )
        if one.name not in (*GIVEN, *systems):
            raise StudyError(
                f"{path}: the part {part.name!r} takes {one.name!r}, which nobody gives",
                f"after the kernels there are {', '.join(GIVEN)}, and the kernels of a system by "
                f"its name: {', '.join(systems)}",
            )
    if not taken:
        raise StudyError(
            f"{path}: the part {part.name!r} takes no kernels", "let its first argument be kernels"
        )
    return tuple(one.name for one in taken[1:])


def _check_needs(path: Path, parts: Sequence[Found]) -> None:
    """Refuse parts of one name, and needs that are not there or go in a ring."""
    known = {part.name: part for part in parts}
    if len(known) < len(parts):
        raise StudyError(f"{path}: two parts have one name", "name each once")
    ready: set[str] = set()
    for part in parts:
        for need in part.needs:
            if need not in known:
                raise StudyError(
                    f"{path}: the part {part.name!r} needs {need!r}, which is no part",
                    f"choose from {', '.join(known)}",
                )
    for _ in parts:
        ready |= {part.name for part in parts if ready.issuperset(part.needs)}
    if len(ready) < len(parts):
        ring = ", ".join(name for name in known if name not in ready)
        raise StudyError(f"{path}: parts need each other in a ring: {ring}", "break the ring")
