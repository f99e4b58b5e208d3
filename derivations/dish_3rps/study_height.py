"""The height z_O of the dish: what can be asked for, what is feasible, what is best (Fig. 5)."""

from dataclasses import dataclass

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Axis, Curve, Mark, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table

from .days import MM, day_names, mount, whole_study
from .searches import PEOPLE, differential_evolution, genetic, local

STEP = 5.0  # minutes between the suns; the extremes are at the ends of the tracking
YEAR = np.arange(1, 366)
YEAR_STEP = 30.0  # minutes
PRINTED_GENERATION = 75
FLOOR = 1e-5  # mm, where the plot of convergence ends
SMALL = 1e-4  # m, a step of z_O for slopes
SAME = 0.005  # mm, half the last digit of the paper's height


@dataclass(frozen=True)
class Objective:
    """What is made small: a function of rods (heights, days, times, facets, rods) in metres."""

    name: str
    words: str
    of: object


def height(kernels, sun, parameters, tell):
    """The whole of it."""
    rods = Rods(kernels, sun, parameters)
    limits = parameters.rods
    low, high = feasible(rods, limits)
    yield Heading("Fig. 5: the height of the dish")
    yield statement(limits)
    if not low < high:
        yield infeasible(limits, low, high)
        return
    yield interval(rods, sun, limits, low, high, parameters)
    yield over_height(rods, low, high, limits, parameters)
    found = []
    chosen = objectives(parameters)
    for k, objective in enumerate(chosen):
        tell(k / len(chosen), objective.name)
        found.append(optimum(rods, objective, low, high))
    yield from best(rods, found, parameters, low, high)
    yield from convergence(found, low, high, tell)
    yield from searched(rods, parameters, low, high)
    yield Result("feasible", {"low": low, "high": high})


class Rods:
    """The twelve rods at all suns of the study, for candidate heights."""

    def __init__(self, kernels, sun, parameters, step=STEP, days=()):
        self.kernels = kernels
        self.size = mount(kernels, parameters)
        self.angles = whole_study(kernels, sun, parameters, step, days)

    def at(self, heights):
        """Lengths, shape (heights, days, times, facets, rods)."""
        tall = np.reshape(np.asarray(heights, dtype=float), (-1, 1, 1))
        return self.kernels.rod_lengths_all(**self.angles, **{**self.size, "z_O": tall}).l

    def ends(self, z_O):
        """Shortest and longest."""
        l = self.at([z_O])
        return float(l.min()), float(l.max())


# -- what is feasible -----------------------------------------------------------------------------


def feasible(rods, limits):
    """Where the shortest rod reaches its limit, and where the longest does; NaN where never.

    Both grow with z_O as long as the rods point upward, so that each has one root.
    """
    brentq = need("scipy.optimize").brentq
    reach = (0.1 * limits.longest, 2 * limits.longest)

    def root(gap):
        there = gap(reach[0]) * gap(reach[1]) <= 0
        return brentq(gap, *reach, xtol=1e-12) if there else np.nan

    return (
        root(lambda z: rods.ends(z)[0] - limits.shortest),
        root(lambda z: rods.ends(z)[1] - limits.longest),
    )


def statement(limits):
    """Why (35) is no problem yet, and what is."""
    return Prose(
        "(35) is no problem that can be solved: it sets $z_O$, a height, equal to the minimum of a "
        "sum; it sums over the three rods of one facet and says nothing of the other facets; it "
        "leaves $f(l, t)$ open and does not say what becomes of the time $t$; and if $f$ is the "
        "length itself, every rod grows with $z_O$ (its slope is the sine of the rod's "
        "elevation), so that the least sum is at the lower end of what is allowed, whatever the "
        "weights. Well posed is this: **find $z_O$ in the set where all twelve rods, on the four "
        f"days and all hours of the tracking, are between {MM * limits.shortest:.0f} and "
        f"{MM * limits.longest:.0f} mm, such that a stated number is smallest.** The suns of the "
        f"search stand {STEP:g} minutes apart."
    )


def infeasible(limits, low, high):
    """No height keeps all rods within their limits."""
    found = (
        f"the shortest rod is long enough only above {MM * low:.2f} mm, the longest short enough "
        f"only below {MM * high:.2f} mm"
        if np.isfinite(low) and np.isfinite(high)
        else f"a limit is reached at no height up to {MM * 2 * limits.longest:.0f} mm"
    )
    return Prose(
        f"**With the inferred dimensions, as they are set here, no $z_O$ is feasible**: {found}. "
        "So nothing is left to be chosen, and the questions of this part have no answer."
    )


