"""The trough as many parcels: sums over masses at their places, moved by the flow.

Nothing is derived here. The dry trough is six point masses. The water is quadrature points along
one path: from the surface of container 2 down to its floor, through a tube of straight pieces, and
up to the surface of container 1. Volume along that path, from the floor of container 2 on, says
where a parcel is; the flow carries every parcel along the path, the turn carries the path. Rates
of sums are complex steps along the motion.
"""

from dataclasses import dataclass

import numpy as np

STEP = 1e-30
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(4)
_NODES, _WEIGHTS = (_NODES + 1) / 2, _WEIGHTS / 2  # on 0 to 1
UP = np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True)
class Sums:
    """Over all parcels of one trough, in world axes; moments are about O."""

    momentum: np.ndarray
    moment: np.ndarray
    kinetic: complex
    potential: complex
    first: np.ndarray
    mass: complex


def bends(p):
    """Corners of the tube, in the frame of the trough: from floor 2, under the axis, to floor 1."""
    return np.array([
        [p["x_2"], p["y_2"]], [p["x_2"] * 0.8, p["y_2"] - p["sag"]],
        [p["x_1"] * 0.7, p["y_1"] - 0.5 * p["sag"]], [p["x_1"], p["y_1"]],
    ])  # fmt: skip


def pieces(p):
    """Start and way of each straight piece of the tube."""
    corners = bends(p)
    return list(zip(corners[:-1], np.diff(corners, axis=0), strict=True))


def tube(p):
    """Parameters of the tube by quadrature: length, mass, moments, and the area it sweeps."""
    found = dict.fromkeys(("L_t", "m_t", "S_t_xi", "S_t_eta", "I_t", "Gamma_t"), 0.0)
    for start, way in pieces(p):
        long = float(np.linalg.norm(way))
        for node, weight in zip(_NODES, _WEIGHTS, strict=True):
            x, y = start + node * way
            mass = p["rho"] * p["a_t"] * long * weight
            parts = {
                "L_t": long * weight, "m_t": mass, "S_t_xi": mass * x, "S_t_eta": mass * y,
                "I_t": mass * (x * x + y * y), "Gamma_t": weight * (x * way[1] - y * way[0]),
            }  # fmt: skip
            found = {name: found[name] + parts[name] for name in found}
    return found


def _dry(p):
    """Masses, places and no speed: six points with the mass, centre and inertia of the dry trough.

    They stand in pairs about the centre of mass, along eta, along xi and along z.
    """
    centre = p["l"] * np.array([np.cos(p["lam"]), np.sin(p["lam"]), 0.0])
    reach = np.sqrt(1.5 * (p["I_zz"] / p["M"] - p["l"] ** 2))
    arms = np.array([[reach, 0, 0], [0, reach, 0], [0, 0, 0.4]])
    places = np.concatenate([centre + arms, centre - arms])
    return np.full(6, p["M"] / 6), places, 0 * places


def _column(p, area, floor, height, rise):
    """Parcels of a container: over its length, width and height; they rise at a speed."""
    z, x, y = np.meshgrid(_NODES - 0.5, _NODES - 0.5, _NODES, indexing="ij")
    weight = np.einsum("i,j,k->ijk", _WEIGHTS, _WEIGHTS, _WEIGHTS).ravel()
    places = np.stack([
        floor[0] + p["w"] * x.ravel(), floor[1] + height * y.ravel(), area / p["w"] * z.ravel()
    ], axis=-1)  # fmt: skip
    return p["rho"] * area * height * weight, places, rise * np.broadcast_to(UP, places.shape)


def _water(p, s, q):
    """Masses, places and speeds in the trough's frame of all water."""
    parts = [
        _column(p, p["A_1"], (p["x_1"], p["y_1"]), p["h_10"] + s / p["A_1"], q / p["A_1"]),
        _column(p, p["A_2"], (p["x_2"], p["y_2"]), p["h_20"] - s / p["A_2"], -q / p["A_2"]),
    ]
    for start, way in pieces(p):
        long = np.linalg.norm(way)
        flat = np.concatenate([start + _NODES[:, None] * way, np.zeros((4, 1))], axis=1)
        speed = q / p["a_t"] * np.append(way / long, 0.0)
        parts.append((p["rho"] * p["a_t"] * long * _WEIGHTS, flat, speed + 0 * flat))
    return parts


def sums(p, theta, omega, s, q):
    """Everything that is summed, at a state that may be complex."""
    parts = [_dry(p), *_water(p, s, q)]
    mass = np.concatenate([m for m, _, _ in parts])
    place = np.concatenate([r for _, r, _ in parts])
    speed = np.concatenate([v for _, _, v in parts])
    c, n = np.cos(theta), np.sin(theta)
    turn = np.array([[c, -n, 0], [n, c, 0], [0, 0, 1]])
    carried = np.stack([-omega * place[:, 1], omega * place[:, 0], 0 * place[:, 0]], axis=-1)
    r, v = place @ turn.T, (speed + carried) @ turn.T
    push = mass[:, None] * v
    return Sums(
        push.sum(axis=0), np.cross(r, push).sum(axis=0), (mass * (v * v).sum(axis=1)).sum() / 2,
        p["g"] * (mass * r[:, 1]).sum(), (mass[:, None] * r).sum(axis=0), mass.sum(),
    )  # fmt: skip


def state(row):
    """theta, omega, s, q of a point."""
    return row["theta"], row["omega"], row["s"], row["q"]


def rates(row, alpha):
    """How fast the sums change along the motion, at an acceleration of theta."""
    speeds = row["omega"], alpha, row["q"], row["q_dot"]
    moved = [x + 1j * STEP * v for x, v in zip(state(row), speeds, strict=True)]
    found = sums(row, *moved)
    return Sums(*(np.imag(getattr(found, name)) / STEP for name in Sums.__dataclass_fields__))


@dataclass(frozen=True)
class Demand:
    """What a motion takes: force of the bearings, the moment about O, and power.

    World axes; from outside, besides the weight.
    """

    force: np.ndarray
    moment: np.ndarray
    power: float


def demand(row, alpha):
    """Newton's and Euler's equations of all parcels, at an acceleration of theta."""
    now, change = sums(row, *state(row)), rates(row, alpha)
    weight = -row["g"] * UP
    return Demand(
        change.momentum - now.mass * weight,
        change.moment - np.cross(now.first, weight),
        float(change.kinetic + change.potential),
    )


def bearings(row, force, moment):
    """Forces of A and B across the axis: four equations of force and moment about O."""
    r_A, r_B = row["r_A"], row["r_B"]
    balance = np.array([[1.0, 0, 1, 0], [0, 1, 0, 1], [0, -r_A, 0, r_B], [r_A, 0, -r_B, 0]])
    found = np.linalg.solve(balance, [force[0], force[1], moment[0], moment[1]])
    return found[:2], found[2:]
