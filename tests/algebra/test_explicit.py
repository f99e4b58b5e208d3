"""The text-book form: matrices entry by entry, and the normal form that proves identities."""

import math

import mpmath
import pytest
import sympy

from armillary import Derivation, hat, sin, vee, where
from armillary.algebra.explicit import Explicit, elementary_matrix, reduce_trigonometry, symbol
from armillary.algebra.rigid import Pose, Twist, Wrench
from armillary.algebra.rotation import IDENTITY, elementary
from armillary.algebra.scalar import Symbol
from armillary.algebra.vector import VectorSymbol, vector

a, b = sympy.symbols("a b", real=True)
A, B = Symbol("a"), Symbol("b")
U, V = VectorSymbol("u"), VectorSymbol("v")


def zero(matrix):
    return all(reduce_trigonometry(e) == 0 for e in matrix)


def test_elementary_rotations_turn_right_handed():
    quarter = sympy.pi / 2
    e = sympy.eye(3)
    for axis in range(3):
        turn = elementary_matrix(axis, quarter)
        assert turn * e[:, (axis + 1) % 3] == e[:, (axis + 2) % 3]
        assert turn * e[:, axis] == e[:, axis]


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_elementary_matrix_is_the_exponential_of_its_axis(axis):
    skew = sympy.Matrix(Explicit()(hat(vector(*(int(k == axis) for k in range(3))))))
    assert elementary_matrix(axis, a).diff(a) == elementary_matrix(axis, a) * skew


def test_a_transpose_is_the_inverse():
    rotation = elementary(2, A) @ elementary(0, -B) @ elementary(1, A)
    explicit = Explicit()
    product = explicit(rotation) * explicit(rotation.transpose())
    assert zero(product - sympy.eye(3))


def test_a_pose_times_its_inverse_is_one():
    pose = Pose(elementary(2, A) @ elementary(0, B), U)
    explicit = Explicit()
    assert zero(explicit(pose) * explicit(pose.inverse()) - sympy.eye(4))
    assert zero(explicit(pose @ pose.inverse()) - sympy.eye(4))
    assert zero(explicit(pose.matrix()) - explicit(pose))


def test_hat_is_the_cross_product_and_vee_undoes_it():
    explicit = Explicit()
    assert explicit(hat(U)) * explicit(V) == explicit(U.cross(V))
    assert explicit(vee(hat(U))) == explicit(U)


def test_power_is_the_same_about_every_point():
    """Moved to another point, a twist and a wrench still meet in one power."""
    offset = VectorSymbol("d")
    force, moment = VectorSymbol("f"), VectorSymbol("n")
    here = Wrench(moment, force).power(Twist(U, V).at(offset))
    there = Wrench(moment + offset.cross(force), force).power(Twist(U, V))
    assert reduce_trigonometry(Explicit()(here) - Explicit()(there)) == 0


def test_named_keeps_the_names():
    d = Derivation("names", title="Names")
    t = d.angle("t", "an angle")
    twice = d.define("twice", 2 * t, because="for the test")
    assert Explicit(named=True)(twice + t) == symbol("twice") + symbol("t")
    assert Explicit()(twice + t) == 3 * symbol("t")


def test_identity_rotation():
    assert Explicit()(IDENTITY) == sympy.eye(3)


ZEROS = [
    sympy.sin(a) ** 2 + sympy.cos(a) ** 2 - 1,
    sympy.sin(a + b) - sympy.sin(a) * sympy.cos(b) - sympy.cos(a) * sympy.sin(b),
    sympy.sin(2 * a) - 2 * sympy.sin(a) * sympy.cos(a),
    sympy.sin(-a) + sympy.sin(a),
    sympy.cos(-a) - sympy.cos(a),
    (sympy.sin(a) ** 4 - sympy.cos(a) ** 4) - (sympy.sin(a) ** 2 - sympy.cos(a) ** 2),
    sympy.sin(a) / (2 + sympy.cos(b)) - sympy.sin(a) / (2 + sympy.cos(b)),
    1 / (1 + sympy.cos(a)) - (1 - sympy.cos(a)) / sympy.sin(a) ** 2,
]
OTHERS = [
    sympy.sin(a) ** 2 - sympy.cos(a) ** 2 - 1,
    sympy.sin(a + b) - sympy.sin(a) * sympy.cos(b) + sympy.cos(a) * sympy.sin(b),
    sympy.sin(a) * sympy.cos(b) - sympy.sin(b) * sympy.cos(a),
]


@pytest.mark.parametrize("expression", ZEROS)
def test_zero_is_found(expression):
    assert reduce_trigonometry(expression) == 0


@pytest.mark.parametrize("expression", OTHERS)
def test_what_is_not_zero_stays(expression):
    assert reduce_trigonometry(expression) != 0


def test_a_choice_by_a_long_condition_is_left_as_it_is():
    """SymPy would simplify the condition; its value is that of the side it chooses all the same."""
    long = A
    for k in range(7):
        long = sin(long + k) * where(k > A, long, B)
    chosen = Explicit()(1 / where(long < 0, A, long + 2))
    assert not isinstance(1 / chosen, sympy.Piecewise)
    names = sorted(chosen.free_symbols, key=str)
    value = sympy.lambdify(names, chosen, modules="mpmath", cse=True)
    for point in ((0.3, 1.2), (-0.7, 2.0), (5.1, 0.4)):
        wanted = point[0]
        for k in range(7):
            wanted = math.sin(wanted + k) * (wanted if point[0] < k else point[1])
        wanted = 1 / (point[0] if wanted < 0 else wanted + 2)
        assert float(value(*map(mpmath.mpf, point))) == pytest.approx(wanted, rel=1e-9)