def interval(rods, sun, limits, low, high, parameters):
    """The feasible interval in words."""
    ends = {z: rods.ends(z) for z in (low, high)}
    strokes = [MM * (b - a) for a, b in ends.values()]
    z_O = parameters.rods.found_height
    inside = "in it" if low <= z_O <= high else "not in it"
    year = feasible(Rods(rods.kernels, sun, parameters, YEAR_STEP, YEAR), limits)
    left = f"{MM * year[0]:.2f} to {MM * year[1]:.2f} mm" if year[0] < year[1] else "no height"
    changed = abs(strokes[1] - strokes[0]) / (MM * (high - low))
    return Prose(
        f"**With the inferred dimensions feasible is $z_O$ from {MM * low:.2f} to "
        f"{MM * high:.2f} mm**, {MM * (high - low):.0f} mm wide; the paper's {MM * z_O:.2f} mm is "
        f"{inside}. All days of the year leave {left}. At the lower end the shortest rod measures "
        f"{MM * limits.shortest:.0f} mm, at the upper end the longest {MM * limits.longest:.0f}. "
        "From one end to the other the stroke, longest less shortest, "
        f"goes from {strokes[0]:.2f} to {strokes[1]:.2f} mm, which is {100 * changed:.2g}% of the "
        "way between them: what the height chooses is where in the sections' range the stroke lies."
    )


def over_height(rods, low, high, limits, parameters):
    """Shortest, longest and mean over the height."""
    z = np.linspace(low, high, 41)
    l = rods.at(z).reshape(len(z), -1)
    curves = [
        Curve(name, MM * z, MM * values)
        for name, values in (
            ("longest", l.max(axis=1)), ("mean", l.mean(axis=1)), ("shortest", l.min(axis=1)),
        )
    ]  # fmt: skip
    marks = [
        Mark(MM * limits.longest, ""), Mark(MM * limits.shortest, ""),
        Mark(MM * parameters.rods.found_height, "the paper's", across=True),
    ]  # fmt: skip
    return Plot(
        "Rods over the feasible heights.",
        "height z_O, mm",
        Axis("length, mm", high=MM * limits.longest + 400.0),
        curves,
        marks,
    )


# -- what is best ---------------------------------------------------------------------------------


def objectives(parameters):
    """What one may ask for."""
    limits = parameters.rods
    middle = (limits.shortest + limits.longest) / 2
    rods = (1, 2, 3, 4)
    length = f"{MM * middle:.0f} mm"
    return [
        Objective("minimax", f"the largest distance of a rod from {length}",
                  lambda l: np.abs(l - middle).max(axis=rods)),
        Objective("least squares", f"the mean square of the distance from {length}",
                  lambda l: mean((l - middle) ** 2)),
        Objective("mean distance", f"the mean distance from {length}",
                  lambda l: mean(np.abs(l - middle))),
        Objective("stroke", "the longest less the shortest",
                  lambda l: l.max(axis=rods) - l.min(axis=rods)),
        Objective("ratio", "the longest over the shortest",
                  lambda l: l.max(axis=rods) / l.min(axis=rods)),
        Objective("sum", "the mean length: (35) with $f = l$ and equal weights",
                  mean),
    ]  # fmt: skip


def mean(values):
    """Over days, facets, rods and, by trapezoids, the time: shape (heights,)."""
    weights = np.ones(values.shape[2])
    weights[[0, -1]] = 0.5
    return (values.mean(axis=(1, 3, 4)) * weights).sum(axis=1) / weights.sum()


def optimum(rods, objective, low, high):
    """By a local search and by differential evolution."""

    def value(z):
        return objective.of(rods.at(z))

    return objective, value, local(value, low, high), differential_evolution(value, low, high)


def best(rods, found, parameters, low, high):
    """A row for each objective."""
    z_O = parameters.rods.found_height
    rows = []
    for objective, _, z, search in found:
        at_end = "lower end" if z - low < 1e-9 else "upper end" if high - z < 1e-9 else "inside"
        ends = (MM * x for x in rods.ends(z))
        rows.append((
            objective.name, objective.words, MM * z, at_end, MM * abs(search.best - z),
            MM * (z - z_O), *ends,
        ))  # fmt: skip
    yield Table(
        "The best height by what is made small: by Brent's search, and how far differential "
        "evolution ends from it.",
        [
            "objective", "made small", Column("best $z_O$", "mm", ".3f"), "where",
            Column("differential evolution off by", "mm", ".4f"),
            Column("less the paper's", "mm", ".2f"),
            Column("shortest", "mm", ".1f"), Column("longest", "mm", ".1f"),
        ],
        rows,
    )  # fmt: skip
    yield chosen(rows, parameters.rods)


