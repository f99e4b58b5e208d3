"""Where a unit vector is normalised, and directions, which need no normalising."""

import pytest

from armillary import Chain, Derivation, X, Y, Z, direction_angles, partial, unit, vector
from armillary.algebra.direction import AzimuthSine
from armillary.program.arithmetic import Reals
from armillary.program.compile import compile_kernel
from armillary.program.cost import cost
from armillary.program.evaluate import evaluate
from armillary.program.lower import Strategy, decisions, lower
from armillary.program.passes import PASSES
from armillary.program.scalarise import scalarise
from armillary.program.search import cheapest
from armillary.program.strategy import NORMALISED
from tests.programs import exact, kernel_of

record = Derivation("directions", title="Directions")
a, b = record.angle("a", "first turn"), record.angle("b", "second turn")
m = record.vector("m", "a vector that is not normalised")
INPUTS = [a, b, m]
POINT = exact({"a": 0.7, "b": -1.9, "m": [0.3, -2.0, 1.7]})
turns = Chain("ground").rotate(Z, a).rotate(X, b).rotate(Y, a, frame="tip")
R = turns.rotation("ground", "tip")
shifted = m + vector(0, 0, 9)


def found(outputs):
    return cost(cheapest(kernel_of(record, INPUTS, outputs)).program)


def both_ways(outputs):
    """What each place of normalising costs, after a check that they agree."""
    kernel = kernel_of(record, INPUTS, outputs)
    nodes = [d.node for d in decisions(kernel, Strategy(), {}) if set(d.options) <= set(NORMALISED)]
    assert nodes
    costs, values = [], []
    for option in NORMALISED:
        program = lower(kernel, Strategy(), dict.fromkeys(nodes, option))
        values.append(flat(evaluate(program, POINT, Reals()).results))
        for step in (scalarise, *PASSES):
            program = step(program)
        costs.append(cost(program).weighted)
    assert all(abs(p - q) < 1e-40 for p, q in zip(*values, strict=True))
    return costs


def flat(results):
    values = []
    for value in results.values():
        values += value if isinstance(value, list) else [value]
    return values


n = R @ unit(shifted)
azimuth, elevation = direction_angles(n)
CASES = {
    "a turned normal": {"n": n},
    "its angles": {"azimuth": azimuth, "elevation": elevation},
    "both": {"n": n, "azimuth": azimuth, "elevation": elevation},
    "the opposite": {"n": -n, "azimuth": direction_angles(-n)[0]},
    "the opposite inside": {"n": R @ -unit(shifted)},
    "in two frames": {"n": n, "k": turns.rotation("tip", "ground") @ n},
    "in its own frame too": {"n": n, "m": unit(shifted)},
    "normalised twice": {"n": R @ unit(R @ unit(shifted)), "azimuth": azimuth},
    "of another unit vector": {"e": direction_angles(unit(n + vector(0, 0, 3)))[1], "n": n},
    "with a derivative": {"n": n, "J": partial(azimuth, a), "K": partial(elevation, b)},
    "with a derivative's own": {"n": n, "s": partial(AzimuthSine(n), b)},
}


@pytest.mark.parametrize("outputs", CASES.values(), ids=list(CASES))
def test_both_places_give_the_same(outputs):
    both_ways(outputs)
    compile_kernel(kernel_of(record, INPUTS, outputs))


def test_a_direction_is_not_normalised():
    """Of a unit vector or a turned one: the root is that of the horizontal length."""
    plain = direction_angles(shifted)
    for vector_ in (unit(shifted), record_name("s", unit(shifted))):
        angles = direction_angles(vector_)
        assert found({"r": angles[0], "s": angles[1]}) == found({"r": plain[0], "s": plain[1]})
    turned = direction_angles(R @ shifted)
    assert found({"r": azimuth, "s": elevation}) == found({"r": turned[0], "s": turned[1]})


def record_name(name, expression):
    return record.define(name, expression, because="so that it has a name")


def test_the_horizontal_length_is_shared_with_the_norm():
    """Normalised last, rho^2 is part of |w|^2; normalised first, it is three operations more."""
    first, last = both_ways(CASES["both"])
    assert last == first - 3
    assert found(CASES["both"]).weighted == last


def test_a_unit_vector_that_is_wanted_itself_is_normalised_once():
    once = found({"m": unit(shifted)})
    both = found(CASES["in its own frame too"])
    assert (both.divide, both.sqrt) == (once.divide, once.sqrt) == (1, 1)


def test_the_plainest_place_wins_ties():
    kernel = kernel_of(record, INPUTS, {"n": n})
    assert not cheapest(kernel).local


def test_each_vector_is_decided_once():
    kernel = kernel_of(record, INPUTS, CASES["with a derivative"])
    nodes = [d.node for d in decisions(kernel, Strategy(), {})]
    assert len(nodes) == len(set(nodes))
