"""A day behind the sun: an on-off pump with a dead band, the law its exported C kernel."""

from dataclasses import dataclass

import numpy as np

from armillary.verify.plots import Axis, Curve, Mark, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .motion_of import Motion, Record
from .pumping import Piece
from .study_cycle import cycles
from .troughs import SIZES, TITLES, law, trough

LITRE = 1e3
HOUR = 3600.0
TOLERANCE = 1e-9
STEP = 30.0  # s, between two points of a curve of the day
BEFORE = 0.5  # h
CELLS = 240
CLOCK = "solar time, h"
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
    """Both troughs from sunrise to sunset; the smaller is drawn."""
    clock, wanted, turning = suns(kernels, sun, parameters)
    found = {}
    for k, size in enumerate(SIZES):
        found[size] = track(
            native, parameters, size, clock, wanted,
            lambda part, at, k=k, size=size: tell((k + part) / 2, f"{TITLES[size]}, {at}"),
        )  # fmt: skip
    small = found[SIZES[0]]
    yield Heading("A day behind the sun")
    yield Prose(
        f"Day {parameters.place.day} of the year at {parameters.place.latitude:g} degrees, from "
        "sunrise to sunset in solar time. `single_axis_backtrack` gives the angle that is "
        "wanted, and `pump_control`, its compiled C called "
        f"once in {parameters.control.period:g} s, says which pump runs; it hears an angle in "
        f"steps of {parameters.control.sensor:g} degrees, and the levels. Between two of its "
        f"samples the flow comes or goes within {parameters.control.ramp:g} s, and the trough "
        "sticks and slips as above. The curves are of the "
        f"{TITLES[SIZES[0]]} trough where they do not say so."
    )
    yield from drawn_angles(parameters, small)
    yield drawn_errors(parameters, found)
    yield from drawn_noon(small)
    yield from drawn_loads(native, parameters, small)
    yield table(parameters, found, turning)
    for size in SIZES:
        yield Prose(worst(kernels, parameters, size, found[size]))
    yield Prose(paid(small))
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


