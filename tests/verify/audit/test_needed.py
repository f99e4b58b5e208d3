"""Sentences that say small angles must be taken into account."""

import pytest

from armillary import Paper, cos, sin, vector
from armillary.verify.audit.audit import audit
from armillary.verify.audit.verdict import Verdict


@pytest.fixture
def p():
    return Paper("demo")


def small(p, name):
    return p.angle(name, "a small angle", range=(-0.1, 0.1))


def test_what_moves_with_an_angle_needs_it(p):
    a, theta = p.angle("a", "an angle"), small(p, "theta")
    p.needed("lean", "theta must be considered", (theta,), of=vector(cos(a + theta), 0, 1))
    (finding,) = audit(p)
    assert finding.verdict is Verdict.HOLDS
    assert finding.quote == "theta must be considered"
    assert "theta 0.001" in finding.says


def test_what_moves_to_second_order_only_does_not(p):
    a, theta, psi = p.angle("a", "an angle"), small(p, "theta"), small(p, "psi")
    of = sin(a + theta) * cos(psi)
    p.needed("lean", "theta and psi must be considered", (theta, psi), of=of)
    (finding,) = audit(p)
    assert finding.verdict is Verdict.WRONG
    assert "hardly feels psi" in finding.says
    assert "theta 0.001" in finding.says
