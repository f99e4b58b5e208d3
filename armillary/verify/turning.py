"""Iterations in the text-book form: turned at 50 digits, apart from the program."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import mpmath
import sympy

from armillary.algebra.explicit import Explicit, symbol
from armillary.algebra.iteration import Iteration

Iterations = Mapping[str, tuple[Iteration, Explicit]]
Exact = Mapping[sympy.Symbol, sympy.Expr]


class Turning:
    """One iteration as a function of what is known before it.

    Attributes:
        results: the symbols that stand for its results.
    """

    def __init__(
        self, key: str, given: Iteration, at: Explicit, known: Sequence[sympy.Symbol], exact: Exact
    ) -> None:
        unknowns = [symbol(u.name) for u in given.unknowns]
        self.results = [symbol(f"{key}_{u.name}") for u in given.unknowns]
        self.turns = given.turns.size
        start = [replaced(at(e), exact) for e in given.start]
        following = [replaced(at(e), exact) for e in given.following]
        self._start = sympy.lambdify(known, start, modules="mpmath", cse=True)
        self._next = sympy.lambdify([*known, *unknowns], following, modules="mpmath", cse=True)

    def __call__(self, known: Sequence[Any]) -> list[Any]:
        """The unknowns after the last turn."""
        values = _exact(self._start(*known))
        for _ in range(self.turns):
            values = _exact(self._next(*known, *values))
        return values


def _exact(values: Sequence[Any]) -> list[Any]:
    """A bound is a plain integer, and 1 over it a plain float, if nobody minds."""
    return [mpmath.mpf(value) for value in values]


def turnings(iterations: Iterations, names: Sequence[sympy.Symbol], exact: Exact) -> list[Turning]:
    """The iterations in an order in which each stands only on those before it."""
    known, done = list(names), dict[str, Turning]()

    def add(key: str) -> None:
        given, at = iterations[key]
        # Translating may meet iterations inside this one: `iterations` grows by them.
        forms = [at(e) for e in (*given.start, *given.following)]
        free = set[sympy.Basic]().union(*(form.free_symbols for form in forms))
        for other in list(iterations):
            unknowns = iterations[other][0].unknowns
            if other not in (key, *done) and free & {symbol(f"{other}_{u.name}") for u in unknowns}:
                add(other)
        done[key] = Turning(key, given, at, known, exact)
        known.extend(done[key].results)

    for key in list(iterations):
        if key not in done:
            add(key)
    return list(done.values())


def replaced(form: sympy.Basic, exact: Exact) -> sympy.Basic:
    """The form with symbols replaced, each part once however often it stands in it."""
    done: dict[sympy.Basic, sympy.Basic] = dict(exact)

    def of(part: sympy.Basic) -> sympy.Basic:
        if part not in done:
            args = [of(a) for a in part.args]
            same = all(a is b for a, b in zip(args, part.args, strict=True))
            done[part] = part if same else part.func(*args)
        return done[part]

    return of(form)
