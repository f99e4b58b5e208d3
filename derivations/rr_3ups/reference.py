"""The tracker once more, in NumPy and in world axes: points (n, ...), legs next, parts last.

Nothing is differentiated by hand but two turns; rates come from complex steps or from the motion
of the platform as a rigid body.
"""

from dataclasses import dataclass

import numpy as np

UP = np.array([0.0, 0.0, 1.0])
STEP = 1e-30


def about(axis, angle):
    """Matrices that turn about axis 0 (x), 1 (y) or 2 (z): (..., 3, 3)."""
    angle = np.asarray(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    found = np.zeros((*angle.shape, 3, 3), dtype=angle.dtype)
    found[..., axis, axis] = 1
    found[..., i, i] = found[..., j, j] = np.cos(angle)
    found[..., i, j], found[..., j, i] = -np.sin(angle), np.sin(angle)
    return found


def times(matrix, vector):
    """Matrix times vector, point by point."""
    return np.einsum("...ij,...j->...i", matrix, vector)


def dot(first, second):
    """Scalar product, point by point."""
    return np.sum(first * second, axis=-1)


def attitude(alpha, beta):
    """R_m."""
    return about(2, alpha) @ about(0, beta)


def on_circle(radius, azimuth, height):
    """Points (radius cos, radius sin, height)."""
    return np.stack(
        [radius * np.cos(azimuth), radius * np.sin(azimuth), height + 0 * radius], axis=-1
    )


def arms(p):
    """From o to the spherical joints, world axes: (n, 3, 3), a row a leg."""
    return np.einsum(
        "nij,nkj->nki", attitude(p["alpha"], p["beta"]), on_circle(p["r"], p["phi"], 0)
    )


def ends(p):
    """Spherical joints P and universal joints Q: (n, 3, 3) both."""
    top = p["h_0"][:, None, None] * UP
    return top + arms(p), on_circle(p["R"], p["theta"], p["h"])


def along(p):
    """From Q to P, world axes."""
    P, Q = ends(p)
    return P - Q


def lengths(p):
    """Lengths of the legs (n, 3); no absolute value, so that complex steps pass."""
    return np.sqrt(dot(along(p), along(p)))


def leg_axes(p):
    """Directions, lengths, cosines of psi, and matrices whose columns are a leg's axes.

    The first axis of the universal joint is the vertical, turned about north by zeta. The second
    is square to it and to the leg.
    """
    reach, size = along(p), lengths(p)
    w = reach / size[..., None]
    first = times(about(1, p["zeta"]), UP)
    across = np.cross(w, first)
    cosine = np.sqrt(dot(across, across))
    with np.errstate(divide="ignore", invalid="ignore"):  # along the first axis there is none
        x = across / cosine[..., None]
    return w, size, cosine, np.stack([x, w, np.cross(x, w)], axis=-1)


def joint_angles(p):
    """Gamma and psi of the universal joints."""
    w = leg_axes(p)[0]
    seen = times(np.swapaxes(about(1, p["zeta"]), -1, -2), w)
    level = np.hypot(seen[..., 0], seen[..., 1])
    return np.arctan2(-seen[..., 0], seen[..., 1]), np.arctan2(seen[..., 2], level)


def rate(function, points, rates):
    """Derivative along rates by a complex step: as exact as the function itself."""
    moved = {name: value + 0j for name, value in points.items()}
    for name, speed in rates.items():
        moved[name] = moved[name] + 1j * STEP * speed
    return function(moved).imag / STEP


def slopes(function, points):
    """Derivatives by alpha and by beta, in one more last axis."""
    return np.stack([rate(function, points, {name: 1.0}) for name in ("alpha", "beta")], axis=-1)


def jacobian(points):
    """J: (n, 3, 2)."""
    return slopes(lengths, points)


def determinant(J):
    """Of the rows of the first two legs."""
    return J[:, 0, 0] * J[:, 1, 1] - J[:, 0, 1] * J[:, 1, 0]


# -- spin-free dynamics ---------------------------------------------------------------------------


@dataclass(frozen=True)
class Body:
    """The platform's turning: axes of the two drives (n, 3, 2), Omega and its rate (n, 3)."""

    axes: np.ndarray
    spin: np.ndarray
    change: np.ndarray


def platform(p):
    """Turns about the vertical, and about the level axis that turns with it."""
    level = about(2, p["alpha"])[..., 0]
    axes = np.stack([UP + 0 * level, level], axis=-1)
    rates = np.stack([p["alpha_dot"], p["beta_dot"]], axis=-1)
    both = np.stack([p["alpha_ddot"], p["beta_ddot"]], axis=-1)
    carried = (p["alpha_dot"] * p["beta_dot"])[:, None] * np.cross(UP, level)
    return Body(axes, times(axes, rates), times(axes, both) + carried)


@dataclass(frozen=True)
class Legs:
    """Directions of the legs, how they turn and how the joints P move: (n, 3, 3) each, world."""

    w: np.ndarray
    w_dot: np.ndarray
    w_ddot: np.ndarray
    P_dot: np.ndarray
    P_ddot: np.ndarray
    q_dot: np.ndarray
    q_ddot: np.ndarray


def legs(p):
    """How the legs move, from the platform as a rigid body."""
    body, a = platform(p), arms(p)
    spin, change = body.spin[:, None], body.change[:, None]
    v = np.cross(spin, a)
    pull = np.cross(change, a) + np.cross(spin, v)
    w, size, _, _ = leg_axes(p)
    q = size[..., None]
    q_dot = dot(w, v)[..., None]
    w_dot = (v - q_dot * w) / q
    q_ddot = dot(w, pull)[..., None] + q * dot(w_dot, w_dot)[..., None]
    w_ddot = (pull - q_ddot * w - 2 * q_dot * w_dot) / q
    return Legs(w, w_dot, w_ddot, v, pull, q_dot[..., 0], q_ddot[..., 0])


def spin_free_motion(p):
    """omega, omega_dot, v_t, a_t, v_s, a_s of legs that turn about no axis of their own."""
    m = legs(p)
    t, s = p["t"][..., None], p["s"][..., None]
    return (
        np.cross(m.w, m.w_dot), np.cross(m.w, m.w_ddot), t * m.w_dot, t * m.w_ddot,
        m.P_dot - s * m.w_dot, m.P_ddot - s * m.w_ddot,
    )  # fmt: skip


def platform_demand(p):
    """Force of the two drives for the platform alone, from Euler's equation about o."""
    body, R = platform(p), attitude(p["alpha"], p["beta"])
    inertia = np.einsum("nij,nj,nkj->nik", R, p["I_m"], R)
    weight = -(p["m_m"] * p["g"])[:, None] * UP
    moment = times(inertia, body.change) + np.cross(body.spin, times(inertia, body.spin))
    moment = moment - np.cross(times(R, p["r_sc"]), weight) - p["n_d"]
    return np.einsum("nik,ni->nk", body.axes, moment)


def spin_free_force(p):
    """Tau by virtual work, when legs turn about no axis of their own and are not let do so."""
    w, q, _, axes = leg_axes(p)
    omega, omega_dot, _, a_t, _, a_s = spin_free_motion(p)
    J_a = slopes(arms, p)
    J_w = (J_a - w[..., None] * np.einsum("nki,nkij->nkj", w, J_a)[:, :, None]) / q[..., None, None]
    J_omega = np.cross(w[..., None], J_w, axis=2)
    inertia = np.einsum("nkij,nkj,nklj->nkil", axes, p["I_t"] + p["I_s"], axes)
    moment = times(inertia, omega_dot) + np.cross(omega, times(inertia, omega))
    lift = p["g"][:, None, None] * UP
    t, s = p["t"][..., None, None], p["s"][..., None, None]
    force_t, force_s = p["m_t"][..., None] * (a_t + lift), p["m_s"][..., None] * (a_s + lift)
    work = [(t * J_w, force_t), (J_a - s * J_w, force_s), (J_omega, moment)]
    return platform_demand(p) + sum(np.einsum("nkij,nki->nj", J, f) for J, f in work)
