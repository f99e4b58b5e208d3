"""The papers of a project: `derivations/papers/references.toml`."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path

from armillary.site.errors import SiteError

TABLE = Path("derivations") / "papers" / "references.toml"
_WANTED = ("short", "authors", "title", "published")


@dataclass(frozen=True)
class Reference:
    """One paper as the pages cite it."""

    key: str
    short: str
    authors: str
    title: str
    published: str


def read_references(root: Path) -> dict[str, Reference]:
    """Every paper of a project by its key; none where there is no table.

    Raises:
        SiteError: when the table cannot be read or an entry is not whole.
    """
    path = root / TABLE
    if not path.is_file():
        return {}
    try:
        content = tomllib.loads(path.read_text("utf-8"))
    except tomllib.TOMLDecodeError as problem:
        raise SiteError(f"{path}: {problem}", "correct the file; it must be TOML") from None
    for key, entry in content.items():
        missing = [name for name in _WANTED if not isinstance(entry.get(name), str)]
        if missing:
            raise SiteError(
                f"{path}: [{key}] has no {', '.join(missing)}", f"write {missing[0]} = '...' there"
            )
    return {
        key: Reference(key, *(entry[name] for name in _WANTED)) for key, entry in content.items()
    }


def reference_of(references: dict[str, Reference], key: str, system: str) -> Reference:
    """The paper that a derivation names.

    Raises:
        SiteError: when the table does not have it.
    """
    if key not in references:
        raise SiteError(
            f"{system} names the paper {key!r}, which {TABLE.as_posix()} does not have",
            f"add a table [{key}] with {', '.join(_WANTED)}",
        )
    return references[key]
