"""Arithmetic of nodes: zeros and ones disappear, structure stays, numbers are exact."""

import math

import pytest
import sympy

from armillary import (
    PI,
    Derivation,
    degrees,
    full_turn,
    matrix,
    number,
    reciprocal_or_zero,
    wrap,
)
from armillary.algebra import scalar as s
from armillary.algebra.explicit import Explicit, symbol
from armillary.algebra.functions import arccos, arcsin
from armillary.algebra.scalar import ONE, ZERO, Symbol
from armillary.algebra.vector import NULL, Basis, VectorSymbol, vector
from armillary.derivation.units import METRE
from tests.programs import program_of, value_of

TURN = 2 * math.pi
a, b = Symbol("a"), Symbol("b")
u = VectorSymbol("u")


def test_zeros_and_ones_disappear():
    assert a + 0 is a
    assert 0 + a is a
    assert 1 * a is a
    assert a / 1 is a
    assert a - 0 is a
    assert (0 * a) is ZERO
    minus = -a
    assert -minus is a


def test_structure_is_kept():
    assert isinstance(a + a, s.Add)
    assert isinstance((a + b) * (a + b), s.Multiply)
    assert isinstance(a - a, s.Add)


def test_an_arc_sine_or_cosine_keeps_its_digits_near_its_ends():
    near = 1 - 1e-14
    angle = Explicit()(arcsin(number(near)).explicit())
    assert float(sympy.N(angle, 30)) == float(sympy.N(sympy.asin(number(near).value), 30))
    assert isinstance(arcsin(a), s.ArcSine)
    angle = Explicit()(arccos(number(near)).explicit())
    assert float(sympy.N(angle, 30)) == float(sympy.N(sympy.acos(number(near).value), 30))


def test_matrices_are_written_row_by_row():
    made = matrix((1, a), (b, "0.5"))
    assert made.shape == (2, 2)
    assert made.rows[0][1] is a
    assert made.rows[1][1].value == sympy.Rational(1, 2)
    with pytest.raises(ValueError, match="one length"):
        matrix((1, 2), (3,))


def test_decimals_are_what_was_written():
    assert number(23.45).value == sympy.Rational(2345, 100)
    assert number("0.1").value == sympy.Rational(1, 10)
    assert degrees(180).value == sympy.pi
    assert degrees("23.45").value == sympy.Rational(2345, 100) * sympy.pi / 180
    assert PI.value == sympy.pi


def test_powers_are_products():
    assert a**1 is a
    assert isinstance(a**3, s.Multiply)
    with pytest.raises(TypeError, match=r"unsupported operand|whole powers"):
        a**0.5


def test_division_by_the_number_zero():
    with pytest.raises(ZeroDivisionError):
        a / 0


def test_a_condition_has_no_truth_value():
    with pytest.raises(TypeError, match="where"):
        bool(a < b)


def test_a_scalar_is_no_string_of_words():
    with pytest.raises(ValueError, match="one"):
        number("one")
    with pytest.raises(TypeError, match="expected a scalar"):
        a + [1]  # noqa: RUF005


def test_vectors_of_zeros():
    assert vector(0, 0, 0) + u is u
    assert u - vector(0, 0, 0) is u
    assert (0 * u) is NULL
    assert vector(1, 2, 3).y.value == 2
    assert Basis(2).z is ONE
    assert Basis(2).x is ZERO
    assert Basis(0).dot(u) is not None
    assert isinstance(Basis(1).dot(u), s.Component)


@pytest.mark.parametrize(
    ("angle", "wrapped", "turned"),
    [
        (7.0, 7 - TURN, 7 - TURN),
        (-1.0, -1.0, TURN - 1),
        (0.0, 0.0, 0.0),
        (-7.0, TURN - 7, 2 * TURN - 7),
    ],
)
def test_turns(angle, wrapped, turned):
    wrapped = wrapped if abs(wrapped) <= TURN / 2 else wrapped - TURN
    assert value(wrap(a), angle) == pytest.approx(wrapped)
    assert value(full_turn(wrap(a)), angle) == pytest.approx(turned % TURN)


def value(node, at):
    return float(Explicit()(node).xreplace({symbol("a"): sympy.Float(at, 30)}))


def test_one_over_a_value_is_0_where_the_value_may_be_0():
    record = Derivation("guarded", title="Guarded")
    x = record.length("x", "a divisor, in metres")
    least = record.constant("least", "0.5", "what is divided by", unit=METRE)
    program = program_of(record, [x], {"r": reciprocal_or_zero(x, x < least)})
    assert value_of(program, {"x": 0.0}) == 0.0
    assert value_of(program, {"x": 0.25}) == 0.0
    assert value_of(program, {"x": 4.0}) == 0.25
