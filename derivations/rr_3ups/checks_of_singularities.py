"""Where drives do not hold the platform and legs have no direction: statuses, finite results."""

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare

from .checks_of_kinematics import MOTION
from .reference import UP, about, determinant, ends, jacobian, slopes, spin_free_motion, times
from .samples import ACCELERATIONS, RATES, TABLE, call, joined, of_table
from .solved import least_norm, solve

MOUNTED = 0.7  # rad, of the universal joints where legs stand along their axes
HELD = 1e-5  # what the derivation states: a part of the sum of r squared
SITE = np.radians(40.0)  # latitude of the paper's site
QUARTER = np.radians(1e-3)  # rad of the sun's hour angle: a quarter of a second
THREE = {"forces": "F", "forces_spin_free": "F", "power": "P", "internal_forces": "N"}
TWO = {"forces_two_legs": "F", "power_two_legs": "P"}
REGULAR = {"generalized_force": "tau", "mass_matrix": "H", "bias": "tau_0", "jacobian": "J"}
LOAD = {"n_d": np.array([10.0, -20.0, 30.0])}


def home_pose(kernels):
    """At home the first two legs point at the column's axis and hold nothing; one drive is left."""
    turns = np.linspace(-np.pi, np.pi, 9)[:, None]
    points = of_table(np.zeros((9, 2)), **LOAD)
    for name in ("theta", "phi"):  # the whole machine, turned about its column
        points[name] = points[name] + turns
    second = np.linalg.svd(call(kernels.jacobian, points).J, compute_uv=False)[:, 1]
    yield compare(
        "J has rank 1 at home", "NumPy", second, 0.0, 1e-15, points, "jacobian", relative=False
    )
    yield from _told(kernels, {**THREE, **TWO}, points, Status.SINGULAR, "at home nothing holds")
    yield from _told(kernels, REGULAR, points, Status.OK, "at home nothing else is singular")
    for kernel, name in {**THREE, **TWO}.items():
        yield compare(
            "at home drives are given no force", "geometry",
            getattr(call(getattr(kernels, kernel), points), name), 0.0, 0.0, points, kernel,
        )  # fmt: skip


def around_home(kernels):
    """Drives let go where the columns of J span less than the stated area, and only there."""
    random = np.random.default_rng(31)
    away = 10.0 ** random.uniform(-8.0, 0.0, (400, 2)) * random.choice([-1.0, 1.0], (400, 2))
    points = of_table(away, **LOAD)
    J = jacobian(points)
    for held, area, count in (
        (THREE, np.prod(np.linalg.svd(J, compute_uv=False), axis=1), 3),
        (TWO, np.abs(determinant(J)), 2),
    ):
        bound = HELD * np.sum(TABLE["r"][:count] ** 2)
        clear = np.abs(area / bound - 1) > 1e-3
        near = {name: value[clear] for name, value in points.items()}
        wanted = np.where(area[clear] > bound, Status.OK, Status.SINGULAR)
        what = f"around home {count} drives let go within {bound:.2g} m^2"
        yield from _told(kernels, held, near, wanted, what)
        yield from _finite(kernels, held, near, "around home")


# -- two legs -------------------------------------------------------------------------------------


def two_legs_by_roots(kernels):
    """Both sides of the two-leg singular set, from points on it that SciPy finds."""
    tilts = np.radians(np.linspace(-85.0, 85.0, 86))  # none of them is 0, where all alpha are
    ways = [_at(alpha) for alpha in np.radians(np.linspace(-176.0, 176.0, 46))]
    roots = np.concatenate([way(_places(way, tilts)) for way in ways])
    points = of_table(roots, **LOAD)
    what = "on the two-leg singular set"
    yield from _told(kernels, TWO, points, Status.SINGULAR, f"{what} two drives let go")
    yield from _told(kernels, THREE, points, Status.OK, f"{what} three drives hold")
    slope = slopes(_areas, points)
    steep = np.linalg.norm(slope, axis=1, keepdims=True)
    edge = HELD * np.sum(TABLE["r"][:2] ** 2) / steep  # rad
    for part, status, claim in (
        (0.5, Status.SINGULAR, "half the stated distance off the two-leg singular set"),
        (2.0, Status.OK, "twice the stated distance off the two-leg singular set"),
    ):
        step = part * edge * slope / steep
        near = of_table(np.concatenate([roots - step, roots + step]), **LOAD)
        yield from _told(kernels, TWO, near, status, claim)
        yield from _finite(kernels, TWO, near, claim)


