"""The linear error budget against machines drawn at random, through the exact kernels."""

import numpy as np

from armillary.verify.measured import compare

from .error_sources import ERRORS, linear, monte_carlo, total
from .sky import OBLIQUITY, RISE, sun_at, toward

SETTINGS = np.array(  # declination, hour angle and azimuth of the receiver, in degrees
    [(0.0, 30.0, 180.0), (OBLIQUITY, -60.0, 90.0), (-OBLIQUITY, 15.0, 60.0)]
)
SMALL = 0.05  # mrad, below which a part of the budget is not told from none


def budget_by_monte_carlo(kernels):
    """Each error alone, and all together: what they spread by in azimuth, elevation and beam."""
    declination, hour_angle, side = SETTINGS.T
    points = {"c": sun_at(declination, hour_angle), "b": toward(side, RISE)}
    each = linear(kernels, points)
    for name, by_slopes, errors, kernel in (
        *(
            (error.name, spread, [error], _kernel(error))
            for error, spread in zip(ERRORS, each, strict=True)
        ),
        ("all errors", total(each), ERRORS, "drive_response"),
    ):
        drawn = [monte_carlo(kernels, c, b, errors) for c, b in zip(*points.values(), strict=True)]
        wanted = np.array([spread.three for spread in drawn])
        found = np.stack(np.broadcast_arrays(*by_slopes.three), axis=-1)
        yield compare(
            f"{name}: linear spread over that of machines drawn at random, less 1",
            "Monte Carlo", (found - wanted) / np.maximum(wanted, SMALL), 0.0, 0.02, points, kernel,
        )  # fmt: skip


def _kernel(error):
    return "drive_sensitivity" if error.of in ("theta", "psi", "chi") else "drive_response"
