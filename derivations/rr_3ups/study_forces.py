"""Forces of the drives through the equinox (Fig. 6)."""

import numpy as np

from armillary.verify.plots import Axis, Curve, Mark, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .study_basis import (
    CLIPPED,
    LEGS,
    NOON,
    SPRING,
    clock_words,
    crossings,
    day_of,
    declination,
    mean,
    mount,
    three,
    two,
)

DRIVES = ("three drives", "two drives")


def forces(kernels, sun, parameters):
    """Fig. 6, largest and mean forces."""
    size, day = mount(parameters), day_of(kernels, sun, parameters)
    found = three(kernels, day.state, size), two(kernels, day.state, size)
    zeros = crossings(kernels, parameters, declination(parameters, SPRING), day.clock, size)
    yield Heading("Fig. 6: forces on the equinox")
    singular = [Mark(t, "" if k else "singular", across=True) for k, t in enumerate(zeros)]
    for letter, name, F, marks in zip("ab", DRIVES, found, ((), singular), strict=True):
        yield Plot(
            f"Fig. 6 ({letter}): forces of the {name} on the equinox.",
            "solar time, h", Axis("force, N", low=None if F is found[0] else -CLIPPED,
                                  high=None if F is found[0] else CLIPPED),
            [Curve(leg, day.clock, clipped(F[:, i]))
             for i, leg in enumerate(LEGS[: F.shape[1]])],
            marks,
        )  # fmt: skip
    facts = figures(day, *found, zeros)
    yield table(facts, parameters.published)
    yield Prose(words(facts, parameters.published))
    yield Prose(at_the_ends(facts))
    yield Result("forces", facts)


def clipped(force):
    """A force where it can be drawn."""
    return np.where(np.abs(force) <= CLIPPED, force, np.nan)


def figures(day, F, F_2, zeros):
    """What decides the claims."""
    noon = np.argmin(np.abs(day.clock - NOON))
    return {
        "peak": np.abs(F).max(axis=0).tolist(),
        "mean": [mean(np.abs(column), day.clock) for column in F.T],
        # Two drives have neither where they are singular.
        "peak_two": None if zeros else float(np.abs(F_2).max()),
        "mean_two": None if zeros else [mean(np.abs(column), day.clock) for column in F_2.T],
        "dawn": [F[0].tolist(), F_2[0].tolist()],
        "noon": [F[noon].tolist(), F_2[noon].tolist()],
        "zeros": zeros,
    }


def table(facts, published):
    """Three drives; two have no largest force."""
    means, theirs = facts["mean"], published.mean_forces
    return Table(
        "Largest and mean forces of the three drives on the equinox.",
        ["drive", Column("largest", "N", ".1f"), Column("mean", "N", ".1f"),
         Column("mean in the paper", "N", ".0f")],
        [(leg, peak, mean_, wanted) for leg, peak, mean_, wanted in
         zip(LEGS, facts["peak"], means, theirs, strict=True)],
    )  # fmt: skip


def words(facts, published):
    """What comes out."""
    if facts["zeros"]:
        times = " and at ".join(clock_words(t) for t in facts["zeros"])
        second = (
            f"**Two drives have no largest force: at {times} they do not hold the platform**, and "
            "the forces grow without bound on the way there. The paper's curve can only show what "
            "its samples happened to meet."
        )
    else:
        second = "Two drives hold the platform all day."
    return (
        f"The three drives push or pull with at most {max(facts['peak']):.1f} N; the paper has "
        f"{published.peak_force:g} N. Legs 1 and 2 carry as much as each other, mirrored about "
        f"noon, as the paper's means do; leg 3 carries the most here and the least there. {second}"
    )


def at_the_ends(facts):
    """Why both mechanisms agree at sunrise."""
    (*pair, third), both = facts["dawn"]
    same = max(abs(a - b) for a, b in zip(pair, both, strict=True)) + abs(third)
    words = (
        f"At sunrise and sunset of the equinox {pair[0]:.2f} and {pair[1]:.2f} N are needed with "
        f"three drives, {both[0]:.2f} and {both[1]:.2f} N with two."
    )
    if same > 1e-6:
        return words
    return (
        f"{words} **There the two mechanisms agree**: the spherical joint of leg 3 stands upright "
        "above o, neither angle changes the leg's length, and it carries nothing, whatever the "
        "masses are. That much of the paper's equal peaks at dawn and dusk follows from the "
        "dimensions alone."
    )