def equinox_path(kernels):
    """The sun's path of an equinox crosses the two-leg singular set twice; three legs hold."""
    hours = np.radians(np.linspace(-89.0, 89.0, 357))
    points = of_table(_equinox(hours))
    sign = np.sign(call(kernels.singularity, points).det_2)
    yield compare(
        "crossings of the two-leg singular set on an equinox", "NumPy",
        np.count_nonzero(sign[1:] != sign[:-1]), 2, 0.0, {"hours": len(hours)}, "singularity",
        relative=False,
    )  # fmt: skip
    crossings = _places(_equinox, hours)
    yield from _told(
        kernels, TWO, of_table(_equinox(crossings)), Status.SINGULAR, "where an equinox crosses"
    )
    yield from _told(kernels, THREE, points, Status.OK, "all along an equinox three drives hold")
    before, after = (of_table(_equinox(crossings + off)) for off in (-QUARTER, QUARTER))
    what = "a quarter of a second before and after two drives hold"
    yield from _told(kernels, TWO, joined(before, after), Status.OK, what)
    push, pull = (call(kernels.forces_two_legs, side).F for side in (before, after))
    yield compare(
        "and their forces have changed sign, as large as before", "geometry", pull, -push, 1e-3,
        before, "forces_two_legs",
    )  # fmt: skip


def singularity_by_numpy(kernels):
    """The measures of what holds, over the whole plane of the angles."""
    points = of_table(np.random.default_rng(33).uniform([-3.2, -1.6], [3.2, 1.6], (300, 2)))
    J = jacobian(points)
    found = call(kernels.singularity, points)
    for name, wanted in (
        ("det_2", determinant(J)),
        ("sigma_min", np.linalg.svd(J, compute_uv=False)[:, -1]),
    ):
        yield compare(
            f"{name} of the Jacobian", "NumPy", getattr(found, name), wanted, 1e-12, points,
            "singularity",
        )  # fmt: skip


def _areas(points):
    """The determinant of two legs in a form that complex steps pass: from the gradient of q^2."""
    P, Q = ends(points)
    arm = P - points["h_0"][:, None, None] * UP
    level = about(2, points["alpha"])[..., 0][:, None]
    reach = P - Q
    rows = [np.sum(np.cross(axis + 0 * arm, arm) * reach, axis=-1) for axis in (UP, level)]
    size = np.sqrt(np.sum(reach**2, axis=-1))
    first, second = (row / size for row in rows)
    return first[:, 0] * second[:, 1] - second[:, 0] * first[:, 1]


def _at(alpha):
    """Angles of one alpha and given tilts."""
    return lambda beta: np.stack([alpha + 0 * beta, beta], axis=-1)


def _equinox(hour):
    """Attitudes on the sun's path at declination 0; hour angles in rad."""
    east, north = -np.sin(hour), -np.sin(SITE) * np.cos(hour)
    return np.stack([np.arctan2(east, -north), np.arccos(np.cos(SITE) * np.cos(hour))], axis=-1)


def _places(path, places):
    """Where on a path the determinant of two legs changes its sign, as exact as floats are."""
    brentq = need("scipy.optimize").brentq

    def area(place):
        return float(_areas(of_table(path(np.atleast_1d(place))))[0])

    found = _areas(of_table(path(places)))
    changes = np.flatnonzero(np.sign(found[1:]) != np.sign(found[:-1]))
    return np.array([brentq(area, places[k], places[k + 1], xtol=1e-15) for k in changes])


# -- legs without length or direction -------------------------------------------------------------


