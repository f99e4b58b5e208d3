"""Points: the same every run, inside the limits, and awkward where they say so."""

import numpy as np
import pytest

from armillary import Derivation
from armillary.program.compile import compile_kernel
from armillary.program.evaluate import guard_status
from armillary.verify.points import (
    AWKWARD_DIRECTIONS,
    awkward_points,
    chosen,
    count,
    directions,
    illegal_points,
    random_points,
    rows_of,
)


@pytest.fixture
def record():
    d = Derivation("points", title="Points")
    t, L = d.angle("t", "angle"), d.length("L", "length", range=(0.5, 2.0))
    n, f = d.unit_vector("n", "direction"), d.vector("f", "force")
    g = d.parameter.scalar("g", "factor", limits=(0.1, 3.0), range=(1.0, 2.0))
    d.kernel("k", inputs=[t, L, n, f], outputs={"r": t * g + n.x + f.y, "s": 2 * L})
    return d


def test_random_points_lie_in_the_ranges(record):
    points = random_points(record, 200, seed=1)
    assert {name: a.shape for name, a in points.items()} == {
        "t": (200,), "L": (200,), "n": (200, 3), "f": (200, 3), "g": (200,)
    }  # fmt: skip
    assert points["L"].min() >= 0.5
    assert points["L"].max() <= 2.0
    assert points["g"].min() >= 1.0
    assert np.allclose(np.linalg.norm(points["n"], axis=1), 1.0, atol=1e-15)
    assert np.ptp(points["t"]) > 5.0


@pytest.fixture
def attitude():
    d = Derivation("attitude", title="Attitude")
    R = d.rotation("R", "attitude")
    d.kernel("k", inputs=[R], outputs={"r": R.entry(0, 0)})
    return d.kernels["k"]


def test_random_rotations_are_spread_over_all_attitudes(attitude):
    R = random_points(attitude, 400, seed=1)["R"]
    assert R.shape == (400, 3, 3)
    assert np.allclose(R @ R.swapaxes(1, 2), np.eye(3), atol=1e-15)
    assert np.linalg.det(R).min() > 0
    assert np.abs(R.mean(axis=0)).max() < 0.15
    # The angle of an even spread has the density (1 - cos) / pi: 2/pi + pi/2 on the average.
    angles = np.arccos(np.clip((np.trace(R, axis1=1, axis2=2) - 1) / 2, -1, 1))
    assert angles.mean() == pytest.approx(np.pi / 2 + 2 / np.pi, abs=0.1)


def test_awkward_rotations_are_legal_and_meet_the_singular_sets(attitude):
    guards = compile_kernel(attitude).program.guards
    points = awkward_points(attitude)
    assert {guard_status(guards, row) for row in rows_of(points)} == {0}
    known = {tuple(m.ravel()) for m in points["R"].round(12) + 0.0}
    for turn in (np.eye(3), np.diag([-1.0, -1, 1]), np.diag([1.0, -1, -1]), np.eye(3)[[1, 2, 0]]):
        assert tuple(turn.ravel()) in known
    lean = np.hypot(points["R"][:, 0, 2], points["R"][:, 1, 2])
    assert ((lean > 0) & (lean < 1e-6)).any()
    assert ((lean > 1e-6) & (lean < 1e-3)).any()


def test_matrices_that_are_no_rotations_are_refused(attitude):
    guards = compile_kernel(attitude).program.guards
    points = illegal_points(attitude)
    answers = [guard_status(guards, row) for row in rows_of(points)]
    assert set(answers) == {-1, -2}
    assert answers.count(-2) == count(points) - 3


def test_random_points_are_the_same_every_run(record):
    first, second = random_points(record, 5, seed=1), random_points(record, 5, seed=1)
    assert all(np.array_equal(first[n], second[n]) for n in first)
    assert not np.array_equal(first["t"], random_points(record, 5, seed=2)["t"])


def test_a_new_quantity_moves_no_others_points(record):
    before = random_points(record, 5)
    record.angle("z", "another")
    assert all(np.array_equal(before[n], random_points(record, 5)[n]) for n in before)


def test_awkward_points_are_legal_and_awkward(record):
    kernel = record.kernels["k"]
    guards = compile_kernel(kernel).program.guards
    points = awkward_points(kernel)
    assert {guard_status(guards, row) for row in rows_of(points)} == {0}
    assert {0.0, np.pi, -np.pi / 2, 999.0} <= set(points["t"])
    assert {0.0, 1e6} <= set(points["L"])
    assert {0.1, 1.0, 3.0} <= set(points["g"])
    up = [0.0, 0.0, 1.0]
    assert any(np.array_equal(n, up) for n in points["n"])
    nearly = [n for n in points["n"] if 0 < np.hypot(n[0], n[1]) < 1e-3]
    assert nearly


def test_illegal_points_are_all_refused(record):
    kernel = record.kernels["k"]
    guards = compile_kernel(kernel).program.guards
    points = illegal_points(kernel)
    assert {guard_status(guards, row) for row in rows_of(points)} == {-1, -2}
    assert count(points) == 5 * 7 + 3


def test_directions_are_all_over_the_sphere_with_the_awkward_ones_behind():
    made = directions(100, seed=1)
    assert np.allclose(np.linalg.norm(made, axis=1), 1.0, atol=1e-15)
    assert np.abs(made[:100].mean(axis=0)).max() < 0.2
    assert np.array_equal(made[100:], np.array(AWKWARD_DIRECTIONS))
    assert np.array_equal(directions(100, seed=1), made)


def test_points_are_chosen_by_a_mask():
    points = {"a": np.arange(3.0), "n": np.eye(3)}
    some = chosen(points, np.array([True, False, True]))
    assert some["a"].tolist() == [0.0, 2.0]
    assert np.array_equal(some["n"], np.eye(3)[[0, 2]])
