"""wrenfold: as it comes (3 factorisation passes), and with the 8 that do best here."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from typing import Any

from benchmarks.matrices import Matrix, Recipe, Scalar, Vector
from benchmarks.peers import ENTRY, Generated, Peer, scalar_call
from benchmarks.recipes import Kernel

PEER = Peer("wrenfold", package="wrenfold", module="wrenfold")
OPTIONS = ("default", "8 factorisation passes")


class WrenfoldOps:
    """The recipe's operations in wrenfold."""

    def __init__(self, sym: Any) -> None:
        """Borrow the functions of the imported module."""
        self.sin, self.cos, self.sqrt, self.atan2 = sym.sin, sym.cos, sym.sqrt, sym.atan2
        self._expression = sym.Expr

    def named(self, values: Vector, /) -> Vector:
        """As they are: an expression is not written out where it is used."""
        return values

    def jacobian(self, values: Vector, variables: Vector, /) -> Matrix:
        """Entry by entry with `diff`."""
        return [[self._diff(y, x) for x in variables] for y in values]

    def _diff(self, value: Scalar, variable: Scalar) -> Scalar:
        """Numbers that a recipe writes, such as 0, are not expressions yet."""
        return value.diff(variable) if isinstance(value, self._expression) else 0


def generate(kernel: Kernel, recipe: Recipe) -> Iterator[Generated]:
    """One source per number of factorisation passes."""
    sym: Any = importlib.import_module("wrenfold.sym")
    cg: Any = importlib.import_module("wrenfold.code_generation")
    type_info: Any = importlib.import_module("wrenfold.type_info")
    real = type_info.ScalarType(type_info.NumericType.Float)
    function = cg.FunctionDescription(ENTRY)
    inputs = [function.add_input_argument(name, real) for name in kernel.inputs]
    for i, value in enumerate(recipe(WrenfoldOps(sym), list(inputs))):
        function.add_output_argument(f"out_{i}", False, value)
    call = scalar_call(ENTRY, len(inputs), [f"out[{i}]" for i in range(kernel.n_out)])
    for options, passes in zip(OPTIONS, (None, 8), strict=True):
        parameters = cg.OptimizationParams()
        if passes is not None:
            parameters.factorization_passes = passes
        code = cg.transpile(function, optimization_params=parameters)
        yield Generated(options, cg.CppGenerator().generate(code), call)
