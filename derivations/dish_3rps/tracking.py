"""Experiments with the four facets under the sun: laws side by side on one way."""

from dataclasses import dataclass

import numpy as np

from armillary.verify.engines import need

from .days import mount
from .loop import RODS, Loop
from .plant import corner, gust, nominal, train
from .tuning import law_of
from .way import day_way, move_way

STRETCH = 10000  # control steps that are worked at in one piece
SEED = 6
P_ONLY, PID, AHEAD = "P only", "PID", "PID with feed-forward"
IN_CORNER = "PID, corner plant"
AHEAD_IN_CORNER = "PID with feed-forward, corner plant"
HALVED = "PID, half the step"


@dataclass(frozen=True)
class Stage:
    """What every experiment needs."""

    kernels: object
    native: object
    sun: object
    parameters: object
    gains: dict

    @property
    def shape(self):
        """The dish as the kernels take it."""
        return mount(self.kernels, self.parameters)

    def loop(self, name):
        """A loop by the name of its law and plant."""
        forward = name in (AHEAD, AHEAD_IN_CORNER)
        law = law_of(self.parameters, self.gains["P" if name == P_ONLY else "PID"], forward)
        plant = (corner if name in (IN_CORNER, AHEAD_IN_CORNER) else nominal)(self.parameters)
        return Loop(self.native, self.shape, plant, law, forward, 2 if name == HALVED else 1)

    def day(self, start, speed):
        """The way under the sun from a clock time, as a function of times."""
        known = nominal(self.parameters)  # what is fed forward knows no other plant
        return lambda time: day_way(
            self.native, self.sun, self.parameters, self.shape, known, start, speed, time
        )

    def move(self, azimuth, tilts, duration):
        """The way from one tilt to another, after the time in which a loop settles."""
        known, rest = nominal(self.parameters), self.parameters.tracking.settling
        return lambda time: move_way(
            self.native, self.shape, known, azimuth, tilts, duration, rest, time
        )

    def times(self, duration):
        """Control samples."""
        period = self.parameters.control.T_S
        return np.arange(round(duration / period)) * period


def drive(stage, names, way, time, wind=None, tell=None):
    """Records of the laws and plants that are named, on one way."""
    loops = {name: stage.loop(name) for name in names}
    follow(loops, way, time, wind, tell)
    return {name: loop.record for name, loop in loops.items()}


def follow(loops, way, time, wind=None, tell=None):
    """Take loops along a way."""
    for first in range(0, len(time), STRETCH):
        part = slice(first, first + STRETCH)
        here = way(time[part])
        for loop in loops.values():
            loop.follow(here, None if wind is None else wind[part])
        if tell is not None:
            tell(min(1.0, (first + STRETCH) / len(time)))


def gusts(parameters, time, start, begin):
    """A gust that presses on all mirrors at `start`, and random trains from `begin`, (n, 4), N."""
    given = parameters.gust
    one = -gust(time, start, given.length, given.peak)
    later = time >= begin
    many = np.zeros((len(time), 4))
    many[later] = train(time[later] - begin, given.length, given.peak, given.pause, SEED)
    return one[:, None] + many


def creep(stage, share, duration):
    """The largest speed of a rod that dry friction holds, against a share of it, in m/s.

    The friction of MuJoCo is a soft constraint: what it holds gives way a little all the time.
    """
    loop = stage.loop(PID)
    here = stage.day(stage.parameters.days.first, 1.0)(np.zeros(1))
    loop.begin(here)
    data, friction = loop.machine.data, loop.plant.coulomb
    step, period = need("mujoco").mj_step, stage.parameters.control.T_S
    data.ctrl[:] = here.forces.ravel() + share * friction
    half = round(duration / period / 2)
    step(loop.machine.model, data, half)
    before = loop.machine.lengths.copy()
    step(loop.machine.model, data, half)
    return float(np.abs(loop.machine.lengths - before).max() / (half * period))


# -- what a record says ---------------------------------------------------------------------------


@dataclass(frozen=True)
class Figures:
    """Errors after the start-up.

    Attributes:
        peaks: largest of each rod, (4, 3), m.
        means: root mean square of each rod, (4, 3), m.
        tilts: largest of each facet's normal, (4,), rad.
        force: largest that was asked for, N.
    """

    peaks: np.ndarray
    means: np.ndarray
    tilts: np.ndarray
    force: float

    @property
    def peak(self):
        """The largest error of a rod, m."""
        return float(self.peaks.max())

    @property
    def tilt(self):
        """The largest error of a normal, rad."""
        return float(self.tilts.max())


def figures(record, first, last=np.inf):
    """The errors of a record from one time to another."""
    time = record.joined("time")
    kept = (time >= first) & (time < last)
    errors = record.joined("errors")[kept].reshape(-1, 4, 3)
    looks = record.joined("looks")
    tilts = record.joined("tilts")[(looks >= first) & (looks < last)]
    forces = record.joined("forces")[kept]
    return Figures(
        np.abs(errors).max(axis=0), np.sqrt(np.mean(errors**2, axis=0)), tilts.max(axis=0),
        float(np.abs(forces).max()),
    )  # fmt: skip


def outline(time, errors, points=400):
    """A curve of few points: of each piece the error that is largest, with its sign."""
    size = -(-len(time) // points)
    found = [
        (time[k + at], errors[k + at])
        for k in range(0, len(time), size)
        for at in [int(np.argmax(np.abs(errors[k : k + size])))]
    ]
    return np.array(found).T


def rods_of(record, facet):
    """Errors of a facet's rods, (n, 3), m."""
    return record.joined("errors").reshape(-1, RODS // 3, 3)[:, facet]
