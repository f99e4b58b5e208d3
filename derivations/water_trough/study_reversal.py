"""Turning back: the water that crosses the range of friction, closed form and simulation."""

from itertools import pairwise

import numpy as np

from armillary.verify.study import Column, Heading, Prose, Result, Table, text_of

from .motion_of import Motion
from .pumping import joined
from .troughs import trough

ML = 1e6
RAMP = 1.0  # s
QUARTER = (3.5, 4.5)  # by which what grows with a square falls when it is halved


def reversal(kernels, native, parameters):
    """At several angles, with flows that are halved."""
    given, settings = trough(parameters), parameters.reversal
    rows, worst = [], dict.fromkeys(settings.flow, 0.0)
    for angle in settings.angle:
        theta = np.radians(angle)
        told = kernels.stick_volumes(theta=theta, **given)
        wanted = abs(float(told.reversal))
        found = [needed(native, given, theta, told, flow) for flow in settings.flow]
        for flow, volume in zip(settings.flow, found, strict=True):
            worst[flow] = max(worst[flow], abs(volume - wanted))
        rows.append((angle, ML * wanted, *(ML * (volume - wanted) for volume in found)))
    yield Heading("Turning back")
    yield Prose(
        "The trough stands where it stops when it has turned towards positive angles: at the edge "
        "of the range of friction. Then the pump runs the other way. The trough moves when the "
        "mass centre has crossed the whole range; `stick_volumes` says after how much water."
    )
    yield Table(
        "Water to turn the smaller trough back, by the closed form, and how much more the "
        "simulation takes at each flow.",
        [
            Column("angle", "degrees", ".0f"), Column("closed form", "ml", ".4f"),
            *(Column(f"more at {ML * flow:g} ml/s", "ml", ".2e") for flow in settings.flow),
        ],
        rows,
    )  # fmt: skip
    yield Prose(in_words(worst))
    yield Result("reversal", {"worst": list(worst.values())})


def needed(native, given, theta, told, flow):
    """Volume after which the trough slips back, m^3."""
    volume = 1.2 * abs(float(told.reversal))
    sign = np.sign(float(told.s_back) - float(told.s_on))
    legs = [(RAMP, sign * flow), (volume / flow, sign * flow), (RAMP, 0.0)]
    pieces = joined(float(told.s_on), 0.0, *legs)
    record = Motion(native, given, book=False).run(pieces, theta)
    back = next(time for time, _, mode in record.events if mode == "slip -")
    piece = next(piece for piece in pieces if piece.start <= back <= piece.end)
    return abs(piece(back)[0] - float(told.s_on))


def in_words(worst):
    """Order of what is neglected."""
    flows, sizes = list(worst), list(worst.values())
    ratios = [a / b if b > 0 else np.inf for a, b in pairwise(sizes)]
    squares = all(QUARTER[0] < ratio < QUARTER[1] for ratio in ratios)
    why = (
        " **It goes with the square of the flow**, as the flow's own inertia does: the closed form "
        "leaves that out."
        if squares else " That is not the square of the flow, as its inertia would be."
    )  # fmt: skip
    return (
        f"The largest difference, {text_of(ML * sizes[0], '.1e')} ml at {ML * flows[0]:g} ml/s, "
        "changes with the flow: halved, the flow leaves "
        + " and then ".join(text_of(1 / ratio, ".2f") for ratio in ratios)
        + " of it."
        + why
    )
