"""Two-axis tracker driven by three UPS legs (Yu, Wu and Zhang).

Each part stands in a file of its own; their order here is their order on the page.
"""

from armillary import Status

from .symbols import (
    DISTURBANCE,
    STATE,
    alpha,
    alpha_dot,
    beta,
    beta_dot,
    d,
)
from .legs import J, J_dot, P, R_m, no_leg, no_leg_2, q, q_ddot, q_dot
from .legs_in_motion import along_axis, along_axis_2
from .dynamics import tau, tau_2, tau_free
from .links import (
    a_s,
    a_t,
    gamma,
    omega_dot_W,
    omega_free_dot_W,
    omega_free_W,
    omega_W,
    psi,
    v_s,
    v_t,
)
from .forces import (
    F_2,
    F_free,
    F_preloaded,
    F_q,
    det_2,
    internal,
    loose,
    loose_2,
    preload,
    sigma_min,
)
from .energy import F_leg, K_M, P_2, P_copper, P_q, R_w, T, V, lead
from .forward_dynamics import alpha_found, beta_found, bias, mass_matrix, massless

from .picture import POSE, scene

# These bring their kernels along.
from . import celestial, forward, trajectory  # noqa: F401

derivation = d
angles = [alpha, beta]
rates = [alpha, beta, alpha_dot, beta_dot]
loaded = [*STATE, *DISTURBANCE]
NO_LEG = (Status.UNREACHABLE, no_leg, "a leg is shorter than 1e-6 m")
ALONG = (
    Status.UNREACHABLE,
    along_axis,
    (
        "a leg stands along the first axis of its universal joint, within 1e-5: no rate of the "
        "joint gives it every motion"
    ),
)
ALONG_FREE = (
    Status.UNREACHABLE,
    along_axis,
    (
        "a leg stands along the first axis of its universal joint, within 1e-5: the axes of its "
        "moments of inertia have no direction"
    ),
)
MOVED = [NO_LEG, ALONG]
MOVED_FREE = [NO_LEG, ALONG_FREE]
MOVED_2 = [
    (Status.UNREACHABLE, no_leg_2, NO_LEG[2]),
    (Status.UNREACHABLE, along_axis_2, ALONG[2]),
]
LOOSE = (
    Status.SINGULAR,
    loose,
    (
        "three drives do not hold the platform, sqrt(det J^T J) is at most 1e-5 of the sum of r^2: "
        "forces are given as 0, so hold the axes"
    ),
)
LOOSE_2 = (
    Status.SINGULAR,
    loose_2,
    (
        "two drives do not hold the platform, |det_2| is at most 1e-5 (r_1^2 + r_2^2): forces are "
        "given as 0, so hold the axes"
    ),
)
ABSENT = (
    "Its parameters must be legal, 0 serves, and no result depends on them; a call still works "
    "through three legs in its loop, and leaves the third aside."
)

# ---- platform and legs ----

d.kernel(
    "platform",
    inputs=angles,
    outputs={"R_m": R_m},
    summary="Rotation of the platform.",
)
d.kernel(
    "joints",
    inputs=angles,
    outputs={"P": P},
    summary="Positions of the three spherical joints, world axes.",
)
d.kernel("leg_lengths", inputs=angles, outputs={"q": q}, summary="Lengths of the three legs.")
d.kernel(
    "leg_rates",
    inputs=rates,
    outputs={"q_dot": q_dot},
    cases=[NO_LEG],
    summary="Rates of the three lengths.",
)
d.kernel(
    "leg_accelerations",
    inputs=STATE,
    outputs={"q_ddot": q_ddot},
    cases=[NO_LEG],
    summary="Accelerations of the three lengths.",
)
d.kernel(
    "jacobian",
    inputs=angles,
    outputs={"J": J},
    cases=[NO_LEG],
    summary="Jacobian from the rates of alpha and beta to those of the lengths.",
)
d.kernel(
    "jacobian_rate",
    inputs=rates,
    outputs={"J_dot": J_dot},
    cases=[NO_LEG],
    summary="Rate of that Jacobian.",
)
d.kernel(
    "leg_angles",
    inputs=angles,
    outputs={"gamma": gamma, "psi": psi},
    cases=MOVED,
    summary="Angles of the three legs about the two axes of their universal joints.",
)
_centres = {"v_t": v_t, "a_t": a_t, "v_s": v_s, "a_s": a_s}
d.kernel(
    "leg_motion",
    inputs=STATE,
    outputs={"omega": omega_W, "omega_dot": omega_dot_W, **_centres},
    cases=MOVED,
    summary="Angular velocity and acceleration of the three legs, and velocities and accelerations "
    "of the centres of mass of their links, world axes.",
)
d.kernel(
    "leg_motion_spin_free",
    inputs=STATE,
    outputs={"omega": omega_free_W, "omega_dot": omega_free_dot_W, **_centres},
    cases=[NO_LEG],
    summary="The same of legs that do not spin, as the paper takes them: also where a leg stands "
    "along the first axis of its universal joint.",
)
d.kernel(
    "singularity",
    inputs=angles,
    outputs={"det_2": det_2, "sigma_min": sigma_min},
    cases=[NO_LEG],
    summary="How far two and three drives are from not holding the platform: the determinant of "
    "the Jacobian of legs 1 and 2, and the smallest singular value of that of all three.",
)

