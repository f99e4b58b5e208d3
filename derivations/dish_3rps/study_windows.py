"""The June solstice in MuJoCo in real time: three windows, and why they stand for the day."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Axis, Curve, Panels, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .days import FACETS, MM, clock_words
from .study_day import LAWS, MICRO, MRAD
from .tracking import HALVED, IN_CORNER, PID, Stage, creep, drive, figures, outline

NAMES = (*LAWS, IN_CORNER)
CHECKED = 1  # the window that is run with half the step as well: with the slowest rods
WINDOWS = ("window_1", "window_2", "window_3")
POINTS = 150
HELD, CREEPING = 0.9, 4.0  # share of the friction, and s
MINUTE = 60.0


def window(number, kernels, native, sun, parameters, results, tell):
    """One window: what real_time shows of it."""
    need("mujoco")
    stage = Stage(kernels, native, sun, parameters, results["gains"])
    start = parameters.tracking.windows[number]
    time, settling = (stage.times(parameters.tracking.window), parameters.tracking.window_settling)
    names = (*NAMES, HALVED) if number == CHECKED else NAMES
    records = drive(stage, names, stage.day(start, 1.0), time, tell=tell)
    kept = time >= settling
    found = {}
    for name, record in records.items():
        of = figures(record, settling)
        errors = MM * np.abs(record.joined("errors")[kept]).max(axis=1)
        found[name] = {
            "peak": of.peak, "tilt": of.tilt, "peaks": of.peaks,
            "rms": float(np.sqrt(np.mean(of.means**2))),
            "curve": outline(time[kept] / MINUTE, errors, POINTS),
        }  # fmt: skip
    yield Result(WINDOWS[number], found)


def morning(kernels, native, sun, parameters, results, tell):
    """The first window."""
    yield from window(0, kernels, native, sun, parameters, results, tell)


def noon(kernels, native, sun, parameters, results, tell):
    """The second window."""
    yield from window(1, kernels, native, sun, parameters, results, tell)


def afternoon(kernels, native, sun, parameters, results, tell):
    """The third window."""
    yield from window(2, kernels, native, sun, parameters, results, tell)


def real_time(kernels, native, sun, parameters, results):
    """The windows side by side."""
    tracking = parameters.tracking
    found = [results[name] for name in WINDOWS]
    minutes = tracking.window / MINUTE
    yield Heading("Tracking in real time")
    yield Prose(
        f"Windows of {minutes:g} minutes at the sun's own pace, the first "
        f"{tracking.window_settling:g} s of each left out. The law hears the lengths "
        f"in the encoder's steps of {MICRO * parameters.plant.encoder:g} µm."
    )
    yield Panels(
        "The largest error of the twelve rods in real time.",
        [
            Plot(
                f"from {clock_words(start)}", "minutes", Axis("largest error, mm", low=0.0),
                [Curve(name, *of[name]["curve"]) for name in NAMES if name in LAWS[1:]],
            )
            for start, of in zip(tracking.windows, found, strict=True)
        ],
    )  # fmt: skip
    yield table(tracking.windows, found, minutes)
    yield softness(Stage(kernels, native, sun, parameters, results["gains"]), found[CHECKED])
    yield from the_rest(native, sun, parameters, results, kernels)
    yield Result(
        "windows",
        {n: {what: max(of[n][what] for of in found) for what in ("peak", "tilt")} for n in NAMES},
    )


def table(starts, found, minutes):
    """Window by window, law by law."""
    return Table(
        f"Three windows of {minutes:g} minutes in real time: root mean square and largest error of "
        "the rods, and the largest of the normals.",
        [
            "window", "law", Column("rms", "µm", ".1f"), Column("largest", "µm", ".1f"),
            Column("largest of a normal", "mrad", ".3f"),
        ],
        [
            (clock_words(start), name, MICRO * of[name]["rms"], MICRO * of[name]["peak"],
             MRAD * of[name]["tilt"])
            for start, of in zip(starts, found, strict=True) for name in NAMES
        ],
    )  # fmt: skip


def softness(stage, found):
    """What the model itself adds."""
    speed = creep(stage, HELD, CREEPING)
    window = stage.parameters.tracking.window
    half, whole = found[HALVED], found[PID]
    start = clock_words(stage.parameters.tracking.windows[CHECKED])
    return Prose(
        "Dry friction in MuJoCo is soft: a rod that it holds against "
        f"{100 * HELD:.0f}% of what it can hold creeps by {1e9 * speed:.0f} nm/s, "
        f"{MICRO * speed * window:.0f} µm in a window. With half the "
        f"step the PID's largest error in the window from {start} goes from "
        f"{MICRO * whole['peak']:.1f} to {MICRO * half['peak']:.1f} µm, its root mean "
        f"square from {MICRO * whole['rms']:.2f} to "
        f"{MICRO * half['rms']:.2f} µm."
    )


def the_rest(native, sun, parameters, results, kernels):
    """The day between the windows, by the kernels alone."""
    stage = Stage(kernels, native, sun, parameters, results["gains"])
    days, tracking = parameters.days, parameters.tracking
    hours = days.last - days.first
    time = np.arange(round(hours * 3600) + 1.0)
    way = stage.day(days.first, 1.0)(time)
    rates, forces = way.rates.reshape(len(time), -1), way.forces.reshape(len(time), -1)
    clock = days.first + time / 3600
    inside = np.zeros(len(time), dtype=bool)
    for start in tracking.windows:
        inside |= (clock >= start) & (clock <= start + tracking.window / 3600)
    speeds = np.abs(rates).max(axis=1)
    turns = sorted(
        (float(clock[k]), f"rod {j % 3 + 1} at {FACETS[j // 3]}", bool(inside[k]))
        for j in range(rates.shape[1])
        for k in np.flatnonzero(np.diff(np.sign(rates[:, j])) != 0)
    )
    words = ", ".join(f"{name} at {clock_words(at)}" for at, name, _ in turns)
    within = sum(one for *_, one in turns)
    slow = np.abs(np.diff(forces, axis=0)).max() / np.diff(time).max()
    k_i = stage.gains["PID"][1]
    heard = parameters.plant.encoder / (speeds[inside].max() * parameters.control.T_S)
    yield Result("turns", {"all": len(turns), "inside": within})
    yield Prose(
        "The rest of the day is quasi-static. The fastest rod of the windows makes "
        f"{MICRO * speeds[inside].max():.1f} µm/s, {heard:.0f} sampling periods from one step of "
        f"the encoder to the next, the fastest of the day {MICRO * speeds.max():.1f}; "
        f"the load of a rod never changes by more than {1000 * slow:.0f} mN/s, which costs a PID "
        f"{1e9 * slow / k_i:.2g} nm; and what is left, the turning round of rods against "
        f"their friction, happens {len(turns)} times: {words}. "
        f"{within} of these are in the windows"
        + ("; the others were not run in real time." if within < len(turns) else ".")
    )
