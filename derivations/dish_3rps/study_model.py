"""How much the paper's over-determined facet is off, through the days."""

import numpy as np

from armillary.verify.plots import Curve, Panels, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .days import (
    FACETS,
    LONGEST_DAY,
    MILLI,
    MM,
    NAMES,
    PHI,
    apart,
    attitude,
    day_names,
    four,
    hours,
    mount,
)
from .paper_readings import READINGS, dish_facet, read, replaced

RODS_OFF = (
    "Rods by the paper's readings less those of the consistent facet, the largest of three, on "
    f"the {NAMES[LONGEST_DAY]}."
)
PLANES_OFF = (
    "How far S-joints are out of the planes of their hinges by the paper's readings, the furthest "
    f"of three, on the {NAMES[LONGEST_DAY]}."
)


def model(kernels, sun, parameters):
    """The readings against the consistent facet."""
    size, days = mount(kernels, parameters), day_names(parameters)
    clock = hours(parameters)
    yield Heading("What the paper's facet is worth in millimetres")
    yield frames()
    yield told(size)
    rows, gaps, lost = [], [], [0, 0]
    for n, name in days.items():
        angles = four(attitude(kernels, sun, parameters, n, clock))
        rows += compared(kernels, size, angles, name, lost)
        off = np.linalg.norm(kernels.off_dish(**angles, **size).off, axis=-1)
        gaps.append((name, *(MM * off.max(axis=0)), *twist(kernels, size, angles)))
    yield Table(
        "Rods by the paper's readings: how far they are from those of the consistent facet, how "
        "far an S-joint would be out of the plane of its hinge, how far a machine with these rods "
        "points off, and the extremes.",
        [
            "day", "reading", Column("rods off by", "mm", ".1f"),
            Column("out of plane", "mm", ".1f"), Column("normal off by", "mrad", ".1f"),
            Column("shortest", "mm", ".1f"), Column("longest", "mm", ".1f"),
        ],
        rows,
    )  # fmt: skip
    yield from over_the_day(kernels, sun, parameters, size)
    yield Table(
        "How far the dish's own point is from where the hinges let the facet's point be, and the "
        "torsion of the dish's attitude, which a 3-RPS platform cannot follow.",
        [
            "day", *(Column(facet, "mm", ".1f") for facet in FACETS),
            Column("torsion from", "degrees", ".2f"), Column("to", "degrees", ".2f"),
        ],
        gaps,
    )  # fmt: skip
    yield answer(rows, gaps, lost, parameters.tracking.found_error)


def compared(kernels, size, angles, name, lost):
    """Rows of a day; counts in `lost` the poses without an answer, and all."""
    own = kernels.rod_lengths(**angles, **size).l
    yield name, "consistent", None, None, None, MM * own.min(), MM * own.max()
    for reading, found in read(size, **angles).items():
        off = astray(kernels, size, angles, found.l)
        lost[0] += int(np.isnan(off).sum())
        lost[1] += off.size
        yield (
            name, reading, MM * np.abs(found.l - own).max(), MM * np.abs(found.off_plane).max(),
            np.nanmax(off), MM * found.l.min(), MM * found.l.max(),
        )  # fmt: skip


def frames():
    """What the letters of the frames stand for."""
    return Prose(
        "All numbers here are with the inferred dimensions. {H} is the dish's level frame: its "
        "origin is on the ground below the dish's vertex, its axes point east, north and up. {P} "
        "is the frame of a facet's base, which the hinges stand on: level too, its origin on the "
        "ground at the distance $d$ from that of {H}, its $x$ axis towards that of {H}."
    )


