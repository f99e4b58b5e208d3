"""How large an error is, where it is shown, and what is said beyond the order of a print."""

import pytest

from armillary import cos, matrix, number, sin
from armillary.derivation.errors import DerivationError
from armillary.verify.audit.audit import audit
from armillary.verify.audit.shown import error_text
from armillary.verify.audit.verdict import Verdict
from tests.verify.audit.papers import only


def test_a_wrong_term_beyond_the_order_is_told(arm):
    t, q = arm.theta, arm.psi
    whole = (cos(t), 0, sin(t)), (sin(q) * sin(t), cos(q), -sin(q) * cos(t))
    rest = (-cos(q) * sin(t), sin(q), cos(q) * cos(t))
    for sign, told in ((1, "keeps terms of order 2"), (-1, "prints terms of order 2 that are not")):
        arm.p.equation(
            f"{sign}",
            words="lean",
            claims=matrix(*whole, rest),
            printed=matrix((1, 0, t), (sign * t * q, 1, -q), (-t, q, 1)),
            small=(t, q),
        )
        (read,) = audit(arm.p)[-1].readings
        assert (read.verdict, read.order) == (Verdict.ORDER, 1)
        assert any(f"entry (2, 1) {told}" in fact for fact in read.properties)


def test_a_lost_term_of_two_factors_and_a_lost_divisor(arm):
    u, a, b = arm.u, arm.L_1, arm.L_2
    arm.p.equation("1", words="height", claims=a + b * sin(u), printed=a)
    arm.p.equation("2", words="slope", claims=sin(u) / cos(arm.g), printed=sin(u))
    lost, divisor = (f.readings[0].entries[0].repair for f in audit(arm.p))
    assert (lost.kind, lost.words, lost.size) == ("lost term", "L_2 sin(u) added", 1)
    assert (divisor.kind, divisor.words) == ("factor", "sin(u) divided by cos(g)")


def test_the_counterexample_says_of_which_entry_it_is(arm):
    """Of one that fails, not of one that only holds to an order beside a derived 0."""
    t, q = arm.theta, arm.psi
    claims = matrix((cos(t), 0, sin(t)), (0, 1, 0), (-sin(t), 0, cos(t)))
    printed = matrix((1, t * q, -t), (0, 1, 0), (t, 0, 1))
    arm.p.equation("1", words="lean", claims=claims, printed=printed, small=(t, q))
    finding = only(arm)
    shown = finding.readings[0].counterexample
    assert (shown.row, shown.column) in ((1, 3), (3, 1))
    assert f"entry ({shown.row}, {shown.column}) gives" in finding.says


def test_the_error_is_met_at_the_ends_of_the_ranges(arm):
    """0.3 rad is the end of the range: at random inside it, less would be met."""
    arm.p.equation("1", words="lean", claims=number(0), printed=arm.theta + arm.psi)
    (read,) = only(arm).readings
    assert read.worst == pytest.approx(0.6, abs=1e-12)


def test_an_error_without_bound(arm):
    arm.p.equation("1", words="slope", claims=sin(arm.g), printed=sin(arm.g) / sin(arm.u))
    finding = only(arm)
    assert finding.readings[0].worst == float("inf")
    assert "errs without bound" in finding.says


def test_special_values_keep_to_the_condition_of_the_print(arm):
    """At theta = 0 it would hold, but there the print says nothing."""
    wrong = arm.psi + arm.theta * (arm.g + 7 * arm.u * arm.g)
    for key, given in (("1", None), ("2", arm.theta > 0.1)):
        arm.p.equation(key, words="lean", claims=arm.psi, printed=wrong, given=given)
    everywhere, above = audit(arm.p)
    assert "theta = 0" in everywhere.says
    assert "theta = 0" not in above.says


def test_a_condition_that_is_never_met(arm):
    arm.p.equation("1", words="lean", claims=arm.psi, printed=arm.psi, given=arm.psi > 9)
    with pytest.raises(DerivationError, match=r"condition of \(1\) holds at no point"):
        audit(arm.p)


def test_the_errors_of_several_readings(arm):
    arm.p.equation(
        "1", words="lean", claims=arm.psi, printed={"right": arm.psi, "twice": 2 * arm.psi}
    )
    assert error_text(only(arm)) == "0 to 0.3 rad"
