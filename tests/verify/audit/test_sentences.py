"""Sentences of a text: words for matrices, neglected quantities, bounds, combinations of turns."""

import pytest

from armillary import X, Y, Z, absolute, cos, elementary, matrix, number, sin, vector
from armillary.verify.audit.audit import audit
from armillary.verify.audit.verdict import Verdict
from tests.verify.audit.papers import only


def test_a_word_that_fits(arm):
    arm.p.word("1", "it is orthogonal", "orthogonal", {"R": arm.R.matrix()})
    finding = only(arm)
    assert (finding.verdict, finding.quote) == (Verdict.HOLDS, "it is orthogonal")


def test_a_word_for_another_word(arm):
    arm.p.word("1", "they are singular", "singular", {"R": arm.R.matrix()})
    finding = only(arm)
    assert finding.verdict is Verdict.MISPRINT
    assert finding.readings[0].whole.words == "orthogonal for singular"
    assert "the determinant of R is 1" in finding.says


@pytest.mark.parametrize(
    ("word", "entries"),
    [
        ("symmetric", lambda a: ((1, a), (a, 2))),
        ("skew-symmetric", lambda a: ((0, a), (-a, 0))),
        ("diagonal", lambda a: ((a, 0), (0, 2))),
        ("singular", lambda a: ((a, 2 * a), (1, 2))),
        ("orthogonal", lambda a: ((sin(a), cos(a)), (cos(a), -sin(a)))),
    ],
)
def test_each_word_holds_of_its_matrix_only(arm, word, entries):
    arm.p.word("yes", "q", word, {"A": matrix(*entries(arm.g))})
    arm.p.word("no", "q", word, {"B": matrix((1, arm.g), (3, arm.u))})
    yes, no = audit(arm.p)
    assert (yes.verdict, no.verdict) == (Verdict.HOLDS, Verdict.WRONG)


def test_no_word_fits(arm):
    arm.p.word("1", "q", "symmetric", {"B": matrix((1, arm.g), (3, arm.u))})
    assert only(arm).verdict is Verdict.WRONG
    assert "B is off by up to" in only(arm).says


def test_what_may_be_neglected(arm):
    t, q = arm.theta, arm.psi
    arm.p.negligible("yes", "q", t, of=vector(t * t, q, 1), beside=(q,))
    arm.p.negligible("no", "q", t, of=vector(t, q, 1), beside=(q,))
    yes, no = audit(arm.p)
    assert (yes.verdict, no.verdict) == (Verdict.HOLDS, Verdict.WRONG)
    assert "its effect is 1 times the largest of the others" in no.says


def test_what_is_needed(arm):
    t, q = arm.theta, arm.psi
    arm.p.needed("yes", "q", (t, q), of=sin(t) * cos(arm.g) + q)
    arm.p.needed("no", "q", (t, q), of=sin(t) + q * q)
    yes, no = audit(arm.p)
    assert (yes.verdict, no.verdict) == (Verdict.HOLDS, Verdict.WRONG)
    assert "psi" in no.says.split(".")[0]


def test_bounds(arm):
    arm.p.between("yes", "q", sin(arm.g), -1, 1, words="the sine")
    arm.p.between("no", "q", 2 * sin(arm.g), -1, 1, words="the sine")
    yes, no = audit(arm.p)
    assert (yes.verdict, no.verdict) == (Verdict.HOLDS, Verdict.WRONG)
    shown = no.readings[0].counterexample
    assert shown.printed in (-1, 1)
    assert abs(shown.derived) > 1
    assert "Over the working ranges the sine is -2 to 2; stated is -1 to 1." in no.says


def test_a_bound_of_a_number_has_its_words_and_its_unit(arm):
    arm.p.between("three", "q", number(3), 0, 2, words="the number of legs")
    arm.p.between("angle", "q", absolute(arm.theta), 0, 0, words="the lean")
    three, angle = audit(arm.p)
    assert three.says == "Over the working ranges the number of legs is 3; stated is 0 to 2."
    assert angle.says.startswith(
        "Over the working ranges the lean is 0 to 0.3 rad; stated is 0 rad."
    )
    assert angle.unit == "rad"


def test_turns_that_reach_every_orientation(arm):
    a = arm.p.angle("a", "x")
    g, u = arm.g, arm.u
    full = elementary(Z, g) @ elementary(X, u) @ elementary(Z, a)
    flat = elementary(Z, g) @ elementary(Y, u) @ elementary(Y, a)
    arm.p.spans("yes", "q", full, (g, u, a))
    arm.p.spans("no", "q", flat, (g, u, a))
    yes, no = audit(arm.p)
    assert (yes.verdict, no.verdict) == (Verdict.HOLDS, Verdict.WRONG)
    assert "rank 2" in no.says
