"""What the parts of the study share: the mount, the days, and the forces through a day."""

from dataclasses import dataclass

import numpy as np

from armillary.verify.study import text_of

NAMES = ("summer solstice", "spring equinox", "autumn equinox", "winter solstice")
SUMMER, SPRING, AUTUMN, WINTER = range(4)
ANGLES = ("phi", "theta", "zeta")
LEGS = ("leg 1", "leg 2", "leg 3")
STATE = ("alpha", "beta", "alpha_dot", "beta_dot", "alpha_ddot", "beta_ddot")
SINGULAR = 2  # the status
NOON = 12.0
AROUND = 1.0  # h, within which a time is around noon
DAY = 86400.0  # s
HOUR = 3600.0  # s
TURNING = 2 * np.pi / DAY  # rad/s, of the sun about the pole
CALM = {"f_d": np.zeros(3), "n_d": np.zeros(3)}
CLIPPED = 200.0  # N, beyond which a curve of the two drives is not drawn
WITHIN = 0.05  # of a published figure, within which it is reproduced


@dataclass(frozen=True)
class Day:
    """A day from sunrise to sunset.

    Attributes:
        clock: solar time, h.
        state: the two angles, their rates and accelerations, as the kernels take them.
    """

    name: str
    clock: np.ndarray
    state: dict[str, np.ndarray]

    @property
    def pose(self):
        """The two angles."""
        return {key: self.state[key] for key in STATE[:2]}

    @property
    def motion(self):
        """The two angles and their rates."""
        return {key: self.state[key] for key in STATE[:4]}


def mount(parameters, **changed):
    """The kernels' parameters in SI units; `changed` replaces some."""
    given = {**parameters.mount, **parameters.bodies}
    size = {name: np.array(value, dtype=float) for name, value in given.items()}
    size.update({name: np.radians(size[name]) for name in ANGLES})
    return {**size, **changed}


def near(ours, theirs):
    """Whether a published figure is reproduced."""
    return abs(ours - theirs) <= WITHIN * abs(theirs)


def centre_words(parameters):
    """Where the platform's mass centre is taken, in words."""
    centre = parameters.bodies.r_sc
    if not any(centre):
        return "at o"
    x, y, z = (text_of(1e3 * at, "g") for at in centre)
    return f"at [{x} {y} {z}] mm from o"


def around_noon(clock):
    """Which solar times are around noon."""
    return np.abs(np.asarray(clock) - NOON) <= AROUND + 1e-9


def declination(parameters, which):
    """Declination on one of the four days, rad."""
    return np.radians(parameters.days.declination[which])


def sunrise_and_sunset(sun, parameters, angle):
    """Solar times at which a sun of this declination rises and sets, h."""
    found = sun.day_limits(latitude=np.radians(parameters.site.latitude), declination=angle)
    return clock_of(found.rise), clock_of(found.set)


def clock_of(hour_angle):
    """Solar time of an hour angle, h."""
    return NOON + np.degrees(hour_angle) / 15


def hour_angle_of(clock):
    """Hour angle of a solar time, rad."""
    return np.radians(15 * (np.asarray(clock, dtype=float) - NOON))


def state_at(kernels, parameters, angle, clock, speed_up=1.0):
    """State of the platform that faces the sun; time may run faster."""
    found = kernels.track(
        latitude=np.radians(parameters.site.latitude),
        declination=angle,
        hour_angle=hour_angle_of(clock),
        hour_angle_rate=TURNING * speed_up,
    )
    return {key: np.asarray(getattr(found, key)) for key in STATE}


def day_of(kernels, sun, parameters, which=SPRING, minutes=None):
    """One of the four days, with noon among its times and steps of at most `minutes`."""
    angle = declination(parameters, which)
    rise, set_ = sunrise_and_sunset(sun, parameters, angle)
    step = (parameters.sampling.step if minutes is None else minutes) / 60
    count = 2 * int(np.ceil((set_ - rise) / 2 / step - 1e-9))
    clock = np.linspace(rise, set_, count + 1)
    return Day(NAMES[which], clock, state_at(kernels, parameters, angle, clock))


def held(found, what):
    """A result where the drives hold the platform, NaN where they do not."""
    values = np.asarray(getattr(found, what), dtype=float)
    loose = np.asarray(found.status) == SINGULAR
    return np.where(loose.reshape(loose.shape + (1,) * (values.ndim - loose.ndim)), np.nan, values)


def three(kernels, state, size):
    """Forces of the three drives, N."""
    return held(kernels.forces(**state, **CALM, **size), "F")


def two(kernels, state, size):
    """Forces of the two drives of the mechanism without leg 3, N."""
    return held(kernels.forces_two_legs(**state, **CALM, **size), "F")


def over_time(values, clock):
    """Integral over the day by trapezoids, per second; what is missing is passed over."""
    kept = np.isfinite(values)
    return float(np.trapezoid(values[kept], HOUR * clock[kept]))


def mean(values, clock):
    """Mean over the day by trapezoids."""
    return over_time(values, clock) / (HOUR * (clock[-1] - clock[0]))


def clock_words(hour):
    """A solar time in words: 9.5 is 9:30."""
    minutes = round(float(hour) * 60)
    return f"{minutes // 60}:{minutes % 60:02d}"


def crossings(kernels, parameters, angle, clock, size):
    """Solar times at which two drives cease to hold the platform, to the last digit."""
    return [
        root(lambda t: determinant(kernels, parameters, angle, t, size), *ends)
        for ends in sign_changes(determinant(kernels, parameters, angle, clock, size), clock)
    ]


def determinant(kernels, parameters, angle, clock, size):
    """Determinant of the Jacobian of legs 1 and 2 at solar times, m^2."""
    state = state_at(kernels, parameters, angle, clock)
    return kernels.singularity(alpha=state["alpha"], beta=state["beta"], **size).det_2


def sign_changes(values, clock):
    """Pairs of neighbouring times with a zero between them."""
    found = np.flatnonzero(np.sign(values[1:]) != np.sign(values[:-1]))
    return [(float(clock[k]), float(clock[k + 1])) for k in found]


def root(of, low, high):
    """A zero by bisection."""
    rising = of(low) < 0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if (of(middle) < 0) == rising else (low, middle)
    return (low + high) / 2
