"""Where the drives do not hold the platform: through the days, and over all attitudes."""

import numpy as np

from armillary.verify.plots import Axis, Curve, HeatMap, Mark, Plot, centres
from armillary.verify.study import Column, Heading, Prose, Table, text_of

from .study_basis import (
    AUTUMN,
    HOUR,
    NAMES,
    NOON,
    SPRING,
    clock_words,
    crossings,
    day_of,
    declination,
    determinant,
    mount,
    sign_changes,
    state_at,
    sunrise_and_sunset,
    two,
)
from .study_marks import branches, covering, crosses

CELL = 5.0  # degrees
COARSE = 4.0  # degrees, where single points are looked for
FINE = 1.0  # degrees, where the singular set is looked for
TILT = 95.0  # degrees, the upper end of the maps
YEAR = np.linspace(-23.45, 23.45, 95)  # degrees of declination
MILLI = 1e3
LOOSE = 1e-3  # m a radian, below which three drives hardly hold
CROSS = (4.0, 3.0)  # degrees
HELD = (0.0, 0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3)
DETERMINANTS = (-0.1, -0.05, -0.02, -0.005, 0.0, 0.005, 0.02, 0.05, 0.1)


def singular(kernels, sun, parameters):
    """Both mechanisms, on the days and on the map."""
    size = mount(parameters)
    days = {k: day_of(kernels, sun, parameters, k) for k in range(len(NAMES)) if k != AUTUMN}
    found = {k: kernels.singularity(**day.pose, **size) for k, day in days.items()}
    zeros = {
        k: crossings(kernels, parameters, declination(parameters, k), day.clock, size)
        for k, day in days.items()
    }
    yield Heading("Where the drives do not hold the platform")
    yield Prose(
        "Two drives hold the platform where the determinant of their Jacobian is not 0. Where it "
        "vanishes, some motion of the platform changes neither length: nothing but its inertia "
        "answers a wind, and to carry a weight along that motion takes forces without bound. Three "
        "drives fail only where the Jacobian's smaller singular value vanishes: what the drives "
        "move, in metres, for a radian of the motion that they feel least."
    )
    yield Plot(
        "Determinant of the Jacobian of legs 1 and 2 through the days: two drives do not hold the "
        "platform where it is 0.",
        "solar time, h", "determinant, m²",
        [Curve(day.name, day.clock, found[k].det_2) for k, day in days.items()],
        [Mark(0.0, "singular")],
    )  # fmt: skip
    yield Plot(
        "Smaller singular value of the three-drive Jacobian through the days: three drives hold "
        "the platform while it is not 0.",
        "solar time, h", Axis("singular value, m", low=0.0),
        [Curve(day.name, day.clock, found[k].sigma_min) for k, day in days.items()],
    )  # fmt: skip
    yield table(days, found, zeros)
    yield from maps(kernels, size, days)
    year = through_the_year(kernels, sun, parameters, size)
    refused = refused_for(kernels, parameters, size, zeros[SPRING])
    yield Prose(words(days, year, found, refused))


def table(days, found, zeros):
    """Times and attitudes of the crossings."""
    rows = []
    for k, day in days.items():
        at = [float(np.degrees(np.interp(t, day.clock, day.state["beta"]))) for t in zeros[k]]
        times = ", ".join(clock_words(t) for t in zeros[k]) or "never"
        tilt = ", ".join(f"{b:.1f}" for b in at) or "–"
        morning = day.clock <= NOON + 1e-9
        least = int(np.argmin(np.where(morning, found[k].sigma_min, np.inf)))
        held = found[k].sigma_min[least]
        rows.append((day.name, times, tilt, MILLI * held, clock_words(day.clock[least])))
    return Table(
        "Where the sun's path meets the singular set of two drives, and where three hold least.",
        [
            "day", "two drives singular at", Column("β there", "degrees"),
            Column("three drives: least singular value", "mm", ".1f"), "at",
        ],
        rows,
    )  # fmt: skip


def maps(kernels, size, days):
    """Both over the attitude, with the ways of the days."""
    turn, tilt = np.arange(-180.0, 181.0, CELL), np.arange(0.0, TILT + 1, CELL)
    a, b = np.meshgrid(np.radians(centres(turn)), np.radians(centres(tilt)))
    found = kernels.singularity(alpha=a, beta=b, **size)
    ways = [
        Curve(day.name, *np.degrees([day.state["alpha"], day.state["beta"]]))
        for day in days.values()
    ]
    label = "α, degrees", "β, degrees"
    yield HeatMap(
        "Determinant of the Jacobian of legs 1 and 2 over the attitude, the attitudes at which two "
        "drives do not hold, and the ways of the days.",
        *label, "determinant, m²", turn, tilt, found.det_2,
        covering(DETERMINANTS, found.det_2),
        curves=[Curve("singular", *singular_set(kernels, size)), *ways],
    )  # fmt: skip
    points = isolated(kernels, size)
    yield HeatMap(
        "Smaller singular value of the three-drive Jacobian over the attitude, the attitudes at "
        "which three drives do not hold, and the ways of the days.",
        *label, "singular value, m", turn, tilt, found.sigma_min,
        covering(HELD, found.sigma_min),
        curves=[*([Curve("singular", *crosses(*points, *CROSS))] if points.size else []), *ways],
    )  # fmt: skip
    yield Prose(where_three_fail(points))


