"""Water left to itself is level: what the convention of the parallel surface leaves out."""

import numpy as np

from armillary.verify.study import Column, Heading, Prose, Result, Table, text_of

from .troughs import SIZES, TITLES, trough

LITRE, MM = 1e3, 1e3
PARTS = (0.0, 0.25, 0.5, 0.75, 1.0)  # of the stroke
FINE = 2001  # angles among which the one is sought at which a container runs over


def surface(kernels, parameters):
    """Both troughs through the stroke."""
    stroke = parameters.place.stroke
    found = {size: figures(kernels, trough(parameters, size), stroke) for size in SIZES}
    brims = {size: brim(kernels, trough(parameters, size)) for size in SIZES}
    yield Heading("What a level surface changes")
    yield Prose(
        "The model keeps the water's surface parallel to the floor, by convention. At the speed of "
        "tracking a free surface stays level. `free_surface` tells what that takes off the "
        "stiffness and how high water stands at the lower wall, `rest_volume_level` the volume for "
        "an angle."
    )
    yield Table(
        "Parallel and level surfaces through the stroke.",
        [
            "trough", Column("angle", "degrees", ".0f"),
            Column("volume, parallel", "l", ".3f"), Column("volume, level", "l", ".3f"),
            Column("stiffness lost", "%", ".1f"), Column("water at the wall", "mm", ".0f"),
            Column("height of the wall", "mm", ".0f"), Column("runs over at", "degrees", ".1f"),
        ],
        [
            (TITLES[size], *row, MM * trough(parameters, size)["h_max"], brims[size])
            for size in SIZES for row in found[size]
        ],
    )  # fmt: skip
    yield Prose(in_words(found, brims, stroke))
    yield Result(
        "surface",
        {TITLES[size]: {"lost": found[size][-1][3], "brim": brims[size]} for size in SIZES},
    )


def figures(kernels, given, stroke):
    """Angle, both volumes, loss of stiffness in percent and height at the wall, at each part."""
    rows = []
    for part in PARTS:
        at = {"theta": np.radians(part * stroke), **given}
        s = float(kernels.rest_volume(**at).s)
        free = kernels.free_surface(**at, s=s)
        level = float(kernels.rest_volume_level(**at).s)
        wall = max(float(free.wall_1), float(free.wall_2))
        rows.append((part * stroke, LITRE * s, LITRE * level, 100 * float(free.loss), MM * wall))
    return rows


def brim(kernels, given):
    """Least angle at which level water runs over an open container, or nan, degrees."""
    angles = np.linspace(0.0, 89.0, FINE)
    at = {"theta": np.radians(angles), **given}
    free = kernels.free_surface(**at, s=kernels.rest_volume(**at).s)
    over = np.fmax(free.wall_1, free.wall_2) > given["h_max"]
    return float(angles[np.argmax(over)]) if over.any() else float("nan")


def in_words(found, brims, stroke):
    """How much, and whether open containers do."""
    lost = max(row[3] for rows in found.values() for row in rows)
    less = max(1 - row[2] / row[1] for rows in found.values() for row in rows if row[1])
    least = min(brims.values())
    open_do = (
        f"**Open containers keep their water through the stroke**: the first runs over at "
        f"{least:.1f} degrees and the stroke ends at {stroke:g}."
        if least > stroke else
        f"**Open containers run over within the stroke**, at {least:.1f} degrees of {stroke:g}: "
        "they must be closed."
    )  # fmt: skip
    return (
        f"Level surfaces take up to {text_of(lost, '.0f')} % of the stiffness, and an angle needs "
        f"up to {text_of(100 * less, '.0f')} % less water. Periods, bands of friction and gains on "
        f"this page are those of the convention, and change with the stiffness. {open_do}"
    )
