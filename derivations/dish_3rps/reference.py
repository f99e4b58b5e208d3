"""The facet once more, in NumPy: the hinges are asked, not the closed forms; complex steps too."""

import numpy as np

TURNS = np.array([0.0, 2 * np.pi / 3, -2 * np.pi / 3])
UP = np.array([0.0, 0.0, 1.0])
U = np.stack([np.cos(TURNS), np.sin(TURNS), 0 * TURNS], axis=-1)  # joints of a level facet
T = np.cross(UP, U)  # hinge axes
STEP = 1e-30


def about(axis, angle):
    """Matrices that turn about axis 1 (y) or 2 (z): (n, 3, 3)."""
    angle = np.asarray(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    found = np.zeros((*angle.shape, 3, 3), dtype=angle.dtype)
    found[..., axis, axis] = 1
    found[..., i, i] = found[..., j, j] = np.cos(angle)
    found[..., i, j], found[..., j, i] = -np.sin(angle), np.sin(angle)
    return found


def hat(v):
    """Matrices of the cross product with vectors (n, 3)."""
    found = np.zeros((*v.shape, 3), dtype=v.dtype)
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        found[..., i, j], found[..., j, i] = -v[..., k], v[..., k]
    return found


def vee(m):
    """Vectors of skew matrices."""
    return np.stack([m[..., 2, 1], m[..., 0, 2], m[..., 1, 0]], axis=-1)


def times(matrix, vector):
    """Matrix times vector, point by point."""
    return np.einsum("...ij,...j->...i", matrix, vector)


def dish(alpha, beta):
    """Attitude of the dish."""
    return about(2, alpha) @ about(1, beta) @ about(2, -np.asarray(alpha))


def base(phi, d):
    """Attitude and place of the facet's base."""
    phi, d = np.broadcast_arrays(phi, d)
    return about(2, phi - np.pi), np.stack([d * np.cos(phi), d * np.sin(phi), 0 * phi], axis=-1)


def shortest(n):
    """Rodrigues: the turn about z x n that takes z to n."""
    across = hat(np.cross(UP + 0 * n, n))
    return np.eye(3) + across + across @ across / (1 + n[..., 2])[..., None, None]


def facet(alpha, beta, f, d, r_m, z_O, phi, **_):
    """Rotation and point in {H}: normal and height of the dish, the rest from two of the planes."""
    turned = dish(alpha, beta)
    out = np.stack([np.cos(phi), np.sin(phi), 0 * phi], axis=-1)
    point = d[..., None] * out + (d * d / (4 * f))[..., None] * UP
    normal = -d[..., None] * out + (2 * f)[..., None] * UP
    normal = normal / np.sqrt(np.sum(normal**2, axis=-1))[..., None]
    turn, place = base(phi, d)
    back = np.swapaxes(turn, -1, -2)
    tilt = shortest(times(back, times(turned, normal)))
    joints = r_m[..., None, None] * np.einsum("...ij,kj->...ki", tilt, U)
    # t.(M + r) = 0 for the first two hinges, in x and y; the third is left to be checked.
    wanted = -np.einsum("ki,...ki->...k", T[:2], joints[..., :2, :])
    x, y = np.moveaxis(
        np.linalg.solve(T[:2, :2] + 0 * joints[..., :2, :2], wanted[..., None]), -2, 0
    )
    height = z_O + times(turned, point)[..., 2]
    inside = np.stack([x[..., 0], y[..., 0], height], axis=-1)
    return turn @ tilt, place + times(turn, inside)


def rods(R, M, d, r_b, r_m, phi, **_):
    """Vectors along the rods (n, 3, 3), a row each, from hinge to S-joint, {H}; and r_S."""
    turn, place = base(phi, d)
    arms = r_m[..., None, None] * np.einsum("...ij,kj->...ki", R, U)
    feet = r_b[..., None, None] * np.einsum("...ij,kj->...ki", turn, U)
    return M[..., None, :] + arms - place[..., None, :] - feet, arms


def hinge_axes(phi):
    """Hinge axes (n, 3, 3), a row each, {H}."""
    return np.einsum("...ij,kj->...ki", about(2, np.asarray(phi) - np.pi), T)


def lengths(points):
    """Lengths of the rods; no absolute value, so that complex steps pass."""
    found, _ = rods(*facet(**points), **points)
    return np.sqrt(np.sum(found**2, axis=-1))


def rate(function, points, rates):
    """Derivative along rates by a complex step: as exact as the function itself."""
    moved = {name: value + 0j for name, value in points.items()}
    for name, speed in rates.items():
        moved[name] = moved[name] + 1j * STEP * speed
    return function(moved).imag / STEP
