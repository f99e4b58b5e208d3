"""Troughs and motions at which the kernels are checked: at random, and the awkward ones."""

import inspect

import numpy as np

COUNT = 200
STATE = ("theta", "omega", "s", "q", "q_dot")


def call(kernel, points):
    """A kernel at points that may hold more than it takes."""
    taken = inspect.signature(kernel).parameters
    return kernel(**{name: value for name, value in points.items() if name in taken})


def joined(*several):
    """Points of all of several dictionaries, one after the other."""
    return {name: np.concatenate([points[name] for points in several]) for name in several[0]}


def rows(points):
    """The points one by one, each a dictionary of floats."""
    for k in range(len(points["theta"])):
        yield {name: float(value[k]) for name, value in points.items()}


def troughs(random, count=COUNT):
    """Troughs at random, whose tube is full and has moments at random."""
    ends = {
        "M": (5.0, 200.0), "l": (0.0, 0.3), "lam": (-2.2, -0.9), "A_1": (0.02, 0.2),
        "A_2": (0.02, 0.2), "w": (0.05, 0.3), "x_1": (-1.0, -0.3), "y_1": (-0.3, 0.1),
        "x_2": (0.3, 1.0), "y_2": (-0.3, 0.1), "h_10": (0.06, 0.12), "h_20": (0.06, 0.12),
        "h_max": (0.25, 0.4), "a_t": (1e-4, 1e-3), "L_t": (1.0, 3.0),
        "S_t_xi": (-0.3, 0.3), "S_t_eta": (-0.3, 0.3), "I_t": (0.0, 2.0), "Gamma_t": (-0.5, 0.5),
        "rho": (990.0, 1010.0), "g": (1.0, 10.0), "mu": (0.05, 0.3), "r_f": (0.01, 0.06),
        "r_A": (0.3, 2.0), "r_B": (0.3, 2.0), "omega_s": (1e-3, 0.1),
    }  # fmt: skip
    found = {name: random.uniform(*span, count) for name, span in ends.items()}
    spread = random.uniform(0.2, 1.0, count)  # m, from the concentrator's centre of mass
    water = found["rho"] * found["a_t"] * found["L_t"]
    return {**found, "m_t": water, "I_zz": found["M"] * (found["l"] ** 2 + spread**2)}


def motions(random, trough):
    """Motions of troughs: any angle, levels well inside, speeds of either sign."""
    count = len(trough["M"])
    least = np.minimum(trough["A_1"] * trough["h_10"], trough["A_2"] * trough["h_20"])

    def of_either_sign(low, high):
        return random.uniform(low, high, count) * random.choice([-1.0, 1.0], count)

    return {
        **trough, "theta": random.uniform(-np.pi, np.pi, count),
        "omega": of_either_sign(0.2, 3.0), "s": random.uniform(-0.9, 0.9, count) * least,
        "q": of_either_sign(1e-4, 2e-3), "q_dot": of_either_sign(1e-4, 2e-3),
    }  # fmt: skip


def fast(seed, count=COUNT):
    """Motions at random of troughs at random."""
    random = np.random.default_rng(seed)
    return motions(random, troughs(random, count))


def awkward(seed=5):
    """Quarter turns, no speed, no flow, no weight, no water moved, a centre of mass on the axis."""
    quarters = (0.0, np.pi / 2, -np.pi / 2, np.pi, -np.pi, 999.0)
    plain = fast(seed, len(quarters))
    plain["theta"] = np.array(quarters)
    nothing = ({}, {"omega": 0.0}, {"q": 0.0}, {"q": 0.0, "q_dot": 0.0, "omega": 0.0}, {"g": 0.0},
               {"s": 0.0}, {"l": 0.0}, {"Gamma_t": 0.0, "m_t": 0.0, "L_t": 0.0})  # fmt: skip
    return joined(
        *({**plain, **{n: np.full(len(quarters), v) for n, v in one.items()}} for one in nothing)
    )
