"""Every derivative rule against SymPy's own differentiation and against dual numbers."""

import pytest
import sympy
from hypothesis import given

from armillary import (
    absolute,
    arccos,
    arcsin,
    atan2,
    cos,
    direction_angles,
    sin,
    sqrt,
    time_derivative,
    unit,
    where,
)
from armillary.algebra.derivative import partial
from armillary.algebra.direction import AzimuthCosine, AzimuthSine, ElevationTangent
from armillary.algebra.explicit import Explicit, symbol, vector_symbol
from armillary.algebra.rotation import elementary
from armillary.algebra.vector import choice, vector
from armillary.program.arithmetic import Reals
from armillary.program.evaluate import evaluate
from armillary.verify.exact import directional_derivative, numbers
from tests.expressions import INPUTS, SCALARS, VECTORS, c, record, x, y
from tests.programs import opened

POINT = {
    "x": 0.7, "y": -1.3, "c": [0.3, -0.8, 0.5],
    "x_dot": 0.9, "y_dot": -0.4, "c_dot": [0.2, 0.6, -0.1],
}  # fmt: skip
RATES = {"x": 0.9, "y": -0.4, "c": [0.2, 0.6, -0.1]}

turned = elementary(2, x) @ (elementary(0, -y) @ c)
carried = elementary(1, y) @ unit(elementary(0, x) @ c + vector(x, 2, 1))
axis = elementary(0, x) @ -(elementary(1, y) @ vector(1, -2, 1))
SCALAR_RULES = {
    "sum": x + y,
    "product": x * y * x,
    "quotient": x / (2 + cos(y)),
    "root": sqrt(3 + sin(x)),
    "length": turned.norm(),
    "sine of a sum": sin(x + 2 * y),
    "cosine": cos(x * y),
    "atan2": atan2(sin(x), 3 + y),
    "arc sine": arcsin("0.9" * sin(x * y)),
    "arc cosine": arccos("0.9" * sin(x * y)),
    "absolute": absolute(y) * x,
    "select": where(x < y, sin(x), cos(y)),
    "component": turned.y,
    "dot": turned.dot(c),
    "square of a vector": (turned + c).dot(turned + c),
    "azimuth": direction_angles(turned)[0],
    "elevation": direction_angles(turned)[1],
    "azimuth of a unit vector": direction_angles(unit(turned))[0],
    "elevation of a sum": direction_angles(turned + c)[1],
    "elevation of a unit vector": direction_angles(unit(turned))[1],
    "azimuth of a turned unit vector": direction_angles(carried)[0],
    "elevation of a turned unit vector": direction_angles(carried)[1],
    "azimuth, the other way round": direction_angles(-carried)[0],
    "elevation, the other way round": direction_angles(-carried)[1],
    "azimuth of an axis": direction_angles(axis)[0],
    "elevation of an axis": direction_angles(axis)[1],
    "sine of the azimuth": AzimuthSine(carried),
    "cosine of the azimuth": AzimuthCosine(turned),
    "tangent of the elevation": ElevationTangent(carried),
    "rate of an azimuth": partial(direction_angles(carried)[0], x),
    "rate of an elevation": partial(direction_angles(carried)[1], y),
    "rate of an axis's azimuth": partial(direction_angles(axis)[0], x),
    "rate of an axis's elevation": partial(direction_angles(axis)[1], y),
}
VECTOR_RULES = {
    "components": vector(sin(x), x * y, 1),
    "sum": turned + c,
    "negation": -turned,
    "scaled": sin(x) * turned,
    "cross": turned.cross(c),
    "unit": unit(turned + c),
    "rotated about x": elementary(0, x) @ c,
    "rotated about y": elementary(1, x * y) @ c,
    "rotated about z": elementary(2, -x) @ c,
    "three turns": elementary(1, y) @ turned,
    "choice": choice(turned, elementary(2, x) @ elementary(0, -y) @ c, turned),
}
_TIMES = {
    **{symbol(q): symbol(f"{q}_dot") for q in ("x", "y")},
    **dict(zip(vector_symbol("c"), vector_symbol("c_dot"), strict=True)),
}
_NUMBERS = {
    **{symbol(q): POINT[q] for q in ("x", "y", "x_dot", "y_dot")},
    **{s: n for q in ("c", "c_dot") for s, n in zip(vector_symbol(q), POINT[q], strict=True)},
}


def by_sympy(expression):
    """Time derivative by SymPy of the explicit form, as floats."""
    form = sympy.Matrix([Explicit()(expression)])
    rate = sum((form.diff(q) * q_dot for q, q_dot in _TIMES.items()), sympy.zeros(*form.shape))
    return [float(e) for e in rate.subs(_NUMBERS).evalf(30)]


def by_rule(derivative):
    program = opened(record, INPUTS, {"r": derivative})
    found = evaluate(program, numbers(Reals(), POINT), Reals()).results["r"]
    return [float(f) for f in (found if isinstance(found, list) else [found])]


def by_duals(expression):
    program = opened(record, INPUTS, {"r": expression})
    found = directional_derivative(program, POINT, RATES).results["r"]
    return [float(f.slope) for f in (found if isinstance(found, list) else [found])]


@pytest.mark.parametrize("name", SCALAR_RULES)
def test_scalar_rule(name):
    expression = SCALAR_RULES[name]
    found = by_rule(time_derivative(expression))
    assert found == pytest.approx(by_sympy(expression), rel=1e-13, abs=1e-14)
    assert found == pytest.approx(by_duals(expression), rel=1e-13, abs=1e-14)


@pytest.mark.parametrize("name", VECTOR_RULES)
def test_vector_rule(name):
    expression = VECTOR_RULES[name]
    found = by_rule(time_derivative(expression))
    assert found == pytest.approx(by_sympy(expression), rel=1e-13, abs=1e-14)
    assert found == pytest.approx(by_duals(expression), rel=1e-13, abs=1e-14)


@pytest.mark.parametrize("name", SCALAR_RULES)
def test_partial_derivative(name):
    expression = SCALAR_RULES[name]
    form = Explicit()(expression).diff(symbol("x")).subs(_NUMBERS).evalf(30)
    assert by_rule(partial(expression, x))[0] == pytest.approx(float(form), rel=1e-13, abs=1e-14)


@given(SCALARS)
def test_random_scalars(expression):
    found = by_rule(time_derivative(expression))
    assert found == pytest.approx(by_duals(expression), rel=1e-12, abs=1e-12)


@given(VECTORS)
def test_random_vectors(expression):
    found = by_rule(time_derivative(expression))
    assert found == pytest.approx(by_duals(expression), rel=1e-12, abs=1e-12)


def test_a_constant_does_not_move():
    assert by_rule(time_derivative(x * 0 + 3)) == [0.0]


def test_a_derivative_that_has_a_name_is_taken_by_it():
    """Where a value is met again its derivative is not worked out anew, nor checked."""
    square, arm = x * y, vector(x, y, 0)
    told, said = sin(x), vector(y, 0, 1)
    sine = float(sympy.sin(0.7))
    for known, expression, wanted in (
        ({square: told}, 2 * square, 2 * sine),
        ({square: told}, cos(square), float(sympy.sin(0.7 * 1.3)) * sine),
        ({arm: said}, arm.dot(arm), 2 * 0.7 * -1.3),
    ):
        assert by_rule(time_derivative(expression, known)) == pytest.approx([wanted])
    assert by_rule(partial(square + x, x, {square: told})) == pytest.approx([sine + 1])
    assert by_rule(partial(cos(square), x, {square: x * 0})) == [0.0]
