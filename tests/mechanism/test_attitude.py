"""Tilts without torsion, against chains of turns and against finite turns in NumPy."""

import numpy as np
import pytest
import sympy

from armillary import Chain, Derivation, Y, Z, tilted, tilting, time_derivative, vector
from armillary.algebra.explicit import Explicit, reduce_trigonometry
from armillary.algebra.vector import Basis
from armillary.mechanism.attitude import Axes
from tests.programs import program_of, value_of

POINTS = [{"a": 0.4, "b": 0.9}, {"a": -2.5, "b": 2.9}, {"a": 1.0, "b": 0.0}]


@pytest.fixture
def tilt():
    """A record, its angles, and the frame that Rz(a) Ry(b) Rz(-a) makes."""
    d = Derivation("tilt", title="Tilt")
    a, b = d.angle("a", "towards"), d.angle("b", "by")
    a.rate(), b.rate()
    return d, a, b, Chain("base").rotate(Z, a).rotate(Y, b).rotate(Z, -a, frame="top")


def test_a_tilt_follows_from_its_normal_alone(tilt):
    """Rz(a) Ry(b) Rz(-a) is the tilt of its own third axis, for all angles."""
    _, _, _, chain = tilt
    turned = chain.rotation("base", "top")
    made = tilted(turned.column(2)).matrix()
    explicit = Explicit()
    difference = explicit(made) - explicit(turned)
    assert all(reduce_trigonometry(e) == 0 for e in difference)
    assert any(e != 0 for e in explicit(made) - sympy.eye(3))


def test_it_turns_as_the_chain_of_turns_does(tilt):
    d, a, b, chain = tilt
    n = chain.rotation("base", "top").column(2)
    rates = [a.rate(), b.rate()]
    outputs = {
        "tilt": tilting(n, time_derivative(n)),
        "known": tilting(n, time_derivative(n), 1 + n.z),
        "chain": chain.angular_velocity("top"),
    }
    program = program_of(d, [a, b, *rates], outputs)
    for point in POINTS:
        point = {**point, "a_dot": 0.7, "b_dot": -0.3}
        wanted = np.array(value_of(program, point, "chain"))
        assert np.linalg.norm(wanted) > 0.2
        for name in ("tilt", "known"):
            np.testing.assert_allclose(value_of(program, point, name), wanted, atol=1e-13)


def test_axes_carry_vectors_as_the_rotation_does(tilt):
    d, a, b, chain = tilt
    turned = chain.rotation("base", "top")
    axes = Axes(*(turned.column(k) for k in range(3)))
    inner = vector(0.3, -1.2, 2.0)
    outputs = {
        "axes": axes @ inner, "turned": turned @ inner, "back": axes.back(turned @ inner),
        "flat": axes @ vector(0, 2, 0), "basis": axes @ Basis(1),
    }  # fmt: skip
    program = program_of(d, [a, b], outputs)
    for point in POINTS:
        found = {name: np.array(value_of(program, point, name)) for name in outputs}
        np.testing.assert_allclose(found["axes"], found["turned"], atol=1e-15)
        np.testing.assert_allclose(found["back"], [0.3, -1.2, 2.0], atol=1e-15)
        np.testing.assert_allclose(found["flat"], 2 * found["basis"], atol=1e-15)
