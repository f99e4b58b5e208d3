"""Mechanical, copper and total power through the equinox (Figs. 7 to 9), and the energies."""

import numpy as np

from armillary.verify.plots import Axis, Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .study_basis import (
    CALM,
    SPRING,
    around_noon,
    centre_words,
    crossings,
    day_of,
    declination,
    held,
    mount,
    near,
    over_time,
    three,
    two,
)

MILLI = 1e3
KILO = 1e-3
DRIVES = ("three drives", "two drives")
ABOVE = 1e3  # how far beyond three drives the heat of two is shown
BELOW = 1e-6  # of the upper end, the least that is shown
HALF = 0.5  # of the day
NOTHING = 0.01  # share of the heat that does not count


def power(kernels, sun, parameters):
    """Figs. 7 to 9."""
    size, day = mount(parameters), day_of(kernels, sun, parameters)
    state = {**day.state, **CALM, **size}
    mechanical = [held(kernels.power(**state), "P"), held(kernels.power_two_legs(**state), "P")]
    F = [three(kernels, day.state, size), two(kernels, day.state, size)]
    motor = motor_of(parameters)
    copper = [heat(kernels, size, motor, of) for of in F]
    zeros = crossings(kernels, parameters, declination(parameters, SPRING), day.clock, size)
    total = [a.sum(axis=1) + b for a, b in zip(mechanical, copper, strict=True)]
    yield Heading("Figs. 7 to 9: power on the equinox")
    yield Prose(
        f"The platform's mass centre is {centre_words(parameters)}. Mechanical power is "
        "$F \\dot q$ of a drive, positive where it does work, negative where the load drives it. "
        "Around noon means within an hour of it."
    )
    yield from mechanical_part(day, mechanical)
    yield Prose(assumed(parameters, motor))
    yield drawn("Fig. 8: copper power", day, copper, zeros)
    yield drawn("Fig. 9: total power", day, total, zeros)
    yield since_sunrise(day, total, zeros)
    facts = {
        "mechanical": [figures(day, P) for P in mechanical],
        # Of two drives that are singular on the way these have no value.
        "copper": bounded([around(day, P) for P in copper], zeros, ("least", "most")),
        "total": bounded([around(day, P) for P in total], zeros, ("least", "most")),
        "copper_energy": without_bound([over_time(P, day.clock) for P in copper], zeros),
        "energy": without_bound([over_time(P, day.clock) for P in total], zeros),
        "constant": constant(parameters),
    }
    yield energies(facts, parameters.published)
    yield Prose(words(facts, parameters.published))
    yield Result("power", facts)


def without_bound(values, zeros):
    """A value of each mechanism; none of two drives that are singular on the way."""
    return [values[0], None if zeros else values[1]]


def bounded(values, zeros, names):
    """The same of values by name."""
    one, other = values
    return [one, {**other, **dict.fromkeys(names)} if zeros else other]


def constant(parameters):
    """Copper power by the square of the force, W/N^2, if a drive has the peaks of the paper."""
    published = parameters.published
    return published.peak_copper / published.peak_force**2


def motor_of(parameters):
    """A motor with that constant, as the kernel takes it."""
    drive = parameters.drive
    K_M = drive.lead / (2 * np.pi) * np.sqrt(drive.R_w / constant(parameters))
    return {"K_M": K_M, "R_w": drive.R_w, "lead": drive.lead}


def heat(kernels, size, motor, F):
    """Copper power of all drives, W; the kernel has a place for three forces."""
    room = np.concatenate([np.nan_to_num(F), np.zeros((len(F), 3 - F.shape[1]))], axis=1)
    found = kernels.copper_power(F_leg=room, **motor, **size).P.sum(axis=1)
    return np.where(np.isnan(F[:, 0]), np.nan, found)


def mechanical_part(day, mechanical):
    """Fig. 7."""
    sums = [MILLI * P.sum(axis=1) for P in mechanical]
    yield Plot(
        "Fig. 7: mechanical power of all drives together on the equinox, positive where they do "
        "work.",
        "solar time, h", "power, mW",
        [Curve(name, day.clock, P) for name, P in zip(DRIVES, sums, strict=True)],
    )  # fmt: skip
    limit = 4 * np.nanmax(np.abs(sums))
    both = MILLI * mechanical[1]
    opposed = np.nanmean(both[:, 0] * both[:, 1] < 0)
    yield Plot(
        "Fig. 7, the drives of the mechanism with two apart"
        + (": one brakes what the other drives." if opposed > HALF else "."),
        "solar time, h", Axis("power, mW", low=-limit, high=limit),
        [Curve(f"leg {i + 1}", day.clock, np.where(np.abs(both[:, i]) < limit, both[:, i], np.nan))
         for i in range(2)],
    )  # fmt: skip


def figures(day, P):
    """Peak, mean size, what is put in and what comes out over the day."""
    total = P.sum(axis=1)
    return {
        "peak": float(np.nanmax(np.abs(total))),
        "mean": over_time(np.abs(total), day.clock) / (3600 * (day.clock[-1] - day.clock[0])),
        "in": over_time(np.maximum(total, 0), day.clock),
        "net": over_time(total, day.clock),
    }


