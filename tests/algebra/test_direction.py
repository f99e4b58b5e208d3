"""Direction angles: turned as a whole, without the length of the vector."""

import pytest
import sympy

from armillary import Chain, Derivation, X, Y, Z, direction_angles, partial, time_derivative, unit
from armillary.algebra.derivative import Differentiator, of_time
from armillary.algebra.direction import (
    AzimuthCosine,
    AzimuthSine,
    ElevationTangent,
    is_unit,
    normalised_in,
)
from armillary.algebra.explicit import Explicit
from armillary.algebra.rotation import elementary
from armillary.algebra.scalar import is_zero
from armillary.algebra.vector import VectorReference, is_null, vector
from armillary.derivation.symbols import leaves
from armillary.derivation.units import METRE, ONE, RADIAN, check_block
from armillary.program.arithmetic import Floats
from armillary.program.cost import cost
from armillary.program.evaluate import evaluate
from armillary.program.search import cheapest
from armillary.site.notation import Notation
from armillary.site.structure import Structure
from tests.expressions import c, record, x, y
from tests.programs import kernel_of, opened

NODES = (AzimuthSine, AzimuthCosine, ElevationTangent)


def found_cost(value):
    inputs = [x, y, c, x.rate(), y.rate(), c.rate()]
    return cost(cheapest(kernel_of(record, inputs, {"r": value})).program)


def test_a_column_of_the_jacobian_is_a_cross_product_with_the_axis():
    """About x: d(elevation) = cos(az), d(azimuth) = tan(el) sin(az), and nothing else."""
    held = elementary(0, x) @ (elementary(2, y) @ unit(c))
    azimuth, elevation = direction_angles(held)
    assert found_cost(partial(elevation, x)) == found_cost(AzimuthCosine(held))
    product = ElevationTangent(held) * AzimuthSine(held)
    assert found_cost(partial(azimuth, x)) == found_cost(product)
    assert found_cost(product).sqrt == found_cost(product).divide == 1


def test_a_turn_about_the_vertical_turns_the_azimuth_alone():
    azimuth, elevation = direction_angles(elementary(2, x) @ c)
    assert Explicit()(partial(azimuth, x)) == -1
    assert is_zero(partial(elevation, x))


HORIZON = {(0, 1, 0): (0, 1), (1, 0, 0): (0, 0), (0, -1, 0): (0, -1), (-1, 0, 0): (0, 0)}


@pytest.mark.parametrize("place", HORIZON)
def test_the_horizon_is_regular_all_around(place):
    """North, east, south and west: the tilt about east (azimuth's rate, elevation's rate)."""
    azimuth, elevation = direction_angles(elementary(0, x) @ unit(c))
    program = opened(record, [x, c], {"a": partial(azimuth, x), "e": partial(elevation, x)})
    found = evaluate(program, {"x": 0.0, "c": place}, Floats()).results
    assert (found["a"], found["e"]) == HORIZON[place]


def test_the_rate_of_a_moving_direction_takes_one_root():
    """A unit vector that moves: its length is neither computed nor differentiated."""
    moving = elementary(2, x) @ unit(elementary(0, -y) @ c + vector(0, 0, 9))
    for angle in direction_angles(moving):
        assert found_cost(time_derivative(angle)).sqrt == 1


def test_a_vector_held_in_its_frame_only_spins():
    d = Differentiator(of_time)
    held = elementary(2, x) @ unit(vector(1, 2, 3))
    assert is_null(d.turning(held).slip)
    assert not is_null(d.turning(held).spin)
    assert not is_null(d.turning(elementary(2, x) @ c).slip)


def test_what_is_not_normalised_stays_shared():
    """The motion speaks of the vector that was written, not of a copy."""
    d = Differentiator(of_time)
    named = VectorReference("n", "random-n", elementary(2, x) @ -c)
    assert d.turning(named).along is named
    assert d.turning(unit(named)).along is named
    assert d.turning(-named).along is not named


@pytest.mark.parametrize("node", NODES)
def test_explicit_forms(node):
    """sin, cos and tan of the angles, as SymPy has them."""
    azimuth, elevation = (Explicit()(angle) for angle in direction_angles(c))
    wanted = {
        AzimuthSine: sympy.sin(azimuth),
        AzimuthCosine: sympy.cos(azimuth),
        ElevationTangent: sympy.tan(elevation),
    }[node]
    assert sympy.simplify(Explicit()(node(c)) - wanted) == 0


def test_units():
    d = Derivation("lengths", title="Lengths")
    arm = d.vector("arm", "an arm", unit=METRE)
    assert all(check_block(angle) == RADIAN for angle in direction_angles(arm))
    assert all(check_block(node(arm)) == ONE for node in NODES)


@pytest.mark.parametrize("node", NODES)
def test_leaves_are_those_of_the_vector(node):
    assert leaves(node(elementary(2, x) @ c)) == [x, c]


def test_as_printed():
    text = Structure(Notation(record))
    across = r"\sqrt{{\mathbf{c}_{x}}^2 + {\mathbf{c}_{y}}^2}"
    assert text(AzimuthSine(c)) == rf"\frac{{\mathbf{{c}}_{{x}}}}{{{across}}}"
    assert text(ElevationTangent(c)) == rf"\frac{{\mathbf{{c}}_{{z}}}}{{{across}}}"


def test_where_a_vector_is_normalised():
    normal = unit(c)
    attitude = Chain("a").rotate(X, x).rotate(Y, y).rotate(Z, x, frame="b").rotation("a", "b")
    assert normalised_in(attitude @ -(elementary(0, y) @ normal)) is normal
    assert normalised_in(attitude @ c) is None
    assert normalised_in(2 * normal) is None
    assert is_unit(attitude @ normal)
