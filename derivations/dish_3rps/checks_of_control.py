"""The control law of a rod against SciPy's filters, and what it does at the bound of the force."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.measured import compare

SAMPLES, RODS = 400, 40
LENGTH = 3.0  # m


def gains(random, most):
    """Laws at random; `most` is the largest force of each."""
    between = random.uniform
    return {
        "K_P": between(1e4, 1e6, RODS), "K_I": between(1e4, 1e7, RODS),
        "K_D": between(1e2, 1e5, RODS), "T_D": between(0.0, 0.02, RODS),
        "T_S": between(2e-4, 5e-3, RODS), "K_V": between(0, 4e3, RODS),
        "F_C": between(0, 200, RODS), "v_C": between(1e-5, 1e-2, RODS), "F_max": most,
    }  # fmt: skip


def signals(random):
    """What the law hears, sample by sample, (samples, rods)."""
    shape = SAMPLES, RODS
    wander = np.cumsum(random.normal(0, 2e-5, shape), axis=0)
    return {
        "l_ref": LENGTH + wander, "l_dot_ref": random.normal(0, 5e-3, shape),
        "l_measured": LENGTH + wander + random.normal(0, 2e-4, shape),
        "F_ff": random.normal(0, 100, shape),
    }  # fmt: skip


def run(kernels, law, heard, start):
    """The forces and the integrals through all samples, from the law's own beginning."""
    first = heard["l_measured"][0]
    state = kernels.rod_control_init(l_measured=first, F_start=start)
    now = {name: getattr(state, name) for name in ("integral", "v", "l_before")}
    forces, integrals = [], []
    for k in range(SAMPLES):
        found = kernels.rod_control_update(**now, **law, **{n: a[k] for n, a in heard.items()})
        now = {name: getattr(found, name) for name in now}
        forces.append(found.F_drive)
        integrals.append(found.integral)
    return np.array(forces), np.array(integrals)


def law_by_scipy(kernels):
    """Far from the bound the law is linear: the filters of its terms, rod by rod."""
    signal = need("scipy.signal")
    random = np.random.default_rng(63)
    law, heard = gains(random, np.full(RODS, 1e5)), signals(random)
    start = random.uniform(-200, 200, RODS)
    forces, _ = run(kernels, law, heard, start)
    wanted = np.empty_like(forces)
    for k in range(RODS):
        of = {name: value[k] for name, value in law.items()}
        said = {name: array[:, k] for name, array in heard.items()}
        error = said["l_ref"] - said["l_measured"]
        # The integral is a sample behind, and begins with the force at the start.
        summed = signal.lfilter([0.0, of["K_I"] * of["T_S"]], [1.0, -1.0], error) + start[k]
        share = of["T_S"] / (of["T_S"] + of["T_D"])
        moved = np.diff(said["l_measured"], prepend=said["l_measured"][0]) / of["T_S"]
        speed = signal.lfilter([share], [1.0, share - 1.0], moved)
        rubbing = of["F_C"] * np.clip(said["l_dot_ref"] / of["v_C"], -1, 1)
        ahead = said["F_ff"] + of["K_V"] * said["l_dot_ref"] + rubbing
        wanted[:, k] = ahead + of["K_P"] * error + summed + of["K_D"] * (said["l_dot_ref"] - speed)
    inputs = {**law, "F_start": start}
    yield compare(
        f"forces of {SAMPLES} samples", "SciPy", forces.T, wanted.T, 1e-9, inputs,
        "rod_control_update",
    )  # fmt: skip


def law_at_its_bound(kernels):
    """The force keeps its bound; the integral never grows towards it while it is kept."""
    random = np.random.default_rng(64)
    law, heard = gains(random, random.uniform(20, 200, RODS)), signals(random)
    forces, integrals = run(kernels, law, heard, 0.0)
    error = heard["l_ref"] - heard["l_measured"]
    kept = np.abs(forces) >= law["F_max"]
    yield compare(
        "the force is at its bound, never beyond", "bounds",
        np.max(np.abs(forces), axis=0), law["F_max"], 0.0, law, "rod_control_update",
    )  # fmt: skip
    grown = np.diff(integrals, axis=0, prepend=0.0)
    towards = kept & (error * forces > 0)
    wanted = np.where(towards, 0.0, law["K_I"] * law["T_S"] * error)
    yield compare(
        "the integral takes every error but those that push on at the bound", "sums",
        grown.T, wanted.T, 1e-9, law, "rod_control_update",
    )  # fmt: skip
