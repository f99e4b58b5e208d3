"""Each figure and claim of the paper beside ours, with a verdict."""

from armillary.verify.study import Heading, Prose, Table, text_of

from .study_basis import SUMMER, clock_words
from .study_paths import ordered

WITHIN = 0.05
MM = 1e3
KILO = 1e-3
YES, NO, OPEN = "reproduced", "not reproduced", "not determined"
NEEDS = ("paths", "lengths", "forces", "power", "motor", "unknowns", "pace")


def verdict(kernels, parameters, results):
    """The table."""
    published, elsewhere = parameters.published, results["unknowns"]
    rows = [
        *of_the_paths(results["paths"]),
        *of_the_lengths(results["lengths"]),
        *of_the_forces(results["forces"], elsewhere, published),
        *of_the_power(results["power"], elsewhere),
        *of_the_heat(results["power"], results["motor"], results["forces"], elsewhere, published),
        *of_the_energy(results["power"], bool(results["forces"]["zeros"]), published),
    ]
    counts = {word: sum(row[3] == word for row in rows) for word in (YES, NO, OPEN)}
    yield Heading("What the paper reports, and what comes out")
    yield Prose(
        "A figure counts as reproduced within "
        f"{100 * WITHIN:.0f}%. Of {len(rows)} claims and figures, {counts[YES]} are reproduced, "
        f"{counts[NO]} are not, and {counts[OPEN]} hang on what the paper does not give."
    )
    yield Table(
        "Every published figure and claim on the mechanism's day.",
        ["claim", "the paper", "here", "verdict", "why"],
        rows,
    )
    yield Prose(summary(results))


def judged(holds):
    """A verdict."""
    return YES if holds else NO


def hanging(holds, elsewhere):
    """A verdict on what hangs on the mass centre."""
    return YES if holds else OPEN if elsewhere else NO


def place(elsewhere):
    """The mass centre without poles in words; empty where there is none."""
    if not elsewhere.get("place"):
        return ""
    return "with y = {} mm, z = {} mm:".format(
        *(text_of(MM * at, ".0f") for at in elsewhere["place"])
    )


def near(ours, theirs):
    """Whether a figure is reproduced."""
    return abs(ours - theirs) <= WITHIN * abs(theirs)


def of_the_paths(facts):
    """Fig. 4."""
    noon, length = facts["noon"], facts["length"]
    beta = ", ".join(f"{b:.2f}" for k, b in enumerate(noon) if k != 2)
    yield (
        "Fig. 4: curves from bottom to top", "summer, equinox, winter",
        f"tilt at noon {beta} degrees", judged(ordered(facts)), "geometry of the sun",
    )  # fmt: skip
    yield (
        "the equinoxes have one path", "yes", "yes", judged(facts["apart"] < 1e-9),
        "with the sun over the equator on both; the calendar's days differ by tenths of a degree",
    )  # fmt: skip
    yield (
        "the summer's sun is highest, its day longest", "yes",
        f"{90 - noon[SUMMER]:.2f} degrees, {length[SUMMER]:.2f} h",
        judged(noon[SUMMER] == min(noon) and length[SUMMER] == max(length)),
        "geometry of the sun",
    )  # fmt: skip


def of_the_lengths(facts):
    """Fig. 5."""
    strokes = facts["strokes"]
    yield (
        "Fig. 5: $q_3$ varies little, $q_1$ and $q_2$ much", "yes",
        " and ".join(f"{MM * s:.0f}" for s in (strokes[2], strokes[0])) + " mm",
        judged(strokes[2] < min(strokes[:2])), "dimensions of Table 1",
    )  # fmt: skip
    yield (
        "$q_1$ and $q_2$ symmetric", "yes", "mirrored about noon",
        judged(facts["mirrored"] < 1e-9), "not equal at one time: each other's mirror image",
    )  # fmt: skip


def of_the_forces(facts, elsewhere, published):
    """Fig. 6."""
    peak, means = max(facts["peak"]), facts["mean"]
    (*pair, third), both = facts["dawn"]
    yield (
        "Fig. 6: largest force, three drives", f"{published.peak_force:g} N", f"{peak:.1f} N",
        hanging(near(peak, published.peak_force),
                near(elsewhere.get("largest", peak), published.peak_force)),
        "the mass centre is not given; at o the platform weighs nothing on the drives",
    )  # fmt: skip
    yield two_drives(facts, published)
    equal = max(abs(a - b) for a, b in zip(pair, both, strict=True)) + abs(third) < 1e-6
    yield (
        "the same at dawn and dusk for both", "yes", f"{max(map(abs, both)):.2f} N for both",
        judged(equal), "leg 3 has no lever there, whatever the masses",
    )  # fmt: skip
    fits = all(near(a, b) for a, b in zip(means, published.mean_forces, strict=True))
    yield (
        "mean forces, three drives", ", ".join(f"{m:g}" for m in published.mean_forces) + " N",
        ", ".join(f"{m:.1f}" for m in means) + " N", judged(fits),
        f"no mass centre gives peak and means, the best misses by {elsewhere['residual']:.0f} N",
    )  # fmt: skip
    means = facts["mean_two"]
    yield (
        "mean forces, two drives", ", ".join(f"{m:g}" for m in published.mean_forces_two) + " N",
        "no bound" if means is None else ", ".join(f"{m:.1f}" for m in means) + " N",
        judged(means is not None and near(means[0], published.mean_forces_two[0])),
        "the mean grows with the logarithm of the finest step" if means is None else "",
    )  # fmt: skip
    lower = means is None or sum(facts["mean"]) / 3 < sum(means) / 2
    yield (
        "mean force lower with three drives", "yes", "yes" if lower else "no", judged(lower),
        "but by how much has no number" if means is None else "",
    )  # fmt: skip


