"""Parabolic dish on 3-RPS platforms (Mo et al. 2023), with what its hinges permit.

Each part stands in a file of its own; their order here is their order on the page.
"""

from armillary import Status, near, vector

from .symbols import (
    D,
    alpha,
    alpha_dot,
    beta,
    beta_dot,
    centre,
    d,
    enu,
    f_d,
    g,
    guess,
    l_given,
    mass,
    metre,
    n_d,
    theta_rim,
    z_dot,
    z_O,
)
from .dish import alpha_aim, at_zenith, beta_aim, f_rim
from .facet import H_R_M, M, face_down, off_dish
from .rods import face_down_all, l_all, l_rod, no_rod
from .rates import J, J_A, J_B, J_P, Omega_M, l_dot, v_M
from .joints import p_dot, p_R, s
from .forward import H_R_found, M_found, lost
from .statics import F_rod, loose
from .receiver import H_R_aimed, M_aimed, astray, l_aimed, miss, miss_angle
from .control import (
    F_drive,
    F_ff,
    F_start,
    integral,
    integral_next,
    l_before,
    l_dot_ref,
    l_measured,
    l_ref,
    v,
    v_next,
)

from .picture import POSE, scene

derivation = d
angles = [alpha, beta]
rates = [alpha, beta, alpha_dot, beta_dot, z_dot]
FACE_DOWN = (Status.UNREACHABLE, face_down, "the facet hangs face down")
NO_ROD = (Status.UNREACHABLE, no_rod, "a rod has no length")

# ---- the dish ----

d.kernel(
    "focal_length",
    inputs=[D, theta_rim],
    outputs={"f": f_rim},
    summary="Focal length of a dish by its diameter and its edge angle.",
)
d.kernel(
    "aim",
    inputs=[enu],
    outputs={"alpha": alpha_aim, "beta": beta_aim},
    cases=[(Status.SINGULAR, at_zenith, "the sun is at the zenith or the nadir: alpha is free")],
    summary="Attitude of a dish that faces the sun.",
)

# ---- the facet and its rods ----

d.kernel(
    "facet",
    inputs=angles,
    outputs={"H_R_M": H_R_M, "M": M},
    cases=[FACE_DOWN],
    summary="Rotation and point of the facet, in {H}.",
)
d.kernel(
    "off_dish",
    inputs=angles,
    outputs={"off": off_dish},
    cases=[FACE_DOWN],
    summary="How far the facet's point stands from the point of the dish, in {H}.",
)
d.kernel(
    "rod_lengths",
    inputs=angles,
    outputs={"l": l_rod},
    cases=[FACE_DOWN],
    summary="Lengths of the three rods of one facet.",
)
d.kernel(
    "rod_lengths_all",
    inputs=angles,
    outputs={"l": l_all},
    cases=[(Status.UNREACHABLE, face_down_all, "a facet hangs face down")],
    summary="Lengths of the rods of four facets, at 0, 90, 180 and 270 degrees; phi is not used.",
)
d.kernel(
    "rod_rates",
    inputs=rates,
    outputs={"l_dot": l_dot},
    cases=[FACE_DOWN, NO_ROD],
    summary="Rates of the three rods of one facet.",
)
d.kernel(
    "facet_rates",
    inputs=rates,
    outputs={"M_dot": v_M, "Omega": Omega_M},
    cases=[FACE_DOWN],
    summary="Velocity of the facet's point and angular velocity of the facet, in {H}.",
)

# ---- Jacobians and joints ----