def told(size):
    """What (14) and (15) are."""
    random = np.random.default_rng(7)
    alpha, beta, phi = random.uniform(-np.pi, np.pi, (3, 200))
    R, _ = dish_facet(size, alpha, beta, phi)
    x, y = replaced(size, R, alpha, beta, phi)
    gap = max(
        np.abs(x - size["r_m"] / 2 * (R[:, 0, 0] - R[:, 1, 1])).max(),
        np.abs(y + size["r_m"] * R[:, 1, 0]).max(),
    )
    bound = 10.0 ** np.ceil(np.log10(max(gap, 1e-15)))
    level = dish_facet(size, 0 * PHI, 0 * PHI, PHI)[0]
    places = np.hypot(*replaced(size, level, 0 * PHI, 0 * PHI, PHI))
    return Prose(
        "(13) places the facet in the dish: six coordinates, of which a 3-RPS platform can follow "
        "three. (14) and (15) then give $x$ and $y$ again. With the elements of (12) they say "
        "$x = r_m (n_1 - o_2) / 2$ and $y = -r_m n_2$ (equal to the printed sums within "
        f"{bound:.0e} m at 200 random attitudes): two of the three conditions that the S-joints "
        "stay in the planes of their hinges. These conditions hold for components in {P}, from "
        "its origin; the paper has those in {H}, from the middle of the dish: at rest the four "
        f"facets would stand {', '.join(f'{MM * x:.0f}' for x in places)} mm from it, where "
        f"all should be at {MM * size['d']:.0f}. The third condition, $n_2 = o_1$, is imposed "
        f"nowhere. Three readings are compared: {READINGS[0]} is the facet fixed in the dish; "
        f"{READINGS[1]} puts them into (17) as they stand; the last takes the same two "
        "conditions in {P}."
    )


def twist(kernels, size, angles):
    """Torsion of the dish's facet against the one on rods, in degrees: least and most."""
    whole = np.broadcast_arrays(angles["alpha"], angles["beta"], angles["phi"])
    R, _ = dish_facet(size, *whole)
    own = kernels.facet(**angles, **size).H_R_M
    between = np.swapaxes(own, -1, -2) @ R
    found = np.degrees(np.arctan2(between[..., 1, 0], between[..., 0, 0]))
    return found.min(), found.max()


def astray(kernels, size, angles, lengths):
    """Angles in mrad between the wanted normals and those of facets on given rods."""
    guess = np.stack(np.broadcast_arrays(angles["alpha"], angles["beta"], size["z_O"]), axis=-1)
    found = kernels.forward(l=lengths, guess=guess, phi=angles["phi"], **size)
    own = kernels.facet(**angles, **size)
    return apart(found.H_R_M[..., 2], own.H_R_M[..., 2]) / MILLI


def over_the_day(kernels, sun, parameters, size):
    """Both measures through the longest day."""
    clock = hours(parameters)
    angles = four(attitude(kernels, sun, parameters, LONGEST_DAY, clock))
    own = kernels.rod_lengths(**angles, **size).l
    found = read(size, **angles)
    for caption, of in (
        (RODS_OFF, lambda reading: reading.l - own),
        (PLANES_OFF, lambda reading: reading.off_plane),
    ):  # fmt: skip
        sizes = {name: MM * np.abs(of(reading)).max(axis=-1) for name, reading in found.items()}
        yield Panels(
            caption,
            [
                Plot(
                    f"facet {facet}", "clock time, h", "mm",
                    [Curve(name, clock, s[:, k]) for name, s in sizes.items()],
                )
                for k, facet in enumerate(FACETS)
            ],
        )  # fmt: skip


def answer(rows, gaps, lost, reported):
    """The sizes, in a sentence."""
    worst = {
        name: [max(row[k] for row in rows if row[1] == name) for k in (2, 4)] for name in READINGS
    }
    parts = "; ".join(
        f"{name}, {off:.0f} mm and {turn:.0f} mrad" for name, (off, turn) in worst.items()
    )
    times = [off / reported for off, _ in worst.values()]
    gap = max(max(row[1:5]) for row in gaps)
    torsion = max(max(abs(row[5]), abs(row[6])) for row in gaps)
    return Prose(
        "**How far the paper's rods are off, and how far a machine that is driven by them points "
        f"off, at most: {parts}.** (At {lost[0]} of {lost[1]} poses such rods "
        "belong to no pose near the wanted one.) The sun's disc is 9.3 mrad wide. No choice of "
        "rods can place the facet as (13) wants: its point would have to leave the "
        f"place that the hinges allow by up to {gap:.0f} mm, and the facet to twist by up to "
        f"{torsion:.1f} degrees. The rods are off by {min(times):.3g} to {max(times):.3g} times "
        f"the {reported:g} mm of tracking error that the paper reports, which is against set "
        "lengths that come from the same model."
    )
