"""The error budget of the paper's introduction, linear and by Monte Carlo."""

import numpy as np

from armillary.verify.plots import (
    Axis,
    Bars,
    Curve,
    Panels,
    Plot,
    Series,
    centres,
    sky_map,
)
from armillary.verify.study import Column, Heading, Prose, Table

from .error_sources import ERRORS, PLAY, SAMPLES, STEPS, linear, monte_carlo, total
from .sky import (
    EAST,
    LATITUDE,
    LOWEST,
    OBLIQUITY,
    RISE,
    azimuth_of,
    elevation_of,
    middle,
    south_receiver,
    sun_at,
    through_a_day,
    toward,
)

HOUR = 30.0  # degrees of hour angle
INCIDENCE = 30.0  # degrees, on the way to the zenith
OFF_ZENITH = (60, 45, 30, 20, 15, 10, 7, 5, 3, 2, 1.5, 1, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05)  # degrees
WITHIN = 0.02


def budget(kernels):
    """What the errors of the introduction add up to."""
    c, b = sun_at(0.0, HOUR), south_receiver()
    n = middle({"c": c, "b": b})
    yield Heading("What do the errors of the introduction add up to?")
    yield Prose(
        "The introduction names the errors and gives no sizes. **Those of the table are our "
        "assumption**, independent of each other; put in your own. The base error "
        "$\\Delta_N$ contains $\\Delta_{NO}$ and $\\Delta_{NY}$; what else is in it we take to be "
        "the zero marks of the encoders. An error of a direction is taken both ways across it, "
        "one of a drive for each of the two on its own, and what axes are off by is what a "
        f"calibration has left. The encoders have {STEPS:,} steps a turn, the gears a play of "
        f"{PLAY:g} mrad."
    )
    yield Prose(
        "Linear means the derivatives of the drive, `drive_response` and `drive_sensitivity`; "
        "encoders, marks and gears add to the drive angles as they are. Monte Carlo means "
        f"{SAMPLES:,} machines through the exact drive and beam. The sun stands {HOUR / 15:g} "
        f"hours after noon at the equinox at {LATITUDE:g} degrees north, the receiver due south "
        f"and {RISE:g} degrees high: the normal points to azimuth {azimuth_of(n):.0f} and "
        f"elevation {elevation_of(n):.0f} degrees."
    )
    by_slopes = linear(kernels, {"c": c, "b": b})
    yield from one_by_one(kernels, c, b, by_slopes)
    yield from over_the_sky(kernels)
    yield Heading("Where does the linear budget fail?")
    yield from to_the_zenith(kernels)


# -- one sun and one receiver ---------------------------------------------------------------------


def one_by_one(kernels, c, b, by_slopes):
    """A row for each error, and what they add up to."""
    rows = []
    for error, slope in zip(ERRORS, by_slopes, strict=True):
        exact = monte_carlo(kernels, c, b, [error])
        rows.append((error.name, error.symbol, error.words, error.sigma, *_pairs(slope, exact)))
    whole, exact = total(by_slopes), monte_carlo(kernels, c, b)
    rows.append(("all", "", "", None, *_pairs(whole, exact)))
    yield Table(
        "Error budget: root mean square of the error angles and of the beam's angle, by the "
        "derivatives (lin.) and by Monte Carlo (MC). Sizes are assumed.",
        [
            "error", "paper", "assumed", Column("$\\sigma$", "mrad", ".2f"),
            *(
                Column(f"{what}, {how}", "mrad", ".3f")
                for what in ("$\\Delta_A$", "$\\Delta_h$", "beam") for how in ("lin.", "MC")
            ),
        ],
        rows,
    )  # fmt: skip
    yield Bars(
        "The same budget by the paper's symbols, by Monte Carlo.",
        "error",
        Axis("root mean square, mrad", low=0.0),
        [*(error.mark for error in ERRORS), "all"],
        [
            Series(name, [row[column] for row in rows])
            for name, column in (("azimuth", 5), ("elevation", 7), ("beam", 9))
        ],
        digits=2,
    )
    yield summary(rows)


def _pairs(slope, exact):
    both = zip(slope.three, exact.three, strict=True)
    return [float(number) for pair in both for number in pair]


