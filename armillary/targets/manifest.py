"""`generated/manifest.json`: what the finished set consists of, and what it was made from.

It holds only what comes out the same on every machine: versions, the digests of the files, and per
kernel its program, cost and definitions. It is the seal of the set: a set is finished when its
manifest is there and every file has the digest that the manifest gives.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from importlib.metadata import version as version_of
from pathlib import Path
from typing import Any

from armillary import __version__
from armillary.store.files import digest, digest_of

MANIFEST = "manifest.json"
FORMAT = 4
# In the folder of the generated files, but not made by `generate`.
FOREIGN = frozenset({MANIFEST, "budgets.json"})

Facts = dict[str, Any]


@dataclass(frozen=True)
class Entry:
    """One system of the set, or what is common to all: its files with digests, its kernels."""

    files: dict[str, str]
    kernels: dict[str, Facts]

    def digest(self) -> str:
        """A hash of the whole entry."""
        return digest(json.dumps([self.files, self.kernels], sort_keys=True).encode())

    def intact(self, folder: Path) -> bool:
        """Whether every file is there with the contents it should have."""
        return all(digest_of(folder / name) == wanted for name, wanted in self.files.items())


@dataclass(frozen=True)
class Manifest:
    """A finished set."""

    engine: dict[str, str]
    systems: dict[str, Entry]
    shared: Entry

    @property
    def files(self) -> dict[str, str]:
        """Every file with its digest."""
        return {name: d for entry in self._entries() for name, d in entry.files.items()}

    def _entries(self) -> Iterator[Entry]:
        yield self.shared
        yield from self.systems.values()

    def text(self) -> str:
        """The manifest as it is written."""
        content = {
            "format": FORMAT,
            "engine": self.engine,
            "shared": {"files": self.shared.files},
            "systems": {
                name: {"files": entry.files, "kernels": entry.kernels}
                for name, entry in self.systems.items()
            },
        }
        return json.dumps(content, indent=1, sort_keys=True, ensure_ascii=True) + "\n"


def engine_versions() -> dict[str, str]:
    """Versions of all that decides what comes out."""
    return {
        "armillary": __version__,
        "mpmath": version_of("mpmath"),
        "sympy": version_of("sympy"),
    }


def entry_of(files: Mapping[str, str], kernels: Mapping[str, Facts]) -> Entry:
    """The entry of files given by their texts."""
    return Entry({name: digest(text.encode()) for name, text in files.items()}, dict(kernels))


def read_manifest(folder: Path) -> Manifest | None:
    """What the manifest of a folder says; None when there is none, or none of this format."""
    try:
        content = json.loads((folder / MANIFEST).read_bytes())
        if content["format"] != FORMAT:
            return None
        return Manifest(
            dict(content["engine"]),
            {
                name: Entry(dict(entry["files"]), dict(entry["kernels"]))
                for name, entry in content["systems"].items()
            },
            Entry(dict(content["shared"]["files"]), {}),
        )
    except (FileNotFoundError, ValueError, KeyError, TypeError, AttributeError):
        return None


def read_finished(folder: Path) -> Manifest | None:
    """The manifest of a finished set; None for a set that is unfinished or was edited."""
    manifest = read_manifest(folder)
    if manifest is None:
        return None
    whole = all(entry.intact(folder) for entry in (manifest.shared, *manifest.systems.values()))
    return manifest if whole else None


def strangers(folder: Path, known: Mapping[str, object]) -> list[str]:
    """Files of the folder that are not known: neither hidden, nor caches, nor measured budgets."""
    found = []
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        hidden = any(part.startswith(".") or part == "__pycache__" for part in name.split("/"))
        if path.is_file() and not hidden and name not in FOREIGN and name not in known:
            found.append(name)
    return found
