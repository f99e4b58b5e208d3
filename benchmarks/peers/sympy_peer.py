"""SymPy: `diff`, `cse` with and without its basic optimisations, C99 printer."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator
from typing import Any

from benchmarks.peers import ENTRY, Generated, Peer
from benchmarks.recipes import Kernel, Matrix, Recipe, Scalar, Vector

PEER = Peer("SymPy", package="sympy", module="sympy")


class SymPyOps:
    """The recipe's operations in SymPy."""

    def __init__(self, sympy: Any) -> None:
        """Borrow the functions of the imported module."""
        self.sin, self.cos, self.sqrt, self.atan2 = sympy.sin, sympy.cos, sympy.sqrt, sympy.atan2
        self._sympify = sympy.sympify

    def jacobian(self, values: Vector, variables: Vector, /) -> Matrix:
        """Entry by entry with `diff`."""
        return [[self._sympify(y).diff(x) for x in variables] for y in values]


def generate(kernel: Kernel, recipe: Recipe) -> Iterator[Generated]:
    """One source per setting of `cse`."""
    sympy: Any = importlib.import_module("sympy")
    inputs = [sympy.Symbol(name, real=True) for name in kernel.inputs]
    values = [sympy.sympify(y) for y in recipe(SymPyOps(sympy), list(inputs))]
    for options, optimizations in (("cse", None), ("cse, basic optimisations", "basic")):
        names = sympy.numbered_symbols("t", real=True)
        shared, reduced = sympy.cse(values, symbols=names, optimizations=optimizations)
        source = _function(sympy.ccode, inputs, shared, reduced)
        yield Generated(options, source, f"{ENTRY}(in, out);")


def _function(
    ccode: Callable[[Scalar], str],
    inputs: Vector,
    shared: list[tuple[Scalar, Scalar]],
    outputs: Vector,
) -> str:
    lines = [f"  const double {x} = in[{i}];" for i, x in enumerate(inputs)]
    lines += [f"  const double {x} = {ccode(y)};" for x, y in shared]
    lines += [f"  out[{i}] = {ccode(y)};" for i, y in enumerate(outputs)]
    return "\n".join([f"void {ENTRY}(const double *in, double *out)", "{", *lines, "}"])
