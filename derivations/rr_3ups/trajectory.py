"""The way of the platform through a day: how the attitude that faces the sun moves."""

from dataclasses import dataclass

from armillary import Status, sin, time_derivative, vector
from armillary.derivation.units import RADIAN, SECOND

from .aiming import (
    PRINTED,
    Aim,
    aim,
    aimed,
    alone,
    alpha_aim,
    alpha_before,
    alpha_nearest,
    at_zenith,
    beta_aim,
    beta_before,
    beta_nearest,
    naming,
    unnamed,
)
from .symbols import d, enu

sun = d.use("sun")
latitude, declination = sun.quantity("latitude"), sun.quantity("declination")
hour_angle, hour_angle_rate = sun.quantity("hour_angle"), sun.quantity("hour_angle_rate")

enu_dot = enu.rate("enu_dot", "rate of the unit vector to the sun")
enu_ddot = enu_dot.rate("enu_ddot", "rate of enu_dot")
SPEED, ACCELERATION = RADIAN / SECOND, RADIAN / SECOND**2

# ---- how it moves ----


@dataclass(frozen=True)
class Seen:
    """The direction that is faced and how it moves, in the axes that turn with alpha.

    Attributes:
        rho: length of its horizontal part, 1 where the turn is free.
        square: of its length.
        of_length_one: whether it keeps its length, 1, in every digit.
        v: its rate.
        w: its second derivative.
    """

    aim: Aim
    rho: object
    square: object
    of_length_one: bool
    v: object
    w: object


def follow(aim, c_dot, c_ddot, define, *, of_length_one=False):
    """Rates and accelerations of the attitude that faces a direction: of alpha, then of beta.

    Args:
        of_length_one: the direction keeps its length, 1, in every digit.
    """
    seen = _seen(aim, c_dot, c_ddot, define, of_length_one)
    rates = _rates(seen, define)
    return (*rates, *_accelerations(seen, *rates, define))


def _seen(aim, c_dot, c_ddot, define, of_length_one):
    """How the direction moves, as the carousel sees it."""
    c = aim.c
    rho = define(
        "shadow_{}",
        aim.unless_free(aim.rho, 1),
        because="Where the turn is free the rates are stated, not divided.",
        meaning="length of the horizontal part that the rates are divided by",
        latex=r"\rho_1",
    )
    sine, cosine = c.x / rho, -c.y / rho

    def carousel(v):
        return vector(cosine * v.x + sine * v.y, cosine * v.y - sine * v.x, v.z)

    v = define(
        "v_{}",
        carousel(c_dot),
        because="In the axes that turn with alpha the sun stands at (0, -rho, z). The sine of "
        "alpha and its cosine are the direction's own parts over rho.",
        meaning="rate of the sun's direction, axes turned by alpha",
        latex=r"\mathbf{v}",
    )
    w = define(
        "w_{}",
        carousel(c_ddot),
        because="A derivative of the components in fixed axes, seen in turned ones as the rate is.",
        meaning="second derivative of the sun's direction, axes turned by alpha",
        latex=r"\mathbf{w}",
    )
    square = 1 if of_length_one else aim.rho * aim.rho + c.z * c.z
    return Seen(aim, rho, square, of_length_one, v, w)


def _rates(seen, define):
    """Rates of the turn and of the tilt."""
    aim, rho, v = seen.aim, seen.rho, seen.v
    alpha_dot = define(
        "alpha_{}_dot",
        aim.unless_free(v.x) / rho,
        because="Only a turn moves the sun's direction along the axis of the tilt, by rho per "
        "unit. Where the turn is free no rate is defined; 0 holds the axis.",
        meaning="rate of the turn that faces the sun",
        unit=SPEED,
        latex=r"\dot{\alpha}",
    )
    beta_dot = define(
        "beta_{}_dot",
        aim.unless_free(-(aim.c.z * v.y + rho * v.z)) / seen.square,
        because="In the upright plane through the sun beta is the angle of a point that moves: "
        "the cross product of place and velocity over the square of the distance.",
        meaning="rate of the tilt that faces the sun",
        unit=SPEED,
        latex=r"\dot{\beta}",
    )
    return alpha_dot, beta_dot


def _accelerations(seen, alpha_dot, beta_dot, define):
    """Accelerations of the turn and of the tilt."""
    aim, rho, v, w = seen.aim, seen.rho, seen.v, seen.w
    alpha_ddot = define(
        "alpha_{}_ddot",
        aim.unless_free(w.x + 2 * alpha_dot * v.y) / rho,
        because="Along the axis of the tilt the acceleration is that of the turn, and Coriolis's, "
        "twice the turn's rate by that of rho.",
        meaning="acceleration of the turn that faces the sun",
        unit=ACCELERATION,
        latex=r"\ddot{\alpha}",
    )
    outward = rho * alpha_dot * alpha_dot - w.y
    growth = 0 if seen.of_length_one else 2 * (aim.c.z * v.z - rho * v.y) * beta_dot
    beta_ddot = define(
        "beta_{}_ddot",
        aim.unless_free(aim.c.z * outward - rho * w.z - growth) / seen.square,
        because="The rate of that cross product: what the turn bends inward is added to the "
        "acceleration outward, as rho grows by both.",
        meaning="acceleration of the tilt that faces the sun",
        unit=ACCELERATION,
        latex=r"\ddot{\beta}",
    )
    return alpha_ddot, beta_ddot


