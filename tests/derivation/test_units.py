"""Units: what fits, what does not, and how they are printed."""

import pytest

from armillary import Derivation, Twist, Wrench, arccos, arcsin, sqrt, vector
from armillary.derivation.units import (
    KILOGRAM,
    METRE,
    NEWTON,
    NEWTON_METRE,
    ONE,
    RADIAN,
    SECOND,
    WATT,
    UnitError,
    UnitOf,
    check_block,
)  # fmt: skip

d = Derivation("units", title="Units")
t, T = d.angle("t", "angle"), d.time("T", "time")
L, W = d.length("L", "length"), d.length("W", "width")
m = d.scalar("m", "mass", unit=KILOGRAM)


@pytest.mark.parametrize(
    ("expression", "unit"),
    [
        (L * W, METRE**2),
        (L / T, METRE / SECOND),
        (sqrt(L * W), METRE),
        (t * L + W, METRE),
        (vector(L, 0, W).norm(), METRE),
        (vector(L, 0, W).dot(vector(L, L, L)), METRE**2),
        (m * L / (T * T), NEWTON),
    ],
)
def test_units_follow(expression, unit):
    found = UnitOf()(expression)
    assert found is not None
    assert found.agrees(unit)


@pytest.mark.parametrize("expression", [L + T, L + t, sqrt(L) + L, vector(L, T, 0)])
def test_what_does_not_fit(expression):
    with pytest.raises(UnitError, match="do not fit"):
        UnitOf()(expression)


def test_an_arc_sine_or_cosine_takes_a_ratio():
    assert UnitOf()(arcsin(L / W)) == RADIAN
    with pytest.raises(UnitError, match="arc sine of a quantity in m"):
        UnitOf()(arcsin(L))
    assert UnitOf()(arccos(L / W)) == RADIAN
    with pytest.raises(UnitError, match="arc cosine of a quantity in m"):
        UnitOf()(arccos(L))


def test_zero_fits_everywhere():
    assert UnitOf()(vector(L, 0, 0) + vector(0, 0, 0)) == METRE


def test_blocks():
    w, v = vector(t / T, 0, 0), vector(L / T, 0, 0)
    check_block(Twist(w, v))
    with pytest.raises(UnitError, match="the angular part of a twist"):
        check_block(Twist(v, v))
    with pytest.raises(UnitError, match="the linear part of a twist"):
        check_block(Twist(w, w))
    force, moment = vector(m * L / (T * T), 0, 0), vector(m * L * L / (T * T), 0, 0)
    check_block(Wrench(moment, force))
    with pytest.raises(UnitError, match="the moment of a wrench"):
        check_block(Wrench(force, force))


@pytest.mark.parametrize(
    ("unit", "text"),
    [
        (ONE, "1"), (RADIAN, "rad"), (METRE, "m"), (METRE / SECOND, "m/s"), (NEWTON, "N"),
        (RADIAN / SECOND, "rad/s"), (METRE**2, "m^2"), (WATT, "W"), (ONE / SECOND, "1/s"),
    ],
)  # fmt: skip
def test_printed(unit, text):
    assert str(unit) == text


def test_a_newton_metre_is_a_moment():
    assert NEWTON_METRE.agrees(NEWTON * METRE)
