"""The boxes of a rate: the wide ones of its unit, unless they are given."""

from armillary import Derivation


def test_a_rate_takes_the_boxes_of_its_unit():
    rate = Derivation("d", title="A title").angle("t", "an angle").rate()
    assert rate.facts.limits[1] > 1e3


def test_a_rate_takes_the_boxes_that_are_given():
    d = Derivation("d", title="A title")
    turning = d.angle("t", "an angle").rate(limits=(-5.0, 6.0), range=(-1.0, 2.0))
    moving = d.vector("v", "a place").rate("v_dot", limits=(-7.0, 7.0))
    assert (turning.facts.limits, turning.facts.range) == ((-5.0, 6.0), (-1.0, 2.0))
    assert moving.facts.limits == (-7.0, 7.0)


def test_a_rate_may_be_asked_for_again_in_its_own_boxes():
    angle = Derivation("d", title="A title").angle("t", "an angle")
    turning = angle.rate(limits=(-5, 6), range=(-1.0, 2.0))
    assert angle.rate(limits=(-5.0, 6.0), range=(-1, 2)) is turning
    assert angle.rate() is turning
