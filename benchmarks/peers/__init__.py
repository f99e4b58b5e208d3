"""The other code generators: each turns a kernel's recipe into C or C++.

A peer is a module with `PEER`, which tells what it is called and how it is installed, and
`generate(kernel, recipe)`. The tool itself is imported only inside functions, so a peer that is
not installed can still be named.
"""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata
from typing import Protocol, cast

from benchmarks.matrices import Recipe
from benchmarks.recipes import Kernel

ENTRY = "bench_kernel"


@dataclass(frozen=True)
class Generated:
    """Code of one kernel, and the statement that calls it with `in` and `out`."""

    options: str
    source: str
    call: str


@dataclass(frozen=True)
class Peer:
    """A tool: its name in the table, the package that provides it, the module that it imports."""

    name: str
    package: str
    module: str

    @property
    def installed(self) -> bool:
        """Whether the tool can be imported here."""
        return importlib.util.find_spec(self.module) is not None

    @property
    def version(self) -> str:
        """Version of the installed package."""
        return metadata.version(self.package)

    @property
    def remedy(self) -> str:
        """How to get a tool that is missing."""
        return f"run `make tools` or `pip install {self.package}` (group `benchmark`)"


class PeerModule(Protocol):
    """What a module in this package offers."""

    __name__: str
    PEER: Peer
    OPTIONS: tuple[str, ...]  # what `generate` yields for each recipe

    def generate(self, kernel: Kernel, recipe: Recipe) -> Iterator[Generated]:
        """One variant after another."""


def peers() -> list[PeerModule]:
    """Every peer, installed or not, in the order of the table's legend."""
    names = ("sympy_peer", "casadi_peer", "wrenfold_peer", "symforce_peer")
    return [cast(PeerModule, importlib.import_module(f"{__name__}.{name}")) for name in names]


def scalar_call(entry: str, n_in: int, outputs: list[str]) -> str:
    """Call a function that takes scalars: the inputs by value, then the outputs as written."""
    return f"{entry}({', '.join([*(f'in[{i}]' for i in range(n_in)), *outputs])});"
