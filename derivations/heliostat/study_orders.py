"""What it costs to linearise the drives' law in theta, psi and chi."""

from itertools import product

import numpy as np

from armillary.verify.plots import Axis, Curve, Mark, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .sky import (
    MILLI,
    SIZES,
    around,
    astray,
    elevation_of,
    exactly,
    facing,
    field,
    lower_than,
    middle,
    rms,
    spelled,
)

ORDERS = (("first", 2), ("second", 3))  # and the power that the error grows with
TOP = 75.0  # degrees: higher normals are looked at on their own
ENOUGH = 0.1  # mrad of normal
HEIGHTS = (30.0, 45.0, 60.0, 75.0, 85.0)
SIGNS = np.array(list(product((-1.0, 1.0), repeat=3)))
ALONE = (
    ("$\\theta$", np.diag([1.0, 0, 0])[:1]),
    ("$\\psi$", np.diag([0, 1.0, 0])[1:2]),
    ("$\\chi$", np.diag([0, 0, 1.0])[2:]),
    ("all, any signs", SIGNS),
)
MICRO = 1e-6


def orders(kernels):
    """The truncated laws: their cost, and when first order is enough."""
    points = lower_than(field(), TOP)
    yield Heading("What does it cost to linearise the law?")
    yield Prose(
        "Now the law knows the misalignments, and is truncated: `drive_first_order` keeps what is "
        "linear in all three together, `drive_second_order` their products too. The machine has "
        "one of them alone, or all three of one size with any signs. The mirrors stand round the "
        f"tower as before, with normals up to {TOP:g} degrees high."
    )
    yield from tables(kernels, points)
    yield from by_size(kernels, points)
    yield closed_form(kernels, points)
    yield Heading("When is first order enough?")
    yield by_elevation(kernels)
    yield from enough(kernels)


def machines(combined, size):
    """Machines with misalignments of one size, as columns to go with rows of points."""
    return exactly(*(size * MILLI * combined.T[:, :, None]))


def law(kernels, order):
    """The kernel of an order."""
    return getattr(kernels, f"drive_{order}_order")


def costs(kernels, points, order, combined, size):
    """Angles of normal and of beam in rad: a row a machine, a column a point."""
    machine = machines(combined, size)
    return astray(kernels, points, law(kernels, order)(**points, **machine), machine)


def tables(kernels, points):
    """Root mean square and worst for each misalignment alone and for all, of normal and beam."""
    cells = {
        (order, name): [costs(kernels, points, order, combined, size) for size in SIZES]
        for order, _ in ORDERS
        for name, combined in ALONE
    }
    for kind, over in (("Root mean square", rms), ("Worst", np.max)):
        rows = [
            (order, name, what, *(over(found[k]) / MICRO for found in cells[order, name]))
            for order, name in cells
            for k, what in enumerate(("normal", "beam"))
        ]
        heads = [Column(f"for {size:g} mrad", "µrad") for size in SIZES]
        yield Table(
            f"{kind} over the same sky of the angle between normal or beam and the one that is "
            f"wanted, with the truncated laws and misalignments of {SIZES[0]:g} to "
            f"{SIZES[-1]:g} mrad.",
            ["order", "misaligned", "angle of", *heads],
            rows,
        )
    alone = [cells["first", name][-1][0].max() / MICRO for name, _ in ALONE[:-1]]
    every = [cells["first", ALONE[-1][0]][k] for k in (0, -1)]
    yield Prose(
        f"**Linearised, {SIZES[-1]:g} mrad of $\\theta$, $\\psi$ or $\\chi$ alone cost up to "
        f"{spelled(alone, '.0f')} µrad of normal; all three together cost up to "
        f"{every[0][0].max() / MICRO:.1f} µrad of normal and {every[0][1].max() / MICRO:.1f} of "
        f"beam at {SIZES[0]:g} mrad, {every[1][0].max() / MILLI:.2f} and "
        f"{every[1][1].max() / MILLI:.2f} mrad at {SIZES[-1]:g} mrad.**"
    )


def by_size(kernels, points):
    """The worst against the size, and the slopes."""
    sizes = np.geomspace(0.5, 20.0, 9)
    curves, slopes = [], []
    for order, _ in ORDERS:
        both = np.array(
            [[rms(a) for a in costs(kernels, points, order, SIGNS, size)] for size in sizes]
        )
        slopes.append(np.polyfit(np.log(sizes), np.log(both[:, 0]), 1)[0])
        for what, found in zip(("normal", "beam"), both.T, strict=True):
            curves.append(Curve(f"{order} order, {what}", sizes, found / MILLI))
    yield Plot(
        "Root mean square of the angles of normal and beam with the truncated laws, all three "
        "misalignments of one size and any signs.",
        Axis("size of the misalignments, mrad", log=True),
        Axis("angle, mrad", log=True),
        curves,
        [Mark(ENOUGH, f"{ENOUGH:g} mrad")],
    )
    theory = " and ".join(str(power) for _, power in ORDERS)
    yield Prose(
        f"The slopes of the normal's curves are {spelled(slopes, '.3f')}; what is left out has "
        f"the orders {theory}."
    )


