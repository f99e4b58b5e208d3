"""What the passive joints must allow, and how well the rods hold the facet."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Axis, Curve, Mark, Panels, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .days import (
    FACETS,
    PHI,
    RODS,
    attitude,
    clock_words,
    day_names,
    four,
    hours,
    mount,
)
from .drawing import joints

YEAR = np.arange(1, 366)
COARSE = 10.0  # minutes, through the year


def passive_joints(kernels, sun, parameters):
    """S-joints against their cone, and the hinges."""
    size, days = mount(kernels, parameters), day_names(parameters)
    clock = hours(parameters)
    cone, narrow = parameters.joints.cone, parameters.joints.conventional
    yield Heading(f"Does an S-joint of {cone:g} degrees suffice?")
    found = {
        n: np.degrees(
            kernels.joint_angles(**four(attitude(kernels, sun, parameters, n, clock)), **size).s
        )
        for n in days
    }
    yield Panels(
        "Largest S-joint angle of each facet: between rod and the facet's normal.",
        [
            Plot(
                f"facet {facet}", "clock time, h", Axis("angle, degrees", low=0.0, high=90.0),
                [Curve(days[n], clock, s[:, k].max(axis=1)) for n, s in found.items()],
                [Mark(cone, f"{cone:g}")],
            )
            for k, facet in enumerate(FACETS)
        ],
    )  # fmt: skip
    yield Table(
        "S-joint angles on the four days, and the time for which all twelve stay within the "
        "paper's cone and within the conventional one.",
        [
            "day", Column("largest", "degrees", ".2f"), "facet, rod, time",
            Column(f"within {cone:g} degrees", "h", ".2f"), "from, to",
            Column(f"within {narrow:g} degrees", "h", ".2f"),
        ],
        [row(days[n], s, clock, cone, narrow) for n, s in found.items()],
    )  # fmt: skip
    yield from sockets(kernels, sun, parameters, size, days)
    yield hinges(kernels, sun, parameters, size, days)


def row(name, s, clock, cone, narrow):
    """A day's largest angle, and the hours that two cones allow."""
    t, facet, rod = np.unravel_index(np.argmax(s), s.shape)
    worst = s.max(axis=(1, 2))
    step = clock[1] - clock[0]
    inside = clock[worst <= cone]
    narrowly = np.count_nonzero(worst <= narrow)
    span = f"{clock_words(inside[0])}, {clock_words(inside[-1])}" if len(inside) else "never"
    return (
        name, s.max(), f"{FACETS[facet]}, {RODS[rod]}, {clock_words(clock[t])}",
        max(len(inside) - 1, 0) * step, span, max(narrowly - 1, 0) * step,
    )  # fmt: skip


def sockets(kernels, sun, parameters, size, days):
    """All days: the cone about the facet's normal, and the smallest if its axis may lean."""
    clock = hours(parameters, COARSE)
    local = in_the_facet(kernels, size, attitude(kernels, sun, parameters, YEAR[:, None], clock))
    four_days = local[[min(n, len(YEAR)) - 1 for n in days]].reshape(-1, 4, 3, 3)
    s = np.degrees(np.arccos(np.clip(local[..., 2], -1, 1)))
    rows = []
    for k, facet in enumerate(FACETS):
        for i, rod in enumerate(RODS):
            own = smallest_cone(four_days[:, k, i])
            whole = smallest_cone(local[:, :, k, i].reshape(-1, 3))
            level = np.degrees(np.arctan2(whole[1][1], whole[1][0]) + PHI[k] - np.pi)
            lean = np.degrees(np.arccos(whole[1][2]))
            rows.append(
                (f"{facet}, {rod}", s[..., k, i].max(), own[0], whole[0], lean, (90 - level) % 360)
            )
    yield Table(
        "Half angle of the cone that an S-joint needs within the hours of the tracking: about the "
        "facet's normal, and about the axis that needs the smallest. The last two columns say how "
        "that axis leans from the normal, and to which azimuth when the dish looks up.",
        [
            "facet, rod", Column("about the normal, year", "degrees", ".2f"),
            Column("best axis, four days", "degrees", ".2f"),
            Column("best axis, year", "degrees", ".2f"), Column("leans by", "degrees", ".1f"),
            Column("leans to", "degrees", ".0f"),
        ],
        rows,
    )  # fmt: skip
    lean = largest_lean(kernels, size, attitude(kernels, sun, parameters, YEAR[:, None], clock))
    yield verdict(parameters, s, rows, lean)


