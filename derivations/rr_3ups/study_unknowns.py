"""What the unknown mass centre could explain of the paper's forces, and how firmly."""

import numpy as np

from armillary.verify.plots import Curve, HeatMap, centres
from armillary.verify.study import Heading, Prose, Result, text_of

from .study_balance import balance
from .study_basis import near, root
from .study_candidates import at_its_best, energies, forces, has_no_pole, mechanical, told
from .study_marks import covering, crosses
from .study_power import constant

MM = 1e3
CROSS = (3.0, 3.0)  # mm
MILLI = 1e3
KILO = 1e-3
REACH = 0.08  # m, how far from o the mass centre is looked for
CELLS = 32
MISFIT = (0.0, 5.0, 10.0, 20.0, 40.0, 80.0, 160.0, 320.0)  # N


def unknowns(kernels, sun, parameters):
    """The best mass centres, beside what each leaves open."""
    found, published = balance(kernels, sun, parameters), parameters.published
    target = np.array([published.peak_force, *published.mean_forces])
    yield Heading("What could the platform's mass centre explain?")
    yield Prose(
        "The platform's weight turns it about its level axis only. So the drives feel the mass "
        "centre's $y$ and $z$ in the platform's axes and not its $x$, and of mass and place only "
        "the products. All forces are affine in them; the kernels at four mass centres give every "
        "other one."
    )
    best = fit(found.figures, target)
    kept = on_the_line(found, published.peak_force)
    places = candidates(found, best, kept, published)
    yield drawing(found, target, best, kept)
    yield forces(found, {"at o": (0.0, 0.0), **places}, published)
    yield energies(found, {"at o": (0.0, 0.0), **places}, parameters)
    yield mechanical(found, {"at o": (0.0, 0.0), **places})
    figures = found.figures((0.0, *best))
    yield Prose(fit_in_words(best, figures, target, sensitivity(found, best)))
    centres_ = [told(found, name, place) for name, place in places.items()]
    if found.loose:
        yield Prose(bounded_in_words(found, kept, published))
    if kept:
        yield at_its_best(found, (0.0, *kept[-1]))
        yield Prose(chosen_in_words(told(found, "", kept[-1]), parameters))
    yield Result("unknowns", {
        "residual": float(np.abs(figures - target).max()), "conditions": found.held_back(),
        "fits": fits(figures, target), "centres": centres_,
    })  # fmt: skip


def on_the_line(found, peak):
    """Mass centres (y, z) without poles that give the peak at sunrise, from the lowest up."""
    if found.held_back() != 1:
        return []
    places = [(found.bounded(z), z) for z in heights(found, peak)]
    return [place for place in places if has_no_pole(found, place)]


def candidates(found, best, kept, published):
    """The mass centres that are looked at, by name; the highest without poles is the first."""
    places = {
        f"two drives bounded, {'above' if z > 0 else 'below'} o": (y, z) for y, z in reversed(kept)
    }
    ratio = published.energy[1] / published.energy[0]
    if kept and (other := at_the_ratio(found, ratio, kept[-1][1])):
        places["two drives bounded, the paper's ratio of energies"] = other
    places["fits three drives best"] = best
    if not found.loose:
        target = np.array([published.peak_force, *published.mean_forces_two])
        places["fits two drives best"] = fit(found.figures_two, target)
    return places


def fits(figures, target):
    """Whether all figures are reproduced."""
    return all(near(a, b) for a, b in zip(figures, target, strict=True))


def misfit(figures, target, place):
    """Root mean square of what figures miss, N."""
    return float(np.sqrt(np.mean((figures((0.0, *place)) - target) ** 2)))


def fit(figures, target):
    """The mass centre (y, z) with the least misfit, by grids that shrink about the best."""
    place, width, count = (0.0, 0.0), REACH, 65
    while width > 1e-7:
        ticks = np.linspace(-width, width, count)
        tried = [(place[0] + y, place[1] + z) for y in ticks for z in ticks]
        place = min(tried, key=lambda at: misfit(figures, target, at))
        width, count = 2 * (ticks[1] - ticks[0]), 9
    return float(place[0]), float(place[1])


def at_the_ratio(found, ratio, height):
    """The mass centre without poles, above a height, where two drives heat so much more."""

    def short(z):
        one, other = found.squares((0.0, found.bounded(z), z))
        return other / one - ratio

    if short(height) * short(REACH) > 0:
        return None
    z = root(short, height, REACH)
    return found.bounded(z), z


def heights(found, peak):
    """Heights of the mass centre, m, at which the larger force at sunrise is the peak."""
    first = found.three.value[0, :2], found.three.slopes[0, :2, 2]
    roots = sorted(
        (sign * peak - f) / slope for f, slope in zip(*first, strict=True) for sign in (-1, 1)
    )
    return [z for z in roots if np.abs(first[0] + first[1] * z).max() < peak * (1 + 1e-9)]


