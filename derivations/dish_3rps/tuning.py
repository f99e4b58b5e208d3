"""What a gain is worth: the score of (36) on rods of their own, stability, and the swarm."""

from dataclasses import dataclass

import numpy as np

from .law import Law
from .plant import Rods

MIDDLE = 3.0  # m, where the rod of a trial is
UNSTABLE, LOOSE = 10.0, 1.0  # m s^2: beyond the score of any law that is stable and robust
LOWEST = 0.3  # rad/s, from where the sensitivity is looked at
FREQUENCIES = 500


def law_of(parameters, gains=None, forward=False):
    """The law's parameters; `gains` are K_P, K_I and K_D on the last axis, or a dict of them."""
    law = dict(parameters.control)
    if not forward:
        law.update(K_V=0.0, F_C=0.0)
    if gains is not None:
        named = dict(zip(("K_P", "K_I", "K_D"), np.moveaxis(np.asarray(gains), -1, 0), strict=True))
        law.update(named)
    return law


@dataclass(frozen=True)
class Trial:
    """The experiment that gains are scored on.

    A rod begins at rest, off by an offset, under a load that nothing but the integral will carry,
    and is to follow a cosine of speed: it turns round half-way.
    """

    native: object
    parameters: object
    plants: tuple

    def run(self, gains):
        """Errors before each step, (samples, plants, laws), for gains (laws, 3)."""
        tuning, law = self.parameters.tuning, law_of(self.parameters, gains)
        step, count = law["T_S"], len(gains)
        time = np.arange(round(tuning.duration / step)) * step
        pace = 2 * np.pi / tuning.duration
        wanted = MIDDLE + tuning.speed / pace * np.sin(pace * time)
        rates = tuning.speed * np.cos(pace * time)
        rods = Rods(self.plants, MIDDLE - tuning.offset, count, step)
        load = np.array([p.weight for p in self.plants])[:, None]
        reading = self.plants[0].read
        control = Law(self.native, law, rods.length.shape)
        control.start(reading(rods.length))
        errors = np.empty((len(time), *rods.length.shape))
        for k in range(len(time)):
            errors[k] = wanted[k] - rods.length
            rods.move(control(wanted[k], rates[k], reading(rods.length), 0.0), load)
        return errors

    def scores(self, gains):
        """The integral (36) for each plant and law, m s^2, (plants, laws)."""
        errors, step = np.abs(self.run(gains)), self.parameters.control.T_S
        return np.einsum("t,tpl->pl", np.arange(len(errors)) * step, errors) * step


# -- the linear loop: no dry friction, no bound, no encoder ---------------------------------------


def sensitivity(plant, law):
    """The largest of |1 / (1 + L)| over frequency: 1 over the distance to the critical point."""
    gain = {n: np.atleast_1d(np.asarray(law[n], dtype=float))[:, None] for n in law}
    period = float(law["T_S"])
    s = 1j * np.geomspace(LOWEST, 0.98 * np.pi / period, FREQUENCIES)
    z = np.exp(s * period)
    share = gain["T_S"] / (gain["T_S"] + gain["T_D"])
    speed = share * (1 - 1 / z) / period / (1 - (1 - share) / z)
    control = gain["K_P"] + gain["K_I"] * period / (z - 1) + gain["K_D"] * speed
    holding = (1 - 1 / z) / (s * period)
    moved = 1 / ((plant.moved * s**2 + plant.viscous * s) * (plant.lag * s + 1))
    return np.abs(1 / (1 + control * holding * moved)).max(axis=1)


def radius(plant, law):
    """The largest modulus of the loop's eigenvalues from sample to sample; stable below 1.

    The state is length, speed and force of the rod, then integral, filtered speed and last reading
    of the law; the rod moves as in `Rods`.
    """
    step = float(law["T_S"])
    k_p, k_i, k_d = (np.atleast_1d(np.asarray(law[n], dtype=float)) for n in ("K_P", "K_I", "K_D"))
    share, followed = step / (step + float(law["T_D"])), -np.expm1(-step / plant.lag)
    damped = plant.moved + step * plant.viscous
    one, matrix = np.eye(6), np.zeros((len(k_p), 6, 6))
    filtered = (1 - share) * one[4] + share / step * (one[0] - one[5])
    asked = one[3] - np.outer(k_p, one[0]) - np.outer(k_d, filtered)
    speed = (plant.moved * one[1] + step * one[2]) / damped
    matrix[:, 0], matrix[:, 1] = one[0] + step * speed, speed
    matrix[:, 2] = (1 - followed) * one[2] + followed * asked
    matrix[:, 3] = one[3] - step * np.outer(k_i, one[0])
    matrix[:, 4], matrix[:, 5] = filtered, one[0]
    return np.abs(np.linalg.eigvals(matrix)).max(axis=1)


def worst(measure, plants, law):
    """The larger of both plants' figures, law by law."""
    return np.max([measure(plant, law) for plant in plants], axis=0)


def robust_score(trial, logs):
    """Sum of the plants' scores; a law that is not robust is worse than any that is."""
    gains = 10.0 ** np.asarray(logs)
    law = law_of(trial.parameters, gains)
    rough = worst(sensitivity, trial.plants, law)
    unstable = worst(radius, trial.plants, law)
    score = _told(np.sum(trial.scores(gains), axis=0))
    score = np.where(rough > trial.parameters.tuning.sensitivity, LOOSE * rough, score)
    return np.where(unstable >= 1.0, UNSTABLE * unstable, score)


def plain_score(trial, logs):
    """Sum of the plants' scores and nothing else."""
    return _told(np.sum(trial.scores(10.0 ** np.asarray(logs)), axis=0))


def _told(scores):
    """A law that the kernel refused on its way, for states beyond all limits, is unstable."""
    return np.where(np.isnan(scores), UNSTABLE, scores)


# -- the swarm ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Swarm:
    """The best place, its score, and the best score of each generation."""

    best: np.ndarray
    score: float
    way: np.ndarray


def swarm(objective, box, settings, seed, tell=None):
    """(38) and (39), each rand() a number of its own for each particle and coordinate.

    A particle that leaves the box is put on its wall. Both bests are known before the first step.

    Args:
        objective: takes places (n, k) and gives n scores.
        box: least and greatest, (2, k).
    """
    random = np.random.default_rng(seed)
    low, high = np.asarray(box)
    place = random.uniform(low, high, (settings.particles, len(low)))
    velocity = np.zeros_like(place)
    own, own_score = place.copy(), objective(place)
    way = [own_score.min()]
    for generation in range(settings.generations):
        leader = own[own_score.argmin()]
        velocity = (
            settings.omega * velocity
            + settings.c_1 * random.random(place.shape) * (own - place)
            + settings.c_2 * random.random(place.shape) * (leader - place)
        )
        place = np.clip(place + velocity, low, high)
        score = objective(place)
        better = score < own_score
        own[better], own_score[better] = place[better], score[better]
        way.append(own_score.min())
        if tell is not None:
            tell((generation + 1) / settings.generations)
    first = own_score.argmin()
    return Swarm(own[first].copy(), float(own_score[first]), np.array(way))
