"""The trough in time: the book of energy, swings, following, and breaking away."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from armillary.verify.engines import need
from armillary.verify.measured import compare
from armillary.verify.parameters import read_parameters

from .motion_of import Motion, closed, compiled, energies
from .pumping import Piece, experiment, joined
from .troughs import trough

PARAMETERS = read_parameters(Path(__file__).with_name("parameters.toml"))


def small(**changed):
    """The smaller trough of the study."""
    return {**trough(PARAMETERS), **changed}


def energy_closes(kernels):
    """Over three pulses of the pump; with friction the trough stands after each."""
    fast = compiled(kernels)
    pieces, long = experiment(PARAMETERS.pulses, 1.0), PARAMETERS.pulses.length
    for given, part, what in (
        (small(), 1e-8, "with stick and slip"), (small(mu=0.0), 1e-9, "without friction"),
    ):  # fmt: skip
        first = float(fast.rest_angle(s=0.0, **given).theta)
        record = Motion(fast, given).run(pieces, first)
        span = np.ptp(energies(fast, given, record))
        lost = np.max(np.abs(closed(fast, given, record))) / span
        at = {"seconds": long, "mu": given["mu"], "steps": len(record.rows)}
        yield compare(
            f"energy over {long:g} s {what}, by its range", "SciPy", lost, 0.0, part, at,
            "pump_pressure", relative=False,
        )  # fmt: skip
        end = record.rows[-1][0]
        yield compare(f"all of the {long:g} s {what}", "SciPy", end, long, 1e-9, at)
        if given["mu"]:
            stands = [name for _, _, name in record.events].count("stick")
            yield compare(
                "the trough stands before each pulse and after the last", "SciPy",
                float(stands >= 4), 1.0, 0.0, {**at, "stands": stands}, "acceleration",
            )  # fmt: skip


# -- swings ---------------------------------------------------------------------------------------


def _period(kernels, given, amplitude):
    """Between turning points of the same side, of a swing from an amplitude off the rest."""
    rest = float(kernels.rest_angle(s=0.0, **given).theta)
    long = 4 * float(kernels.rest(s=0.0, **given).period)
    record = Motion(kernels, given, book=False).run(joined(0.0, 0.0, (long, 0.0)), rest + amplitude)
    turns = [time for time, _, _ in record.events]
    return turns[2] - turns[0]


def swings(kernels):
    """Without tube a pendulum: large swings by the elliptic integral, small ones to 2nd order."""
    fast, ellipk = compiled(kernels), need("scipy.special").ellipk
    nothing = dict.fromkeys(("m_t", "S_t_xi", "S_t_eta", "I_t", "Gamma_t", "L_t", "mu"), 0.0)
    given = small(**nothing)
    short = float(fast.rest(s=0.0, **given).period)
    amplitudes = np.array([0.1, 0.2, 1.0, 2.0, 3.0])
    found = np.array([_period(fast, given, a) for a in amplitudes])
    wanted = short * 2 / np.pi * ellipk(np.sin(amplitudes / 2) ** 2)
    at = {"amplitude": amplitudes}
    yield compare(
        "period of swings", "SciPy's elliptic integral", found, wanted, 1e-9, at, "acceleration"
    )
    order = np.log2((found[1] - short) / (found[0] - short))
    yield compare(
        "order of the period of small swings", "halving", order, 2.0, 0.02, {"amplitude": 0.2},
        "rest", relative=False,
    )  # fmt: skip


# -- following ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Following:
    """The flow at which the rest turns at a steady rate, as a piece of flow."""

    kernels: object
    given: dict
    first: float
    rate: float
    start: float
    end: float
    idle = False

    def volume(self, time):
        """At which the trough rests where it is to be."""
        return self.kernels.rest_volume(theta=self.first + self.rate * time, **self.given).s

    def flow(self, s):
        """That the kernel gives."""
        return self.kernels.follow(s=s, theta_dot_ref=self.rate, **self.given).q

    def __call__(self, time):
        """Volume, flow and its rate."""
        s = self.volume(time)
        q, step = self.flow(s), 1e-6
        return s, q, (self.flow(s + step) - self.flow(s - step)) / (2 * step) * q


def following(kernels):
    """A trough that starts with its rest stays by it, but for the square of the rate."""
    fast, given = compiled(kernels), small(mu=0.0)
    first = 0.4  # upright, where all is symmetric, the trough stays closer: by the cube
    off, drift = [], []
    for rate in (2e-3, 1e-3, 5e-4):
        piece = Following(fast, given, first, rate, 0.0, 20.0)
        record = Motion(fast, given, tolerance=1e-11, book=False).run([piece], first, rate)
        time, theta = record.column("time"), record.column("theta")
        off.append(np.max(np.abs(theta - first - rate * time)))
        s = np.array([piece.volume(t) for t in time])
        drift.append(np.max(np.abs(fast.rest_angle(s=s, **given).theta - first - rate * time)))
    orders = np.log2(np.array(off[:-1]) / off[1:])
    at = {"rate": np.array([2e-3, 1e-3])}
    yield compare(
        "order of the distance of a trough that follows from its rest", "halving", orders, 2.0,
        0.1, at, "follow", relative=False,
    )  # fmt: skip
    yield compare(
        "the rest turns as it is to", "rest_angle", drift, 0.0, 1e-12, {"rates": 3},
        "rest_volume", relative=False,
    )  # fmt: skip


# -- breaking away --------------------------------------------------------------------------------


def breaking_away(kernels):
    """Under a steady flow the trough breaks away at the volume of rest, but for its square."""
    fast, given, theta = compiled(kernels), small(), 0.3
    held = fast.stick_volumes(theta=theta, **given)
    middle = float(held.s_on + held.s_back) / 2
    for sense, edge in ((1.0, float(held.s_on)), (-1.0, float(held.s_back))):
        off = [
            _breakaway(fast, given, theta, middle, edge, sense * flow)
            for flow in (8e-5, 4e-5, 2e-5)
        ]  # fmt: skip
        yield compare(
            "order of the distance from the volume of breakaway, in the flow", "halving",
            np.log2(np.array(off[:-1]) / off[1:]), 2.0, 0.02, {"flow": np.array([8e-5, 4e-5])},
            "stick_volumes", relative=False,
        )  # fmt: skip
        yield compare(
            "and it is a small part of what is between", "SciPy",
            off[-1] / float(held.reversal), 0.0, 1e-3, {"flow": 2e-5}, "stick_volumes",
            relative=False,
        )  # fmt: skip


def _breakaway(kernels, given, theta, s, edge, flow):
    """How far from an edge the volume is when the trough sets off, after a start between both."""
    piece = Piece(0.0, 1.5 * (edge - s) / flow, s, flow, flow)
    record = Motion(kernels, given, book=False).run([piece], theta)
    time = next(time for time, _, name in record.events if name != "stick")
    return abs(float(piece(time)[0]) - edge)