def chosen(rows, limits):
    """How far the answers are apart, and how far from the paper's."""
    worst = max(1e-6, *(row[4] for row in rows))
    inner = [row[2] for row in rows if row[3] == "inside"]
    spread = (
        f"{len(inner)} of {len(rows)} objectives have an optimum inside, from {min(inner):.0f} to "
        f"{max(inner):.0f} mm; the others run to an end"
        if inner
        else "all objectives run to an end"
    )
    nearest = min(rows, key=lambda row: abs(row[5]))
    room = (rows[0][6] - MM * limits.shortest, MM * limits.longest - rows[0][7])
    return Prose(
        f"Both searches agree within {10 ** np.ceil(np.log10(worst)):g} mm. **The answer hangs on "
        f"the question**: {spread}. Who wants room at both ends of the sections asks for the "
        f"minimax: {rows[0][2]:.2f} mm, which leaves {room[0]:.1f} and {room[1]:.1f} mm at the "
        + (
            f"ends. None gives the paper's {MM * limits.found_height:.2f} mm; the nearest, "
            if abs(nearest[5]) > SAME
            else f"ends. Nearest to the paper's {MM * limits.found_height:.2f} mm, "
        )
        + f"{nearest[0]}, is {abs(nearest[5]):.2f} mm off."
    )


def convergence(found, low, high, tell):
    """Fig. 5: distance to the optimum by generation."""
    objective, value, z, search = found[1]
    tell(0.9, "genetic algorithm")
    grown = genetic(value, low, high)
    ways = [("genetic algorithm", grown.way), ("differential evolution", search.way)]
    curves = []
    for name, way in ways:
        off = MM * np.abs(way - z)
        off[off < FLOOR] = np.nan
        curves.append(Curve(name, np.arange(1, len(way) + 1), off))
    yield Plot(
        f"Fig. 5: how far the best of each generation is from the optimum, {objective.name}.",
        "generation", Axis("distance, mm", log=True), curves,
        [Mark(PRINTED_GENERATION, "the paper's 75th", across=True)],
    )  # fmt: skip
    at = MM * abs(grown.way[min(PRINTED_GENERATION, len(grown.way)) - 1] - z)
    tried = []
    local(lambda x: tried.append(x) or value(x), low, high)
    yield Prose(
        f"With {PEOPLE} candidates the genetic algorithm is {at:.1g} mm off in generation "
        f"{PRINTED_GENERATION}; differential evolution ends {MM * abs(search.best - z):.1g} mm "
        f"off. A search over one number needs neither: Brent's takes {len(tried)} evaluations."
    )


# -- where the paper's height comes from ----------------------------------------------------------


def searched(rods, parameters, low, high):
    """Which question has the paper's height as its answer."""
    limits, z_O = parameters.rods, parameters.rods.found_height
    below = MM * (limits.found_shortest - limits.shortest)
    above = MM * (limits.longest - limits.found_longest)
    out = [
        *(["it is at no end of the feasible interval, where the sum has its least value"]
          if min(below, above) > 0 else []),
        *(["it is not the minimax, which leaves equal room"] if below != above else []),
    ]  # fmt: skip
    yield Heading("Which question has the paper's height as its answer?")
    yield Prose(
        "Whatever Table 1 was, the paper's own extremes exclude some: at its height the shortest "
        f"rod is {below:.0f} mm above the lower limit and the longest {above:.0f} mm below the "
        "upper one." + (f" So {', and '.join(out)}." if out else "")
    )
    rows = list(by_days(rods, parameters, low, high))
    nearest = min(rows, key=lambda row: abs(row[2]))
    yield Table(
        "Least squares about a target length: the best height for some of the suns, and the target "
        "for which the best is the paper's height.",
        [
            "suns", Column("best $z_O$ about the middle", "mm", ".2f"),
            Column("less the paper's", "mm", ".2f"),
            Column("target that gives the paper's", "mm", ".2f"),
        ],
        rows,
    )  # fmt: skip
    yield Prose(
        "With the nominal dimensions, which are inferred, least squares about the middle comes "
        f"nearest to the paper's {MM * z_O:.2f} mm with these suns: {nearest[0]}, "
        f"{abs(nearest[2]):.2f} mm off. What it gives with other dimensions stands below, where "
        "Table 1 is guessed. The text does not say which objective the paper took."
    )


def by_days(rods, parameters, low, high):
    """A row for all days and for each."""
    limits, z_O = parameters.rods, parameters.rods.found_height
    middle = (limits.shortest + limits.longest) / 2
    groups = {"all days": slice(None)}
    groups |= {name: slice(k, k + 1) for k, name in enumerate(day_names(parameters).values())}
    for name, days in groups.items():

        def value(z, days=days):
            return mean((rods.at(z)[:, days] - middle) ** 2)

        z = local(value, low, high)
        # The mean square has slope 0 where the lengths, weighted by their slopes, average to it.
        less, more = (rods.at([z_O + step])[:, days] for step in (-SMALL, SMALL))
        slopes = (more - less) / (2 * SMALL)
        target = mean(slopes * (less + more) / 2) / mean(slopes)
        yield name, MM * z, MM * (z - z_O), MM * float(target[0])
