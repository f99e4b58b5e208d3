"""SymPy: `diff`, `cse` with and without its basic optimisations, C99 printer.

Where a recipe names a value, it becomes a symbol of its own, as SymPyBotics does with every
intermediate of a recursion; `cse` then works on the right-hand sides.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator
from typing import Any

from benchmarks.matrices import Matrix, Recipe, Scalar, Vector
from benchmarks.peers import ENTRY, Generated, Peer
from benchmarks.recipes import Kernel

PEER = Peer("SymPy", package="sympy", module="sympy")

OPTIONS = ("cse", "cse, basic optimisations")

Lines = list[tuple[Scalar, Scalar]]


class SymPyOps:
    """The recipe's operations in SymPy."""

    def __init__(self, sympy: Any) -> None:
        """Borrow the functions of the imported module."""
        self.sin, self.cos, self.sqrt, self.atan2 = sympy.sin, sympy.cos, sympy.sqrt, sympy.atan2
        self._sympy = sympy
        self._names: dict[Scalar, Scalar] = {}

    @property
    def steps(self) -> Lines:
        """What was named, in the order named."""
        return [(name, value) for value, name in self._names.items()]

    def jacobian(self, values: Vector, variables: Vector, /) -> Matrix:
        """Entry by entry with `diff`; what was named counts as constant."""
        return [[self._sympy.sympify(y).diff(x) for x in variables] for y in values]

    def named(self, values: Vector, /) -> Vector:
        """A symbol for each value that takes an operation; the same for the same value."""
        return [self._named(self._sympy.sympify(value)) for value in values]

    def _named(self, value: Scalar) -> Scalar:
        if value.is_Atom or (-value).is_Atom:
            return value
        if value not in self._names:
            self._names[value] = self._sympy.Symbol(f"step{len(self._names)}", real=True)
        return self._names[value]


def generate(kernel: Kernel, recipe: Recipe) -> Iterator[Generated]:
    """One source per setting of `cse`."""
    sympy: Any = importlib.import_module("sympy")
    inputs = [sympy.Symbol(name, real=True) for name in kernel.inputs]
    ops = SymPyOps(sympy)
    values = [sympy.sympify(y) for y in recipe(ops, list(inputs))]
    steps = ops.steps
    for options, optimizations in zip(OPTIONS, (None, "basic"), strict=True):
        names = sympy.numbered_symbols("t", real=True)
        asked = [*(value for _, value in steps), *values]
        shared, reduced = sympy.cse(asked, symbols=names, optimizations=optimizations)
        stepped = [(name, value) for (name, _), value in zip(steps, reduced, strict=False)]
        outputs = reduced[len(steps) :]
        source = _function(sympy.ccode, inputs, _in_order([*shared, *stepped], outputs), outputs)
        yield Generated(options, source, f"{ENTRY}(in, out);")


def _in_order(lines: Lines, outputs: Vector) -> Lines:
    """The lines that the outputs need, each after those that it needs."""
    meaning, ordered = dict(lines), {}
    pending = [(symbol, False) for value in reversed(outputs) for symbol in _symbols(value)]
    while pending:
        symbol, ready = pending.pop()
        if symbol not in meaning or symbol in ordered:
            continue
        if ready:
            ordered[symbol] = meaning[symbol]
            continue
        pending.append((symbol, True))
        pending += [(below, False) for below in _symbols(meaning[symbol])]
    return list(ordered.items())


def _symbols(value: Scalar) -> list[Scalar]:
    """Free symbols, in an order that no hash decides."""
    return sorted(value.free_symbols, key=str)


def _function(ccode: Callable[[Scalar], str], inputs: Vector, lines: Lines, outputs: Vector) -> str:
    body = [f"  const double {x} = in[{i}];" for i, x in enumerate(inputs)]
    body += [f"  const double {x} = {ccode(y)};" for x, y in lines]
    body += [f"  out[{i}] = {ccode(y)};" for i, y in enumerate(outputs)]
    return "\n".join([f"void {ENTRY}(const double *in, double *out)", "{", *body, "}"])