def two_drives(facts, published):
    """The largest force without leg 3."""
    times, peak = " and ".join(clock_words(t) for t in facts["zeros"]), facts["peak_two"]
    return (
        "largest force, two drives", f"{published.peak_force:g} N",
        "no bound" if peak is None else f"{peak:.1f} N",
        judged(peak is not None and near(peak, published.peak_force)),
        f"two drives do not hold the platform at {times}; on one line of mass centres there is a "
        "bound" if times else "",
    )  # fmt: skip


def of_the_power(facts, elsewhere):
    """Fig. 7."""
    one, other = facts["mechanical"]
    (peak, size), (peak_2, size_2) = elsewhere.get("mechanical", ((None, None),) * 2)
    beside = place(elsewhere)
    yield (
        "Fig. 7: the same peak of mechanical power", "yes",
        f"{MM * one['peak']:.2f} and {MM * other['peak']:.2f} mW",
        hanging(near(one["peak"], other["peak"]), peak and near(peak, peak_2)),
        beside and f"{beside} {MM * peak:.2f} and {MM * peak_2:.2f} mW",
    )  # fmt: skip
    yield (
        "mechanical energy higher with three drives", "yes",
        f"{MM * one['mean']:.2f} and {MM * other['mean']:.2f} mW in the mean",
        hanging(one["mean"] > other["mean"], size and size > size_2),
        beside and f"{beside} {MM * size:.2f} and {MM * size_2:.2f} mW; all of it comes back",
    )  # fmt: skip


def of_the_heat(facts, motor, forces, elsewhere, published):
    """Fig. 8."""
    free = "no bound" if forces["zeros"] else f"{facts['copper'][1]['noon']:.2g} W"
    dawn = [of["dawn"] for of in facts["copper"]]
    yield (
        "Fig. 8: copper power at dawn and dusk", f"{published.peak_copper:g} W for both",
        f"{dawn[0]:.2g} and {dawn[1]:.2g} W", OPEN,
        "$K_M$, $R$, $d$ and the mass centre not given; that both are equal is reproduced",
    )  # fmt: skip
    of, beside, noon = facts["copper"][0], place(elsewhere), elsewhere.get("noon")
    yield (
        "it is larger there than around noon, three drives", "yes",
        f"{of['dawn']:.2g} W there, {of['noon']:.2g} W at noon",
        hanging(of["dawn"] > of["noon"], noon and noon < 1),
        beside and f"no motor changes the ratio; {beside} noon has {noon:.2f} of sunrise",
    )  # fmt: skip
    low, high = (1e4 * motor[key] for key in ("low", "high"))
    yield (
        "around noon, three against two drives",
        "{:g} against {:g} W".format(*published.noon_copper),
        f"{of['noon']:.2g} W against {free}", OPEN,
        f"fits the paper's other figures for $k$ from {low:.1f} to {high:.1f}·10⁻⁴ W/N²",
    )  # fmt: skip


def of_the_energy(facts, singular, published):
    """Fig. 9 and the energies."""
    energy = facts["energy"]
    yield (
        "energy of the day, three drives", f"{published.energy[0]:g} kJ",
        f"{KILO * energy[0]:.1f} kJ", OPEN,
        "motor and mass centre not given; ours with $k$ of the paper's peaks",
    )  # fmt: skip
    yield (
        "energy of the day, two drives", f"{published.energy[1]:g} kJ",
        "no bound" if singular else f"{KILO * energy[1]:.1f} kJ", NO if singular else OPEN,
        "the heat grows with one over the step" if singular else "motor and mass centre not given",
    )  # fmt: skip
    yield (
        "Fig. 9: smooth with three drives, peaks around noon with two", "yes",
        "yes" if singular else "no peaks", judged(singular), "the peaks are singular attitudes",
    )  # fmt: skip
    yield (
        "total lower with three drives", "yes", "yes" if energy[0] < energy[1] else "no",
        judged(energy[0] < energy[1]),
        "but how much is saved has no number" if singular else "",
    )  # fmt: skip


def summary(results):
    """What remains."""
    elsewhere, pace = results["unknowns"], results["pace"]
    part = text_of(pace["inertia"] / pace["weight"], ".0e")
    words = (
        "**What follows from dimensions and sun is reproduced; the sizes of forces, power and "
        "energy are not.** One cause is a gap in the paper: the platform's mass centre and the "
        "motor. The other is the mechanism: without leg 3 it is singular on its way, and but for "
        "one line of mass centres neither its forces nor its heat nor its energy has a value. "
    )
    if at := place(elsewhere):
        words += (
            f"A mass centre on that line, {at.removeprefix('with ').removesuffix(':')}, gives both "
            "mechanisms the paper's peak at dawn and dusk, and with it come the paper's claims "
            "about mechanical power and the order of the totals; the paper's means do not. "
        )
    return words + (
        f"What is wrong in the paper's rates cannot be the cause: inertia asks for {part} of the "
        "weight on this day."
    )