def in_the_facet(kernels, size, angles):
    """Unit vectors along the rods, in facet axes."""
    base, platform, pose = joints(kernels, size, four(angles))
    along = platform - base
    along = along / np.linalg.norm(along, axis=-1, keepdims=True)
    return np.einsum("...ji,...kj->...ki", pose.H_R_M, along)


def largest_lean(kernels, size, angles):
    """The largest angle of a rod from the vertical, in degrees."""
    return np.degrees(np.abs(kernels.revolute_angles(**four(angles), **size).p_R)).max()


def verdict(parameters, s, rows, lean):
    """What the paper concludes, and what is found."""
    cone, narrow = parameters.joints.cone, parameters.joints.conventional
    worst = s.max(axis=(2, 3))
    good = int(np.count_nonzero((worst <= cone).all(axis=1)))
    span = [clock_words(hour) for hour in (parameters.days.first, parameters.days.last)]
    enough = "does" if good == len(YEAR) else "does not"
    own, whole = (max(row[k] for row in rows) for k in (2, 3))
    still = f"which is still more than {cone:g}" if whole > cone else f"which {cone:g} would allow"
    return Prose(
        f"The paper concludes that {cone:g} degrees allow tracking from {span[0]} to {span[1]}. "
        f"**About the facet's normal, a cone of {cone:g} degrees {enough} suffice**: "
        f"{s.max():.1f} degrees are needed, on {good} of {len(YEAR)} days {cone:g} are enough all "
        f"day, and {100 * np.mean(worst <= cone):.0f}% of the hours of the year are within "
        f"({100 * np.mean(worst <= narrow):.0f}% within the conventional {narrow:g}). The rods "
        f"stand within {lean:.1f} degrees of the vertical, so that the angle is the tilt of the "
        "facet within as much. It hangs on how the socket is mounted, which the paper does not "
        "say: with its axis leaning from the normal as in the table, "
        f"{whole:.1f} degrees suffice throughout the year, {still}. For the four days alone, each "
        f"socket about an axis of its own for them, {own:.1f} degrees suffice."
    )


def smallest_cone(directions):
    """Half angle in degrees and axis of the smallest cone that holds unit vectors.

    The axis a is along the shortest x with d . x >= 1 for each direction d; only the few that
    bind are kept, and the furthest is added until none is outside.
    """
    x = directions.mean(axis=0)
    x = x / (directions @ x).min()
    kept = directions[[np.argmin(directions @ x)]]
    for _ in range(50):
        x = shortest(kept, x)
        far = int(np.argmin(directions @ x))
        if directions[far] @ x >= 1 - 1e-9:
            break
        kept = np.vstack([kept, directions[far]])
    axis = x / np.linalg.norm(x)
    return np.degrees(np.arccos((directions @ axis).min())), axis


def shortest(kept, x):
    """The shortest vector whose product with each of `kept` is at least 1."""
    return need("scipy.optimize").minimize(
        lambda y: y @ y, x, jac=lambda y: 2 * y, method="SLSQP",
        constraints={"type": "ineq", "fun": lambda y: kept @ y - 1, "jac": lambda y: kept},
        options={"ftol": 1e-14},
    ).x  # fmt: skip


def hinges(kernels, sun, parameters, size, days):
    """Range of the R-joints."""
    clock = hours(parameters)
    p = np.degrees(
        np.concatenate(
            [
                kernels.revolute_angles(
                    **four(attitude(kernels, sun, parameters, n, clock)), **size
                ).p_R
                for n in days
            ]
        )
    )
    return Table(
        "Angles of the R-joints on the four days: of the rod from the vertical, outward positive.",
        ["facet, rod", Column("least", "degrees", ".2f"), Column("most", "degrees", ".2f")],
        [
            (f"{facet}, {rod}", p[:, k, i].min(), p[:, k, i].max())
            for k, facet in enumerate(FACETS) for i, rod in enumerate(RODS)
        ],
    )  # fmt: skip
