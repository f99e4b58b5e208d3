"""Some mass centres beside each other: forces, heat and mechanical power of both mechanisms."""

from armillary.verify.plots import Curve, Plot
from armillary.verify.study import Column, Table, text_of

from .study_basis import LEGS
from .study_power import constant

MM = 1e3
MILLI = 1e3
KILO = 1e-3
NAMES = ("largest", "mean, leg 1", "mean, leg 2", "mean, leg 3")


def forces(found, places, published):
    """The forces."""
    rows = [
        (name, MM * y, MM * z, *found.figures((0.0, y, z)), *two_drives(found, (y, z)))
        for name, (y, z) in places.items()
    ]
    theirs = published.peak_force, *published.mean_forces
    rows.append(
        ("the paper", None, None, *theirs, published.peak_force, *published.mean_forces_two)
    )
    return Table(
        "Forces on the equinox for some mass centres, beside the paper's"
        + ("; no value where they grow without bound." if found.loose else "."),
        [
            "mass centre", Column("y", "mm", ".1f"), Column("z", "mm", ".1f"),
            *(Column(f"three drives: {name}", "N", ".1f") for name in NAMES),
            *(Column(f"two drives: {name}", "N", ".1f") for name in NAMES[:3]),
        ],
        rows,
    )  # fmt: skip


def at_its_best(found, centre):
    """Forces of both mechanisms for a mass centre without poles."""
    F, F_2 = found.three.at(centre), found.two.at(centre)
    return Plot(
        f"Forces on the equinox with the mass centre at y = {text_of(MM * centre[1], '.1f')} mm, "
        f"z = {text_of(MM * centre[2], '.1f')} mm, which gives both mechanisms the paper's peak "
        "and two drives no pole.",
        "solar time, h", "force, N",
        [
            *(Curve(f"{leg}, three drives", found.clock, F[:, k]) for k, leg in enumerate(LEGS)),
            *(Curve(f"{LEGS[k]}, two drives", found.clock, F_2[:, k]) for k in range(2)),
        ],
    )  # fmt: skip


def two_drives(found, place):
    """Largest and mean forces of two drives, where they have them."""
    if not has_no_pole(found, place):
        return None, None, None
    return tuple(found.figures_two((0.0, *place)))


def has_no_pole(found, place):
    """Whether nothing is asked along the motions that are not held."""
    return max((abs(of.at((0.0, *place))) for of in found.loose), default=0.0) < 1e-6


def energies(found, places, parameters):
    """Heat of the day, and its ratio."""
    k, published, rows = constant(parameters), parameters.published, []
    for name, place in places.items():
        one, other = found.squares((0.0, *place))
        other = other if has_no_pole(found, place) else None
        rows.append((
            name, KILO * k * one, None if other is None else KILO * k * other,
            None if other is None else other / one, around_by_dawn(found, place)[0],
            None if other is None else around_by_dawn(found, place)[1],
        ))  # fmt: skip
    low, high = published.energy
    rows.append(("the paper", low, high, high / low,
                 *(noon / published.peak_copper for noon in published.noon_copper)))  # fmt: skip
    return Table(
        f"Copper's heat on the equinox for the same mass centres, with {1e4 * k:.2f}·10⁻⁴ W/N². "
        "The ratios hang on no motor; around noon is the largest within an hour of it.",
        [
            "mass centre", Column("three drives", "kJ", ".1f"), Column("two drives", "kJ", ".1f"),
            Column("two by three", "", ".2f"),
            Column("three drives: around noon by sunrise", "", ".2f"),
            Column("two drives: around noon by sunrise", "", ".2f"),
        ],
        rows,
    )  # fmt: skip


def mechanical(found, places):
    """Mechanical power."""
    rows = []
    for name, place in places.items():
        (peak, size), (peak_2, size_2) = found.mechanical((0.0, *place))
        rows.append((name, *(MILLI * P for P in (peak, peak_2, size, size_2))))
    return Table(
        "Mechanical power of all drives together on the equinox for the same mass centres, in "
        "size. In the paper the peaks are equal and the mean is higher with three drives.",
        [
            "mass centre", Column("largest, three drives", "mW", ".3f"),
            Column("two drives", "mW", ".3f"), Column("mean, three drives", "mW", ".3f"),
            Column("two drives", "mW", ".3f"),
        ],
        rows,
    )  # fmt: skip


def around_by_dawn(found, place):
    """Largest heat around noon by that at sunrise, of both mechanisms."""
    return [most / dawn for dawn, _, most in found.heats((0.0, *place))]


def told(found, name, place):
    """What a mass centre gives, as the verdicts take it; two drives as far as they have it."""
    centre = (0.0, *place)
    mechanical = found.mechanical(centre)
    figures = found.figures(centre).tolist(), found.figures_two(centre).tolist()
    both = [
        {"largest": largest, "means": means, "mechanical": power, "squares": squares,
         "dawn": dawn, "least": least, "most": most}
        for (largest, *means), power, squares, (dawn, least, most) in zip(
            figures, mechanical, found.squares(centre), found.heats(centre), strict=True
        )
    ]  # fmt: skip
    if not has_no_pole(found, place):
        both[1] = {"mechanical": mechanical[1], "dawn": both[1]["dawn"]}
    return {"name": name, "place": [float(at) for at in place], "drives": both}
