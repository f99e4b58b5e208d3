"""Where some motion moves no mass: what forward dynamics answers on both sides of the limits."""

import numpy as np

from armillary import Status
from armillary.verify.measured import compare
from armillary.verify.points import chosen

from .reference import arms, attitude, jacobian, leg_axes, platform, slopes, spin_free_force, times
from .samples import ACCELERATIONS, call, fast

PART = 1e-5  # what the derivation states: of the inertia of beta
LEAST = 1e-9  # kg m^2
CLEAR = 1e-3  # part of a limit that rounding may blur
COUNT = 600
FOUND = ("alpha_ddot", "beta_ddot")
OF_LEGS = ("m_t", "m_s", "I_t", "I_s")


def masses_on_one_leg(kernels):
    """All mass on one leg: at a quarter turn of tilt both angles move its joint on one line."""
    random = np.random.default_rng(71)
    points = _carried_by_one_leg(fast(72, COUNT), random)
    side = random.choice([-1.0, 1.0], (2, COUNT))
    points["beta"] = side[0] * (np.pi / 2 - side[1] * 10.0 ** random.uniform(-6.0, -0.5, COUNT))
    _, size, cosine, _ = leg_axes(points)
    points = chosen(points, np.all(size > 0.15, axis=1) & np.all(cosine > 0.2, axis=1))
    H = _mass_matrix(points)
    left = np.linalg.det(H) / H[:, 0, 0] / H[:, 1, 1]
    points, left = _clear_of(points, left, left / PART)
    yield from _answers(kernels, points, left > PART, f"{PART:g} of the inertia of beta")


def platforms_of_little_mass(kernels):
    """A platform without legs' masses that hardly weighs about one of its axes."""
    random = np.random.default_rng(73)
    points = fast(74, COUNT)
    for name in OF_LEGS:
        points[name] = np.zeros_like(points[name])
    points["I_m"] = LEAST * 10.0 ** random.uniform(-1.0, 1.0, (COUNT, 3))
    points["m_m"] = np.zeros(COUNT)
    H = _mass_matrix(points)
    least = np.minimum(H[:, 0, 0], H[:, 1, 1])
    points, least = _clear_of(points, least, H[:, 0, 0] / LEAST, H[:, 1, 1] / LEAST)
    yield from _answers(kernels, points, least > LEAST, f"{LEAST:g} kg m^2")


def _answers(kernels, points, weighs, limit):
    """Status, accelerations of 0 where something does not weigh, and the true ones elsewhere."""
    if not 0.1 < np.mean(weighs) < 0.9:
        raise ValueError(f"points lie on one side of {limit}")
    points["F_leg"] = np.random.default_rng(75).uniform(-500.0, 500.0, (len(weighs), 3))
    found = call(kernels.forward_dynamics, points)
    yield compare(
        f"some motion moves no mass within {limit}, and only there", "NumPy", found.status,
        np.where(weighs, Status.OK, Status.SINGULAR), 0.0, points, "forward_dynamics",
    )  # fmt: skip
    push = np.stack([getattr(found, name) for name in FOUND], axis=-1)
    yield compare(
        f"within {limit} accelerations are given as 0", "geometry", push[~weighs], 0.0, 0.0,
        chosen(points, ~weighs), "forward_dynamics",
    )  # fmt: skip
    points, push = chosen(points, weighs), push[weighs]
    still = {**points, **{name: 0 * points[name] for name in ACCELERATIONS}}
    wanted = times(np.swapaxes(jacobian(points), 1, 2), points["F_leg"]) - spin_free_force(still)
    moved = times(_mass_matrix(points), push)
    scale = np.abs(_mass_matrix(points)).max(axis=(1, 2)) * np.abs(push).max(axis=1)
    yield compare(
        f"beyond {limit} masses times accelerations are what forces leave", "NumPy",
        (moved - wanted) / scale[:, None], 0.0, 1e-12, points, "forward_dynamics", relative=False,
    )  # fmt: skip


def _carried_by_one_leg(points, random):
    """Machines of which one leg, a different one each, has masses and all else has none."""
    kept = np.eye(3)[random.integers(0, 3, len(points["alpha"]))]
    for name in ("m_t", "m_s"):
        points[name] = points[name] * kept
    for name in ("I_t", "I_s", "I_m", "m_m"):
        points[name] = np.zeros_like(points[name])
    return points


def _clear_of(points, measure, *parts):
    """Points whose parts of the limits are told by floats, and their measure."""
    clear = np.all([np.abs(part - 1) > CLEAR for part in parts], axis=0)
    return chosen(points, clear), measure[clear]


def _mass_matrix(p):
    """Of the platform, and of legs whose links are points of mass: (n, 2, 2)."""
    w, q, _, _ = leg_axes(p)
    J_a, R, axes = slopes(arms, p), attitude(p["alpha"], p["beta"]), platform(p).axes
    J_w = (J_a - w[..., None] * np.einsum("nki,nkij->nkj", w, J_a)[:, :, None]) / q[..., None, None]
    t, s = p["t"][..., None, None], p["s"][..., None, None]
    seen = np.einsum("nij,nik->njk", R, axes)
    found = np.einsum("nij,ni,nik->njk", seen, p["I_m"], seen)
    for mass, J in ((p["m_t"], t * J_w), (p["m_s"], J_a - s * J_w)):
        found = found + np.einsum("nkij,nk,nkil->njl", J, mass, J)
    return found
