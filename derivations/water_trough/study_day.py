"""A day behind the sun: an on-off pump with a dead band, the law its exported C kernel."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from armillary.verify.plots import Axis, Curve, Mark, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .motion_of import Motion, Record
from .pumping import Piece
from .troughs import TITLES, law, trough

LITRE = 1e3
HOUR = 3600.0
TOLERANCE = 1e-9
STEP = 30.0  # s, between two points of a curve of the day
GOOD = 0.03  # by which the closed form of the cycle may miss
BEFORE = 0.5  # h
EDGE = 1e-3  # of the stroke: within it the rotation stands at its limit


@dataclass(frozen=True)
class Tracked:
    """A day of a trough; samples are the controller's.

    Attributes:
        clock: solar time of each sample, h.
        wanted, theta: angle wanted and the trough's own, rad.
        s: volume moved, m^3.
        pump: command of the law for the time that follows.
        record: the motion.
    """

    clock: np.ndarray
    wanted: np.ndarray
    theta: np.ndarray
    s: np.ndarray
    pump: np.ndarray
    record: Record

    @property
    def error(self):
        """Error of the angle, degrees."""
        return np.degrees(self.wanted - self.theta)


def day(kernels, native, sun, parameters, tell):
    """The smaller trough from sunrise to sunset."""
    clock, wanted, turning = suns(kernels, sun, parameters)
    found = track(native, parameters, clock, wanted, tell)
    yield Heading("A day behind the sun")
    yield Prose(
        f"Day {parameters.place.day} of the year at {parameters.place.latitude:g} degrees, from "
        "sunrise to sunset in solar time. `single_axis_backtrack` gives the angle that is "
        "wanted, and `pump_control`, its compiled C called "
        f"once in {parameters.control.period:g} s, says which pump runs; it hears an angle in "
        f"steps of {parameters.control.sensor:g} degrees. Between two of its samples the flow "
        f"comes or goes within {parameters.control.ramp:g} s, and the trough sticks and slips as "
        f"above. It is the {TITLES['small']} trough."
    )
    yield from drawn(native, parameters, found)
    yield table(parameters, found, turning)
    yield Prose(f"{worst(kernels, parameters, found)} {paid(found)}")
    yield from cycles(kernels, parameters, found, turning)


def suns(kernels, sun, parameters):
    """Solar time, angle wanted, and whether it moves freely, from sunrise to sunset."""
    place, step = parameters.place, parameters.control.period
    declination = float(sun.spencer(day=float(place.day)).declination)
    latitude = np.radians(place.latitude)
    half = np.degrees(np.arccos(-np.tan(latitude) * np.tan(declination))) / 15 * HOUR
    time = np.arange(np.ceil((12 * HOUR - half) / step), (12 * HOUR + half) / step) * step
    hour_angle = np.radians((time / HOUR - 12) * 15)
    enu = sun.direction(latitude=latitude, declination=declination, hour_angle=hour_angle).enu
    stroke = np.radians(place.stroke)
    axis = {"enu": enu, "axis_azimuth": np.radians(place.axis_azimuth),
            "axis_tilt": np.radians(place.axis_tilt)}  # fmt: skip
    wanted = kernels.single_axis_backtrack(
        **axis, gcr=place.gcr, cross_axis_tilt=0.0, rotation_min=-stroke, rotation_max=stroke
    ).rotation
    ideal = kernels.single_axis(**axis).rotation
    free = np.abs(wanted - ideal) < EDGE * stroke
    return time / HOUR, np.where(np.isfinite(wanted), wanted, 0.0), free


def track(native, parameters, clock, wanted, tell):
    """The trough under the law, sample by sample."""
    given, settings = trough(parameters), parameters.control
    call = native.pump_control_update.prepare(
        pump=float(native.pump_control_init().pump), theta_ref=0.0, theta_measured=0.0, s=0.0,
        **given, **law(parameters),
    )  # fmt: skip
    motion, record = Motion(native, given, TOLERANCE), Record()
    sensor = np.radians(settings.sensor)
    theta, omega = float(wanted[0]), 0.0
    s = float(native.rest_volume(theta=theta, **given).s)
    q, time, rows = 0.0, clock[0] * HOUR, []
    for k, aim in enumerate(wanted):
        for name, value in (
            ("theta_ref", aim), ("theta_measured", sensor * np.round(theta / sensor)), ("s", s),
        ):  # fmt: skip
            call.inputs[name][...] = value
        call.run()
        flow = float(call.results.flow)
        rows.append((theta, s, np.sign(flow)))
        pieces = sample(time, settings, s, q, flow)
        motion.run(pieces, theta, omega, record=record)
        _, theta, omega, *_ = record.rows[-1]
        time, s, q = pieces[-1].end, pieces[-1].last, flow
        tell(k / len(wanted), f"{clock[k]:.1f} h")
    return Tracked(clock, wanted, *np.array(rows).T, record)


def sample(time, settings, s, before, flow):
    """What flows in a sampling period."""
    end = time + settings.period
    if flow == before:
        return [Piece(time, end, s, flow, flow)]
    ramp = Piece(time, time + settings.ramp, s, before, flow)
    return [ramp, Piece(ramp.end, end, ramp.last, flow, flow)]


# ---- what is shown ----


def drawn(native, parameters, found):
    """Angle, error, levels and reactions."""
    control, given = parameters.control, trough(parameters)
    thin = slice(None, None, max(1, round(STEP / control.period)))
    clock = found.clock[thin]
    yield Plot(
        "The day's angle. The trough lies almost flat at sunrise so that no row shades the next, "
        "goes back to its stop, follows the sun from there to the other stop, and lies flat again.",
        "solar time, h", "angle, degrees",
        [
            Curve("wanted", clock, np.degrees(found.wanted[thin])),
            Curve("trough", clock, np.degrees(found.theta[thin])),
        ],
    )  # fmt: skip
    yield Plot(
        "The error of the angle, with the error at which the pump starts. See a saw within the "
        "dead band, and where the trough leaves it.",
        "solar time, h", "error, degrees",
        [Curve("error", clock, found.error[thin])],
        [Mark(control.band_on, "pump starts"), Mark(-control.band_on, "")],
    )  # fmt: skip
    middle = np.abs(found.clock - 12.0) < 0.1
    yield Plot(
        "Twelve minutes around noon, sample by sample: the trough stands until the sun is ahead by "
        "the dead band, then the pump turns it past the sun.",
        "solar time, h", "angle, degrees",
        [
            Curve("wanted", found.clock[middle], np.degrees(found.wanted[middle])),
            Curve("trough", found.clock[middle], np.degrees(found.theta[middle])),
        ],
    )  # fmt: skip
    yield Plot(
        "What the law asks of the pump in these twelve minutes.",
        "solar time, h", "pump: 1 fills container 1, −1 container 2",
        [Curve("command", found.clock[middle], found.pump[middle])],
    )  # fmt: skip
    levels = native.levels(s=found.s[thin], **given)
    yield Plot(
        "The levels through the day.",
        "solar time, h", Axis("level, mm", low=0.0, high=1e3 * given["h_max"]),
        [Curve("container 1", clock, 1e3 * levels.h_1),
         Curve("container 2", clock, 1e3 * levels.h_2)],
    )  # fmt: skip
    yield carried(native, given, found)


def carried(native, given, found):
    """Largest and least sideways force in each step of the day."""
    states, time = found.record.states, found.record.column("time") / HOUR
    forces = native.reactions(**states, **given)
    sideways = forces.F_A[:, 0] + forces.F_B[:, 0]
    edges = np.linspace(time[0], time[-1], 241)
    cell = np.clip(np.digitize(time, edges) - 1, 0, 239)
    high, low = np.zeros(240), np.zeros(240)
    np.maximum.at(high, cell, sideways)
    np.minimum.at(low, cell, sideways)
    middle = (edges[:-1] + edges[1:]) / 2
    return Plot(
        "Sideways force of both bearings, the largest either way in each 240th of the day: all "
        "there is of dynamics, against a weight of "
        f"{forces.F_A[0, 1] + forces.F_B[0, 1]:.0f} N.",
        "solar time, h", "force, N",
        [Curve("largest", middle, high), Curve("least", middle, low)],
    )  # fmt: skip


def table(parameters, found, free):
    """The day in figures."""
    record, control = found.record, parameters.control
    time, q, work = (record.column(name) for name in ("time", "q", "work"))
    water = float(np.sum(np.abs(q[1:] + q[:-1]) / 2 * np.diff(time)))
    gains = np.diff(work)
    starts = np.count_nonzero((found.pump[1:] != 0) & (found.pump[:-1] == 0))
    error = np.abs(found.error)
    return Table(
        "The day in figures.",
        ["figure", Column("value", "", ".4g"), "unit"],
        [
            ("largest error", error.max(), "degrees"),
            ("largest error where the sun is followed", error[free].max(), "degrees"),
            ("root mean square error there", np.sqrt(np.mean(error[free] ** 2)), "degrees"),
            ("part of that time within the dead band", np.mean(error[free] <= control.band_on), ""),
            ("starts of a pump", int(starts), ""),
            ("time in which a pump runs",
             np.count_nonzero(found.pump) * control.period / 60, "min"),
            ("water moved, both ways", LITRE * water, "l"),
            ("net work of the pump on trough and water", work[-1], "J"),
            ("work that the pump puts in", gains[gains > 0].sum(), "J"),
            ("work that it takes out, on falling water", -gains[gains < 0].sum(), "J"),
            ("heat of the bearings", record.column("heat")[-1], "J"),
            ("changes between stick and slip", len(record.events) - 1, ""),
        ],
    )  # fmt: skip


def periods(kernels, parameters, found, free):
    """Of each cycle while the sun is followed: clock, period, the closed form's, range of error."""
    given = {**trough(parameters), **law(parameters)}
    running = found.pump != 0
    starts = np.flatnonzero(running[1:] & ~running[:-1]) + 1
    rows = []
    for a, b in pairwise(starts):
        if np.all(free[a:b]) and np.all(found.pump[a:b] >= 0):
            span = parameters.control.period * (b - a)
            rate = (found.wanted[b] - found.wanted[a]) / span
            s = (found.s[a] + found.s[b]) / 2
            told = float(kernels.cycle(s=s, theta_dot_ref=rate, **given).t_cycle)
            swept = np.ptp(found.error[a : b + 1])
            rows.append((found.clock[a], span, told, swept))
    return np.array(rows).T


