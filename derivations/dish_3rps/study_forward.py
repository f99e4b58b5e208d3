"""From rods to pose: how far a guess may be off, and how many steps the search takes."""

from itertools import pairwise

import numpy as np

from armillary.verify.plots import Curve, HeatMap, Panels, centres
from armillary.verify.study import Column, Heading, Prose, Table

from .days import LONGEST_DAY, apart, attitude, four, hours, mount, toward
from .drawing import CIRCLE

YEAR = np.arange(1, 366)
COARSE = 30.0  # minutes, through the year
SEED = 59
OFF = (1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0)  # degrees, of the guessed axis
EDGES = (0.0, 30.0, 45.0, 60.0, 75.0)  # degrees, classes of the dish's tilt
LIFT = 0.1  # m, of the guessed height, either way
RIGHT = 1e-6  # rad, within which the pose found is the right one
MICRON = 1e-6
STEPS = 8  # of the kernel
CASES = ((LONGEST_DAY, 12.0), (355, 9.0))


def forward(kernels, sun, parameters):
    """Maps of the basin, its size in a table, and the steps that are needed."""
    size = mount(kernels, parameters)
    yield Heading("From rods to pose: how good must the guess be?")
    yield maps(kernels, sun, parameters, size)
    rows, sure = basin(kernels, sun, parameters, size)
    yield Table(
        "Share of searches that end at the right pose, by how far the guessed axis of the dish is "
        "off and by the tilt of the dish; share of all that end at another pose; and steps to 1 µm "
        "of those that end right, counted with a copy of the search in NumPy. Rods of all four "
        "facets through the year.",
        [
            Column("axis off by", "degrees", ".0f"),
            *(Column(f"tilt {low:g} to {high:g}", "%", ".2f") for low, high in pairwise(EDGES)),
            Column("another pose", "%", ".2f"), Column("steps to 1 µm, mean", "", ".1f"),
            Column("most", "", ".0f"),
        ],
        rows,
    )  # fmt: skip
    home, before = from_home(kernels, sun, parameters, size)
    words = ", ".join(f"{off:g} degrees up to a tilt of {edge:g}" for edge, off in sure.items())
    yield Prose(
        "The guess is off in a random direction, and in height by up to "
        f"{LIFT:g} m. **Every search ended at the right pose that began within {words}.** The "
        "basin narrows towards the singularity. From the home pose ($\\alpha = \\beta = 0$, no "
        f"special point for this search) {100 * home:.2f}% of the year's poses are found, from the "
        f"pose {COARSE:g} minutes before {100 * before:.2f}%. Newton's method doubles the digits "
        f"once it is near: the kernel's {STEPS} steps are a fixed count, and what has not ended "
        "on rods of the given lengths by then is told as NOT_CONVERGED. Another pose on the same "
        "rods is a true answer, of which the rods know nothing; only the guess decides."
    )


# -- one search, step by step ---------------------------------------------------------------------


def steps_needed(size, own, guess):
    """Steps until all rods are within a micron, from half tilts; STEPS + 1 if never.

    The half tilt is (n_x, n_y) / (1 + n_z); with the height of M it fixes the pose.
    """
    lengths, needed = rods_of(size, own), np.full(own.shape[:-1], STEPS + 1)
    q = guess.copy()
    for step in range(STEPS + 1):
        gap = rods_of(size, q) - lengths
        done = (np.abs(gap) < MICRON).all(axis=-1)
        needed = np.where(done & (needed > step), step, needed)
        J = np.stack(
            [(rods_of(size, q + e) ** 2 - rods_of(size, q - e) ** 2) / 2e-6
             for e in 1e-6 * np.eye(3)], axis=-1,
        )  # fmt: skip
        square = rods_of(size, q) ** 2 - lengths**2
        flat = np.abs(np.linalg.det(J)) < 1e-12
        J = np.where(flat[..., None, None], np.eye(3), J)
        q = q - np.linalg.solve(J, square[..., None])[..., 0]
        q = np.clip(q, (-2.0, -2.0, 0.0), (2.0, 2.0, 2000.0))
    return needed


def rods_of(size, q):
    """Lengths of the rods by half tilt and height."""
    shrink = 1 / (1 + q[..., :1] ** 2 + q[..., 1:2] ** 2)
    w = q[..., :2] @ CIRCLE[:, :2].T
    reach = size["r_m"] * (2 - shrink - 4 * w * w * shrink) - size["r_b"]
    return np.hypot(reach, q[..., 2:] - 2 * size["r_m"] * w * shrink)


def half_tilt(kernels, size, angles):
    """Where a pose stands in these coordinates."""
    pose = kernels.facet(**angles, **size)
    phi = np.asarray(angles["phi"]) - np.pi
    n = pose.H_R_M[..., 2]
    lean = 1 + n[..., 2]
    x, y = (
        np.cos(phi) * n[..., 0] + np.sin(phi) * n[..., 1],
        np.cos(phi) * n[..., 1] - np.sin(phi) * n[..., 0],
    )
    return np.stack([x / lean, y / lean, pose.M[..., 2]], axis=-1)


