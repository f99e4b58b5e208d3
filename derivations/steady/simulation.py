"""The steady collector once more: as a placement in pinocchio, and its incidence in pvlib."""

import numpy as np

from armillary.verify.engines import each, need
from armillary.verify.engines.rigid import Fixed, Mechanism
from armillary.verify.measured import compare

COUNT = 200


def build(point):
    """Column, a fixed tilt leaning north, post and arm."""
    return Mechanism(
        [
            Fixed((0, 0, point["L_0"]), rpy=(-point["tilt"], 0, 0)),
            Fixed((0, point["L_2"], point["L_1"])),
        ]
    )


def mounts():
    """Random collectors, tilted anyhow."""
    random = np.random.default_rng(22)
    points = {name: random.uniform(0, 10, COUNT) for name in ("L_0", "L_1", "L_2")}
    return {**points, "tilt": random.uniform(-np.pi, np.pi, COUNT)}


def checks(kernels):
    """Everything measured about the steady collector."""
    yield from each(kernels, placement_by_pinocchio, incidence_by_pvlib)


def placement_by_pinocchio(kernels):
    """Where the collector stands, and where it faces."""
    points = mounts()
    rows = [{name: a[k] for name, a in points.items()} for k in range(COUNT)]
    placed = np.stack([build(row).pose(np.zeros(0)) for row in rows])
    yield compare("pose", "pinocchio", kernels.pose(**points).M, placed, 1e-13, points, "pose")
    yield compare(
        "normal", "pinocchio", kernels.normal(**points).normal, placed[:, :3, 2], 1e-13, points,
        "normal",
    )  # fmt: skip


def incidence_by_pvlib(kernels):
    """The sun anywhere, below the horizon too."""
    points, random = mounts(), np.random.default_rng(27)
    irradiance = need("pvlib.irradiance")
    elevation = random.uniform(-np.pi / 2, np.pi / 2, COUNT)
    azimuth = random.uniform(0, 2 * np.pi, COUNT)
    level = np.cos(elevation)
    enu = np.stack([level * np.sin(azimuth), level * np.cos(azimuth), np.sin(elevation)], axis=1)
    # pvlib tilts towards an azimuth: a collector leaning south faces 180 degrees.
    wanted = irradiance.aoi(
        np.degrees(np.abs(points["tilt"])),
        np.where(points["tilt"] < 0, 180.0, 0.0),
        90 - np.degrees(elevation),
        np.degrees(azimuth),
    )
    found = kernels.incidence(enu=enu, **points).incidence
    clear = np.abs(np.cos(found)) < np.cos(np.radians(1))  # the arc cosine is blunt at its ends
    given = {"enu": enu, "tilt": points["tilt"]}
    yield compare(
        "incidence, more than 1 deg from 0 and 180",
        "pvlib",
        found[clear],
        np.radians(wanted)[clear],
        1e-13,
        {name: a[clear] for name, a in given.items()},
        "incidence",
    )
    yield compare(
        "incidence",
        "pvlib",
        np.cos(found),
        np.cos(np.radians(wanted)),
        1e-14,
        given,
        "incidence",
    )
