"""The closed form of the on-off pump's cycle against the trough's motion under that pump."""

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare

from .checks_of_motion import whole
from .checks_of_time import PARAMETERS
from .cycles_of import Pump, cycles
from .motion_of import compiled
from .samples import STATE, rows
from .swings_of import settled, swing
from .troughs import law, trough

SUN = np.radians(15) / 3600  # rad/s
BANDS = (0.25, 0.27, 0.29, 0.31)  # degrees, at which the pump starts
PARTS = (0.1, 0.01, 0.001)  # of the study's flow and sun
CLOSE = 1e-7
NAMES = ("t_on", "t_cycle", "travel", "error_rest")
QUICK = 3e-6  # m^3/s, more than the larger trough's own pump gives
SHARP = Pump(up=0.4, down=0.02)  # s; the start is gentle enough for friction to hold it
# Size of trough and volume of the middle: upright, and leaning either way behind a sun of either
# sense.
SETS = (
    ("small", 0.0, 1), ("small", 6e-4, 1), ("small", -1e-3, 1), ("small", 1.5e-3, -1),
    ("large", 2e-3, 1), ("large", -2e-3, -1),
)  # fmt: skip


def given(size, scale=1.0, **changed):
    """A trough of the study and its law, the sun as slow as the pump and the band as narrow."""
    found = trough(PARAMETERS, size) | law(PARAMETERS, size) | {"lag": 0.2}
    slowed = {name: scale * found[name] for name in ("q_pump", "band_on", "band_off")}
    return {**found, **slowed, **changed}


def both(kernels, of, s, rate, pump=SHARP):
    """The third cycle of a motion, and that of the kernel at its middle."""
    *_, last = cycles(kernels, of, pump, rate, s, 3)
    return last, kernels.cycle(s=last.s, theta_dot_ref=rate, **of)


def missed(kernels, of, s, rate, pump=SHARP):
    """By how much of each the kernel misses the motion, (4,)."""
    moved, told = both(kernels, of, s, rate, pump)
    return np.array([float(getattr(told, n)) / getattr(moved, n) - 1 for n in NAMES])


def cycle_by_motion(kernels):
    """To first order in the angles of the cycle; and how well it tells the study's own."""
    fast = compiled(kernels)
    off = [missed(fast, given(size), s, sense * SUN) for size, s, sense in SETS]
    at = {"s": np.array([s for _, s, _ in SETS])}
    yield compare(
        "time on, period, turn and last error of the pump's cycle, as parts", "motion", off, 0.0,
        5e-3, at, "cycle", relative=False,
    )  # fmt: skip
    scales = (1.0, 0.5, 0.25)
    fine = [missed(fast, given("large", k, q_pump=k * QUICK), 2e-3, k * SUN) for k in scales]
    orders = np.log2(np.abs(np.array(fine[:-1]) / fine[1:]))
    yield compare(
        "order of what it misses, in all angles", "halving", orders, 1.0, 0.2,
        {"scale": np.array(scales[:-1])}, "cycle", relative=False,
    )  # fmt: skip
    ramps = (0.4, 0.2)
    slow = [
        missed(fast, given("small"), 0.0, SUN, Pump(0.4, ramp)) - off[0] for ramp in ramps
    ]  # fmt: skip
    yield compare(
        "order of what a ramp adds, in its length", "halving",
        np.log2(np.abs(slow[0] / slow[1])), 2.0, 0.1, {"ramp": ramps[0]}, "cycle", relative=False,
    )  # fmt: skip


def _law(of, pace, wide, ahead, lag):
    """A law whose numbers are parts of what friction holds and lengths of a swing."""
    pace = pace * of.hold * of.pulse
    wide = wide * pace / of.pulse
    return {
        "q_pump": pace / of.turn, "band_on": (1 - ahead) * wide, "band_off": -ahead * wide,
        "lag": lag / of.pulse,
    }  # fmt: skip


def _at_random(random):
    return (random.uniform(0.02, 0.2), random.uniform(0.5, 15), *random.uniform(0, 0.5, 2))


def _spring(kernels, row, sense, law, slow):
    """How the kernel's cycle misses those of a mass on a spring, up to the one that is told.

    Args:
        law: four numbers for `_law`.
        slow: rate of the sun by that of the edge.
    """
    of = {n: v for n, v in row.items() if n not in (*STATE, "sag")}
    held = swing(kernels, of, row["s"], sense)
    pump = _law(held, *law)
    rate = slow * held.turn * pump["q_pump"]
    found = kernels.cycle(s=row["s"], theta_dot_ref=sense * rate, **of, **pump)
    if held.turn <= 0 or found.status < 0:
        return None
    told, misses = np.array([float(getattr(found, n)) for n in NAMES]), []
    for one in settled(held, pump, rate):
        misses.append(told / one - 1)
        if np.max(np.abs(misses[-1])) < CLOSE:
            return misses
    return [*misses, np.full(4, np.nan)]


