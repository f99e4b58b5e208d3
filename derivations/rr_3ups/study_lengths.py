"""Lengths of the legs through the equinox (Fig. 5) and the other days."""

import numpy as np

from armillary.verify.plots import Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .study_basis import AUTUMN, LEGS, NAMES, SPRING, day_of, mount

MM = 1e3
MINUTE = 60.0  # s
ROUNDING = 1e-9  # m


def lengths(kernels, sun, parameters):
    """Fig. 5, strokes and speeds."""
    size = mount(parameters)
    days = [day_of(kernels, sun, parameters, k) for k in range(len(NAMES)) if k != AUTUMN]
    found = {day.name: kernels.leg_lengths(**day.pose, **size).q for day in days}
    speeds = {day.name: kernels.leg_rates(**day.motion, **size).q_dot for day in days}
    equinox = next(day for day in days if day.name == NAMES[SPRING])
    q = found[equinox.name]
    yield Heading("Fig. 5: lengths of the legs on the equinox")
    yield Plot(
        "Fig. 5: lengths of the legs on the equinox, from universal to spherical joint.",
        "solar time, h", "length, mm",
        [Curve(leg, equinox.clock, MM * q[:, i]) for i, leg in enumerate(LEGS)],
    )  # fmt: skip
    yield Table(
        "Stroke, longest less shortest, and largest speed of each leg on the days.",
        [
            "day", *(Column(f"stroke, {leg}", "mm", ".1f") for leg in LEGS),
            *(Column(f"speed, {leg}", "mm/min", ".2f") for leg in LEGS),
        ],
        [
            (name, *MM * np.ptp(found[name], axis=0),
             *MM * MINUTE * np.abs(speeds[name]).max(axis=0))
            for name in found
        ],
    )  # fmt: skip
    mirrored = float(np.abs(q[:, 0] - q[::-1, 1]).max())
    strokes = np.ptp(q, axis=0).tolist()
    yield Prose(words(strokes, mirrored))
    yield Result("lengths", {"strokes": strokes, "mirrored": mirrored})


def words(strokes, mirrored):
    """The paper's claim."""
    little = strokes[2] < min(strokes[:2])
    said = (
        f"Leg 3 {'varies less' if little else 'does not vary less'} than the others: "
        f"{MM * strokes[2]:.0f} mm against {MM * strokes[0]:.0f} and {MM * strokes[1]:.0f}. "
    )
    if mirrored > ROUNDING:
        return said + (
            "Lengths 1 and 2 are not symmetric: length 1 in the morning and length 2 as long after "
            f"noon are up to {MM * mirrored:.3g} mm apart."
        )
    return said + (
        "Symmetric can only mean mirrored: length 1 in the morning is length 2 in the afternoon, "
        "at the same time from noon, to rounding, as of any mechanism that is its own mirror "
        "image; at one and the same time the two lengths differ."
    )
