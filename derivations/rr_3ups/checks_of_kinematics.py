"""Lengths, rates and turning of the legs against NumPy, pinocchio's loops and dual numbers."""

import numpy as np

from armillary import Status
from armillary.program.lower import Strategy, lower
from armillary.verify.exact import directional_derivative, flat
from armillary.verify.measured import compare
from armillary.verify.points import rows_of

from .derivation import derivation
from .reference import attitude, ends, jacobian, joint_angles, lengths
from .samples import ACCELERATIONS, ANGLES, RATES, call, fast
from .solved import by_pinocchio

SLOW = 60  # points for dual numbers of long programs
MOTION = ("omega", "omega_dot", "v_t", "a_t", "v_s", "a_s")
TURNED = {"alpha": "alpha_dot", "beta": "beta_dot"}
OF_MOTIONS = (
    "platform", "joints", "leg_lengths", "leg_rates", "leg_accelerations", "jacobian",
    "jacobian_rate", "leg_angles", "leg_motion", "leg_motion_spin_free", "generalized_force",
    "generalized_force_spin_free", "generalized_force_two_legs", "forces", "forces_spin_free",
    "forces_two_legs", "internal_forces", "power", "power_two_legs", "energy", "mass_matrix",
    "bias", "singularity",
)  # fmt: skip
SPED = dict(zip(ANGLES + RATES, RATES + ACCELERATIONS, strict=True))


def lengths_by_numpy(kernels):
    """Where the joints are and how long and how inclined the legs are, straight from the loop."""
    points = fast(1)
    gamma, psi = joint_angles(points)
    for kernel, name, wanted, tolerance in (
        ("platform", "R_m", attitude(points["alpha"], points["beta"]), 1e-14),
        ("joints", "P", ends(points)[0], 1e-14),
        ("leg_lengths", "q", lengths(points), 1e-14),
        ("leg_angles", "gamma", gamma, 1e-13),
        ("leg_angles", "psi", psi, 1e-13),
    ):
        found = getattr(call(getattr(kernels, kernel), points), name)
        yield compare(
            f"{name} from the loop", "NumPy", found, wanted, tolerance, points, kernel,
            turn=kernel == "leg_angles",
        )  # fmt: skip
    yield compare(
        "J by complex steps through the loop", "NumPy", call(kernels.jacobian, points).J,
        jacobian(points), 1e-13, points, "jacobian",
    )  # fmt: skip


def regular_motions(kernels):
    """Away from what is singular every kernel of a motion says so."""
    points = fast(1)
    told = [call(getattr(kernels, name), points).status for name in OF_MOTIONS]
    yield compare(
        "away from what is singular all is well", "geometry", np.stack(told, axis=-1), Status.OK,
        0.0, points,
    )  # fmt: skip


def loops_by_pinocchio(kernels):
    """Lengths, joint angles and their rates where pinocchio's tree closes."""
    solved = by_pinocchio()
    points, x = solved.points, solved.ways("x")
    for kernel, name, wanted in (
        ("leg_lengths", "q", solved.ways("q")),
        ("leg_angles", "gamma", x[:, 2::3]),
        ("leg_angles", "psi", x[:, 3::3]),
        ("leg_rates", "q_dot", solved.ways("q_dot")),
        ("leg_accelerations", "q_ddot", solved.ways("q_ddot")),
        ("jacobian", "J", solved.ways("J")),
    ):
        yield compare(
            f"{name} where the loops close", "pinocchio",
            getattr(call(getattr(kernels, kernel), points), name), wanted, 1e-12, points, kernel,
            turn=kernel == "leg_angles",
        )  # fmt: skip


def turning_by_pinocchio(kernels):
    """How the links turn, and how their centres of mass move."""
    solved = by_pinocchio()
    found = call(kernels.leg_motion, solved.points)
    links = [e.links(m) for e, m in zip(solved.engines, solved.motions, strict=True)]
    for k, name in enumerate(MOTION):
        yield compare(
            f"{name} of the legs", "pinocchio", getattr(found, name),
            np.array([link[k] for link in links]), 1e-12, solved.points, "leg_motion",
        )  # fmt: skip


def rates_by_dual_numbers(kernels):
    """Jacobian, its rate and every acceleration: slopes of what they are the rate of."""
    points = fast(2)
    J = np.stack([slopes_of("leg_lengths", points, {n: 1.0})["q"] for n in ANGLES], axis=-1)
    yield compare(
        "J is the slope of the lengths", "dual numbers", call(kernels.jacobian, points).J, J, 1e-11,
        points, "jacobian",
    )  # fmt: skip
    few = {name: value[:SLOW] for name, value in points.items()}
    motion = {"omega_dot": "omega", "a_t": "v_t", "a_s": "v_s"}
    for kernel, base, speeds, given, pairs in (
        ("leg_rates", "leg_lengths", TURNED, points, {"q_dot": "q"}),
        ("jacobian_rate", "jacobian", TURNED, points, {"J_dot": "J"}),
        ("leg_accelerations", "leg_rates", SPED, points, {"q_ddot": "q_dot"}),
        ("leg_motion", "leg_motion", SPED, few, motion),
        ("leg_motion_spin_free", "leg_motion_spin_free", SPED, few, motion),
    ):
        slopes, found = slopes_of(base, given, speeds), call(getattr(kernels, kernel), given)
        for name, of in pairs.items():
            got = getattr(found, name)
            yield compare(
                f"{name} is the rate of {of}", "dual numbers", got, slopes[of].reshape(got.shape),
                1e-11, given, kernel,
            )  # fmt: skip


def slopes_of(kernel, points, speeds):
    """Slopes of all results of a kernel by dual numbers, before any pass: (n, size) each.

    Args:
        speeds: for each input that moves how fast: a number, or the name of what the points hold.
    """
    stated = derivation.kernels[kernel]
    program = lower(stated, Strategy())
    names = [q.name for q in (*stated.inputs, *stated.parameters)]
    found = []
    for row in rows_of(points):
        direction = {
            name: row[speed] if isinstance(speed, str) else speed
            for name, speed in speeds.items() if name in names
        }  # fmt: skip
        given = {name: row[name] for name in names}
        results = directional_derivative(program, given, direction).results
        found.append({n: [float(dual.slope) for dual in flat(v)] for n, v in results.items()})
    return {name: np.array([row[name] for row in found]) for name in found[0]}
