"""The twelve rods through the four days (Fig. 6), and through the year."""

import numpy as np

from armillary.verify.plots import Axis, Curve, Mark, Panels, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .days import (
    FACETS,
    MM,
    NAMES,
    RODS,
    attitude,
    clock_words,
    day_names,
    four,
    hours,
    mount,
    place,
)

YEAR = np.arange(1, 366)
COARSE = 10.0  # minutes, through the year
DAY = 86400.0  # s


def rods(kernels, sun, parameters):
    """Fig. 6, its extremes, and the speeds."""
    size, days = mount(kernels, parameters), day_names(parameters)
    clock = hours(parameters)
    yield Heading("Fig. 6: the rods through the days")
    lengths = {}
    for letter, (n, name) in zip("abcdefgh", days.items(), strict=False):
        angles = attitude(kernels, sun, parameters, n, clock)
        lengths[n] = MM * kernels.rod_lengths_all(**angles, **size).l
        yield Panels(
            f"Fig. 6 ({letter}): lengths of the rods of the four facets {on(name)}.",
            [
                Plot(
                    f"facet {facet}", "clock time, h", "length, mm",
                    [Curve(rod, clock, lengths[n][:, k, i]) for i, rod in enumerate(RODS)],
                )
                for k, facet in enumerate(FACETS)
            ],
        )  # fmt: skip
    yield extremes_by_day(days, lengths, clock)
    yield extremes_by_rod(lengths)
    yield suffice(lengths, parameters)
    yield from through_the_year(kernels, sun, parameters, size, lengths)
    yield from speeds(kernels, sun, parameters, size, days)


def extremes_by_day(days, lengths, clock):
    """Shortest and longest of each day, with rod and time."""
    rows = []
    for n, l in lengths.items():
        cells = [days[n]]
        for pick in (np.argmin, np.argmax):
            t, facet, rod = np.unravel_index(pick(l), l.shape)
            cells += [l[t, facet, rod], f"{FACETS[facet]}, {RODS[rod]}, {clock_words(clock[t])}"]
        rows.append((*cells, np.ptp(l)))
    return Table(
        "Shortest and longest rod of each day.",
        [
            "day", Column("shortest", "mm", ".2f"), "facet, rod, time",
            Column("longest", "mm", ".2f"), "facet, rod, time", Column("stroke", "mm", ".2f"),
        ],
        rows,
    )  # fmt: skip


def extremes_by_rod(lengths):
    """Each of the twelve over all days."""
    l = np.concatenate(list(lengths.values()))
    rows = [
        (f"{facet}, {rod}", l[:, k, i].min(), l[:, k, i].max(), np.ptp(l[:, k, i]))
        for k, facet in enumerate(FACETS)
        for i, rod in enumerate(RODS)
    ]
    return Table(
        "Each rod over the four days.",
        ["facet, rod", *(Column(w, "mm", ".1f") for w in ("shortest", "longest", "stroke"))],
        rows,
    )


def suffice(lengths, parameters):
    """What the paper concludes from the extremes."""
    limits = parameters.rods
    l = np.concatenate(list(lengths.values()))
    low, high = l.min(), l.max()
    off = [low - MM * limits.found_shortest, high - MM * limits.found_longest]
    inside = MM * limits.shortest <= low and high <= MM * limits.longest
    left = MM * 2 * limits.shortest - high
    overlap = (
        f"At its longest a rod's sections then overlap by {left:.0f} mm, the bearing length that "
        "carries its bending; the paper sets no least overlap."
        if left > 0
        else f"At its longest a rod's sections are {-left:.0f} mm too short to meet."
    )
    return Prose(
        f"**The rods measure {low:.2f} to {high:.2f} mm**; the paper has "
        f"{MM * limits.found_shortest:.0f} and {MM * limits.found_longest:.0f}, which is "
        f"{abs(off[0]):.2f} and {abs(off[1]):.2f} mm off (the dimensions are inferred from these "
        "two). Rod 1 is the one that stands on the dish's side of its facet. The rods "
        f"{'stay' if inside else 'do not stay'} within {MM * limits.shortest:.0f} to "
        f"{MM * limits.longest:.0f} mm, so that two sections of {MM * limits.shortest:.0f} mm "
        f"{'suffice' if inside else 'do not suffice'} by the paper's count. {overlap}"
    )