def legs_without_direction(kernels):
    """A leg of no length, and a leg along the first axis of its universal joint, are told."""
    points = of_table(np.random.default_rng(34).uniform(-1.0, 1.0, (20, 2)), **LOAD)
    points["zeta"][:] = MOUNTED
    joints, axis = ends(points)[0], times(about(1, MOUNTED), UP)

    def stood(off, legs=(0, 1, 2)):
        return joined(*(_moved(points, leg, joints[:, leg] - off) for leg in legs))

    told = {**THREE, **REGULAR, "leg_motion": "omega"}
    yield from _told(kernels, told, stood(0 * axis), Status.UNREACHABLE, "a leg has no length")
    yield from _told(
        kernels, TWO, stood(0 * axis, (0, 1)), Status.UNREACHABLE, "a leg of two has no length"
    )
    absent = stood(0 * axis, (2,))
    yield from _told(kernels, TWO, absent, Status.OK, "of two legs the third is absent")
    yield from _finite(kernels, TWO, absent, "where the third of two legs has no length")
    turning = {name: told[name] for name in told if name not in ("jacobian", "internal_forces")}
    along = joined(stood(0.5 * axis), stood(-0.5 * axis))
    yield from _told(
        kernels, turning, along, Status.UNREACHABLE, "a leg stands along its joint's first axis"
    )
    for name in RATES + ACCELERATIONS:
        along[name] = np.random.default_rng(36).uniform(-3.0, 3.0, len(along[name]))
    found = call(kernels.leg_motion_spin_free, along)
    what = "a leg that does not spin moves along its joint's first axis too"
    yield from _told(kernels, {"leg_motion_spin_free": "omega"}, along, Status.OK, what)
    with np.errstate(invalid="ignore"):  # the reference's joint axes, which this does not ask for
        wanted = spin_free_motion(along)
    for name, value in zip(MOTION, wanted, strict=True):
        yield compare(
            f"{what}: {name}", "NumPy", getattr(found, name), value, 1e-13, along,
            "leg_motion_spin_free",
        )  # fmt: skip


def legs_nearly_along(kernels):
    """A thousandth of a radian beside its joint's first axis a leg turns as pinocchio says.

    Rounding grows there with the tangent squared, by a million.
    """
    points = of_table(np.random.default_rng(35).uniform(-1.0, 1.0, (20, 2)), **LOAD, alpha_dot=0.1)
    points["zeta"][:] = MOUNTED
    off = 0.5 * times(about(1, MOUNTED), UP) + [0.0, 5e-4, 0.0]
    joints = ends(points)[0]
    beside = joined(*(_moved(points, leg, joints[:, leg] - off) for leg in range(3)))
    yield compare(
        "tau with a leg a thousandth of a radian beside its joint's first axis", "pinocchio",
        call(kernels.generalized_force, beside).tau, solve(beside).tau, 1e-8, beside,
        "generalized_force",
    )  # fmt: skip


def _moved(points, leg, foot):
    """Machines whose universal joint of one leg stands at a point."""
    found = {**points, **{name: points[name].copy() for name in ("R", "theta", "h")}}
    found["R"][:, leg] = np.hypot(foot[:, 0], foot[:, 1])
    found["theta"][:, leg] = np.arctan2(foot[:, 1], foot[:, 0])
    found["h"][:, leg] = foot[:, 2]
    return found


def awkward_motions(kernels):
    """At rest, level, at whole and quarter turns: the same forces as pinocchio's."""
    quarters = np.array([0.0, np.pi / 2, np.pi, -np.pi / 2, -np.pi])
    pairs = [(alpha, beta) for alpha in quarters for beta in (0.0, 0.4, -0.4)]
    pairs = np.array([pair for pair in pairs if pair != (0.0, 0.0)])
    for what, motion in (
        ("at rest", {}),
        ("at a steady turn", {"alpha_dot": 3.0}),
        ("from rest", {"alpha_ddot": 5.0, "beta_ddot": -5.0}),
    ):
        points = of_table(pairs, r_sc=np.array([0.05, -0.1, 0.1]), **LOAD, **motion)
        solved = solve(points)
        tau = call(kernels.generalized_force, points).tau
        yield compare(
            f"tau {what} at awkward angles", "pinocchio", tau, solved.tau, 1e-12, points,
            "generalized_force",
        )  # fmt: skip
        holds = call(kernels.forces, points).status == Status.OK
        J = solved.ways("J")
        yield compare(
            f"F {what} at awkward angles", "pinocchio", call(kernels.forces, points).F[holds],
            least_norm(J, solved.tau)[holds], 1e-11, {"alpha": points["alpha"][holds]}, "forces",
        )  # fmt: skip


# -- comparing ------------------------------------------------------------------------------------


def _told(kernels, results, points, status, what):
    """Each kernel answers with a status."""
    for kernel in results:
        found = call(getattr(kernels, kernel), points).status
        yield compare(what, "geometry", found, status, 0.0, points, kernel)


def _finite(kernels, results, points, what):
    """Each result is a number."""
    for kernel, name in results.items():
        found = getattr(call(getattr(kernels, kernel), points), name)
        yield compare(
            f"finite {what}", "geometry", np.isfinite(found).all(axis=-1), 1.0, 0.0, points, kernel
        )
