"""One plot of each kind, with the awkward things in it."""

import math

from armillary.verify.plots import (
    Axis,
    Band,
    Bars,
    Curve,
    HeatMap,
    Histogram,
    Mark,
    Panels,
    Plot,
    Series,
    centres,
    sky_map,
)

X = [k / 10 for k in range(61)]
AZIMUTH = [float(a) for a in range(0, 361, 10)]
ELEVATION = [float(e) for e in range(0, 91, 10)]


def line() -> Plot:
    """Six curves, one with gaps and a point alone, marks and a band."""
    waves = [[math.sin(x + k) for x in X] for k in range(6)]
    waves[1][20:30] = [math.nan] * 10
    waves[1][25] = 0.5
    names = ("sine", "gap", "third", "fourth with a long name", "fifth", "sixth")
    return Plot(
        "Waves of $\\sin x$ & more. The second has a gap.",
        "angle, rad",
        "height, mm",
        [
            Curve(n, X, w, "both" if n == "third" else "line")
            for n, w in zip(names, waves, strict=True)
        ],
        [Mark(0.8, "limit <one>"), Mark(4.5, "noon", across=True)],
        [Band("spread", X, [y - 0.1 for y in waves[0]], [y + 0.1 for y in waves[0]])],
    )


def powers() -> Plot:
    """Logarithmic axes both ways, cut at the lower end."""
    x = [10 ** (k / 4 - 3) for k in range(9)]
    return Plot(
        "Errors fall with their order.",
        Axis("misalignment, rad", log=True),
        Axis("error, rad", log=True, low=1e-8),
        [
            Curve("first order", x, [v**2 for v in x], "both"),
            Curve("second order", x, [v**3 for v in x], "both"),
        ],
    )


def scatter() -> Plot:
    """Points only."""
    points = [(math.cos(k * k), math.sin(k * k * k)) for k in range(80)]
    return Plot(
        "Points.",
        Axis("east, m", low=-1.2, high=1.2),
        "north, m",
        [
            Curve(name, [a * s for a, _ in points], [b * s for _, b in points], "points")
            for name, s in (("wide", 1.0), ("narrow", 0.4))
        ],
    )


def bars() -> Bars:
    """Three series, one with a negative and a missing number."""
    return Bars(
        "What each source adds.",
        "source",
        "error, mrad",
        ["base", "reflected beam", "encoder"],
        [
            Series("azimuth", [1.25, 0.5, 0.333]),
            Series("elevation", [0.75, -0.5, None]),
            Series("both", [1.46, 0.7, 0.4]),
        ],
    )


def fillings() -> Bars:
    """As many series as bars can tell apart."""
    names = ("solid", "hollow", "hatched", "both ways", "level")
    series = [Series(name, [k + 1, 12 - k]) for k, name in enumerate(names)]
    return Bars("How bars differ.", "verdict", "prints", ["few", "many"], series)


def histogram() -> Histogram:
    """Two shares over cells."""
    edges = [k / 2 for k in range(9)]
    return Histogram(
        "How often.",
        "error, mrad",
        "share, %",
        edges,
        [
            Series("linear", [1, 5, 20, 30, 24, 12, 6, 2]),
            Series("exact", [2, 6, 19, 28, 25, 13, 5, 2]),
        ],
        [Mark(2.1, "mean", across=True)],
    )


def sky(factor: float = 1.0, caption: str = "The sky.") -> object:
    """A map of the sky, with cells below a stair left out, and a way across it."""
    rows = [
        [
            None if e < 15 and 170 < a < 200 else factor * (e + 20 * math.cos(math.radians(a)) + 30)
            for a in centres(AZIMUTH)
        ]
        for e in centres(ELEVATION)
    ]
    day = Curve(
        "21 June", [60 + 4 * k for k in range(61)], [70 - abs(k - 30) * 2.3 for k in range(61)]
    )
    levels = [float(v) for v in range(0, 181, 20)]
    return sky_map(caption, "error, mrad", AZIMUTH, ELEVATION, rows, levels, curves=[day])


def heat() -> HeatMap:
    """A rectangular map in logarithmic classes."""
    x, y = [k / 2 for k in range(21)], [float(k) for k in range(9)]
    rows = [[10 ** (a / 4 - b / 3) for a in centres(x)] for b in centres(y)]
    return HeatMap("Heat.", "chi, mrad", "theta, mrad", "error, mrad", x, y, rows, log=True,
                   curves=[Curve("edge", x, [v * 0.7 for v in x])])  # fmt: skip


def panels() -> Panels:
    """Three plots with one legend."""
    return Panels("Three waves.", [
        Plot(f"{k} mrad", "angle, rad", "height, mm", [
            Curve("sine", X, [k * math.sin(x) for x in X]),
            Curve("cosine", X, [k * math.cos(x) for x in X]),
        ]) for k in (1, 2, 5)
    ])  # fmt: skip


def skies() -> Panels:
    """Two maps with one scale of colours."""
    return Panels("Two skies.", [sky(1.0, "chi = 1 mrad"), sky(0.5, "chi = 0.5 mrad")])


ALL = {
    made.__name__: made
    for made in (line, powers, scatter, bars, fillings, histogram, sky, heat, panels, skies)
}