def summary(rows):
    """Closed form, and the answer."""
    *each, whole = rows
    apart = max(abs(whole[k + 1] / whole[k] - 1) for k in (4, 6, 8))
    shares = sorted(((row[8] / whole[8]) ** 2, row[0]) for row in each)[::-1]
    largest = ", ".join(f"{name} {share:.0%}" for share, name in shares[:3])
    return Prose(
        "With $\\mathbf{J}$ the derivatives by the misalignments and $\\mathbf{J}_m$ those by the "
        "directions, the covariance of the drives is "
        "$\\mathbf{J} \\mathbf{S} \\mathbf{J}^\\mathsf{T} + "
        "\\mathbf{J}_m [\\sigma_M^2 (\\mathbf{1} - \\mathbf{c} \\mathbf{c}^\\mathsf{T}) + "
        "\\sigma_{NO}^2 (\\mathbf{1} - \\mathbf{b} \\mathbf{b}^\\mathsf{T})] "
        "\\mathbf{J}_m^\\mathsf{T} + (\\sigma_N^2 + \\sigma_{NY}^2 + \\sigma_P^2) \\mathbf{1}$, "
        "where $\\mathbf{S}$ holds the variances of $\\theta$, $\\psi$ and $\\chi$. "
        f"**The budget is {whole[5]:.2f} mrad in azimuth, {whole[7]:.2f} mrad in elevation and "
        f"{whole[9]:.2f} mrad of beam**, and linear and Monte Carlo differ by "
        f"{100 * apart:.1f}% at most. Most of the beam's variance: {largest}."
    )


# -- all suns -------------------------------------------------------------------------------------


def over_the_sky(kernels):
    """The beam's error for each place of the sun, with the sun's ways."""
    azimuth, elevation = np.arange(0.0, 361.0, 5.0), np.arange(LOWEST, 91.0, 4.0)
    c = toward(*np.meshgrid(centres(azimuth), centres(elevation)))
    maps = []
    for name, side in (("mirror north of the tower", 180.0), ("mirror south of the tower", 0.0)):
        points = {"c": c, "b": np.broadcast_to(toward(side, RISE), c.shape)}
        beam = total(linear(kernels, points)).beam
        maps.append(sky_map(name, "beam, mrad", azimuth, elevation, beam, curves=ways()))
    beams = np.array([one.values for one in maps], dtype=float)
    yield Panels(
        "Root mean square of the beam's angle by where the sun stands, linear, all errors. Upon it "
        "the sun's ways at the solstices and at the equinox.",
        maps,
    )
    yield Prose(
        f"The beam's error stays between {beams.min():.2f} and {beams.max():.2f} mrad for "
        "every place of the sun, normals at the zenith included: where the azimuth drive "
        "is sensitive, it moves the beam little."
    )


def ways():
    """The sun through three days."""
    found = []
    for name, declination in (("Jun", OBLIQUITY), ("Mar", 0.0), ("Dec", -OBLIQUITY)):
        # The name stands at the middle point: fewer points after noon move it off the scale.
        hours, c = through_a_day(declination)
        c = np.concatenate([c[hours < 0], c[hours >= 0][::4]])
        found.append(Curve(name, azimuth_of(c), elevation_of(c)))
    return found


# -- near the zenith ------------------------------------------------------------------------------


def to_the_zenith(kernels):
    """Both budgets as the normal goes to the zenith."""
    rows = []
    for off in OFF_ZENITH:
        n = toward(180.0, 90.0 - off)
        slant = np.radians(INCIDENCE)
        c, b = (np.cos(slant) * n + sign * np.sin(slant) * EAST for sign in (-1, 1))
        slope, exact = total(linear(kernels, {"c": c, "b": b})), monte_carlo(kernels, c, b)
        rows.append((float(off), *_pairs(slope, exact), 100 * exact.lost))
    table = np.array(rows)
    names = ("azimuth", "elevation", "beam")
    yield Plot(
        "The whole budget on the way to the zenith, linear and by Monte Carlo.",
        Axis("angle from the normal to the zenith, degrees", log=True),
        Axis("root mean square, mrad", log=True),
        [
            Curve(f"{name}, {how}", table[:, 0], table[:, 1 + 2 * k + mc], style)
            for k, name in enumerate(names)
            for mc, (how, style) in enumerate((("linear", "line"), ("Monte Carlo", "points")))
        ],
    )
    yield Table(
        "Monte Carlo over linear on the way to the zenith, and the share of machines for which no "
        "drive angles point the normal where it is wanted.",
        [
            Column("from the zenith", "degrees", ".3g"),
            *(Column(name, "", ".3f") for name in names),
            Column("no drive angles", "%", ".2g"),
        ],
        [
            (row[0], row[2] / row[1], row[4] / row[3], row[6] / row[5], row[7])
            for row in rows if row[0] in (60, 30, 10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05)
        ],
    )  # fmt: skip
    yield parting(table)


def parting(table):
    """Where they part."""
    ratio = np.abs(table[:, 2:7:2] / table[:, 1:6:2] - 1) < WITHIN
    good = np.logical_and.accumulate(ratio, axis=0)
    last = [table[column, 0].min() for column in good.T]
    return Prose(
        "Towards the zenith the linear error in azimuth grows as $1 / \\cos E$ without end, while "
        "an angle cannot be off by more than half a turn; and within $\\chi$ of the axis there are "
        f"no drive angles at all. **Linear and Monte Carlo agree within {WITHIN:.0%} in azimuth "
        f"down to {last[0]:g} degrees from the zenith, in elevation to {last[1]:g} and in the beam "
        f"to {last[2]:g} degrees**; the nearest that was tried is {min(OFF_ZENITH):g}."
    )
