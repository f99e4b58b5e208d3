"""The sun once more: ERFA for directions, pvlib for formulas, the NREL SPA for the truth."""

from dataclasses import replace

import numpy as np

from armillary import Status
from armillary.verify.engines import each, need
from armillary.verify.measured import compare
from armillary.verify.points import chosen

COUNT = 500
TURN = 2 * np.pi
FIRST_YEAR, LAST_YEAR = 2020, 2050
HOURS_APART = 5  # prime to 24, so that every time of the day is met
DELTA_T = 69.2  # s, terrestrial less universal time
ZENITH = 1e-6  # distance from the zenith within which the azimuth is free
ATMOSPHERE = 0.5667  # deg, the refraction at which the SPA calls the sun set
# What the NREL SPA is asked: the sun over (0, 0) at sea level, in 1010 hPa and 10 deg C.
SETTING = (0.0, 0.0, 0.0, 1010.0, 10.0, DELTA_T, ATMOSPHERE, 1)


def places():
    """Random places and hours, and a grid of the awkward ones.

    On the grid: both poles, the equator, zenith and nadir, the horizon due north, east, south and
    west, noon and midnight, and hairs off each.
    """
    random = np.random.default_rng(3)
    quarter = np.pi / 2
    hairs = np.array([0.0, 1e-3, -1e-6, 1e-9])
    latitude = np.append(np.array([-quarter, 0.0, 0.4, quarter, 1.0]), 0.4 + hairs[1:])
    declination = np.array([-0.41, 0.0, 0.4, 0.41, quarter, -quarter])
    hour = (np.arange(-2, 3)[:, None] * quarter + hairs).ravel()
    grid = np.meshgrid(latitude, declination, hour, indexing="ij")
    spread = (
        random.uniform(-quarter, quarter, COUNT),
        random.uniform(-0.41, 0.41, COUNT),
        random.uniform(-np.pi, np.pi, COUNT),
    )
    names = ("latitude", "declination", "hour_angle")
    return {
        name: np.concatenate([a.ravel(), b]) for name, a, b in zip(names, grid, spread, strict=True)
    }


def horizontal(place):
    """Azimuth and elevation by ERFA."""
    return need("erfa").hd2ae(place["hour_angle"], place["declination"], place["latitude"])


def direction(azimuth, elevation):
    """East, north, up of a direction, by ERFA."""
    north, east, up = np.moveaxis(need("erfa").s2c(azimuth, elevation), -1, 0)
    return np.stack([east, north, up], axis=-1)


def nothing(name, found, inputs, kernel, engine="bounds"):
    """What must be exactly zero at every point: an excess, or a claim that is not true."""
    return compare(name, engine, found, 0.0, 0.0, inputs, kernel)


def checks(kernels):
    """Everything measured about the sun."""
    yield from each(
        kernels,
        direction_by_erfa,
        angles_by_erfa,
        direction_by_pvlib,
        rates_by_erfa,
        limits_by_erfa,
        polar_days_by_erfa,
        clock_by_pvlib,
        refraction_by_spa,
        almanacs_by_spa,
        almanacs_by_pvlib,
    )


# -- direction and angles -------------------------------------------------------------------------


def direction_by_erfa(kernels):
    """The direction, and the angles that lead back to it, everywhere."""
    place = places()
    azimuth, elevation = horizontal(place)
    enu = kernels.direction(**place).enu
    yield compare(
        "direction, awkward places among them", "ERFA", enu, direction(azimuth, elevation), 1e-13,
        place, "direction",
    )  # fmt: skip
    found = kernels.angles(**place)
    regular = found.status == Status.OK
    yield compare(
        "elevation and azimuth lead back to the direction", "round trip",
        direction(found.azimuth, found.elevation)[regular], enu[regular], 1e-13,
        chosen(place, regular), "angles",
    )  # fmt: skip


