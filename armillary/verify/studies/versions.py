"""Versions of the packages that files of a study stand on."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterable, Iterator
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from armillary.verify.engines import PACKAGES

_ALWAYS = frozenset({"numpy"})  # the kernels run on it
_OWN = frozenset({"armillary"})


def versions_of(files: Iterable[Path]) -> list[str]:
    """Name and version of each package that files import or `need`, sorted by name.

    One that is not installed is left out: when it is, that is a change.
    """
    found = set(_ALWAYS)
    for file in files:
        found.update(_named(file))
    made = []
    for name in sorted(found - _OWN - sys.stdlib_module_names):
        try:
            made.append(f"{name} {version(PACKAGES.get(name, name))}")
        except PackageNotFoundError:
            continue
    return made


def _named(file: Path) -> Iterator[str]:
    """Top-level packages that a file may import."""
    try:
        tree = ast.parse(file.read_bytes())
    except (SyntaxError, ValueError):
        return
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and not node.level and node.module:
            yield node.module.partition(".")[0]
        elif isinstance(node, ast.Import):
            yield from (alias.name.partition(".")[0] for alias in node.names)
        elif isinstance(node, ast.Call) and _name(node.func) == "need":
            for one in node.args:
                if isinstance(one, ast.Constant) and isinstance(one.value, str):
                    yield one.value.partition(".")[0]


def _name(function: ast.expr) -> str:
    return function.id if isinstance(function, ast.Name) else ""
