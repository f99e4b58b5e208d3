"""Derivatives by dual numbers, the series' orders, and what the errors do."""

from pathlib import Path

import numpy as np

from armillary import Status, truncate
from armillary.derivation.load import load
from armillary.program.compile import compile_kernel
from armillary.verify.exact import directional_derivative
from armillary.verify.measured import compare
from armillary.verify.points import chosen
from armillary.verify.remainder import remainder_check, remainder_order, rotation_bound

from .drive import closed_form
from .frames import H_R_I, I_R_L
from .rays import (
    COUNT,
    ERRORS,
    JOINTS,
    build,
    cos_beta,
    drives_everywhere,
    exact,
    lit,
    normals,
    rows,
    skies,
    tilts,
    unit,
    wanted,
)
from .series import SMALL, H_R_I_first, I_R_L_first, m_L
from .sky import toward

FEW = 60


def _program(kernel):
    record = load(Path(__file__).with_name("derivation.py"))
    return compile_kernel(record.kernels[kernel]).program


def _regular(kernels, n, seed):
    """Suns, receivers and stands at which the drive answers, down to the blind cone's edge."""
    tilted = tilts(n, seed)
    random = np.random.default_rng(seed + 1)
    near = np.abs(tilted["chi"]) + 10 ** random.uniform(-4, 0, n)
    turn = random.uniform(-np.pi, np.pi, n)
    axis = np.stack(
        [
            np.sin(tilted["psi"]),
            np.sin(tilted["theta"]) * np.cos(tilted["psi"]),
            np.cos(tilted["theta"]) * np.cos(tilted["psi"]),
        ],
        axis=1,
    )
    first = unit(np.cross(axis, [1.0, 0.3, 0.2]))
    second = np.cross(axis, first)
    around = np.cos(turn)[:, None] * first + np.sin(turn)[:, None] * second
    normal = np.cos(near)[:, None] * axis + np.sin(near)[:, None] * around
    points = {**lit(normal, seed + 2), **tilted}
    return chosen(points, kernels.drive(**exact(**points)).status == Status.OK)


def derivatives_by_duals(kernels):
    """Sensitivity and response against dual numbers of the drive, at 50 digits.

    Relative to the largest entry times 1 / cos(beta)^2, by which the edge magnifies the rounding of
    the normal.
    """
    drive = _program("drive")
    points = _regular(kernels, FEW, 61)
    given = exact(**points)
    condition = cos_beta(points, wanted(points)) ** -2
    axes = np.eye(3).tolist()
    for kernel, name, ways in (
        ("drive_sensitivity", "J", [{error: 1.0} for error in ERRORS]),
        ("drive_response", "J_c", [{"c": axis} for axis in axes]),
        ("drive_response", "J_b", [{"b": axis} for axis in axes]),
    ):
        by_duals = np.array([_slopes(drive, row, ways) for row in rows(points)])
        found = getattr(getattr(kernels, kernel)(**given), name)
        scale = np.abs(by_duals).max(axis=(1, 2)) * condition
        yield compare(
            f"{name}, relative to its largest entry over cos(beta)^2", "dual numbers",
            (found - by_duals) / scale[:, None, None], 0.0, 1e-12, points, kernel,
        )  # fmt: skip


def _slopes(program, row, ways):
    """Derivatives of alpha and beta: a row an angle, a column a way."""
    columns = []
    for way in ways:
        answer = directional_derivative(program, exact(**row), way)
        columns.append([float(answer.results[name].slope) for name in ("alpha", "beta")])
    return np.array(columns).T


def rates_add_up(kernels):
    """The rates of the drives add up to the angles they go through while the sun moves."""
    points = _regular(kernels, COUNT, 64)
    facing = {**points, "b": points["c"]}
    for given, mode, share in ((points, "", 1), (facing, ", facing the sun", 2)):
        calm = chosen(given, cos_beta(given, wanted(given)) > 0.3)
        yield from _added_up(kernels, calm, mode, share)


