"""What parts of studies found, kept in `build/studies/<system>/<part>/`.

A file for each set of things that a part has read, so that other parameters do not push out the
default ones. Its first line says what it was made from, its second what was found.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from pathlib import Path
from typing import Any, get_args

from armillary.store.files import remove_file, replace_durably
from armillary.verify import plots, study

FOLDER = Path("build") / "studies"
MOST = 24  # files of one part; beyond, the one not used for longest goes
_KINDS = {
    kind.__name__: kind
    for kind in (*vars(plots).values(), *vars(study).values())
    if isinstance(kind, type) and is_dataclass(kind)
}
_YIELDED = (*get_args(study.Item), study.Result)
_ITEMS = tuple(kind for kind in _YIELDED if kind is not study.Absent)


@dataclass(frozen=True)
class Kept:
    """What a part found.

    Attributes:
        key: digest of its files, of the versions beneath them, and of the results it was given.
        reads: digests of what it touched, by the names that `reads.py` gives.
        seconds: how long it took.
        items: in the order of the page; its results among them.
    """

    key: str
    reads: Mapping[str, str]
    seconds: float
    items: tuple[Any, ...]

    @property
    def file(self) -> str:
        """Name of the file that it is kept in."""
        made_from = json.dumps([self.key, dict(sorted(self.reads.items()))])
        return hashlib.sha256(made_from.encode()).hexdigest()[:16] + ".json"

    @property
    def results(self) -> dict[str, Any]:
        """Its results by name."""
        return {one.name: one.value for one in self.items if isinstance(one, study.Result)}


def find(folder: Path, key: str, are: Callable[[Mapping[str, str]], bool]) -> Kept | None:
    """What is kept of a part in its folder; None if it must run.

    Args:
        are: tells whether digests of what was read are those of now.
    """
    for path, head in _heads(folder):
        if head["key"] == key and are(head["reads"]):
            found = read(path)
            if found is not None:
                os.utime(path)
                return found
    return None


def keep(folder: Path, kept: Kept) -> None:
    """Keep what a part found; the caller holds the part's lock."""
    head = {"key": kept.key, "reads": dict(sorted(kept.reads.items())), "seconds": kept.seconds}
    text = f"{json.dumps(head)}\n{json.dumps([_plain(item) for item in kept.items])}\n"
    replace_durably(folder / kept.file, text.encode())
    for path in _newest_first(folder)[MOST:]:
        remove_file(path)


def last_seconds(folder: Path) -> float | None:
    """How long a part took when it last ran; None if it is not known."""
    for _, head in _heads(folder):
        return float(head["seconds"])
    return None


def _newest_first(folder: Path) -> list[Path]:
    def time(path: Path) -> int:
        try:
            return path.stat().st_mtime_ns
        except FileNotFoundError:  # gone meanwhile
            return 0

    return sorted(folder.glob("*.json"), key=lambda path: (-time(path), path.name))


def _heads(folder: Path) -> Iterator[tuple[Path, dict[str, Any]]]:
    """The files of a part that can be read, with their first lines."""
    for path in _newest_first(folder):
        try:
            with path.open(encoding="utf-8") as file:
                head = json.loads(file.readline())
            if head.keys() >= {"key", "reads", "seconds"}:
                yield path, head
        except (OSError, ValueError, AttributeError):
            continue


def read(path: Path) -> Kept | None:
    """What is kept in a file; None when it cannot be read."""
    try:
        first, second = path.read_text("utf-8").splitlines()
        return Kept(**json.loads(first), items=tuple(map(_made, json.loads(second))))
    except (OSError, ValueError, KeyError, TypeError):
        return None


# -- as JSON --------------------------------------------------------------------------------------


def checked(found: Iterable[object]) -> list[Any]:
    """What a part yields.

    Raises:
        PlotError: for anything that is no item.
    """
    items = []
    for item in found:
        if not isinstance(item, _ITEMS):
            raise plots.PlotError(
                f"the study yields {type(item).__name__}",
                f"yield {', '.join(sorted(kind.__name__ for kind in _ITEMS))}",
            )
        items.append(item)
    return items


def _plain(value: Any) -> Any:
    if isinstance(value, study.Result):
        return {"is": "Result", "name": value.name, "value": {"as": value.value}}
    if is_dataclass(value):
        kept = {f.name: _plain(getattr(value, f.name)) for f in fields(value)}
        return {"is": type(value).__name__, **kept}
    return [_plain(one) for one in value] if isinstance(value, (tuple, list)) else value


def _made(value: Any) -> Any:
    if isinstance(value, dict) and "as" in value:
        return value["as"]
    if isinstance(value, dict):
        kind = _KINDS[value["is"]]
        return kind(**{name: _made(one) for name, one in value.items() if name != "is"})
    return tuple(_made(one) for one in value) if isinstance(value, list) else value
