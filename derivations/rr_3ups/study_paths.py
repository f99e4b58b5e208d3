"""The platform's angles on the four days (Fig. 4), and what the paper says of them."""

import numpy as np

from armillary.verify.plots import Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table, text_of

from .study_basis import (
    AUTUMN,
    NAMES,
    SPRING,
    SUMMER,
    WINTER,
    clock_words,
    day_of,
    state_at,
    sunrise_and_sunset,
)

TURN = 2 * np.pi
SAME = 1e-9  # rad: less is rounding


def paths(kernels, sun, parameters):
    """Fig. 4."""
    days = [day_of(kernels, sun, parameters, which) for which in range(len(NAMES))]
    angles = np.radians([calendar_day(sun, parameters, k) for k in (SPRING, AUTUMN)])
    facts = {**figures(days), "calendar": float(abs(np.diff(angles)[0]))}
    yield Heading("Fig. 4: the angles of the four days")
    yield Plot(
        "Fig. 4: tilt over turn of the platform through the four days"
        + ("; the equinoxes coincide." if facts["apart"] < SAME else "."),
        "α, degrees", "β, degrees",
        [Curve(day.name, *np.degrees([day.state["alpha"], day.state["beta"]])) for day in days],
    )  # fmt: skip
    yield table(days)
    yield Prose(words(facts))
    yield from calendar(kernels, sun, parameters)
    yield Result("paths", facts)


def table(days):
    """Length of the day and height of the sun."""
    rows = []
    for day in days:
        alpha, beta = np.degrees([day.state["alpha"], day.state["beta"]])
        length = day.clock[-1] - day.clock[0]
        ends = clock_words(day.clock[0]), clock_words(day.clock[-1])
        rows.append((day.name, *ends, length, 90 - beta.min(), alpha[0], beta.min(), beta[0]))
    return Table(
        "Sunrise, sunset and the platform's angles.",
        [
            "day", "sunrise", "sunset", Column("length", "h", ".2f"),
            Column("sun at noon", "degrees high", ".2f"),
            *(Column(name, "degrees", ".2f")
              for name in ("α at sunrise", "β at noon", "β at sunrise")),
        ],
        rows,
    )  # fmt: skip


def figures(days):
    """What decides the claims."""
    noon = [float(np.degrees(day.state["beta"].min())) for day in days]
    length = [float(day.clock[-1] - day.clock[0]) for day in days]
    spring, autumn = days[SPRING], days[AUTUMN]
    apart = max(
        float(np.abs(spring.state[key] - np.interp(spring.clock, autumn.clock, autumn.state[key]))
              .max())
        for key in ("alpha", "beta")
    )  # fmt: skip
    steep = np.abs(days[SUMMER].state["alpha"]) > np.pi / 2
    hours = float(np.diff(days[SUMMER].clock)[0]) * int(steep.sum())
    return {"noon": noon, "length": length, "apart": apart, "beyond": hours}


def ordered(facts):
    """Whether the curves lie as the paper says, from the summer's up to the winter's."""
    noon, length = facts["noon"], facts["length"]
    return (
        noon[SUMMER] < noon[SPRING] < noon[WINTER]
        and length[SUMMER] > length[SPRING] > length[WINTER]
    )


def words(facts):
    """The claims, one by one."""
    order = "lie" if ordered(facts) else "do not lie"
    same = facts["apart"] < SAME
    equinoxes = (
        "The curves of the equinoxes are one, as the paper says, because the sun's declination is "
        "taken as the same on both."
        if same
        else "The curves of the equinoxes are up to "
        f"{np.degrees(facts['apart']):.2f} degrees apart."
    )
    noon, length = facts["noon"], facts["length"]
    highest = NAMES[int(np.argmin(noon))]
    longest = NAMES[int(np.argmax(length))]
    beyond = (
        f"In summer the platform turns beyond 90 degrees, for {facts['beyond']:.1f} h of the day; "
        "the arctangent of (32) cannot and would jump by half a turn there."
        if facts["beyond"]
        else "The platform never turns beyond 90 degrees, where (32) would jump."
    )
    return (
        f"The curves {order} as in the paper, from the summer solstice's below to the winter "
        f"solstice's above; the sun stands highest on the {highest}, and the {longest} has the "
        f"longest day. {equinoxes} {beyond}"
    )


def calendar_day(sun, parameters, which):
    """Declination of a day by its number and (25), repaired; degrees."""
    day = float(parameters.days.number[which])
    return float(np.degrees(sun.cosine(day=day).declination))


def calendar(kernels, sun, parameters):
    """The days by their numbers."""
    rows = []
    for name, which, number in zip(NAMES, range(4), parameters.days.number, strict=True):
        found = calendar_day(sun, parameters, which)
        printed = parameters.days.declination[WINTER] * np.cos(365 * (number + 10) * TURN / 365)
        rows.append((name, number, parameters.days.declination[which], found, printed))
    yield Table(
        "Declination on the four days.",
        [
            "day", "number", Column("here", "degrees", ".2f"),
            Column("by (25), repaired", "degrees", ".2f"),
            Column("by (25), as printed", "degrees", ".2f"),
        ],
        rows,
    )  # fmt: skip
    angles = np.radians([rows[which][3] for which in (SPRING, AUTUMN)])
    rise, set_ = sunrise_and_sunset(sun, parameters, angles.min())
    clock = np.linspace(rise, set_, 721)
    both = [state_at(kernels, parameters, angle, clock) for angle in angles]
    off = [float(np.degrees(np.abs(both[0][k] - both[1][k]).max())) for k in ("alpha", "beta")]
    taken = [text_of(parameters.days.declination[k], "g") for k in (SPRING, AUTUMN)]
    yield Prose(
        "(25) as printed has the factor 365 twice: its cosine is 1 on every whole day and every "
        "day is the winter solstice. Repaired, it puts the two equinoxes of the calendar "
        f"{abs(np.degrees(angles[0] - angles[1])):.2f} degrees apart, and their angles by up to "
        f"{off[0]:.2f} degrees of α and {off[1]:.2f} of β. The study takes declinations of "
        f"{taken[0]} and {taken[1]} degrees; the paper has the sun over the equator."
    )
