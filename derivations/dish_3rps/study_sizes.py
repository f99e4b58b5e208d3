"""Table 1 of the paper is lost: what the text still determines of it, and what it does not."""

from itertools import product

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Curve, Mark, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .days import MM, four, mount, whole_study

SUNS = 30.0  # minutes
RATIOS = (1.5, 2.0, 3.0, 5.0)  # r_m / r_b
DISTANCES = np.linspace(0.3, 1.0, 29)  # m
RADII = np.linspace(0.05, 1.0, 20)  # m, where r_m is looked for
HALVES = 40
FOCI = (0.8, 1.0, 1.5, 2.0, 3.0, 5.0)  # m
# -- round numbers --
DIAMETERS = (1.5, 2.0, 2.5, 3.0, 4.0)  # m
RIMS = (30.0, 35.0, 40.0, 45.0, 50.0, 60.0)  # degrees
STEP = 0.025  # m, of d, r_b and r_m
WITHIN = 1.0  # mm
SHOWN = 12


def sizes(kernels, sun, parameters, tell):
    """The family of dimensions that give the paper's extremes, and what follows from each."""
    search = Search(kernels, sun, parameters)
    yield Heading("Table 1 is lost: what the text determines")
    yield from one_focus(search, parameters)
    tell(0.2, "the family")
    members = [m for f in FOCI for ratio in RATIOS for m in search.members(f, ratio)]
    tell(0.5, "round numbers")
    found = round_sets(search, parameters)
    if not members or not found:
        yield Prose("With these parameters no dimensions that were tried give both extremes.")
        return
    yield family(members)
    rows = list(consequences(search, found, parameters))
    yield table(rows)
    tell(0.9, "what follows")
    yield answer(search, members, found, rows, parameters)


class Search:
    """Rods at the suns of the study for any dimensions."""

    def __init__(self, kernels, sun, parameters):
        self.kernels, self.parameters = kernels, parameters
        angles = whole_study(kernels, sun, parameters, SUNS)
        self.angles = {name: a.ravel() for name, a in angles.items()}
        weights = np.ones_like(angles["beta"])  # trapezoids over the time
        weights[:, [0, -1]] = 0.5
        self.weights = weights.ravel()
        self.corners = {name: a[:, [0, -1]].ravel() for name, a in angles.items()}
        self.z_O = parameters.rods.found_height
        limits = parameters.rods
        self.wanted = np.array([limits.found_shortest, limits.found_longest])

    def ends(self, f, d, r_b, r_m, z_O=None, corners=False):
        """Shortest and longest for arrays of dimensions."""
        angles = self.corners if corners else self.angles
        f, d, r_b, r_m, z = (
            np.asarray(x, dtype=float)[..., None]
            for x in np.broadcast_arrays(f, d, r_b, r_m, self.z_O if z_O is None else z_O)
        )
        l = self.kernels.rod_lengths_all(**angles, f=f, d=d, r_b=r_b, r_m=r_m, z_O=z).l
        return l.min(axis=(-3, -2, -1)), l.max(axis=(-3, -2, -1))

    def radii(self, f, ratio):
        """r_m for which the shortest rod is the paper's, for each of DISTANCES; else NaN."""
        gap = self.ends(f, DISTANCES, RADII[:, None] / ratio, RADII[:, None])[0] - self.wanted[0]
        falls = (gap[:-1] > 0) & (gap[1:] <= 0)
        first, there = falls.argmax(axis=0), falls.any(axis=0)
        low, high = RADII[first], RADII[first + 1]
        for _ in range(HALVES):
            middle = (low + high) / 2
            above = self.ends(f, DISTANCES, middle / ratio, middle)[0] > self.wanted[0]
            low, high = np.where(above, middle, low), np.where(above, high, middle)
        return np.where(there, high, np.nan)

    def longest(self, f, ratio, radii):
        """The longest rod where the shortest is the paper's, less the paper's."""
        known = np.nan_to_num(radii, nan=RADII[0])
        gap = self.ends(f, DISTANCES, known / ratio, known)[1] - self.wanted[1]
        return np.where(np.isnan(radii), np.nan, gap)

    def members(self, f, ratio):
        """Dimensions (f, d, r_b, r_m) with both of the paper's extremes, and r_m < d."""
        fsolve = need("scipy.optimize").fsolve
        radii = self.radii(f, ratio)
        gap = self.longest(f, ratio, radii)
        for k in np.flatnonzero(gap[:-1] * gap[1:] < 0):

            def off(x, f=f, ratio=ratio):
                return np.array(self.ends(f, x[0], x[1] / ratio, x[1])) - self.wanted

            share = gap[k] / (gap[k] - gap[k + 1])
            start = [v[k] + share * (v[k + 1] - v[k]) for v in (DISTANCES, radii)]
            found, _, ok, _ = fsolve(off, start, full_output=True, xtol=1e-12)
            if ok == 1 and found[1] < found[0]:
                yield f, float(found[0]), float(found[1] / ratio), float(found[1])


