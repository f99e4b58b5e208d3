"""The June solstice in MuJoCo, compressed: Fig. 15, Table 3, and what each law is worth."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Axis, Curve, Panels, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .days import FACETS, MM, NAMES, RODS
from .tracking import (
    AHEAD,
    AHEAD_IN_CORNER,
    HALVED,
    IN_CORNER,
    P_ONLY,
    PID,
    Stage,
    drive,
    figures,
    outline,
    rods_of,
)

MICRO = 1e6
MRAD = 1e3
LAWS = (P_ONLY, PID, AHEAD)
START_UP = 1.0  # s that are drawn
COLUMNS = (
    Column("largest error of a rod", "mm", ".3f"),
    Column("largest error of a normal", "mrad", ".3f"),
    Column("largest force", "N", ".0f"),
)


def compressed(kernels, native, sun, parameters, results, tell):
    """The whole day, compressed."""
    need("mujoco")
    stage = Stage(kernels, native, sun, parameters, results["gains"])
    days, tracking = parameters.days, parameters.tracking
    time = stage.times((days.last - days.first) * 3600 / tracking.compression)
    names = (*LAWS, IN_CORNER, AHEAD_IN_CORNER, HALVED)
    way = stage.day(days.first, tracking.compression)
    records = drive(stage, names, way, time, tell=tell)
    found = {name: figures(record, tracking.settling) for name, record in records.items()}
    clock = days.first + time * tracking.compression / 3600
    kept = time >= tracking.settling
    yield Heading(f"Fig. 15 and Table 3: tracking through the day, {day_of(parameters)}")
    yield Prose(
        f"With the inferred dimensions. The day from {days.first:g} to {days.last:g} h passes "
        f"{tracking.compression:g} times as fast: {time[-1]:.0f} s. An error is the wanted "
        "length less the model's, taken before the "
        "step that the law's force then makes, at every sample; a curve shows of each piece of "
        f"time the error that is largest. The first {tracking.settling:g} s are left out, where "
        "the loop takes up the weight that was not there at its start."
    )
    yield from by_facet(records[PID], clock, kept)
    yield start_up(records, time)
    yield law_by_law(records, clock, kept)
    yield table_of_rods(found)
    yield first_rod(found)
    yield table_of_laws(f"The day compressed {tracking.compression:g} times, law by law.", found)
    yield halved(found)
    yield Result("figures", {name: told(of) for name, of in found.items()})


def day_of(parameters):
    """The day of the tracking in words."""
    number = int(parameters.tracking.day)
    return NAMES.get(number, f"day {number}")


def told(found):
    """What the summary needs of an experiment."""
    return {"peak": found.peak, "tilt": found.tilt}


def by_facet(record, clock, kept):
    """Fig. 15 (a) to (d)."""
    yield Panels(
        "Fig. 15: errors of the rods under the tuned PID, without feed-forward.",
        [
            Plot(
                f"({letter}) facet on the {facet} axis", "clock time, h", "error, mm",
                [
                    Curve(name, *outline(clock[kept], MM * rods_of(record, k)[kept, i]))
                    for i, name in enumerate(RODS)
                ],
            )
            for k, (letter, facet) in enumerate(zip("abcd", FACETS, strict=True))
        ],
    )  # fmt: skip


def start_up(records, time):
    """The first second of the worst rod."""
    kept = time < START_UP
    curves = []
    for name in LAWS:
        errors = records[name].joined("errors")[kept]
        worst = np.argmax(np.abs(errors).max(axis=0))
        curves.append(Curve(name, *outline(time[kept], MM * errors[:, worst])))
    return Plot(
        "Fig. 15, its beginning: the rod that is farthest off, from rest and with no force at the "
        "start.",
        "time, s", "error, mm", curves,
    )  # fmt: skip


def law_by_law(records, clock, kept):
    """The largest error of the twelve through the day."""

    def worst(name):
        return MM * np.abs(records[name].joined("errors")[kept]).max(axis=1)

    return Plot(
        "The largest error of the twelve rods through the compressed day.",
        "clock time, h",
        Axis("largest error, mm", log=True),
        [
            Curve(name, *outline(clock[kept], worst(name)))
            for name in (*LAWS, IN_CORNER)
        ],
    )  # fmt: skip


def table_of_rods(found):
    """Table 3."""
    both = ("means", "peaks")
    rows = [
        (f"{facet}, {rod}",
         *(MICRO * getattr(found[law], what)[k, i] for law in LAWS for what in both))
        for k, facet in enumerate(FACETS) for i, rod in enumerate(RODS)
    ]  # fmt: skip
    return Table(
        "Table 3: errors of the twelve rods after the start-up: root mean square and largest.",
        [
            "facet, rod",
            *(Column(f"{law}, {what}", "µm", ".1f") for law in LAWS for what in ("rms", "largest")),
        ],
        rows,
    )


def first_rod(found):
    """The paper's claim that rod 1 is the most exact."""
    counts = {
        law: [int((getattr(found[law], what).argmin(axis=1) == 0).sum()) for what in
              ("means", "peaks")]
        for law in LAWS
    }  # fmt: skip
    words = {
        law: f"on {rms} by the root mean square and on {peak} by the largest error"
        for law, (rms, peak) in counts.items()
    }
    holds = "holds" if min(counts[PID]) == len(FACETS) else "does not hold"
    others = "; ".join(f"under {law} {words[law]}" for law in LAWS if law != PID)
    return Prose(
        "The paper finds the error of rod 1 the smallest on all facets, since it moves least. "
        f"Under the paper's law, the tuned PID, it is so {words[PID]} of {len(FACETS)} facets: "
        f"**the claim {holds}.** (Beside it, {others}.)"
    )


def table_of_laws(caption, found):
    """A row for each law and plant."""
    rows = [(name, MM * of.peak, MRAD * of.tilt, of.force) for name, of in found.items()]
    return Table(caption, ["law", *COLUMNS], rows)


def halved(found):
    """Whether the model's step decides anything."""
    whole, half = found[PID], found[HALVED]
    return Prose(
        "With half the time step in MuJoCo, the law's period left as it is, the largest error "
        f"of the PID changes by {100 * abs(half.peak / whole.peak - 1):.1f}% and that of the "
        f"normals by {100 * abs(half.tilt / whole.tilt - 1):.1f}%."
    )
