"""The stamp: from what each system was last generated, on this machine.

`build/generated.json` is not committed. It lets a run see, without loading SymPy, that there is
nothing to do. Contents are compared, never times.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import armillary
from armillary.project.config import Project
from armillary.store.files import digest, digest_of, replace_durably
from armillary.targets.manifest import Entry, engine_versions

STAMP = "generated.json"
FORMAT = 1
# Parts of the package that nothing generated depends on.
_APART = frozenset({"cli.py", "site", "store", "templates", "verify"})


@dataclass(frozen=True)
class Mark:
    """What one system was made from, and what it became.

    Attributes:
        reads: the files that it was read from.
        inputs: a hash over them and the base.
        entry: digest of the entry that the manifest got.
        table: what the files shared by all systems tell of it, as a Python literal.
    """

    reads: tuple[str, ...]
    inputs: str
    entry: str
    table: str


@dataclass
class Stamp:
    """The marks of all systems; `base` is of what every system depends on."""

    base: str = ""
    marks: dict[str, Mark] = field(default_factory=dict)

    def write(self, path: Path) -> None:
        """Replace the stamp file."""
        content = {
            "format": FORMAT,
            "base": self.base,
            "systems": {name: asdict(mark) for name, mark in sorted(self.marks.items())},
        }
        replace_durably(path, (json.dumps(content, indent=1) + "\n").encode())


def read_stamp(path: Path) -> Stamp:
    """The stamp in a file; an empty one when it cannot be read."""
    try:
        content: dict[str, Any] = json.loads(path.read_bytes())
        if content["format"] != FORMAT:
            return Stamp()
        marks = {
            name: Mark(tuple(mark["reads"]), mark["inputs"], mark["entry"], mark["table"])
            for name, mark in content["systems"].items()
        }
        return Stamp(content["base"], marks)
    except (FileNotFoundError, ValueError, KeyError, TypeError, AttributeError):
        return Stamp()


def base_digest(project: Project) -> str:
    """A hash over the engine's source, the versions beneath it and the project's settings."""
    package = Path(armillary.__file__).parent
    parts = [
        f"{path.relative_to(package).as_posix()} {digest_of(path)}"
        for path in sorted(package.rglob("*"))
        if path.is_file() and _matters(path.relative_to(package))
    ]
    settings = [
        project.kernels,
        project.c_folder,
        project.c_prefix,
        list(project.precisions),
        project.version,
    ]
    return digest(json.dumps([parts, engine_versions(), settings], sort_keys=True).encode())


def _matters(path: Path) -> bool:
    return path.parts[0] not in _APART and "__pycache__" not in path.parts


@dataclass(frozen=True)
class Inputs:
    """All that systems can be made from, as it was at one moment.

    It is taken before anything is loaded, so that an edit made meanwhile counts as new.
    """

    base: str
    sources: Mapping[str, str | None]

    def digest(self, reads: Iterable[str]) -> str:
        """A hash over the files that a system is read from, and over the base."""
        parts = [f"{name} {self.sources.get(name)}" for name in sorted(reads)]
        return digest("\n".join([self.base, *parts]).encode())


def take_inputs(project: Project) -> Inputs:
    """The inputs as they are now."""
    sources = {
        path.relative_to(project.root).as_posix(): digest_of(path)
        for path in project.derivations.rglob("*.py")
    }
    return Inputs(base_digest(project), sources)


def is_fresh(project: Project, inputs: Inputs, mark: Mark | None, entry: Entry | None) -> bool:
    """Whether a system's files are there and are what generating it again would give."""
    return (
        mark is not None
        and entry is not None
        and mark.entry == entry.digest()
        and mark.inputs == inputs.digest(mark.reads)
        and entry.intact(project.generated)
    )
