"""What the paper's own figures say of the motor's constant, whatever the mechanism."""

from armillary.verify.study import Column, Heading, Prose, Result, Table

from .study_basis import WITHIN, centre_words, day_of
from .study_forces import DRIVES

TEN_THOUSAND = 1e4
KILO = 1e3


def motor(kernels, sun, parameters, results):
    """Bounds on the constant, and the ratios that do not hang on it."""
    published = parameters.published
    day = day_of(kernels, sun, parameters)
    duration = 3600 * float(day.clock[-1] - day.clock[0])
    found = limits(published, duration)
    yield Heading("One constant of the motor for all the paper's figures?")
    yield Prose(
        "Copper power is a constant $k$ times the square of the force, $k = R (d / 2 \\pi K_M)^2$; "
        "$K_M$, $R$ and $d$ cannot be told apart by any power. Each published figure bounds $k$, "
        "without any model: no force exceeds the peak; the mean of squares is at least the square "
        "of the mean, and at most the peak times the mean."
    )
    yield Table(
        "The constant that each published figure permits.",
        ["figure", Column("at least", "10⁻⁴ W/N²", ".2f"), Column("at most", "10⁻⁴ W/N²", ".2f")],
        [(name, *(None if k is None else TEN_THOUSAND * k for k in ends))
         for name, ends in found.items()],
    )  # fmt: skip
    low = max(ends[0] for ends in found.values() if ends[0] is not None)
    high = min(ends[1] for ends in found.values() if ends[1] is not None)
    yield Prose(words(low, high, published))
    powers = results["power"]["copper"]
    yield table_of_ratios(powers, published)
    yield Prose(ratios_in_words(powers, parameters))
    yield Prose(needed(results["power"], published))
    yield Result("motor", {"low": low, "high": high})


def limits(published, duration):
    """Least and greatest constant by figure, W/N^2; None where there is no bound."""
    peak = published.peak_force
    means = published.mean_forces, published.mean_forces_two
    found = {"largest copper power": (None, published.peak_copper / peak**2)}
    for name, energy, forces in zip(DRIVES, published.energy, means, strict=True):
        power = KILO * energy / duration
        found[f"energy, {name}"] = (
            power / (peak * sum(forces)), power / sum(mean**2 for mean in forces),
        )  # fmt: skip
    for name, heat, forces in zip(DRIVES, published.noon_copper, means, strict=True):
        # Around noon every drive may be at its peak; more heat than that cannot be.
        found[f"copper power around noon, {name}"] = (heat / (len(forces) * peak**2), None)
    return found


def words(low, high, published):
    """Whether one constant fits."""
    if low > high:
        return "**No constant satisfies all of them: the published figures contradict each other.**"
    return (
        f"**One constant can satisfy all of them**: from {TEN_THOUSAND * low:.2f} to "
        f"{TEN_THOUSAND * high:.2f}·10⁻⁴ W/N². The published figures of heat do not contradict "
        f"each other, {published.noon_copper[0]:g} and {published.noon_copper[1]:g} W around noon "
        f"among them, and leave $k$ open by a factor of {high / low:.1f}."
    )


def table_of_ratios(powers, published):
    """Around noon by sunrise."""
    rows = [
        (name, ratio(of), noon / published.peak_copper)
        for name, of, noon in zip(DRIVES, powers, published.noon_copper, strict=True)
    ]
    seen = "; no value where it grows without bound" if ratio(powers[1]) is None else ""
    return Table(
        "Largest copper power within an hour of noon by that at sunrise, which hangs on no "
        f"constant{seen}.",
        ["mechanism", Column("here", "", ".3g"), Column("in the paper", "", ".2f")],
        rows,
    )


def ratio(of):
    """The largest heat around noon by that at sunrise, or None."""
    return None if of["most"] is None else of["most"] / of["dawn"]


def ratios_in_words(powers, parameters):
    """Whether a constant closes the gap."""
    published, ours = parameters.published, ratio(powers[0])
    theirs = published.noon_copper[0] / published.peak_copper
    fits = ours <= theirs * (1 + WITHIN)
    return (
        f"A constant scales both. With the mass centre {centre_words(parameters)} the three drives "
        f"heat up to {ours:.3g} times as much around noon as at sunrise, in the paper at most "
        f"{theirs:.2f} times: "
        + ("that agrees." if fits else "**no motor can close that**; what the drives carry could.")
    )


def needed(power, published):
    """The constant that each figure would need with our forces."""
    of, k = power["copper"][0], power["constant"]
    early, noon = (
        k * theirs / of[key]
        for key, theirs in (("dawn", published.peak_copper), ("most", published.noon_copper[0]))
    )
    return (
        "With our forces the paper's heat at sunrise needs "
        f"{TEN_THOUSAND * early:.1f}·10⁻⁴ W/N², that around noon with three drives at "
        f"most {TEN_THOUSAND * noon:.1f}·10⁻⁴"
        + (": they contradict each other." if early > (1 + WITHIN) * noon else ": they agree.")
    )
