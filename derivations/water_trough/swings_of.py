"""A pump's cycle of the plainest kind: one mass on one spring, dragged by a moving edge.

The few numbers that it stands on are measured on other kernels; SciPy does the rest.
"""

from dataclasses import dataclass

import numpy as np

from armillary.verify.engines import need

MANY = 200  # cycles, in which what the first one began with is forgotten
PARTS = (0.0, 1.0, 2.0)  # coasts to begin with, by the speed of the edge over the pulse
MOST = 200  # rad, the longest slip
SPAN = 1e-3  # of the range of volumes, over which slopes are taken


@dataclass(frozen=True)
class Swing:
    """The edge of friction and the trough behind it.

    Attributes:
        turn: of the edge per volume moved, rad/m^3.
        pulse: angular frequency of swings about the edge, rad/s.
        kick: angular velocity gained per flow that stops, rad/m^3.
        hold: half of the range in which friction holds, rad.
    """

    turn: float
    pulse: float
    kick: float
    hold: float


def _slope(of, at, step):
    """The derivative of a function of a number, by four differences."""
    return (8 * (of(at + step) - of(at - step)) - of(at + 2 * step) + of(at - 2 * step)) / 12 / step


def swing(kernels, trough, s, sense):
    """What a trough does about the edge of friction that it slides along in a sense."""
    still = {"omega": 0.0, "q": 0.0, "q_dot": 0.0}

    def hold(volume):
        return float(kernels.stick_band(s=volume, **trough).half_width)

    def edge(volume):
        return float(kernels.rest_angle(s=volume, **trough).theta) - sense * hold(volume)

    def alpha(**state):
        given = {"theta": edge(s), "s": s, **still, **trough, "mu": 0.0, **state}
        return float(kernels.acceleration(**given).alpha)

    least = min(trough["A_1"] * trough["h_10"], trough["A_2"] * trough["h_20"])
    return Swing(
        turn=_slope(edge, s, SPAN * least),
        pulse=np.sqrt(-_slope(lambda theta: alpha(theta=theta), edge(s), 1e-3)),
        kick=alpha(q_dot=0.0) - alpha(q_dot=1.0),
        hold=hold(s),
    )


def settled(of, pump, rate):
    """Cycles in which the trough may settle: time on, period, turn and last error of each, (4,).

    More than one may last; the first is that of a trough that stood at the edge.

    Args:
        of: the `Swing`.
        pump: `q_pump`, `band_on`, `band_off` and `lag`.
        rate: of the sun, rad/s, positive: the sense is the sun's.
    """
    for part in PARTS:
        coast, found = part * of.turn * pump["q_pump"] / of.pulse, np.zeros(4)
        for _ in range(MANY):
            before = found
            found, coast = _cycle(of, pump, rate, coast)
            if np.allclose(found, before, rtol=1e-11, atol=0):
                yield found
                break


def _cycle(of, pump, rate, coast):
    """One cycle of a trough that stands beyond the edge by a coast, rad; and the coast after it."""
    pace, lag = of.turn * pump["q_pump"], pump["lag"]
    wait = coast / pace
    error = pump["band_on"] + rate * (lag + wait)  # when the edge reaches the trough

    def asked(t, x):
        return error + rate * t - x[0] - pump["band_off"]

    asked.terminal, asked.direction = True, -1
    slip = _moved(of, lambda t: pace * t, [0.0, 0.0], MOST / of.pulse, asked)
    told = slip.t[-1]
    if lag:
        slip = _moved(of, lambda t: pace * (told + t), slip.y[:, -1], lag)
    stop, (place, speed) = told + lag, slip.y[:, -1]
    speed += of.kick * pump["q_pump"]
    later = 0.0
    if speed > 0:
        rest = _moved(of, lambda t: pace * stop, [place, speed], 7 / of.pulse, _stands)
        later, place = rest.t[-1], rest.y[0, -1]
    last = error + rate * (stop + later) - place
    return np.array([wait + stop, place / rate, place, last]), place - pace * stop


def _stands(t, x):
    return x[1]


_stands.terminal, _stands.direction = True, -1


def _moved(of, edge, start, length, *events):
    """The trough, drawn to an edge, in the frame of its sense; until an event if there is one."""
    return need("scipy.integrate").solve_ivp(
        lambda t, x: [x[1], of.pulse**2 * (edge(t) - x[0])], (0.0, length), start,
        method="DOP853", rtol=1e-11, atol=1e-15, events=events,
    )  # fmt: skip
