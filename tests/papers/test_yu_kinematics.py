"""What the audit must find in Yu, (1) to (18)."""

import pytest

from armillary.verify.audit.verdict import Verdict

SPIN_FREE = "true of a leg that does not spin about itself"


@pytest.fixture
def yu(found):
    return found["yu"]


def repairs(finding):
    """All repairs of a finding with one reading: that of the whole and those of entries."""
    (read,) = finding.readings
    return [r for r in (read.whole, *(e.repair for e in read.entries)) if r]


def failing(finding):
    """The places of the entries that fail."""
    (read,) = finding.readings
    return {(e.row, e.column) for e in read.entries if e.verdict is not Verdict.HOLDS}


def test_a_leg_that_points_to_the_ground(yu):
    assert yu["4"].verdict is Verdict.HOLDS  # a length does not tell
    assert yu["5"].verdict is Verdict.SIGN
    assert yu["5"].readings[0].worst == pytest.approx(2, abs=1e-4)
    # What (5) would change: the loop does not close, and a leg that grows would shrink.
    assert yu["3"].verdict is yu["8"].verdict is Verdict.HOLDS
    assert yu["3 by (5)"].verdict is yu["8 by (5)"].verdict is Verdict.SIGN


def test_most_entries_of_the_joints_jacobian(yu):
    assert yu["6"].verdict is Verdict.HOLDS  # the product that it is made from
    assert yu["6'"].verdict is Verdict.WRONG
    assert failing(yu["6'"]) == {(1, 1), (1, 2), (2, 1), (3, 2)}
    assert {r.words for r in repairs(yu["6'"])} == {"sin for cos of phi"}
    assert yu["8 by (6)"].verdict is Verdict.WRONG


def test_the_spin_that_is_left_out(yu):
    (repair,) = repairs(yu["10"])
    assert (yu["10"].verdict, repair.kind) == (Verdict.WRONG, "frame")
    assert repair.words.startswith("rr_3ups-omega_free_W")
    assert yu["10'"].verdict is Verdict.HOLDS  # it follows from (10)
    for key in ("10 reason", "16", "17'", "18", "18''"):
        assert [r.words for r in repairs(yu[key])] == [SPIN_FREE], key
    assert failing(yu["16"]) == failing(yu["18"]) == {(4, 1), (5, 1), (6, 1)}


@pytest.mark.parametrize("key", ["12", "12'", "14", "14'"])
def test_factors_of_a_cross_product_exchanged(yu, key):
    assert yu[key].verdict is Verdict.SIGN
    (repair,) = repairs(yu[key])
    assert repair.kind == "sign"


def test_the_rate_of_the_other_links_jacobian(yu):
    (repair,) = repairs(yu["17"])
    assert (repair.kind, repair.words) == ("index", "Jdot_t for Jdot_s")
    assert yu["18'"].verdict is Verdict.HOLDS


def test_a_name_for_three_numbers_and_for_six(yu):
    assert yu["12 and 16"].verdict is Verdict.WRONG
    assert "is 6; stated is 3" in yu["12 and 16"].says


@pytest.mark.parametrize("letter", ["T", "S"])
def test_a_position_that_starts_at_the_leg(yu, letter):
    number = {"T": "11", "S": "13"}[letter]
    assert yu[number].verdict is Verdict.HOLDS
    finding = yu[f"{number} in words"]
    assert finding.verdict is Verdict.WRONG
    assert [r.words for r in repairs(finding)] == ["true of the vector from Q_i to it"]
