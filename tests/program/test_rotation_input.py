"""Rotations as inputs: every direction of evaluation, exact to the entries, and the guards."""

import numpy as np
import pytest

from armillary import Derivation, Rate, X, Y, Z, unit
from armillary.algebra.rotation import elementary
from armillary.program.arithmetic import Reals
from armillary.program.compile import compile_kernel
from armillary.program.evaluate import evaluate, guard_status
from armillary.program.guards import Form, guards_of
from armillary.program.lower import strategies
from armillary.program.sample import sample_points
from armillary.targets.runtime import _runtime
from armillary.verify import exact
from armillary.verify.identities import text_book_rotation
from tests.programs import kernel_of, program_of

record = d = Derivation("attitudes", title="Attitudes")
R = d.rotation("R", "an attitude", rate=Rate.MOUNT)
Q = d.rotation("Q", "another")
t = d.angle("t", "an angle")
v = d.vector("v", "a vector")
INPUTS = [R, Q, t, v]
# Not quite a rotation: what holds of rotations only must not be taken for granted.
ODD = [[0.99, 0.3, -0.2], [-0.1, 1.0, 0.4], [0.25, -0.35, 0.9]]
ROW = {
    "R": [x for row in ODD for x in row],
    "Q": [0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6],
    "t": 0.7,
    "v": [0.3, -1.2, 0.5],
}
OUTPUTS = {
    "w": R @ elementary(Y, t) @ elementary(Y, -2 * t) @ Q.transpose() @ elementary(X, t) @ v,
    "P": R.transpose() @ elementary(Z, t) @ Q @ R,
    "whole": R.matrix(),
    "entry": Q.entry(Z, X),
}


@pytest.mark.parametrize("strategy", strategies(), ids=str)
def test_every_direction_of_evaluation_multiplies_the_matrices(strategy):
    answer = exact.run(program_of(record, INPUTS, OUTPUTS, strategy), ROW, Reals())
    for name, value in OUTPUTS.items():
        wanted = exact.text_book(value)(ROW)
        assert exact.worst(exact.flat(answer.results[name]), wanted) < 1e-45


def test_norms_are_those_of_the_entries_given():
    """(R v).(R v) is v.v for a rotation only, and the unit vector is taken before R turns it."""
    outputs = {
        "square": (R @ v).dot(R @ v),
        "same": (lambda w: w.dot(w))(R @ v),
        "turned": R @ unit(v),
    }
    kernel = kernel_of(record, INPUTS, outputs)
    answer = exact.run(compile_kernel(kernel).program, ROW, Reals())
    for name, value in outputs.items():
        wanted = exact.text_book(value)(ROW)
        assert exact.worst(exact.flat(answer.results[name]), wanted) < 1e-45
    assert abs(float(answer.results["square"]) - float(np.dot(ROW["v"], ROW["v"]))) > 0.01


def test_samples_are_rotations_to_all_digits():
    reals = Reals()
    for point in sample_points(kernel_of(record, INPUTS, OUTPUTS), 3):
        m = reals.mp.matrix(3, 3)
        for k, entry in enumerate(point["R"]):
            m[k // 3, k % 3] = entry
        assert reals.mp.norm(m.T * m - reals.mp.eye(3)) < 1e-45
        assert reals.mp.det(m) > 0


def test_a_definition_of_given_entries_is_not_proved_orthonormal():
    own = Derivation("own", title="Own")
    S, a = own.rotation("S", "an attitude"), own.angle("a", "an angle")
    own.define("T", S @ elementary(X, a), because="it is turned")
    own.define("U", elementary(Y, a) @ elementary(X, a), because="it is built")
    assert text_book_rotation(own.definitions["T"]) is None
    assert text_book_rotation(own.definitions["U"]).passed


# -- guards ---------------------------------------------------------------------------------------

NAN, INF = float("nan"), float("inf")


def told(matrix):
    return guard_status(guards_of(R), {"R": np.asarray(matrix, dtype=float).ravel().tolist()})


def changed(place, value, matrix=None):
    found = np.array(np.eye(3) if matrix is None else matrix, dtype=float)
    found[place] = value
    return found


def sheared(by, to=0, of=1):
    found = np.eye(3)
    found[:, to] += by * found[:, of]
    return found


LEGAL = {
    "rest": np.eye(3),
    "a half turn": np.diag([-1.0, 1.0, -1.0]),
    "a third turn": [[0, 0, 1], [1, 0, 0], [0, 1, 0]],
    "an error within the tolerance": sheared(0.9e-3),
    "a length within it": np.diag([1.0, 1.0 + 0.45e-3, 1.0]),
}
ILLEGAL = {
    "nothing": np.zeros((3, 3)),
    "a mirror": np.diag([1.0, 1.0, -1.0]),
    "a point mirror": -np.eye(3),
    "an exchange of axes": [[0, 1, 0], [1, 0, 0], [0, 0, 1]],
    **{f"axis {k} too short": changed((k, k), 0.9994) for k in range(3)},
    **{f"axis {i} leans on {j}": sheared(1.1e-3, i, j) for i in range(3) for j in range(i)},
    "one column twice": [[1, 1, 0], [0, 0, 0], [0, 0, 1]],
    "a large entry": changed((0, 1), 1e30),
    "not finite, and beside it too short": changed((0, 1), NAN, np.diag([0.5, 1.0, 1.0])),
}


@pytest.mark.parametrize("name", LEGAL)
def test_rotations_are_accepted(name):
    assert told(LEGAL[name]) == 0


@pytest.mark.parametrize("name", ILLEGAL)
def test_other_matrices_are_out_of_range(name):
    assert told(ILLEGAL[name]) == -2


@pytest.mark.parametrize("fault", [NAN, INF, -INF])
def test_what_is_not_finite_is_told_as_such(fault):
    assert told(changed((1, 2), fault)) == -1


@pytest.mark.parametrize(("quantity", "size"), [(R, 9), (d.unit_vector("n", "a direction"), 3)])
def test_the_python_runtime_knows_the_same_forms(quantity, size):
    wanted = [g.form for g in guards_of(quantity) if isinstance(g.form, Form)]
    found = [(tuple(terms), value, tolerance) for terms, value, tolerance in _runtime._FORMS[size]]
    assert found == [(f.terms, f.value, f.tolerance) for f in wanted]


def test_evaluation_takes_flat_entries():
    program = program_of(record, [R], {"e": R.entry(Y, Z)})
    assert float(evaluate(program, {"R": list(range(9))}).results["e"]) == 5.0
