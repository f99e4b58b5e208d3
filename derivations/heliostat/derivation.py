"""Heliostat with misaligned axes (Musabekov et al. 2018), solved without a small angle.

Each part stands in a file of its own; their order here is their order on the page.
"""

from armillary import PI, Chain, Status, X, Z, number

from .symbols import (
    aim_point,
    alpha,
    alpha_reading,
    azimuth,
    b,
    beta,
    beta_reading,
    c,
    c_dot,
    d,
    declination,
    elevation,
    hour_angle,
    latitude,
    n,
    position,
)
from .frames import H_R_I, I_R_L, L_R_E, normal, stand
from .optics import (
    astray,
    b_beam,
    b_reflected,
    b_target,
    distance,
    miss,
    on_mirror,
    opposed,
    unlit,
    wanted,
)
from .drive import (
    aim,
    aim_sun,
    alpha_back,
    alpha_drive,
    alpha_track,
    beta_back,
    beta_drive,
    beta_track,
    cases_of,
    cases_of_nearest,
)
from .rates import J, alpha_dot, beta_dot, e_chi, e_psi, e_theta, response
from .series import (
    Delta_A,
    Delta_h,
    H_R_I_1,
    I_R_L_1,
    alpha_first,
    alpha_second,
    beta_first,
    beta_second,
    law_cases,
    overhead,
)
from .encoder import (
    AN,
    AW,
    CA,
    IA,
    IE,
    NPAE,
    alpha_decoded,
    alpha_encoder,
    at_zenith,
    beta_decoded,
    beta_encoder,
    decoding_cases,
    delta_azimuth,
    delta_elevation,
    reading_cases,
)

derivation = d
drives = {"alpha": alpha_drive, "beta": beta_drive}
CONDITION = "What is rounded grows in it by at most 1 / cos(beta)^2, relative to its largest entry."
regular = cases_of(aim)
no_normal = regular[0]

# ---- frames ----

d.kernel(
    "normal",
    inputs=[alpha, beta],
    outputs={"n": normal},
    summary="Unit normal of the mirror for given drive angles.",
)
d.kernel(
    "chain",
    inputs=[latitude, alpha, beta],
    outputs=[L_R_E, I_R_L, H_R_I],
    summary="Rotations from the equator to the mirror, in the paper's axes.",
)
d.kernel(
    "chain_first_order",
    inputs=[latitude, alpha, beta],
    outputs={"L_R_E": L_R_E, "I_R_L": I_R_L_1, "H_R_I": H_R_I_1},
    summary="Rotations from the equator to the mirror to first order in theta, psi and chi, in the "
    "paper's axes. They are no rotations any more: I_R_L is off by at most half the square of "
    "|theta| + |psi|, H_R_I by half that of chi; 0.18 and 0.045 for 0.3 rad.",
)

# ---- optics ----

d.kernel(
    "bisector",
    inputs=[c, b],
    outputs={"n": wanted},
    cases=[(Status.UNREACHABLE, opposed, no_normal[2])],
    summary="Unit normal that sends the sun to the receiver.",
)
d.kernel(
    "reflect",
    inputs=[c, n],
    outputs={"b": b_reflected},
    summary="Where a mirror of a given normal sends the sun.",
)
d.kernel(
    "beam",
    inputs=[c, alpha, beta],
    outputs={"b": b_beam},
    summary="Where the mirror sends the sun, for given drive angles.",
)
d.kernel(
    "target",
    inputs=[position, aim_point],
    outputs={"b": b_target, "distance": distance},
    cases=[(Status.UNREACHABLE, on_mirror, "the aim point lies on the mirror, within 1e-6 m")],
    summary="Direction and distance from the mirror to the aim point.",
)
d.kernel(
    "miss",
    inputs=[c, alpha, beta, position, aim_point],
    outputs=[miss],
    cases=[
        (Status.UNREACHABLE, on_mirror, "the aim point lies on the mirror, within 1e-6 m"),
        (
            Status.UNREACHABLE,
            astray,
            "the beam leaves across the way, or backwards",
        ),
        (Status.UNREACHABLE, unlit, "the sun stands behind the mirror"),
    ],
    summary="How far from the aim point the beam's axis lands, on the plane through it that faces "
    "the mirror.",
)

# ---- drives ----

