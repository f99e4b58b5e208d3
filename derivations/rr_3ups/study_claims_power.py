"""What the paper says of power and energy (Figs. 7 to 9), judged."""

from .study_basis import AROUND, NOON, near
from .study_claims import (
    NO,
    OPEN,
    ORDER,
    SIZE,
    YES,
    Claim,
    hanging,
    judged,
    motor,
    place,
    times,
    yes,
)

MILLI = 1e3
KILO = 1e-3
NO_BOUND = "no bound"
WITHIN = 1.05  # of a bound, as elsewhere


def of_the_power(facts, open_):
    """Fig. 7."""
    one, other = facts["mechanical"]
    for key, words, unit, test, pick in (
        ("Fig. 7", "Fig. 7: the same peak of mechanical power", "", near, 0),
        ("mechanical power", "mechanical energy higher with three drives", " in the mean",
         lambda a, b: a > b, 1),
    ):  # fmt: skip
        ours = [of["mean" if pick else "peak"] for of in (one, other)]
        centre = open_.where(
            lambda a, b, test=test, pick=pick: test(a["mechanical"][pick], b["mechanical"][pick])
        )
        verdict, why = hanging(
            test(*ours), centre,
            lambda of, pick=pick: milliwatts(*(d["mechanical"][pick] for d in of["drives"])),
        )  # fmt: skip
        yield Claim(
            (key,), ORDER, words, "yes", f"{milliwatts(*ours)}{unit}", verdict, why
        )  # fmt: skip


def milliwatts(one, other):
    """Two powers, three drives first."""
    return f"{MILLI * one:.2f} and {MILLI * other:.2f} mW"


def of_the_heat(facts, open_, published):
    """Fig. 8."""
    yield at_dawn(facts, open_, published)
    one, other = facts["copper"]
    ours, theirs = one["most"] / one["dawn"], published.noon_copper[0] / published.peak_copper
    for key, words, printed, bound in (
        ("4.5 W", "copper power larger at dawn than around noon, three drives", "yes", 1.0),
        ("1.4 W", "copper power around noon, three drives",
         f"below {published.noon_copper[0]:g} W, {theirs:.2f} times dawn's", theirs),
    ):  # fmt: skip
        centre = open_.where(
            lambda of, _, bound=bound: of["most"] <= WITHIN * bound * of["dawn"]
        )  # fmt: skip
        verdict, why = hanging(
            ours <= WITHIN * bound, centre,
            lambda of: f"{of['drives'][0]['most'] / of['drives'][0]['dawn']:.2f} times dawn's",
        )  # fmt: skip
        yield Claim(
            (key,), ORDER if bound == 1.0 else SIZE, words, printed,
            times(ours), verdict, f"no motor changes this ratio; {why}",
        )  # fmt: skip
    yield around_noon_with_two(other, open_, published)


def at_dawn(facts, open_, published):
    """The largest heat: a motor must give it for both mechanisms."""
    dawn, theirs = [of["dawn"] for of in facts["copper"]], published.peak_copper
    centre = open_.where(
        lambda one, other: near(one["dawn"], other["dawn"]) and open_.permits(theirs / one["dawn"])
    )
    if all(near(ours, theirs) for ours in dawn):
        verdict, why = YES, f"with the {motor(facts['constant'])} that is assumed"
    elif centre:
        k = theirs / centre["drives"][0]["dawn"]
        beside = f"{place(centre)} and {motor(k)}"
        verdict = OPEN
        why = f"$K_M$, $R$, $d$ and the mass centre are not given; both have it {beside}"
    else:
        verdict, why = NO, "with no motor that the paper's other figures permit"
    return Claim(
        ("Fig. 8",), SIZE, "Fig. 8: copper power at dawn and dusk", f"{theirs:g} W for both",
        f"{dawn[0]:.2g} and {dawn[1]:.2g} W", verdict, why,
    )  # fmt: skip


