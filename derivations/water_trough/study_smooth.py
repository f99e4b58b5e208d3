"""Smooth friction never holds: how fast it lets the trough creep."""

import numpy as np

from armillary.verify.plots import Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table, text_of

from .motion_of import creeping
from .pumping import Piece
from .troughs import trough

SUN = np.radians(15) / 3600  # rad/s
LONG = 0.5  # of the angle off the rest, that the creep covers at its first speed
FIRM = 1e-3  # largest part by which the prediction may miss


def smooth(kernels, native, parameters, tell):
    """Creep at several speeds of the ramp, against its prediction."""
    given, settings = trough(parameters), parameters.smooth
    width = float(kernels.stick_band(s=0.0, **given).half_width)
    first = float(kernels.rest_angle(s=0.0, **given).theta)
    off = np.arcsin(settings.part * np.sin(width))
    rows, curves = [], []
    for k, omega_s in enumerate(settings.omega_s):
        tell(k / len(settings.omega_s), f"{omega_s:g} rad/s")
        smoothed = {**given, "omega_s": omega_s}
        begun = -float(kernels.creep(theta=first + off, s=0.0, **smoothed).omega)
        span = LONG * off / begun
        way = creeping(native, smoothed, [Piece(0.0, span, 0.0)], first + off)
        rows.append((omega_s, begun, begun / SUN, off / begun, judged(kernels, way, smoothed)))
        curves.append(Curve(f"{omega_s:g} rad/s", way[0] / span, np.degrees(way[1] - first)))
    yield Heading("Smooth friction creeps")
    yield Prose(
        "An integrator that knows no events may take `acceleration_smooth`, whose friction grows "
        "with the speed. Where dry friction would hold the trough it then creeps, at the speed at "
        "which the smooth friction is as large as the drive; `creep` tells it. Here the trough is "
        f"left {np.degrees(off):.4f} degrees off its rest, where the drive is {settings.part:g} of "
        "what friction holds."
    )
    yield Plot(
        "The trough that should stand, under smooth friction. Each time axis is "
        "scaled to its own creep: the curves fall on each other where the prediction holds.",
        "time, of that of the experiment", "angle off the rest, degrees", curves,
    )  # fmt: skip
    yield listed(rows)
    yield Prose(in_words(rows))
    yield Result("smooth", {"misses": [row[-1] for row in rows]})


def listed(rows):
    """Speed by speed."""
    return Table(
        "Creep under smooth friction.",
        [
            Column("$\\omega_\\mathrm{s}$", "rad/s", ".0e"),
            Column("first speed predicted", "rad/s", ".3e"),
            Column("of 15 degrees an hour", "", ".2f"),
            Column("time in which the range is lost", "s", ".3g"),
            Column("largest relative miss of the prediction", "", ".1e"),
        ],
        rows,
    )  # fmt: skip


def judged(kernels, way, given):
    """How far the speed is from its prediction, once the start is over, as a part of it."""
    time, theta, omega = way
    late = time > 0.2 * time[-1]
    wanted = kernels.creep(theta=theta[late], s=0.0, **given).omega
    return float(np.max(np.abs(omega[late] / wanted - 1)))


def in_words(rows):
    """Which speeds do."""
    held = [row for row in rows if row[-1] < FIRM]
    fast = [row for row in rows if row[2] > 0.1]
    words = (
        f"The prediction holds within {text_of(max(row[-1] for row in held), '.0e')} for "
        f"{len(held)} of the {len(rows)}. "
        if held else "The prediction holds for none of them. "
    )  # fmt: skip
    return words + (
        f"**With {len(fast)} of the {len(rows)} the trough creeps faster than a tenth of the "
        "sun's own speed**: such friction keeps no dead band, and a study of tracking needs "
        "either true sticking or a much smaller $\\omega_\\mathrm{s}$."
    )
