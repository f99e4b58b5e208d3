"""The pump's law, interpreted and compiled, against a plain state machine over random traces."""

import math

import numpy as np

from armillary import Status
from armillary.verify.measured import compare

from .motion_of import compiled

SAMPLES, PUMPS = 400, 60
KERNEL = "pump_control_update"


def settings(random):
    """Containers and bands at random, a set for each pump."""
    between = random.uniform
    on = between(1e-3, 0.05, PUMPS)
    return {
        "h_max": between(0.15, 0.3, PUMPS), "q_pump": between(1e-6, 1e-3, PUMPS),
        "band_on": on, "band_off": on * between(-1, 1, PUMPS),
    }  # fmt: skip


def traces(random, given):
    """What the law hears, (samples, pumps).

    The errors wander to and fro over both bands, the angle wanted goes through half a turn, and
    the levels go beyond either container, both ways, each in a time of its own: water is lost.
    """
    shape = SAMPLES, PUMPS
    phase = np.arange(SAMPLES)[:, None] * random.uniform(0.02, 0.2, PUMPS)
    error = given["band_on"] * (2 * np.sin(phase) + random.normal(0, 0.4, shape))
    wanted = np.linspace(2.6, 3.7, SAMPLES)[:, None] * random.choice([-1, 1], PUMPS)
    lapse = 2 * np.pi * random.integers(-2, 3, shape)
    start = random.uniform(0, 6, PUMPS)
    levels = (0.5 + 0.8 * np.sin(pace * phase + start) for pace in (0.37, -0.41))
    level_1, level_2 = (given["h_max"] * level for level in levels)
    return {"theta_ref": wanted, "theta_measured": wanted - error + lapse,
            "level_1": level_1, "level_2": level_2}  # fmt: skip


def machine(running, setting, heard):
    """The pump that runs next, and why it does not when the levels forbid it, for one pump."""
    error = math.remainder(heard["theta_ref"] - heard["theta_measured"], 2 * math.pi)
    levels = level_1, level_2 = heard["level_1"], heard["level_2"]
    if error > setting["band_on"]:
        wish = 1
    elif error < -setting["band_on"]:
        wish = -1
    elif running == 1 and error > setting["band_off"]:
        wish = 1
    elif running == -1 and -error > setting["band_off"]:
        wish = -1
    else:
        wish = 0
    full, empty = (level_1, level_2) if wish == 1 else (level_2, level_1)
    stopped = wish != 0 and (full >= setting["h_max"] or empty <= 0)
    astray = min(levels) < 0 or max(levels) > setting["h_max"]
    return (0 if stopped else wish), (Status.LIMIT if stopped or astray else Status.OK)


def by_machine(given, heard):
    """Pumps and statuses of all samples, (samples, pumps)."""
    pumps, statuses = np.zeros((SAMPLES, PUMPS)), np.zeros((SAMPLES, PUMPS))
    for j in range(PUMPS):
        running = 0
        setting = {name: float(value[j]) for name, value in given.items()}
        for k in range(SAMPLES):
            now = {name: float(value[k, j]) for name, value in heard.items()}
            running, statuses[k, j] = machine(running, setting, now)
            pumps[k, j] = running
    return pumps, statuses


def by_law(kernels, given, heard):
    """The same by the law, and the flows."""
    pump = np.broadcast_to(kernels.pump_control_init().pump, PUMPS).astype(float)
    told = []
    for k in range(SAMPLES):
        now = {name: value[k] for name, value in heard.items()}
        found = kernels.pump_control_update(pump=pump, **given, **now)
        pump = np.array(found.pump)
        told.append((pump, np.array(found.status), np.array(found.flow)))
    return [np.array(column) for column in zip(*told, strict=True)]


def law_by_machine(kernels):
    """Hysteresis, both signs, through half a turn, and levels that block, sample by sample."""
    random = np.random.default_rng(81)
    given = settings(random)
    heard = traces(random, given)
    pumps, statuses = by_machine(given, heard)
    yield from _exercised(pumps, statuses, given)
    wanted = np.stack([pumps, statuses, pumps * given["q_pump"]], axis=-1)
    for told, law in (("interpreted", lambda: kernels), ("compiled C", lambda: compiled(kernels))):
        found = np.stack(by_law(law(), given, heard), axis=-1)
        yield compare(
            f"pump, status and flow of {SAMPLES} samples, {told}", "state machine",
            np.moveaxis(found, 1, 0), np.moveaxis(wanted, 1, 0), 0.0, given, KERNEL,
            relative=False,
        )  # fmt: skip


