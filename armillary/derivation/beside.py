"""Runs a file of a system's folder, so that it can import the files beside it.

`from .almanac import declination` in `sun/derivation.py` means `sun/almanac.py`. While the file
runs, its folder is a package of a name of its own; afterwards Python forgets that package, so the
next run reads every file anew.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib import import_module
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, SourceFileLoader
from importlib.util import spec_from_file_location
from pathlib import Path
from types import CodeType, ModuleType

PREFIX = "_armillary_"


@dataclass(frozen=True)
class Ran:
    """A module, and the files it was read from: its own, and those beside that it imported."""

    module: ModuleType
    files: tuple[Path, ...]


def run(path: Path) -> Ran:
    """Run a file, as a module of a package made for its folder.

    Imports of files beside belong to the top of the file: later there is no package any more.
    """
    path = path.resolve()
    package = f"{PREFIX}{path.stem}_{re.sub(r'[^0-9A-Za-z_]', '_', path.parent.name)}"
    finder = _Finder(package, path.parent)
    folder = ModuleType(package)
    folder.__path__ = []
    sys.modules[package] = folder
    sys.meta_path.insert(0, finder)
    try:
        module = import_module(f"{package}.{path.stem}")
    finally:
        sys.meta_path.remove(finder)
        for name in [n for n in sys.modules if n == package or n.startswith(f"{package}.")]:
            del sys.modules[name]
    return Ran(module, tuple(sorted(finder.files)))


def files_of(path: Path) -> list[Path]:
    """A file and those beside that it imports, directly or not, by their text; it is not run."""
    found: dict[Path, None] = {}
    open_ = [path]
    while open_:
        one = open_.pop()
        if one not in found and one.is_file():
            found[one] = None
            open_ += [path.parent / f"{name}.py" for name in _imported(one)]
    return sorted(found)


def _imported(path: Path) -> Iterator[str]:
    """Names of the modules that a file may import from beside it."""
    try:
        tree = ast.parse(path.read_bytes())
    except (SyntaxError, ValueError):
        return
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.level == 1:
            yield from [node.module] if node.module else [alias.name for alias in node.names]


class _Finder(MetaPathFinder):
    """Finds the modules of one package in one folder, and remembers their files."""

    def __init__(self, package: str, folder: Path) -> None:
        self._package, self._folder = package, folder
        self.files: set[Path] = set()

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        package, _, name = fullname.rpartition(".")
        if package != self._package:
            return None
        file = self._folder / f"{name}.py"
        if not file.is_file():
            raise ModuleNotFoundError(f"there is no {name}.py in {self._folder}", name=fullname)
        self.files.add(file)
        return spec_from_file_location(fullname, file, loader=_Text(fullname, str(file)))


class _Text(SourceFileLoader):
    """Compiles the text each time: kept bytecode does not see two edits within one second."""

    def get_code(self, fullname: str) -> CodeType:
        return self.source_to_code(self.get_data(self.path), self.path)
