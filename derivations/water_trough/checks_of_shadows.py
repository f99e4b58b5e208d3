"""Backtracking against rays that are shot from row to row."""

import numpy as np

from armillary import Status
from armillary.verify.measured import compare
from armillary.verify.points import chosen

from .checks_of_axis import about_axis, anywhere, axis_frame

COUNT = 2000
WIDTH = 1.7  # m, of a collector
ALONG = np.array([0.0, 1.0, 0.0])  # the axis, in its own frame
FREE = {"rotation_min": -3.2, "rotation_max": 3.2}
KERNEL = "single_axis_backtrack"


def fields():
    """Suns over fields of rows; gcr up to 1, the rows' plane sloping either way."""
    random = np.random.default_rng(91)
    return {
        **anywhere(COUNT, 92),
        "gcr": random.uniform(0.05, 1.0, COUNT),
        "cross_axis_tilt": random.uniform(-0.6, 0.6, COUNT),
    }


def neighbour(points):
    """From an axis to the next one: a level step of width over gcr, and down the slope."""
    step = WIDTH / points["gcr"]
    drop = step * np.tan(points["cross_axis_tilt"])
    return np.stack([step, np.zeros_like(step), -drop], axis=-1)


def sun_of(points):
    """The sun in the frame of the axis."""
    frames = axis_frame(points["axis_azimuth"], points["axis_tilt"])
    return frames.inv().apply(points["enu"])


def clearance(points, rotation):
    """Half widths by which rays to the sun pass a neighbour's axis, less one: below 0 they hit it.

    From nine places on a row a ray goes to the sun; it meets the plane of either neighbouring row
    at a distance from its axis. Of all rays that meet one on their way, the least distance.
    """
    across, sun, step = (
        about_axis(rotation).apply([1.0, 0.0, 0.0]),
        sun_of(points),
        neighbour(points),
    )
    along = np.broadcast_to(ALONG, across.shape)
    # A place on the row + t sun = the neighbour's axis + b across + c along.
    solver = np.linalg.inv(np.stack([across, along, -sun], axis=-1))
    least = np.full(len(rotation), np.inf)
    for place in np.linspace(-WIDTH / 2, WIDTH / 2, 9):
        for side in (-1.0, 1.0):
            b, _, t = np.moveaxis(
                np.einsum("nij,nj->ni", solver, place * across - side * step), -1, 0
            )
            least = np.where(t > 0, np.minimum(least, np.abs(b) / (WIDTH / 2) - 1), least)
    return least


def shadows_by_rays(kernels):
    """Between its neighbours a row is lit as a whole, and just so where it turned back."""
    points = fields()
    ideal = kernels.single_axis(**points_of_axis(points)).rotation
    found = kernels.single_axis_backtrack(**points, **FREE)
    before, after = clearance(points, ideal), clearance(points, found.rotation)
    turned = np.abs(found.rotation - ideal) > 0
    yield compare(
        "no ray from a row to the sun meets the next row", "rays",
        np.maximum(0.0, -after), 0.0, 1e-10, points, KERNEL,
    )  # fmt: skip
    yield compare(
        "where the rotation was turned back, the outermost ray meets the edge of the next row",
        "rays", after[turned], 0.0, 1e-10, chosen(points, turned), KERNEL, relative=False,
    )  # fmt: skip
    yield compare(
        "it is turned back just where rays met the next row before", "rays",
        turned != (before < 0), 0.0, 0.0, points, KERNEL,
    )  # fmt: skip
    yield from _towards_the_slope(points, ideal, found.rotation)


def points_of_axis(points):
    """Without what the true rotation does not need."""
    return {name: points[name] for name in ("enu", "axis_azimuth", "axis_tilt")}


def _towards_the_slope(points, ideal, rotation):
    """Of the two rotations that just clear, the one whose rows lie flatter on the slope."""
    above = np.cos(ideal - points["cross_axis_tilt"]) > 0
    slope = points["cross_axis_tilt"]
    other = np.abs(2 * ideal - rotation - slope)
    excess = np.maximum(0.0, np.abs(rotation - slope) - other)[above]
    yield compare(
        "it is turned towards the slope, where the sun is above the rows", "bounds",
        excess, 0.0, 1e-13, chosen(points, above), KERNEL,
    )  # fmt: skip


def rows_of_any_cover(kernels):
    """Rows very far apart, or far wider than their distance; slopes almost upright; odd suns."""
    suns = np.array([
        [0, 0, 1], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0.6, 0, 0.8], [-0.6, 0, 0.8],
        [1e-9, 0, 1], [0.0, 0.6, 0.8], [0, 0, -1],
    ], dtype=float)  # fmt: skip
    covers, slopes = np.array([1e-3, 0.5, 1.0, 1.5, 1e3]), np.array([-1.57, -0.3, 0, 0.3, 1.57])
    grid = np.meshgrid(np.arange(len(suns)), covers, slopes, [0.0, np.pi / 2], indexing="ij")
    which, gcr, slope, tilt = (g.ravel() for g in grid)
    points = {"enu": suns[which], "axis_azimuth": np.zeros(len(gcr)), "axis_tilt": tilt,
              "gcr": gcr, "cross_axis_tilt": slope}  # fmt: skip
    found = kernels.single_axis_backtrack(**points, **FREE)
    answers = np.stack([found.rotation, found.incidence], axis=1)
    yield compare(
        "every answer is finite, whatever the cover, the slope and the sun", "bounds",
        ~np.isfinite(answers) | (found.status < 0)[:, None], 0.0, 0.0, points, KERNEL,
    )  # fmt: skip
    alone = found.status == Status.SINGULAR
    yield compare(
        "in the line of the axis no row is turned back", "bounds",
        found.rotation[alone], 0.0, 0.0, chosen(points, alone), KERNEL,
    )  # fmt: skip
    # In the rows' plane the sun meets every row edge on: no ray leaves its plane.
    off = np.abs(np.cos(kernels.single_axis(**points_of_axis(points)).rotation - slope)) > 1e-2
    shone = (found.status == Status.OK) & (np.abs(slope) < 1) & off
    lit = clearance(chosen(points, shone), found.rotation[shone])
    yield compare(
        "rows wider than their distance clear each other too", "rays",
        np.maximum(0.0, -lit), 0.0, 1e-9, chosen(points, shone), KERNEL,
    )  # fmt: skip


def limits_of_the_stroke(kernels):
    """Limits of either sign, met or not; limits that exclude each other are refused."""
    points = fields()
    free = kernels.single_axis_backtrack(**points, **FREE).rotation
    random = np.random.default_rng(93)
    low = random.uniform(-1.6, 1.6, COUNT)
    high = low + random.uniform(0.0, 1.6, COUNT)
    within = {**points, "rotation_min": low, "rotation_max": high}
    found = kernels.single_axis_backtrack(**within)
    cut = np.clip(free, low, high)
    status = np.where(cut == free, Status.OK, Status.CLAMPED)
    yield compare(
        "the rotation is cut at limits of either sign, and that is told", "NumPy",
        np.stack([found.rotation, found.status], axis=1), np.stack([cut, status], axis=1), 0.0,
        within, KERNEL,
    )  # fmt: skip
    crossed = {**points, "rotation_min": high + 1e-6, "rotation_max": low}
    yield compare(
        "limits that exclude each other are refused", "bounds",
        kernels.single_axis_backtrack(**crossed).status, Status.UNREACHABLE, 0.0, crossed, KERNEL,
    )  # fmt: skip
