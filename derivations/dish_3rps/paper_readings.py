"""The paper's facet, read in the ways that its equations permit, as NumPy.

(13) fixes all six coordinates of the facet; (14) and (15) then replace two of them. The first
column of (8) holds an element twice; it is taken as the rotation that the text describes.
"""

from dataclasses import dataclass

import numpy as np

from .drawing import CIRCLE, ROUND

READINGS = ("(13) alone", "(14), (15) as printed", "(14), (15) in {P}")


@dataclass(frozen=True)
class Reading:
    """Rods, shape (..., 3), and how far each S-joint is out of the plane of its hinge."""

    l: np.ndarray
    off_plane: np.ndarray


def turn_z(angle):
    """Rz, shape (..., 3, 3)."""
    c, s, zero = np.cos(angle), np.sin(angle), 0 * angle
    return _matrix([[c, -s, zero], [s, c, zero], [zero, zero, zero + 1]])


def turn_y(angle):
    """Ry, shape (..., 3, 3)."""
    c, s, zero = np.cos(angle), np.sin(angle), 0 * angle
    return _matrix([[c, zero, s], [zero, zero + 1, zero], [-s, zero, c]])


def _matrix(rows):
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def dish_facet(size, alpha, beta, phi):
    """Rotation and point of a facet that is fixed in the dish: (8), (11) and (13)."""
    dish = turn_z(alpha) @ turn_y(beta) @ turn_z(-alpha)
    eta = np.arctan(size["d"] / (2 * size["f"]))
    facet = dish @ turn_z(phi - np.pi) @ turn_y(eta + 0 * phi)
    d = size["d"]
    point = np.stack([d * np.cos(phi), d * np.sin(phi), d * d / (4 * size["f"]) + 0 * phi], -1)
    return facet, (dish @ point[..., None])[..., 0] + np.array([0.0, 0.0, size["z_O"]])


def replaced(size, R, alpha, beta, phi):
    """The facet's x and y by (14) and (15) as printed."""
    eta = np.arctan(size["d"] / (2 * size["f"]))
    ce, se, cp, sp = np.cos(eta), np.sin(eta), np.cos(phi), np.sin(phi)
    ca, sa, cb, sb = np.cos(alpha), np.sin(alpha), np.cos(beta), np.sin(beta)
    s2 = np.sin(2 * alpha)
    x = -0.5 * size["r_m"] * (
        ce * cp * (ca**2 * cb - ca**2 + 1) + 0.5 * s2 * ce * sp * (cb - 1)
        - cp * (ca**2 + cb * sa**2) + 0.5 * s2 * sp * (cb - 1) + ca * sb * se
    )  # fmt: skip
    y = size["r_m"] * (ce * sp * (ca**2 + cb * sa**2) + ca * ce * cp * sa * (cb - 1) + sa * sb * se)
    return x, y


def read(size, alpha, beta, phi):
    """The three readings by name, in the order of READINGS; angles of one shape."""
    alpha, beta, phi = np.broadcast_arrays(alpha, beta, phi)
    R, point = dish_facet(size, alpha, beta, phi)
    base = turn_z(phi - np.pi)
    origin = size["d"] * np.stack([np.cos(phi), np.sin(phi), 0 * phi], axis=-1)
    x, y = replaced(size, R, alpha, beta, phi)
    printed = np.stack([x, y, point[..., 2]], axis=-1)
    # The same two conditions, with the components that the facet's axes have in {P}.
    inner = np.swapaxes(base, -1, -2) @ R
    x_P = 0.5 * size["r_m"] * (inner[..., 0, 0] - inner[..., 1, 1])
    y_P = -size["r_m"] * inner[..., 1, 0]
    local = np.stack([x_P, y_P, point[..., 2]], axis=-1)
    points = (point, printed, origin + (base @ local[..., None])[..., 0])
    found = {}
    for name, M in zip(READINGS, points, strict=True):
        arms = size["r_m"] * np.einsum("...ij,kj->...ki", R, CIRCLE)
        S = np.einsum("...ji,...kj->...ki", base, M[..., None, :] + arms - origin[..., None, :])
        rods = S - size["r_b"] * CIRCLE
        across = np.cos(ROUND) * S[..., 1] - np.sin(ROUND) * S[..., 0]
        found[name] = Reading(np.linalg.norm(rods, axis=-1), across)
    return found
