"""The polar tracker once more: as joints in pinocchio, under the sun of ERFA."""

import numpy as np

from armillary.verify.engines import each, need
from armillary.verify.engines.rigid import Fixed, Mechanism, Revolute
from armillary.verify.measured import compare
from armillary.verify.points import directions
from armillary.verify.serial import aim_checks, serial_checks

COUNT = 200
DRIVES = ("epsilon", "D")
ARMS = {"L_0": 2.0, "L_1": 0.5, "L_2": 0.3}
DOWN, WEST = (0, 0, -1), (-1, 0, 0)


def build(point):
    """Column, tilt leaning north for good, post, hour drive, declination drive, arm."""
    return Mechanism(
        [
            Fixed((0, 0, point["L_0"]), rpy=(-point["incl"], 0, 0)),
            Fixed((0, 0, point["L_1"])),
            Revolute(DOWN),
            Revolute(WEST),
            Fixed((0, point["L_2"], 0)),
        ]
    )


def motions():
    """Random mounts, anywhere, moving."""
    random = np.random.default_rng(23)
    lengths = {name: random.uniform(0, 10, COUNT) for name in ("L_0", "L_1", "L_2")}
    angles = {name: random.uniform(-7, 7, COUNT) for name in ("incl", *DRIVES)}
    rates = {f"{name}_dot": random.uniform(-1, 1, COUNT) for name in DRIVES}
    return {**lengths, **angles, **rates}


def checks(kernels):
    """Everything measured about the polar tracker."""
    yield from each(
        kernels,
        motion_by_pinocchio,
        orientation_by_scipy,
        aim_by_pinocchio,
        setting_by_erfa,
        pace_of_the_hour_drive,
    )


def motion_by_pinocchio(kernels):
    """Pose and velocities of the joints."""
    yield from serial_checks(kernels, build, DRIVES, motions())


def orientation_by_scipy(kernels):
    """The fixed tilt and the two turns as Euler angles."""
    rotation = need("scipy.spatial.transform").Rotation
    still = {name: a for name, a in motions().items() if not name.endswith("_dot")}
    angles = np.stack([-still[name] for name in ("incl", *DRIVES)], axis=1)
    yield compare(
        "orientation",
        "SciPy",
        kernels.pose(**still).M[:, :3, :3],
        rotation.from_euler("XZX", angles).as_matrix(),
        1e-13,
        still,
        "pose",
    )


def aim_by_pinocchio(kernels):
    """Aiming at directions all over the sphere, with the tilt anywhere."""
    enu = directions(COUNT, seed=24)
    tilt = np.random.default_rng(26).uniform(-np.pi, np.pi, len(enu))
    # Upright, every awkward direction is as awkward for this mount as for an altazimuth.
    tilt[COUNT:] = 0.0
    mount = {name: np.full(len(enu), a) for name, a in ARMS.items()}
    front = ("cos(D) >= 0", lambda aimed: np.cos(aimed.D))
    given = {"enu": enu, "incl": tilt, **mount}
    yield from aim_checks(kernels, build, DRIVES, given, axis=1, branch=front)


def setting_by_erfa(kernels):
    """The mount set by latitude, declination and hour angle alone."""
    erfa = need("erfa")
    random = np.random.default_rng(25)
    place = {
        "latitude": random.uniform(-np.pi / 2, np.pi / 2, COUNT),
        "declination": random.uniform(-0.41, 0.41, COUNT),
        "hour_angle": random.uniform(-np.pi, np.pi, COUNT),
    }
    azimuth, elevation = erfa.hd2ae(place["hour_angle"], place["declination"], place["latitude"])
    north, east, up = np.moveaxis(erfa.s2c(azimuth, elevation), -1, 0)
    found = kernels.setting(**place)
    drives = np.stack([found.epsilon, found.D], axis=1)
    mounts = [build({**ARMS, "incl": i}) for i in found.incl]
    faced = np.stack([m.pose(q)[:3, 1] for m, q in zip(mounts, drives, strict=True)])
    yield compare(
        "at the setting the collector's second axis is on the sun",
        "ERFA, pinocchio",
        faced,
        np.stack([east, north, up], axis=1),
        1e-14,
        place,
        "setting",
    )


def pace_of_the_hour_drive(kernels):
    """From noon to noon it runs evenly, whatever the season: that is the mount's point."""
    steps = np.linspace(-3, 3, COUNT)
    hours = kernels.setting(latitude=0.7, declination=0.2, hour_angle=steps).epsilon
    yield compare(
        "the hour drive runs at the speed of the hour angle",
        "balance",
        np.diff(hours),
        np.diff(steps),
        1e-14,
        {"hour_angle": steps[1:]},
        "setting",
        turn=True,
    )