d.kernel(
    "jacobian_a",
    inputs=angles,
    outputs={"J_A": J_A},
    cases=[FACE_DOWN, NO_ROD],
    summary="Jacobian from the facet's twist about its point to the rates of its rods.",
)
d.kernel(
    "jacobian_b",
    inputs=angles,
    outputs={"J_B": J_B},
    cases=[FACE_DOWN],
    summary="Jacobian from the rates of alpha, beta and z_O to the facet's twist about its point.",
)
d.kernel(
    "jacobian_full",
    inputs=angles,
    outputs={"J": J},
    cases=[FACE_DOWN, NO_ROD],
    summary="Jacobian from the facet's twist about its point to the rates of its rods, over the "
    "rates that its hinges make zero.",
)
d.kernel(
    "jacobian_passive",
    inputs=angles,
    outputs={"J_P": J_P},
    cases=[FACE_DOWN, NO_ROD],
    summary="Jacobian from the facet's twist about its point to the rates of its hinges.",
)
d.kernel(
    "passive_rates",
    inputs=rates,
    outputs={"p_R_dot": p_dot},
    cases=[FACE_DOWN, NO_ROD],
    summary="Rates of the three hinges of one facet.",
)
d.kernel(
    "joint_angles",
    inputs=angles,
    outputs={"s": s},
    cases=[FACE_DOWN, NO_ROD],
    summary="Angles of the three S-joints: between rod and facet normal, in [0, pi].",
)
d.kernel(
    "revolute_angles",
    inputs=angles,
    outputs={"p_R": p_R},
    cases=[FACE_DOWN, NO_ROD],
    summary="Angles of the three hinges: of the rods from the vertical, outward positive.",
)

# ---- rods to pose ----

d.kernel(
    "forward",
    inputs=[l_given, guess],
    outputs={"H_R_M": H_R_found, "M": M_found},
    cases=[(Status.NOT_CONVERGED, lost, "the search did not end on rods of these lengths")],
    drawn={l_given: l_rod, guess: near(vector(alpha, beta, z_O / metre), by=0.1)},
    summary="Rotation and point of the facet on rods of the lengths given, by eight steps of "
    "Newton's method from a guess. OK means rods of these lengths: where the facet stands nearly "
    "on edge, only a close guess tells which of two poses.",
)

# ---- forces ----

d.kernel(
    "static_forces",
    inputs=[alpha, beta, mass, centre, f_d, n_d, g],
    outputs={"F": F_rod},
    cases=[
        FACE_DOWN,
        NO_ROD,
        (Status.SINGULAR, loose, "the rods do not hold the facet: their forces are given as 0"),
    ],
    summary="Forces of the three rods that hold the facet against its weight and a disturbance, "
    "push positive.",
)

# ---- the receiver ----

d.kernel(
    "central_ray",
    inputs=angles,
    outputs={"miss": miss, "miss_angle": miss_angle},
    cases=[FACE_DOWN],
    summary="How far the central ray passes the focus when the facet has the dish's normal.",
)
d.kernel(
    "aim_at_receiver",
    inputs=angles,
    outputs={"H_R_M": H_R_aimed, "M": M_aimed, "l": l_aimed},
    cases=[
        FACE_DOWN,
        (Status.NOT_CONVERGED, astray, "the normal that was found is not the bisector"),
    ],
    summary="Rotation, point and rods of a facet whose normal halves the angle between sun and "
    "receiver, by five steps of Newton's method.",
)

# ---- control ----

d.controller(
    "rod_control",
    inputs=[l_ref, l_dot_ref, l_measured, F_ff],
    outputs={"F_drive": F_drive},
    states={integral: integral_next, v: v_next, l_before: l_measured},
    start={integral: F_start, v: 0, l_before: l_measured},
    start_inputs=[l_measured, F_start],
    summary="Force of a rod's drive: PID with a filtered rate, feed-forward and an integral that "
    "does not wind up.",
)

# ---- what is taken for granted ----

d.assume(
    "Inferred: Table 1 of the paper is lost. Dimensions on this page are examples, and where the "
    "paper's numbers are met it is told how many sets would meet them."
)
d.assume(
    "The receiver stands on the axis of the dish at the focal length from the vertex, whatever "
    "holds it there."
)
d.assume("Rods, facets and ground are rigid; hinges, drives and S-joints have no play.")
d.assume(
    "The hinge axes lie across the way from the base's centre to the hinge; the S-joints lie in "
    "the plane that touches the dish at the facet's point."
)
d.assume("A facet is flat and small for the light: one ray, at its point, stands for the beam.")
d.assume("Forces are those of rest: rods have no weight and nothing is accelerated.")
d.assume(
    "The pose without torsion is the one that is built: turned about the normal by half a turn "
    "the facet would keep to its hinges too."
)
d.picture(
    scene,
    at=POSE,
    caption="The four facets act a dish that turns about its vertex O to face the sun. Its "
    "meridians are drawn through them, and the circle of their points. Each facet stands on three "
    "rods, hinged to the ground about P; a rod keeps to the upright plane through P. The facet M "
    "has the normal and the height of the dish's point, and stands a little aside of it.",
)
