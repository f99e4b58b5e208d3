"""The altazimuth tracker once more: as joints in pinocchio, and as Euler angles in SciPy."""

import numpy as np

from armillary.verify.engines import each, need
from armillary.verify.engines.rigid import Fixed, Mechanism, Revolute
from armillary.verify.measured import compare
from armillary.verify.points import directions
from armillary.verify.serial import aim_checks, serial_checks

COUNT = 200
DRIVES = ("gamma", "upsilon")
DOWN, WEST = (0, 0, -1), (-1, 0, 0)


def build(point):
    """Column, turntable turning clockwise seen from above, post, cradle tipping over, arm."""
    return Mechanism(
        [
            Fixed((0, 0, point["L_0"])),
            Revolute(DOWN),
            Fixed((0, 0, point["L_1"])),
            Revolute(WEST),
            Fixed((0, point["L_2"], 0)),
        ]
    )


def motions():
    """Random mounts, anywhere, moving."""
    random = np.random.default_rng(14)
    lengths = {name: random.uniform(0, 10, COUNT) for name in ("L_0", "L_1", "L_2")}
    angles = {name: random.uniform(-7, 7, COUNT) for name in DRIVES}
    rates = {f"{name}_dot": random.uniform(-1, 1, COUNT) for name in DRIVES}
    return {**lengths, **angles, **rates}


def checks(kernels):
    """Everything measured about the altazimuth tracker."""
    yield from each(kernels, motion_by_pinocchio, orientation_by_scipy, aim_by_pinocchio)


def motion_by_pinocchio(kernels):
    """Pose and velocities of the joints."""
    yield from serial_checks(kernels, build, DRIVES, motions())


def orientation_by_scipy(kernels):
    """The two turns as Euler angles."""
    rotation = need("scipy.spatial.transform").Rotation
    still = {name: a for name, a in motions().items() if not name.endswith("_dot")}
    turned = rotation.from_euler("ZX", -np.stack([still[name] for name in DRIVES], axis=1))
    yield compare(
        "orientation",
        "SciPy",
        kernels.pose(**still).M[:, :3, :3],
        turned.as_matrix(),
        1e-13,
        still,
        "pose",
    )


def aim_by_pinocchio(kernels):
    """Aiming at directions all over the sphere."""
    enu = directions(COUNT, seed=15)
    mount = {name: np.full(len(enu), a) for name, a in (("L_0", 2.0), ("L_1", 0.5), ("L_2", 0.3))}
    upright = ("0 <= upsilon <= pi", lambda aimed: np.minimum(aimed.upsilon, np.pi - aimed.upsilon))
    yield from aim_checks(kernels, build, DRIVES, {"enu": enu, **mount}, axis=2, branch=upright)