def drawing(found, target, best, kept):
    """Misfit over the mass centre."""
    edges = np.linspace(-REACH, REACH, CELLS + 1)
    middles = centres(edges)
    values = [[misfit(found.figures, target, (y, z)) for y in middles] for z in middles]
    seen = (
        "; the line of mass centres on which two drives have no pole, and the places on it with "
        "the paper's largest force at sunrise"
        if kept
        else ""
    )
    least = misfit(found.figures, target, best)
    points = [Curve("best fit", *crosses([MM * best[0]], [MM * best[1]], *CROSS))]
    if found.held_back() == 1:
        ends = np.array([-REACH, REACH])
        line = clip(np.array([found.bounded(z) for z in ends]), ends)
        points = [
            Curve("no pole", *(MM * of for of in line)),
            *points,
            *([Curve("peak", *crosses(*(MM * np.array(kept).T), *CROSS))] if kept else []),
        ]
    return HeatMap(
        "Root mean square by which the largest and the three mean forces of three drives miss the "
        f"paper's, over the mass centre; it is least at the best fit, {least:.1f} N{seen}.",
        "y of the mass centre, mm", "z of the mass centre, mm", "misfit, N",
        MM * edges, MM * edges, values, covering(MISFIT, values), curves=points,
    )  # fmt: skip


def clip(y, z):
    """The part of a line within the map."""
    along = np.linspace(0.0, 1.0, 401)
    line = y[0] + along * (y[1] - y[0]), z[0] + along * (z[1] - z[0])
    inside = np.abs(line[0]) <= REACH
    return line[0][inside], line[1][inside]


def sensitivity(found, place):
    """Singular values of the derivative of four figures by the mass centre, N/mm."""
    step, columns = 1e-6, []
    for k in range(3):
        ends = []
        for sign in (1, -1):
            centre = np.array([0.0, *place])
            centre[k] += sign * step
            ends.append(found.figures(centre))
        columns.append((ends[0] - ends[1]) / (2 * step) / MM)
    return np.linalg.svd(np.stack(columns, axis=-1), compute_uv=False).tolist()


def fit_in_words(best, figures, target, values):
    """How well, and how well determined."""
    first, second, third = values
    blind = "0" if third < 1e-6 else f"{third:.1g}"
    y, z = (text_of(MM * at, ".1f") for at in best)
    off = float(np.abs(figures - target).max())
    good = fits(figures, target)
    return (
        f"**{'A' if good else 'No'} mass centre gives the paper's four figures of three drives.** "
        f"The best, y = {y} mm and z = {z} mm, misses one by {off:.1f} N. The singular values of "
        f"the fit are {first:.1f} and {second:.1f} N/mm, so that an error of 1 N in the figures "
        f"moves the answer by {1 / first:.1f} and {1 / second:.1f} mm"
        + ("" if good else ": it is not for want of a firm answer")
        + f"; the third, of $x$, is {blind}: no force of this day tells it."
    )


def bounded_in_words(found, kept, published):
    """What a mass centre does for two drives."""
    if found.held_back() > 1:
        return (
            "The crossings ask for different mass centres: "
            + ("one alone" if found.held_back() == 2 else "none")
            + " keeps the forces of two drives finite at all of them."
        )
    pole = found.loose[0]
    left = {0: "no place", 1: "one place", 2: "two places"}.get(len(kept), f"{len(kept)} places")
    return (
        "On one line of mass centres two drives keep finite forces, though they still do not hold "
        "the platform at the crossings: there the weights ask for nothing along the motion that "
        f"is not held. A millimetre beside it they ask for {abs(pole.slopes[1]) / MM:.2f} N m of "
        f"the {abs(pole.value):.1f} N m that they ask for with the mass centre at o, and the pole "
        f"is back. The paper's {published.peak_force:g} N at sunrise for both mechanisms leave "
        f"{left} on the line."
    )


def chosen_in_words(chosen, parameters):
    """What comes along with the mass centre without poles that lies highest."""
    published, (one, other) = parameters.published, chosen["drives"]
    (peak, size), (peak_2, size_2) = one["mechanical"], other["mechanical"]
    low, high = (KILO * constant(parameters) * of["squares"] for of in (one, other))
    y, z = (text_of(MM * at, ".1f") for at in chosen["place"])
    same = "equal" if near(peak, peak_2) else "unequal"
    means, theirs = ("{}; {}".format(*(", ".join(f"{m:.0f}" for m in of) for of in both))
                     for both in ((one["means"], other["means"]),
                                  (published.mean_forces, published.mean_forces_two)))  # fmt: skip
    around, around_there = other["most"] / other["dawn"], (
        published.noon_copper[1] / published.peak_copper
    )  # fmt: skip
    return (
        f"The highest of them, y = {y} mm and z = {z} mm, has {same} peaks of mechanical power, "
        f"{MILLI * peak:.2f} and {MILLI * peak_2:.2f} mW, equal in the paper, and a mean that is "
        f"{'higher' if size > size_2 else 'lower'} with three drives, higher in the paper; a total "
        f"that is {'lower' if low < high else 'higher'} with three, {low:.1f} against {high:.1f} "
        f"kJ, where the paper has {published.energy[0]:g} and {published.energy[1]:g}: "
        f"{high / low:.2f} times against {published.energy[1] / published.energy[0]:.2f}, and no "
        f"motor enters that; means of {means} N, where the paper has {theirs} N; and around noon "
        f"two drives heat {around:.2f} of what they do at sunrise, in the paper "
        f"{around_there:.2f}. {determined(chosen, published)}"
    )


def determined(chosen, published):
    """Whether a mass centre gives the published forces."""
    one, other = chosen["drives"]
    same = fits(one["means"], published.mean_forces) and fits(
        other["means"], published.mean_forces_two
    )
    if same:
        return "**It gives all of the paper's forces.**"
    return (
        "**It does not give the paper's means.** The paper may have had a mass centre near it; its "
        "figures do not determine one."
    )
