"""The water-displacement trough: one freedom, two containers, a pump, and dry friction.

Each part stands in a file of its own; their order here is their order on the page.
"""

from armillary import Status, near, substitute

from .symbols import STATE, d, s, theta
from .water import F_1, F_2, dry, h_1, h_2, spilt
from .motion import T, V
from .balance import share_A  # noqa: F401
from .friction import (
    F_A_found, F_B_found, M_F, M_FA, M_FB, alpha_found, alpha_smooth, jammed, pressure_found,
    sticks,
)  # fmt: skip
from .rest import (
    gain, half_width, indifferent, level_gain, loose, period, q_follow, stiffness, theta_dot_ref,
    theta_rest,
)  # fmt: skip
from .volumes import (
    no_cycle, no_s_back, no_s_on, no_s_rest, outrun, reversal, s_back, s_on, s_rest, t_cycle, t_on,
    tops,
)  # fmt: skip
from .control import blocked, flow, pump, pump_next, theta_measured, theta_ref, unfit
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
WATER, MOVING = [SPILT, DRY], [SPILT, JAMMED, DRY, STICKS]
FREE = (
    Status.SINGULAR, indifferent,
    "the mass centre lies on the axis, within 1e-6 m: any angle is a rest",
)  # fmt: skip
# The water at hand turns the rest by a little only: angles are drawn about the rest without it.
NEAR_REST = {theta: near(substitute(theta_rest, {s: 0}), by=0.02)}

d.kernel(
    "levels",
    inputs=[s],
    outputs=[h_1, h_2, F_1, F_2],
    cases=WATER,
    summary="Levels in the containers, and the weights of their water.",
)
d.kernel(
    "energy",
    inputs=STATE[:4],
    outputs=[T, V],
    cases=WATER,
    summary="Kinetic and potential energy of trough and water.",
)
d.kernel(
    "acceleration",
    inputs=STATE,
    outputs={"alpha": alpha_found},
    cases=MOVING,
    summary="Angular acceleration with dry friction, and whether it holds the trough.",
)
d.kernel(
    "acceleration_smooth",
    inputs=STATE,
    outputs={"alpha": alpha_smooth},
    cases=[SPILT, JAMMED, DRY],
    summary="The same with friction that grows with the speed and never holds.",
)
d.kernel(
    "friction",
    inputs=STATE,
    outputs=[M_FA, M_FB, M_F],
    cases=MOVING,
    summary="Moments of friction of the bearings on the trough.",
)
d.kernel(
    "reactions",
    inputs=STATE,
    outputs={"F_A": F_A_found, "F_B": F_B_found},
    cases=MOVING,
    summary="Forces of the bearings on the trough, level and upward.",
)
d.kernel(
    "pump_pressure",
    inputs=STATE,
    outputs={"pressure": pressure_found},
    cases=MOVING,
    summary="Pressure that the pump must give, without losses in the tube.",
)
d.kernel(
    "rest_angle",
    inputs=[s],
    outputs={"theta": theta_rest},
    cases=[*WATER, FREE],
    summary="Angle at which the trough rests without friction, in [-pi, pi].",
)
d.kernel(
    "rest",
    inputs=[s],
    outputs=[stiffness, period, gain],
    cases=[*WATER, FREE],
    summary="About the rest: stiffness, period of small swings, and turn per volume moved.",
)
d.kernel(
    "linear",
    inputs=[s],
    outputs=[swing, pull, kick],
    cases=[SPILT, JAMMED, DRY, FREE],
    summary="About the rest, without friction: the deviation accelerates by -swing times itself, "
    "pull times the volume moved since, and -kick times the rate of the flow.",
)
d.kernel(
    "stick_band",
    inputs=[s],
    outputs={"half_width": half_width},
    cases=[*WATER, (Status.CLAMPED, loose, "friction holds the trough at every angle")],
    summary="Half of the range of angles about the rest where friction holds the trough.",
)
d.kernel(
    "follow",
    inputs=[s, theta_dot_ref],
    outputs={"q": q_follow},
    cases=[*WATER, FREE, (Status.SINGULAR, level_gain, "moving water turns nothing")],
    summary="Flow at which the rest turns at a rate.",
)
d.kernel(
    "rest_volume",
    inputs=[theta],
    outputs={"s": s_rest},
    cases=[
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
        (Status.UNREACHABLE, no_s_on, "no volume turns the trough on from this angle"),
        (Status.UNREACHABLE, no_s_back, "no volume turns it back"),
    ],
    summary="Volumes at which the trough breaks away from an angle in either sense, and the "
    "water to be moved between them.",
    drawn=NEAR_REST,
)
d.kernel(
    "cycle",
    inputs=[s, theta_dot_ref],
    outputs=[t_on, t_cycle],
    cases=[
        *WATER,
        FREE,
        (Status.UNREACHABLE, outrun, "the sun outruns the pump"),
        (Status.SINGULAR, no_cycle, "a sun that stands still starts no pump"),
    ],
    summary="Time for which an on-off pump runs, and period of its cycle.",
)
d.controller(
    "pump_control",
    inputs=[theta_ref, theta_measured, s],
    outputs={"flow": flow},
    states={pump: pump_next},
    start={pump: 0},
    cases=[
        (Status.UNREACHABLE, unfit, "the errors at which the pump starts and stops contradict"),
        (Status.LIMIT, blocked, "the levels forbid the pump that is asked for"),
        (Status.LIMIT, spilt, "a container overflows, or should hold less than nothing"),
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
