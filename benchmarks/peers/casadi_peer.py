"""CasADi: scalar expressions (SX), forward or reverse differentiation as it sees fit, `cse`."""

from __future__ import annotations

import importlib
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from benchmarks.matrices import Matrix, Recipe, Vector
from benchmarks.peers import ENTRY, Generated, Peer
from benchmarks.recipes import Kernel

PEER = Peer("CasADi", package="casadi", module="casadi")
OPTIONS = ("SX, cse",)


class CasadiOps:
    """The recipe's operations in CasADi."""

    def __init__(self, ca: Any) -> None:
        """Borrow the functions of the imported module."""
        self.sin, self.cos, self.sqrt, self.atan2 = ca.sin, ca.cos, ca.sqrt, ca.atan2
        self._casadi = ca

    def named(self, values: Vector, /) -> Vector:
        """As they are: an expression is not written out where it is used."""
        return values

    def jacobian(self, values: Vector, variables: Vector, /) -> Matrix:
        """All derivatives in one sweep, so that CasADi may choose its direction."""
        ca = self._casadi
        dense = ca.densify(ca.jacobian(ca.vertcat(*values), ca.vertcat(*variables)))
        return [[dense[i, j] for j in range(len(variables))] for i in range(len(values))]


def generate(kernel: Kernel, recipe: Recipe) -> Iterator[Generated]:
    """SX with common subexpressions eliminated."""
    ca: Any = importlib.import_module("casadi")
    inputs = [ca.SX.sym(name) for name in kernel.inputs]
    values = ca.cse(ca.densify(ca.vertcat(*recipe(CasadiOps(ca), list(inputs)))))
    function = ca.Function(ENTRY, [ca.vertcat(*inputs)], [values])
    with tempfile.TemporaryDirectory(prefix="casadi-") as folder:
        code = ca.CodeGenerator(f"{ENTRY}.c")
        code.add(function)
        code.generate(f"{folder}/")
        source = (Path(folder) / f"{ENTRY}.c").read_text()
    call = f"const double *arg[] = {{in}}; double *res[] = {{out}}; {ENTRY}(arg, res, 0, 0, 0);"
    yield Generated(*OPTIONS, source, call)
