"""Legs that do not spin, as the paper takes them: its (10) with the sign mended, by hand."""

import numpy as np

from armillary.verify.measured import compare

from .checks_of_kinematics import MOTION
from .reference import dot, jacobian, legs, spin_free_force, spin_free_motion
from .samples import call, fast
from .solved import by_pinocchio, least_norm

SHARE = 0.01  # of the generalised force: what the spin changes of it, at the least


def spin_free_by_numpy(kernels):
    """Turning, generalised force and forces when a leg turns only as its direction does."""
    points = fast(21)
    found = call(kernels.leg_motion_spin_free, points)
    for name, wanted in zip(MOTION, spin_free_motion(points), strict=True):
        yield compare(
            f"{name} of legs that do not spin", "NumPy", getattr(found, name), wanted, 1e-13,
            points, "leg_motion_spin_free",
        )  # fmt: skip
    tau = spin_free_force(points)
    for kernel, name, wanted in (
        ("generalized_force_spin_free", "tau", tau),
        ("forces_spin_free", "F", least_norm(jacobian(points), tau)),
    ):
        yield compare(
            f"{name} of legs that do not spin", "NumPy",
            getattr(call(getattr(kernels, kernel), points), name), wanted, 1e-12, points, kernel,
        )  # fmt: skip


def spin_is_about_the_leg(kernels):
    """Both kinds of leg differ by a turn about the leg alone, and no centre of mass feels it."""
    solved = by_pinocchio()
    points = solved.points
    w = legs(points).w
    exact, free = call(kernels.leg_motion, points), call(kernels.leg_motion_spin_free, points)
    spin = exact.omega - free.omega
    x, v = solved.ways("x"), solved.ways("v")
    yield compare(
        "a leg spins as fast as its joint's first axis turns, times the sine of psi", "pinocchio",
        dot(exact.omega, w), v[:, 2::3] * np.sin(x[:, 3::3]), 1e-12, points, "leg_motion",
    )  # fmt: skip
    yield compare(
        "the difference of angular velocities is along the leg", "NumPy",
        spin - dot(spin, w)[..., None] * w, 0.0, 1e-13, points, "leg_motion", relative=False,
    )  # fmt: skip
    yield compare(
        "a leg that does not spin has no angular velocity along itself", "NumPy",
        dot(free.omega, w), 0.0, 1e-13, points, "leg_motion_spin_free", relative=False,
    )  # fmt: skip
    for name in MOTION[2:]:
        yield compare(
            f"{name} is the same with the spin and without", "leg_motion", getattr(free, name),
            getattr(exact, name), 1e-14, points, "leg_motion_spin_free",
        )  # fmt: skip


def spin_of_round_light_legs(kernels):
    """Without inertia of the legs' own, spinning costs nothing: both forms agree."""
    points = fast(23)
    for name in ("I_t", "I_s"):
        points[name] = np.zeros_like(points[name])
    yield compare(
        "legs of points of mass: the spin costs nothing", "generalized_force_spin_free",
        call(kernels.generalized_force, points).tau,
        call(kernels.generalized_force_spin_free, points).tau, 1e-13, points, "generalized_force",
    )  # fmt: skip


def spin_matters(kernels):
    """On fast motions the spin-free form is off by a good part of the leg's share."""
    solved = by_pinocchio()
    points = solved.points
    free = call(kernels.generalized_force_spin_free, points).tau
    part = np.linalg.norm(free - solved.tau, axis=1) / np.linalg.norm(solved.tau, axis=1)
    median = float(np.median(part))
    yield compare(
        "on fast motions the spin is more than a hundredth of the generalised force (half of them)",
        "pinocchio", np.minimum(median, SHARE), SHARE, 0.0, {"median": np.array([median])},
        "generalized_force_spin_free",
    )  # fmt: skip
