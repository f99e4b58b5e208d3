"""Sines of an angle and a constant of each part."""

import pytest

from armillary import Derivation, atan2, cos, degrees, sin, substitute
from armillary.program.compile import compile_kernel
from armillary.program.cost import cost
from armillary.program.lower import Strategy, lower
from armillary.program.passes.angle_sums import open_angle_sums
from armillary.program.scalarise import scalarise
from armillary.verify.identities import text_book_expression


@pytest.fixture
def d():
    d = Derivation("facets", title="Facets")
    facet = d.index("facet", 4)
    d.constant("phi", (0, degrees(90), degrees(180), degrees(270)), "azimuth", per=facet)
    d.angle("alpha", "azimuth of the sun")
    d.angle("beta", "of each", per=facet)
    return d


def kernel(d, value):
    inputs = [d.quantities["alpha"], d.quantities["beta"]]
    d.kernel("k", inputs=inputs, outputs={"y": value})
    return d.kernels["k"]


def trigonometry(program):
    return cost(program).trigonometry


def test_one_sine_and_cosine_serve_all_parts(d):
    alpha, phi = d.quantities["alpha"], d.constants["phi"]
    k = kernel(d, sin(alpha - phi) * cos(phi - alpha) + atan2(alpha, 1 + alpha * alpha))
    plain = scalarise(lower(k, Strategy()))
    assert trigonometry(plain) == 8
    assert trigonometry(open_angle_sums(plain)) == 2
    made = compile_kernel(k)
    assert made.cost.trigonometry == 2
    (found,) = text_book_expression(k, made.program)
    assert found.passed


def test_an_angle_of_each_part_keeps_its_own_trigonometry(d):
    beta, phi = d.quantities["beta"], d.constants["phi"]
    plain = scalarise(lower(kernel(d, sin(beta + phi)), Strategy()))
    assert open_angle_sums(plain).instructions == plain.instructions


def test_what_has_no_loop_stays_as_it_is(d):
    alpha = d.quantities["alpha"]
    value = substitute(sin(alpha + d.constants["phi"]), {d.constants["phi"]: degrees(90)})
    plain = scalarise(lower(kernel(d, value), Strategy()))
    assert open_angle_sums(plain) is plain
