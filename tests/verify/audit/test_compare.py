"""Two expressions compared: exactly, to an order, where both are defined, up to whole turns."""

import numpy as np
import pytest

from armillary import PI, Derivation, atan2, cos, number, sin, sqrt
from armillary.verify.audit import points as p
from armillary.verify.audit.compare import Bench, Outcome
from armillary.verify.audit.order import coefficient, mixed_order
from armillary.verify.audit.sides import sides_of


@pytest.fixture
def d():
    return Derivation("compare", title="Compare")


def outcome(left, right, **more):
    return Bench((left, right), **more).outcome(left, right)


def test_what_is_equal_is_equal_to_50_digits(d):
    a = d.angle("a", "x")
    assert outcome(sin(2 * a), 2 * sin(a) * cos(a)) == Outcome(exact=True)


def test_a_difference_below_double_precision_is_seen(d):
    a = d.angle("a", "x")
    assert not outcome(sin(a) + number("1e-18"), sin(a)).exact


def test_orders(d):
    a, t = d.angle("a", "x"), d.angle("t", "x", range=(-0.3, 0.3))
    exact = sin(a + t)
    for order, printed in enumerate(
        [sin(a), sin(a) + t * cos(a), sin(a) + t * cos(a) - t * t * sin(a) / 2]
    ):
        found = outcome(printed, exact, small=(t,))
        assert found == Outcome(exact=False, order=order)
        assert found.holds == (order >= 1)
    assert outcome(cos(a), exact, small=(t,)).order == -1


def test_orders_count_all_small_quantities_together(d):
    t, q = (d.angle(n, "x", range=(-0.3, 0.3)) for n in "tq")
    assert outcome(number(0), t * q, small=(t, q)).order == 1
    assert outcome(number(0), t * q, small=(t,)).order == 0


def test_angles_are_compared_up_to_whole_turns(d):
    a = d.angle("a", "x")
    assert outcome(atan2(sin(a), cos(a)) + 4 * PI, a).exact
    assert not outcome(atan2(sin(a), cos(a)) + PI, a).exact
    # A ratio has no turns.
    r = d.scalar("r", "x")
    assert not outcome(r + 2 * PI, r).exact


def test_points_where_a_side_is_not_defined_do_not_count(d):
    a = d.angle("a", "x")
    assert outcome(sqrt(a) * sqrt(a), a).exact
    assert not outcome(sqrt(-1 - a * a), a).exact
    bench = Bench((sqrt(a), a))
    assert 0.4 < bench.undefined(sqrt(a), a) < 0.6


def test_where_doubles_lose_all_digits_fifty_settle_it(d):
    a = d.angle("a", "x", range=(-1.0, 3.2))
    left, right = (1 - sin(a)) / cos(a) ** 2, 1 / (1 + sin(a))
    bench = Bench((left, right))
    far = np.abs(bench.difference(bench.floats, left, right)) > 0.1
    assert list(bench.points[a][far]) == [np.pi / 2]
    assert bench.outcome(left, right).exact


def test_a_condition_narrows_the_points(d):
    a, b = d.angle("a", "x"), d.angle("b", "x")
    given = (a > 0) & (b < a)
    bench = Bench((a, b), given=given)
    for values in (bench.floats, bench.many, bench.digits):
        low, high = values.array(b), values.array(a)
        assert all(x > 0 and y < x for x, y in zip(high, low, strict=True))


def test_the_worst_error_is_taken_over_the_working_ranges(d):
    L = d.length("L", "x", range=(1.0, 3.0))
    assert Bench((L,)).worst(2 * L, L) == pytest.approx(3.0, rel=0.01)


def test_unit_vectors_keep_their_norm_at_50_digits(d):
    b, c = d.unit_vector("b", "x"), d.unit_vector("c", "x")
    assert outcome(2 * (1 + b.dot(c)), (b + c).dot(b + c)).exact


def test_coefficients_of_a_series(d):
    t = d.angle("t", "x", range=(-0.3, 0.3))
    bench = Bench((t,), small=(t,))
    size = [abs(x) for x in bench.first_few[t]]
    for k, wanted in ((0, [1] * 6), (1, [0] * 6), (2, [x * x / 2 for x in size])):
        found = coefficient(bench, cos(t), k)
        assert max(abs(abs(f) - w) for f, w in zip(found, wanted, strict=True)) < 1e-15


def test_mixed_orders(d):
    from armillary import vector

    t = d.angle("t", "x", range=(-0.3, 0.3))

    def mixed(*printed):
        exact = vector(sin(t), cos(t), t + t * t)
        print_ = vector(*printed)
        bench = Bench((exact, print_), small=(t,))
        return mixed_order(sides_of(bench, print_, exact), 1)

    assert mixed(t, 1, t) == ""
    assert mixed(t, 1 - t * t / 2, t) == (
        "mixed order: entry (2, 1) keeps terms of order 2, entry (3, 1) lacks those of order 2"
    )
    assert mixed(sin(t), 1, t) == (
        "mixed order: entry (1, 1) keeps terms of order 3, "
        "entries (2, 1) and (3, 1) lack those of order 2"
    )


def test_two_quantities_of_one_name_get_points_of_their_own():
    first, second = (Derivation(n, title=n).angle("a", "x") for n in ("one", "two"))
    made = p.sample([first, second], 4, 0)
    assert not np.allclose(made[first], made[second])
    assert not outcome(first, second).exact


def test_round_points_are_round_and_inside_the_ranges(d):
    known = [
        d.angle("a", "x"),
        d.angle("t", "x", range=(-0.3, 0.3)),
        d.length("L", "x", range=(2.0, 3.0)),
        d.scalar("day", "x", range=(1.0, 367.0), limits=(0, 400)),
        d.unit_vector("u", "x"),
        d.rotation("R", "x"),
    ]
    for point in p.round_points(known, (known[1],)):
        at = point.told()
        assert abs(np.degrees(at["a"]) / 5 - round(np.degrees(at["a"]) / 5)) < 1e-9
        assert 0 < abs(at["t"]) <= 0.02
        assert 2 <= at["L"] <= 3
        assert 1 <= at["day"] <= 367
        assert np.hypot(np.hypot(*at["u"][:2]), at["u"][2]) == pytest.approx(1, abs=1e-15)
        R = np.array(at["R"]).reshape(3, 3)
        assert np.abs(R.T @ R - np.eye(3)).max() < 1e-15
        assert np.linalg.det(R) == pytest.approx(1)


def test_no_round_value_is_what_rounding_left_of_zero(d):
    """Of -0.3 to 0.1 three quarters are 5.6e-17 in double precision."""
    place = d.scalar("place", "x", range=(-0.3, 0.1))
    values = {point.told()["place"] for point in p.round_points([place], ())}
    assert 0.0 in values
    assert min(abs(value) for value in values if value) > 0.05


def test_the_plainest_round_point_with_a_large_error_is_shown(d):
    a, b = d.angle("a", "x"), d.angle("b", "x")

    def error(points):
        return points[a] - points[b]

    found = p.worst_round([a, b], (), None, error)
    assert found is not None
    assert abs(found.told()["a"] - found.told()["b"]) > 1
    assert p.worst_round([a, b], (), a < b, error).told()["a"] < np.pi
    assert p.worst_round([a, b], (), None, lambda points: 0 * points[a]) is None