def angles_by_erfa(kernels):
    """Elevation and azimuth everywhere, and the zenith where the azimuth is free."""
    place = places()
    azimuth, elevation = horizontal(place)
    found = kernels.angles(**place)
    yield compare("elevation", "ERFA", found.elevation, elevation, 1e-13, place, "angles")
    across = np.cos(elevation)
    turned = np.remainder(found.azimuth - azimuth + np.pi, TURN) - np.pi
    regular = found.status == Status.OK
    yield compare(
        "azimuth, as the arc it moves the sun by", "ERFA", (turned * across)[regular], 0.0, 1e-13,
        chosen(place, regular), "angles",
    )  # fmt: skip
    decided = np.abs(across - ZENITH) > 1e-9  # ERFA's rounding and ours may part on the edge
    status = np.where(across < ZENITH, Status.SINGULAR, Status.OK)
    claim = "the azimuth is called singular just where the sun is at the zenith or the nadir"
    wrong = (found.status != status)[decided]
    yield nothing(claim, wrong, chosen(place, decided), "angles", "ERFA")
    yield nothing("and it is 0 there", found.azimuth[~regular], chosen(place, ~regular), "angles")
    beyond = (found.azimuth < 0) | (found.azimuth >= TURN)
    yield nothing("azimuth lies in [0, 2 pi)", beyond, place, "angles")


def direction_by_pvlib(kernels):
    """Pvlib's formulas use arc cosines, which are blunt on the meridian and at the zenith."""
    pvlib = need("pvlib.solarposition")
    random = np.random.default_rng(4)
    place = {
        "latitude": random.uniform(-1.4, 1.4, COUNT),
        "declination": random.uniform(-0.41, 0.41, COUNT),
        "hour_angle": random.uniform(-np.pi, np.pi, COUNT),
    }
    latitude, declination, hour = place.values()
    zenith = pvlib.solar_zenith_analytical(latitude, hour, declination)
    azimuth = pvlib.solar_azimuth_analytical(latitude, hour, declination, zenith)
    degree = np.radians(1)
    clear = np.abs(np.sin(azimuth)) > np.sin(degree)
    clear &= np.abs(np.cos(zenith)) < np.cos(degree)
    yield compare(
        "direction, more than 1 deg off the meridian", "pvlib",
        kernels.direction(**chosen(place, clear)).enu,
        direction(azimuth[clear], np.pi / 2 - zenith[clear]), 1e-13, chosen(place, clear),
        "direction",
    )  # fmt: skip


def over_a_second():
    """Times and weights of Gauss's quadrature over one second."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    return (nodes + 1) / 2, weights / 2


def rates_by_erfa(kernels):
    """Rates add up to the angles that ERFA's sun goes through, wherever it keeps off the zenith."""
    random = np.random.default_rng(5)
    start = {
        "latitude": random.uniform(-1.5, 1.5, COUNT),
        "declination": random.uniform(-0.41, 0.41, COUNT),
        "hour_angle": random.uniform(-np.pi, np.pi, COUNT),
    }
    speed = random.uniform(0.1, 0.3, COUNT)  # so that it moves by this much in a second
    times, weights = over_a_second()

    def at(time):
        return {**start, "hour_angle": start["hour_angle"] + time * speed}

    found = [kernels.rates(**at(time), hour_angle_rate=speed) for time in times]
    heights = np.stack([horizontal(at(time))[1] for time in times])
    clear = np.abs(heights).max(axis=0) < np.radians(75)
    (azimuth_0, elevation_0), (azimuth_1, elevation_1) = horizontal(at(0.0)), horizontal(at(1.0))
    rise = np.tensordot(weights, np.stack([f.elevation_rate for f in found]), axes=1)
    turn = np.tensordot(weights, np.stack([f.azimuth_rate for f in found]), axes=1)
    given = chosen({**start, "hour_angle_rate": speed}, clear)
    yield compare(
        "the rates of the elevation add up", "ERFA", rise[clear],
        (elevation_1 - elevation_0)[clear], 1e-12, given, "rates",
    )  # fmt: skip
    yield compare(
        "the rates of the azimuth add up", "ERFA", turn[clear], (azimuth_1 - azimuth_0)[clear],
        1e-12, given, "rates", turn=True,
    )  # fmt: skip


