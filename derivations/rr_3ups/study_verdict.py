"""Each figure and claim of the paper beside ours, with a verdict."""

from armillary.verify.study import Heading, Prose, Result, Table, text_of

from .study_basis import WITHIN, centre_words, clock_words, near
from .study_claims import MOTION, NO, OPEN, ORDER, SIZE, YES, exceptions, left_open, motor, place
from .study_claims_forces import of_the_forces
from .study_claims_motion import of_the_lengths, of_the_paths
from .study_claims_power import of_the_energy, of_the_heat, of_the_power

NEEDS = ("paths", "lengths", "forces", "power", "motor", "unknowns", "pace")
SMALL = 1e-3  # of the weight; less decides nothing


def verdict(kernels, parameters, results):
    """The paper's claims, what holds, and the table."""
    published = parameters.published
    claims = claims_of(results, published)
    yield Heading("What the paper reports, and what comes out")
    yield Prose(claimed(published))
    yield Prose(tally(claims))
    yield Prose(summary(claims, results))
    yield Prose(
        f"**Assumed**: the platform's mass centre {centre_words(parameters)}, and a motor with "
        f"{motor(results['power']['constant'])}; the paper gives neither. $q_i$ grows where leg i "
        "gets longer, $F_i > 0$ pushes it longer. A figure counts as reproduced within "
        f"{100 * WITHIN:.0f}%, as not determined where it comes out only with another mass centre "
        "or motor, and with those beside it. Dawn is sunrise; around noon is within an hour of it."
    )
    yield Table(
        "Every published figure and claim, beside what comes out here.",
        ["claim", "the paper", "here", "verdict", "why"],
        [claim.row for claim in claims],
    )
    yield Result("verdicts", {key: claim.verdict for claim in claims for key in claim.keys})


def claims_of(results, published):
    """Every claim, judged."""
    open_, forces, power = left_open(results), results["forces"], results["power"]
    return [
        *of_the_paths(results["paths"]),
        *of_the_lengths(results["lengths"]),
        *of_the_forces(forces, results["unknowns"], open_, published),
        *of_the_power(power, open_),
        *of_the_heat(power, open_, published),
        *of_the_energy(power, forces["zeros"], open_, published),
    ]


def claimed(published):
    """What the paper wants to show."""
    three, two = (
        "{} N".format(", ".join(f"{mean:g}" for mean in means))
        for means in (published.mean_forces, published.mean_forces_two)
    )
    return (
        "The paper compares its tracker on three driven legs, one more than its two freedoms need, "
        "with the same tracker without leg 3, through the day of an equinox. It reports the same "
        f"largest force for both, {published.peak_force:g} N, lower mean forces with three legs "
        f"({three} against {two}), a little more mechanical work, and less energy in all, "
        f"{published.energy[0]:g} against {published.energy[1]:g} kJ."
    )


def summary(claims, results):
    """Why the rest does not come out."""
    return " ".join(
        part
        for part in (
            gaps(claims),
            without_leg_3(results["forces"]["zeros"], results["unknowns"]["conditions"]),
            chosen(results["unknowns"]),
            slow(results["pace"]),
        )
        if part
    )


def tally(claims):
    """How many are reproduced, and how many of each kind."""
    verdicts = [claim.verdict for claim in claims]
    one, other, third = (
        f"{of.count(YES)} of {len(of)}"
        for of in ([c.verdict for c in claims if c.kind == k] for k in (MOTION, ORDER, SIZE))
    )
    return (
        f"**Of {len(claims)} claims and figures {number(verdicts.count(YES))} reproduced, "
        f"{number(verdicts.count(NO))} not, and {number(verdicts.count(OPEN))} not determined.** "
        f"Reproduced are {one} about the sun and the lengths, {other} comparisons of forces, power "
        f"and energy between the mechanisms or through the day, and {third} sizes of these."
    )


def number(count):
    """A count as it stands in a sentence."""
    return {0: "none is", 1: "1 is"}.get(count, f"{count} are")


def gaps(claims):
    """What the paper leaves open."""
    if not any(claim.verdict == OPEN for claim in claims):
        return ""
    return (
        "What is not determined hangs on the platform's mass centre or on the motor, which are not "
        "given."
    )


def without_leg_3(zeros, conditions):
    """Whether the comparison has a second side."""
    if not zeros:
        return "Without leg 3 the mechanism holds the platform all through the equinox."
    times = " and ".join(map(clock_words, zeros))
    except_ = f"but for {exceptions(conditions)} " if exceptions(conditions) else ""
    return (
        f"Without leg 3 the mechanism is singular on its way, at {times}: {except_}neither its "
        "forces nor its heat nor its energy has a value that could be compared."
    )


def chosen(unknowns):
    """What the mass centre on that line with the paper's peak gives."""
    if unknowns["conditions"] != 1:
        return ""
    centre, (one, other) = unknowns["centres"][0], unknowns["centres"][0]["drives"]
    if "squares" not in other:
        return ""
    (peak, mean), (peak_2, mean_2) = one["mechanical"], other["mechanical"]
    holds = {
        "the same peak of mechanical power": near(peak, peak_2),
        "a higher mean of it with three drives": mean > mean_2,
        "a lower total with three drives": one["squares"] < other["squares"],
    }
    kept = [words for words, true in holds.items() if true]
    lost = [words for words, true in holds.items() if not true]
    gives = f"gives {', '.join(kept)}" if kept else ""
    fails = f"does not give {', '.join(lost)}" if lost else ""
    return (
        f"One mass centre on that line, {place(centre).removeprefix('with ')}, gives both the "
        f"paper's peak at dawn and dusk; it also {'; it '.join(filter(None, (gives, fails)))}."
    )


def slow(pace):
    """What the paper's dynamics is worth on a solar day."""
    if not pace["weight"]:
        return ""
    part = pace["inertia"] / pace["weight"]
    text = text_of(part, ".0e")
    if part > SMALL:
        return f"Inertia asks for {text} of the weight on this day, so that it counts."
    return (
        "What is wrong in the paper's rates cannot be the cause: inertia asks for "
        f"{text} of the weight on this day."
    )
