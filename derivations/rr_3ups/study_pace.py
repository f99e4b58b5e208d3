"""What inertia and the spin of the legs are worth at the sun's pace and faster."""

import numpy as np

from armillary.verify.plots import Axis, Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table, text_of

from .study_basis import CALM, SPRING, day_of, declination, mount, state_at

SMALL = 1e-3  # of the weight; less does not show


def pace(kernels, sun, parameters):
    """Largest forces of weight, inertia and spin against how fast the day runs."""
    day = day_of(kernels, sun, parameters)
    angle = declination(parameters, SPRING)
    factors = parameters.fast.speed_up
    found = [
        parts(kernels, parameters, state_at(kernels, parameters, angle, day.clock, factor))
        for factor in factors
    ]
    yield Heading("Inertia, and the spin of the legs")
    yield Prose(
        "The kernels without gravity give the inertia's part of the forces, so that nothing is "
        "lost in a difference. (10) lets a leg turn with its direction only; on a universal joint "
        "it also spins about itself, which the kernels take into account; their spin-free forms "
        f"are as the paper has it. {own_axis(parameters.bodies)}"
    )
    names = "weight", "inertia", "spin alone"
    columns = list(zip(*found, strict=True))
    yield Plot(
        "Largest force of three drives on the equinox, by its origin, against how much faster than "
        "the sun the day runs; where inertia crosses the weight the dynamics begins to count.",
        Axis("factor of speed", log=True), Axis("force, N", log=True),
        [Curve(name, factors, column, style="both")
         for name, column in zip(names, columns, strict=True)],
    )  # fmt: skip
    yield Table(
        "Largest force of three drives on the equinox by its origin and the factor of speed.",
        [Column("factor of speed", "", "g"), *(Column(name, "N", ".3g") for name in names)],
        [(factor, *row) for factor, row in zip(factors, found, strict=True)],
    )
    yield Prose(words(factors, found))
    yield Result("pace", {"weight": found[0][0], "inertia": found[0][1], "spin": found[0][2]})


def own_axis(bodies):
    """What the legs' moments about their own axes are worth."""
    own = sum(of[0][1] for of in (bodies.I_t, bodies.I_s))
    words = f"The moment of inertia of leg 1 about its own axis is {own:g} kg m²"
    if all(of[0][1] <= of[0][0] + of[0][2] for of in (bodies.I_t, bodies.I_s)):
        return f"{words}."
    return f"{words}, which no body of its other moments has: the spin's part is too large by that."


def parts(kernels, parameters, state):
    """Largest force of weight, of inertia, and of the spin within it, N."""
    weightless = mount(parameters, g=0.0)
    moved = kernels.forces(**state, **CALM, **weightless).F
    free = kernels.forces_spin_free(**state, **CALM, **weightless).F
    still = {name: of if name in ("alpha", "beta") else 0 * of for name, of in state.items()}
    weight = kernels.forces(**still, **CALM, **mount(parameters)).F
    return tuple(float(np.abs(of).max()) for of in (weight, moved, moved - free))


def words(factors, found):
    """When either matters."""
    weight, inertia, spin = found[0]
    equal = factors[0] * np.sqrt(weight / inertia)
    still = inertia < SMALL * weight
    return (
        f"{'At' if factors[0] == 1 else f'At {factors[0]:g} times'} the sun's pace inertia asks "
        f"for {text_of(inertia, '.2g')} N at most and weight for {weight:.1f} N: "
        + (
            "**on a solar day the dynamics is statics**, and what is wrong in (10) to (20) about "
            "rates does not show. "
            if still
            else "**the dynamics counts.** "
        )
        + f"Inertia grows with the square of the speed and reaches the weight at about {equal:.0f} "
        f"times the sun's pace. The spin is {100 * spin / inertia:.0f}% of it on this motion"
        + ("; a test on a solar day cannot tell whether it is there." if still else ".")
    )
