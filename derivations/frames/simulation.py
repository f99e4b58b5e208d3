"""The frames once more: SciPy turns the axes, ERFA brings the angles into their turn."""

import numpy as np

from armillary.verify.engines import each, need
from armillary.verify.measured import compare

COUNT = 200


def checks(kernels):
    """Everything measured about the frames."""
    yield from each(kernels, axes_by_scipy, azimuths_by_erfa)


def axes_by_scipy(kernels):
    """Vectors carried over by rotation objects."""
    rotation = need("scipy.spatial.transform").Rotation
    v = np.random.default_rng(1).uniform(-10, 10, (COUNT, 3))
    # The axes are listed as they stand in East-North-Up; a vector's components are its shadows.
    south, east, west, up = (0, -1, 0), (1, 0, 0), (-1, 0, 0), (0, 0, 1)
    for outward, back, axes in (
        ("seu_from_enu", "enu_from_seu", (south, east, up)),
        ("wsu_from_enu", "enu_from_wsu", (west, south, up)),
    ):
        turn = rotation.from_matrix(np.array(axes, dtype=float))
        found = getattr(kernels, outward)(v=v).v
        yield compare(outward, "SciPy", found, turn.apply(v), 1e-14, {"v": v}, outward)
        found = getattr(kernels, back)(v=v).v
        yield compare(back, "SciPy", found, turn.inv().apply(v), 1e-14, {"v": v}, back)


def angles():
    """Random angles, quarter turns, and hairs below the ends of a turn."""
    random = np.random.default_rng(2).uniform(-20, 20, COUNT)
    hairs = np.nextafter([0.0, np.pi, -np.pi, 2 * np.pi], -10)
    return np.concatenate([random, np.arange(-8, 9) * np.pi / 2, hairs])


def azimuths_by_erfa(kernels):
    """Angles brought into their turn."""
    erfa, angle = need("erfa"), angles()
    south_west = kernels.azimuth_from_south_west(azimuth=angle).azimuth_south
    yield compare(
        "azimuth from south",
        "ERFA",
        south_west,
        erfa.anpm(angle - np.pi),
        1e-14,
        {"azimuth": angle},
        "azimuth_from_south_west",
        turn=True,
    )
    north_east = kernels.azimuth_from_north_east(azimuth_south=angle).azimuth
    yield compare(
        "azimuth from north",
        "ERFA",
        north_east,
        erfa.anp(angle + np.pi),
        1e-14,
        {"azimuth_south": angle},
        "azimuth_from_north_east",
        turn=True,
    )
    beyond = (north_east < 0) | (north_east >= 2 * np.pi)
    yield compare(
        "azimuth from north lies in [0, 2 pi)",
        "bounds",
        beyond,
        0.0,
        0.0,
        {"azimuth_south": angle},
        "azimuth_from_north_east",
    )
