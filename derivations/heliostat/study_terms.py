"""The same machine in the words of telescope pointing."""

import numpy as np

from armillary.verify.study import Column, Heading, Prose, Table

from .sky import (
    LOWEST,
    MILLI,
    azimuth_of,
    elevation_of,
    exactly,
    facing,
    field,
    lower_than,
    middle,
    rms,
    through_a_day,
    toward,
)
from .study_angles import DAYS, MACHINE

ZEROS = {"alpha_0": 2.0 * MILLI, "beta_0": -1.0 * MILLI, "collimation": 1.5 * MILLI}
TERMS = {  # and what they add to the readings of azimuth and elevation
    "IA": ("alpha_0", "$\\alpha_0$", "$1$", "–"),
    "IE": ("beta_0", "$\\beta_0$", "–", "$1$"),
    "CA": ("collimation", "$\\kappa$", "$1 / \\cos E$", "–"),
    "NPAE": ("chi", "$\\chi$", "$\\tan E$", "–"),
    "AN": ("theta", "$\\theta$", "$\\sin A \\tan E$", "$\\cos A$"),
    "AW": ("psi", "$-\\psi$", "$\\cos A \\tan E$", "$-\\sin A$"),
}
HIGH = 60.0  # degrees


def terms(kernels):
    """The machine's errors as pointing terms."""
    machine = {**MACHINE, **ZEROS}
    points = facing()
    yield Heading("What would a telescope's pointing model call it?")
    yield Prose(
        "Telescopes are calibrated in the terms IA, IE, CA, NPAE, AN and AW: what encoders read "
        "less azimuth and elevation of the normal, with azimuth from north as zero. The machine "
        "of the first question, with zeros of the encoders and a collimation error besides, "
        "through a year of facing the sun:"
    )
    yield table(kernels, machine, points)
    yield fit(kernels, machine)
    yield Heading("Can they be told apart?")
    yield from told_apart(kernels)


def predicted(kernels, n, machine):
    """What the six terms say that azimuth and elevation are off by, the former on the sky."""
    rise = np.radians(elevation_of(n))
    found = kernels.pointing(azimuth=np.radians(azimuth_of(n)), elevation=rise, **machine)
    return np.cos(rise) * found.delta_azimuth, found.delta_elevation


def table(kernels, machine, points):
    """The terms, their sizes, and how far each moves the normal."""
    sizes = kernels.pointing_terms(**machine)
    rows = []
    for name, (own, symbol, across, up) in TERMS.items():
        alone = {**exactly(), own: machine[own]}
        moved = np.hypot(*predicted(kernels, middle(points), alone)) / MILLI
        size = getattr(sizes, name) / MILLI
        rows.append((name, symbol, float(size), across, up, rms(moved), moved.max()))
    return Table(
        "The pointing terms of the machine, what each adds to the readings, and how far off the "
        "normal is if it is left out.",
        [
            "term", "here", Column("size", "mrad", ".1f"), "azimuth", "elevation",
            Column("normal, rms", "mrad", ".2f"), Column("normal, worst", "mrad", ".2f"),
        ],
        rows,
    )  # fmt: skip


def fit(kernels, machine):
    """How well the linear model fits the exact readings."""
    off = []
    for points in (lower_than(facing(), HIGH), facing()):
        n = middle(points)
        angles = kernels.drive(**points, **machine)
        read = kernels.encoder(alpha=angles.alpha, beta=angles.beta, **machine)
        rise = np.radians(elevation_of(n))
        turn = read.alpha_reading + np.pi - np.radians(azimuth_of(n))
        across = np.cos(rise) * (np.remainder(turn + np.pi, 2 * np.pi) - np.pi)
        model = predicted(kernels, n, machine)
        off.append(np.hypot(across - model[0], read.beta_reading - rise - model[1]).max())
    top = elevation_of(facing()["c"]).max()
    return Prose(
        "**AN is $\\theta$, AW is $-\\psi$, NPAE is $\\chi$.** The sum of the six is the exact "
        f"reading to within {off[0] / MILLI:.2f} mrad on the sky below {HIGH:g} degrees, and "
        f"{off[1] / MILLI:.2f} mrad up to {top:.0f} degrees, the highest sun."
    )


def told_apart(kernels):
    """How well a fit of all six is conditioned."""
    days = [(f"{day}, facing the sun", through_a_day(tilt)[1]) for day, tilt in DAYS]
    all_round = np.meshgrid(np.arange(0.0, 360.0, 5.0), np.arange(LOWEST, 86.0, 5.0))
    skies = (
        *days,
        ("a year, facing the sun", middle(facing())),
        ("a year, receivers all round", middle(lower_than(field(), 85.0))),
        (f"everywhere from {LOWEST:g} to 85 degrees", toward(*all_round).reshape(-1, 3)),
    )
    rows = [(name, *conditioned(kernels, n)) for name, n in skies]
    yield Table(
        "A least-squares fit of all six terms to readings: condition number, with the column of "
        "each term made of length 1, and the combination of these columns that is seen least.",
        ["directions of the normal", Column("condition number", "", ".0f"), "seen least"],
        rows,
    )
    ratio = {name: row / rows[-1][1] for name, row, _ in rows}
    worst = max((name for name, _ in days), key=ratio.get)
    yield Prose(
        "On the sky IA, CA and NPAE turn the normal sideways by $\\cos E$, $1$ and $\\sin E$: much "
        "alike where $E$ changes little, and not very different where it changes much. "
        f"**From the {worst}, the terms are told apart {ratio[worst]:.0f} times worse than from "
        f"the whole sky, from a year of receivers all round {ratio[rows[-2][0]]:.1f} times**: low "
        "and high normals are needed for a calibration of all six."
    )


def conditioned(kernels, n):
    """Condition number, and the combination of columns that is seen least."""
    columns = []
    for own, *_ in TERMS.values():
        column = np.concatenate(predicted(kernels, n, {**exactly(), own: MILLI}))
        columns.append(column / np.linalg.norm(column))
    _, sizes, ways = np.linalg.svd(np.array(columns).T, full_matrices=False)
    least = ways[-1] * np.sign(ways[-1][0])
    named = [(x, name) for x, name in zip(least, TERMS, strict=True) if abs(x) > 0.05]
    text = " ".join(f"{'−' if x < 0 else '+'} {abs(x):.2f} {name}" for x, name in named)
    return sizes[0] / sizes[-1], text.removeprefix("+ ")
