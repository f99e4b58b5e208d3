"""The evaluator on reals, floats and dual numbers; statuses and guards."""

import math

import mpmath
import pytest
from hypothesis import given

from armillary import Derivation, Status, absolute, atan2, cos, sin, sqrt, where
from armillary.algebra.explicit import Explicit
from armillary.program.arithmetic import Floats, Reals
from armillary.program.compile import compile_kernel
from armillary.program.evaluate import evaluate, guard_status
from armillary.verify import exact
from tests.expressions import INPUTS, SCALARS, VECTORS, record, x, y
from tests.programs import kernel_of, opened

POINT = {
    "x": 0.7, "y": -1.3, "c": [0.3, -0.8, 0.5],
    "x_dot": 0.9, "y_dot": -0.4, "c_dot": [0.2, 0.6, -0.1],
}  # fmt: skip
FUNCTIONS = {
    "sine": (sin(x), math.sin(0.7)),
    "cosine": (cos(y), math.cos(-1.3)),
    "root": (sqrt(x), math.sqrt(0.7)),
    "atan2": (atan2(y, x), math.atan2(-1.3, 0.7)),
    "quotient": (x / y, 0.7 / -1.3),
    "absolute": (absolute(y), 1.3),
    "then": (where(y < x, x, y), 0.7),
    "otherwise": (where(x < y, x, y), -1.3),
    "both": (where((y < x) & ~(x < y), x, y), 0.7),
    "decimal": (x * 0 + "0.1", 0.1),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_reals_and_floats(name):
    expression, wanted = FUNCTIONS[name]
    program = opened(record, INPUTS, {"r": expression})
    assert evaluate(program, POINT, Floats()).results["r"] == pytest.approx(wanted, rel=1e-15)
    assert float(exact.run(program, POINT, Reals()).results["r"]) == pytest.approx(
        wanted, rel=1e-15
    )


def test_fifty_digits_and_no_global_precision():
    before = mpmath.mp.dps
    root = exact.run(opened(record, INPUTS, {"r": sqrt(x * 0 + 2)}), POINT, Reals()).results["r"]
    with mpmath.workdps(60):
        assert abs(mpmath.mpf(root) - mpmath.sqrt(2)) < mpmath.mpf("1e-49")
    assert mpmath.mp.dps == before


@pytest.mark.parametrize(
    ("expression", "slope"),
    [
        (sin(x), math.cos(0.7)),
        (cos(x), -math.sin(0.7)),
        (sqrt(x), 0.5 / math.sqrt(0.7)),
        (x / (1 + x), 1 / 1.7**2),
        (atan2(x, 2), 2 / (4 + 0.49)),
        (atan2(2, x), -2 / (4 + 0.49)),
        (absolute(-x), 1.0),
        (where(x < 1, x * x, x), 1.4),
        (y * y, 0.0),
    ],
)
def test_dual_numbers_against_calculus(expression, slope):
    program = opened(record, INPUTS, {"r": expression})
    found = exact.directional_derivative(program, POINT, {"x": 1.0}).results["r"]
    assert float(found.slope) == pytest.approx(slope, rel=1e-15)


@given(SCALARS)
def test_dual_numbers_against_differences(expression):
    """Central differences at 50 digits share nothing with dual numbers or rules."""
    program = opened(record, INPUTS, {"r": expression})
    reals = Reals()
    slope = exact.directional_derivative(program, POINT, {"x": 1.0}).results["r"].slope
    step = reals.number("1e-12")
    ends = []
    for way in (step, -step):
        point = exact.numbers(reals, POINT)
        point["x"] += way
        ends.append(evaluate(program, point, reals).results["r"])
    difference = (ends[0] - ends[1]) / (2 * step)
    assert abs(difference - slope) <= 1e-12 * (1 + abs(slope)) * 10


@given(VECTORS)
def test_the_text_book_form_has_the_same_values(expression):
    kernel = kernel_of(record, INPUTS, {"r": expression})
    found = exact.run(compile_kernel(kernel).program, POINT, Reals()).results["r"]
    assert exact.worst(found, exact.text_book(expression)(POINT)) < 1e-40
    assert Explicit()(expression).shape == (3, 1)


def cases(*conditions):
    d = Derivation("cases", title="Cases")
    t = d.angle("t", "an angle")
    made = [(status, build(t), "for the test") for status, build in conditions]
    d.kernel("k", inputs=[t], outputs={"r": 2 * t}, cases=made)
    return compile_kernel(d.kernels["k"]).program


def status(program, t):
    return evaluate(program, {"t": t}, Floats())


def test_positive_statuses_keep_the_results():
    program = cases((Status.SINGULAR, lambda t: t < 1), (Status.CLAMPED, lambda t: t < 2))
    assert [status(program, t).status for t in (0.0, 1.5, 3.0)] == [2, 1, 0]
    assert status(program, 1.5).results == {"r": 3.0}


def test_negative_statuses_have_no_results():
    program = cases(
        (Status.LIMIT, lambda t: t < 3),
        (Status.UNREACHABLE, lambda t: t < 1),
        (Status.NOT_CONVERGED, lambda t: t < 0),
    )
    assert [status(program, t).status for t in (2.0, 0.5, -1.0)] == [5, -3, -4]
    assert status(program, 0.5).results == {}


def guarded():
    d = Derivation("guards", title="Guards")
    t, length = d.angle("t", "an angle"), d.length("L", "a length")
    n, v = d.unit_vector("n", "a direction"), d.vector("v", "a vector")
    d.kernel("k", inputs=[t, length, n, v], outputs={"r": t + n.x + v.x})
    return compile_kernel(d.kernels["k"]).program.guards


GOOD = {"t": 1.0, "L": 1.0, "n": [0.6, 0.0, 0.8], "v": [1.0, 2.0, 3.0]}


@pytest.mark.parametrize(
    ("change", "wanted"),
    [
        ({}, 0),
        ({"t": 1000.0}, 0),
        ({"t": 1000.1}, -2),
        ({"t": math.inf}, -1),
        ({"t": math.nan}, -1),
        ({"L": 0.0}, 0),
        ({"L": -1e-9}, -2),
        ({"L": 2e6}, -2),
        ({"n": [0.6, 0.0, 0.81]}, -2),
        ({"n": [0.0, 0.0, 0.0]}, -2),
        ({"n": [0.6, 0.0, 0.8002]}, 0),
        ({"n": [math.nan, 0.0, 1.0]}, -1),
        ({"v": [0.0, math.inf, 0.0]}, -1),
        ({"t": math.nan, "L": -1.0}, -2),
    ],
)
def test_guards(change, wanted):
    assert guard_status(guarded(), GOOD | change) == wanted


def test_no_angle_and_no_order_of_what_is_not_real():
    root = sqrt(x - y)
    for made in (atan2(root, 1 + y * y), where(root < x, x, y)):
        program = opened(record, INPUTS, {"r": made})
        point = {name: Reals().number(v) for name, v in {"x": 0.5, "y": 0.7}.items()}
        with pytest.raises(TypeError):
            evaluate(program, {**POINT, **point}, Reals())
