"""A folder of files that changes as one.

One file, the *seal*, vouches for the others: it holds their digests. A set is finished when its
seal is there and the digests agree. A change goes through these steps:

1. All new contents are written to `.staging/`, where nobody looks for them.
2. `.staging/journal.json` says what is to be moved and what to be removed. It appears by one
   rename, and from that moment on the change will happen.
3. The old seal is removed. Files are removed and moved into place. The new seal comes last.
4. The journal goes, then the rest of `.staging/`.

Killed before the journal is there, the next run throws the staging away: nothing had changed.
Killed later, the next run does steps 3 and 4 again; each of their moves may be repeated.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterable, Mapping
from enum import Enum
from pathlib import Path

from armillary.store.files import (
    make_folder,
    remove_empty_folders,
    remove_file,
    replace_durably,
    sync_folder,
    write_durably,
)

STAGING = ".staging"
_JOURNAL = "journal.json"
_NEW = "new"


class Recovery(Enum):
    """What was found of an earlier run."""

    NOTHING = "nothing"
    FINISHED = "finished"
    DISCARDED = "discarded"


def commit(folder: Path, seal: str, write: Mapping[str, bytes], remove: Iterable[str] = ()) -> None:
    """Change a folder as one; the caller holds its lock and has called `recover`.

    Args:
        folder: the folder; names are relative to it, with forward slashes.
        seal: name of the file that vouches for the set; one of `write`.
        write: new contents of every file that changes.
        remove: files that go.
    """
    staging = folder / STAGING
    for name, data in write.items():
        write_durably(staging / _NEW / name, data)
    for inner in sorted((staging / _NEW).rglob("*")):
        if inner.is_dir():
            sync_folder(inner)
    sync_folder(staging / _NEW)
    plan = {"seal": seal, "write": sorted(set(write) - {seal}), "remove": sorted(remove)}
    replace_durably(staging / _JOURNAL, json.dumps(plan, indent=1).encode())
    _apply(folder)


def recover(folder: Path) -> Recovery:
    """Finish or discard what a killed run left behind; the caller holds the lock."""
    staging = folder / STAGING
    if not staging.is_dir():
        return Recovery.NOTHING
    if (staging / _JOURNAL).is_file():
        _apply(folder)
        return Recovery.FINISHED
    _discard(staging)
    return Recovery.DISCARDED


def in_flight(folder: Path) -> bool:
    """Whether a change of the folder was begun and not finished."""
    return (folder / STAGING / _JOURNAL).is_file()


def _apply(folder: Path) -> None:
    staging = folder / STAGING
    plan = json.loads((staging / _JOURNAL).read_bytes())
    new, seal = staging / _NEW, plan["seal"]
    if (new / seal).is_file():  # otherwise it is in its place: only the tidying is left
        remove_file(folder / seal)
        sync_folder(folder)
        for name in plan["remove"]:
            remove_file(folder / name)
            remove_empty_folders((folder / name).parent, folder)
        for name in plan["write"]:
            _move(new / name, folder / name)
        for touched in _folders(folder, plan["write"]):
            sync_folder(touched)
        _move(new / seal, folder / seal)
        sync_folder(folder)
    _discard(staging)


def _folders(top: Path, names: Iterable[str]) -> list[Path]:
    """The folders that hold files of these names, and those between them and the top."""
    found = {folder for name in names for folder in (top / name).parents if top in folder.parents}
    return sorted(found)


def _move(source: Path, target: Path) -> None:
    """Move a staged file into place, unless an earlier try has done so."""
    if source.is_file():
        make_folder(target.parent)
        source.replace(target)


def _discard(staging: Path) -> None:
    remove_file(staging / _JOURNAL)
    sync_folder(staging)
    shutil.rmtree(staging)