def cycles(kernels, parameters, found, free):
    """Each cycle while the sun is followed, beside the closed form."""
    clock, span, told, swept = periods(kernels, parameters, found, free)
    band = parameters.control.band_on - parameters.control.band_off
    yield Plot(
        "Period of the pump's cycle while the sun is followed: simulated, by the closed form, and "
        "by it with the range that the error really ran through instead of the dead band. See how "
        "nearly all that the closed form misses is that range.",
        "solar time, h", Axis("period, s", low=0.0),
        [
            Curve("simulated", clock, span, style="points"), Curve("closed form", clock, told),
            Curve("closed form, real range", clock, told * swept / band),
        ],
    )  # fmt: skip
    plain, scaled = span / told, span / (told * swept / band)
    yield Prose(
        f"In {len(span)} cycles the period is {np.mean(plain):.3f} of the closed form's in the "
        f"mean, with a standard deviation of {np.std(plain):.3f}. The error runs through "
        f"{np.mean(swept):.3f} degrees and not the {band:g} of the dead band: the law is sampled "
        "and stops the pump late, the sensor has steps, and the trough swings past its rest. "
        f"With the real range the ratio is {np.mean(scaled):.3f}, with a standard deviation of "
        f"{np.std(scaled):.3f}. {cause(float(np.mean(scaled)))}"
    )
    yield Result(
        "cycles",
        {"count": len(span), "plain": float(np.mean(plain)), "scaled": float(np.mean(scaled)),
         "spread": float(np.std(scaled))},
    )  # fmt: skip


