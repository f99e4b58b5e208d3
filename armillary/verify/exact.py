"""Fifty-digit evaluation: of the program, and of the text-book expression through SymPy."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import product
from typing import Any

import mpmath
import sympy

from armillary.algebra.explicit import Explicit, Node, symbol
from armillary.algebra.index import Index
from armillary.algebra.indexed import indices
from armillary.derivation.quantity import AnyQuantity, Constant
from armillary.derivation.symbols import Leaf, leaves
from armillary.program.arithmetic import DIGITS, Dual, Duals, Reals
from armillary.program.evaluate import Answer, evaluate
from armillary.program.program import Program
from armillary.verify.turning import Iterations, replaced, turnings

Row = Mapping[str, Any]


def numbers(reals: Reals, row: Row) -> dict[str, Any]:
    """Plain inputs as exact 50-digit numbers."""
    return {
        name: [reals.number(c) for c in value] if isinstance(value, list) else reals.number(value)
        for name, value in row.items()
    }


def run(program: Program, row: Row, reals: Reals) -> Answer:
    """The program at one point, without its guards."""
    return evaluate(program, numbers(reals, row), reals)


def directional_derivative(
    program: Program, inputs: Row, direction: Row, reals: Reals | None = None
) -> Answer:
    """Values and slopes of a program along a direction, by dual numbers.

    Args:
        inputs: every input and parameter, a float or a flat list of floats.
        direction: how fast each of them moves; what is left out is held.

    Returns:
        An answer whose results are `Dual`s, or flat row-major lists of them.
    """
    reals = reals or Reals()
    still = reals.number(0)
    duals: dict[str, Any] = {}
    for name, value in numbers(reals, inputs).items():
        speed = direction.get(name)
        if isinstance(value, list):
            speeds = [still] * len(value) if speed is None else [reals.number(c) for c in speed]
            duals[name] = [Dual(v, d) for v, d in zip(value, speeds, strict=True)]
        else:
            duals[name] = Dual(value, still if speed is None else reals.number(speed))
    return evaluate(program, duals, Duals(reals))


class Function:
    """SymPy expressions as a function at 50 digits.

    Args:
        entries: the expressions, constants of the derivation included.
        symbols: the symbols they stand on, as `leaves` finds them.
        iterations: what the results of iterations among the entries stand for, as the explicit
            form collects them.
    """

    def __init__(
        self,
        entries: Sequence[sympy.Expr],
        symbols: Sequence[Leaf],
        iterations: Iterations | None = None,
    ) -> None:
        exact = {symbol(c.name): c.value for c in symbols if isinstance(c, Constant)}
        self.entries = [replaced(e, exact) for e in entries]
        self.quantities = [q for q in symbols if isinstance(q, AnyQuantity)]
        self._names = [symbol(part) for q in self.quantities for part in q.parts]
        self._turning = turnings(iterations or {}, self._names, exact)
        self._function: Callable[..., Any] | None = None

    def __call__(self, row: Row) -> list[Any]:
        """Values of the entries at one point (floats, flat lists of floats)."""
        if self._function is None:
            names = [*self._names, *(name for t in self._turning for name in t.results)]
            # Shared parts first: lambdify walks what it is given as a tree, and counts to sort it.
            shared, reduced = sympy.cse(self.entries, order="none", list=False)
            self._function = sympy.lambdify(
                names, list(reduced), modules="mpmath", cse=lambda _: (shared, list(reduced))
            )
        with mpmath.workdps(DIGITS + 10):
            given = [mpmath.mpf(x) for q in self.quantities for x in flat(row[q.name])]
            for turning in self._turning:
                given += turning(given)
            return list(self._function(*given))


def text_book(value: Node, order: Sequence[Index] | None = None) -> Function:
    """The explicit SymPy form of a value, row-major; every name in it opened.

    Args:
        order: the indices that the value is left open in, outermost first; by name if not given.
    """
    explicit = Explicit()
    entries = [e for place in everywhere(explicit, value, order) for e in entries_of(place(value))]
    return Function(entries, leaves(value), explicit.iterations)


def everywhere(
    explicit: Explicit, value: object, order: Sequence[Index] | None = None
) -> Iterator[Explicit]:
    """The translation at every part of the indices that a value is left open in, row-major."""
    if order is None:
        order = sorted(indices(value), key=str)
    for places in product(*(range(i.size) for i in order)):
        at_part = explicit
        for index, place in zip(order, places, strict=True):
            at_part = at_part.moved(index, place)
        yield at_part


def entries_of(form: sympy.Basic) -> list[sympy.Expr]:
    """The scalars of a SymPy form, row-major."""
    return list(form) if isinstance(form, sympy.MatrixBase) else [form]


def flat(value: Any) -> list[Any]:
    """A scalar or a flat list, as a list."""
    return value if isinstance(value, list) else [value]


def worst(found: Sequence[Any], wanted: Sequence[Any]) -> float:
    """Largest difference, relative to the largest entry of `wanted` where that is above 1.

    NaN where any entry is.
    """
    with mpmath.workdps(DIGITS + 10):
        scale = largest([1, *wanted])
        pairs = zip(found, wanted, strict=True)
        return float(largest([mpmath.mpf(f) - mpmath.mpf(w) for f, w in pairs]) / scale)


def largest(values: Sequence[Any]) -> Any:
    """The largest magnitude; NaN where any value is."""
    found = [abs(mpmath.mpf(v)) for v in values]
    return next((v for v in found if mpmath.isnan(v)), max(found, default=mpmath.mpf(0)))
