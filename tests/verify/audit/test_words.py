"""Numbers and places in the sentences of findings."""

import pytest

from armillary.verify.audit.sides import told
from armillary.verify.audit.verdict import Counterexample
from armillary.verify.audit.words import at, number, two_numbers


@pytest.mark.parametrize(
    ("first", "second", "shown"),
    [
        (0.5, -0.25, ("0.5", "-0.25")),
        (1.0, 0.99975, ("1.0000", "0.99975")),
        (6.3, 6.28318, ("6.300", "6.283")),
        (0.0, 1e-17, ("0", "1e-17")),
        (2.0, 2.0, ("2", "2")),
    ],
)
def test_two_numbers_are_told_apart(first, second, shown):
    assert two_numbers(first, second, "") == shown


def test_units_follow_numbers():
    assert number(0.12345, "rad") == "0.123 rad"
    assert number(2.0, "1") == "2"


def test_a_counterexample_in_a_sentence():
    point = Counterexample({"a": 0.5235987755982988, "t": 0.01, "c": [0.48, 0.6, 0.64]}, 1.5, 1.0)
    assert at(point, "m") == (
        "At a = 30 deg, t = 0.01, c = (0.48, 0.6, 0.64) it gives 1.5 m; derived is 1 m."
    )
    assert at(Counterexample({}, 2.0, 3.0), "") == "It gives 2; derived is 3."


def test_places():
    assert told([(0, 1)]) == "entry (1, 2)"
    assert told([(0, 0), (1, 2), (2, 2)]) == "entries (1, 1), (2, 3) and (3, 3)"
