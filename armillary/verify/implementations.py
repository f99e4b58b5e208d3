"""The generated kernels as they are called: each target behind one small interface."""

from __future__ import annotations

import importlib
import os
import shutil
import sys
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from armillary.verify.engines import EngineMissing, need

Inputs = Mapping[str, NDArray[Any]]
Results = dict[str, NDArray[Any]]


@dataclass(frozen=True)
class Implementation:
    """One target of one system.

    Attributes:
        name: "numpy f64", "c f32", ...; the key in the tolerances.
        dtype: what it computes in; inputs are rounded to it first.
        call: kernel name and arrays of that dtype to results by name, `status` among them.
        like: the target whose tolerances it is held to, where that is another.
        only: the kernels that it has; None for all.
    """

    name: str
    dtype: type[np.floating[Any]]
    call: Callable[[str, Inputs], Results]
    like: str = ""
    only: frozenset[str] | None = None

    @property
    def key(self) -> str:
        """Its place in the tolerances."""
        return self.like or self.name

    def has(self, kernel: str) -> bool:
        """Whether it has a kernel."""
        return self.only is None or kernel in self.only

    @property
    def epsilon(self) -> float:
        """Spacing of floats at 1."""
        return float(np.finfo(self.dtype).eps)


def generated_module(folder: Path, package: str, system: str) -> ModuleType:
    """The generated Python module of a system, from `folder` and from nowhere else.

    Raises:
        ModuleNotFoundError: if it was not generated yet.
    """
    with _importing(folder):
        return importlib.import_module(f"{package}.{system}")


def forget(package: str) -> None:
    """Drop a generated package that was imported before, from elsewhere or from older files."""
    for name in [n for n in sys.modules if n == package or n.startswith(f"{package}.")]:
        del sys.modules[name]


@contextmanager
def _importing(folder: Path) -> Iterator[None]:
    """Import from `folder` first, and leave no bytecode there: it holds generated files only."""
    keep, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    sys.path.insert(0, str(folder))
    try:
        importlib.invalidate_caches()
        yield
    finally:
        sys.path.remove(str(folder))
        sys.dont_write_bytecode = keep


def python_implementations(module: ModuleType) -> list[tuple[str, Callable[[], Implementation]]]:
    """Makers of every way a Python module is run.

    One whose library is absent raises `EngineMissing` when made.
    """

    def maker(name: str, dtype: Any, library: str | None) -> Callable[[], Implementation]:
        return lambda: _python(module, name, dtype, library)

    ways = (
        ("numpy f64", np.float64, None),
        ("numpy f32", np.float32, None),
        ("array-api-strict f64", np.float64, "array_api_strict"),
        ("dask f64", np.float64, "dask.array"),
    )
    return [(name, maker(name, dtype, library)) for name, dtype, library in ways]


def _python(module: ModuleType, name: str, dtype: Any, library: str | None) -> Implementation:
    convert = np.asarray if library is None else _from_numpy(need(library))

    def call(kernel: str, inputs: Inputs) -> Results:
        given = {n: convert(a) for n, a in inputs.items()}
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            answer = getattr(module, kernel)(**given)
            return {field: np.asarray(getattr(answer, field)) for field in answer._fields}

    return Implementation(name, dtype, call)


def _from_numpy(library: Any) -> Callable[[NDArray[Any]], Any]:
    if hasattr(library, "from_array"):
        # Several chunks: a kernel must not depend on seeing the whole batch.
        return lambda a: library.from_array(a, chunks=(max(1, (len(a) + 1) // 2), *a.shape[1:]))
    return lambda a: library.asarray(a)


def native_implementations(
    folder: Path, package: str, system: str
) -> list[tuple[str, Callable[[], Implementation]]]:
    """Makers of the compiled C, in the precisions of the project.

    Without a compiler they raise `EngineMissing`; C that does not compile is an error.
    """
    native = generated_module(folder, package, "native")

    def maker(name: str, dtype: Any) -> Callable[[], Implementation]:
        return lambda: _native(folder, native, system, name, dtype)

    dtypes = {"f64": np.float64, "f32": np.float32}
    found = [p for p in dtypes if p in native.PRECISIONS]
    return [(f"c {p}", maker(f"c {p}", dtypes[p])) for p in found]


def _native(folder: Path, native: ModuleType, system: str, name: str, dtype: Any) -> Implementation:
    module = native_system(folder, native, system)

    def call(kernel: str, inputs: Inputs) -> Results:
        answer = getattr(module, kernel)(**inputs)
        return {field: np.asarray(getattr(answer, field)) for field in answer._fields}

    return Implementation(name, dtype, call)


def native_system(folder: Path, native: ModuleType, system: str) -> Any:
    """The compiled kernels of one system.

    Raises:
        EngineMissing: if there is no compiler.
    """
    need_compiler()
    with _importing(folder):
        return getattr(native, system)


def need_compiler() -> None:
    """See that there is something to compile the C with.

    Raises:
        EngineMissing: if there is not.
    """
    if not any(shutil.which(c) for c in (os.environ.get("CC", "cc").split()[0], "gcc", "clang")):
        raise EngineMissing("a C compiler", "install gcc or clang, or set CC")
