"""The cycles of the day beside the closed form."""

from itertools import pairwise

import numpy as np

from armillary.verify.plots import Axis, Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .troughs import TITLES, law, trough

NAMES = ("period", "pump on", "last error")
GOOD = 0.02  # by which the closed form of the cycle may miss in the mean


def cycles(kernels, parameters, found, free):
    """Each cycle of both troughs while the sun is followed, beside the closed form."""
    compared = {size: periods(kernels, parameters, size, of, free) for size, of in found.items()}
    yield Heading("The cycle of the pump")
    yield Prose(
        "`cycle` tells the steady cycle of a trough behind a steady sun, with swings, coast and "
        "the lag of the law: half of a sampling period and half of a ramp. In the day the law "
        "wakes once in a while, hears an angle in steps, and the sun's rate changes. Nothing is "
        "fitted."
    )
    for size, (clock, told, seen) in compared.items():
        yield Plot(
            f"Period of the pump's cycle of the {TITLES[size]} trough while the sun is followed.",
            "solar time, h", Axis("period, s", low=0.0),
            [Curve("simulated", clock, seen[0], style="points"),
             Curve("closed form", clock, told[0])],
        )  # fmt: skip
    rows = [
        (TITLES[size], len(clock), name, np.mean(seen[k]), np.mean(told[k]),
         np.mean(seen[k]) / np.mean(told[k]), np.std(seen[k] / told[k]))
        for size, (clock, told, seen) in compared.items()
        for k, name in enumerate(NAMES)
    ]  # fmt: skip
    yield Table(
        "The cycles of the day in the mean: seconds, and degrees of the last error.",
        [
            "trough", Column("cycles", "", ".0f"), "figure", Column("simulated", "", ".4g"),
            Column("closed form", "", ".4g"), Column("ratio", "", ".3f"),
            Column("deviation of single ones", "", ".3f"),
        ],
        rows,
    )  # fmt: skip
    yield Prose(in_words(rows))
    yield Result("cycles", {f"{row[0]} {row[2]}": float(row[5]) for row in rows})


def periods(kernels, parameters, size, found, free):
    """Of each cycle while the sun is followed: clock, and figures by closed form and simulated."""
    given, step = {**trough(parameters, size), **law(parameters, size)}, parameters.control.period
    running = found.pump != 0
    starts = np.flatnonzero(running[1:] & ~running[:-1]) + 1
    clock, told, seen = [], [], []
    for a, b in pairwise(starts):
        if not (np.all(free[a : b + 1]) and np.all(found.pump[a:b] >= 0)):
            continue
        span = step * (b - a)
        rate = (found.wanted[b] - found.wanted[a]) / span
        s = (found.s[a] + found.s[b]) / 2
        cycle = kernels.cycle(s=s, theta_dot_ref=rate, **given)
        clock.append(found.clock[a])
        told.append((cycle.t_cycle, cycle.t_on, np.degrees(cycle.error_rest)))
        seen.append((span, (found.s[b] - found.s[a]) / given["q_pump"], found.error[a:b].min()))
    return np.array(clock), np.array(told, dtype=float).T, np.array(seen).T


def in_words(rows):
    """Whether the closed form holds in the mean."""
    far = [row for row in rows if not abs(row[5] - 1) <= GOOD]
    if not far:
        return (
            f"**In the mean every figure is within {100 * GOOD:g} % of the closed form.** Single "
            "cycles scatter with the sampling and with the steps of the sensor."
        )
    listed = ", ".join(f"{row[2]} of the {row[0]} trough ({row[5]:.3f})" for row in far)
    return (
        f"Beyond {100 * GOOD:g} % of the closed form in the mean: {listed}. Where a slip ends near "
        "a whole swing the coast is short, and a law that wakes late lets it grow: the mean over "
        "many lags is not the cycle of the mean lag."
    )
