"""Suns, receivers and normals that the study looks at, and how far a machine strays there."""

import numpy as np

from .rays import unit

LATITUDE = 43.0  # degrees
OBLIQUITY = 23.44  # degrees, the sun's largest declination
LOWEST = 10.0  # degrees, the lowest sun that is worked with
RISE = 20.0  # degrees, how high the mirrors see the receiver
ROUND = np.arange(0.0, 360.0, 30.0)  # degrees, where mirrors all round a tower see it
SIZES = (1.0, 2.0, 5.0, 10.0)  # mrad
MILLI = 1e-3
EAST, NORTH, UP = np.eye(3)


def exactly(theta=0.0, psi=0.0, chi=0.0):
    """A machine with these misalignments, its encoders without an error."""
    ideal = {"alpha_0": 0.0, "beta_0": 0.0, "collimation": 0.0}
    return {"theta": theta, "psi": psi, "chi": chi, **ideal}


IDEAL = exactly()


def toward(azimuth, elevation):
    """Unit vectors in east, north and up, from degrees."""
    turn, rise = np.radians(azimuth), np.radians(elevation)
    level = np.cos(rise)
    return np.stack([level * np.sin(turn), level * np.cos(turn), np.sin(rise) + 0 * turn], axis=-1)


def azimuth_of(n):
    """Azimuth from north, clockwise, in degrees from 0 to 360."""
    return np.degrees(np.arctan2(n[..., 0], n[..., 1])) % 360.0


def elevation_of(n):
    """Elevation in degrees."""
    return np.degrees(np.arctan2(n[..., 2], np.hypot(n[..., 0], n[..., 1])))


def apart(a, b):
    """Angle between unit vectors, with all its digits when it is small."""
    return 2 * np.arcsin(np.linalg.norm(a - b, axis=-1) / 2)


def rms(x):
    """Root mean square of what has a value."""
    return np.sqrt(np.nanmean(np.square(x)))


def spelled(numbers, form=".2g"):
    """Numbers in a sentence: "1, 2 and 5"."""
    *first, last = (format(x, form) for x in numbers)
    return f"{', '.join(first)} and {last}" if first else last


# -- suns -----------------------------------------------------------------------------------------


def sun_at(declination, hour_angle):
    """Directions to the sun at the plant, from degrees."""
    from armillary_kernels import sun

    return sun.direction(
        latitude=np.radians(LATITUDE),
        declination=np.radians(declination),
        hour_angle=np.radians(hour_angle),
    ).enu


def through_a_day(declination, step=2.5):
    """Hours after apparent noon and directions to the sun, while it is high enough."""
    hour_angle = np.arange(-120.0, 120.0 + step / 2, step)
    c = sun_at(declination, hour_angle)
    high = elevation_of(c) >= LOWEST
    return hour_angle[high] / 15.0, c[high]


def through_a_year():
    """Directions to the sun every half hour of 24 days, evenly spread over a year."""
    days = OBLIQUITY * np.sin(2 * np.pi * (np.arange(24) + 0.5) / 24)
    return np.concatenate([through_a_day(day, 7.5)[1] for day in days])


def facing():
    """The working sky of a mirror that faces the sun."""
    c = through_a_year()
    return {"c": c, "b": c}


def field():
    """The working sky of mirrors all round a tower: each sun with each receiver."""
    c, b = through_a_year(), toward(ROUND, RISE)
    return {"c": np.repeat(c, len(b), axis=0), "b": np.tile(b, (len(c), 1))}


def south_receiver():
    """The receiver of a mirror that stands north of the tower."""
    return toward(180.0, RISE)


def middle(points):
    """The normals that suns and receivers ask for."""
    return unit(points["c"] + points["b"])


def lower_than(points, elevation):
    """Those of the points whose normal is lower, in degrees."""
    low = elevation_of(middle(points)) < elevation
    return {name: array[low] for name, array in points.items()}


def around(elevation, count=72):
    """Mirrors that face the sun at one elevation, all round, in degrees."""
    c = toward(np.arange(count) * 360.0 / count, elevation)
    return {"c": c, "b": c}


# -- a machine that is driven by a law ------------------------------------------------------------


def astray(kernels, points, angles, machine):
    """How far normal and beam are from those that are wanted, with the drives at these angles."""
    n = kernels.normal(alpha=angles.alpha, beta=angles.beta, **machine).n
    beam = kernels.beam(c=points["c"], alpha=angles.alpha, beta=angles.beta, **machine).b
    return apart(n, middle(points)), apart(beam, points["b"])


def beam_shift(points, slip):
    """How far the beam moves, to first order, when the normal slips by a vector."""
    n, c = middle(points), points["c"]
    along = np.sum(c * slip, axis=-1) ** 2
    return 2 * np.sqrt(along + np.sum(c * n, axis=-1) ** 2 * np.sum(slip * slip, axis=-1))
