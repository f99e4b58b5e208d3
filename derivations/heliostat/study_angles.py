"""The error angles of (1) and (2): over the sky, and over a day."""

import numpy as np

from armillary.verify.plots import Curve, Panels, Plot, centres, sky_map
from armillary.verify.study import Column, Heading, Prose, Table

from .sky import (
    LATITUDE,
    LOWEST,
    MILLI,
    OBLIQUITY,
    RISE,
    azimuth_of,
    elevation_of,
    exactly,
    lower_than,
    middle,
    south_receiver,
    through_a_day,
    toward,
)

LEAN = 3.0  # mrad, of each of the three
MACHINE = exactly(theta=LEAN * MILLI, psi=LEAN * MILLI, chi=LEAN * MILLI)
TOP = 75.0  # degrees, the upper end of the maps
LEVELS = (-30.0, -12.0, -6.0, -3.0, -1.0, 1.0, 3.0, 6.0)
DAYS = (
    ("June solstice", OBLIQUITY),
    ("equinox", 0.0),
    ("December solstice", -OBLIQUITY),
)


def error_angles(kernels):
    """Drive angles that take the axes for ideal, less the valid ones."""
    yield Heading("How far are drive angles off that take the axes for ideal?")
    yield Prose(
        "Equations (1) and (2) define $\\Delta_A$ and $\\Delta_h$, calculated less valid drive "
        f"angles, and leave them open. Take a plant at {LATITUDE:g} degrees north whose axes are "
        f"off by $\\theta = \\psi = \\chi = {LEAN:g}$ mrad, and a sun at least {LOWEST:g} degrees "
        "high. One mirror faces the sun, another throws it on a receiver due south, "
        f"{RISE:g} degrees high."
    )
    yield over_the_sky(kernels)
    yield over_a_day(kernels)
    yield table(kernels)
    yield answer(kernels)


def found(kernels, points):
    """Both error angles in mrad."""
    both = kernels.error_angles(**points, **MACHINE)
    return both.Delta_A / MILLI, both.Delta_h / MILLI


def first_order(points):
    """What the closed form says, in mrad."""
    n = middle(points)
    turn, rise = np.radians(azimuth_of(n)), np.radians(elevation_of(n))
    theta, psi, chi = (MACHINE[name] / MILLI for name in ("theta", "psi", "chi"))
    across = -np.tan(rise) * (chi + theta * np.sin(turn) - psi * np.cos(turn))
    return across, -(theta * np.cos(turn) + psi * np.sin(turn))


def over_the_sky(kernels):
    """Maps of both, for normals everywhere."""
    azimuth, elevation = np.arange(0.0, 361.0, 6.0), np.arange(0.0, TOP + 1.0, 5.0)
    n = toward(*np.meshgrid(centres(azimuth), centres(elevation)))
    maps = [
        sky_map(name, "error, mrad", azimuth, elevation, values, LEVELS)
        for name, values in zip(
            ("in azimuth", "in elevation"), found(kernels, {"c": n, "b": n}), strict=True
        )
    ]
    return Panels(
        f"Error angles $\\Delta_A$ and $\\Delta_h$ by where the normal points, up to {TOP:g} "
        "degrees; above, $\\Delta_A$ goes beyond the scale.",
        maps,
    )


def stands(c):
    """Both mirrors, for the same suns."""
    yield "facing the sun", {"c": c, "b": c}
    yield "on the receiver", {"c": c, "b": np.broadcast_to(south_receiver(), c.shape)}


def over_a_day(kernels):
    """Curves on the longest day."""
    (day, declination), *_ = DAYS
    hours, c = through_a_day(declination)
    plots = []
    for name, points in stands(c):
        across, up = found(kernels, points)
        curves = [Curve("azimuth", hours, across), Curve("elevation", hours, up)]
        plots.append(Plot(name, "hours after noon", "error, mrad", curves))
    return Panels(f"Error angles through the {day}.", plots)


def table(kernels):
    """The range of each through three days."""
    rows = []
    for day, declination in DAYS:
        for name, points in stands(through_a_day(declination)[1]):
            across, up = found(kernels, points)
            top = elevation_of(middle(points)).max()
            rows.append((day, name, top, across.min(), across.max(), up.min(), up.max()))
    return Table(
        "Error angles through three days.",
        [
            "day", "mirror", Column("highest normal", "degrees", ".1f"),
            *(
                Column(f"${angle}$, {end}", "mrad", ".2f")
                for angle in ("\\Delta_A", "\\Delta_h") for end in ("least", "most")
            ),
        ],
        rows,
    )  # fmt: skip


def answer(kernels):
    """The closed form, and how far it is off."""
    n = toward(*np.meshgrid(np.arange(0.0, 360.0, 5.0), np.arange(0.0, 86.0, 5.0)))
    points = {"c": n.reshape(-1, 3), "b": n.reshape(-1, 3)}
    low = lower_than(points, 60.5)
    off = [
        np.abs(np.array(found(kernels, some)) - np.array(first_order(some))).max()
        for some in (low, points)
    ]
    worst = np.abs(found(kernels, low)).max(axis=1)
    return Prose(
        "With $A$ and $E$ for azimuth from north and elevation of the normal, to first order "
        "$\\Delta_A = -(\\chi + \\theta \\sin A - \\psi \\cos A) \\tan E$ and "
        "$\\Delta_h = -(\\theta \\cos A + \\psi \\sin A)$. For this machine that is within "
        f"{off[0]:.2f} mrad of the exact kernel for normals up to 60 degrees and within "
        f"{off[1]:.1f} mrad up to 85. **Taking the axes for ideal costs up to {worst[0]:.1f} mrad "
        f"in azimuth and {worst[1]:.1f} mrad in elevation below 60 degrees; towards the zenith the "
        "azimuth has no bound.**"
    )
