"""Motions at which the RR-3UPS kernels are checked: at random and fast, and those of Table 1."""

import inspect
from pathlib import Path

import numpy as np

from armillary.verify.parameters import read_parameters
from armillary.verify.points import chosen

from .reference import determinant, jacobian, leg_axes
from .study_basis import mount

COUNT = 200
ANGLES, RATES = ("alpha", "beta"), ("alpha_dot", "beta_dot")
ACCELERATIONS = ("alpha_ddot", "beta_ddot")

# How far random motions keep from what is singular.
LENGTH = 0.15  # m, of a leg
COSINE = 0.2  # of psi, the angle about the second axis of a universal joint
STIFF = 0.05  # m, the smallest singular value of J
BOTH = 0.02  # m^2, the determinant of J's first two rows

TABLE = mount(read_parameters(Path(__file__).with_name("parameters.toml")))  # Table 1


def call(kernel, points):
    """A kernel at points that may hold more than it takes."""
    taken = inspect.signature(kernel).parameters
    return kernel(**{name: value for name, value in points.items() if name in taken})


def joined(*several):
    """Points of all of several dictionaries, one after the other."""
    return {name: np.concatenate([points[name] for points in several]) for name in several[0]}


def rows(points):
    """The points one by one, each a dictionary."""
    for k in range(len(points["alpha"])):
        yield {name: value[k] for name, value in points.items()}


def state(row):
    """Angles, their rates and their accelerations, an array of two each."""
    return [np.array([row[name] for name in pair]) for pair in (ANGLES, RATES, ACCELERATIONS)]


def fast(seed, count=COUNT):
    """Fast motions of machines at random, under random loads, away from what is singular.

    Angles all around, rates and accelerations between 1 and 10 of either sign.
    """
    random = np.random.default_rng(seed)
    found = _regular(_drawn(random, count))
    while len(found["alpha"]) < count:
        found = joined(found, _regular(_drawn(random, count)))
    return {name: value[:count] for name, value in found.items()}


def of_table(angles, **changed):
    """The machine of Table 1 at angles (n, 2); at rest and without loads unless told otherwise."""
    angles = np.asarray(angles, dtype=float)
    still = dict.fromkeys((*RATES, *ACCELERATIONS), 0.0)
    plain = {**TABLE, **still, "f_d": np.zeros(3), "n_d": np.zeros(3)}
    points = {"alpha": angles[:, 0], "beta": angles[:, 1]}
    for name, value in plain.items():
        shape = (len(angles), *np.shape(value))
        points[name] = np.broadcast_to(changed.get(name, value), shape).copy()
    return points


def _regular(points):
    """Those of machines away from what is singular, by the bounds above."""
    _, size, cosine, _ = leg_axes(points)
    J = jacobian(points)
    return chosen(
        points,
        np.all(size > LENGTH, axis=1)
        & np.all(cosine > COSINE, axis=1)
        & (np.linalg.svd(J, compute_uv=False)[:, -1] > STIFF)
        & (np.abs(determinant(J)) > BOTH),
    )


def _drawn(random, count):
    """Machines and motions at random; bodies that could be made of matter."""

    def of_either_sign(low, high):
        return random.uniform(low, high, count) * random.choice([-1.0, 1.0], count)

    def inertia(low, high, *legs):
        spread = random.uniform(low, high, (count, *legs, 3))  # second moments of mass
        return spread.sum(axis=-1, keepdims=True) - spread

    names = (*RATES, *ACCELERATIONS)
    lengths = {
        "r": (0.2, 0.5), "R": (0.3, 1.0), "h": (-0.2, 1.0), "phi": (-4.0, 4.0),
        "theta": (-4.0, 4.0), "zeta": (-4.0, 4.0), "t": (0.05, 0.4), "s": (0.05, 0.4),
        "m_t": (1.0, 15.0), "m_s": (1.0, 15.0),
    }  # fmt: skip
    return {
        "alpha": random.uniform(-np.pi, np.pi, count), "beta": random.uniform(-1.6, 1.6, count),
        **{name: of_either_sign(1.0, 10.0) for name in names},
        **{name: random.uniform(*ends, (count, 3)) for name, ends in lengths.items()},
        "I_t": inertia(0.02, 1.0, 3), "I_s": inertia(0.02, 1.0, 3), "I_m": inertia(3.0, 10.0),
        "h_0": random.uniform(0.3, 1.0, count), "m_m": random.uniform(10.0, 80.0, count),
        "r_sc": random.uniform(-0.1, 0.1, (count, 3)), "g": random.uniform(1.0, 10.0, count),
        "f_d": random.uniform(-500.0, 500.0, (count, 3)),
        "n_d": random.uniform(-200.0, 200.0, (count, 3)),
    }  # fmt: skip
