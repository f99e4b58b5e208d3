"""Where a project is and what its `[tool.armillary]` says."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from armillary.derivation.folders import names, paper_names
from armillary.project.errors import ProjectError

PRECISIONS = ("f32", "f64")
SETTINGS = ("kernels", "c_folder", "c_prefix", "precisions", "version")
_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")
_VERSION = re.compile(r"\d+\.\d+\.\d+\Z")


@dataclass(frozen=True)
class Project:
    """A folder whose pyproject.toml has a `[tool.armillary]`.

    Attributes:
        root: the folder.
        kernels: name of the generated Python package.
        c_folder: folder of the generated C below `generated/c/src`, as an `#include` names it.
        c_prefix: put before every C name.
        precisions: of the C kernels.
        version: of the generated code.
    """

    root: Path
    kernels: str
    c_folder: str
    c_prefix: str
    precisions: tuple[str, ...]
    version: str

    @property
    def derivations(self) -> Path:
        return self.root / "derivations"

    @property
    def generated(self) -> Path:
        return self.root / "generated"

    @property
    def build(self) -> Path:
        return self.root / "build"

    def systems(self) -> list[str]:
        """Every system of the project, sorted."""
        return names(self.derivations)

    def papers(self) -> list[str]:
        """Every paper of the project, sorted."""
        return paper_names(self.derivations)

    def chosen(self, names: tuple[str, ...]) -> list[str]:
        """The named systems, or all of them.

        Raises:
            ProjectError: for a name that no system has.
        """
        return _chosen("system", names, self.systems(), "`armillary new {}` adds one")

    def chosen_papers(self, names: tuple[str, ...]) -> list[str]:
        """The named papers, or all of them.

        Raises:
            ProjectError: for a name that no paper has.
        """
        return _chosen("paper", names, self.papers(), "write derivations/papers/{}.py")


def _chosen(what: str, names: tuple[str, ...], known: list[str], first: str) -> list[str]:
    """Those of the known that are named, or all; `first` tells how to make the first one."""
    for name in names:
        if name not in known:
            mend = f"choose from {', '.join(known)}" if known else first.format(name)
            raise ProjectError(f"there is no {what} {name!r}", mend)
    return [name for name in known if not names or name in names]


def find_project(start: Path) -> Project:
    """The project that a folder belongs to.

    Raises:
        ProjectError: when there is none, or its settings are wrong.
    """
    start = start.resolve()
    for folder in (start, *start.parents):
        path = folder / "pyproject.toml"
        if path.is_file():
            content = _read(path)
            settings = content.get("tool", {}).get("armillary")
            if settings is not None:
                return _project(folder, settings, content.get("project", {}))
    raise ProjectError(
        f"no Armillary project in {start} or above it: no pyproject.toml with [tool.armillary]",
        "change into the project's folder, or make one with `armillary init` in an empty folder",
    )


def _read(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(path.read_text("utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as problem:
        raise ProjectError(f"{path}: {problem}", "correct the file; it must be TOML") from None


def _project(root: Path, settings: Mapping[str, Any], package: Mapping[str, Any]) -> Project:
    where = f"{root / 'pyproject.toml'}, [tool.armillary]"
    for key in settings:
        if key not in SETTINGS:
            raise ProjectError(f"{where}: unknown {key!r}", f"it knows {', '.join(SETTINGS)}")
    kernels = settings.get("kernels")
    if kernels is None:
        raise ProjectError(
            f"{where} does not name the kernel package", 'add kernels = "my_kernels"'
        )
    version: object = settings.get("version", package.get("version", ""))
    if not isinstance(version, str) or not _VERSION.match(version):
        raise ProjectError(f"{where}: version {version!r}", 'write version = "0.1.0"')
    return Project(
        root,
        _name(where, "kernels", kernels),
        _name(where, "c_folder", settings.get("c_folder", kernels)),
        _name(where, "c_prefix", settings.get("c_prefix", ""), empty=True),
        _precisions(where, settings.get("precisions", list(PRECISIONS))),
        version,
    )


def _name(where: str, key: str, value: object, empty: bool = False) -> str:
    if isinstance(value, str) and (_IDENTIFIER.match(value) or (empty and not value)):
        return value
    raise ProjectError(
        f"{where}: {key} = {value!r} is no name",
        "use letters, digits and underscores, beginning with a letter",
    )


def _precisions(where: str, value: object) -> tuple[str, ...]:
    if isinstance(value, list) and value and set(value) <= set(PRECISIONS):
        return tuple(p for p in PRECISIONS if p in value)
    raise ProjectError(
        f"{where}: precisions = {value!r}", 'write precisions = ["f32", "f64"], or one of the two'
    )