# -- sunrise and sunset ---------------------------------------------------------------------------


def days():
    """Latitudes and declinations: usual ones, polar days and nights, and some past the pole."""
    random = np.random.default_rng(6)
    quarter = np.pi / 2
    steep = np.array([[quarter, 0.3], [quarter, -0.3], [-quarter, 0.3], [1.5, -0.41], [1.5, 0.41]])
    past = np.stack([random.uniform(quarter, TURN, 40), random.uniform(-0.41, 0.41, 40)], axis=1)
    usual = np.stack(
        [random.uniform(-quarter, quarter, COUNT), random.uniform(-0.41, 0.41, COUNT)], axis=1
    )
    latitude, declination = np.concatenate([usual, steep, past]).T
    return {"latitude": latitude, "declination": declination}


def limits_by_erfa(kernels):
    """At rise and set the sun crosses the horizon, in the right sense."""
    place = days()
    found = kernels.day_limits(**place)
    crosses = found.status == Status.OK
    given = chosen(place, crosses)

    def height(hour):
        return horizontal({**place, "hour_angle": hour})[1]

    for name, hour, sign in (("rise", found.rise, 1), ("set", found.set, -1)):
        yield compare(
            f"at {name} the sun stands on the horizon",
            "ERFA",
            height(hour)[crosses],
            0.0,
            1e-13,
            given,
            "day_limits",
        )
        climb = sign * (height(hour + 1e-4) - height(hour - 1e-4))
        sense = "rising" if sign > 0 else "setting"
        wrong = np.minimum(climb, 0)[crosses]
        yield nothing(f"at {name} it is {sense}", wrong, given, "day_limits", "ERFA")


def polar_days_by_erfa(kernels):
    """Days without a sunrise, by the sun's height all through them."""
    place = days()
    found = kernels.day_limits(**place)
    hours = np.linspace(-np.pi, np.pi, 721)
    heights = np.stack([horizontal({**place, "hour_angle": h})[1] for h in hours])
    up, down = heights.min(axis=0) >= 0, heights.max(axis=0) <= 0
    yield compare(
        "polar day and night are told apart", "ERFA", found.status,
        np.where(up, Status.CLAMPED, np.where(down, Status.BELOW_HORIZON, Status.OK)), 0.0, place,
        "day_limits",
    )  # fmt: skip
    stays = found.status != Status.OK
    yield compare(
        "a polar day lasts from -pi to pi, a polar night from 0 to 0", "ERFA",
        np.stack([found.rise, found.set], axis=1)[stays],
        np.where(up, np.pi, 0.0)[stays, None] * np.array([-1.0, 1.0]), 0.0, chosen(place, stays),
        "day_limits",
    )  # fmt: skip


# -- clock and air --------------------------------------------------------------------------------


def clock_by_pvlib(kernels):
    """The hour angle against pvlib's, from calendar times."""
    pvlib = need("pvlib.solarposition")
    pandas = need("pandas")
    random = np.random.default_rng(7)
    utc = np.floor(random.uniform(0, 86400, COUNT))
    longitude = random.uniform(-np.pi, np.pi, COUNT)
    equation_of_time = random.uniform(-1000, 1000, COUNT)
    times = pandas.Timestamp("2031-05-17", tz="UTC") + pandas.to_timedelta(utc, unit="s")
    wanted = [
        pvlib.hour_angle(pandas.DatetimeIndex([t]), np.degrees(l), e / 60)[0]
        for t, l, e in zip(times, longitude, equation_of_time, strict=True)
    ]
    given = {"utc": utc, "longitude": longitude, "equation_of_time": equation_of_time}
    found = kernels.hour_angle(**given).hour_angle
    yield compare(
        "hour angle", "pvlib", found, np.radians(wanted), 1e-13, given, "hour_angle", turn=True
    )
    excess = np.maximum(np.abs(found) - np.pi, 0)
    yield nothing("hour angle lies in [-pi, pi]", excess, given, "hour_angle")


