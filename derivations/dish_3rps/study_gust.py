"""Wind on the facets in MuJoCo."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Axis, Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .days import FACETS, MM, clock_words
from .study_day import LAWS, MRAD
from .tracking import IN_CORNER, Stage, drive, figures, gusts, outline

NAMES = (*LAWS, IN_CORNER)
ONE, TRAIN = "one gust", "random train"
STEPS = 100  # samples between two points of the wind's curve


def gust(kernels, native, sun, parameters, results, tell):
    """One gust on all facets, then a train of gusts on each, in real time."""
    need("mujoco")
    stage = Stage(kernels, native, sun, parameters, results["gains"])
    given, rest = parameters.gust, parameters.tracking.window_settling
    first = parameters.days.first
    spans = {ONE: (rest, rest + 2 * given.length)}
    spans[TRAIN] = (spans[ONE][1], spans[ONE][1] + given.train)
    time = stage.times(spans[TRAIN][1])
    wind = gusts(parameters, time, spans[ONE][0], spans[TRAIN][0])
    records = drive(stage, NAMES, stage.day(first, 1.0), time, wind, tell)
    found = {
        name: {law: figures(record, *span) for law, record in records.items()}
        for name, span in spans.items()
    }
    yield from the_wind(parameters)
    kept = time >= rest
    yield Plot(
        "The wind: force along the normals of the facets.", "time, s", "force, N",
        [
            Curve(name, time[kept][::STEPS], wind[kept][::STEPS, k])
            for k, name in enumerate(FACETS)
        ],
    )  # fmt: skip
    yield Plot(
        "The largest error of the twelve rods in the wind.",
        "time, s",
        Axis("largest error, mm", log=True),
        [Curve(law, *outline(time[kept], worst(record)[kept])) for law, record in records.items()],
    )
    yield table(found)
    yield Result(
        "gust",
        {
            law: {n: max(getattr(of[law], n) for of in found.values()) for n in ("peak", "tilt")}
            for law in NAMES
        },
    )


def the_wind(parameters):
    """What blows."""
    given, rest = parameters.gust, parameters.tracking.window_settling
    yield Heading("Tracking in the wind")
    yield Prose(
        f"From {clock_words(parameters.days.first)}, when the dish leans almost as far as on the "
        f"whole day, in real time and after {rest:g} s of calm. One gust of "
        f"{given.length:g} s, {given.peak:g} N at its peak, "
        "presses on all four mirrors along their normals. Then each facet has a train of such "
        f"gusts of its own for {given.train:g} s, with random peaks of both signs up to "
        f"{given.peak:g} N and random pauses. No law is told of the wind."
    )


def worst(record):
    """The largest error of the twelve, at each time, in mm."""
    return MM * np.abs(record.joined("errors")).max(axis=1)


def table(found):
    """The errors."""
    return Table(
        "Errors in the wind: the largest of a rod and of a normal.",
        [
            "law",
            *(Column(f"rod, {name}", "mm", ".3f") for name in found),
            *(Column(f"normal, {name}", "mrad", ".3f") for name in found),
        ],
        [
            (law, *(MM * of[law].peak for of in found.values()),
             *(MRAD * of[law].tilt for of in found.values()))
            for law in NAMES
        ],
    )  # fmt: skip
