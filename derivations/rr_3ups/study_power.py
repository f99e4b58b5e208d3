"""Mechanical, copper and total power through the equinox (Figs. 7 to 9), and the energies."""

import numpy as np

from armillary.verify.plots import Axis, Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .study_basis import CALM, NOON, day_of, held, mount, over_time, three, two

MILLI = 1e3
KILO = 1e-3
DRIVES = ("three drives", "two drives")
SHOWN = (0.01, 1000.0)  # W


def power(kernels, sun, parameters):
    """Figs. 7 to 9."""
    size, day = mount(parameters), day_of(kernels, sun, parameters)
    state = {**day.state, **CALM, **size}
    mechanical = [held(kernels.power(**state), "P"), held(kernels.power_two_legs(**state), "P")]
    F = [three(kernels, day.state, size), two(kernels, day.state, size)]
    motor = motor_of(parameters)
    copper = [heat(kernels, size, motor, of) for of in F]
    yield Heading("Figs. 7 to 9: power on the equinox")
    yield from mechanical_part(day, mechanical)
    yield Prose(assumed(parameters, motor))
    yield drawn("Fig. 8: copper power of all drives together on the equinox.", day, copper)
    total = [a.sum(axis=1) + b for a, b in zip(mechanical, copper, strict=True)]
    yield drawn("Fig. 9: total power of all drives together on the equinox.", day, total)
    yield since_sunrise(day, total)
    facts = {
        "mechanical": [figures(day, P) for P in mechanical],
        "copper": [around(day, P) for P in copper],
        "copper_energy": [over_time(P, day.clock) for P in copper],
        "energy": [over_time(P, day.clock) for P in total],
        "constant": constant(parameters),
    }
    yield energies(facts, parameters.published)
    yield Prose(words(facts))
    yield Result("power", facts)


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
        "Fig. 7: mechanical power of all drives together on the equinox.",
        "solar time, h", "power, mW",
        [Curve(name, day.clock, P) for name, P in zip(DRIVES, sums, strict=True)],
    )  # fmt: skip
    limit = 4 * np.nanmax(np.abs(sums))
    both = MILLI * mechanical[1]
    yield Plot(
        "Fig. 7, the two drives apart: one brakes what the other drives.",
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
    """Copper power at sunrise, its largest, and at noon."""
    noon = int(np.argmin(np.abs(day.clock - NOON)))
    return {"dawn": float(P[0]), "noon": float(P[noon]), "peak": float(np.nanmax(P))}


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


def drawn(caption, day, powers):
    """A plot of both mechanisms."""
    low, high = SHOWN
    return Plot(
        caption, "solar time, h", Axis("power, W", log=True, low=low, high=high),
        [Curve(name, day.clock, within(P, low, high))
         for name, P in zip(DRIVES, powers, strict=True)],
    )  # fmt: skip


def within(values, low, high):
    """Values where they can be drawn."""
    return np.where((values >= low) & (values <= high), values, np.nan)


def since_sunrise(day, powers):
    """Energy used up to each time."""
    curves = []
    for name, P in zip(DRIVES, powers, strict=True):
        mid = np.nan_to_num((P[1:] + P[:-1]) / 2) * np.diff(3600 * day.clock)
        curves.append(Curve(name, day.clock[1:], KILO * np.cumsum(mid)))
    return Plot(
        "Energy since sunrise of the equinox; at a crossing that of two drives jumps by as much as "
        "the samples happen to give.",
        "solar time, h", Axis("energy, kJ", log=True), curves,
    )  # fmt: skip


def energies(facts, published):
    """The day's energies."""
    rows = [
        (name, MILLI * of["peak"], MILLI * of["mean"], of["in"], KILO * copper, KILO * all_, theirs)
        for name, of, copper, all_, theirs in zip(
            DRIVES, facts["mechanical"], facts["copper_energy"], facts["energy"],
            published.energy, strict=True,
        )
    ]  # fmt: skip
    return Table(
        "Power and energy of all drives together on the equinox. Copper and total of two drives "
        "are what the samples give; they grow without bound as the step shrinks.",
        [
            "mechanism", Column("mechanical: peak", "mW", ".3f"), Column("mean size", "mW", ".3f"),
            Column("put in", "J", ".2f"), Column("copper", "kJ", ".4g"),
            Column("total", "kJ", ".4g"), Column("total in the paper", "kJ", ".1f"),
        ],
        rows,
    )  # fmt: skip


def words(facts):
    """What the powers come to."""
    one, other = facts["mechanical"]
    at_noon, dawn = facts["copper"][0]["noon"], [of["dawn"] for of in facts["copper"]]
    higher = one["mean"] > other["mean"]
    balance = (
        "the third leg is one more weight to carry"
        if higher
        else "the third leg is a counterweight, it rises where the others sink"
    )
    left = max(abs(one["net"]), abs(other["net"]))
    back = "comes back in the afternoon" if left < 1e-6 else f"comes back but for {left:.2g} J"
    return (
        "At the sun's pace the drives' mechanical work is the change of height of what they carry. "
        f"Its mean size is {'higher' if higher else 'lower'} with three drives: {balance}. What is "
        f"put in, {one['in']:.2f} and {other['in']:.2f} J, {back}, and is nothing beside "
        f"{KILO * facts['copper_energy'][0]:.1f} kJ of heat. **The energy is the copper's alone.** "
        f"At sunrise and sunset the heat is {dawn[0]:.2g} W with three drives and {dawn[1]:.2g} W "
        "with two, the same as the forces are; the paper has its largest there, and ours is "
        f"larger at noon, {at_noon:.2g} W with three drives."
    )
