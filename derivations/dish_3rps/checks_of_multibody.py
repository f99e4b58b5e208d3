"""Poses and rod forces against a MuJoCo machine of hinges, slides and ball joints."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.measured import compare

from .multibody import (
    AZIMUTHS,
    FACETS,
    LEGS,
    Facet,
    Rod,
    bases,
    build,
    hold,
    holding_forces,
    push,
    stand,
    turn_z,
)

COUNT = 10
STEP = 5e-4  # s: the constraints yield with its square
MOVED, SETTLED = 2000, 1000  # steps
ROD = Rod(mass=8.0, screw=50.0, viscous=2000.0)  # at rest its numbers do not matter


def machines():
    """Ten sizes of dish with an attitude each; the second has beta = 0."""
    random = np.random.default_rng(61)
    found = [
        {
            "alpha": random.uniform(-np.pi, np.pi), "beta": random.uniform(0.0, 1.2),
            "f": random.uniform(1.0, 2.0), "d": random.uniform(0.4, 0.9),
            "r_b": random.uniform(0.15, 0.5), "r_m": random.uniform(0.3, 0.7),
            "z_O": random.uniform(2.6, 3.4),
        }
        for _ in range(COUNT)
    ]  # fmt: skip
    found[1]["beta"] = 0.0
    return found


def settled(kernels, given, facet, wrench=None):
    """A machine whose rods have taken the lengths of an attitude, from level facets, at rest.

    Args:
        wrench: force and torque about M of each facet, (4, 3) both, in N and N m.
    """
    step = need("mujoco").mj_step
    machine = build(given, facet, ROD, STEP, held=True, weightless=True)
    feet, _ = bases(given)
    level = feet.mean(axis=1) + np.array([0.0, 0.0, given["z_O"]])
    first = stand(machine, given, turn_z(AZIMUTHS - np.pi), level)
    wanted = kernels.rod_lengths(**given, phi=AZIMUTHS).l
    for k in range(MOVED + SETTLED):
        part = min(k / MOVED, 1.0)
        hold(machine, first + part**3 * (10 - 15 * part + 6 * part**2) * (wanted - first))
        if wrench is not None:
            push(machine, *wrench, machine.origins)
        step(machine.model, machine.data)
    need("mujoco").mj_forward(machine.model, machine.data)
    return machine


def of_each_facet(points):
    """The inputs facet by facet, to name the worst."""
    names = points[0]
    spread = {n: np.repeat([p[n] for p in points], FACETS, axis=0) for n in names}
    return {**spread, "phi": np.tile(AZIMUTHS, len(points))}


def poses_by_mujoco(kernels):
    """Told only the rods' lengths, the facets settle where the kernel says."""
    points = machines()
    posed = [settled(kernels, given, Facet(30.0)) for given in points]
    inputs = of_each_facet(points)
    found = kernels.facet(**inputs)
    for what, wanted in (("M", "origins"), ("H_R_M", "attitudes")):
        settled_at = np.concatenate([getattr(machine, wanted) for machine in posed])
        yield compare(
            f"{what} of the facet that the rods hold", "MuJoCo", getattr(found, what), settled_at,
            1e-8, inputs, "facet", relative=False,
        )  # fmt: skip


def forces_by_mujoco(kernels):
    """What holds the rods under the weight of a lopsided facet and under wind."""
    random = np.random.default_rng(62)
    points = machines()
    loads = [
        {
            "mass": random.uniform(20.0, 60.0), "centre": random.uniform(-0.1, 0.1, 3),
            "f_d": random.uniform(-200, 200, (FACETS, 3)),
            "n_d": random.uniform(-50, 50, (FACETS, 3)),
        }
        for _ in points
    ]  # fmt: skip
    held = []
    for given, load in zip(points, loads, strict=True):
        facet = Facet(load["mass"], tuple(load["centre"]))
        machine = settled(kernels, given, facet, (load["f_d"], load["n_d"]))
        held.append(holding_forces(machine))
    inputs = of_each_facet(points)
    for name in ("mass", "centre"):
        inputs[name] = np.repeat([load[name] for load in loads], FACETS, axis=0)
    for name in ("f_d", "n_d"):
        inputs[name] = np.concatenate([load[name] for load in loads])
    yield compare(
        "static forces of the rods", "MuJoCo", kernels.static_forces(**inputs, g=9.81).F,
        np.reshape(held, (-1, LEGS)), 1e-6, inputs, "static_forces",
    )  # fmt: skip
