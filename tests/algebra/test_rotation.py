"""Rotations given by their entries: entries, products, transposes, and how they turn a vector."""

from dataclasses import dataclass

import numpy as np
import pytest
import sympy

from armillary import X, Y, Z, time_derivative, vector
from armillary.algebra.derivative import Differentiator, of_time
from armillary.algebra.direction import is_unit, normalised_in
from armillary.algebra.explicit import Explicit, elementary_matrix, rotation_symbol, symbol
from armillary.algebra.misuse import MisuseError
from armillary.algebra.rotation import (
    IDENTITY,
    RotationSymbol,
    compose,
    elementary,
    keeps_norms,
    transpose,
)
from armillary.algebra.scalar import Symbol
from armillary.algebra.vector import Basis, Vector, VectorSymbol, unit
from armillary.verify.points import rotations

t = Symbol("t")
R, Q = RotationSymbol("R"), RotationSymbol("Q")
v = VectorSymbol("v")
BOOK_R, BOOK_Q = rotation_symbol("R"), rotation_symbol("Q")
BOOK_T = elementary_matrix(1, symbol("t"))
BOOK_V = sympy.Matrix([symbol(f"v_{a}") for a in "xyz"])


def test_the_entries_are_named_by_row_and_column():
    assert [str(e) for e in BOOK_R] == [f"R_{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)]
    assert Explicit()(R.entry(X, Z)) == BOOK_R[0, 2]
    assert Explicit()(R.transpose().entry(X, Z)) == BOOK_R[2, 0]
    assert Explicit()(R.column(Y)) == BOOK_R[:, 1]
    assert Explicit()(R.matrix()) == BOOK_R


@pytest.mark.parametrize(
    ("made", "wanted"),
    [
        (R @ v, BOOK_R * BOOK_V),
        (R.transpose() @ v, BOOK_R.T * BOOK_V),
        (R @ Q, BOOK_R * BOOK_Q),
        (R @ elementary(1, t) @ Q.transpose(), BOOK_R * BOOK_T * BOOK_Q.T),
        (transpose(R @ elementary(1, t)), BOOK_T.T * BOOK_R.T),
        (transpose(transpose(compose(R, Q))), BOOK_R * BOOK_Q),
        (compose(IDENTITY, R) @ Basis(2), BOOK_R[:, 2]),
    ],
)
def test_products_are_those_of_matrices(made, wanted):
    assert sympy.simplify(Explicit()(made) - wanted) == sympy.zeros(*wanted.shape)


@pytest.mark.parametrize("place", [(3, 0), (0, -1), (0, "z")])
def test_there_are_three_rows_and_columns(place):
    with pytest.raises(MisuseError, match="X, Y and Z name them"):
        R.entry(*place)


def test_only_rotations_made_of_angles_keep_norms_for_certain():
    assert keeps_norms(elementary(0, t) @ elementary(1, t))
    assert not keeps_norms(elementary(0, t) @ R)
    turned = unit(v)
    assert is_unit(elementary(0, t) @ turned)
    assert normalised_in(elementary(0, t) @ turned) is turned
    assert not is_unit(R @ turned)
    assert normalised_in(R @ turned) is None


# -- motion ---------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Moving(RotationSymbol):
    """A rotation with an angular velocity."""

    def velocity(self) -> Vector:
        return vector("0.3", "-1.1", "0.7")


SPIN = np.array([0.3, -1.1, 0.7])


@dataclass(frozen=True, eq=False)
class Running(Symbol):
    """An angle that runs."""

    def velocity(self):
        return Symbol("t_dot")


def numbers(node, attitude):
    given = dict(zip(BOOK_R, attitude.ravel().tolist(), strict=True))
    given |= {symbol("t"): 0.4, symbol("t_dot"): 1.7}
    given |= dict(zip(BOOK_V, (0.2, -0.9, 1.3), strict=True))
    return np.array(Explicit()(node).subs(given), dtype=float).ravel()


def hat(w):
    return np.cross(w, np.eye(3)).T


def test_a_rotation_that_is_held_does_not_move_a_vector():
    assert Explicit()(time_derivative(R @ vector(1, 2, 3))) == sympy.zeros(3, 1)
    moved = time_derivative(R.transpose() @ elementary(0, Running("t")) @ Q @ v)
    book = BOOK_R.T * elementary_matrix(0, symbol("t")).diff(symbol("t")) * BOOK_Q * BOOK_V
    found = sympy.expand(Explicit()(moved) - book * symbol("t_dot"))
    assert found == sympy.zeros(3, 1)


@pytest.mark.parametrize("back", [False, True])
def test_one_that_moves_turns_by_its_angular_velocity(back):
    """d(R v) = w x R v and d(R^T v) = -R^T (w x v), in a chain with an angle that runs."""
    attitude = rotations(1, np.random.default_rng(1))[0]
    moving, running = Moving("R"), Running("t")
    chain = (moving.transpose() if back else moving) @ elementary(1, running)
    inner = np.array(elementary_matrix(1, sympy.Float(0.4)), dtype=float)
    along = inner @ (0.2, -0.9, 1.3)
    turning = inner @ np.cross((0, 1.7, 0), (0.2, -0.9, 1.3))
    outer, change = attitude, hat(SPIN) @ attitude
    if back:
        outer, change = outer.T, change.T
    wanted = change @ along + outer @ turning
    assert numbers(time_derivative(chain @ v), attitude) == pytest.approx(wanted, abs=1e-12)
    spin = numbers(Differentiator(of_time).angular_velocity(chain), attitude)
    carried = outer @ along
    assert np.cross(spin, carried) == pytest.approx(wanted, abs=1e-12)
