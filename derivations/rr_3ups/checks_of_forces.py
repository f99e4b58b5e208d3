"""What least norm, preload, power and energy must satisfy, whatever the forces are."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.measured import compare

from .checks_of_kinematics import SPED, slopes_of
from .derivation import derivation
from .reference import dot, jacobian, platform, platform_demand, times
from .samples import call, fast
from .solved import by_pinocchio

OF_TWO = {"generalized_force_two_legs": "tau", "forces_two_legs": "F", "power_two_legs": "P"}
PER_LEG = ("r", "phi", "R", "theta", "h", "zeta", "t", "s", "m_t", "m_s", "I_t", "I_s")


def forces_by_algebra(kernels):
    """The forces do what is asked, and no force that does nothing is among them."""
    points = fast(3)
    J = jacobian(points)
    back = np.swapaxes(J, 1, 2)
    tau = call(kernels.generalized_force, points).tau
    F = call(kernels.forces, points).F
    found = {
        "J^T F is the generalised force": (times(back, F), tau, "forces"),
        "F has the least norm: SciPy's least squares finds it too": (
            F,
            _lstsq(back, tau),
            "forces",
        ),
    }
    pair, tau_2 = (
        call(kernels.forces_two_legs, points).F,
        call(kernels.generalized_force_two_legs, points).tau,
    )
    found["J^T F of two legs is theirs"] = (times(back[..., :2], pair), tau_2, "forces_two_legs")
    for claim, (got, wanted, kernel) in found.items():
        yield compare(claim, "NumPy", got, wanted, 1e-12, points, kernel)


def _lstsq(back, tau):
    from_scipy = need("scipy.linalg").lstsq
    return np.array([from_scipy(one, moment)[0] for one, moment in zip(back, tau, strict=True)])


def preload_does_nothing(kernels):
    """Internal forces: of norm 1, in the null space, and added as they are."""
    points = fast(4)
    N = call(kernels.internal_forces, points).N
    yield compare(
        "internal forces do no work", "NumPy", times(np.swapaxes(jacobian(points), 1, 2), N), 0.0,
        1e-13, points, "internal_forces", relative=False,
    )  # fmt: skip
    yield compare(
        "and have norm 1", "NumPy", np.linalg.norm(N, axis=1), 1.0, 1e-14, points, "internal_forces"
    )
    F = call(kernels.forces, points).F
    scale = np.linalg.norm(F, axis=1)
    yield compare(
        "no part of F is internal", "NumPy", dot(F, N) / scale, 0.0, 1e-12, points, "forces",
        relative=False,
    )  # fmt: skip
    load = np.random.default_rng(5).uniform(-100.0, 100.0, len(N))
    both = {**points, "preload": load}
    yield compare(
        "a preload is added along them", "NumPy", call(kernels.forces_preloaded, both).F,
        F + load[:, None] * N, 1e-13, both, "forces_preloaded",
    )  # fmt: skip


def third_leg_is_absent(kernels):
    """Nothing of leg 3 tells where two legs drive: neither another one nor an absurd one."""
    points = fast(6)
    for what, third in (
        ("another third leg", fast(7)),
        ("a third leg at the lower limits", _at_limits(points, 0)),
        ("a third leg at the upper limits", _at_limits(points, 1)),
        ("a third leg without length", _without_length(points)),
    ):
        swapped = {**points, **{name: points[name].copy() for name in PER_LEG}}
        for name in PER_LEG:
            swapped[name][:, 2] = third[name][:, 2]
        for kernel, name in OF_TWO.items():
            found, wanted = (call(getattr(kernels, kernel), each) for each in (swapped, points))
            yield compare(
                f"{what} changes nothing", kernel, getattr(found, name), getattr(wanted, name), 0.0,
                points, kernel,
            )  # fmt: skip
            yield compare(f"{what} is no matter", kernel, found.status, 0, 0.0, points, kernel)


def _at_limits(points, end):
    """Legs of which every quantity is at the end of what a kernel takes."""
    given = {q.name: q for q in derivation.kernels["generalized_force_two_legs"].parameters}
    return {name: np.full_like(points[name], given[name].facts.limits[end]) for name in PER_LEG}


def _without_length(points):
    """Legs whose spherical joint is at o and whose universal joint is there too."""
    found = {name: np.zeros_like(points[name]) for name in PER_LEG}
    return {**found, "h": np.repeat(points["h_0"][:, None], 3, axis=1)}


def massless_legs(kernels):
    """Legs without mass ask for nothing: what is left is Euler's equation of the platform."""
    points = fast(8)
    for name in ("m_t", "m_s", "I_t", "I_s"):
        points[name] = np.zeros_like(points[name])
    wanted = platform_demand(points)
    for kernel in (
        "generalized_force", "generalized_force_spin_free", "generalized_force_two_legs",
    ):  # fmt: skip
        found = call(getattr(kernels, kernel), points).tau
        yield compare(
            "legs without mass ask for nothing", "NumPy", found, wanted, 1e-12, points, kernel
        )  # fmt: skip


def energy_by_pinocchio(kernels):
    """Kinetic and potential energy, the latter from the ground."""
    solved = by_pinocchio()
    found = call(kernels.energy, solved.points)
    wanted = solved.each(lambda engine, motion: engine.energies(motion))
    for k, name in enumerate("TV"):
        yield compare(
            f"energy {name}", "pinocchio", getattr(found, name), wanted[:, k], 1e-13, solved.points,
            "energy",
        )  # fmt: skip


def power_balances(kernels):
    """What drives and wind do is what the energy gains."""
    points = fast(9)
    slopes = slopes_of("energy", points, SPED)
    gained = slopes["T"][:, 0] + slopes["V"][:, 0]
    wind = dot(points["n_d"], platform(points).spin)
    q_dot = call(kernels.leg_rates, points).q_dot
    for kernel, done in (
        ("forces", dot(call(kernels.forces, points).F, q_dot)),
        ("power", call(kernels.power, points).P.sum(axis=1)),
    ):
        yield compare(
            "drives and wind do what energy gains", "dual numbers", done + wind, gained, 1e-12,
            points, kernel,
        )  # fmt: skip


def motors(kernels):
    """Power is force times speed; the heat of a motor goes with its current squared."""
    points = fast(10)
    q_dot = call(kernels.leg_rates, points).q_dot
    for kernel, forces, count in (("power", "forces", 3), ("power_two_legs", "forces_two_legs", 2)):
        F = call(getattr(kernels, forces), points).F
        yield compare(
            "power is force times speed", "NumPy", call(getattr(kernels, kernel), points).P,
            F * q_dot[:, :count], 1e-14, points, kernel,
        )  # fmt: skip
    random = np.random.default_rng(11)
    ends = {"K_M": (0.01, 1.0), "R_w": (0.0, 10.0), "lead": (0.001, 0.02)}
    motor = {name: random.uniform(*span, 200) for name, span in ends.items()}
    motor["F_leg"] = random.uniform(-500.0, 500.0, (200, 3))
    turn = motor["lead"] / (2 * np.pi)
    current = motor["F_leg"] * (turn / motor["K_M"])[:, None]
    yield compare(
        "heat is resistance times current squared", "NumPy",
        call(kernels.copper_power, {**points, **motor}).P, motor["R_w"][:, None] * current**2,
        1e-14, motor, "copper_power",
    )  # fmt: skip
