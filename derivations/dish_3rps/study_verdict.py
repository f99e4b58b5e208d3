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
    peaks = [MM * of[PID]["peak"] for of in found.values()]
    all_kept = all(peak <= bound for peak, bound in zip(peaks, bounds, strict=True))
    words = "; ".join(
        f"{peak:.3f} mm in {where}, where {bound:g} mm was aimed at"
        for peak, bound, (_, _, where) in zip(peaks, bounds, EXPERIMENTS, strict=True)
    )
    ahead = ", ".join(
        f"{100 * (of[AHEAD]['peak'] / of[PID]['peak'] - 1):+.0f}% in {where}"
        for of, (_, _, where) in zip(found.values(), EXPERIMENTS, strict=True)
    )
    yield Prose(
        f"**The tuned PID {'keeps' if all_kept else 'does not keep'} the bounds: {words}.** The "
        f"paper reports {parameters.tracking.found_error:g} mm for a plant that it does not "
        "describe. With the gain of the error alone, the best that is stable, the compressed day "
        f"costs {MM * day[P_ONLY]['peak']:.2f} mm: a spring under a weight, whose give the "
        f"integral takes away. Feed-forward of weight and friction changes the PID's errors by "
        f"{ahead}: it knows what a rod that turns round will ask for; it knows neither the "
        "encoder's step, which is the limit in real time, nor the wind. Rods that stick and slip "
        "amplify roundings, so the last digits here are not the same on every machine."
    )


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