# -- the leading term -----------------------------------------------------------------------------


def leading(kernels, points, machine):
    """What the second-order law adds to the first, as a shift of the normal."""
    one, two = (law(kernels, order)(**points, **machine) for order, _ in ORDERS)
    rise = np.radians(elevation_of(middle(points)))
    return np.hypot(np.cos(rise) * (two.alpha - one.alpha), two.beta - one.beta)


def closed_form(kernels, points):
    """How well it fits."""
    off = []
    for size in (SIZES[0], SIZES[-1]):
        machine = machines(SIGNS, size)
        exact = costs(kernels, points, "first", SIGNS, size)[0]
        off.append(np.abs(exact - leading(kernels, points, machine)).max() / exact.max())
    facing_sun = [
        costs(kernels, facing(), order, SIGNS, SIZES[-1])[0].max() / MICRO for order, _ in ORDERS
    ]
    top = elevation_of(facing()["c"]).max()
    return Prose(
        "What first order leaves out of the normal is, across and up, "
        "$\\cos E \\, [\\, p \\chi (1 + t^2) + p w (t^2 + \\tfrac{1}{2}) - "
        "\\tfrac{1}{2} \\theta \\psi \\,]$ and $\\tfrac{1}{2} t (\\chi^2 - w^2)$, with "
        "$t = \\tan E$ and the leans towards the normal and across, "
        "$p = \\theta \\cos A + \\psi \\sin A$ and $w = \\theta \\sin A - \\psi \\cos A$. It is "
        f"within {100 * off[0]:.1g}% of the worst exact angle at {SIZES[0]:g} mrad and within "
        f"{100 * off[1]:.1g}% at {SIZES[-1]:g} mrad. $\\chi$ alone costs "
        "$\\tfrac{1}{2} \\chi^2 \\tan E$, all of it in elevation. A mirror that faces the sun has "
        f"its normal no higher than {top:.1f} degrees; with all three at {SIZES[-1]:g} mrad the "
        f"two laws leave at most {facing_sun[0]:.0f} and {facing_sun[1]:.1f} µrad there."
    )


# -- when it is enough ----------------------------------------------------------------------------


def by_elevation(kernels):
    """The worst of all signs and azimuths against the normal's elevation."""
    rise = np.append(np.arange(2.5, 85.0, 2.5), (85.0, 86.0, 87.0))
    curves = []
    for order, _ in ORDERS:
        for size in (SIZES[0], SIZES[-1]):
            found = [costs(kernels, around(e), order, SIGNS, size)[0].max() for e in rise]
            curves.append(Curve(f"{order} order, {size:g} mrad", rise, np.array(found) / MILLI))
    return Plot(
        "Worst angle of the normal with the laws of first and second order, all round and for any "
        "signs, for misalignments of two sizes.",
        "elevation of the normal, degrees",
        Axis("angle of the normal, mrad", log=True),
        curves,
        [Mark(ENOUGH, f"{ENOUGH:g} mrad")],
    )


def largest(kernels, elevation, order):
    """Largest size in mrad of all three that keeps the normal within what is enough."""
    low, high = 1e-2, 300.0
    for _ in range(30):
        size = np.sqrt(low * high)
        found = costs(kernels, around(elevation, 36), order, SIGNS, size)[0].max()
        low, high = (size, high) if found < ENOUGH * MILLI else (low, size)
    return low


def by_closed_form(kernels, elevation):
    """The same for first order, from the leading term."""
    points = around(elevation, 36)
    worst = leading(kernels, points, machines(SIGNS, 1.0)).max()
    return np.sqrt(ENOUGH * MILLI / worst)


def enough(kernels):
    """How large the misalignments may be."""
    rows = [
        (
            height,
            largest(kernels, height, "first"),
            by_closed_form(kernels, height),
            largest(kernels, height, "second"),
        )
        for height in HEIGHTS
    ]
    yield Table(
        f"How large $\\theta$, $\\psi$ and $\\chi$ may be, together and of any signs, for the "
        f"normal to stay within {ENOUGH:g} mrad.",
        [
            Column("elevation of the normal", "degrees", ".0f"),
            Column("first order", "mrad", ".1f"),
            Column("by the closed form", "mrad", ".1f"),
            Column("second order", "mrad", ".0f"),
        ],
        rows,
    )
    sizes = {height: first for height, first, *_ in rows}
    yield Prose(
        f"**First order keeps the normal within {ENOUGH:g} mrad for misalignments of up to "
        f"{sizes[60.0]:.1f} mrad and normals up to 60 degrees, {sizes[75.0]:.1f} mrad up to 75 and "
        f"{sizes[85.0]:.1f} mrad up to 85.** The exact drive has no such limit."
    )
