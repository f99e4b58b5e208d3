"""Comparing arrays point by point."""

import math

import numpy as np
import pytest

from armillary.verify.measured import Measured, compare

ANGLES = {"t": np.array([1.0, 2.0, 3.0]), "n": np.eye(3), "L": 2.0}


def test_the_worst_point_is_named():
    wanted = np.array([[1.0, 4.0], [1.0, 1.0], [0.0, 0.0]])
    found = wanted + np.array([[0.0, 4e-6], [5e-6, 0.0], [0.0, 0.0]])
    made = compare("a", "by hand", found, wanted, 1e-5, ANGLES, kernel="k")
    assert made.worst == pytest.approx(5e-6)
    assert made.at == {"t": 2.0, "n": [0.0, 1.0, 0.0], "L": 2.0}
    assert (made.points, made.kernel, made.passed) == (3, "k", True)
    assert not compare("a", "by hand", found, wanted, 1e-6, ANGLES).passed


def test_relative_to_the_largest_entry_but_never_to_less_than_one():
    made = compare("a", "e", [[100.0, 1.0]], [[100.0, 2.0]], 1.0, {})
    assert made.worst == pytest.approx(0.01)
    assert compare("a", "e", [0.011], [0.010], 1.0, {}).worst == pytest.approx(0.001)
    assert compare("a", "e", [100.0], [101.0], 1.0, {}, relative=False).worst == 1.0


def test_whole_turns():
    turn = 2 * np.pi
    assert compare("a", "e", [turn - 1e-9], [0.0], 1e-8, {}, turn=True).passed
    assert not compare("a", "e", [turn - 1e-9], [0.0], 1e-8, {}).passed
    assert not compare("a", "e", [np.pi], [0.0], 1e-8, {}, turn=True).passed


def test_nan_never_passes():
    made = compare("a", "e", [1.0, math.nan, 3.0], [1.0, 2.0, 3.0], 1e9, {"t": np.arange(3.0)})
    assert math.isnan(made.worst)
    assert made.at == {"t": 1.0}
    assert not made.passed
    assert not Measured("a", "e", None, 1, math.nan, math.inf).passed


def test_no_points():
    with pytest.raises(ValueError, match="no point"):
        compare("a", "e", [], [], 1.0, {})


def test_scalars_are_one_point():
    assert compare("a", "e", 1.0, 1.0, 0.0, {"t": 3.0}).at == {"t": 3.0}
