"""The equatorial tracker once more: as joints in pinocchio, and as Euler angles in SciPy."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.engines.rigid import Fixed, Mechanism, Revolute
from armillary.verify.measured import compare
from armillary.verify.points import AWKWARD_DIRECTIONS
from armillary.verify.serial import serial_checks

COUNT = 200
DOWN, WEST = (0, 0, -1), (-1, 0, 0)


def build(point):
    """Column, cradle tipping north, post, roll clockwise seen from its tip, arm."""
    return Mechanism(
        [
            Fixed((0, 0, point["L_0"])),
            Revolute(WEST),
            Fixed((0, 0, point["L_1"])),
            Revolute(DOWN),
            Fixed((0, point["L_2"], 0)),
        ]
    )


def motions():
    """Random mounts, anywhere, moving."""
    random = np.random.default_rng(17)
    lengths = {name: random.uniform(0, 10, COUNT) for name in ("L_0", "L_1", "L_2")}
    angles = {name: random.uniform(-7, 7, COUNT) for name in ("incl", "epsilon")}
    rates = {f"{name}_dot": random.uniform(-1, 1, COUNT) for name in angles}
    return {**lengths, **angles, **rates}


def directions():
    """Random directions all over the sphere, and the awkward ones."""
    random = np.random.default_rng(18).normal(size=(COUNT, 3))
    random /= np.linalg.norm(random, axis=1, keepdims=True)
    return np.concatenate([random, np.array(AWKWARD_DIRECTIONS)])


def checks(kernels):
    """Everything measured about the equatorial tracker."""
    points = motions()
    yield from serial_checks(kernels, build, ("incl", "epsilon"), points)

    rotation = need("scipy.spatial.transform").Rotation
    turned = rotation.from_euler("XZ", np.stack([-points["incl"], -points["epsilon"]], axis=1))
    still = {name: points[name] for name in ("incl", "epsilon", "L_0", "L_1", "L_2")}
    yield compare(
        "orientation",
        "SciPy",
        kernels.pose(**still).M[:, :3, :3],
        turned.as_matrix(),
        1e-13,
        still,
        "pose",
    )

    enu = directions()
    aimed = kernels.aim(enu=enu)
    mount = build({"L_0": 2.0, "L_1": 0.5, "L_2": 0.3})
    axis = mount.pose(np.stack([aimed.incl, aimed.epsilon], axis=1))[:, :3, 1]
    regular = aimed.status == 0
    yield compare(
        "the aimed collector's second axis is on the sun",
        "pinocchio",
        axis[regular],
        enu[regular],
        1e-14,
        {"enu": enu[regular]},
        "aim",
    )
    yield compare(
        "on the tilt axis it is there within the tolerance of the singularity",
        "pinocchio",
        axis[~regular],
        enu[~regular],
        2e-6,
        {"enu": enu[~regular]},
        "aim",
    )
    yield compare(
        "the branch is cos(epsilon) >= 0",
        "round trip",
        np.minimum(np.cos(aimed.epsilon), 0),
        np.zeros(len(enu)),
        0.0,
        {"enu": enu},
        "aim",
    )
    posed = kernels.pose(incl=aimed.incl, epsilon=aimed.epsilon, L_0=2.0, L_1=0.5, L_2=0.3)
    yield compare(
        "aim and pose undo each other",
        "round trip",
        posed.M[regular, :3, 1],
        enu[regular],
        1e-14,
        {"enu": enu[regular]},
        "aim",
    )