def on(name):
    """A day as it stands in a sentence."""
    return f"on the {name}" if name in NAMES.values() else f"on {name}"


def through_the_year(kernels, sun, parameters, size, lengths):
    """Whether the four days hold the extremes of all."""
    clock = hours(parameters, COARSE)
    angles = attitude(kernels, sun, parameters, YEAR[:, None], clock)
    l = MM * kernels.rod_lengths_all(**angles, **size).l.reshape(len(YEAR), -1)
    low, high = l.min(axis=1), l.max(axis=1)
    limits = parameters.rods
    yield Plot(
        "Shortest and longest rod of every day of the year, within the hours of the tracking.",
        "day of the year", "length, mm",
        [Curve("longest", YEAR, high), Curve("shortest", YEAR, low)],
        [Mark(MM * limits.shortest, "two sections"), Mark(MM * limits.longest, "two sections")],
    )  # fmt: skip
    four_days = np.concatenate([day.ravel() for day in lengths.values()])
    first, last = YEAR[np.argmin(low)], YEAR[np.argmax(high)]
    beyond = (four_days.min() - low.min(), high.max() - four_days.max())
    hold = "do not hold" if max(beyond) > 0 else "hold"
    yield Prose(
        f"The four days {hold} the year's extremes: the shortest rod of the year is "
        f"{low.min():.1f} mm on day {first}, where theirs is {four_days.min():.1f}, the longest "
        f"{high.max():.1f} mm on day {last}, where theirs is {four_days.max():.1f}."
    )


def speeds(kernels, sun, parameters, size, days):
    """How fast the rods go, by the Jacobians (21) to (27)."""
    clock = hours(parameters)
    rows, curves = [], []
    for n, name in days.items():
        where = place(sun, parameters, n, clock)
        turn = sun.rates(**where, hour_angle_rate=2 * np.pi / DAY)
        # The dish's azimuth counts from east and against the clock, beta from the zenith.
        rates = {
            "alpha_dot": -turn.azimuth_rate, "beta_dot": -turn.elevation_rate,
            "z_dot": np.zeros_like(clock),
        }  # fmt: skip
        angles = attitude(kernels, sun, parameters, n, clock)
        found = np.abs(60 * MM * kernels.rod_rates(**four({**angles, **rates}), **size).l_dot)
        t, facet, rod = np.unravel_index(np.argmax(found), found.shape)
        where = f"{FACETS[facet]}, {RODS[rod]}, {clock_words(clock[t])}"
        rows.append((name, found[t, facet, rod], where, *found.max(axis=(0, 1))))
        curves.append(Curve(name, clock, found.reshape(len(clock), -1).max(axis=1)))
    yield Plot(
        "Speed of the fastest of the twelve rods through the days.",
        "clock time, h",
        Axis("speed, mm/min", low=0.0),
        curves,
    )
    yield Table(
        "Largest speed of the rods.",
        [
            "day", Column("fastest", "mm/min", ".1f"), "facet, rod, time",
            *(Column(rod, "mm/min", ".1f") for rod in RODS),
        ],
        rows,
    )  # fmt: skip
    fastest = max(row[1] for row in rows)
    slowest = all(row[3] <= min(row[4:]) for row in rows)
    yield Prose(
        f"No rod goes faster than {fastest:.1f} mm/min ({fastest / 60:.2f} mm/s). "
        f"Rod 1, on the dish's side, {'is' if slowest else 'is not'} the slowest of the three on "
        f"every day, at most {max(row[3] for row in rows):.1f} mm/min"
        + (
            ": it moves least, as the paper says when it explains why the error of rod 1 is the "
            "smallest."
            if slowest
            else ", where the paper has it move least."
        )
    )
