"""How far the almanacs stray from the sun, by the NREL SPA."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Curve, Mark, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .simulation import FIRST_YEAR, LAST_YEAR, SETTING, calendar

YEARS = f"{FIRST_YEAR}-{LAST_YEAR}"
DISC = 0.27  # deg, half the width of the sun


def study(kernels):
    """What a user of an almanac asks first."""
    yield Heading("How good are the almanacs?")
    unix, day = calendar()
    found = list(almanacs(kernels, day, truth(unix)))
    worst = {name: np.max(np.abs(error)) for name, error in found}
    yield Prose(
        f"The sun's disc reaches {DISC} degrees from its centre. Spencer's series strays by up to "
        f"{worst['Spencer'] / DISC:.1f} times as much, Cooper's formula by up to "
        f"{worst['Cooper'] / DISC:.1f} times. Leap years shift the calendar under the formulas, so "
        "no year is like another: the figure shows one, the table all."
    )
    yield Table(
        f"Declination $\\delta$ by the almanacs less that of the NREL SPA, {YEARS}, every five "
        "hours.",
        ["almanac", Column("largest error", "degrees", ".2f"),
         Column("root mean square", "degrees", ".2f"), Column("mean", "degrees", ".2f")],
        [(name, worst[name], np.sqrt(np.mean(error**2)), np.mean(error)) for name, error in found],
    )  # fmt: skip
    yield through_a_year(kernels)


def truth(unix):
    """Declination in degrees by the NREL SPA."""
    return need("pvlib.spa").solar_position_numpy(unix, *SETTING, sst=True)[2]


def almanacs(kernels, day, exact):
    """Name and error in degrees of each almanac."""
    for name, kernel in (
        ("Cooper", kernels.cooper),
        ("Yu's cosine", kernels.cosine),
        ("Spencer", kernels.spencer),
    ):
        yield name, np.degrees(kernel(day=day).declination) - exact


def through_a_year(kernels):
    """The errors day by day in one year."""
    day = np.arange(1.0, 366.0, 2.0)
    start = np.datetime64("2025-01-01", "s").astype(float)
    exact = truth(start + 86400 * (day - 1))
    return Plot(
        "Declination by the almanacs less that of the NREL SPA, through the year 2025.",
        "day of the year",
        "error, degrees",
        [Curve(name, day, error) for name, error in almanacs(kernels, day, exact)],
        [Mark(DISC, "half the sun's disc"), Mark(-DISC, "")],
    )
