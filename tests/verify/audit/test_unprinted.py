"""Figures that hang on what a paper does not print, and counterexamples at a paper's own values."""

import pytest

from armillary import Derivation, Paper, absolute, sin, total, vector
from armillary.derivation.errors import DerivationError
from armillary.derivation.record import Used
from armillary.derivation.units import METRE, RADIAN
from armillary.verify.audit.audit import audit
from armillary.verify.audit.verdict import Verdict


class Swing:
    """A swing of two parts, of a size and about a middle that a paper does not print."""

    def __init__(self) -> None:
        self.d = d = Derivation("swing", title="Swing")
        self.side = d.index("side", 2)
        self.t = d.scalar("t", "time", range=(0.0, 3.0))
        self.r = d.parameter.length("r", "radius", range=(0.5, 2.0), per=self.side)
        self.p = p = Paper("swing_paper")
        p.used["swing"] = Used(d)
        self.size = p.scalar("size", "size of the swing", range=(0.0, 4.0), unit=METRE)
        self.middle = p.scalar("middle", "its middle", range=(-4.0, 4.0), unit=METRE)
        self.value = self.middle + self.size * sin(self.t)

    def hanging(self, low, high, *more, to=0):
        figures = {"the reach": (self.value, low, high), **dict(more)}
        self.p.hanging(
            "1", "q", figures, on={self.size: 1, self.middle: 0}, words="a swing of 1 m", to=to,
            see="More is said elsewhere.",
        )  # fmt: skip
        (finding,) = audit(self.p)
        return finding


@pytest.fixture
def swing():
    return Swing()


def test_a_figure_that_another_choice_would_give(swing):
    finding = swing.hanging("2.5", "2.5", to="0.01")
    assert finding.verdict is Verdict.NOT_CHECKABLE
    assert finding.readings == ()
    assert finding.says.startswith(
        "With a swing of 1 m, which the paper does not print, the reach is 1 m, stated is 2.5 m."
    )
    assert "it is 2.5 m: what is not printed decides. More is said elsewhere." in finding.says


def test_a_figure_that_no_choice_gives(swing):
    finding = swing.hanging("9", None)
    assert finding.verdict is Verdict.WRONG
    assert "the reach is 1 m, stated is at least 9 m" in finding.says
    assert "No choice within 0 to 4 m of size and -4 to 4 m of middle gives it" in finding.says
    assert finding.readings[0].worst == pytest.approx(1, abs=2e-3)  # 8 m are the most


def test_figures_of_which_each_could_be_but_not_all(swing):
    below = ("the size", (swing.size, None, "0.5"))
    lower = ("the middle", (absolute(swing.middle), None, "0.25"))
    assert Swing().hanging(2, 2, to="0.01").verdict is Verdict.NOT_CHECKABLE
    finding = swing.hanging(2, 2, below, lower, to="0.01")
    assert finding.verdict is Verdict.WRONG
    assert finding.readings[0].worst == pytest.approx(1.25 / 3, abs=0.01)  # shared by the three


def test_a_choice_between_those_of_the_first_grid(swing):
    """The first grid has steps of 0.25 m: only those that shrink about its best find it."""
    finding = swing.hanging("3.3333", "3.3333", ("the size", (swing.size, 2, 2)), to="0.004")
    assert finding.verdict is Verdict.NOT_CHECKABLE
    assert "they are 3.33 m, 2 m" in finding.says


def test_figures_that_nothing_moves_are_refused(swing):
    with pytest.raises(DerivationError, match="has no figures, or hangs on nothing"):
        swing.p.hanging("1", "q", {"x": (swing.value, 0, 1)}, on={}, words="nothing")
    with pytest.raises(DerivationError, match="has no figures, or hangs on nothing"):
        swing.p.hanging("1", "q", {}, on={swing.size: 1}, words="nothing")


# ---- counterexamples at the paper's own values ----


def own(swing):
    """The paper's radii."""
    return swing.p.constant("r_1", ("0.75", "1.25"), "radii", unit=METRE, per=swing.side)


def test_a_counterexample_stands_at_the_papers_own_values(swing):
    p, r, t = swing.p, swing.r, swing.t
    p.example_at({r: own(swing)})
    p.equation("1", words="x", claims=r * sin(t), printed=r * t)
    p.between("2", "q", total(r, over=swing.side), 0, 1, words="the sum")
    first, second = audit(p)
    assert first.readings[0].counterexample.at["r"] == [0.75, 1.25]
    assert second.readings[0].counterexample.at["r"] == [0.75, 1.25]
    assert second.readings[0].counterexample.derived == 2


def test_where_nothing_shows_there_other_values_serve(swing):
    p, r = swing.p, swing.r
    p.example_at({r: own(swing)})
    p.between("1", "q", total(r, over=swing.side), 2, 2, words="the sum")
    (finding,) = audit(p)
    assert finding.verdict is Verdict.WRONG
    assert sum(finding.readings[0].counterexample.at["r"]) != 2


def test_an_example_has_numbers_of_the_quantitys_shape(swing):
    with pytest.raises(DerivationError, match="what r has in an example is not its value"):
        swing.p.example_at({swing.r: swing.size})
    with pytest.raises(DerivationError, match="constants of its shape"):
        swing.p.example_at({swing.t: vector(0, 0, 1)})
    turn = swing.p.constant("turn", 1, "a turn", unit=RADIAN)
    with pytest.raises(DerivationError, match="what an example has"):
        swing.p.example_at({turn: turn})
