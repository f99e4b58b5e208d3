"""The sun on the four days (Fig. 4), and what the paper says of it."""

import numpy as np

from armillary.verify.plots import Curve, Panels, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .days import apart, attitude, clock_words, day_names, hours, mount, place, toward, whole_study

NOON = 12.0
SOLSTICES = (172, 355)  # June, December
NOT_SOLSTICES = "where the paper has the summer and the winter solstice"
TURN = 2 * np.pi
FINE = 1.0  # minutes
PRINTED_TERM, SPENCER_TERM = 0.0409, 0.040849


def sun_paths(kernels, sun, parameters):
    """Fig. 4, its claims, and the slips in the clock and in the azimuth."""
    yield Heading("Fig. 4: where the sun stands")
    clock, days = hours(parameters, FINE), day_names(parameters)
    paths = {n: path(sun, parameters, n, clock) for n in days}
    yield Plot(
        "Fig. 4 (a): altitude of the sun through the days.", "clock time, h", "altitude, degrees",
        [Curve(days[n], clock[::5], p["altitude"][::5]) for n, p in paths.items()],
    )  # fmt: skip
    yield Panels(
        "Fig. 4 (b): azimuth of the sun through the days; the paper's caption calls it zenith "
        "angle.",
        [
            Plot(
                name, "clock time, h", "azimuth, degrees",
                [Curve(days[n], clock[::5], p[key][::5]) for n, p in paths.items()],
            )
            for name, key in (("from north, clockwise", "azimuth"), ("by (29)", "printed"))
        ],
    )  # fmt: skip
    yield Table(
        "The sun on the four days, azimuth from north.",
        [
            "day", Column("equation of time", "min", ".2f"), Column("highest at", "clock time"),
            Column("highest", "degrees", ".2f"), *ends(parameters, "altitude"),
            *ends(parameters, "azimuth"),
        ],
        [row(sun, days[n], n, p, clock) for n, p in paths.items()],
    )  # fmt: skip
    yield claims(days, paths)
    yield from equinoxes(days, paths, clock)
    yield from origin(kernels, sun, parameters, days)
    yield from minutes_as_hours(sun, parameters, days)


def path(sun, parameters, day, clock):
    """Altitude, azimuth from north and azimuth by (29), in degrees."""
    where = place(sun, parameters, day, clock)
    found = sun.angles(**where)
    return {
        "altitude": np.degrees(found.elevation),
        "azimuth": np.degrees(found.azimuth),
        "printed": np.degrees(printed_azimuth(altitude=found.elevation, **where)),
        "solar time": NOON + np.degrees(where["hour_angle"]) / 15,
    }


def printed_azimuth(altitude, latitude, declination, hour_angle):
    """Equation (29), its single bar read as the other of a pair."""
    cosine = (np.sin(altitude) * np.sin(latitude) - np.sin(declination)) / (
        np.cos(altitude) * np.cos(latitude)
    )
    return np.sign(hour_angle) * np.abs(np.arccos(np.clip(cosine, -1, 1)))


def ends(parameters, what):
    """Columns for both ends of the tracking."""
    for hour in (parameters.days.first, parameters.days.last):
        yield Column(f"{what} at {clock_words(hour)}", "degrees", ".2f")


def row(sun, name, day, found, clock):
    """A day in the table."""
    top = int(np.argmax(found["altitude"]))
    equation = float(sun.spencer(day=float(day)).equation_of_time) / 60
    sides = [found[what][k] for what in ("altitude", "azimuth") for k in (0, -1)]
    return name, equation, clock_words(clock[top]), found["altitude"][top], *sides


def claims(days, paths):
    """Monotonic, and which days reach furthest."""
    least = min(np.diff(p["azimuth"]).min() for p in paths.values())
    low = min(paths, key=lambda n: paths[n]["azimuth"].min())
    high = max(paths, key=lambda n: paths[n]["azimuth"].max())
    tops = {n: p["altitude"].max() for n, p in paths.items()}
    way = "grows throughout" if least > 0 else "does not grow throughout"
    top, bottom = (pick(tops, key=tops.get) for pick in (max, min))
    agrees = "as the paper says" if (top, bottom) == SOLSTICES else NOT_SOLSTICES
    return Prose(
        f"The altitude is highest on the {days[top]} and lowest on the {days[bottom]}, {agrees}. "
        "The paper calls the azimuth monotonic and "
        f"decreasing: from north and clockwise, and by (29) just so, **the azimuth {way}** (at "
        f"least {60 * least:.1f} degrees an hour); what decreases is the Euler angle $\\alpha$ of "
        "(16). The paper puts its largest value on the summer and its smallest on the winter "
        f"solstice; the smallest is that of the {days[low]} "
        f"({paths[low]['azimuth'].min():.1f} degrees), the largest that of the {days[high]} "
        f"({paths[high]['azimuth'].max():.1f})."
    )