# ---- forces ----

d.kernel(
    "generalized_force",
    inputs=loaded,
    outputs={"tau": tau},
    cases=MOVED,
    summary="Moments about the axes of alpha and beta that the drives must give.",
)
d.kernel(
    "generalized_force_two_legs",
    inputs=loaded,
    outputs={"tau": tau_2},
    cases=MOVED_2,
    summary="The same where leg 3 is absent with its masses. " + ABSENT,
)
d.kernel(
    "generalized_force_spin_free",
    inputs=loaded,
    outputs={"tau": tau_free},
    cases=MOVED_FREE,
    summary="The same of legs that do not spin, as the paper takes them.",
)
d.kernel(
    "forces",
    inputs=loaded,
    outputs={"F": F_q},
    cases=[*MOVED, LOOSE],
    summary="Forces of the three drives, of least norm; extending positive.",
)
d.kernel(
    "forces_spin_free",
    inputs=loaded,
    outputs={"F": F_free},
    cases=[*MOVED_FREE, LOOSE],
    summary="The same of legs that do not spin, as the paper takes them.",
)
d.kernel(
    "forces_preloaded",
    inputs=[*loaded, preload],
    outputs={"F": F_preloaded},
    cases=[*MOVED, LOOSE],
    summary="Forces of the three drives with an internal force, which moves nothing.",
)
d.kernel(
    "forces_two_legs",
    inputs=loaded,
    outputs={"F": F_2},
    cases=[*MOVED_2, LOOSE_2],
    summary="Forces of the drives of legs 1 and 2 where leg 3 is absent with its masses. " + ABSENT,
)
d.kernel(
    "internal_forces",
    inputs=angles,
    outputs={"N": internal},
    cases=[NO_LEG, LOOSE],
    summary="Forces of norm 1 that do no work along any motion.",
)

# ---- power and energy ----

d.kernel(
    "power",
    inputs=loaded,
    outputs={"P": P_q},
    cases=[*MOVED, LOOSE],
    summary="Mechanical power of the three drives at forces of least norm.",
)
d.kernel(
    "power_two_legs",
    inputs=loaded,
    outputs={"P": P_2},
    cases=[*MOVED_2, LOOSE_2],
    summary="Mechanical power of the drives of legs 1 and 2 where leg 3 is absent with its masses. "
    + ABSENT,
)
d.kernel(
    "copper_power",
    inputs=[F_leg, K_M, R_w, lead],
    outputs={"P": P_copper},
    summary="Heat of the three motors at given forces.",
)
d.kernel(
    "energy",
    inputs=rates,
    outputs={"T": T, "V": V},
    cases=MOVED,
    summary="Kinetic and potential energy of platform and legs.",
)

# ---- forward dynamics ----

d.kernel(
    "mass_matrix",
    inputs=angles,
    outputs={"H": mass_matrix},
    cases=MOVED,
    summary="Mass matrix of alpha and beta, legs included.",
)
d.kernel(
    "bias",
    inputs=[*rates, *DISTURBANCE],
    outputs={"tau_0": bias},
    cases=MOVED,
    summary="Generalised force at no acceleration.",
)
d.kernel(
    "forward_dynamics",
    inputs=[*rates, F_leg, *DISTURBANCE],
    outputs={"alpha_ddot": alpha_found, "beta_ddot": beta_found},
    cases=[
        *MOVED,
        (Status.SINGULAR, massless, "some motion moves no mass: accelerations are given as 0"),
    ],
    summary="Accelerations of alpha and beta under given forces of the drives.",
)

# ---- what is taken for granted ----

d.assume(
    "Legs, platform, column and ground are rigid; joints and drives have no play, no friction."
)
d.assume(
    "The two axes of the platform cross in o, above the origin; the spherical joints lie in the "
    "plane through o that is square to the platform's normal."
)
d.assume(
    "The two axes of a universal joint cross in its centre, the spherical joint's centre lies on "
    "the leg's axis, and the centres of mass of both links do so too."
)
d.assume(
    "Principal axes of a link are those of its leg, principal axes of the platform its own; the "
    "platform's moments are about o."
)
d.assume("Legs are driven by forces along them; what a drive's motor turns has no inertia here.")
d.picture(
    scene,
    at=POSE,
    caption="A column carries the platform on two crossed axes. Three legs drive it, each from a "
    "universal joint on a post, its first axis dashed, to a spherical joint; o-xyz turns with the "
    "platform, its z axis faces the sun.",
)
