"""Statuses: numbers that never change, and which of two is told."""

import itertools

from armillary.derivation.status import MEANINGS, Status, worse


def test_the_numbers_are_part_of_the_abi():
    assert {s.name: int(s) for s in Status} == {
        "OK": 0, "CLAMPED": 1, "SINGULAR": 2, "STICKING": 3, "BELOW_HORIZON": 4, "LIMIT": 5,
        "NOT_FINITE": -1, "OUT_OF_RANGE": -2, "UNREACHABLE": -3, "NOT_CONVERGED": -4,
    }  # fmt: skip
    assert set(MEANINGS) == set(Status)


def test_the_most_negative_wins_else_the_largest():
    for a, b in itertools.product(Status, repeat=2):
        low, high = min(a, b), max(a, b)
        assert worse(a, b) == worse(b, a) == (low if low < 0 else high)