def where_three_fail(points):
    """The single attitudes in words."""
    lines = "The singular attitudes of two drives are lines that part the map; "
    if not points.size:
        return f"{lines}three drives hold at every attitude of the map."
    places = "; ".join(f"({text_of(x, '.1f')}, {text_of(y, '.1f')})" for x, y in points.T.tolist())
    return (
        f"{lines}those of three are single points, with α and β in degrees at {places}. A way can "
        "go round a point."
    )


def singular_set(kernels, size):
    """Turns and tilts in degrees at which two drives do not hold."""
    turn, tilt = np.arange(-180.0, 180.5, FINE), np.arange(FINE, TILT + FINE / 2, FINE)
    a, b = np.meshgrid(np.radians(turn), np.radians(tilt))
    return branches(kernels.singularity(alpha=a, beta=b, **size).det_2, turn, tilt)


def isolated(kernels, size):
    """Attitudes in degrees at which three drives do not hold, found on ever finer grids."""

    def value(x, y):
        J = kernels.jacobian(alpha=np.radians(x), beta=np.radians(y), **size).J
        return np.linalg.svd(J, compute_uv=False)[..., -1]

    turn, tilt = np.arange(-180.0, 180.0, COARSE), np.arange(0.0, TILT, COARSE)
    wide = np.arange(-180.0 - COARSE, 180.5, COARSE), np.arange(-COARSE, TILT + COARSE, COARSE)
    around = value(*np.meshgrid(*wide))
    middle = around[1:-1, 1:-1]
    # Mirror images may be equal: hence < on one side and <= on the other.
    low = (middle < np.minimum(around[:-2, 1:-1], around[1:-1, :-2])) & (
        middle <= np.minimum(around[2:, 1:-1], around[1:-1, 2:])
    )
    rows, columns = np.nonzero(low[: len(tilt), : len(turn)])
    refined = [refine(value, turn[c], tilt[r]) for r, c in zip(rows, columns, strict=True)]
    kept = {(round(x, 1) + 0.0, round(y, 1) + 0.0) for x, y, least in refined if least < 1e-5}
    return np.array(sorted(kept)).reshape(-1, 2).T


def refine(value, x, y):
    """The least value near a place, by grids that shrink about the best."""
    width, offsets = COARSE, np.linspace(-1.0, 1.0, 9)
    while width > 1e-5:
        a, b = np.meshgrid(x + width * offsets, y + width * offsets)
        found = value(a, b)
        best = np.unravel_index(np.argmin(found), found.shape)
        x, y, width = float(a[best]), float(b[best]), 0.4 * width
    return x, y, float(found[best])


def through_the_year(kernels, sun, parameters, size):
    """Fewest and most crossings of a day, over all declinations of the year."""
    counts = []
    for angle in np.radians(YEAR):
        clock = np.linspace(*sunrise_and_sunset(sun, parameters, angle), 401)
        det = determinant(kernels, parameters, angle, clock, size)
        counts.append(len(sign_changes(det, clock)))
    return [min(counts), max(counts)]


def refused_for(kernels, parameters, size, zeros):
    """Seconds about the first crossing of the equinox for which the kernel answers SINGULAR."""
    if not zeros:
        return 0.0
    span = np.linspace(-1.0, 1.0, 2001)  # s
    state = state_at(kernels, parameters, declination(parameters, SPRING), zeros[0] + span / HOUR)
    refused = span[np.isnan(two(kernels, state, size)[:, 0])]
    return float(np.ptp(refused)) if refused.size else 0.0


def words(days, year, found, refused):
    """What it means for the two mechanisms."""
    least, day = min((float(np.min(of.sigma_min)), days[k].name) for k, of in found.items())
    third = (
        f"The mechanism with three drives is held {'all day' if least > LOOSE else 'not always'}; "
        f"least, with {MILLI * least:.0f} mm a radian, on the {day}."
    )
    few, many = year
    if not many:
        return f"The sun's way never crosses the set, on no day of the year. {third}"
    if not few:
        return (
            f"The sun's way crosses the set up to {many} times a day, and on some days of the "
            f"year never. {third}"
        )
    times = f"{few} times" if few == many else f"{few} to {many} times"
    signs = (
        "The determinant has one sign about noon and the other towards sunrise and sunset; no "
        "finer plan and no stronger motor avoids the zeros between. "
        if few == many == 2
        else ""
    )
    about = (
        "About a crossing of the equinox the kernel answers SINGULAR, with forces of 0, for "
        f"{refused:.2f} s of the sun's time. "
        if refused
        else ""
    )
    return (
        "**The mechanism with two drives is singular on its way, every day of the year**: at each "
        f"of {len(YEAR)} declinations the sun's way crosses the set {times}. {signs}{about}{third}"
    )
