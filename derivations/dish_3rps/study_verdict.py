"""What the tracking comes to: every experiment against the bound that was set for it."""

from armillary.verify.study import Column, Heading, Prose, Table

from .days import MM
from .study_day import AHEAD_IN_CORNER, LAWS, MRAD
from .tracking import AHEAD, IN_CORNER, P_ONLY, PID

EXPERIMENTS = (
    ("figures", "day compressed", "the compressed day"),
    ("windows", "real time", "real time"),
    ("gust", "wind", "the wind"),
)
NAMES = (*LAWS, IN_CORNER, AHEAD_IN_CORNER)


def verdict(kernels, parameters, results):
    """The table, and what it says."""
    bounds = parameters.tracking.bounds
    found = {name: results[key] for key, name, _ in EXPERIMENTS}
    yield Heading("How exactly can the dish be driven?")
    yield table(bounds, found)
    day = found["day compressed"]
    all_kept, words = kept(found, bounds, PID, ", where {:g} mm was aimed at")
    firm, in_corner = kept(found, bounds, IN_CORNER, "")
    ahead = ", ".join(
        f"{100 * (of[AHEAD]['peak'] / of[PID]['peak'] - 1):+.0f}% in {where}"
        for of, (_, _, where) in zip(found.values(), EXPERIMENTS, strict=True)
    )
    yield Prose(
        f"**The tuned PID {'keeps' if all_kept else 'does not keep'} the bounds: {words}.** The "
        f"paper reports {parameters.tracking.found_error:g} mm for a plant that it does not "
        "describe. With the gain of the error alone, the best that is stable, the compressed day "
        f"costs {MM * day[P_ONLY]['peak']:.2f} mm. Feed-forward of weight and friction "
        f"changes the PID's errors by {ahead}. On the corner plant, with the same gains, the PID "
        f"{'keeps' if firm else 'does not keep'} the bounds: {in_corner}. Rods that stick and slip "
        "amplify roundings, so the last digits here are not the same on every machine."
    )
    yield Prose(real(parameters.tracking, results["turns"]))


def real(tracking, turns):
    """What is meant by real time."""
    minutes = tracking.window / 60
    outside = turns["all"] - turns["inside"]
    return (
        f"Real time means the {len(tracking.windows)} windows of {minutes:g} minutes and not the "
        f"day: of the {turns['all']} times that a rod turns round through the day, "
        f"{turns['inside']} are in the windows"
        + (f"; the {outside} outside them were not run." if outside else ".")
    )


def kept(found, bounds, law, aimed):
    """Whether a law keeps all bounds, and its errors in words."""
    peaks = [MM * of[law]["peak"] for of in found.values()]
    words = "; ".join(
        f"{peak:.3f} mm in {where}" + aimed.format(bound)
        for peak, bound, (_, _, where) in zip(peaks, bounds, EXPERIMENTS, strict=True)
    )
    return all(peak <= bound for peak, bound in zip(peaks, bounds, strict=True)), words


def table(bounds, found):
    """Law by law, experiment by experiment."""
    return Table(
        "Largest errors after the start-up in MuJoCo, law by law: of a rod, and of a facet's "
        "normal. The first row is what was aimed at.",
        [
            "law",
            *(Column(f"rod, {name}", "mm", ".3f") for name in found),
            *(Column(f"normal, {name}", "mrad", ".3f") for name in found),
        ],
        [
            ("bound", *bounds, *(None for _ in bounds)),
            *(
                (law, *(cell(of, law, "peak", MM) for of in found.values()),
                 *(cell(of, law, "tilt", MRAD) for of in found.values()))
                for law in NAMES
            ),
        ],
    )  # fmt: skip


def cell(found, law, what, scale):
    """A number of the table, where the law was tried."""
    return scale * found[law][what] if law in found else None
