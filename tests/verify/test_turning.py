"""Iterations of the text-book form: exact at a bound, and with constants put in once."""

import mpmath
import pytest
import sympy

from armillary import Derivation, solve
from armillary.verify import exact
from armillary.verify.turning import replaced


@pytest.fixture
def held():
    """A root of 3 x^2 = a that is held to [-2, 1] on the way: the bounds are whole numbers."""
    d = Derivation("demo", title="Demo")
    a = d.scalar("a", "three times a square", range=(0.1, 0.2))
    third = d.constant("third", 3, "a number")
    q = d.unknown("q", "its root")
    return solve(third * (q * q) - a, {q: 0.01}, steps=3, name="root", within={q: (-2, 1)})[0]


def test_a_bound_is_as_exact_as_any_other_value(held):
    """The first step goes to the bound; 1 over it must not be a plain float."""
    (found,) = exact.text_book(held)({"a": 0.125})
    with mpmath.workdps(60):
        value = mpmath.mpf("0.01")
        for _ in range(3):
            value -= (3 * value * value - mpmath.mpf("0.125")) / (6 * value)
            value = min(max(value, mpmath.mpf(-2)), mpmath.mpf(1))
        assert value != 1
        assert abs(found - value) < mpmath.mpf(10) ** -45


def test_what_stands_often_is_replaced_everywhere():
    x, y, z = sympy.symbols("x y z")
    form = x + y
    for _ in range(60):  # as a tree it would have 2^60 leaves
        form = sympy.Mul(form, sympy.Add(form, z, evaluate=False), evaluate=False)
    done = replaced(form, {x: sympy.Rational(1, 3)})
    assert symbols_of(form) == {x, y, z}
    assert symbols_of(done) == {y, z}
    assert replaced(form, {}) is form
    assert replaced(x + y, {x: z}) == y + z


def symbols_of(form):
    """Its symbols, each part visited once."""
    seen, stack = set(), [form]
    while stack:
        part = stack.pop()
        if id(part) not in seen:
            seen.add(id(part))
            stack.extend(part.args)
            if part.is_Symbol:
                seen.add(part)
    return {part for part in seen if isinstance(part, sympy.Symbol)}