# -- the kernel -----------------------------------------------------------------------------------


def search(kernels, size, angles, guess):
    """The kernel's answer for the rods of a pose: right, another, none; boolean arrays."""
    own = kernels.facet(**angles, **size).H_R_M[..., 2]
    lengths = kernels.rod_lengths(**angles, **size).l
    start = np.stack(np.broadcast_arrays(guess["alpha"], guess["beta"], guess["z_O"]), axis=-1)
    found = kernels.forward(l=lengths, guess=start, phi=angles["phi"], **size)
    none = found.status < 0
    right = ~none & (apart(np.nan_to_num(found.H_R_M[..., 2]), own) < RIGHT)
    return right, ~none & ~right, none


def maps(kernels, sun, parameters, size):
    """Where the search ends, over the guessed attitude."""
    azimuth, tilt = np.arange(-180.0, 181.0, 7.5), np.arange(0.0, 121.0, 4.0)
    a, b = np.meshgrid(np.radians(centres(azimuth)), np.radians(centres(tilt)))
    panels = []
    for day, hour in CASES:
        target = attitude(kernels, sun, parameters, day, np.array(hour))
        angles = {**target, "phi": np.zeros_like(a)}
        guess = {"alpha": a, "beta": b, "z_O": size["z_O"]}
        right, _, _ = search(kernels, size, angles, guess)
        own = half_tilt(kernels, size, {k: v + 0 * a for k, v in angles.items()})
        start = half_tilt(kernels, size, {"alpha": a, "beta": b, "phi": angles["phi"]})
        needed = np.where(right, steps_needed(size, own, start), np.nan)
        mark = Curve("pose", [np.degrees(target["alpha"])], [np.degrees(target["beta"])], "points")
        panels.append(
            HeatMap(
                f"day {day}, {hour:g} h", "guessed azimuth, degrees", "guessed tilt, degrees",
                "steps to 1 µm", azimuth, tilt, needed, tuple(range(STEPS + 2)), curves=[mark],
            )
        )  # fmt: skip
    return Panels(
        "Steps until the rods of facet +X are within a micron, by the guessed attitude of the "
        "dish; no colour where it ends elsewhere or nowhere. The pose is marked 'pose'. "
        "Counted with a copy of the search in NumPy.",
        panels,
    )


def basin(kernels, sun, parameters, size):
    """A row for each distance of the guess, and the largest that never failed."""
    random = np.random.default_rng(SEED)
    clock = hours(parameters, COARSE)
    c = toward(sun, parameters, YEAR[:, None], clock).reshape(-1, 3)
    looked = aimed(kernels, c)
    angles, tilt = four(looked), np.degrees(looked["beta"])
    own = half_tilt(kernels, size, angles)
    rows, sure = [], dict.fromkeys(EDGES[1:], 0.0)
    for off in OFF:
        guessed = aimed(kernels, astray(random, c, np.radians(off)))
        height = size["z_O"] + random.uniform(-LIFT, LIFT, len(c))[:, None]
        guess = {name: a[:, None] for name, a in guessed.items()} | {"z_O": height}
        right, other, _ = search(kernels, size, angles, guess)
        start = half_tilt(kernels, {**size, "z_O": height}, four(guessed))
        needed = steps_needed(size, own, start)[right]
        shares = []
        for low, high in pairwise(EDGES):
            some = right[(tilt >= low) & (tilt < high)]
            shares.append(100 * some.mean())
            if some.all() and sure[high] == OFF[len(rows) - 1] * (len(rows) > 0):
                sure[high] = off
        rows.append((off, *shares, 100 * other.mean(), needed.mean(), needed.max()))
    return rows, sure


def aimed(kernels, c):
    """Angles of a dish that looks along c."""
    found = kernels.aim(enu=c)
    return {"alpha": found.alpha, "beta": found.beta}


def astray(random, c, off):
    """Unit vectors at an angle from c, in random directions."""
    across = np.cross(c, random.normal(size=c.shape))
    across = across / np.linalg.norm(across, axis=-1, keepdims=True)
    return np.cos(off) * c + np.sin(off) * across


def from_home(kernels, sun, parameters, size):
    """Share of right poses from the home pose, and from the pose before."""
    clock = hours(parameters, COARSE)
    whole = attitude(kernels, sun, parameters, YEAR[:, None], clock)
    z = size["z_O"]
    still = {"alpha": np.zeros(1), "beta": np.zeros(1), "z_O": z}
    home = search(kernels, size, four(whole), still)[0]
    later = four({name: a[:, 1:] for name, a in whole.items()})
    before = {name: a[:, :-1, None] for name, a in whole.items()}
    return home.mean(), search(kernels, size, later, {**before, "z_O": z})[0].mean()
