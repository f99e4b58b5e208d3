"""What a sampled day says of two drives: figures that depend on the step."""

import numpy as np

from armillary.verify.plots import Axis, Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Table, text_of

from .study_basis import (
    HOUR,
    SPRING,
    clock_words,
    crossings,
    day_of,
    declination,
    mean,
    mount,
    state_at,
    three,
    two,
)

TEN = 10.0  # min
GROWTH = (
    "Near a crossing the forces of two drives grow as one over the time that is left. The largest "
    "of the samples then says how near one of them came; the mean grows with the logarithm of the "
    "finest step, and the integral of the squares, which is the copper's heat, with one over it. "
    "None of the three has a value."
)
NEAR = np.geomspace(1.0, 1800.0, 40)  # s before the first crossing


def bounds(kernels, sun, parameters):
    """Largest force, mean force and heat against the step; the force against the distance."""
    size = mount(parameters)
    steps = parameters.sampling.steps
    sampled = [day_of(kernels, sun, parameters, SPRING, step) for step in steps]
    found = {
        name: [figures(day, of(kernels, day.state, size)) for day in sampled]
        for name, of in (("three drives", three), ("two drives", two))
    }
    finest = sampled[steps.index(min(steps))]
    zeros = crossings(kernels, parameters, declination(parameters, SPRING), finest.clock, size)
    yield Heading("What the step of time decides")
    yield Prose(GROWTH if zeros else "Two drives hold the platform at every sample of the equinox.")
    yield against_the_step(steps, found)
    if zeros:
        yield from before(kernels, parameters, size, finest, zeros[0])
    yield table(steps, found)
    yield Prose(words(steps, found, zeros))


def figures(day, F):
    """Largest force, mean size, and mean of the summed squares."""
    size = np.abs(F)
    return (
        float(np.nanmax(size)),
        float(np.mean([mean(column, day.clock) for column in size.T])),
        mean((F**2).sum(axis=1), day.clock),
    )


def against_the_step(steps, found):
    """The largest force."""
    return Plot(
        "Largest force of the samples on the equinox against the step: a force that has a bound "
        "settles as the step shrinks, to the left.",
        Axis("step, min", log=True), Axis("largest force, N", log=True),
        [Curve(name, steps, [row[0] for row in rows], style="both")
         for name, rows in found.items()],
    )  # fmt: skip


def before(kernels, parameters, size, day, zero):
    """The forces shortly before the first crossing."""
    state = state_at(kernels, parameters, declination(parameters, SPRING), zero - NEAR / HOUR)
    F = np.abs(two(kernels, state, size))
    yield Plot(
        "Sizes of the forces of two drives before the first crossing of the equinox: ten times "
        "nearer, ten times larger.",
        Axis("time to the crossing, s", log=True), Axis("force, N", log=True),
        [Curve(f"leg {i + 1}", NEAR, F[:, i]) for i in range(2)],
    )  # fmt: skip
    peak = parameters.published.peak_force
    larger = np.abs(two(kernels, day.state, size)).max(axis=1)
    above = day.clock[~(larger <= peak)]
    second = float(F[0].max() * NEAR[0])
    yield Prose(
        f"The larger force is {second / 60:.0f} N a minute before {clock_words(zero)} and "
        f"{second:.0f} N a second before it. {above_in_words(day, above, peak)}"
    )


def above_in_words(day, above, peak):
    """When two drives need more than the paper's largest force."""
    if not len(above):
        return f"At no sample it is above the paper's {peak:g} N."
    throughout = len(above) == np.sum((day.clock >= above[0]) & (day.clock <= above[-1]))
    return (
        f"It is above the paper's {peak:g} N "
        + ("all the time " if throughout else "for parts of the time ")
        + f"from {clock_words(above[0])} to {clock_words(above[-1])}."
    )


def table(steps, found):
    """All three against the step."""
    rows = []
    for step, a, b in zip(steps, found["three drives"], found["two drives"], strict=True):
        rows.append((step, a[0], b[0], a[1], b[1], a[2], b[2]))
    names = "three drives", "two drives"
    return Table(
        "Figures of the equinox against the step; the squares are added over the drives and "
        "averaged over the day.",
        [
            Column("step", "min", "g"),
            *(Column(f"largest, {name}", "N", ".1f") for name in names),
            *(Column(f"mean, {name}", "N", ".2f") for name in names),
            *(Column(f"mean square, {name}", "N²", ".4g") for name in names),
        ],
        rows,
    )  # fmt: skip


def words(steps, found, zeros):
    """How far apart the samplings are."""
    spread = [max(column) / min(column) for column in zip(*found["two drives"], strict=True)]
    fine = [row for step, row in zip(steps, found["three drives"], strict=True) if step <= TEN]
    firm = max(max(column) / min(column) - 1 for column in zip(*(fine or found["three drives"]),
                                                               strict=True))  # fmt: skip
    factors = ", ".join(text_of(of, ".3g") for of in spread)
    least = min(row[0] for row in found["two drives"])
    said = (
        f"From steps of {max(steps):g} to {min(steps):g} minutes the figures of two drives change "
        f"by factors of {factors}, and no step has less than {least:.0f} N; those of three drives, "
        f"from {TEN:g} minutes down, change by {100 * firm:.1f}%. "
    )
    if zeros:
        return said + (
            "**Of two drives on this day neither a largest force nor a mean force nor a heat can "
            "be stated**, and a saving against them cannot either."
        )
    finest = [row for _, row in sorted(zip(steps, found["two drives"], strict=True))[:2]]
    last = max(max(pair) / min(pair) - 1 for pair in zip(*finest, strict=True))
    return f"{said}Between the two finest steps those of two drives change by {100 * last:.1f}%."
