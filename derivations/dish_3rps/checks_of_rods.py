"""The rods of the study: the paper's extremes, the height, symmetry, f32, and aimed facets."""

from pathlib import Path

import numpy as np

from armillary.verify.measured import compare
from armillary.verify.parameters import read_parameters

from .days import PHI, mount, whole_study
from .searches import differential_evolution, local
from .study_height import Rods, feasible, objectives
from .study_precision import STEEP, truth

COUNT = 200
CORNERS = 420.0  # minutes: both ends of the tracking, where the extremes are
MILLI = 1e-3


def given(kernels):
    """The study's parameters, and the dimensions that follow."""
    parameters = read_parameters(Path(__file__).with_name("parameters.toml"))
    return parameters, mount(kernels, parameters)


def attitudes(seed):
    """Attitudes of the work space, each for a facet at random."""
    random = np.random.default_rng(seed)
    return {
        "alpha": random.uniform(-np.pi, np.pi, COUNT),
        "beta": np.radians(random.uniform(0.0, STEEP, COUNT)),
        "phi": random.uniform(-np.pi, np.pi, COUNT),
    }


def extremes_of_the_paper(kernels):
    """Shortest and longest rod of the nominal set on the four days."""
    from armillary_kernels import sun

    parameters, size = given(kernels)
    limits = parameters.rods
    l = kernels.rod_lengths_all(**whole_study(kernels, sun, parameters), **size).l
    yield compare(
        "the nominal rods span the paper's shortest and longest", "the paper, section 5.2",
        [l.min(), l.max()], [limits.found_shortest, limits.found_longest], 1e-3,
        {"end": [0.0, 1.0]}, "rod_lengths_all", relative=False,
    )  # fmt: skip


def height_by_two_searches(kernels):
    """Each objective has its least value where differential evolution finds it, to 1e-3 mm."""
    from armillary_kernels import sun

    parameters, _ = given(kernels)
    rods = Rods(kernels, sun, parameters, CORNERS)
    low, high = feasible(rods, parameters.rods)
    ends = [rods.ends(low)[0], rods.ends(high)[1]]
    yield compare(
        "at the ends of the feasible heights a rod is at its limit", "SciPy", ends,
        [parameters.rods.shortest, parameters.rods.longest], 1e-9, {"end": [0.0, 1.0]},
        "rod_lengths_all",
    )  # fmt: skip
    found, wanted = [], []
    for objective in objectives(parameters):

        def value(z, of=objective.of):
            return of(rods.at(z))

        found.append(differential_evolution(value, low, high).best)
        wanted.append(local(value, low, high))
    yield compare(
        "differential evolution ends at the optimum of the bracketing search", "SciPy", found,
        wanted, 1e-3 * MILLI, {"objective": np.arange(float(len(found)))}, "rod_lengths_all",
        relative=False,
    )  # fmt: skip


def squares_over_the_height(kernels):
    """l^2 is a square of z_O plus a number: so the rods grow with the height while they point up.

    The second difference of a quadratic is exact for any step.
    """
    _, size = given(kernels)
    points, step = attitudes(71), 0.25
    below, here, above = (
        kernels.rod_lengths(**points, **{**size, "z_O": size["z_O"] + k * step}).l ** 2
        for k in (-1, 0, 1)
    )
    yield compare(
        "the square of a rod over the height bends by 2", "second difference",
        (above - 2 * here + below) / step**2, 2.0, 1e-12, points, "rod_lengths",
    )  # fmt: skip


def facets_by_turning(kernels):
    """Turned by a quarter with the dish, each facet becomes the next."""
    _, size = given(kernels)
    points = attitudes(72)
    alpha, beta = points["alpha"], points["beta"]
    four = kernels.rod_lengths_all(alpha=alpha, beta=beta, **size).l
    turned = kernels.rod_lengths_all(alpha=alpha + np.pi / 2, beta=beta, **size).l
    yield compare(
        "a quarter turn of the dish passes the rods on to the next facet", "symmetry",
        np.roll(turned, -1, axis=1), four, 1e-14, points, "rod_lengths_all",
    )  # fmt: skip
    one_by_one = kernels.rod_lengths(alpha=alpha[:, None], beta=beta[:, None], phi=PHI, **size).l
    yield compare(
        "the four facets together are the facets one by one", "rod_lengths", four, one_by_one,
        1e-15, points, "rod_lengths_all",
    )  # fmt: skip
    mirrored = {"alpha": 2 * points["phi"] - alpha, "beta": beta, "phi": points["phi"]}
    yield compare(
        "in the mirror of the facet's own plane rods 2 and 3 change places", "symmetry",
        kernels.rod_lengths(**mirrored, **size).l[:, [0, 2, 1]],
        kernels.rod_lengths(**points, **size).l, 1e-14, points, "rod_lengths",
    )  # fmt: skip


def rods_in_single_precision(kernels):
    """float32 rods against 50 digits, at inputs that float32 holds."""
    _, size = given(kernels)
    size = {name: np.float32(value) for name, value in size.items()}
    points = {name: a.astype(np.float32) for name, a in attitudes(73).items()}
    found = np.asarray(kernels.rod_lengths(**points, **size).l, dtype=float)
    yield compare(
        "rods in float32 are within 5 micrometres", "mpmath", found, truth(size, points), 5e-6,
        points, "rod_lengths", relative=False,
    )  # fmt: skip
    whole = {k: np.asarray(v, dtype=float) for k, v in {**size, **points}.items()}
    yield compare(
        "rods by joints that are placed one after the other", "mpmath",
        kernels.rod_lengths(**whole).l, truth(size, points), 1e-14, points, "rod_lengths",
    )  # fmt: skip


def rays_of_aimed_facets(kernels):
    """The ray of an aimed facet goes through the focus; that of a dish normal does not."""
    _, size = given(kernels)
    points = attitudes(74)
    alpha, beta = points["alpha"], points["beta"]
    c = np.stack(
        [np.cos(alpha) * np.sin(beta), np.sin(alpha) * np.sin(beta), np.cos(beta)], axis=-1
    )
    focus = np.array([0.0, 0.0, size["z_O"]]) + size["f"] * c
    aimed, own = kernels.aim_at_receiver(**points, **size), kernels.facet(**points, **size)

    def passes(pose):
        n = pose.H_R_M[..., 2]
        beam = 2 * np.sum(c * n, axis=-1, keepdims=True) * n - c
        return np.linalg.norm(np.cross(beam, focus - pose.M), axis=-1)

    yield compare(
        "the central ray of a facet that is aimed goes through the focus", "reflection",
        passes(aimed), 0.0, 1e-12, points, "aim_at_receiver",
    )  # fmt: skip
    told = kernels.central_ray(**points, **size)
    yield compare(
        "the central ray of a facet with the dish's normal passes the focus so", "reflection",
        told.miss, passes(own), 1e-13, points, "central_ray",
    )  # fmt: skip
    sine = passes(own) / np.linalg.norm(focus - own.M, axis=-1)
    yield compare(
        "and by this angle, which is acute", "reflection", told.miss_angle, np.arcsin(sine), 1e-12,
        points, "central_ray",
    )  # fmt: skip
    yield compare(
        "aimed or not, the facet's point is as high as the dish's", "facet", aimed.M[:, 2],
        own.M[:, 2], 1e-14, points, "aim_at_receiver",
    )  # fmt: skip
