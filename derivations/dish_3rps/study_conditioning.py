"""How well rods and hinges hold the facet: the full Jacobian over the day and the work space."""

import numpy as np

from armillary.verify.plots import Axis, Curve, HeatMap, Plot, centres
from armillary.verify.study import Column, Heading, Prose, Table

from .days import FACETS, PHI, attitude, day_names, four, hours, mount

YEAR = np.arange(1, 366)
COARSE = 10.0  # minutes, through the year
STEEP = 120.0  # degrees, the upper end of the map
FURTHEST = 130.0  # degrees, how far a singular attitude is looked for
LEVELS = (1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1000.0)
ROUND = np.radians(np.arange(-180.0, 180.5, 2.0))


def conditioning(kernels, sun, parameters):
    """Condition numbers, with angular velocities times r_m, and singular attitudes."""
    size, days = mount(kernels, parameters), day_names(parameters)
    clock = hours(parameters)
    yield Heading("How well do the rods hold the facet?")
    yield Prose(
        "All numbers here are with the inferred dimensions. The full Jacobian takes the facet's "
        "twist to the rates of its rods and to what its hinges make zero. Its columns of "
        "angular velocity are divided by the characteristic length "
        f"$r_m = {size['r_m']:g}$ m, so that all entries are pure numbers; the condition number, "
        "largest over smallest singular value, is 1 where every motion of the facet is held alike."
    )
    found = {
        n: np.linalg.cond(scaled(kernels, size, attitude(kernels, sun, parameters, n, clock)))
        for n in days
    }
    yield Plot(
        "Condition number of the full Jacobian, the worst of the four facets.",
        "clock time, h", Axis("condition number", log=True),
        [Curve(days[n], clock, c.max(axis=1)) for n, c in found.items()],
    )  # fmt: skip
    yield Table(
        "Largest condition number of each facet.",
        ["day", *(Column(facet, "", ".2f") for facet in FACETS)],
        [(days[n], *c.max(axis=0)) for n, c in found.items()],
    )
    edge = singular_tilt(kernels, size, ROUND)
    yield work_space(kernels, sun, parameters, size, edge)
    yield answer(kernels, sun, parameters, days, edge)


def scaled(kernels, size, angles, facets=four):
    """The Jacobian of pure numbers, of each facet."""
    weights = np.repeat([1.0, 1 / size["r_m"]], 3)
    return kernels.jacobian_full(**facets(angles), **size).J * weights


def one(angles):
    """Facet +X alone: the others are this one turned with the dish."""
    return {**angles, "phi": np.zeros_like(angles["alpha"])}


def singular_tilt(kernels, size, azimuth):
    """The smallest beta at which the Jacobian of facet +X is singular, by bisection; else NaN."""

    def positive(beta):
        return np.linalg.det(scaled(kernels, size, {"alpha": azimuth, "beta": beta}, one)) > 0

    low, high = np.zeros_like(azimuth), np.full_like(azimuth, np.nan)
    for step in np.radians(np.arange(1.0, FURTHEST)):
        high = np.where(np.isnan(high) & ~positive(np.full_like(azimuth, step)), step, high)
        low = np.where(np.isnan(high), step, low)
    for _ in range(40):
        middle = (low + high) / 2
        here = positive(np.nan_to_num(middle))
        low, high = np.where(here, middle, low), np.where(here, high, middle)
    return high


def turned(alpha, phi):
    """Azimuth of the dish's axis less that of the facet, in [-pi, pi)."""
    return np.remainder(alpha - phi + np.pi, 2 * np.pi) - np.pi


def work_space(kernels, sun, parameters, size, edge):
    """A map over the dish's attitude, with the singular attitudes and the ways of a day."""
    azimuth, tilt = np.arange(-180.0, 181.0, 7.5), np.arange(0.0, STEEP + 1, 2.5)
    a, b = np.meshgrid(np.radians(centres(azimuth)), np.radians(centres(tilt)))
    c = np.linalg.cond(scaled(kernels, size, {"alpha": a, "beta": b}, one))
    last = list(day_names(parameters))[-1]
    way = attitude(kernels, sun, parameters, last, hours(parameters))
    curves = [Curve("singular", np.degrees(ROUND), low_enough(np.degrees(edge)))]
    for facet, phi in zip(FACETS, PHI, strict=True):
        across = np.degrees(turned(way["alpha"], phi))
        across[1:][np.abs(np.diff(across)) > 180.0] = np.nan
        curves.append(Curve(facet, across, np.degrees(way["beta"])))
    return HeatMap(
        "Condition number over the attitude of the dish as a facet sees it, with the singular "
        "attitudes, and the ways of the four facets on the last of the four days.",
        "azimuth of the dish's axis less that of the facet, degrees",
        "angle of the dish's axis from the zenith, degrees", "condition number",
        azimuth, tilt, np.where(c < LEVELS[-1], c, np.nan), LEVELS, curves=curves,
    )  # fmt: skip


def low_enough(tilt):
    """What the map can show."""
    return np.where(tilt <= STEEP, tilt, np.nan)


def answer(kernels, sun, parameters, days, edge):
    """How far the days stay from the singularity."""
    angles = four(attitude(kernels, sun, parameters, YEAR[:, None], hours(parameters, COARSE)))
    room = np.interp(turned(angles["alpha"], angles["phi"]), ROUND, edge) - angles["beta"]
    margin = np.degrees(room).min(axis=(1, 2))
    worst = int(np.argmin(margin))
    own = min(days, key=lambda n: margin[min(n, len(YEAR)) - 1])
    tilt = np.degrees(edge)
    nearest, furthest = int(np.nanargmin(tilt)), int(np.nanargmax(tilt))
    return Prose(
        "**The work space ends at a singularity**, where locked rods no longer hold the facet. It "
        f"lies {tilt[nearest]:.1f} degrees from the zenith where the dish leans away from the side "
        f"of the facet (azimuth {abs(np.degrees(ROUND[nearest])):.0f} degrees), and "
        f"{tilt[furthest]:.1f} degrees at the best azimuth. The four days come nearest on the "
        f"{days[own]}, {margin[own - 1]:.1f} degrees of tilt before it; the year on day "
        f"{YEAR[worst]}, {margin[worst]:.1f} degrees before it. The paper does not look for it."
    )