def cycle_by_swings(kernels):
    """Of troughs and laws at random: a mass on a spring behind an edge, integrated till it repeats.

    Close to a whole swing two cycles may last; the kernel tells one of them.
    """
    random = np.random.default_rng(82)
    troughs = rows(whole(82, 40, omega=0.0, q=0.0, q_dot=0.0))
    found = [
        _spring(kernels, row, (-1) ** k, _at_random(random), random.uniform(0.05, 0.5))
        for k, row in enumerate(troughs)
    ]
    found, at = [one for one in found if one], {"laws": 40}
    yield compare(
        "time on, period, turn and last error of a mass on a spring behind an edge, as parts",
        "SciPy", [one[-1] for one in found], 0.0, CLOSE, at, "cycle", relative=False,
    )  # fmt: skip
    yield compare(
        "a trough from the edge settles in the cycle that is told, in nine of ten", "SciPy",
        np.mean([len(one) > 1 for one in found]) < 0.1, 1.0, 0.0, at, "cycle",
    )  # fmt: skip
    yield compare(
        "most of the laws have a cycle", "counting", len(found) > 25, 1.0, 0.0, at, "cycle"
    )


def cycle_beside_a_swing(kernels):
    """From a slip of less than a swing to one of more: a cycle that is told is one that lasts."""
    (row,) = rows(whole(83, 1, omega=0.0, q=0.0, q_dot=0.0))
    widths = np.linspace(0.5, 7.5, 36)
    found = [_spring(kernels, row, 1, (0.05, wide, 0.1, 0.5), 0.4) for wide in widths]
    found = [one for one in found if one]  # without those that coast past the sun
    yield compare(
        "cycles beside a whole swing, as parts", "SciPy", [one[-1] for one in found], 0.0, CLOSE,
        {"wide": widths}, "cycle", relative=False,
    )  # fmt: skip
    yield compare("most of them", "counting", len(found) > 25, 1.0, 0.0, {"laws": 36}, "cycle")


def cycle_across_a_swing(kernels):
    """A little more dead band, and the slip takes one more swing: the period leaps, and is told."""
    fast, seen, told = compiled(kernels), [], []
    for band in BANDS:
        of = given("small", band_on=np.radians(band))
        *_, last = cycles(fast, of, SHARP, SUN, 4e-4, 6)
        seen.append(last.t_cycle)
        told.append(float(fast.cycle(s=last.s, theta_dot_ref=SUN, **of).t_cycle))
    at = {"band_on": np.radians(BANDS)}
    yield compare(
        "period of the pump's cycle on both sides of a whole swing", "motion", told, seen, 3e-3, at,
        "cycle",
    )  # fmt: skip
    yield compare(
        "between them it leaps", "motion", seen[2] - seen[1] > 10 * (seen[1] - seen[0]), 1.0, 0.0,
        at, "cycle",
    )  # fmt: skip


def cycle_of_many_swings(kernels):
    """A slow edge, a trough as stiff as before: it moves with the edge; a cycle is geometry."""
    fast, s, off = compiled(kernels), 6e-4, []
    for part in PARTS:
        of = {**given("small"), "lag": 0.0}
        of["q_pump"] *= part
        rate = part * SUN
        told = fast.cycle(s=s, theta_dot_ref=rate, **of)
        wide = of["band_on"] - of["band_off"]
        pace = float(told.travel / told.t_on)
        off.append([
            float(told.t_on) * (pace - rate) / wide - 1,
            float(told.t_cycle) / (wide / rate + wide / (pace - rate)) - 1,
        ])  # fmt: skip
    parts = np.array(PARTS)
    yield compare(
        "times of a trough that moves with its edge, off by a part of the pump's slowness",
        "geometry", np.array(off) / parts[:, None], 0.0, 0.2, {"part": parts}, "cycle",
        relative=False,
    )  # fmt: skip


def cycle_refused(kernels):
    """Where friction is too weak for the coast, the trough of the motion turns back: refused."""
    fast = compiled(kernels)

    def told(mu):
        return int(fast.cycle(s=0.0, theta_dot_ref=SUN, **given("small", mu=mu)).status)

    coast = need("scipy.optimize").brentq(
        lambda mu: 1.0 if told(mu) == Status.OK else -1.0, 1e-4, 1e-2, xtol=1e-7
    )
    for part in (0.9, 1.1):
        of = given("small", mu=part * coast)
        *_, last = cycles(fast, of, SHARP, SUN, 0.0, 2)
        status = Status.UNREACHABLE if last.backs else Status.OK
        yield compare(
            f"friction of {part:g} of what holds the coast", "motion", told(of["mu"]), status, 0.0,
            {"mu": of["mu"]}, "cycle",
        )  # fmt: skip
        yield compare(
            f"with {part:g} of it the trough turns back or not", "motion", last.backs,
            float(part < 1), 0.0, {"mu": of["mu"]}, "cycle",
        )  # fmt: skip


def cycle_that_hunts(kernels):
    """The longer the lag, the farther the coast: told where the other pump would start."""
    fast, s = compiled(kernels), 1.05e-3
    of = given("large", q_pump=QUICK)
    for lag in (0.2, 0.9):
        *_, last = cycles(fast, {**of, "lag": lag}, SHARP, SUN, s, 3)
        status = fast.cycle(s=last.s, theta_dot_ref=SUN, **{**of, "lag": lag}).status
        hunts = last.error_rest < -of["band_on"]
        yield compare(
            f"a lag of {lag:g} s: the last error starts the other pump or not", "motion", status,
            Status.UNREACHABLE if hunts else Status.OK, 0.0, {"lag": lag}, "cycle",
        )  # fmt: skip
        yield compare(
            f"and with a lag of {lag:g} s it does so if the lag is long", "motion", float(hunts),
            float(lag > 0.5), 0.0, {"lag": lag}, "cycle",
        )  # fmt: skip
