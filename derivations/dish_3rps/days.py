"""The suns of the study's days, the dimensions of the dish, and its four facets."""

import numpy as np

MM = 1e3
MILLI = 1e-3
NAMES = {80: "March equinox", 172: "June solstice", 266: "September equinox",
         355: "December solstice"}  # fmt: skip
LONGEST_DAY = 172
FACETS = ("+X", "+Y", "−X", "−Y")
RODS = ("rod 1", "rod 2", "rod 3")
PHI = np.arange(4) * np.pi / 2
STEP = 5.0  # minutes, where a curve is drawn


def day_names(parameters):
    """Day numbers of the study with their names."""
    return {int(n): NAMES.get(int(n), f"day {n}") for n in parameters.days.number}


def hours(parameters, minutes=STEP):
    """Clock times of the tracking."""
    days = parameters.days
    return np.linspace(days.first, days.last, round((days.last - days.first) * 60 / minutes) + 1)


def place(sun, parameters, day, clock):
    """Latitude, declination and hour angle, as the sun's kernels take them."""
    site, year = parameters.site, sun.spencer(day=np.asarray(day, dtype=float))
    hour_angle = sun.hour_angle(
        utc=(np.asarray(clock) - site.zone) * 3600.0,
        longitude=np.radians(site.longitude),
        equation_of_time=year.equation_of_time,
    ).hour_angle
    return {
        "latitude": np.radians(site.latitude),
        "declination": year.declination,
        "hour_angle": hour_angle,
    }


def toward(sun, parameters, day, clock):
    """Unit vectors to the sun."""
    return sun.direction(**place(sun, parameters, day, clock)).enu


def attitude(kernels, sun, parameters, day, clock):
    """Angles of the dish that faces the sun."""
    found = kernels.aim(enu=toward(sun, parameters, day, clock))
    return {"alpha": found.alpha, "beta": found.beta}


def whole_study(kernels, sun, parameters, minutes=STEP, days=()):
    """Angles of the dish on days, those of the study if none are given: arrays of days by times."""
    days = np.array(list(days) or list(day_names(parameters)))[:, None]
    return attitude(kernels, sun, parameters, days, hours(parameters, minutes))


def mount(kernels, parameters):
    """Dimensions as the kernels take them, without the facet's azimuth phi."""
    nominal = parameters.nominal
    f = kernels.focal_length(D=nominal.D, theta_rim=np.radians(nominal.theta_rim)).f
    return {"f": f, "d": nominal.d, "r_b": nominal.r_b, "r_m": nominal.r_m, "z_O": nominal.z_O}


def four(angles):
    """The same attitude for each of the four facets, on the last axis of the batch."""
    return {**{name: np.asarray(a)[..., None] for name, a in angles.items()}, "phi": PHI}


def apart(a, b):
    """Angle between unit vectors, with all its digits when it is small."""
    return 2 * np.arcsin(np.clip(np.linalg.norm(a - b, axis=-1) / 2, 0.0, 1.0))


def clock_words(hour):
    """A clock time in words: 9.5 is 9:30."""
    minutes = round(float(hour) * 60)
    return f"{minutes // 60}:{minutes % 60:02d}"
