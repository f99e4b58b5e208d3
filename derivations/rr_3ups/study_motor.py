"""What the paper's own figures say of the motor's constant, whatever the mechanism."""

from armillary.verify.study import Column, Heading, Prose, Result, Table

from .study_basis import day_of
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
    yield Prose(ratios_in_words(powers, published))
    yield from needed(results["forces"], published)
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
    """Noon by sunrise."""
    rows = [
        (name, of["noon"] / of["dawn"], noon / published.peak_copper)
        for name, of, noon in zip(DRIVES, powers, published.noon_copper, strict=True)
    ]
    return Table(
        "Copper power at noon by that at sunrise, which hangs on no constant.",
        ["mechanism", Column("here", "", ".3g"), Column("in the paper", "", ".2f")],
        rows,
    )


def ratios_in_words(powers, published):
    """That no constant closes the gap."""
    ours = powers[0]["noon"] / powers[0]["dawn"]
    theirs = published.noon_copper[0] / published.peak_copper
    close = abs(ours / theirs - 1) < 0.05
    return (
        f"A constant scales both. With the mass centre at o the three drives heat {ours:.3g} times "
        f"as much at noon as at sunrise, in the paper at most {theirs:.2f} times: "
        + ("the same." if close else "**no motor can close that**, though a mass centre can.")
    )


def needed(forces, published):
    """The constant that each figure would need with our forces."""
    dawn, noon = (sum(f * f for f in forces[key][0]) for key in ("dawn", "noon"))
    k = [published.peak_copper / dawn, published.noon_copper[0] / noon]
    yield Prose(
        "With our forces the paper's heat at sunrise needs "
        f"{TEN_THOUSAND * k[0]:.0f}·10⁻⁴ W/N², that around noon with three drives "
        f"{TEN_THOUSAND * k[1]:.0f}·10⁻⁴: a factor of {k[0] / k[1]:.0f} apart."
    )