def one_focus(search, parameters):
    """At the nominal focal length: where the shortest rod is right, how far is the longest."""
    size = mount(search.kernels, parameters)
    curves, sums = [], []
    for ratio in RATIOS:
        radii = search.radii(size["f"], ratio)
        gap = MM * search.longest(size["f"], ratio, radii)
        name = f"r_m = {ratio:g} r_b"
        curves.append(Curve(name, MM * DISTANCES, gap))
        sums.append(Curve(name, MM * DISTANCES, MM * (DISTANCES + radii)))
    yield Plot(
        "The longest rod less the paper's, where r_m is such that the shortest is the paper's.",
        "d, mm", "longest less the paper's, mm", curves,
        [Mark(0.0, ""), Mark(MM * size["d"], "nominal", across=True)],
    )  # fmt: skip
    yield Plot(
        "The sum of $d$ and $r_m$ there.", "d, mm", "d + r_m, mm", sums,
        [Mark(MM * (size["d"] + size["r_m"]), "nominal")],
    )  # fmt: skip


def family(members):
    """Every member, with its sum."""
    return Table(
        "Dimensions that give both of the paper's extremes exactly, for chosen focal lengths and "
        "ratios of the radii. Only $r_m < d$ is looked at: else the inner joints of opposite "
        "facets would cross.",
        [
            Column("$f$", "m", ".2f"), Column("$r_m / r_b$", "", ".1f"),
            *(Column(name, "mm", ".1f") for name in ("$d$", "$r_b$", "$r_m$", "$d + r_m$")),
        ],
        [(f, r_m / r_b, MM * d, MM * r_b, MM * r_m, MM * (d + r_m)) for f, d, r_b, r_m in members],
    )  # fmt: skip


# -- round numbers --------------------------------------------------------------------------------


def round_sets(search, parameters):
    """Round D, theta_rim, d, r_b and r_m with both extremes within WITHIN, the nearest first."""
    steps = np.round(np.arange(0.1, 1.0 + STEP / 2, STEP), 9)
    d, r_b, r_m = (
        np.array(x) for x in zip(*[
            (d, b, m) for d, b, m in product(steps, repeat=3) if b <= m < d
        ], strict=True)
    )  # fmt: skip
    found = []
    for D, rim in product(DIAMETERS, RIMS):
        f = float(search.kernels.focal_length(D=D, theta_rim=np.radians(rim)).f)
        low, high = search.ends(f, d, r_b, r_m, corners=True)
        near = np.hypot(low - search.wanted[0], high - search.wanted[1]) < 0.01
        near &= d <= D / 2
        for k in np.flatnonzero(near):
            off = MM * (np.array(search.ends(f, d[k], r_b[k], r_m[k])) - search.wanted)
            if np.abs(off).max() < WITHIN:
                found.append((float(np.abs(off).max()), D, rim, f, d[k], r_b[k], r_m[k], *off))
    return sorted(found)


def consequences(search, found, parameters):
    """The nearest sets and the nominal one, with what the other questions would be answered."""
    nominal = parameters.nominal
    for k, (_, D, rim, f, d, r_b, r_m, *off) in enumerate(found):
        own = (D, rim, d, r_b, r_m) == (
            nominal.D, nominal.theta_rim, nominal.d, nominal.r_b, nominal.r_m
        )  # fmt: skip
        if k < SHOWN or own:
            size = {"f": f, "d": d, "r_b": r_b, "r_m": r_m, "z_O": search.z_O}
            name = "nominal" if own else str(k + 1)
            yield name, D, rim, MM * d, MM * r_b, MM * r_m, *off, *follows(search, size)