motion = follow(aimed, enu_dot, enu_ddot, naming("aim", r"\mathrm{aim}", printed=PRINTED))
for _what, _found, _wanted in zip(
    (
        "rate of the turn",
        "rate of the tilt",
        "acceleration of the turn",
        "acceleration of the tilt",
    ),
    follow(alone, enu_dot, enu_ddot, unnamed),
    (
        time_derivative(alone.alpha),
        time_derivative(alone.beta),
        time_derivative(time_derivative(alone.alpha)),
        time_derivative(time_derivative(alone.beta)),
    ),
    strict=True,
):
    d.identity(f"the {_what} is what differentiation gives", _found, _wanted)

# ---- with the sun by the clock ----

enu_sun = d.define(
    "enu_sun",
    sun["enu"],
    because="The sun is where latitude, declination and hour angle put it.",
    meaning="unit vector to the sun of a place, a day and an hour",
    latex=r"\mathbf{c}_\odot",
)
enu_dot_sun = d.define(
    "enu_dot_sun",
    sun["enu_dot"],
    because="The place and the declination are held, so that the hour angle alone moves the sun.",
    meaning="rate of the direction to that sun",
    latex=r"\dot{\mathbf{c}}_\odot",
)
enu_ddot_sun = d.define(
    "enu_ddot_sun",
    -(hour_angle_rate * hour_angle_rate) * (enu_sun - sin(declination) * sun["pole"]),
    because="At a steady rate of the hour angle and a declination that is held the sun goes round "
    "a circle about the celestial pole: it falls towards the circle's centre.",
    meaning="second derivative of the direction to that sun",
    latex=r"\ddot{\mathbf{c}}_\odot",
)
d.identity(
    "it is what the turn about the pole makes of the rate",
    enu_ddot_sun,
    hour_angle_rate * enu_dot_sun.cross(sun["pole"]),
)
_define = naming("track", r"\odot", printed=PRINTED, reasons=False)
tracked = aim(enu_sun, _define)
tracked_motion = follow(tracked, enu_dot_sun, enu_ddot_sun, _define, of_length_one=True)
below_horizon = d.define(
    "below_horizon",
    enu_sun.z < 0,
    because="The centre of the sun, without refraction, as at the limits of the day.",
    meaning="whether the sun is below the horizon",
    latex=r"\mathit{below}",
)

# ---- kernels ----

ZENITH = "the sun is within 1e-6 of the zenith or the nadir: alpha is free"
ANGLES = ("alpha", "beta")
STATE = (*ANGLES, "alpha_dot", "beta_dot", "alpha_ddot", "beta_ddot")

d.kernel(
    "aim",
    inputs=[enu],
    outputs=dict(zip(ANGLES, (alpha_aim, beta_aim), strict=True)),
    cases=[(Status.SINGULAR, at_zenith, ZENITH)],
    summary="Attitude of the platform that faces the sun, with beta in [0, pi].",
)
d.kernel(
    "aim_nearest",
    inputs=[enu, alpha_before, beta_before],
    outputs=dict(zip(ANGLES, (alpha_nearest, beta_nearest), strict=True)),
    cases=[(Status.SINGULAR, at_zenith, f"{ZENITH} and held, and the tilt follows what it can")],
    summary="Attitude of the platform that faces the sun and is reached from the attitude before "
    "by the smallest turn of the platform; beta of either sign. Angles are not wrapped, so half a "
    "turn is no border, and a sun that does not set winds alpha up. Through the zenith alpha is "
    "held and beta changes its sign. Past it at the distance rho alpha must turn by nearly half "
    "a turn, as fast as the sun's speed over rho: it follows if it turns by less than a quarter "
    "from call to call, else it stays and beta changes its sign.",
)
d.kernel(
    "aim_rates",
    inputs=[enu, enu_dot, enu_ddot],
    outputs=dict(zip(STATE, (alpha_aim, beta_aim, *motion), strict=True)),
    cases=[(Status.SINGULAR, at_zenith, f"{ZENITH}, and every rate is given as 0")],
    summary="Attitude that faces the sun with beta in [0, pi], its rates and its accelerations. "
    "The attitude with the other sign of beta has the same rates of alpha, and those of beta "
    "with the other sign.",
)
d.kernel(
    "track",
    inputs=[latitude, declination, hour_angle, hour_angle_rate],
    outputs=dict(zip(STATE, (tracked.alpha, tracked.beta, *tracked_motion), strict=True)),
    cases=[
        (Status.SINGULAR, tracked.free, f"{ZENITH}, and every rate is given as 0"),
        (
            Status.BELOW_HORIZON,
            below_horizon,
            "the sun is below the horizon: the attitude still faces it",
        ),
    ],
    summary="The same for the sun of a place, a day and an hour; the limits of the day are "
    "`day_limits` of the sun.",
)
d.assume(
    "In `track` the hour angle runs steadily and the declination is held: its own rate, at most "
    "8.2e-8 rad/s, is missing in the rates. It is a nine-hundredth of the hour angle's."
)