def _exercised(pumps, statuses, given):
    """The traces are worth something: each kind of step occurs."""
    before, after = pumps[:-1], pumps[1:]
    kinds = [(a, b) for a in (-1, 0, 1) for b in (-1, 0, 1)]
    missed = [not np.any((before == a) & (after == b)) for a, b in kinds]
    missed += [not np.any((statuses == Status.LIMIT) & (pumps == a)) for a in (-1, 0, 1)]
    yield compare(
        "every change of the pump occurs in the traces, and levels that block", "state machine",
        np.array(missed), 0.0, 0.0, {}, KERNEL,
    )  # fmt: skip


EXACT = {"h_max": 0.25, "q_pump": 0.5, "band_on": 0.5, "band_off": -0.25}
# Pump, error and rise of the first level over the second's fall, from half full; the pump that must
# run next. One container is full and the other empty at a rise of 0.125 either way.
STEPS = (
    (0, 0.0, 0.0, 0), (0, 0.4, 0.0, 0), (0, 0.6, 0.0, 1), (0, -0.4, 0.0, 0), (0, -0.6, 0.0, -1),
    (1, 0.4, 0.0, 1), (1, -0.2, 0.0, 1), (1, -0.3, 0.0, 0), (1, -0.6, 0.0, -1),
    (-1, -0.4, 0.0, -1), (-1, 0.2, 0.0, -1), (-1, 0.3, 0.0, 0), (-1, 0.6, 0.0, 1),
    (1, 0.6, 0.125, 0), (1, 0.6, 0.1249, 1), (-1, -0.6, 0.125, -1),
    (-1, -0.6, -0.125, 0), (-1, -0.6, -0.1249, -1), (1, 0.6, -0.125, 1),
    (1, 0.6, 0.2, 0), (-1, -0.6, 0.2, -1), (1, -3.0, 0.0, -1), (1, 3.0, 0.0, 1),
    (1, 3.3, 0.0, -1), (1, -3.3, 0.0, 1),
)  # fmt: skip
# Pump that is asked for, rise, height of the containers; whether it runs. One container is just
# empty, or the other one just full, and not both.
EDGES = (
    (1, 0.125, 0.5, False), (1, 0.1249, 0.5, True), (-1, 0.125, 0.5, True),
    (-1, -0.125, 0.5, False), (-1, -0.1249, 0.5, True), (1, -0.125, 0.5, True),
    (1, 0.0625, 0.1875, False), (1, 0.0624, 0.1875, True), (-1, 0.0625, 0.1875, True),
    (-1, -0.0625, 0.1875, False), (-1, -0.0624, 0.1875, True), (1, -0.0625, 0.1875, True),
)  # fmt: skip


def risen(rise):
    """Levels, that of container 1 risen by as much as the other has sunk."""
    return {"level_1": 0.125 + np.asarray(rise), "level_2": 0.125 - np.asarray(rise)}


def law_by_hand(kernels):
    """Single steps, at the edges too; and bands that contradict each other are refused."""
    pump, error, rise, wanted = np.array(STEPS).T
    still = np.zeros(len(pump))
    heard = {"pump": pump, "theta_ref": error, "theta_measured": still, **risen(rise)}
    found = kernels.pump_control_update(**heard, **EXACT)
    yield compare(
        "single steps: dead band, hysteresis, half a turn, containers full and empty", "by hand",
        found.pump, wanted, 0.0, {**heard, **EXACT}, KERNEL,
    )  # fmt: skip
    yield from _edges(kernels)
    off = np.array([0.50001, -0.50001, 0.5, -0.5, 0.0])
    status = [Status.UNREACHABLE] * 2 + [Status.OK] * 3
    heard = {"pump": 0.0, "theta_ref": 0.1, "theta_measured": 0.0, **risen(0.0)}
    found = kernels.pump_control_update(**heard, **{**EXACT, "band_off": off})
    yield compare(
        "an error to stop at that lies beyond the one to start at is refused", "by hand",
        found.status, status, 0.0, {**EXACT, "band_off": off}, KERNEL,
    )  # fmt: skip
    yield compare(
        "no pump runs at the start", "by hand", kernels.pump_control_init().pump, 0.0, 0.0, {},
        "pump_control_init",
    )  # fmt: skip


def _edges(kernels):
    """A level stops just the pump that would carry it farther."""
    asked, rise, height, runs = np.array(EDGES, dtype=float).T
    heard = {"pump": 0.0, "theta_ref": asked, "theta_measured": 0.0, **risen(rise)}
    given = {**EXACT, "h_max": height}
    found = kernels.pump_control_update(**heard, **given)
    status = np.where(runs > 0, Status.OK, Status.LIMIT)
    yield compare(
        "a container just empty or just full stops one pump, and no other", "by hand",
        np.stack([found.pump, found.status], axis=1),
        np.stack([np.where(runs > 0, asked, 0.0), status], axis=1), 0.0, {**heard, **given}, KERNEL,
    )  # fmt: skip