def _added_up(kernels, points, mode, share):
    """`share` is 2 where the beam follows the sun: both halves of b + c move then."""
    axis = unit(np.random.default_rng(65).normal(size=points["c"].shape))
    nodes, weights = np.polynomial.legendre.leggauss(16)
    speed = 0.02

    def at(time):
        turn = speed * time
        c, along = points["c"], np.sum(points["c"] * axis, axis=1, keepdims=True)
        turned = np.cos(turn) * c + np.sin(turn) * np.cross(axis, c)
        turned += (1 - np.cos(turn)) * along * axis
        return {**points, "c": turned, "b": turned if share == 2 else points["b"]}

    travelled = {"alpha": 0.0, "beta": 0.0}
    for node, weight in zip((nodes + 1) / 2, weights / 2, strict=True):
        now = at(node)
        moved = share * speed * np.cross(axis, now["c"])
        found = kernels.drive_rates(**exact(**now), c_dot=moved)
        for name in travelled:
            travelled[name] = travelled[name] + weight * getattr(found, f"{name}_dot")
    first, last = (kernels.drive(**exact(**at(time))) for time in (0.0, 1.0))
    for name, way in travelled.items():
        yield compare(
            f"the rate of {name} adds up{mode}", "balance", way,
            getattr(last, name) - getattr(first, name), 1e-12, points, "drive_rates", turn=True,
        )  # fmt: skip


# -- series ---------------------------------------------------------------------------------------


def _low(n, seed):
    """Suns and receivers whose normal keeps 20 degrees off the zenith and the nadir."""
    random = np.random.default_rng(seed)
    turn, rise = random.uniform(-np.pi, np.pi, n), random.uniform(-1.2, 1.2, n)
    level = np.cos(rise)
    normal = np.stack([np.sin(turn) * level, np.cos(turn) * level, np.sin(rise)], axis=1)
    return lit(normal, seed + 1)


def _apart(kernels, law, points, scale):
    """How far a law is from the exact drive, with all misalignments scaled, each point's worse."""
    tilted = {name: scale * a for name, a in tilts(len(points["c"]), 68).items()}
    given = exact(**points, **tilted)
    exactly, nearly = kernels.drive(**given), getattr(kernels, law)(**given)
    turn = np.remainder(nearly.alpha - exactly.alpha + np.pi, 2 * np.pi) - np.pi
    return np.hypot(turn, nearly.beta - exactly.beta)


def orders_of_the_laws(kernels):
    """The error of the first-order law falls by 4 when the misalignment is halved, then by 8."""
    points = _low(COUNT, 66)
    for law, order in (("drive_first_order", 2), ("drive_second_order", 3)):
        once, half = (_apart(kernels, law, points, scale) for scale in (0.02, 0.01))
        slope = np.log2(np.sqrt(np.mean(once**2)) / np.sqrt(np.mean(half**2)))
        yield compare(
            f"the error falls as order {order} ({slope:.3f})", "exact drive", slope, order, 0.02,
            {"scale": 0.02}, law, relative=False,
        )  # fmt: skip


# The largest misalignment, how high the normal may be, and what alpha and beta are then off by. Of
# 0.3 rad all three bring the blind cone down to 48.7 degrees, where the error has no bound.
SIZES = (
    (0.3, 45, {"drive_first_order": (0.75, 0.16), "drive_second_order": (0.43, 0.11)}),
    (0.01, 60, {"drive_first_order": (9e-4, 2e-4), "drive_second_order": (2e-5, 3e-6)}),
)


def sizes_of_the_laws(kernels):
    """The error at its largest: as high as may be, all round, and each misalignment at its ends."""
    for size, rise, laws in SIZES:
        points = worst(size, rise)
        exactly = kernels.drive(**exact(**points))
        for law, bounds in laws.items():
            nearly = getattr(kernels, law)(**exact(**points))
            for name, bound in zip(("alpha", "beta"), bounds, strict=True):
                yield compare(
                    f"{name} for misalignments of up to {size:g} rad, up to {rise} degrees high",
                    "exact drive", getattr(nearly, name), getattr(exactly, name), bound, points,
                    law, relative=False, turn=True,
                )  # fmt: skip


