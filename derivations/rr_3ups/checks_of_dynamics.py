"""Forces and accelerations against pinocchio and MuJoCo, each with loops that it closes itself."""

import numpy as np

from armillary.verify.measured import compare

from .models_mujoco import Tree as Hinges
from .reference import times
from .samples import ACCELERATIONS, call
from .solved import by_pinocchio, least_norm, solve

PAIR = (0, 1)


def forces_by_pinocchio(kernels):
    """Generalised force and forces of the legs, by recursion on the tree and its closed loops."""
    for what in _against(by_pinocchio(), by_pinocchio(PAIR)):
        yield _compared(kernels, "pinocchio", 1e-12, *what)


def forces_by_mujoco(kernels):
    """The same by MuJoCo's inverse dynamics, on hinges and slides."""
    points = by_pinocchio().points
    for what in _against(solve(points, tree=Hinges), solve(points, PAIR, Hinges)):
        yield _compared(kernels, "MuJoCo", 1e-9, *what)


def _against(three, two):
    """Kernels, results and what they should be."""
    pair = np.linalg.solve(np.swapaxes(two.ways("J"), 1, 2), two.tau[..., None])[..., 0]
    points = three.points
    return [
        ("generalized_force", "tau", three.tau, points),
        ("forces", "F", least_norm(three.ways("J"), three.tau), points),
        ("generalized_force_two_legs", "tau", two.tau, points),
        ("forces_two_legs", "F", pair, points),
    ]


def _compared(kernels, engine, tolerance, kernel, name, wanted, points):
    found = getattr(call(getattr(kernels, kernel), points), name)
    return compare(
        f"{name} of {kernel.replace('_', ' ')}", engine, found, wanted, tolerance, points, kernel
    )


def masses_by_pinocchio(kernels):
    """Mass matrix and bias along alpha and beta; the matrix is positive."""
    solved = by_pinocchio()
    points = solved.points
    H = call(kernels.mass_matrix, points).H
    wanted = solved.each(lambda engine, motion: engine.mass(motion))
    yield compare("mass matrix", "pinocchio", H, wanted, 1e-12, points, "mass_matrix")
    least = np.linalg.eigvalsh(H)[:, 0]
    yield compare(
        "and positive: its smallest eigenvalue is that of pinocchio's, above 0", "pinocchio",
        np.where(least > 0, least, np.nan), np.linalg.eigvalsh(wanted)[:, 0], 1e-12, points,
        "mass_matrix",
    )  # fmt: skip
    push = np.stack([points[name] for name in ACCELERATIONS], axis=-1)
    tau_0 = call(kernels.bias, points).tau_0
    yield compare(
        "what is left without acceleration", "pinocchio", tau_0, solved.tau - times(wanted, push),
        1e-12, points, "bias",
    )  # fmt: skip
    yield compare(
        "mass matrix times accelerations and bias make the generalised force",
        "generalized_force", times(H, push) + tau_0, call(kernels.generalized_force, points).tau,
        1e-12, points, "bias",
    )  # fmt: skip


def forward_dynamics_inverts(kernels):
    """Forces that a motion asks for bring its accelerations about again."""
    solved = by_pinocchio()
    points = solved.points
    wanted = np.stack([points[name] for name in ACCELERATIONS], axis=-1)
    forces = call(kernels.forces, points).F
    for what, push in (("least norm", forces), ("least norm, preloaded", _preloaded(kernels))):
        found = _forward(kernels, {**points, "F_leg": push})
        yield compare(
            f"accelerations under the forces of {what}", "forces", found, wanted, 1e-11, points,
            "forward_dynamics",
        )  # fmt: skip
    pushed = np.random.default_rng(7).uniform(-1e3, 1e3, forces.shape)
    rows = zip(pushed, points["f_d"], points["n_d"], strict=True)
    engines = zip(solved.engines, solved.motions, rows, strict=True)
    multiplied = np.array([engine.forward(motion, *row) for engine, motion, row in engines])
    yield compare(
        "accelerations under forces at random, loops held by multipliers", "pinocchio",
        _forward(kernels, {**points, "F_leg": pushed}), multiplied, 1e-11, points,
        "forward_dynamics",
    )  # fmt: skip


def _preloaded(kernels):
    points = by_pinocchio().points
    return call(kernels.forces_preloaded, {**points, "preload": np.full(len(points["g"]), 50.0)}).F


def _forward(kernels, points):
    found = call(kernels.forward_dynamics, points)
    return np.stack([found.alpha_ddot, found.beta_ddot], axis=-1)
