"""Constants are rounded once, and printed in the fewest digits that keep them."""

import struct
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from armillary.targets.numbers import F32, F64, nearest, shortest

doubles = st.floats(allow_nan=False, allow_infinity=False)
singles = st.floats(allow_nan=False, allow_infinity=False, width=32)
many = settings(max_examples=500)


def single(text):
    """A decimal rounded once to a float, by the C library's reading of it."""
    return float(np.float32(text))


@many
@given(doubles)
def test_doubles_read_back(x):
    text = shortest(x, F64)
    assert float(text) == x
    assert "." in text


@many
@given(singles)
def test_floats_read_back(x):
    text = shortest(x, F32)
    assert np.array(text, dtype="U").astype(np.float32) == np.float32(x)
    assert nearest(Fraction(text), F32) == Fraction(x)


def digits(text):
    return len(text.lower().split("e")[0].replace(".", "").strip("-0"))


@many
@given(doubles)
def test_no_double_has_more_digits_than_in_python(x):
    assert digits(shortest(x, F64)) <= digits(repr(x))


@many
@given(singles)
def test_no_float_has_more_digits_than_it_needs(x):
    assert digits(shortest(x, F32)) <= min(9, digits(str(np.float32(x))) + 1)


@many
@given(st.floats(min_value=-3e38, max_value=3e38))
def test_a_double_becomes_the_nearest_float(x):
    assert float(nearest(x, F32)) == float(np.float32(x))
    assert float(nearest(x, F32)) == struct.unpack("f", struct.pack("f", x))[0]


@many
@given(st.fractions(min_value=-(10**6), max_value=10**6))
def test_a_fraction_is_rounded_once(x):
    assert float(nearest(x, F64)) == x.numerator / x.denominator
    low = nearest(x, F32)
    ulp = Fraction(float(np.spacing(np.float32(abs(float(low))))))
    assert abs(low - x) <= ulp / 2


def test_no_value_is_rounded_twice():
    # Just above the middle of two floats, by less than a double can tell.
    middle = Fraction(1) + Fraction(1, 2**24)
    above = middle + Fraction(1, 2**80)
    assert float(above) == float(middle)
    assert nearest(middle, F32) == 1
    assert nearest(above, F32) == 1 + Fraction(1, 2**23)
    assert nearest(sympy.Rational(above.numerator, above.denominator), F32) > 1
    assert shortest(above, F32) == "1.0000001"


@pytest.mark.parametrize(
    ("value", "f32", "f64"),
    [
        (sympy.Integer(0), "0.0", "0.0"),
        (sympy.Integer(3), "3.0", "3.0"),
        (-sympy.Rational(1, 3), "-0.33333334", "-0.3333333333333333"),
        (sympy.Rational(2345, 100), "23.45", "23.45"),
        (sympy.Rational(1, 10), "0.1", "0.1"),
        (sympy.pi, "3.1415927", "3.141592653589793"),
        (2 * sympy.pi, "6.2831855", "6.283185307179586"),
        (sympy.pi / 180, "0.017453292", "0.017453292519943295"),
        (sympy.sqrt(2), "1.4142135", "1.4142135623730951"),
        (sympy.cos(sympy.pi / 7), "0.90096885", "0.9009688679024191"),
        (sympy.Integer(86400), "86400.0", "86400.0"),
        (sympy.Integer(1000), "1000.0", "1000.0"),
        (-sympy.Rational(27315, 100), "-273.15", "-273.15"),
        (sympy.Rational(1, 1000), "0.001", "0.001"),
        (sympy.Integer(10) ** 22, "1.0e22", "1.0e22"),
        (sympy.Integer(10) ** 6, "1.0e6", "1.0e6"),
        (sympy.Rational(1, 10**7), "1.0e-7", "1.0e-7"),
        (0.1, "0.1", "0.1"),
        (1.001, "1.001", "1.001"),
    ],
)
def test_known_constants(value, f32, f64):
    assert (shortest(value, F32), shortest(value, F64)) == (f32, f64)


@pytest.mark.parametrize("value", [sympy.pi, sympy.pi / 180, sympy.sqrt(3), sympy.exp(-40)])
def test_irrational_constants_equal_mpmaths(value):
    with mpmath.workdps(80):
        exact = mpmath.mpf(str(sympy.N(value, 80)))
    for precision in (F32, F64):
        with mpmath.workprec(precision.bits):
            assert float(nearest(value, precision)) == float(+exact)


def test_subnormal_numbers_keep_what_they_can():
    smallest = Fraction(2) ** -149
    assert nearest(smallest * Fraction(5, 2), F32) == 2 * smallest
    assert nearest(smallest / 2, F32) == 0
    assert shortest(Fraction(2) ** -1074, F64) == "5.0e-324"


@pytest.mark.parametrize(("value", "precision"), [(1e39, F32), (Fraction(10) ** 400, F64)])
def test_what_a_format_cannot_hold_is_refused(value, precision):
    with pytest.raises(ValueError, match=f"beyond the largest {precision.name}"):
        shortest(value, precision)
    assert single(shortest(float(np.finfo(np.float32).max), F32)) == np.finfo(np.float32).max
