"""How low the universal joints of two drives must stand for a day without a singularity."""

import numpy as np

from armillary.verify.plots import Axis, Curve, Mark, Plot
from armillary.verify.study import Heading, Prose

from .study_basis import AUTUMN, NAMES, SPRING, day_of, mount, root

MM = 1e3
HEIGHTS = np.linspace(0.0, 0.7, 36)  # m


def heights(kernels, sun, parameters):
    """The least determinant of each day against the height of joints 1 and 2."""
    days = [day_of(kernels, sun, parameters, k) for k in range(len(NAMES)) if k != AUTUMN]
    curves, limits = [], {}
    for day in days:
        least = [least_determinant(kernels, parameters, day, height) for height in HEIGHTS]
        curves.append(Curve(day.name, MM * HEIGHTS, least))
        limits[day.name] = limit(kernels, parameters, day, least)
    yield Heading("Could two drives avoid the singularity?")
    yield Plot(
        "Least determinant of the Jacobian of legs 1 and 2 through the days, against the height of "
        "their universal joints; a day that is not crossed stays above 0.",
        "height, mm", Axis("determinant, m²"), curves,
        [Mark(0.0, "singular"), Mark(MM * parameters.mount.h[0], "here", across=True)],
    )  # fmt: skip
    yield Prose(words(limits, parameters.mount, noon_slope(kernels, sun, parameters)))


def least_determinant(kernels, parameters, day, height):
    """The least over a day, m^2, with joints 1 and 2 at a height."""
    h = np.array([height, height, parameters.mount.h[2]])
    size = mount(parameters, h=h)
    return float(np.min(kernels.singularity(**day.pose, **size).det_2))


def limit(kernels, parameters, day, least):
    """The height below which a day is not crossed, m; None where there is none above ground."""
    rises = [k for k in range(len(least) - 1) if least[k] > 0 >= least[k + 1]]
    if not rises:
        return None
    ends = HEIGHTS[rises[0]], HEIGHTS[rises[0] + 1]
    return float(root(lambda x: least_determinant(kernels, parameters, day, x), *ends))


def noon_slope(kernels, sun, parameters):
    """Angle of leg 1 above the level at noon of the equinox, degrees."""
    day, size = day_of(kernels, sun, parameters, SPRING), mount(parameters)
    noon = {name: of[len(day.clock) // 2] for name, of in day.pose.items()}
    # The height of a joint of the platform hangs on the tilt alone.
    above_o = size["r"][0] * np.sin(size["phi"][0]) * np.sin(noon["beta"])
    up = size["h_0"] + above_o - size["h"][0]
    return float(np.degrees(np.arcsin(up / kernels.leg_lengths(**noon, **size).q[0])))


def words(limits, mounted, slope):
    """What the paper's non-redundant mechanism could have been."""
    free = "; ".join(
        f"{name}: below {MM * height:.0f} mm" if height is not None else f"{name}: at no height"
        for name, height in limits.items()
    )
    side = "above" if slope > 0 else "below"
    crossed = limits[NAMES[SPRING]] is None or mounted.h[0] >= limits[NAMES[SPRING]]
    return (
        f"Joints 1 and 2 stand at {MM * mounted.h[0]:.0f} mm, o at {MM * mounted.h_0:.0f} mm; at "
        f"noon of the equinox leg 1 points {abs(slope):.0f} degrees {side} the level. A day is "
        f"free of the singularity with the joints so low ({free}). "
        + (
            "The paper compares its mechanism with one whose drives are badly placed, and the "
            "third leg is worth the more for it."
            if crossed
            else "Joints as low as here hold the platform through the equinox of the comparison."
        )
    )
