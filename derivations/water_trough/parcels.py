"""The trough as many parcels: sums over masses at their places, moved by the flow.

Nothing is derived here. The dry trough is six point masses. The water fills one path: from the
surface of container 2 down to its floor, through a tube of straight pieces, and up to the surface
of container 1. Every stretch of the path tells where its middle line begins and ends, and what
volume it holds. The flow carries volume along the path, the turn carries the path: a parcel moves
at the flow times the way of its stretch per volume. The parcels that are summed are those at fixed
parts of each stretch, by Gauss's rule; a stretch in a container ends at the surface, wherever that
is. Rates of sums are complex steps along the motion.
"""

from dataclasses import dataclass
from itertools import pairwise

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
    z_1, z_2 = p.get("z_1", 0.0), p.get("z_2", 0.0)
    return np.array([
        [p["x_2"], p["y_2"], z_2], [p["x_2"] * 0.8, p["y_2"] - p["sag"], 1.5 * z_2],
        [p["x_1"] * 0.7, p["y_1"] - 0.5 * p["sag"], z_1 - z_2], [p["x_1"], p["y_1"], z_1],
    ])  # fmt: skip


def _tube_parcels(p):
    """Length, place and direction of the tube at the points of Gauss's rule."""
    corners = bends(p)
    for start, way in zip(corners[:-1], np.diff(corners, axis=0), strict=True):
        for node, weight in zip(_NODES, _WEIGHTS, strict=True):
            yield weight * np.linalg.norm(way), start + node * way, weight * way


def tube(p):
    """Parameters of the tube by quadrature: length, mass, moments, and the area it sweeps."""
    found = dict.fromkeys(("L_t", "m_t", "S_t_xi", "S_t_eta", "I_t", "Gamma_t"), 0.0)
    for long, (x, y, _), way in _tube_parcels(p):
        mass = p["rho"] * p["a_t"] * long
        parts = {
            "L_t": long, "m_t": mass, "S_t_xi": mass * x, "S_t_eta": mass * y,
            "I_t": mass * (x * x + y * y), "Gamma_t": x * way[1] - y * way[0],
        }  # fmt: skip
        found = {name: float(found[name] + parts[name]) for name in found}
    return found


def offsets(p):
    """What symmetry about the plane z = 0 makes 0, of tube and dry trough, by quadrature."""
    masses, places, _ = _dry(p)
    x, y, z = places.T
    found = {"S_z": masses @ z, "D_xi": masses @ (x * z), "D_eta": masses @ (y * z)}
    found.update(G_xi=0.0, G_eta=0.0)
    for long, (x, y, z), way in _tube_parcels(p):
        mass = p["rho"] * p["a_t"] * long
        parts = {
            "S_z": mass * z, "D_xi": mass * x * z, "D_eta": mass * y * z,
            "G_xi": y * way[2] - z * way[1], "G_eta": z * way[0] - x * way[2],
        }  # fmt: skip
        found = {name: float(found[name] + parts[name]) for name in found}
    return found


def _dry(p):
    """Masses, places and no speed: six points with the mass, centre and inertia of the dry trough.

    They stand in pairs about the centre of mass, along eta, along xi and along z. The centre may
    be off the middle plane, by `z_M`, and the pairs across the axis may lean, by `lean`.
    """
    lean = p.get("lean", 0.0)
    middle = [p["l"] * np.cos(p["lam"]), p["l"] * np.sin(p["lam"]), p.get("z_M", 0.0)]
    reach = np.sqrt(1.5 * (p["I_zz"] / p["M"] - p["l"] ** 2))
    arms = np.array([[reach, 0, lean], [0, reach, -2 * lean], [0, 0, 0.4]])
    places = np.concatenate([middle + arms, middle - arms])
    return np.full(6, p["M"] / 6), places, 0 * places


@dataclass(frozen=True)
class Stretch:
    """A part of the water's path: its middle line, the volume along it, how wide it spreads."""

    begin: np.ndarray
    end: np.ndarray
    volume: complex
    across: float = 0.0
    along: float = 0.0

    def parcels(self, density, flow):
        """Masses, places and speeds, in the frame of the trough."""
        wide = [_NODES if extent else np.array([0.5]) for extent in (self.across, self.along)]
        weigh = [_WEIGHTS if extent else np.array([1.0]) for extent in (self.across, self.along)]
        u, x, z = (part.ravel() for part in np.meshgrid(_NODES, *wide, indexing="ij"))
        weight = np.einsum("i,j,k->ijk", _WEIGHTS, *weigh).ravel()
        way = self.end - self.begin
        spread = np.stack([self.across * (x - 0.5), 0 * x, self.along * (z - 0.5)], axis=-1)
        places = self.begin + u[:, None] * way + spread
        return density * self.volume * weight, places, flow * way / self.volume + 0 * places


def path(p, s):
    """The stretches from the surface in container 2 to the surface in container 1.

    Containers and the tube between them may stand off the middle plane, at `z_1` and `z_2`.
    """
    ends = {}
    for k, volume in ((1, p["A_1"] * p["h_10"] + s), (2, p["A_2"] * p["h_20"] - s)):
        floor = np.array([p[f"x_{k}"], p[f"y_{k}"], p.get(f"z_{k}", 0.0)])
        surface = floor + volume / p[f"A_{k}"] * UP
        ends[k] = floor, surface, volume, p["w"], p[f"A_{k}"] / p["w"]
    floor, surface, *rest = ends[2]
    found = [Stretch(surface, floor, *rest)]
    corners = bends(p)
    for begin, end in pairwise(corners):
        found.append(Stretch(begin, end, p["a_t"] * np.linalg.norm(end - begin)))
    floor, surface, *rest = ends[1]
    return [*found, Stretch(floor, surface, *rest)]


def sums(p, theta, omega, s, q):
    """Everything that is summed, at a state that may be complex."""
    parts = [_dry(p), *(stretch.parcels(p["rho"], q) for stretch in path(p, s))]
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
