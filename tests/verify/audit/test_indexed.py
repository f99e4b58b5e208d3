"""Prints of what is per part of an index: values at each part, and verdicts on all of them."""

import mpmath
import numpy as np
import pytest

from armillary import (
    Derivation,
    Paper,
    any_of,
    at,
    cos,
    degrees,
    one_like,
    sin,
    solve,
    sqrt,
    total,
    vector,
    where,
)
from armillary.algebra.index import Index
from armillary.derivation.record import Used
from armillary.derivation.units import RADIAN
from armillary.verify.audit.audit import audit
from armillary.verify.audit.numbers import Digits, Doubles
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.points import everywhere, exact, quantities, round_points, sample
from armillary.verify.audit.verdict import Verdict

PARTS = np.array([0, 2, 1, 2])
LENGTHS = np.array([[1.0, 2.0, 4.0], [0.5, 3.0, 7.0], [2.0, 5.0, 1.0], [9.0, 8.0, 6.0]])


class Legs:
    """Three legs of their own lengths on a circle, and a paper about them."""

    def __init__(self) -> None:
        self.d = d = Derivation("legs", title="Legs")
        self.leg = d.index("leg", 3)
        self.facet = d.index("facet", 2)
        self.theta = d.constant(
            "theta", (0, degrees(120), degrees(-120)), "azimuth", unit=RADIAN, per=self.leg
        )
        self.phi = d.constant("phi", (0, degrees(90)), "azimuth", unit=RADIAN, per=self.facet)
        self.l = d.length("l", "length", per=self.leg)
        self.a = d.angle("a", "turn")
        self.foot = d.define(
            "foot", self.l * vector(cos(self.theta), sin(self.theta), 0), because="on a circle"
        )
        self.p = Paper("legs_paper")
        self.p.used["legs"] = Used(d)


@pytest.fixture
def legs():
    return Legs()


def values_of(legs, numbers):
    points = {legs.l: LENGTHS, legs.a: np.array([0.1, 0.2, 0.3, 0.4]), legs.leg: PARTS}
    return Values(numbers, points)


@pytest.mark.parametrize("numbers", [Doubles(), Digits()])
def test_values_stand_at_the_part_of_each_point(legs, numbers):
    values, n = values_of(legs, numbers), np.arange(4)
    azimuth = np.radians([0, 120, -120])

    def close(node, wanted):
        return np.allclose(np.array(values.array(node), dtype=float), wanted, atol=1e-14)

    assert close(legs.l, LENGTHS[n, PARTS])
    assert close(legs.theta, azimuth[PARTS])
    assert close(legs.foot.x, (LENGTHS * np.cos(azimuth))[n, PARTS])
    assert close(at(legs.foot, legs.leg, 1).y, LENGTHS[:, 1] * np.sin(azimuth[1]))
    assert close(total(legs.l * sin(legs.theta), over=legs.leg), LENGTHS @ np.sin(azimuth))
    assert close(total(legs.foot, over=legs.leg).x, LENGTHS @ np.cos(azimuth))
    assert close(where(any_of(legs.l > 6, over=legs.leg), 1, 0), [0, 1, 0, 1])
    assert close(one_like(legs.l) + 0 * legs.l, 1)


def test_a_sum_inside_a_sum_holds_both_indices(legs):
    node = total(total(legs.l * cos(legs.theta + legs.phi), over=legs.leg), over=legs.facet)
    # Below the sum over the legs one facet is held, and the other way round.
    other = total(total(legs.l * cos(legs.theta + legs.phi), over=legs.facet), over=legs.leg)
    azimuth = np.radians([0, 120, -120])
    wanted = sum(LENGTHS @ np.cos(azimuth + phi) for phi in (0, np.pi / 2))
    values = values_of(legs, Doubles())
    assert np.allclose(values.array(node), wanted, atol=1e-14)
    assert np.allclose(values.array(other), wanted, atol=1e-14)


def test_an_iteration_takes_all_its_steps(legs):
    d = legs.d
    x = d.unknown("x", "root")
    (root,) = solve([x * x - legs.l], {x: 1}, steps=8, name="newton")
    values = values_of(legs, Digits())
    wanted = [mpmath.sqrt(mpmath.mpf(v)) for v in LENGTHS[np.arange(4), PARTS]]
    assert max(abs(values.array(root) - wanted)) < 1e-15
    few = solve([x * x - legs.l], {x: 1}, steps=2, name="few")[0]
    assert max(abs(values.array(few) - wanted)) > 1e-3
    at_one = values.array(at(root, legs.leg, 0) - sqrt(at(legs.l, legs.leg, 0)))
    assert max(abs(at_one)) < 1e-15


def test_points_say_where_an_index_stands(legs):
    known = quantities(legs.foot)
    assert known == [legs.l, legs.leg]
    drawn = sample(known, 200, 3)
    assert drawn[legs.l].shape == (200, 3)
    assert set(drawn[legs.leg]) == {0.0, 1.0, 2.0}
    assert exact(drawn, Digits())[legs.leg] is drawn[legs.leg]
    told = [point.told() for point in round_points(known, ())]
    assert {point["leg"] for point in told} == {1.0, 2.0, 3.0}
    assert all(len(point["l"]) == 3 for point in told)


def test_every_part_meets_every_step(legs):
    points = everywhere([legs.a, legs.leg, legs.facet], 5, 1)
    places = set(zip(points[legs.leg], points[legs.facet], strict=True))
    assert len(places) == 6
    assert len(points[legs.a]) == 30
    first = points[legs.a][:5]
    assert list(first) == sorted(first)


def test_a_print_per_part_is_judged_at_all_of_them(legs):
    l, theta = legs.l, legs.theta
    legs.p.equation("1", words="foot", claims=legs.foot,
                    printed=vector(l * cos(theta), l * sin(theta), 0))  # fmt: skip
    legs.p.equation("2", words="foot", claims=legs.foot,
                    printed=vector(l * cos(theta), -l * sin(theta), 0))  # fmt: skip
    right, wrong = audit(legs.p)
    assert right.verdict is Verdict.HOLDS
    assert wrong.verdict is Verdict.SIGN
    assert wrong.readings[0].counterexample.at["leg"] in (2.0, 3.0)  # of leg 1 the sine is 0
    assert "leg = " in wrong.says


def test_a_print_of_single_parts(legs):
    parts = [at(legs.foot, legs.leg, k) for k in range(3)]
    legs.p.equation(
        "1", words="x of the feet", claims=vector(*(foot.x for foot in parts)),
        printed=vector(at(legs.l, legs.leg, 0), -at(legs.l, legs.leg, 1) / 2,
                       at(legs.l, legs.leg, 2) / 2),
    )  # fmt: skip
    (finding,) = audit(legs.p)
    assert [e.verdict for e in finding.readings[0].entries] == [
        Verdict.HOLDS, Verdict.HOLDS, Verdict.SIGN,
    ]  # fmt: skip


def test_an_index_is_compared_by_value():
    values = Values(Doubles(), {Index("leg", 3): np.array([0, 1])})
    assert values.count == 2
