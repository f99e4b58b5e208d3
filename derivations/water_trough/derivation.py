"""The water-displacement trough: one freedom, two containers, a pump, and dry friction.

Each part stands in a file of its own; their order here is their order on the page.
"""

from armillary import Status, near, substitute

from .symbols import STATE, L_t, a_t, alpha, d, m_t, omega, q, q_dot, rho, s, theta
from .water import F_1, F_2, dry, h_1, h_2, misfit, spilt, too_slight
from .tube import ENDS, Gamma_part, I_part, L_part, S_eta_part, S_xi_part, m_part
from .motion import T, V
from .balance import share_A  # noqa: F401
from .friction import (
    F_A_found, F_B_found, M_F, M_FA, M_FB, alpha_found, alpha_smooth, jammed, pressure_found,
    creep, lost, pumped, slips, sticks,
)  # fmt: skip
from .rest import (
    gain, half_width, held_everywhere, indifferent, level_gain, period, q_follow, stiffness,
    theta_dot_ref, theta_rest,
)  # fmt: skip
from .surface import M_level, bares, runs_over, softer, tipped, wall_1, wall_2
from .volumes import (
    no_s_back, no_s_level, no_s_on, no_s_rest, reversal, s_back, s_level, s_on, s_rest, tops,
    tops_level,
)  # fmt: skip
from .across import OFFSETS, F_A_off, F_B_off, F_z, M_O
from .cycle import (
    error_rest, gripped, hunts, no_cycle, outrun, q_pump, swings_back, t_cycle, t_on,
    travel, unfound,
)  # fmt: skip
from .control import (
    astray, blocked, flow, level_1, level_2, pump, pump_next, theta_measured, theta_ref, unfit,
)  # fmt: skip
from .single_axis import (
    along_axis, axis_azimuth, axis_tilt, beyond, crossed, down, enu, ideal, incidence,
    incidence_back, rotation,
)  # fmt: skip
from .linear import kick, pull, swing
from . import assumed  # noqa: F401
from .picture import POSE, scene

derivation = d
SPILT = (
    Status.UNREACHABLE, spilt, "a container would overflow, or hold less than nothing",
)  # fmt: skip
DRY = (Status.LIMIT, dry, "a container is empty: its pump draws air")
JAMMED = (Status.UNREACHABLE, jammed, "the bearings jam, or the trough has no inertia")
STICKS = (Status.STICKING, sticks, "friction holds the trough: the acceleration is 0")
MISFIT = (
    Status.UNREACHABLE, misfit, "mass, length and cross-section of the tube contradict each other",
)  # fmt: skip
SLIGHT = (
    Status.UNREACHABLE, too_slight,
    "no body has so little inertia: it is below M l^2, or its kinetic energy may be negative",
)  # fmt: skip
WATER, WHOLE = [SPILT, MISFIT, DRY], [SPILT, MISFIT, SLIGHT, DRY]
MOVING = [SPILT, MISFIT, SLIGHT, JAMMED, DRY, STICKS]
# Mass, length and cross-section of a tube taken at random would contradict each other.
FULL = {m_t: rho * a_t * L_t}
FREE = (
    Status.SINGULAR, indifferent,
    "the mass centre lies on the axis, within 1e-6 m: any angle is a rest",
)  # fmt: skip
# The water at hand turns the rest by a little only: angles are drawn about the rest without it.
NEAR_REST = {**FULL, theta: near(substitute(theta_rest, {s: 0, **FULL}), by=0.02)}

