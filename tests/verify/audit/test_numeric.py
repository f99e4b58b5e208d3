"""Values of nodes: the same as the text-book form, in doubles and with 50 digits."""

import inspect

import mpmath
import numpy as np
import pytest
from hypothesis import given

from armillary import (
    Derivation,
    absolute,
    atan2,
    cos,
    direction_angles,
    elementary,
    sin,
    sqrt,
    where,
)
from armillary.algebra import direction, indexed, iteration, rotation, scalar, vector
from armillary.algebra.direction import AzimuthCosine, AzimuthSine, ElevationTangent
from armillary.derivation.entries import rows_of
from armillary.verify.audit.numbers import Digits, Doubles
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.points import exact, quantities, sample
from armillary.verify.exact import text_book
from armillary.verify.points import rows_of as points_of
from tests.expressions import SCALARS, VECTORS


def worst(block) -> tuple[float, float]:
    """Largest relative error of doubles and of 50 digits against SymPy at 50 digits."""
    known = quantities(block)
    points = sample(known, 4, 1) if known else {}
    entries = [entry for row in rows_of(block) for entry in row]
    doubles = Values(Doubles(), points)
    system = Digits()
    digits = Values(system, {q: system.array(a) for q, a in points.items()})
    wanted = [
        value
        for row in points_of({q.name: a for q, a in points.items()})
        for value in text_book(block)(row)
    ]
    count = max(1, len(wanted) // len(entries))

    def error(values):
        found = [values.array(e)[k if known else 0] for k in range(count) for e in entries]
        pairs = zip(found, wanted, strict=True)
        return max(abs(mpmath.mpf(f) - w) / max(1, abs(w)) for f, w in pairs)

    with mpmath.workdps(60):
        return float(error(doubles)), float(error(digits))


@given(SCALARS)
def test_scalars_have_the_values_of_the_text_book(node):
    doubles, digits = worst(node)
    assert doubles < 1e-12
    assert digits < 1e-45


@given(VECTORS)
def test_vectors_have_the_values_of_the_text_book(node):
    doubles, digits = worst(node)
    assert doubles < 1e-12
    assert digits < 1e-45


@pytest.fixture
def d():
    return Derivation("nodes", title="Nodes")


def test_directions_and_named_rotations(d):
    a, u = d.angle("a", "angle"), d.unit_vector("u", "direction")
    R = d.rotation("R", "attitude")
    turned = R @ elementary(1, a) @ R.transpose()
    azimuth, elevation = direction_angles(turned @ u)
    for node in (turned, turned.matrix(), azimuth, elevation, AzimuthSine(u), AzimuthCosine(u),
                 ElevationTangent(turned @ u), absolute(u.x) * sqrt(2 + a * a)):  # fmt: skip
        doubles, digits = worst(node)
        assert doubles < 1e-12, node
        assert digits < 1e-40, node


RULES = vars(Values)["value"].dispatcher


def test_every_node_has_values(d):
    """A node that is added without a rule, and knows no explicit form, is found here."""
    open_ = []
    for module in (scalar, vector, direction, rotation, indexed, iteration):
        for cls in vars(module).values():
            bases = (scalar.Scalar, scalar.Condition, vector.Vector)
            if inspect.isclass(cls) and issubclass(cls, bases) and cls not in bases:
                default = RULES.dispatch(object)
                ruled = RULES.dispatch(cls) is not default
                if not ruled and not hasattr(cls, "explicit"):
                    open_.append(cls.__name__)
    assert open_ == []


def test_what_is_not_real_is_nan(d):
    a = d.angle("a", "angle")
    values = Values(Doubles(), {a: np.array([-1.0, 4.0])})
    digits = Values(Digits(), {a: np.array([-1.0, 0.0])})
    assert np.isnan(values.array(sqrt(a))[0])
    assert values.array(sqrt(a))[1] == 2
    assert mpmath.isnan(digits.array(sqrt(a))[0])
    assert mpmath.isnan(digits.array(1 / a)[1])


def test_the_side_of_a_choice_that_is_not_taken_may_be_nan(d):
    a = d.angle("a", "angle")
    values = Values(Doubles(), {a: np.array([-1.0, 4.0])})
    assert list(values.array(where(a < 0, 7, sqrt(a)))) == [7, 2]


def test_trials_are_forgotten(d):
    a = d.angle("a", "angle")
    values = Values(Doubles(), {a: np.array([0.5])})
    kept = sin(a)
    values.array(kept)
    before = len(values._done)
    with values.trying():
        assert values.array(kept + cos(a))[0] == np.sin(0.5) + np.cos(0.5)
    assert len(values._done) == before


def test_directions_are_brought_to_norm_1_with_all_digits(d):
    u, R = d.unit_vector("u", "direction"), d.rotation("R", "attitude")
    system = Digits()
    points = exact(sample([u, R], 3, 1), system)
    values = Values(system, points)
    assert max(abs(values.array(u.dot(u)) - 1)) < 1e-55
    lengths = values.array((R @ u).dot(R @ u))
    assert max(abs(lengths - 1)) < 1e-55
    assert max(abs(values.array(atan2(u.y, u.y)))) < 3
