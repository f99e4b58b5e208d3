"""Forces of the drives through the equinox (Fig. 6)."""

import numpy as np

from armillary.verify.plots import Axis, Curve, Mark, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table, text_of

from .study_basis import (
    CLIPPED,
    LEGS,
    NOON,
    SPRING,
    WITHIN,
    centre_words,
    clock_words,
    crossings,
    day_of,
    declination,
    mean,
    mount,
    near,
    three,
    two,
)

DRIVES = ("three drives", "two drives")
SAME = 1e-6  # N, and m a radian: less is rounding


def forces(kernels, sun, parameters):
    """Fig. 6, largest and mean forces."""
    size, day = mount(parameters), day_of(kernels, sun, parameters)
    found = three(kernels, day.state, size), two(kernels, day.state, size)
    zeros = crossings(kernels, parameters, declination(parameters, SPRING), day.clock, size)
    yield Heading("Fig. 6: forces on the equinox")
    yield Prose(
        "$F > 0$ pushes a leg longer, $F < 0$ pulls it shorter; largest and mean forces are of "
        f"the sizes. The platform's mass centre is {centre_words(parameters)}"
        + (": its weight asks nothing of the drives." if balanced(parameters) else ".")
    )
    yield drawing("a", day, found[0])
    yield drawing("b", day, found[1], zeros)
    lever = np.abs(kernels.jacobian(**day.pose, **size).J[[0, -1], 2]).max()
    facts = {**figures(day, *found, zeros), "lever": float(lever)}
    yield table(facts, parameters.published)
    yield Prose(words(facts, parameters.published))
    yield Prose(at_the_ends(facts))
    yield Result("forces", facts)


def balanced(parameters):
    """Whether the platform's weight turns it about neither axis."""
    return not any(parameters.bodies.r_sc[1:])


def drawing(letter, day, F, zeros=()):
    """The forces of a mechanism; those about a crossing are left out where they are too large."""
    limit = CLIPPED if zeros else None
    name = DRIVES[3 - F.shape[1]]
    seen = (
        f"; they grow without bound at the marks and are left out beyond {CLIPPED:g} N"
        if zeros
        else ""
    )
    return Plot(
        f"Fig. 6 ({letter}): forces of the {name} on the equinox, positive where a leg "
        f"pushes{seen}.",
        "solar time, h", Axis("force, N", low=limit and -limit, high=limit),
        [Curve(leg, day.clock, np.where(np.abs(force) <= (limit or np.inf), force, np.nan))
         for leg, force in zip(LEGS, F.T, strict=False)],
        [Mark(t, "" if k else "singular", across=True) for k, t in enumerate(zeros)],
    )  # fmt: skip


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
        "dusk": [F[-1].tolist(), F_2[-1].tolist()],
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
    return (
        f"The three drives push or pull with at most {max(facts['peak']):.1f} N; the paper has "
        f"{published.peak_force:g} N. {shared(facts, published)} {without(facts)}"
    )


def shared(facts, published):
    """Which leg carries how much, here and in the paper."""
    ours, theirs = facts["mean"], published.mean_forces
    alike, alike_there = near(*ours[:2]), near(*theirs[:2])
    pair = (
        f"Legs 1 and 2 {'carry' if alike else 'do not carry'} as much as each other in the mean, "
        f"{'as' if alike == alike_there else 'unlike'} in the paper"
    )
    here, there = third(ours), third(theirs)
    return f"{pair}; leg 3 carries {here} here and {'too' if here == there else there} there."


def third(means):
    """How much leg 3 carries beside the others."""
    if means[2] > (1 + WITHIN) * max(means[:2]):
        return "the most"
    return "the least" if means[2] < (1 - WITHIN) * min(means[:2]) else "as much as another"


def without(facts):
    """What two drives can."""
    if not facts["zeros"]:
        return f"Two drives hold the platform all day, with at most {facts['peak_two']:.1f} N."
    times = " and at ".join(clock_words(t) for t in facts["zeros"])
    return (
        f"**Two drives have no largest force: at {times} they do not hold the platform**, and "
        "the forces grow without bound on the way there. The paper's curve can only show what "
        "its samples happened to meet."
    )


def agree(facts):
    """Whether both mechanisms need the same forces at sunrise and sunset, leg 3 none."""
    off = 0.0
    for end in ("dawn", "dusk"):
        (*pair, other), both = facts[end]
        off = max(off, abs(other), *(abs(a - b) for a, b in zip(pair, both, strict=True)))
    return off < SAME


def at_the_ends(facts):
    """Whether both mechanisms agree at sunrise and sunset, and why."""
    (*pair, other), both = facts["dawn"]
    words = (
        f"At sunrise of the equinox legs 1 and 2 give {in_words(pair)} and leg 3 "
        f"{in_words([other])} with three drives; with two, legs 1 and 2 give {in_words(both)}."
    )
    if not agree(facts):
        return f"{words} **There the two mechanisms do not agree.**"
    if facts["lever"] > SAME:
        return f"{words} **There, and at sunset, the two mechanisms agree.**"
    return (
        f"{words} **There, and at sunset, the two mechanisms agree**: neither angle changes the "
        "length of leg 3, so that it carries nothing, whatever the masses are. That much of the "
        "paper's equal peaks at dawn and dusk follows from the dimensions alone."
    )


def in_words(forces):
    """Forces with their signs, N."""
    rounded = (round(force, 2) + 0.0 for force in forces)  # no minus sign before a zero
    return " and ".join(text_of(force, ".2f") for force in rounded) + " N"