def around_noon_with_two(other, open_, published):
    """The heat of two drives around noon, by that at dawn."""
    theirs = published.noon_copper[1] / published.peak_copper
    ours = None if other["most"] is None else other["most"] / other["dawn"]
    centre = open_.where(lambda _, of: near(of["most"] / of["dawn"], theirs), two=True)
    verdict, why = hanging(
        ours is not None and near(ours, theirs), centre,
        lambda of: f"{of['drives'][1]['most'] / of['drives'][1]['dawn']:.2f} times dawn's",
        "the forces have no bound around noon, whatever the motor" if ours is None else "",
    )  # fmt: skip
    return Claim(
        ("3.8 W",), SIZE, "copper power around noon, two drives",
        f"{published.noon_copper[1]:g} W, {theirs:.2f} times dawn's",
        NO_BOUND if ours is None else times(ours), verdict, why,
    )  # fmt: skip


def of_the_energy(facts, zeros, open_, published):
    """Fig. 9 and the energies."""
    names = ("three drives", "two drives")
    for k, (key, name) in enumerate(zip(("62.1 kJ", "79.8 kJ"), names, strict=True)):
        yield energy(key, name, k, facts, open_, published)
    yield smooth(facts["total"], zeros, open_)
    ours, others = facts["energy"]
    if others is None:
        holds, words = True, f"{KILO * ours:.1f} kJ against no bound"
        verdict, why = judged(holds), "how much is saved has no number"
    else:
        holds, words = ours < others, f"{KILO * ours:.1f} against {KILO * others:.1f} kJ"
        verdict, why = hanging(
            holds, open_.where(lambda one, other: one["squares"] < other["squares"], two=True),
            lambda of: "two drives heat {:.2f} times as much".format(
                of["drives"][1]["squares"] / of["drives"][0]["squares"]
            ),
        )  # fmt: skip
    yield Claim(
        ("total lower",), ORDER, "total lower with three drives", "yes", f"{yes(holds)}, {words}",
        verdict, why,
    )  # fmt: skip


def energy(key, name, k, facts, open_, published):
    """The energy of the day of a mechanism: its heat, in effect."""
    ours, theirs = facts["energy"][k], published.energy[k] / KILO
    centre = open_.where(lambda *of: open_.permits(theirs / of[k]["squares"]), two=k == 1)
    if ours is not None and near(ours, theirs):
        verdict, why = YES, f"with the {motor(facts['constant'])} that is assumed"
    elif centre:
        constant = theirs / centre["drives"][k]["squares"]
        beside = f"{place(centre)} and {motor(constant)}"
        verdict, why = OPEN, f"motor and mass centre are not given; it comes out {beside}"
    elif ours is None:
        verdict, why = NO, "the heat grows with one over the step"
    else:
        verdict, why = NO, "with no motor that the paper's other figures permit"
    return Claim(
        (key,), SIZE, f"energy of the day, {name}", f"{published.energy[k]:g} kJ",
        NO_BOUND if ours is None else f"{KILO * ours:.1f} kJ", verdict, why,
    )  # fmt: skip


def smooth(total, zeros, open_):
    """Whether two drives have peaks of total power around noon that three do not have."""
    one, other = total
    ratio = one["most"] / one["least"]
    words = f"around noon the largest is {ratio:.1f} times the least with three drives, "
    if other["most"] is None:
        holds = any(abs(time - NOON) <= AROUND for time in zeros)
        verdict = judged(holds)
        why = "the peaks are singular attitudes" if holds else "two drives are singular elsewhere"
        words += NO_BOUND if holds else "no peak"
    else:
        ratio_2 = other["most"] / other["least"]
        centre = open_.where(
            lambda a, b: a["most"] / a["least"] < b["most"] / b["least"], two=True
        )  # fmt: skip
        words += f"{ratio_2:.1f} times"
        verdict, why = hanging(
            other["inside"] and ratio_2 > ratio, centre,
            lambda of: " and ".join(f"{a['most'] / a['least']:.1f}" for a in of["drives"])
            + " times",
        )  # fmt: skip
    return Claim(
        ("Fig. 9",), ORDER, "Fig. 9: around noon smooth with three drives, peaks with two", "yes",
        f"{words} with two", verdict, why,
    )  # fmt: skip
