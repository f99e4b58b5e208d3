"""Independent engines, imported when a check needs them."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable, Iterator
from types import ModuleType
from typing import Any

from armillary.verify.measured import Measured, Skipped

# What pip calls the engines that Python calls otherwise.
PACKAGES = {"pinocchio": "pin", "erfa": "pyerfa"}
INSTALL = "pip install 'armillary[check]'"


class EngineMissing(Exception):
    """An engine is not installed: its checks are skipped by name, and the rest still runs."""

    def __init__(self, engine: str, install: str = INSTALL) -> None:
        self.engine, self.install = engine, install
        super().__init__(f"{engine} is not installed; to run its checks: {install}")


def need(module: str) -> ModuleType:
    """Import an engine by its Python name, such as "pinocchio" or "scipy.spatial.transform".

    Raises:
        EngineMissing: if it is not installed here.
    """
    try:
        return importlib.import_module(module)
    except ImportError as problem:
        top = module.partition(".")[0]
        if problem.name is not None and problem.name.partition(".")[0] != top:
            raise  # the engine is there, and something else is broken
        package = PACKAGES.get(top)
        install = f"{INSTALL} (or pip install {package})" if package else INSTALL
        raise EngineMissing(top, install) from problem


def each(
    kernels: Any, *checks: Callable[[Any], Iterable[Measured]]
) -> Iterator[Measured | Skipped]:
    """Run several groups of checks, so that one missing engine does not stop the others.

    def checks(kernels):
        yield from each(kernels, by_rotations, by_pinocchio)
    """
    for check in checks:
        try:
            yield from check(kernels)
        except EngineMissing as missing:
            yield Skipped(check.__name__.replace("_", " "), missing.engine, str(missing))
