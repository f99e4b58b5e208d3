"""Wind on the facets in MuJoCo."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Axis, Curve, Panels, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .days import MM, clock_words
from .study_day import LAWS, MRAD
from .tracking import IN_CORNER, Stage, drive, figures, gusts, outline

NAMES = (*LAWS, IN_CORNER)
AFTER = 5.0  # s that are looked at after a gust
CALM, ONE, TRAIN = "no wind", "one gust", "random train"


def gust(kernels, native, sun, parameters, results, tell):
    """One gust on all facets, and a train of gusts on each, in real time."""
    need("mujoco")
    stage = Stage(kernels, native, sun, parameters, results["gains"])
    given, start = parameters.gust, parameters.tracking.settling
    first = parameters.days.first
    runs = {}
    for k, (name, length) in enumerate(
        ((CALM, given.length), (ONE, given.length), (TRAIN, given.train))
    ):
        time = stage.times(start + length + AFTER)
        wind = dict(zip((ONE, TRAIN), gusts(parameters, time, start), strict=True)).get(name)
        records = drive(
            stage, NAMES, stage.day(first, 1.0), time, wind,
            lambda part, done=k, of=name: tell((done + part) / 3, of),
        )  # fmt: skip
        runs[name] = (time, wind, records)
    found = {
        name: {law: figures(record, start) for law, record in records.items()}
        for name, (_, _, records) in runs.items()
    }
    yield Heading("Tracking in the wind")
    yield Prose(
        f"At {clock_words(first)}, where the facets lean most, in real time. One gust of "
        f"{given.length:g} s, {given.peak:g} N at its peak, presses on all four mirrors along "
        f"their normals; and for {given.train:g} s each facet has a train of such gusts of its "
        f"own, with random peaks of both signs up to {given.peak:g} N and random pauses. No "
        "law is told of the wind."
    )
    yield wind_plot(parameters, runs)
    yield Panels(
        "The largest error of the twelve rods in the wind.",
        [
            Plot(
                name, "time, s", Axis("largest error, mm", log=True),
                [
                    Curve(law, *outline(*after(time, start, worst(records[law]))))
                    for law in NAMES
                ],
            )
            for name, (time, _, records) in runs.items() if name != CALM
        ],
    )  # fmt: skip
    yield Table(
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
    windy = [found[name] for name in (ONE, TRAIN)]
    yield Result(
        "gust",
        {
            law: {
                "peak": max(of[law].peak for of in windy),
                "tilt": max(of[law].tilt for of in windy),
            }
            for law in NAMES
        },
    )


def worst(record):
    """The largest error of the twelve, at each time, in mm."""
    return MM * np.abs(record.joined("errors")).max(axis=1)


def after(time, start, errors):
    """Both from a time on."""
    kept = time >= start
    return time[kept], errors[kept]


def wind_plot(parameters, runs):
    """What blows on the first facet."""
    curves = []
    for name in (ONE, TRAIN):
        time, wind, _ = runs[name]
        curves.append(Curve(name, time[::100], wind[::100, 0]))
    return Plot(
        "The wind on the facet at +X: force along its normal.", "time, s", "force, N", curves
    )