def equinoxes(days, paths, clock):
    """Both equinoxes by the clock, and by the sundial."""
    both = [paths[n] for n, name in days.items() if "equinox" in name]
    if len(both) < 2:  # other days were asked for
        return
    one, other = both
    rows = []
    for name, times in (("by the clock", clock), ("by the sundial", one["solar time"])):
        second = clock if name == "by the clock" else other["solar time"]
        # Only times that both days have; beyond the ends there is nothing to compare.
        inside = (times >= second[0]) & (times <= second[-1])
        gaps = [
            np.abs(one[what] - np.interp(times, second, other[what]))[inside].max()
            for what in ("altitude", "azimuth")
        ]
        rows.append((name, *gaps))
    yield Table(
        "Largest difference between the equinoxes.",
        ["compared", Column("altitude", "degrees", ".2f"), Column("azimuth", "degrees", ".2f")],
        rows,
    )
    apart_by = float(np.mean(np.abs(other["solar time"] - one["solar time"]))) * 60
    yield Prose(
        "The equinoxes are nearly equal, says the paper. By the clock they differ by up to "
        f"{rows[0][1]:.1f} degrees of altitude and {rows[0][2]:.1f} of azimuth, because the "
        f"equation of time sets them {apart_by:.1f} minutes apart; by the sundial by up to "
        f"{rows[1][1]:.2f} and {rows[1][2]:.2f} degrees."
    )


def origin(kernels, sun, parameters, days):
    """(16) counts from north, (29) from south."""
    clock = np.array([parameters.days.first, NOON, parameters.days.last])
    rows, least, most = [], 180.0, 0.0
    for n, name in days.items():
        enu = toward(sun, parameters, n, clock)
        where = place(sun, parameters, n, clock)
        printed = printed_azimuth(altitude=sun.angles(**where).elevation, **where)
        beta = attitude(kernels, sun, parameters, n, clock)["beta"]
        alpha = np.pi / 2 - printed
        level = np.sin(beta)
        axis = np.stack([level * np.cos(alpha), level * np.sin(alpha), np.cos(beta)], axis=-1)
        off = np.degrees(apart(axis, enu))
        least, most = min(least, off.min()), max(most, off.max())
        rows.append((name, *off))
    yield Heading("Where azimuth begins")
    yield Table(
        "Angle between the sun and a dish that is aimed by (16) with the azimuth of (29).",
        ["day", *(Column(clock_words(h), "degrees", ".1f") for h in clock)],
        rows,
    )
    turned = half_a_turn(kernels, sun, parameters)
    yield Prose(
        "Equation (16), $\\alpha = 90° - \\gamma_s$ with $X$ east, needs an azimuth from north; "
        "(29) gives one from south, negative in the morning. Together they turn the dish half a "
        "turn about the vertical: it looks away from the sun by twice the zenith angle, "
        f"**{least:.0f} to {most:.0f} degrees**. The lengths of the twelve rods do not tell: half "
        "a turn exchanges opposite facets, and the shortest and the longest rod stay what they "
        f"are (here within {turned:.0e} m). The kernels take the sun's direction itself, and no "
        "origin is chosen."
    )


def half_a_turn(kernels, sun, parameters):
    """Shortest and longest rod with the dish turned by half a turn, less those without."""
    angles, size = whole_study(kernels, sun, parameters), mount(kernels, parameters)
    there, back = (
        kernels.rod_lengths_all(alpha=angles["alpha"] + turn, beta=angles["beta"], **size).l
        for turn in (0.0, np.pi)
    )
    off = max(abs(there.min() - back.min()), abs(there.max() - back.max()), 1e-13)
    return 10.0 ** np.ceil(np.log10(off))


def minutes_as_hours(sun, parameters, days):
    """(32) adds (34), which is in minutes, to hours."""
    rows = []
    for n, name in days.items():
        where = place(sun, parameters, n, NOON)
        minutes = float(sun.spencer(day=float(n)).equation_of_time) / 60
        true = NOON + np.degrees(where["hour_angle"]) / 15
        printed = true - minutes / 60 + minutes
        wrong = {**where, "hour_angle": np.radians(15 * (printed - NOON))}
        heights = [np.degrees(sun.angles(**at).elevation) for at in (where, wrong)]
        rows.append((name, minutes, true, printed, *heights))
    late = max(abs(row[1]) for row in rows) * (1 - 1 / 60)
    yield Heading("What (32) does to the clock")
    yield Table(
        "True solar time at 12:00 by the clock, and the same by (32) as printed.",
        [
            "day", Column("$E_t$ by (34)", "min", ".2f"), Column("true solar time", "h", ".3f"),
            Column("by (32)", "h", ".3f"), Column("altitude", "degrees", ".1f"),
            Column("altitude by (32)", "degrees", ".1f"),
        ],
        rows,
    )  # fmt: skip
    gap = (PRINTED_TERM - SPENCER_TERM) * 86400 / TURN
    yield Prose(
        "(34) gives minutes and (33) hours; (32) adds them. The factor 1/60 that is missing is a "
        f"matter of hours: on these days noon would be off by up to {late:.1f} hours. The paper "
        "cannot have computed so. Its rounded coefficient in (34), "
        f"{PRINTED_TERM:g} for Spencer's {SPENCER_TERM:g}, is worth {gap:.1f} s at most."
    )
