"""What single precision costs: rod lengths in f32 against 50 digits."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Axis, Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .days import PHI, mount

COUNT = 1000
SEED = 32
STEEP = 75.0  # degrees, as far as the sun of the study goes
DIGITS = 50
MICRO = 1e-6
BINS = np.arange(0.0, STEEP + 1, 7.5)


def precision(kernels, native, parameters):
    """Errors of the f32 kernels, of the f64 one, and of the angles' own rounding."""
    size, angles = points(kernels, parameters)
    exact = truth(size, angles)
    whole = {name: np.asarray(value, dtype=float) for name, value in {**size, **angles}.items()}
    errors = {
        name: np.abs(np.asarray(made.rod_lengths(**size, **angles).l, dtype=float) - exact)
        for name, made in (("C, f32", native), ("Python, float32", kernels))
    }
    double = np.abs(native.rod_lengths(**whole).l - exact).max()
    yield Heading("What does single precision cost?")
    yield Table(
        f"Error of rod lengths at {COUNT} random attitudes up to {STEEP:g} degrees of tilt, "
        f"against {DIGITS} digits by mpmath; the inputs are float32 numbers.",
        ["kernel", Column("largest", "µm", ".2g"), Column("root mean square", "µm", ".2g")],
        [
            (name, e.max() / MICRO, np.sqrt(np.mean(e**2)) / MICRO) for name, e in errors.items()
        ],
    )  # fmt: skip
    yield by_tilt(angles, errors)
    # Half a unit of the last place of an angle up to pi, times the longest arm.
    turn = float(np.spacing(np.float32(np.pi))) / 2 * float(size["d"] + size["r_m"])
    worst = errors["C, f32"].max() / MICRO
    yield Prose(
        f"**In f32 a rod is within {worst:.2f} µm**; one unit in the last place of a length of 2 "
        f"to 4 m is {np.spacing(np.float32(3)) / MICRO:.2f} µm, and an encoder's step "
        f"{parameters.plant.encoder / MICRO:g} µm. In f64 it is within "
        f"{10 ** np.ceil(np.log10(max(double, 1e-15))):.0e} m. Angles that are rounded to float32 "
        f"before they come in add up to about {turn / MICRO:.2f} µm more; an azimuth that is kept "
        "within half a turn keeps that so."
    )


def points(kernels, parameters):
    """Dimensions, and random attitudes each with one of the facets, as float32."""
    size = {name: np.float32(value) for name, value in mount(kernels, parameters).items()}
    random = np.random.default_rng(SEED)
    return size, {
        "alpha": random.uniform(-np.pi, np.pi, COUNT).astype(np.float32),
        "beta": np.radians(random.uniform(0.0, STEEP, COUNT)).astype(np.float32),
        "phi": PHI.astype(np.float32)[random.integers(4, size=COUNT)],
    }


def by_tilt(angles, errors):
    """The largest error in classes of the tilt."""
    tilt = np.degrees(angles["beta"])
    place = np.digitize(tilt, BINS) - 1
    return Plot(
        "Largest error of the rods in single precision by the tilt of the dish.",
        "tilt, degrees", Axis("error, µm", low=0.0),
        [
            Curve(name, (BINS[:-1] + BINS[1:]) / 2,
                  [errors[name][place == k].max() / MICRO for k in range(len(BINS) - 1)], "both")
            for name in errors
        ],
    )  # fmt: skip


def truth(size, angles):
    """Rod lengths by the joints' places, not by the closed form of the kernel."""
    mpmath = need("mpmath")
    with mpmath.workdps(DIGITS):
        lengths = {name: mpmath.mpf(float(value)) for name, value in size.items()}
        found = [
            rods(mpmath, lengths, *(mpmath.mpf(float(angles[k][i])) for k in angles))
            for i in range(len(angles["alpha"]))
        ]
        return np.array([[float(l) for l in three] for three in found])


def rods(mp, size, alpha, beta, phi):
    """The three rods of one facet: a tilt takes the vertical to the dish's normal."""
    f, d, z_O = size["f"], size["d"], size["z_O"]
    dish = turn(mp, alpha) * lean(mp, beta) * turn(mp, -alpha)
    point = mp.matrix([d * mp.cos(phi), d * mp.sin(phi), d * d / (4 * f)])
    slope = mp.matrix([-d * mp.cos(phi), -d * mp.sin(phi), 2 * f]) / mp.sqrt(d * d + 4 * f * f)
    n = turn(mp, mp.pi - phi) * (dish * slope)
    azimuth = mp.atan2(n[1], n[0])
    R = turn(mp, azimuth) * lean(mp, mp.acos(n[2])) * turn(mp, -azimuth)
    # The first S-joint in its plane, and the other two alike.
    M = mp.matrix(
        [size["r_m"] * (R[0, 0] - R[1, 1]) / 2, -size["r_m"] * R[1, 0], z_O + (dish * point)[2]]
    )
    for k in range(3):
        out = mp.matrix([mp.cos(2 * k * mp.pi / 3), mp.sin(2 * k * mp.pi / 3), 0])
        yield mp.norm(M + size["r_m"] * (R * out) - size["r_b"] * out)


def turn(mp, angle):
    """Rz."""
    c, s = mp.cos(angle), mp.sin(angle)
    return mp.matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def lean(mp, angle):
    """Ry."""
    c, s = mp.cos(angle), mp.sin(angle)
    return mp.matrix([[c, 0, s], [0, 1, 0], [-s, 0, c]])
