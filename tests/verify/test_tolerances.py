"""Committed tolerances: four times what was measured, one digit, never below four roundings."""

import json

import pytest

from armillary.verify import tolerances

EPS = 2.0**-52


@pytest.mark.parametrize(
    ("worst", "wanted"),
    [(1e-14, 4e-14), (1.1e-14, 5e-14), (2.4e-14, 1e-13), (0.0, 9e-16), (1e-20, 9e-16)],
)
def test_rounded_up(worst, wanted):
    assert tolerances.rounded_up(worst, EPS) == wanted


def test_an_endless_error_gets_none():
    with pytest.raises(ValueError, match="no tolerance"):
        tolerances.rounded_up(float("inf"), EPS)


def test_written_sorted_and_read_back(tmp_path):
    made = {"pose": {"numpy f64": 1e-15, "c f32": 2e-6}, "aim": {"c f64": 3e-15}}
    tolerances.write(tmp_path, made)
    assert tolerances.read(tmp_path) == made
    assert list(json.loads((tmp_path / "tolerances.json").read_text())) == ["aim", "pose"]
    assert [p.name for p in tmp_path.iterdir()] == ["tolerances.json"]


def test_none_are_committed_yet(tmp_path):
    assert tolerances.read(tmp_path) == {}


def test_what_was_not_measured_stays():
    known = {"pose": {"numpy f64": 1e-15, "c f64": 1e-15}}
    made = tolerances.merged(known, [("pose", "numpy f64", 2e-15), ("aim", "c f64", 3e-15)])
    assert made == {"pose": {"numpy f64": 2e-15, "c f64": 1e-15}, "aim": {"c f64": 3e-15}}
    assert known["pose"]["numpy f64"] == 1e-15
