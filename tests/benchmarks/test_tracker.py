"""K4 by two ways that share nothing: the reference, the recipes, pinocchio."""

import math

import numpy as np
import pytest

from benchmarks import reference
from benchmarks.recipes import KERNELS
from benchmarks.tracker import SIZES
from benchmarks.tracker_recursion import by_recursion
from derivations.rr_3ups.closure import generalized_force, move
from derivations.rr_3ups.models_pinocchio import Tree


class Numbers:
    """A recipe in floating point; what it differentiates is left out."""

    sin, cos, sqrt, atan2 = map(staticmethod, (math.sin, math.cos, math.sqrt, math.atan2))

    def named(self, values):
        return values


def given(point):
    """The inputs by name, with a row a leg where there is one."""
    found, position = {}, 0
    for name, size in SIZES.items():
        entries = np.array(point[position : position + size])
        found[name] = entries.reshape(3, 3) if size == 9 else entries if size > 1 else entries[0]
        position += size
    return found


@pytest.mark.parametrize("point", reference.points("K4", 4))
def test_reference_moves_as_pinocchio_says(point):
    pytest.importorskip("pinocchio")
    p = given(point)
    tree = Tree(p)
    angles, rates, accelerations = (
        np.array([p["alpha" + order], p["beta" + order]]) for order in ("", "_dot", "_ddot")
    )
    motion = move(tree, angles, rates, accelerations)
    tau = generalized_force(tree, motion, p["f_d"], p["n_d"])
    forces = np.array(reference.values("K4", point))
    assert motion.J.T @ forces == pytest.approx(tau, rel=1e-11, abs=1e-11)
    idle = np.cross(*motion.J.T)
    assert abs(idle @ forces) < 1e-12 * np.linalg.norm(idle) * np.linalg.norm(forces)


@pytest.mark.parametrize("point", reference.points("K4", 4))
def test_recursion_is_the_reference(point):
    assert by_recursion(Numbers(), point) == pytest.approx(reference.values("K4", point), rel=1e-12)


def test_every_input_but_the_disturbing_force_matters():
    point = reference.points("K4", 1)[0]
    before = np.array(by_recursion(Numbers(), point))
    idle = []
    for k, name in enumerate(KERNELS["K4"].inputs):
        moved = [*point[:k], point[k] + 1e-3, *point[k + 1 :]]
        if not np.abs(np.array(by_recursion(Numbers(), moved)) - before).max() > 1e-9:
            idle.append(name)
    # r_sc0: the centre of mass along the level axis has no arm about it.
    # I_m0 counts by beta_ddot. f_d acts where nothing moves.
    assert idle == ["r_sc0", "f_d0", "f_d1", "f_d2"]