def refraction_by_spa(kernels):
    """Refraction against the NREL SPA's, whose zero of temperature is at 273 K."""
    spa = need("pvlib.spa")
    random = np.random.default_rng(8)
    given = {
        "elevation": np.append(random.uniform(-0.1, 1.57, COUNT), [0.0, np.pi / 2]),
        "pressure": np.append(random.uniform(5e4, 1.1e5, COUNT), [101325.0, 101325.0]),
        "temperature": np.append(random.uniform(220, 330, COUNT), [283.0, 283.0]),
    }
    lift = spa.atmospheric_refraction_correction(
        given["pressure"] / 100,
        given["temperature"] - 273,
        np.degrees(given["elevation"]),
        ATMOSPHERE,
    )
    yield compare(
        "apparent elevation", "NREL SPA (pvlib)", kernels.refraction(**given).elevation,
        given["elevation"] + np.radians(lift), 1e-14, given, "refraction",
    )  # fmt: skip


# -- almanacs -------------------------------------------------------------------------------------


def calendar():
    """Unix times over the years measured, and the day of the year of each, with its fraction."""
    first = np.datetime64(f"{FIRST_YEAR}-01-01", "s")
    last = np.datetime64(f"{LAST_YEAR + 1}-01-01", "s")
    times = np.arange(first, last, np.timedelta64(HOURS_APART, "h"))
    since = times - times.astype("datetime64[Y]").astype("datetime64[s]")
    return times.astype(float), 1 + since.astype(float) / 86400


def almanacs_by_spa(kernels):
    """How far the almanacs stray from the NREL SPA: facts about the formulas, not about rounding.

    The bounds are what was measured, rounded up; they hold for these years.
    """
    spa = need("pvlib.spa")
    unix, day = calendar()
    declination = np.radians(spa.solar_position_numpy(unix, *SETTING, sst=True)[2])
    equation_of_time = 60 * spa.solar_position_numpy(unix, *SETTING)[5]
    given = {"day": day, "unix_time": unix}
    spencer = kernels.spencer(day=day)
    for kernel, title, found, truth, bound, mean_bound in (
        ("cooper", "Cooper's declination", kernels.cooper(day=day).declination, declination,
         np.radians(1.4), np.radians(0.56)),
        ("cosine", "Yu's cosine", kernels.cosine(day=day).declination, declination,
         np.radians(1.3), np.radians(0.54)),
        ("spencer", "Spencer's declination", spencer.declination, declination,
         np.radians(0.42), np.radians(0.18)),
        ("spencer", "Spencer's equation of time, in seconds", spencer.equation_of_time,
         equation_of_time, 46.0, 21.0),
    ):  # fmt: skip
        claim = f"{title}, {FIRST_YEAR}-{LAST_YEAR}"
        worst = compare(
            f"{claim}: largest error", "NREL SPA (pvlib)", found, truth, bound, given, kernel,
            relative=False,
        )  # fmt: skip
        yield worst
        mean = float(np.sqrt(np.mean((found - truth) ** 2)))
        name = f"{claim}: root mean square error"
        yield replace(worst, name=name, worst=mean, tolerance=mean_bound, at={})


def almanacs_by_pvlib(kernels):
    """The almanacs day by day against the same formulas as pvlib has them."""
    pvlib = need("pvlib.solarposition")
    days = np.arange(1.0, 367.0)
    series = kernels.spencer(day=days)
    yield compare(
        "Cooper's formula", "pvlib", kernels.cooper(day=days).declination,
        pvlib.declination_cooper69(days), 1e-14, {"day": days}, "cooper",
    )  # fmt: skip
    yield compare(
        "Spencer's declination", "pvlib", series.declination, pvlib.declination_spencer71(days),
        1e-14, {"day": days}, "spencer",
    )  # fmt: skip
    # pvlib follows an erratum that takes a tenth of the constant printed in 1971.
    erratum = (0.000075 - 0.0000075) * 86400 / TURN
    yield compare(
        "Spencer's equation of time as printed, in seconds", "pvlib", series.equation_of_time,
        60 * pvlib.equation_of_time_spencer71(days) + erratum, 1e-13, {"day": days}, "spencer",
    )  # fmt: skip