d.kernel(
    "drive",
    inputs=[c, b],
    outputs=drives,
    cases=regular,
    summary="Drive angles that send the sun to the receiver, front branch: cos(beta) >= 0. With "
    "b = c the mirror faces the sun.",
)
d.kernel(
    "drive_back",
    inputs=[c, b],
    outputs={"alpha": alpha_back, "beta": beta_back},
    cases=regular,
    summary="Drive angles that send the sun to the receiver, back branch, over the top: "
    "cos(beta) <= 0.",
)
d.kernel(
    "drive_nearest",
    inputs=[c, b],
    outputs=drives,
    cases=cases_of_nearest(aim),
    summary="Drive angles that send the sun to the receiver, front branch; in the blind cone those "
    "of the nearest normal that can be had, at the edge of the cone and at the same azimuth.",
)
d.kernel(
    "track",
    inputs=[latitude, declination, hour_angle, b],
    outputs={"alpha": alpha_track, "beta": beta_track},
    cases=cases_of(aim_sun),
    summary="Drive angles, front branch, for the sun at a place and hour. A sun below the horizon "
    "is followed too.",
)
d.kernel(
    "drive_rates",
    inputs=[c, c_dot, b],
    outputs={**drives, "alpha_dot": alpha_dot, "beta_dot": beta_dot},
    cases=regular,
    summary="Drive angles and their rates while the sun moves and the beam is held. To face the "
    "sun itself, b = c, give twice its rate.",
)
d.kernel(
    "drive_sensitivity",
    inputs=[c, b],
    outputs=[J],
    cases=regular,
    summary="Derivatives of the drive angles by theta, psi and chi, front branch. Where the status "
    f"is SINGULAR the azimuth drive is held. {CONDITION}",
)
d.kernel(
    "drive_response",
    inputs=[c, b],
    outputs={"J_c": response, "J_b": response},
    cases=regular,
    summary="Derivatives of the drive angles by the components of c and of b, which are the same. "
    f"Where the status is SINGULAR the azimuth drive is held. {CONDITION}",
)
d.kernel(
    "drive_first_order",
    inputs=[c, b],
    outputs={"alpha": alpha_first, "beta": beta_first},
    cases=law_cases,
    summary="Drive angles to first order in theta, psi and chi; alpha is not brought back into "
    "[-pi, pi]. All three of 10 mrad and normals up to 60 degrees high: alpha is off by at most "
    "0.9 mrad, beta by 0.2; all three of 0.3 rad, up to 45 degrees: by 0.75 and 0.16 rad. Towards "
    "the zenith the error grows without end, and the blind cone is not told.",
)
d.kernel(
    "drive_second_order",
    inputs=[c, b],
    outputs={"alpha": alpha_second, "beta": beta_second},
    cases=law_cases,
    summary="Drive angles to second order in theta, psi and chi; alpha is not brought back into "
    "[-pi, pi]. All three of 10 mrad and normals up to 60 degrees high: alpha is off by at most "
    "0.02 mrad, beta by 0.003; all three of 0.3 rad, up to 45 degrees: by 0.43 and 0.11 rad. "
    "Towards the zenith the error grows without end, and the blind cone is not told.",
)

# ---- errors ----

d.kernel(
    "error_angles",
    inputs=[c, b],
    outputs=[Delta_A, Delta_h],
    cases=[
        *regular,
        (
            Status.SINGULAR,
            overhead,
            "the normal is within 1e-6 of the zenith or the nadir: alpha of ideal axes counts as 0",
        ),
    ],
    summary="Drive angles for ideal axes minus those for the real ones.",
)
d.kernel(
    "normal_errors",
    inputs=[alpha, beta],
    outputs=[e_theta, e_psi, e_chi],
    summary="How far the normal moves per unit of theta, psi and chi, drives held.",
)

# ---- encoders ----

d.kernel(
    "encoder",
    inputs=[alpha, beta],
    outputs={"alpha_reading": alpha_encoder, "beta_reading": beta_encoder},
    cases=reading_cases,
    summary="What the encoders read when the true normal points where alpha and beta would point "
    "the mirror's first axis.",
)
d.kernel(
    "encoder_inverse",
    inputs=[alpha_reading, beta_reading],
    outputs={"alpha": alpha_decoded, "beta": beta_decoded},
    cases=decoding_cases,
    summary="The drive angles that the readings stand for.",
)
d.kernel(
    "pointing_terms",
    inputs=[],
    outputs=[IA, IE, CA, NPAE, AN, AW],
    summary="The errors as the terms of a telescope's pointing model.",
)
d.kernel(
    "pointing",
    inputs=[azimuth, elevation],
    outputs=[delta_azimuth, delta_elevation],
    cases=[
        (
            Status.SINGULAR,
            at_zenith,
            "the normal is within 1e-6 of the zenith or the nadir: delta_azimuth is IA alone",
        )
    ],
    summary="Reading minus azimuth and elevation of the normal, to first order in all six errors; "
    "the azimuth that is read is alpha_reading + pi. All errors of 10 mrad: off by at most 1.4 and "
    "0.4 mrad up to 60 degrees high; of 0.3 rad: by 0.9 and 0.5 rad up to 30 degrees.",
)

d.assume("The azimuth axis, the elevation axis and the mirror's face meet in one point.")
d.assume("The mirror is flat and small: one ray, through that point, stands for the beam.")
d.assume(
    "reflect and beam do not ask which face of the mirror the sun is on; miss does, and the drives "
    "always turn the face to it."
)
d.assume("Axes and mirror are rigid; theta, psi, chi, the encoders' zeros and kappa are constant.")
d.assume("Sun and receiver are given as unit vectors; refraction is in c, if it is wanted.")
d.assume(
    "b and c are not made of length 1: one that is too long by a part e, and is let pass, turns "
    "the normal by e tan(i) / 2 at the angle of incidence i."
)
d.picture(
    stand(Chain("ground").rotate(Z, -PI / 2), post=number("1.2"), arm=number("0.3")),
    at={"theta": 0.12, "psi": 0.1, "alpha": 0.9, "chi": 0.12, "beta": 0.6},
    sun=X,
    caption="The stand with its mirror square to the sun, as for b = c. The azimuth axis leans to "
    "the north by theta and to the east by psi, the elevation axis is inclined by chi; all three "
    "are drawn some hundred times too large. The normal is the mirror's x axis.",
)