d.kernel(
    "levels",
    inputs=[s],
    outputs=[h_1, h_2, F_1, F_2],
    cases=[SPILT, DRY],
    summary="Levels in the containers, and the weights of their water.",
)
d.kernel(
    "energy",
    inputs=STATE[:4],
    outputs=[T, V],
    cases=WHOLE,
    summary="Kinetic and potential energy of trough and water.",
    drawn=FULL,
)
d.kernel(
    "acceleration",
    inputs=STATE,
    outputs={"alpha": alpha_found},
    cases=MOVING,
    summary="Angular acceleration with dry friction, and whether it holds the trough. An empty "
    "container's LIMIT hides STICKING: friction holds where omega and alpha are 0.",
    drawn=FULL,
)
d.kernel(
    "acceleration_smooth",
    inputs=STATE,
    outputs={"alpha": alpha_smooth},
    cases=[SPILT, MISFIT, SLIGHT, JAMMED, DRY],
    summary="The same with friction that grows with the speed and never holds.",
    drawn=FULL,
)
d.kernel(
    "friction",
    inputs=STATE,
    outputs=[M_FA, M_FB, M_F],
    cases=MOVING,
    summary="Moments of friction of the bearings on the trough.",
    drawn=FULL,
)
d.kernel(
    "reactions",
    inputs=STATE,
    outputs={"F_A": F_A_found, "F_B": F_B_found},
    cases=MOVING,
    summary="Forces of the bearings on the trough, level and upward.",
    drawn=FULL,
)
d.kernel(
    "pump_pressure",
    inputs=STATE,
    outputs={"pressure": pressure_found},
    cases=MOVING,
    summary="Pressure that the pump must give, without losses in the tube.",
    drawn=FULL,
)
d.kernel(
    "rest_angle",
    inputs=[s],
    outputs={"theta": theta_rest},
    cases=[*WATER, FREE],
    summary="Angle at which the trough rests without friction, in [-pi, pi].",
    drawn=FULL,
)
d.kernel(
    "rest",
    inputs=[s],
    outputs=[stiffness, period, gain],
    cases=[*WHOLE, FREE],
    summary="About the rest: stiffness, period of small swings, and turn per volume moved.",
    drawn=FULL,
)
d.kernel(
    "linear",
    inputs=[s],
    outputs=[swing, pull, kick],
    cases=[SPILT, MISFIT, SLIGHT, JAMMED, DRY, FREE],
    summary="About the rest, without friction: the deviation accelerates by -swing times itself, "
    "pull times the volume moved since, and -kick times the rate of the flow.",
    drawn=FULL,
)
d.kernel(
    "stick_band",
    inputs=[s],
    outputs={"half_width": half_width},
    cases=[*WATER, (Status.CLAMPED, held_everywhere, "friction holds the trough at every angle")],
    summary="Half of the range of angles about the rest where friction holds the trough.",
    drawn=FULL,
)
d.kernel(
    "follow",
    inputs=[s, theta_dot_ref],
    outputs={"q": q_follow},
    cases=[*WATER, FREE, (Status.SINGULAR, level_gain, "moving water turns nothing")],
    summary="Flow at which the rest turns at a rate.",
    drawn=FULL,
)
d.kernel(
    "rest_volume",
    inputs=[theta],
    outputs={"s": s_rest},
    cases=[
        MISFIT,
        (Status.UNREACHABLE, no_s_rest, "no volume makes the trough rest at this angle"),
        (Status.UNREACHABLE, tops, "the rest at this angle does not last"),
    ],
    summary="Volume at which the trough rests at an angle.",
    drawn=NEAR_REST,
)
d.kernel(
    "stick_volumes",
    inputs=[theta],
    outputs={"s_on": s_on, "s_back": s_back, "reversal": reversal},
    cases=[
        MISFIT,
        (Status.UNREACHABLE, no_s_on, "no volume turns the trough on from this angle"),
        (Status.UNREACHABLE, no_s_back, "no volume turns it back"),
    ],
    summary="Volumes at which the trough breaks away from an angle in either sense, and the "
    "water to be moved between them.",
    drawn=NEAR_REST,
)
UNFIT = (Status.UNREACHABLE, unfit, "the errors at which the pump starts and stops contradict")
d.kernel(
    "rest_volume_level",
    inputs=[theta],
    outputs={"s": s_level},
    cases=[
        MISFIT,
        (Status.UNREACHABLE, tipped, "a container lies on its side"),
        (Status.UNREACHABLE, no_s_level, "no volume makes the trough rest at this angle"),
        (Status.UNREACHABLE, tops_level, "the rest at this angle does not last"),
    ],
    summary="Volume at which the trough rests at an angle when the water's surfaces are level.",
    drawn=NEAR_REST,
)
d.kernel(
    "free_surface",
    inputs=[theta, s],
    outputs={"M_level": M_level, "loss": softer, "wall_1": wall_1, "wall_2": wall_2},
    cases=[
        SPILT,
        MISFIT,
        (Status.UNREACHABLE, tipped, "a container lies on its side"),
        (Status.LIMIT, runs_over, "level water would stand higher than a wall"),
        (Status.LIMIT, bares, "a level surface would bare a part of a floor"),
        FREE,
    ],
    summary="What level surfaces, which the other kernels leave out, change: their moment, the "
    "part of the stiffness that they take, and how high water stands at the lower walls.",
    drawn=NEAR_REST,
)
d.kernel(
    "power",
    inputs=STATE,
    outputs={"pump": pumped, "heat": lost},
    cases=MOVING,
    summary="Power of the pump, and what the bearings turn into heat.",
    drawn=FULL,
)
d.kernel(
    "creep",
    inputs=[theta, s],
    outputs={"omega": creep},
    cases=[
        SPILT,
        MISFIT,
        DRY,
        (Status.UNREACHABLE, slips, "the weight overcomes friction: nothing holds"),
    ],
    summary="Angular velocity at which smooth friction lets creep what dry friction would hold.",
    drawn={**FULL, theta: near(substitute(theta_rest, FULL), by=0.01)},
)
d.kernel(
    "reactions_off",
    inputs=[theta, omega, alpha, s, q, q_dot, *OFFSETS],
    outputs={"F_A": F_A_off, "F_B": F_B_off, "F_z": F_z, "M_O": M_O},
    cases=[SPILT, MISFIT, DRY],
    summary="Forces of the bearings without symmetry, at an acceleration; the force along the axis "
    "and the moment about O, frame of the trough.",
    drawn=FULL,
)
d.kernel(
    "tube_part",
    inputs=ENDS,
    outputs=[L_part, m_part, S_xi_part, S_eta_part, I_part, Gamma_part],
    summary="Length, mass and moments of a straight part of the tube; those of the parts add up.",
)
d.kernel(
    "cycle",
    inputs=[s, theta_dot_ref],
    outputs=[t_on, t_cycle, travel, error_rest],
    cases=[
        *WATER,
        FREE,
        UNFIT,
        (Status.UNREACHABLE, gripped, "the trough does not swing: no weight, or too much friction"),
        (Status.UNREACHABLE, outrun, "the sun outruns the pump, or water turns the other way"),
        (Status.UNREACHABLE, swings_back, "friction does not hold the trough where it coasts to"),
        (Status.UNREACHABLE, hunts, "the trough coasts past the sun and starts the other pump"),
        (Status.NOT_CONVERGED, unfound, "no cycle was found"),
        (Status.SINGULAR, no_cycle, "a sun that stands still starts no pump"),
    ],
    summary="The steady cycle of an on-off pump: time for which it runs, period, turn of the "
    "trough, and the error at which the trough comes to rest.",
    drawn={**FULL, theta_dot_ref: near(substitute(gain, FULL) * q_pump / 5, by=1e-6)},
)
d.controller(
    "pump_control",
    inputs=[theta_ref, theta_measured, level_1, level_2],
    outputs={"flow": flow},
    states={pump: pump_next},
    start={pump: 0},
    cases=[
        UNFIT,
        (Status.LIMIT, blocked, "the levels forbid the pump that is asked for"),
        (Status.LIMIT, astray, "a level measured lies outside its container"),
    ],
    summary="An on-off pump with a dead band, and guards of the levels.",
)
AXIS = [enu, axis_azimuth, axis_tilt]
LINE = (Status.SINGULAR, along_axis, "the sun stands in the line of the axis, within 1e-6")
NIGHT = (Status.BELOW_HORIZON, down, "the sun is below the horizon")
d.kernel(
    "single_axis",
    inputs=AXIS,
    outputs={"rotation": ideal, "incidence": incidence},
    cases=[NIGHT, LINE],
    summary="Rotation of a single axis to the sun, and what it misses.",
)
d.kernel(
    "single_axis_backtrack",
    inputs=AXIS,
    outputs={"rotation": rotation, "incidence": incidence_back},
    cases=[
        (Status.UNREACHABLE, crossed, "the limits of the rotation exclude each other"),
        NIGHT,
        LINE,
        (Status.CLAMPED, beyond, "the rotation was cut at a limit"),
    ],
    summary="The same without shading the next row, on a slope, within limits of stroke.",
)

d.picture(scene, at=POSE, caption="The trough, turned by water moved to container 1.")
