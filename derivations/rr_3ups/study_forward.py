"""From lengths to angles: how good a guess must be, and what the third length tells."""

from itertools import pairwise

import numpy as np

from armillary.verify.plots import Axis, Curve, HeatMap, Panels, Plot, centres
from armillary.verify.study import Column, Heading, Prose, Table

from .study_basis import SPRING, SUMMER, WINTER, day_of, mount

CELL = 6.0  # degrees
TILT = 90.0  # degrees, the upper end of the maps
WAYS = np.arange(16) * np.pi / 8  # in which a guess is off
MAPPED = (5.0, 20.0)  # degrees
SHARES = (0, 25, 50, 75, 95, 100)  # %; only all of the guesses are in the last class
OFF = (1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 45.0)  # degrees
EDGES = (0.0, 10.0, 20.0, 30.0, 45.0, 60.0, 80.0)  # degrees, classes of the tilt
COUNT = 12000  # attitudes at random
SEED = 73
RIGHT = 1e-6  # rad, within which the attitude found is the right one
DAYS = (SUMMER, SPRING, WINTER)
MINUTES = 2.0  # between attitudes of a day
BEFORE = (2.0, 4.0, 10.0, 30.0, 60.0)  # minutes
FALSE = np.linspace(-10.0, 10.0, 41)  # mm, errors of one length
MILLI = 1e-3


def forward(kernels, sun, parameters):
    """Maps of the basin, a table of its size, and errors of one length."""
    size = mount(parameters)
    days = [day_of(kernels, sun, parameters, k, MINUTES) for k in DAYS]
    yield Heading("From lengths to angles: how good must the guess be?")
    yield maps(kernels, size, days)
    yield basin(kernels, size)
    sure = [sure_within(kernels, size, day) for day in days]
    yield on_the_days(kernels, size, days, sure)
    yield Prose(where_narrow(kernels, size, days, sure))
    yield discord(kernels, size, days[1])


def where_narrow(kernels, size, days, sure):
    """On which day the basin is narrowest, and how firmly three drives hold there."""
    held = [float(kernels.singularity(**day.pose, **size).sigma_min.min()) for day in days]
    narrow, loose = int(np.argmin(sure)), int(np.argmin(held))
    said = (
        f"The basin is narrowest on the {days[narrow].name}; the least singular value of the three "
        f"drives, {1e3 * held[loose]:.0f} mm a radian, is that of the {days[loose].name}."
    )
    if narrow == loose:
        said += (
            " The two go together: where three drives hardly hold the platform some motion hardly "
            "changes the lengths, and two attitudes with nearly the same lengths lie side by side."
        )
    return (
        f"{said} Another attitude whose lengths fit is a true answer; another whose lengths do not "
        "is told by the residual."
    )


def search(kernels, size, attitude, guess):
    """Whether the kernel leads back from guesses to attitudes (..., 2), and its answer."""
    q = kernels.leg_lengths(alpha=attitude[..., 0], beta=attitude[..., 1], **size).q
    found = kernels.forward(q=q, guess=guess, **size)
    return (found.status == 0) & (apart(found, attitude) < RIGHT), found


def apart(found, attitude):
    """The larger difference of the two angles, but for whole turns, rad."""
    off = np.stack([found.alpha, found.beta], axis=-1) - attitude
    return np.abs(np.nan_to_num(np.angle(np.exp(1j * off)), nan=np.pi)).max(axis=-1)


def around(attitude, degrees):
    """Guesses that are off by an angle in every direction: (..., ways, 2)."""
    off = np.radians(degrees) * np.stack([np.cos(WAYS), np.sin(WAYS)], axis=-1)
    return attitude[..., None, :] + off


def leads_back(kernels, size, attitude, degrees):
    """Whether each of the guesses around each attitude leads back."""
    guess = around(attitude, degrees)
    return search(kernels, size, np.broadcast_to(attitude[..., None, :], guess.shape), guess)[0]


def maps(kernels, size, days):
    """Over the attitude: the share of guesses around it that lead back."""
    turn, tilt = np.arange(-180.0, 181.0, CELL), np.arange(0.0, TILT + 1, CELL)
    a, b = np.meshgrid(np.radians(centres(turn)), np.radians(centres(tilt)))
    attitude = np.stack([a, b], axis=-1)
    ways = [Curve(day.name, *np.degrees([day.state["alpha"], day.state["beta"]])) for day in days]
    panels = [
        HeatMap(
            f"guess off by {off:g} degrees", "α, degrees", "β, degrees", "lead back, %", turn, tilt,
            100 * leads_back(kernels, size, attitude, off).mean(axis=-1), SHARES, curves=ways,
        )
        for off in MAPPED
    ]  # fmt: skip
    return Panels(
        f"Share of {len(WAYS)} guesses around an attitude that lead back to it, and the ways of "
        "the days.",
        panels,
    )


