"""Two troughs of different size: where they rest, how firmly, and how they swing."""

import numpy as np

from armillary.verify.plots import Axis, Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table, text_of

from .troughs import SIZES, TITLES, law, trough, volumes

LITRE = 1e3
ML = 1e6
SUN = np.radians(15) / 3600  # rad/s


def sizes(kernels, parameters):
    """The closed forms over the volume moved."""
    found = {TITLES[size]: figures(kernels, trough(parameters, size)) for size in SIZES}
    yield Heading("Two troughs of different size")
    yield plot(
        found, "theta", "angle at rest, degrees",
        "The angle at which a trough rests over the volume moved from container 2 to 1. See that "
        "the first litre turns it most: the water adds to what must be turned.",
    )  # fmt: skip
    yield plot(
        found, "band", "half of the range, degrees",
        "Half of the range of angles in which friction holds a trough. It is widest upright, "
        "where the least moment brings the trough back.",
    )  # fmt: skip
    yield plot(
        found, "period", Axis("period, s", low=0.0),
        "Period of small swings about the rest. See that it is shorter when the trough leans: the "
        "water that was moved puts the mass centre farther from the axis.",
    )  # fmt: skip
    yield table(kernels, parameters, found)
    yield Prose(in_words(found))
    yield Result("sizes", {n: {"reach": f["theta"].max()} for n, f in found.items()})


def figures(kernels, given):
    """Rest angle, stability, band, period and gain over the volume."""
    s = volumes(kernels, given)
    rest = kernels.rest(s=s, **given)
    return {
        "s": s, "theta": np.degrees(kernels.rest_angle(s=s, **given).theta),
        "band": np.degrees(kernels.stick_band(s=s, **given).half_width),
        "period": rest.period, "stiffness": rest.stiffness, "gain": rest.gain,
    }  # fmt: skip


def plot(found, name, label, caption):
    """A quantity over the volume, of both."""
    return Plot(
        caption, "volume moved, l", label,
        [Curve(title, LITRE * of["s"], of[name]) for title, of in found.items()],
    )  # fmt: skip


def table(kernels, parameters, found):
    """Upright and at the end of the stroke."""
    rows = []
    for size in SIZES:
        given, stroke = trough(parameters, size), parameters.place.stroke
        for angle in (0.0, stroke):
            at = {"theta": np.radians(angle), **given}
            s = float(kernels.rest_volume(**at).s)
            rest = kernels.rest(s=s, **given)
            cycle = kernels.cycle(s=s, theta_dot_ref=SUN, **given, **law(parameters, size))
            rows.append((
                TITLES[size], angle, LITRE * s, rest.stiffness, rest.period,
                np.degrees(rest.gain) / LITRE,
                np.degrees(kernels.stick_band(s=s, **given).half_width),
                ML * abs(kernels.stick_volumes(**at).reversal),
                ML * kernels.follow(s=s, theta_dot_ref=SUN, **given).q * 60,
                cycle.t_on, cycle.t_cycle,
            ))  # fmt: skip
    return Table(
        "Both troughs upright and at the end of the stroke, from the closed forms; flow and cycle "
        "for 15 degrees an hour.",
        [
            "trough", Column("angle", "degrees", ".0f"), Column("volume", "l", ".3f"),
            Column("stiffness", "N m/rad"), Column("period", "s"),
            Column("gain", "degrees/l"), Column("half of the stick range", "degrees"),
            Column("water to reverse", "ml"), Column("flow to follow", "ml/min"),
            Column("pump on", "s"), Column("cycle", "s"),
        ],
        rows,
    )  # fmt: skip


def in_words(found):
    """What holds for both."""
    rising = all(np.all(np.diff(of["theta"]) > 0) for of in found.values())
    falls = " and ".join(
        text_of(of["gain"].min() / of["gain"].max(), ".2f") for of in found.values()
    )
    reach = ", ".join(f"{of['theta'].max():.0f} degrees ({n})" for n, of in found.items())
    return (
        f"The water reaches {reach} before a container is empty or full. On the "
        f"way more water {'always turns' if rising else 'does not always turn'} it further. The "
        f"first litre turns it most: from upright to the end the gain falls to {falls} of what it "
        "was, and a pump that follows at noon may be too slow when the trough leans far."
    )
