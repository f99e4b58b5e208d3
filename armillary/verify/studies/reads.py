"""What a part of a study reads: parameters and kernels, each logged when it is touched.

A part is run again only when something that it read is no longer what it was. A key names a thing:
"parameter plant.mass", "kernel sun.direction", "native sun.direction" (its compiled C).
"""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from armillary.store.files import digest_of
from armillary.targets.manifest import read_manifest
from armillary.verify.parameters import Parameters

PYTHON = Path("generated") / "python"
PRECISIONS = ("f32", "f64")
_RUNTIME = {
    "kernel": ("_runtime.py",),
    "native": ("_runtime.py", "_compiler.py", "_batch.py", "native.py"),
}


class Watched:
    """Kernels that tell which of them is touched."""

    def __init__(self, kernels: Any, touch: Callable[[str], None]) -> None:
        self._kernels, self._touch = kernels, touch

    def __getattr__(self, name: str) -> Any:
        found = getattr(self._kernels, name)
        if not name.startswith("__"):
            self._touch(name)
        return found

    def __dir__(self) -> list[str]:
        return dir(self._kernels)


class Surroundings:
    """What a study of a project can read, as it is at the moment.

    Args:
        package: name of the generated Python package.
        parameters: of the study; None where it has none.
    """

    def __init__(self, root: Path, package: str, parameters: Parameters | None) -> None:
        self._root, self._package, self.parameters = root, package, parameters
        self._kernels: dict[str, Mapping[str, str]] = {}
        self._native: dict[str, str] | None = None

    def state(self, key: str) -> str:
        """A digest of what a key names; empty where there is no such thing."""
        kind, _, name = key.partition(" ")
        if kind == "parameter":
            return _digest(self.parameters.state(name)) if self.parameters is not None else ""
        system, _, kernel = name.partition(".")
        if kind == "native":
            return self._compiled(system, kernel)
        if system not in self._kernels:
            self._kernels[system] = self._functions(system)
        found = self._kernels[system]
        return found.get(kernel, found.get("", ""))

    def are(self, reads: Mapping[str, str]) -> bool:
        """Whether all that was read is what it was."""
        return all(self.state(key) == then for key, then in reads.items())

    def _functions(self, system: str) -> Mapping[str, str]:
        """A digest for each function of a generated module; under "" one of the whole."""
        folder = self._root / PYTHON / self._package
        try:
            text = (folder / f"{system}.py").read_text("utf-8")
        except FileNotFoundError:
            return {}
        body = ast.parse(text).body
        parts = [n for n in body if isinstance(n, (ast.FunctionDef, ast.ClassDef))]
        # What stands between the functions, such as a table, may belong to each; the list of all
        # kernels, which the docstring and __all__ are, does not.
        rest = [ast.dump(node) for node in body[1:] if node not in parts and not _is_list(node)]
        common = "\n".join([self._runtime("kernel"), *rest])
        made = {node.name: _digest(common + _without_words(node)) for node in parts}
        return {**made, "": _digest(common + text)}

    def _compiled(self, system: str, kernel: str) -> str:
        """A digest of the C of a kernel; of all the system's where it has no file of its own."""
        if self._native is None:
            manifest = read_manifest(self._root / "generated")
            self._native = {} if manifest is None else manifest.files
        mine = [name for name in sorted(self._native) if Path(name).name.startswith(system)]
        files = {f"{system}_{kernel}_{precision}.c" for precision in PRECISIONS}
        own = [name for name in mine if Path(name).name in files] or mine
        if not own:
            return ""
        found = [f"{name} {digest_of(self._root / 'generated' / name)}" for name in own]
        return _digest("\n".join([self._runtime("native"), *found]))

    def _runtime(self, kind: str) -> str:
        folder = self._root / PYTHON / self._package
        return " ".join(str(digest_of(folder / name)) for name in _RUNTIME[kind])


def _without_words(node: ast.FunctionDef | ast.ClassDef) -> str:
    if ast.get_docstring(node, clean=False) is not None:
        node.body = node.body[1:]
    return ast.dump(node)


def _is_list(node: ast.stmt) -> bool:
    return isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__"


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]
