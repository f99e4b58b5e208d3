"""How names print on a page."""

import pytest

from armillary.derivation.record import Derivation


@pytest.mark.parametrize("latex", [r"\alpha", r"\mathbf{c}", r"x_\dot{y}"])
def test_rates_carry_a_dot_and_then_two(latex):
    d = Derivation("dots", title="Dots")
    rate = d.scalar("x", "a place", latex=latex).rate()
    assert rate.facts.latex == rf"\dot{{{latex}}}"
    assert rate.rate("x_ddot", "its bend").facts.latex == rf"\ddot{{{latex}}}"