def track(native, parameters, size, clock, wanted, tell):
    """A trough under the law, sample by sample."""
    given, settings = trough(parameters, size), parameters.control
    call = native.pump_control_update.prepare(
        pump=float(native.pump_control_init().pump), theta_ref=0.0, theta_measured=0.0,
        level_1=0.0, level_2=0.0, **given, **law(parameters, size),
    )  # fmt: skip
    motion, record = Motion(native, given, TOLERANCE), Record()
    sensor = np.radians(settings.sensor)
    theta, omega = float(wanted[0]), 0.0
    s = float(native.rest_volume(theta=theta, **given).s)
    q, time, rows = 0.0, clock[0] * HOUR, []
    for k, aim in enumerate(wanted):
        for name, value in (
            ("theta_ref", aim), ("theta_measured", sensor * np.round(theta / sensor)),
            ("level_1", given["h_10"] + s / given["A_1"]),
            ("level_2", given["h_20"] - s / given["A_2"]),
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


def thinned(parameters, found):
    """Every how many samples a curve of the day has a point, and the clock there."""
    thin = slice(None, None, max(1, round(STEP / parameters.control.period)))
    return thin, found.clock[thin]


def drawn_angles(parameters, found):
    """The angle through the day."""
    thin, clock = thinned(parameters, found)
    yield Plot(
        "The day's angle. The trough lies almost flat at sunrise so that no row shades the next, "
        "goes back to its stop, follows the sun from there to the other stop, and lies flat again.",
        CLOCK, "angle, degrees",
        [
            Curve("wanted", clock, np.degrees(found.wanted[thin])),
            Curve("trough", clock, np.degrees(found.theta[thin])),
        ],
    )  # fmt: skip


def drawn_errors(parameters, found):
    """The errors of both."""
    thin, clock = thinned(parameters, found[SIZES[0]])
    on = parameters.control.band_on
    return Plot(
        "The error of the angle of both troughs, with the error at which the pump starts. See a "
        "saw within the dead band, and where a trough leaves it.",
        CLOCK, "error, degrees",
        [Curve(TITLES[size], clock, of.error[thin]) for size, of in found.items()],
        [Mark(on, "pump starts"), Mark(-on, "")],
    )  # fmt: skip


def drawn_noon(found):
    """A few cycles."""
    middle = np.abs(found.clock - 12.0) < 0.1
    clock = found.clock[middle]
    yield Plot(
        "Twelve minutes around noon, sample by sample: the trough stands until the sun is ahead by "
        "the dead band, then the pump turns it past the sun.",
        CLOCK, "angle, degrees",
        [
            Curve("wanted", clock, np.degrees(found.wanted[middle])),
            Curve("trough", clock, np.degrees(found.theta[middle])),
        ],
    )  # fmt: skip
    yield Plot(
        "What the law asks of the pump in these twelve minutes.",
        CLOCK, "pump: 1 fills container 1, −1 container 2",
        [Curve("command", clock, found.pump[middle])],
    )  # fmt: skip


def drawn_loads(native, parameters, found):
    """Levels, and the forces of the bearings."""
    given = trough(parameters)
    thin, clock = thinned(parameters, found)
    levels = native.levels(s=found.s[thin], **given)
    yield Plot(
        "The levels through the day.",
        CLOCK, Axis("level, mm", low=0.0, high=1e3 * given["h_max"]),
        [Curve("container 1", clock, 1e3 * levels.h_1),
         Curve("container 2", clock, 1e3 * levels.h_2)],
    )  # fmt: skip
    forces = native.reactions(**found.record.states, **given)
    time = found.record.column("time") / HOUR
    for told, k in (("Sideways", 0), ("Upward", 1)):
        rests = [float(force[0, k]) for force in (forces.F_A, forces.F_B)]
        yield Plot(
            f"{told} force of each bearing, less what it is at sunrise, "
            f"{rests[0]:.1f} N on A and {rests[1]:.1f} N on B: the largest either way in each "
            f"{CELLS}th of the day. The motion adds this much.",
            CLOCK, "force, N",
            [
                curve
                for name, force, at in zip("AB", (forces.F_A, forces.F_B), rests, strict=True)
                for curve in ends(f"{name}", time, force[:, k] - at)
            ],
        )  # fmt: skip


def ends(name, time, force):
    """Largest and least of a force in each part of the day."""
    edges = np.linspace(time[0], time[-1], CELLS + 1)
    cell = np.clip(np.digitize(time, edges) - 1, 0, CELLS - 1)
    high, low = np.full(CELLS, -np.inf), np.full(CELLS, np.inf)
    np.maximum.at(high, cell, force)
    np.minimum.at(low, cell, force)
    met, middle = np.isfinite(high), (edges[:-1] + edges[1:]) / 2
    return [
        Curve(f"{name}, largest", middle[met], high[met]),
        Curve(f"{name}, least", middle[met], low[met]),
    ]


def table(parameters, found, free):
    """The day in figures."""
    columns = [figures(parameters, of, free) for of in found.values()]
    return Table(
        "The day in figures.",
        ["figure", *(Column(TITLES[size], "", ".4g") for size in found), "unit"],
        [
            (name, *(of[name][0] for of in columns), unit)
            for name, (_, unit) in columns[0].items()
        ],
    )  # fmt: skip


def figures(parameters, found, free):
    """Each with its unit."""
    record, control = found.record, parameters.control
    time, q, work = (record.column(name) for name in ("time", "q", "work"))
    gains, error = np.diff(work), np.abs(found.error)
    starts = np.count_nonzero((found.pump[1:] != 0) & (found.pump[:-1] == 0))
    water = float(np.sum(np.abs(q[1:] + q[:-1]) / 2 * np.diff(time)))
    return {
        "largest error": (error.max(), "degrees"),
        "largest error where the sun is followed": (error[free].max(), "degrees"),
        "root mean square error there": (np.sqrt(np.mean(error[free] ** 2)), "degrees"),
        "part of that time within the dead band": (np.mean(error[free] <= control.band_on), ""),
        "starts of a pump": (int(starts), ""),
        "time in which a pump runs": (np.count_nonzero(found.pump) * control.period / 60, "min"),
        "water moved, both ways": (LITRE * water, "l"),
        "net work of the pump on trough and water": (work[-1], "J"),
        "work that the pump puts in": (gains[gains > 0].sum(), "J"),
        "work that it takes out, on falling water": (-gains[gains < 0].sum(), "J"),
        "heat of the bearings": (record.column("heat")[-1], "J"),
        "changes between stick and slip": (len(record.events) - 1, ""),
    }  # fmt: skip


def worst(kernels, parameters, size, found):
    """Where the error is largest, and whether the pump is too small there."""
    k = int(np.argmax(np.abs(found.error)))
    before = (found.clock >= found.clock[k] - BEFORE) & (found.clock <= found.clock[k])
    rate = np.gradient(found.wanted, parameters.control.period)[before]
    needed = kernels.follow(s=found.s[before], theta_dot_ref=rate, **trough(parameters, size)).q
    minutes = round(found.clock[k] * 60)
    words = (
        f"The error of the {TITLES[size]} trough is largest at {minutes // 60}:{minutes % 60:02d}, "
        f"{abs(found.error[k]):.2f} degrees. "
    )
    part = float(np.max(np.abs(needed))) / law(parameters, size)["q_pump"]
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
