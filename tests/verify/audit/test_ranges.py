"""Sentences on the values that something takes: bounds, extremes, and what changes least."""

import pytest

from armillary import Derivation, Paper, at, degrees, sin
from armillary.derivation.errors import DerivationError
from armillary.derivation.record import Used
from armillary.derivation.units import METRE, RADIAN
from armillary.verify.audit.audit import audit
from armillary.verify.audit.verdict import Verdict


class Rods:
    """Rods that swing through a day, each about its own middle and by its own part."""

    def __init__(self) -> None:
        self.d = d = Derivation("rods", title="Rods")
        self.rod = d.index("rod", 2)
        self.side = d.index("side", 2)
        self.t = d.scalar("t", "time", range=(0.0, 3.0))
        self.part = d.constant("part", (1, 2), "part of the swing", unit=METRE, per=self.rod)
        self.turn = d.constant(
            "turn", (0, degrees(180)), "where it starts", unit=RADIAN, per=self.side
        )
        self.l = d.define(
            "l", 3 * self.part + self.part * sin(self.t + self.turn), because="it swings"
        )
        self.p = Paper("rods_paper")
        self.p.used["rods"] = Used(d)


@pytest.fixture
def rods():
    return Rods()


def verdicts(rods):
    return [finding.verdict for finding in audit(rods.p)]


def test_bounds_that_are_open(rods):
    p, l = rods.p, rods.l
    p.between("1", "q", l, 2, None, words="the length")
    p.between("2", "q", l, None, 8, words="the length")
    p.between("3", "q", l, "2.5", None, words="the length")
    p.between("4", "q", l, None, "7.5", words="the length")
    yes, also, low, high = audit(p)
    assert [f.verdict for f in (yes, also)] == [Verdict.HOLDS, Verdict.HOLDS]
    assert [f.verdict for f in (low, high)] == [Verdict.WRONG, Verdict.WRONG]
    assert "the length is 2 to 8 m; stated is at least 2.5 m" in low.says
    assert "stated is at most 7.5 m" in high.says
    assert low.readings[0].worst == pytest.approx(0.5, abs=1e-4)
    assert high.readings[0].worst == pytest.approx(0.5, abs=1e-4)


def test_bounds_under_a_condition(rods):
    p, l = rods.p, at(at(rods.l, rods.rod, 0), rods.side, 0)
    p.between("1", "q", l, None, "3.9", words="the length", given=rods.t < 1)
    p.between("2", "q", l, None, "3.9", words="the length", given=rods.t > 1)
    assert verdicts(rods) == [Verdict.HOLDS, Verdict.WRONG]


def test_what_is_zero_but_for_rounding_keeps_to_zero(rods):
    t = rods.t
    rods.p.between("1", "q", (t + 1) ** 2 - t * t - 2 * t - 1, 0, 0, words="the rest")
    rods.p.between("2", "q", t * "1e-12", 0, 0, words="the rest")
    assert verdicts(rods) == [Verdict.HOLDS, Verdict.WRONG]


def test_extremes_to_the_digit_printed(rods):
    p, l = rods.p, rods.l
    p.extremes("1", "q", l, "2.00", "8.00", to="0.01", words="the length")
    p.extremes("2", "q", l, "2.00", "8.02", to="0.01", words="the length")
    p.extremes("3", "q", l, "1.90", None, to="0.01", words="the length")
    p.extremes("4", "q", l, None, "8.0", to="0.1", words="the length")
    first, second, third, fourth = audit(p)
    assert [f.verdict for f in (first, second, third, fourth)] == [
        Verdict.HOLDS, Verdict.WRONG, Verdict.WRONG, Verdict.HOLDS,
    ]  # fmt: skip
    assert "at most 8.000 m, stated is 8.020 m" in second.says
    assert third.readings[0].worst == pytest.approx(0.1, abs=1e-4)
    assert "at least" not in fourth.says


def test_the_part_that_changes_least(rods):
    p, l = rods.p, rods.l
    p.least_moved("1", "q", l, over=rods.rod, part=0, words="the change")
    p.least_moved("2", "q", l, over=rods.rod, part=1, words="the change")
    yes, no = audit(p)
    assert (yes.verdict, no.verdict) == (Verdict.HOLDS, Verdict.WRONG)
    assert "side 1: 1, 2; side 2: 1, 2" in yes.says
    assert "Number 2 is not the least in 2 of 2." in no.says


def test_a_part_that_is_not_there(rods):
    with pytest.raises(DerivationError, match="a part from 0 to 1"):
        rods.p.least_moved("1", "q", rods.l, over=rods.rod, part=2, words="the change")
    with pytest.raises(DerivationError, match="a value per rod"):
        rods.p.least_moved("1", "q", rods.t, over=rods.rod, part=0, words="the change")
