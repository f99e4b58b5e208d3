"""What is driven: the rods with their screws and facets, as numbers, and a rod on its own."""

from dataclasses import dataclass, replace

import numpy as np

from .multibody import Facet, Rod


@dataclass(frozen=True)
class Plant:
    """A facet on three rods, with the drive of each; SI units."""

    facet_mass: float
    facet_radius: float
    centre_height: float
    rod_mass: float
    section_length: float
    screw_lead: float
    screw_inertia: float
    viscous: float
    coulomb: float
    lag: float
    limit: float
    encoder: float
    gravity: float

    @property
    def screw(self) -> float:
        """What the turning screw adds to the mass along its rod, kg."""
        return (2 * np.pi / self.screw_lead) ** 2 * self.screw_inertia

    @property
    def moved(self) -> float:
        """The mass that a rod moves: its third of the facet, its own, and its screw, kg."""
        return self.facet_mass / 3 + self.rod_mass + self.screw

    @property
    def weight(self) -> float:
        """What an upright rod carries, N."""
        return (self.facet_mass / 3 + self.rod_mass) * self.gravity

    @property
    def facet(self) -> Facet:
        """A thin disc above the plane of the ball joints."""
        across = self.facet_mass * self.facet_radius**2 / 4
        return Facet(self.facet_mass, (0.0, 0.0, self.centre_height), (across, across, 2 * across))

    @property
    def rod(self) -> Rod:
        """As the multibody model takes it."""
        return Rod(
            self.rod_mass, self.section_length, self.screw, self.viscous, self.coulomb, self.lag,
            self.limit,
        )  # fmt: skip

    def read(self, length):
        """Lengths in m as the encoder tells them."""
        told = length / self.encoder
        np.rint(told, told)
        told *= self.encoder
        return told


def nominal(parameters):
    """The plant that the law is tuned for."""
    return Plant(**parameters.plant)


def corner(parameters):
    """The plant that the law must bear as well."""
    return replace(nominal(parameters), **parameters.corner)


# -- a rod on its own -----------------------------------------------------------------------------


class Rods:
    """Rods of their own, each of a plant: stick-slip solved exactly in each step.

    Args:
        plants: k of them.
        start: length of every rod at the beginning, m; they are at rest and no force acts.
        count: n rods of each plant.
        step: s; the load and the command are constant through it.
    """

    def __init__(self, plants, start, count, step):
        def column(name):
            return np.array([float(getattr(p, name)) for p in plants])[:, None]

        self.step = step
        mass = column("moved")
        damped = mass + step * column("viscous")  # the viscous force at the end of the step
        self.kept, self.gained = mass / damped, step / damped
        self.stopped = self.gained * column("coulomb")
        self.followed = -np.expm1(-step / np.maximum(column("lag"), 1e-9))
        self.limit = column("limit")
        self.length = np.full((len(plants), count), float(start))
        self.speed = np.zeros_like(self.length)
        self.force = np.zeros_like(self.length)

    def move(self, command, load):
        """One step: what friction cannot stop moves on."""
        free = self.kept * self.speed + self.gained * (self.force - load)
        self.speed = np.sign(free) * np.maximum(np.abs(free) - self.stopped, 0.0)
        self.length = self.length + self.step * self.speed
        command = np.clip(command, -self.limit, self.limit)
        self.force = self.force + self.followed * (command - self.force)


# -- wind -----------------------------------------------------------------------------------------


def gust(time, start, length, peak):
    """One minus a cosine, from nothing to the peak and back."""
    phase = np.clip((time - start) / length, 0.0, 1.0)
    return peak * (1 - np.cos(2 * np.pi * phase)) / 2


def train(time, length, peak, pause, seed):
    """A gust after another on each facet, (n, 4): random peaks of both signs, random pauses."""
    random = np.random.default_rng(seed)
    found = np.zeros((len(time), 4))
    for k in range(4):
        start = random.exponential(pause)
        while start < time[-1]:
            found[:, k] += gust(time, start, length, random.uniform(-peak, peak))
            start += length + random.exponential(pause)
    return found
