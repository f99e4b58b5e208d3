"""The size of a truncation's error: measured, led by the derived term, and bounded."""

import math

import numpy as np
import pytest

from armillary import Derivation, absolute, atan2, cos, elementary, sin, sqrt, truncate, vector
from armillary.algebra.misuse import MisuseError
from armillary.algebra.scalar import Symbol
from armillary.verify.remainder import (
    remainder_check,
    remainder_order,
    remainder_size,
    rotation_bound,
)

d = Derivation("errors", title="Errors")
theta = d.parameter.angle("theta", "first lean", range=(-0.1, 0.05))
psi = d.parameter.angle("psi", "second lean", range=(-0.2, 0.2))
a = d.angle("a", "drive angle", range=(-3.2, 3.2))
offset = d.vector("offset", "a small vector", range=(-0.1, 0.1))
SMALL = (theta, psi)
both = elementary(0, psi) @ elementary(2, a) @ elementary(1, theta)


def test_the_worst_point_is_an_end_of_the_range():
    size = remainder_size(truncate(sin(theta), 2, (theta,)))
    assert size.worst == pytest.approx(0.1 - math.sin(0.1), rel=1e-12)
    assert size.leading == pytest.approx(0.1**3 / 6, rel=1e-12)
    assert size.at["theta"] == size.leading_at["theta"] == -0.1
    assert size.points == 256


def test_every_combination_of_ends_is_met():
    # Largest where the two have opposite ends.
    size = remainder_size(truncate(cos(theta - psi), 1, SMALL), n=2)
    assert size.at == {"theta": -0.1, "psi": 0.2}
    assert size.worst == pytest.approx(1 - math.cos(0.3), rel=1e-12)


def test_a_small_vector_has_ends_in_every_component():
    node = (vector(1, 0, 0) + offset).dot(vector(1, 1, 1) + offset) / 2
    size = remainder_size(truncate(node, 1, (offset,)))
    assert size.worst == pytest.approx(3 * 0.1**2 / 2, rel=1e-12)


@pytest.mark.parametrize("order", [1, 2, 3])
def test_the_bound_of_a_rotation_is_above_what_is_measured(order):
    bound = rotation_bound(both, order, SMALL)
    assert bound == pytest.approx(0.3 ** (order + 1) / math.factorial(order + 1), rel=1e-9)
    rng = np.random.default_rng(5)
    for lean, inclination, drive in rng.uniform(-1, 1, (200, 3)) * [0.1, 0.2, 3.2]:
        difference = _product(lean, inclination, drive) - _series(lean, inclination, drive, order)
        assert np.linalg.norm(difference, 2) <= bound
    size = remainder_size(truncate(both, order, SMALL))
    assert bound / 30 < size.worst <= bound


def test_the_bound_is_met_by_turns_about_one_axis():
    node = elementary(2, psi) @ elementary(2, a) @ elementary(2, 2 * psi - a + theta / 2)
    bound = rotation_bound(node, 1, SMALL)
    assert bound == pytest.approx(0.65**2 / 2, rel=1e-9)
    assert bound >= remainder_size(truncate(node, 1, SMALL)).worst > 0.9 * bound


def _skew(axis):
    return np.cross(np.eye(3), -np.eye(3)[axis]).T * -1


def _turn(axis, angle):
    e = _skew(axis)
    return np.eye(3) + np.sin(angle) * e + (1 - np.cos(angle)) * e @ e


def _product(lean, inclination, drive):
    return _turn(0, inclination) @ _turn(2, drive) @ _turn(1, lean)


def _series(lean, inclination, drive, order):
    def term(axis, angle, k):
        return np.linalg.matrix_power(angle * _skew(axis), k) / math.factorial(k)

    return sum(
        term(0, inclination, j) @ _turn(2, drive) @ term(1, lean, k - j)
        for k in range(order + 1)
        for j in range(k + 1)
    )


def test_a_bound_needs_linear_angles_and_ranges():
    with pytest.raises(MisuseError, match="not linear"):
        rotation_bound(elementary(0, theta * psi), 1, SMALL)
    with pytest.raises(MisuseError, match="not linear"):
        rotation_bound(elementary(0, sin(theta)), 1, SMALL)
    bare = Symbol("bare")
    with pytest.raises(MisuseError, match="no declared range"):
        rotation_bound(elementary(0, bare), 1, (bare,))


def test_points_can_be_left_out():
    made = truncate(sqrt(1 + theta), 1, (theta,))
    kept = remainder_size(made, keep=lambda row: row["theta"] > 0)
    assert 0 < kept.points < 256
    assert kept.at["theta"] == 0.05
    with pytest.raises(ValueError, match="no point"):
        remainder_size(made, keep=lambda row: False)


def test_angles_differ_by_less_than_a_turn():
    # The exact angle goes through pi; the truncated one does not jump.
    node = atan2(theta, -1)
    made = truncate(node, 1, (theta,))
    assert remainder_size(made, turn=True).worst < 1e-3
    assert remainder_size(made).worst > 6


def test_a_check_states_the_size_and_can_fail():
    made = truncate(sin(theta), 2, (theta,))
    assert remainder_check("sine", made, 2e-4).passed
    failed = remainder_check("sine", made, 1e-4)
    assert not failed.passed
    assert "0.00017" in failed.why


def test_a_missing_value_never_passes():
    # Beyond the range of the truncation the exact root is not real.
    made = truncate(sqrt(absolute(a) - absolute(a) + 0.04 + theta), 1, (theta,))
    assert not remainder_check("root", made, 1.0).passed


@pytest.mark.parametrize("order", [1, 2, 3])
def test_the_measured_order(order):
    assert remainder_order(truncate(both, order, SMALL)) == pytest.approx(order + 1, abs=1e-3)


def test_the_measured_order_tells_a_wrong_term():
    made = truncate(sin(a + theta), 2, (theta,))
    wrong = truncate(sin(a + theta) + theta * theta / 7, 2, (theta,))
    mixed = type(made)(wrong.value, 2, made.small, made.remainder, made.terms, made.exact)
    assert remainder_order(mixed) == pytest.approx(2, abs=1e-3)