def worst(size, rise, names=ERRORS):
    """Normals at a height above and below the horizon, the mirror facing the sun; every corner."""
    part = (-1.0, -0.5, 0.0, 0.5, 1.0)
    turn, up, *errors = np.meshgrid(
        np.arange(0.0, 360.0, 6.0), (-rise, rise), *([part] * len(names))
    )
    n = toward(turn.ravel(), up.ravel())
    return {"c": n, "b": n, **{k: size * e.ravel() for k, e in zip(names, errors, strict=True)}}


def terms_of_the_laws(kernels):
    """The derived laws over the declared range at 50 digits, and their leading terms."""

    def low(row):
        m = np.array(row["b"]) + np.array(row["c"])
        return abs(m[2]) < np.sin(np.radians(SIZES[0][1])) * np.linalg.norm(m)

    for order, bounds in enumerate(SIZES[0][2].values(), 1):
        laws = [truncate(angle, order, SMALL) for angle in closed_form(I_R_L @ m_L)]
        for name, law, bound in zip(("alpha", "beta"), laws, bounds, strict=True):
            claim = f"{name} to order {order}, misalignments up to 0.3 rad, up to 45 degrees high"
            yield remainder_check(f"{claim}, at random", law, bound, 128, low, True)


def orders_of_the_rotations(kernels):
    """Truncated rotations: the error's order, and its size over the declared range."""
    for name, rotation, law in (("I_R_L", I_R_L, I_R_L_first), ("H_R_I", H_R_I, H_R_I_first)):
        order = remainder_order(law)
        yield compare(
            f"the error of {name} falls as order 2", "50 digits", order, 2.0, 0.01, {},
            "chain_first_order", relative=False,
        )  # fmt: skip
        bound = rotation_bound(rotation, 1, SMALL)
        yield remainder_check(f"{name} is within its proven bound, {bound:.2g}", law, bound)


# -- what the errors do ---------------------------------------------------------------------------


def normal_errors_by_pinocchio(kernels):
    """The leans as joints: their axes crossed with the normal."""
    points = drives_everywhere(71)
    q = np.stack([points[name] for name in JOINTS], axis=1)
    columns = build(points).jacobian(q)[:, 3:, :]
    n = normals(points, points["alpha"], points["beta"])
    found = kernels.normal_errors(**exact(**points))
    for name in ERRORS:
        moved = np.cross(columns[:, :, JOINTS.index(name)], n)
        yield compare(
            f"shift of the normal per unit of {name}", "pinocchio", getattr(found, f"e_{name}"),
            np.linalg.norm(moved, axis=1), 1e-14, points, "normal_errors",
        )  # fmt: skip


def error_angles_by_numpy(kernels):
    """Angles of ideal axes by NumPy, less those of the drive."""
    points = skies()
    found = kernels.error_angles(**exact(**points))
    valid = kernels.drive(**exact(**points))
    east, north, up = wanted(points).T
    level = np.hypot(east, north)
    clear = (found.status == Status.OK) & (level > 1e-5)
    for name, ideal, real in (
        ("Delta_A", np.arctan2(-east, -north), valid.alpha),
        ("Delta_h", np.arctan2(up, level), valid.beta),
    ):
        yield compare(
            f"{name} is calculated minus valid", "NumPy", getattr(found, name)[clear],
            (ideal - real)[clear], 1e-11 if name == "Delta_A" else 1e-14, chosen(points, clear),
            "error_angles", turn=True,
        )  # fmt: skip
    leaning = {"theta": np.array([0.1, -0.2]), "psi": 0.1, "chi": 0.05}
    up = {"c": np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]), "b": toward(0.0, [90.0, -90.0])}
    yield compare(
        "at the zenith and the nadir ideal axes have no azimuth, whatever the real ones have",
        "geometry", kernels.error_angles(**exact(**up, **leaning)).status, Status.SINGULAR, 0.0,
        {**up, **leaning}, "error_angles",
    )  # fmt: skip
