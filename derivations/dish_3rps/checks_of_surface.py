"""The surface of the dish against lines that NumPy intersects."""

import numpy as np

from armillary.verify.exact import text_book
from armillary.verify.measured import compare
from armillary.verify.points import rows_of

from .dish import z_G


def normals_meet(kernels):
    """The normal of the facet's point meets the dish's axis where it is said to."""
    random = np.random.default_rng(91)
    points = {"d": random.uniform(0.1, 2.0, 40), "f": random.uniform(0.5, 5.0, 40)}
    points["phi"] = random.uniform(-7.0, 7.0, 40)
    d, f = points["d"], points["f"]
    slope = d / (2 * f)  # of the parabola x^2 = 4 f z at x = d; the normal is (-slope, 1)
    lines = np.stack([np.stack([-slope, 0 * d], -1), np.stack([1 + 0 * d, -1 + 0 * d], -1)], -2)
    start = np.stack([d, d**2 / (4 * f)], -1)
    met = np.linalg.solve(lines, -start[..., None])[..., 1, 0]
    book = text_book(z_G)
    found = np.array([float(book(row)[0]) for row in rows_of(points)])
    yield compare(
        "the normal of the facet's point meets the axis at G", "NumPy", found, met, 1e-13, points
    )
