"""The errors of the paper's introduction: what is assumed of each, and what they add up to."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .rays import unit
from .sky import IDEAL, MILLI, UP, beam_shift, exactly, middle

STEPS = 2**14  # of an encoder, in a turn
PLAY = 1.0  # mrad, of a gear
SAMPLES = 100_000
SEED = 20180319


def normal(sigma):
    """A normal distribution."""
    return sigma, "normal", lambda random, shape: random.normal(0, sigma, shape)


def uniform(half):
    """Anything between two ends alike."""
    sigma, words = half / np.sqrt(3), f"uniform, ±{half:.2g} mrad"
    return sigma, words, lambda random, shape: random.uniform(-half, half, shape)


@dataclass(frozen=True)
class Error:
    """An error of the introduction.

    Attributes:
        mark: its symbol in plain letters.
        of: what is off: "sun", "receiver", "drives", or a misalignment. A direction is off both
            ways across; so are both drives, each on its own.
        sigma: standard deviation in mrad.
        words: its distribution.
        draw: samples of a shape, in mrad, from a generator.
    """

    name: str
    symbol: str
    mark: str
    of: str
    sigma: float
    words: str
    draw: Callable[..., np.ndarray]

    def sample(self, random, count):
        """Samples in rad: (count, 2), or (count,) for a misalignment."""
        shape = (count, 2) if self.of in WAYS else count
        return self.draw(random, shape) * MILLI


WAYS = ("sun", "receiver", "drives")
STEP = 2 * np.pi / STEPS / MILLI
ERRORS = (
    Error("law of motion", "$\\Delta_M$", "ΔM", "sun", *normal(0.2)),
    Error("reflected beam", "$\\Delta_{NO}$", "ΔNO", "receiver", *normal(0.5)),
    Error("base marks", "$\\Delta_N$", "ΔN", "drives", *normal(0.3)),
    Error("encoders", "$\\Delta_{NY}$", "ΔNY", "drives", *uniform(STEP / 2)),
    Error("gears", "$\\Delta_P$", "ΔP", "drives", *uniform(PLAY / 2)),
    Error("lean to the north", "$\\Delta_O{:}\\,\\theta$", "θ", "theta", *normal(0.5)),
    Error("lean to the east", "$\\Delta_O{:}\\,\\psi$", "ψ", "psi", *normal(0.5)),
    Error("inclination", "$\\Delta_O{:}\\,\\chi$", "χ", "chi", *normal(0.5)),
)


@dataclass(frozen=True)
class Spread:
    """Root mean squares in mrad, of the drives and of the beam.

    Attributes:
        lost: share of the machines for which there are no drive angles.
    """

    azimuth: np.ndarray
    elevation: np.ndarray
    beam: np.ndarray
    lost: float = 0.0

    @property
    def three(self):
        """Azimuth, elevation, beam."""
        return self.azimuth, self.elevation, self.beam


def total(spreads):
    """What independent errors add up to."""
    columns = zip(*(spread.three for spread in spreads), strict=True)
    return Spread(*(np.sqrt(sum(a * a for a in column)) for column in columns))


# -- linear ---------------------------------------------------------------------------------------


def across(direction):
    """Two unit vectors square to a direction and to each other; the first is level."""
    level = unit(np.cross(UP, direction))
    return level, np.cross(direction, level)


def linear(kernels, points):
    """The spread that each error makes, by the derivatives of the drive."""
    response = kernels.drive_response(**points, **IDEAL)
    slope = kernels.drive_sensitivity(**points, **IDEAL).J
    return [_one(error, points, response, slope) for error in ERRORS]


def _one(error, points, response, slope):
    def seen(matrix, direction):
        return [np.einsum("...ij,...j->...i", matrix, axis) for axis in across(direction)]

    if error.of == "drives":
        moved = [np.broadcast_to(one, (*points["c"].shape[:-1], 2)) for one in np.eye(2)]
    elif error.of == "sun":
        moved = seen(response.J_c, points["c"])
    elif error.of == "receiver":
        moved = seen(response.J_b, points["b"])
    else:
        moved = [slope[..., ("theta", "psi", "chi").index(error.of)]]
    beams = [beam_shift(points, slip_of(points, both)) for both in moved]
    return Spread(
        *(error.sigma * np.sqrt(sum(both[..., k] ** 2 for both in moved)) for k in (0, 1)),
        error.sigma * np.sqrt(sum(beam**2 for beam in beams)),
    )


def slip_of(points, drives):
    """How far the normal of ideal axes moves when azimuth and elevation drive do."""
    n = middle(points)
    level = np.cross(n, UP)
    rise = np.cross(unit(level), n)
    return drives[..., :1] * level + drives[..., 1:] * rise


# -- Monte Carlo ----------------------------------------------------------------------------------


def monte_carlo(kernels, c, b, errors=ERRORS, count=SAMPLES, seed=SEED):
    """The spread that errors make together, by the exact kernels.

    The angles are calculated for ideal axes from what is believed of sun and receiver; the machine
    adds what its drives are off by, and throws the true sun.
    """
    random = np.random.default_rng(seed)
    believed, tilt, drives = {"c": c, "b": b}, {}, np.zeros((count, 2))
    for error in errors:
        sample = error.sample(random, count)
        if error.of == "drives":
            drives = drives + sample
        elif error.of in WAYS:
            name = {"sun": "c", "receiver": "b"}[error.of]
            first, second = across(believed[name])
            believed[name] = unit(believed[name] + sample[:, :1] * first + sample[:, 1:] * second)
        else:
            tilt[error.of] = sample
    machine = exactly(**tilt)
    calculated = kernels.drive(**believed, **IDEAL)
    valid = kernels.drive(c=c, b=b, **machine)
    alpha, beta = calculated.alpha + drives[:, 0], calculated.beta + drives[:, 1]
    turn = np.remainder(alpha - valid.alpha + np.pi, 2 * np.pi) - np.pi
    thrown = kernels.beam(c=c, alpha=alpha, beta=beta, **machine).b
    off = np.linalg.norm(thrown - b, axis=-1)
    spread = [np.sqrt(np.nanmean(a * a)) / MILLI for a in (turn, beta - valid.beta, off)]
    return Spread(*spread, float(np.mean(np.isnan(turn))))
