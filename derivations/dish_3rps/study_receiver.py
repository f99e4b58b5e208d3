"""Where the central rays go: with the normals of the dish, and aimed at the receiver."""

import numpy as np

from armillary.verify.plots import Curve, Panels, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .days import (
    FACETS,
    MILLI,
    MM,
    apart,
    attitude,
    day_names,
    four,
    hours,
    mount,
    toward,
)


def receiver(kernels, sun, parameters):
    """The miss of perfect rods, and what it takes to avoid it."""
    size, days = mount(kernels, parameters), day_names(parameters)
    clock = hours(parameters)
    found = {n: day(kernels, sun, parameters, size, n, clock) for n in days}
    yield Heading("Does the light reach the receiver?")
    yield Panels(
        "Distance by which the central ray of each facet passes the focus, rods perfect, facets "
        "with the normals of the dish.",
        [
            Plot(
                name, "clock time, h", "miss, mm",
                [Curve(facet, clock, found[n]["miss"][:, k]) for k, facet in enumerate(FACETS)],
            )
            for n, name in days.items()
        ],
    )  # fmt: skip
    yield Table(
        "The largest miss of each facet, and the angle that it is seen under from the facet.",
        ["day", *(Column(facet, "mm", ".1f") for facet in FACETS),
         *(Column(facet, "mrad", ".1f") for facet in FACETS)],
        [
            (name, *found[n]["miss"].max(axis=0), *found[n]["angle"].max(axis=0))
            for n, name in days.items()
        ],
    )  # fmt: skip
    still = kernels.central_ray(**four({"alpha": 0.0, "beta": 0.0}), **size)
    yield why(found, MM * still.miss.max())
    yield from bisected(found, days, clock, parameters)


def day(kernels, sun, parameters, size, n, clock):
    """Both ways of aiming through a day."""
    c = toward(sun, parameters, n, clock)[:, None, :]
    angles = four(attitude(kernels, sun, parameters, n, clock))
    ray = kernels.central_ray(**angles, **size)
    own = kernels.facet(**angles, **size)
    aimed = kernels.aim_at_receiver(**angles, **size)
    focus = np.array([0.0, 0.0, size["z_O"]]) + size["f"] * c
    normal = aimed.H_R_M[..., 2]
    beam = 2 * np.sum(c * normal, axis=-1, keepdims=True) * normal - c
    lengths = kernels.rod_lengths(**angles, **size).l
    return {
        "miss": MM * ray.miss,
        "angle": ray.miss_angle / MILLI,
        "aside": MM * np.linalg.norm(kernels.off_dish(**angles, **size).off, axis=-1),
        "left": MM * np.linalg.norm(np.cross(beam, focus - aimed.M), axis=-1),
        "turned": apart(normal, own.H_R_M[..., 2]) / MILLI,
        "rods": MM * (aimed.l - lengths),
        "l": MM * aimed.l,
        "way": np.linalg.norm(focus - aimed.M, axis=-1),
    }


def why(found, still):
    """Where the miss comes from."""
    miss = max(one["miss"].max() for one in found.values())
    aside = max(one["aside"].max() for one in found.values())
    return Prose(
        f"**With the inferred dimensions, perfect rods and the normals of the dish the central ray "
        f"misses the focus by up to {miss:.0f} mm.** Nothing is adjusted wrongly: a "
        "facet whose point were on the dish would send the ray into the focus, but the hinges "
        "keep the facet above its base, up to "
        f"{aside:.0f} mm aside of the dish's point. A flat facet at another place with the same "
        "normal sends a parallel ray, that far beside the focus as the step aside is seen across "
        f"the ray. Even with the sun at the zenith {still:.1f} mm are left. The paper, which takes "
        "the facet's point to be on the dish, does not see it; the radius of its receiver "
        "would have to be as large as the miss."
    )


def bisected(found, days, clock, parameters):
    """What aiming at the receiver takes."""
    limits = parameters.rods
    yield Heading("Aimed at the receiver")
    yield Prose(
        "The cure costs nothing but another set of rod lengths: `aim_at_receiver` gives each facet "
        "the normal that halves the angle between the sun and the focus as seen from where the "
        "hinges have its point. The height of the point stays that of the dish."
    )
    yield Panels(
        "Angle by which the normal that aims at the receiver differs from that of the dish.",
        [
            Plot(
                name, "clock time, h", "angle, mrad",
                [Curve(facet, clock, found[n]["turned"][:, k]) for k, facet in enumerate(FACETS)],
            )
            for n, name in days.items()
        ],
    )  # fmt: skip
    rows = []
    for n, name in days.items():
        one = found[n]
        rows.append((
            name, one["miss"].max(), one["turned"].max(), np.abs(one["rods"]).max(),
            one["l"].min(), one["l"].max(), one["way"].min(), one["way"].max(),
        ))  # fmt: skip
    yield Table(
        "Dish normals against normals that aim at the receiver.",
        [
            "day", Column("miss with dish normals", "mm", ".1f"),
            Column("normals turned by", "mrad", ".1f"), Column("rods differ by", "mm", ".1f"),
            Column("shortest", "mm", ".1f"), Column("longest", "mm", ".1f"),
            Column("nearest to the focus", "m", ".3f"), Column("furthest", "m", ".3f"),
        ],
        rows,
    )  # fmt: skip
    yield spared(found, rows, limits)


def spared(found, rows, limits):
    """What is left of the miss, and what it costs."""
    left = max(one["left"].max() for one in found.values())
    low, high = (pick(row[k] for row in rows) for pick, k in ((min, 4), (max, 5)))
    fits = MM * limits.shortest <= low and high <= MM * limits.longest
    return Prose(
        f"The miss falls from {max(row[1] for row in rows):.0f} mm to less than "
        f"{1e6 * 10 ** np.ceil(np.log10(max(left, 1e-7))):g} nm. The rods change by up to "
        f"{max(row[3] for row in rows):.0f} mm and measure {low:.1f} to {high:.1f} mm, which "
        f"{'is still' if fits else 'is no longer'} within two sections. The distance to the focus "
        "still changes through the day as in the last columns, so that a facet that is curved to "
        "focus at one distance is out of focus at others."
    )
