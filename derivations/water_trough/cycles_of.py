"""The cycle of an on-off pump in time: the law exact and awake at every instant, the sun steady."""

from dataclasses import dataclass

import numpy as np

from armillary.verify.engines import need

from .motion_of import MODES, Motion
from .pumping import Piece

STEP = 0.05  # s, in which the error is looked at while the pump runs
REST = 30.0  # s, in which a trough must have come to rest


@dataclass(frozen=True)
class Cycle:
    """One cycle, from the error at which the pump starts to the same error again.

    Attributes:
        s: volume in the middle of the run, m^3.
        t_on, t_cycle: s; as of `cycle`.
        travel, error_rest: rad; as of `cycle`.
        backs: whether the trough turns back after the pump has stopped.
    """

    s: float
    t_on: float
    t_cycle: float
    travel: float
    error_rest: float
    backs: bool


@dataclass(frozen=True)
class Pump:
    """How the flow comes and goes: middle of either change a `lag` after it was asked for, s."""

    up: float
    down: float


def cycles(kernels, given, pump, rate, s, count, tolerance=1e-10):
    """Cycles one after the other, from a trough at the edge of friction; the first are a start.

    Args:
        given: parameters of trough and law.
        rate: of the angle wanted, rad/s.
        s: volume moved at the beginning, m^3.
    """
    motion = Motion(kernels, given, tolerance, book=False)
    sense = np.sign(rate)
    rest = float(kernels.rest_angle(s=s, **given).theta)
    theta = rest - sense * float(kernels.stick_band(s=s, **given).half_width) * (1 - 1e-6)
    for _ in range(count):
        found, theta, s = _one(motion, given, pump, rate, s, theta)
        yield found


def _one(motion, given, pump, rate, s, theta):
    """A cycle from rest; time and the error begin where the pump is asked for."""
    sense, lag, speed = np.sign(rate), given["lag"], abs(rate)
    flow = sense * given["q_pump"]

    def error(time, angle):
        return given["band_on"] + speed * time - sense * (angle - theta)

    rows = _pieces(s, (lag - pump.up / 2, 0.0), (pump.up, flow), (STEP, flow))
    record = motion.run(rows, theta)
    while (last := record.rows[-1]) and error(last[0], last[1]) > given["band_off"]:
        before = last
        record = motion.run([Piece(last[0], last[0] + STEP, last[3], flow, flow)], *last[1:3])

    def over(length):
        at = motion.run([Piece(before[0], before[0] + length, before[3], flow, flow)], *before[1:3])
        end = at.rows[-1]
        return error(end[0], end[1]) - given["band_off"]

    length = need("scipy.optimize").brentq(over, 1e-9, STEP, xtol=1e-9)
    legs = _pieces(
        before[3], (length, flow), (lag - pump.down / 2, flow), (pump.down, 0.0), (REST, 0.0),
        start=before[0], q=flow,
    )  # fmt: skip
    record = motion.run(legs, *before[1:3])
    stopped = [time for time, _, mode in record.events if mode == "stick"][-1]
    end = record.rows[-1]
    travel, against = sense * (end[1] - theta), MODES[-int(sense)]
    return (
        Cycle(
            (s + end[3]) / 2, (end[3] - s) / flow, travel / speed, travel,
            error(stopped, end[1]), against in [mode for _, _, mode in record.events],
        ),
        end[1],
        end[3],
    )  # fmt: skip


def _pieces(s, *legs, start=0.0, q=0.0):
    """Pieces one after the other; those of no length are left out."""
    made = []
    for length, wanted in legs:
        if length > 0:
            made.append(Piece(start, start + length, s, q, wanted))
            s, start, q = made[-1].last, made[-1].end, wanted
    return made