def around(day, P):
    """Power at sunrise and sunset, and the least and the most around noon."""
    middle = P[around_noon(day.clock)]
    top = int(np.nanargmax(middle))
    return {
        "dawn": float(P[0]), "dusk": float(P[-1]), "peak": float(np.nanmax(P)),
        "least": float(np.nanmin(middle)), "most": float(np.nanmax(middle)),
        "inside": 0 < top < len(middle) - 1,
    }  # fmt: skip


def assumed(parameters, motor):
    """Where the motor is from."""
    published = parameters.published
    return (
        "The copper power needs $K_M$, $R$ and $d$, which the paper does not give; only "
        "$R (d / 2 \\pi K_M)^2$ enters. If the drive with the paper's largest force makes the "
        f"paper's largest heat, it is {published.peak_copper:g} W over the square of "
        f"{published.peak_force:g} N, {1e4 * constant(parameters):.2f}·10⁻⁴ W/N². With a pitch of "
        f"{1e3 * motor['lead']:g} mm and {motor['R_w']:g} ohm that is a torque constant of "
        f"{motor['K_M']:.3f} N m/A. The figures below are drawn with it."
    )


def drawn(what, day, powers, zeros):
    """A plot of both mechanisms."""
    low, high = decades(powers[0])
    seen = "; two drives have none at the gaps, where theirs grows without bound" if zeros else ""
    return Plot(
        f"{what} of all drives together on the equinox, from {low:g} to {high:g} W{seen}.",
        "solar time, h", Axis("power, W", log=True, low=low, high=high),
        [Curve(name, day.clock, within(P, low, high))
         for name, P in zip(DRIVES, powers, strict=True)],
    )  # fmt: skip


def decades(power):
    """Whole powers of ten that hold a power where it is positive, with room above it."""
    most = 10.0 ** np.ceil(np.log10(np.nanmax(power))) * ABOVE
    least = 10.0 ** np.floor(np.log10(np.nanmin(power[power > 0])))
    return max(least, BELOW * most), most


def within(values, low, high):
    """Values where they can be drawn."""
    return np.where((values >= low) & (values <= high), values, np.nan)


def since_sunrise(day, powers, zeros):
    """Energy used up to each time."""
    curves = []
    for name, P in zip(DRIVES, powers, strict=True):
        mid = np.nan_to_num((P[1:] + P[:-1]) / 2) * np.diff(3600 * day.clock)
        curves.append(Curve(name, day.clock[1:], KILO * np.cumsum(mid)))
    seen = (
        "; at a crossing that of two drives jumps by as much as the samples happen to give"
        if zeros
        else ""
    )
    return Plot(
        f"Energy since sunrise of the equinox{seen}.",
        "solar time, h", Axis("energy, kJ", log=True), curves,
    )  # fmt: skip


def energies(facts, published):
    """The day's energies."""
    rows = [
        (name, MILLI * of["peak"], MILLI * of["mean"], of["in"],
         *(None if energy is None else KILO * energy for energy in both), theirs)
        for name, of, both, theirs in zip(
            DRIVES, facts["mechanical"],
            zip(facts["copper_energy"], facts["energy"], strict=True),
            published.energy, strict=True,
        )
    ]  # fmt: skip
    none = facts["energy"][1] is None
    return Table(
        "Power and energy of all drives together on the equinox"
        + ("; no value where they grow without bound as the step shrinks." if none else "."),
        [
            "mechanism", Column("mechanical: peak", "mW", ".3f"), Column("mean size", "mW", ".3f"),
            Column("put in", "J", ".2f"), Column("copper", "kJ", ".4g"),
            Column("total", "kJ", ".4g"), Column("total in the paper", "kJ", ".1f"),
        ],
        rows,
    )  # fmt: skip


def words(facts, published):
    """What the powers come to."""
    one, other = facts["mechanical"]
    higher = one["mean"] > other["mean"]
    balance = (
        "the third leg is one more weight to carry"
        if higher
        else "the third leg is a counterweight, it rises where the others sink"
    )
    left = max(abs(one["net"]), abs(other["net"]))
    back = "comes back by sunset" if left < 1e-6 else f"comes back but for {left:.2g} J"
    heat = facts["copper_energy"][0]
    small = one["in"] < NOTHING * heat
    return (
        "At the sun's pace the drives' mechanical work is the change of height of what they carry. "
        f"Its mean size is {'higher' if higher else 'lower'} with three drives: {balance}. What is "
        f"put in, {one['in']:.2f} and {other['in']:.2f} J, {back}, beside {KILO * heat:.1f} kJ of "
        "heat with three drives"
        + (". **The energy is the copper's alone.** " if small else ": both count. ")
        + of_the_heat(facts["copper"], published)
    )


def of_the_heat(copper, published):
    """Where in the day the heat is largest."""
    dawn = [of["dawn"] for of in copper]
    same = "the same" if near(*dawn) else "not the same"
    early = copper[0]["dawn"] >= copper[0]["most"]
    there = published.peak_copper >= max(published.noon_copper)
    return (
        f"At sunrise the heat is {dawn[0]:.2g} W with three drives and {dawn[1]:.2g} W with two, "
        f"{same}; around noon three drives have {copper[0]['least']:.2g} to "
        f"{copper[0]['most']:.2g} W. The larger is that {'at sunrise' if early else 'around noon'} "
        f"here and {'at sunrise' if there else 'around noon'} in the paper."
    )
