"""The quasi-steady tracker once more: as a joint in pinocchio, under the noon sun of ERFA."""

import numpy as np

from armillary.verify.engines import each, need
from armillary.verify.engines.rigid import Fixed, Mechanism, Revolute
from armillary.verify.measured import compare
from armillary.verify.serial import serial_checks

COUNT = 200
WEST = (-1, 0, 0)


def build(point):
    """Column, one axis tipping north, post and arm."""
    return Mechanism(
        [
            Fixed((0, 0, point["L_0"])),
            Revolute(WEST),
            Fixed((0, point["L_2"], point["L_1"])),
        ]
    )


def motions():
    """Random mounts, anywhere, moving."""
    random = np.random.default_rng(20)
    lengths = {name: random.uniform(0, 10, COUNT) for name in ("L_0", "L_1", "L_2")}
    return {
        **lengths,
        "incl": random.uniform(-7, 7, COUNT),
        "incl_dot": random.uniform(-1, 1, COUNT),
    }


def checks(kernels):
    """Everything measured about the quasi-steady tracker."""
    yield from each(kernels, motion_by_pinocchio, orientation_by_scipy, aim_by_erfa)


def motion_by_pinocchio(kernels):
    """Pose and velocities of the joint."""
    yield from serial_checks(kernels, build, ("incl",), motions())


def orientation_by_scipy(kernels):
    """The tilt as a rotation vector."""
    points = motions()
    rotation = need("scipy.spatial.transform").Rotation
    still = {name: points[name] for name in ("incl", "L_0", "L_1", "L_2")}
    yield compare(
        "orientation",
        "SciPy",
        kernels.pose(**still).M[:, :3, :3],
        rotation.from_rotvec(np.outer(points["incl"], WEST)).as_matrix(),
        1e-13,
        still,
        "pose",
    )


def aim_by_erfa(kernels):
    """The noon sun, at places all over the earth."""
    erfa = need("erfa")
    random = np.random.default_rng(21)
    place = {
        "latitude": np.append(random.uniform(-np.pi / 2, np.pi / 2, COUNT), [np.pi / 2, 0.4]),
        "declination": np.append(random.uniform(-0.41, 0.41, COUNT), [0.0, 0.4]),
    }
    azimuth, elevation = erfa.hd2ae(0.0, place["declination"], place["latitude"])
    north, east, up = np.moveaxis(erfa.s2c(azimuth, elevation), -1, 0)
    mount = build({"L_0": 2.0, "L_1": 0.5, "L_2": 0.3})
    aimed = kernels.aim(**place).incl
    yield compare(
        "the aimed collector faces the noon sun",
        "ERFA, pinocchio",
        mount.pose(aimed[:, None])[:, :3, 2],
        np.stack([east, north, up], axis=1),
        1e-14,
        place,
        "aim",
    )
