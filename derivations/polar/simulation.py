"""The polar tracker once more: as joints in pinocchio, under the sun of ERFA."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.engines.rigid import Fixed, Mechanism, Revolute
from armillary.verify.measured import compare
from armillary.verify.points import AWKWARD_DIRECTIONS
from armillary.verify.serial import serial_checks

COUNT = 200
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


def second_axes(mounts, hours, declinations):
    """Where the collectors' second axes point."""
    drives = np.stack([hours, declinations], axis=1)
    return np.stack([m.pose(q)[:3, 1] for m, q in zip(mounts, drives, strict=True)])


def motions():
    """Random mounts, anywhere, moving."""
    random = np.random.default_rng(23)
    lengths = {name: random.uniform(0, 10, COUNT) for name in ("L_0", "L_1", "L_2")}
    angles = {name: random.uniform(-7, 7, COUNT) for name in ("incl", "epsilon", "D")}
    rates = {f"{name}_dot": random.uniform(-1, 1, COUNT) for name in ("epsilon", "D")}
    return {**lengths, **angles, **rates}


def checks(kernels):
    """Everything measured about the polar tracker."""
    points = motions()
    yield from serial_checks(kernels, build, ("epsilon", "D"), points)

    rotation = need("scipy.spatial.transform").Rotation
    angles = np.stack([-points[name] for name in ("incl", "epsilon", "D")], axis=1)
    still = {name: a for name, a in points.items() if not name.endswith("_dot")}
    yield compare(
        "orientation",
        "SciPy",
        kernels.pose(**still).M[:, :3, :3],
        rotation.from_euler("XZX", angles).as_matrix(),
        1e-13,
        still,
        "pose",
    )
    yield from aim_checks(kernels)
    yield from setting_checks(kernels)


def aim_checks(kernels):
    """Aiming at directions all over the sphere, with the tilt anywhere."""
    random = np.random.default_rng(24)
    enu = random.normal(size=(COUNT, 3))
    enu /= np.linalg.norm(enu, axis=1, keepdims=True)
    enu = np.concatenate([enu, np.array(AWKWARD_DIRECTIONS)])
    tilt = random.uniform(-np.pi, np.pi, COUNT)
    # Upright, every awkward direction is as awkward for this mount as for an altazimuth.
    tilt = np.concatenate([tilt, np.zeros(len(AWKWARD_DIRECTIONS))])
    arms = {"L_0": 2.0, "L_1": 0.5, "L_2": 0.3}
    aimed = kernels.aim(enu=enu, incl=tilt)
    axis = second_axes([build({**arms, "incl": i}) for i in tilt], aimed.epsilon, aimed.D)
    regular = aimed.status == 0
    given = {"enu": enu, "incl": tilt}
    yield compare(
        "the aimed collector's second axis is on the sun",
        "pinocchio",
        axis[regular],
        enu[regular],
        1e-14,
        {name: a[regular] for name, a in given.items()},
        "aim",
    )
    yield compare(
        "on the polar axis it is there within the tolerance of the singularity",
        "pinocchio",
        axis[~regular],
        enu[~regular],
        2e-6,
        {name: a[~regular] for name, a in given.items()},
        "aim",
    )
    yield compare(
        "the branch is cos(D) >= 0",
        "round trip",
        np.minimum(np.cos(aimed.D), 0),
        np.zeros(len(enu)),
        0.0,
        given,
        "aim",
    )
    posed = kernels.pose(epsilon=aimed.epsilon, D=aimed.D, incl=tilt, **arms)
    yield compare(
        "aim and pose undo each other",
        "round trip",
        posed.M[regular, :3, 1],
        enu[regular],
        1e-14,
        {name: a[regular] for name, a in given.items()},
        "aim",
    )


def setting_checks(kernels):
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
    arms = {"L_0": 2.0, "L_1": 0.5, "L_2": 0.3}
    mounts = [build({**arms, "incl": i}) for i in found.incl]
    yield compare(
        "at the setting the collector's second axis is on the sun",
        "ERFA, pinocchio",
        second_axes(mounts, found.epsilon, found.D),
        np.stack([east, north, up], axis=1),
        1e-14,
        place,
        "setting",
    )
    # From noon to noon the hour drive runs evenly, whatever the season: that is the mount's point.
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
