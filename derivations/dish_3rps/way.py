"""What the rods are told on the way: lengths, rates, forces and normals, by the kernels."""

from dataclasses import dataclass

import numpy as np

from .days import PHI, place

TURN_RATE = 2 * np.pi / 86400  # rad/s of hour angle
CALM = np.zeros(3)


@dataclass(frozen=True)
class Way:
    """A stretch of the way at n times.

    Attributes:
        time: s from the beginning of the experiment.
        lengths: (n, 4, 3), m.
        rates: likewise, m/s.
        forces: what carries facets and rods, N, push positive.
        attitudes: H_R_M, (n, 4, 3, 3).
        origins: M, (n, 4, 3), m.
    """

    time: np.ndarray
    lengths: np.ndarray
    rates: np.ndarray
    forces: np.ndarray
    attitudes: np.ndarray
    origins: np.ndarray

    @property
    def normals(self):
        """The facets' normals, (n, 4, 3)."""
        return self.attitudes[..., :, 2]


def under_the_sun(kernels, sun, parameters, day, clock, speed):
    """Angles of the dish that faces the sun, and their rates: alpha, beta and their `_dot`.

    Args:
        clock: hours, (n,).
        speed: how many times faster than the sun the day goes by.
    """
    where = place(sun, parameters, day, clock)
    found = kernels.aim(enu=sun.direction(**where).enu)
    rates = sun.rates(**where, hour_angle_rate=TURN_RATE * speed)
    return {
        "alpha": found.alpha,
        "beta": found.beta,
        "alpha_dot": -rates.azimuth_rate,
        "beta_dot": -rates.elevation_rate,
    }


def way_of(kernels, shape, plant, time, angles):
    """The way of given angles of the dish and their rates, each (n,)."""
    spread = {name: np.asarray(a)[:, None] for name, a in angles.items()}
    pose = {name: spread[name] for name in ("alpha", "beta")}
    rods = kernels.rod_lengths(**pose, **shape, phi=PHI).l
    rates = kernels.rod_rates(**spread, z_dot=0.0, **shape, phi=PHI).l_dot
    load = {"mass": plant.facet_mass, "centre": plant.facet.centre, "g": plant.gravity}
    forces = kernels.static_forces(**pose, **load, f_d=CALM, n_d=CALM, **shape, phi=PHI).F
    lean = kernels.revolute_angles(**pose, **shape, phi=PHI).p_R
    facet = kernels.facet(**pose, **shape, phi=PHI)
    own = plant.rod_mass * plant.gravity * np.cos(lean)
    return Way(time, rods, rates, forces + own, facet.H_R_M, facet.M)


def day_way(kernels, sun, parameters, shape, plant, start, speed, time):
    """The way through a day from a clock time, at given times of the experiment."""
    clock = start + speed * time / 3600
    day = float(parameters.tracking.day)
    angles = under_the_sun(kernels, sun, parameters, day, clock, speed)
    return way_of(kernels, shape, plant, time, angles)


def move_way(kernels, shape, plant, azimuth, tilts, duration, rest, time):
    """From one tilt of the dish to another at one azimuth, smoothly, after a rest."""
    part = np.clip((time - rest) / duration, 0.0, 1.0)
    done = part**3 * (10 - 15 * part + 6 * part**2)
    pace = 30 * part**2 * (1 - part) ** 2 / duration
    first, last = tilts
    still = np.zeros_like(time)
    angles = {
        "alpha": azimuth + still,
        "beta": first + (last - first) * done,
        "alpha_dot": still,
        "beta_dot": (last - first) * pace,
    }
    return way_of(kernels, shape, plant, time, angles)