def table(rows):
    """The sets as they are printed."""
    return Table(
        "Table 1 of the paper, as far as it can be guessed: round dimensions whose shortest and "
        "longest rod are the paper's within 1 mm, the nearest first; and what follows from each, "
        "largest S-joint angle, largest miss of the central ray, and the height $z_O$ by least "
        "squares about the middle.",
        [
            "set", Column("$D$", "m", ".1f"), Column("$\\theta_\\mathrm{rim}$", "degrees", ".0f"),
            *(Column(name, "mm", ".0f") for name in ("$d$", "$r_b$", "$r_m$")),
            Column("shortest off", "mm", ".2f"), Column("longest off", "mm", ".2f"),
            Column("S-joint", "degrees", ".1f"), Column("miss", "mm", ".0f"),
            Column("$z_O$", "mm", ".1f"),
        ],
        rows,
    )  # fmt: skip


def follows(search, size):
    """Largest S-joint angle in degrees, largest miss and least-squares height in mm."""
    kernels, angles = search.kernels, four(search.angles)
    s = np.degrees(kernels.joint_angles(**angles, **size).s).max()
    miss = MM * kernels.central_ray(**angles, **size).miss.max()
    return s, miss, MM * best_height(search, size)


def best_height(search, size):
    """Where the mean square of the distance from the middle length has slope 0 over z_O."""
    limits = search.parameters.rods
    middle = (limits.shortest + limits.longest) / 2

    def slope(z):
        l = np.stack([
            search.kernels.rod_lengths_all(**search.angles, **{**size, "z_O": z + step}).l
            for step in (-1e-4, 1e-4)
        ])  # fmt: skip
        squares = ((l - middle) ** 2).mean(axis=(-2, -1))
        return ((squares[1] - squares[0]) * search.weights).sum()

    return need("scipy.optimize").brentq(slope, limits.shortest, limits.longest, xtol=1e-9)


def answer(search, members, found, rows, parameters):
    """What is determined."""
    array = MM * np.array(members)
    sums = array[:, 1] + array[:, 3]
    round_sums = [MM * (d + r_m) for _, _, _, _, d, _, r_m, *_ in found]
    names = ("f", "d", "r_b", "r_m")
    heights = [MM * best_height(search, dict(zip(names, m, strict=True))) for m in members]
    size = mount(search.kernels, parameters)
    low, high = (MM * float(x) for x in search.ends(*(size[name] for name in names)))
    nearest = min(rows, key=lambda row: abs(row[10] - MM * search.z_O))
    s, miss = ([row[k] for row in rows] for k in (8, 9))
    nominal = parameters.nominal
    among = "one among" if any(row[0] == "nominal" for row in rows) else "not among"
    return Prose(
        "The rods know $D$ and $\\theta_\\mathrm{rim}$ only through the focal length: four "
        "dimensions, $f$, $d$, $r_b$ and $r_m$, for two numbers in the text. **What these two "
        "determine is the reach of the outer joints from the dish's axis, $d + r_m$**: over the "
        f"{len(members)} members of the family it is {sums.min():.0f} to {sums.max():.0f} mm, and "
        f"{min(*round_sums, sums.min()):.0f} to {max(*round_sums, sums.max()):.0f} with the round "
        "sets below. The rest is free: in the family $d$ goes from "
        f"{array[:, 1].min():.0f} to {array[:, 1].max():.0f} mm, $r_m$ from "
        f"{array[:, 3].min():.0f} to {array[:, 3].max():.0f}. Of round numbers (steps of "
        f"{MM * STEP:.0f} mm, {len(DIAMETERS)} diameters, {len(RIMS)} edge angles) {len(found)} "
        f"sets come within {WITHIN:g} mm. **The nominal set is {among} them, inferred and not "
        f"known**: $D$ = {nominal.D:g} m, $\\theta_\\mathrm{{rim}}$ = {nominal.theta_rim:g} "
        f"degrees, $d$ = {nominal.d:g} m, $r_b$ = {nominal.r_b:g} m and $r_m$ = {nominal.r_m:g} m "
        f"give {low:.2f} and {high:.2f} mm at the paper's "
        f"height, {MM * search.z_O:.2f} mm. Two conclusions of this study were computed again for "
        "the sets of the table, on the study's days: the largest S-joint angle is "
        f"{min(s):.0f} to {max(s):.0f} degrees and the largest miss {min(miss):.0f} to "
        f"{max(miss):.0f} mm. The height by least squares is {min(heights):.0f} to "
        f"{max(heights):.0f} mm over the family; of the sets of the table, set {nearest[0]} comes "
        f"nearest to the paper's, {abs(nearest[10] - MM * search.z_O):.1f} mm off. The rest "
        "of the study was computed with the nominal dimensions only. "
        "All this takes the rods to be those of the consistent "
        "facet; if the paper computed them by a reading of its own, the dimensions are others "
        "again."
    )