def cause(mean):
    """What the closed form is good for."""
    if abs(mean - 1) < GOOD:
        return "**The closed form holds, once the range is known.**"
    return (
        "**The range does not explain it**: the closed form knows one pump that starts and stops, "
        "and neither swings that last nor a pump that runs back."
    )


def worst(kernels, parameters, found):
    """Where the error is largest, and whether the pump is too small there."""
    k = int(np.argmax(np.abs(found.error)))
    before = (found.clock >= found.clock[k] - BEFORE) & (found.clock <= found.clock[k])
    rate = np.gradient(found.wanted, parameters.control.period)[before]
    needed = kernels.follow(s=found.s[before], theta_dot_ref=rate, **trough(parameters)).q
    minutes = round(found.clock[k] * 60)
    words = (
        f"The error is largest at {minutes // 60}:{minutes % 60:02d}, "
        f"{abs(found.error[k]):.2f} degrees. "
    )
    part = float(np.max(np.abs(needed))) / law(parameters)["q_pump"]
    if part > 1:
        return words + (
            f"**The pump is outrun there**: in the half hour before, to follow takes up to "
            f"{part:.2f} times its flow. Rows that must not shade each other turn faster than the "
            "sun."
        )
    return words + f"To follow takes up to {part:.2f} of the pump's flow in the half hour before."


def paid(found):
    """What becomes of the pump's work."""
    work, heat = (found.record.column(name) for name in ("work", "heat"))
    gains = np.diff(work)
    put = gains[gains > 0].sum()
    return (
        f"Of the {put:.2f} J that the pump puts in, it could have back all but {work[-1]:.3f} J: "
        f"water that was lifted sinks again. The bearings make {heat[-1]:.3f} J of heat, and the "
        "rest of the difference is what trough and water have gained. A pump that gives nothing "
        "back, and the losses in its tube, cost more than what the trough asks for."
    )
