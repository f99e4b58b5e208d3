"""The four facets at 10, 12 and 14 o'clock on the longest day (Figs. 7 to 10)."""

import numpy as np

from armillary.verify.plots import Panels
from armillary.verify.study import Column, Heading, Prose, Table

from .days import FACETS, LONGEST_DAY, MM, NAMES, attitude, clock_words, four, mount, toward
from .drawing import EYE_AZIMUTH, EYE_ELEVATION, facet_drawing, joints

CLOCK = np.array([10.0, 12.0, 14.0])


def attitudes(kernels, sun, parameters):
    """A figure for each facet, and the numbers of all."""
    size = mount(kernels, parameters)
    angles = four(attitude(kernels, sun, parameters, LONGEST_DAY, CLOCK))
    c = toward(sun, parameters, LONGEST_DAY, CLOCK)
    base, platform, pose = joints(kernels, size, angles)
    yield Heading(f"Figs. 7 to 10: attitudes on the {NAMES[LONGEST_DAY]}")
    yield Prose(
        f"Each facet is seen from azimuth {EYE_AZIMUTH:.0f} degrees, {EYE_ELEVATION:.0f} degrees "
        "above the horizon, without perspective and to scale. The normal of a facet points off the "
        "sun by the slope of the dish at M, towards the dish's axis."
    )
    for k, facet in enumerate(FACETS):
        yield Panels(
            f"Fig. {7 + k}: the facet on the {facet} axis on the {NAMES[LONGEST_DAY]}.",
            [
                facet_drawing(
                    f"({letter}) {clock_words(hour)}", base[t, k], platform[t, k], pose.M[t, k],
                    pose.H_R_M[t, k, :, 2], c[t],
                )
                for t, (letter, hour) in enumerate(zip("abc", CLOCK, strict=True))
            ],
        )  # fmt: skip
    l = MM * kernels.rod_lengths(**angles, **size).l
    yield Table(
        "Figs. 7 to 10 in numbers: the facet's normal, its point M in the dish's level frame "
        "{H}, and its rods.",
        [
            "facet, time", Column("tilt", "degrees", ".2f"), Column("azimuth", "degrees", ".2f"),
            *(Column(f"$M_{x}$", "mm", ".1f") for x in "xyz"),
            *(Column(f"$l_{i}$", "mm", ".1f") for i in (1, 2, 3)),
        ],
        [
            (f"{facet}, {clock_words(hour)}", *directed(pose.H_R_M[t, k, :, 2]),
             *(MM * pose.M[t, k]), *l[t, k])
            for k, facet in enumerate(FACETS) for t, hour in enumerate(CLOCK)
        ],
    )  # fmt: skip


def directed(n):
    """Tilt from the zenith and azimuth from north, in degrees."""
    return (
        np.degrees(np.arctan2(np.hypot(n[0], n[1]), n[2])),
        np.degrees(np.arctan2(n[0], n[1])) % 360.0,
    )