def basin(kernels, size):
    """A row for each distance of the guess."""
    random = np.random.default_rng(SEED)
    tilt = random.uniform(EDGES[0], EDGES[-1], COUNT)
    attitude = np.stack([random.uniform(-np.pi, np.pi, COUNT), np.radians(tilt)], axis=-1)
    way = random.uniform(-np.pi, np.pi, COUNT)
    rows = []
    for off in OFF:
        guess = attitude + np.radians(off) * np.stack([np.cos(way), np.sin(way)], axis=-1)
        right, found = search(kernels, size, attitude, guess)
        other = (found.status == 0) & ~right
        fits = other & (found.residual < MILLI)
        shares = [
            100 * right[(tilt >= low) & (tilt < high)].mean() for low, high in pairwise(EDGES)
        ]
        rows.append(
            (off, *shares, 100 * fits.mean(), 100 * (other & ~fits).mean(),
             100 * (found.status < 0).mean())
        )  # fmt: skip
    return Table(
        "Share of searches that lead back to the attitude, by how far the guess is off and by the "
        "tilt; share of all that end at another attitude, whose lengths are within a millimetre of "
        "those given, or not; and that are told as NOT_CONVERGED. Attitudes at random.",
        [
            Column("guess off by", "degrees", ".0f"),
            *(Column(f"tilt {low:g} to {high:g}", "%", ".2f") for low, high in pairwise(EDGES)),
            Column("another, fits", "%", ".2f"), Column("another, does not", "%", ".2f"),
            Column("none", "%", ".2f"),
        ],
        rows,
    )  # fmt: skip


def sure_within(kernels, size, day):
    """The largest of the distances, degrees, within which every guess about a day led back."""
    attitude = np.stack([day.state["alpha"], day.state["beta"]], axis=-1)
    good = [bool(leads_back(kernels, size, attitude, off).all()) for off in OFF]
    first = good.index(False) if False in good else len(good)
    return OFF[first - 1] if first else 0.0


def on_the_days(kernels, size, days, sure):
    """A row for each day: how far every guess may be off, and searches from attitudes before."""
    rows = []
    for day, within in zip(days, sure, strict=True):
        attitude = np.stack([day.state["alpha"], day.state["beta"]], axis=-1)
        step = 60 * (day.clock[1] - day.clock[0])
        lags = [max(1, round(minutes / step)) for minutes in BEFORE]
        shares = [
            100 * search(kernels, size, attitude[lag:], attitude[:-lag])[0].mean() for lag in lags
        ]
        rows.append((day.name, within, *shares))
    return Table(
        "On the ways of the days: the largest of the distances above within which every guess led "
        f"back, and the share of searches that lead back from an attitude of the same day before. "
        f"Attitudes {MINUTES:g} minutes apart.",
        [
            "day", Column("sure within", "degrees", ".0f"),
            *(Column(f"from {minutes:g} min before", "%", ".1f") for minutes in BEFORE),
        ],
        rows,
    )  # fmt: skip


def discord(kernels, size, day):
    """Residual and angles when one length is read wrong at two times of a day."""
    times = (len(day.clock) // 4, len(day.clock) // 2 + 1)
    curves = []
    for at in times:
        attitude = np.stack([day.state["alpha"][at], day.state["beta"][at]])
        q = kernels.leg_lengths(alpha=attitude[0], beta=attitude[1], **size).q
        for leg in range(3):
            given = q + MILLI * FALSE[:, None] * np.eye(3)[leg]
            found = kernels.forward(q=given, guess=attitude, **size)
            residual = np.where(found.status == 0, found.residual, np.nan) / MILLI
            curves.append(Curve(f"leg {leg + 1}, {day.clock[at]:.1f} h", FALSE, residual))
    return Plot(
        f"What is left when one length is read wrong, on the {day.name}. The slope tells how much "
        "of such an error the third length shows; the rest turns the platform that is found. Where "
        "the search answers NOT_CONVERGED, there is no line.",
        "error of the length, mm", Axis("residual, mm", low=0.0), curves,
    )  # fmt: skip
