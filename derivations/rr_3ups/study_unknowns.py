"""What the unknown mass centre could explain of the paper's forces, and how firmly."""

import numpy as np

from armillary.verify.plots import Curve, HeatMap, centres
from armillary.verify.study import Heading, Prose, Result, text_of

from .study_balance import balance
from .study_basis import root
from .study_candidates import at_its_best, energies, forces, mechanical, noon_by_dawn
from .study_marks import crosses
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
    best = fit(found, target)
    kept = (
        [(found.bounded(z), z) for z in heights(found, published.peak_force)] if found.loose else []
    )
    yield drawing(found, target, best, kept)
    places = {"at o": (0.0, 0.0), "fits three drives best": best}
    places.update({f"two drives bounded, {'above' if z > 0 else 'below'} o": (y, z)
                   for y, z in kept})  # fmt: skip
    ratio = published.energy[1] / published.energy[0]
    if kept and (other := at_the_ratio(found, ratio, kept[-1][1])):
        places["two drives bounded, the paper's ratio of energies"] = other
    yield forces(found, places, published)
    yield energies(found, places, parameters)
    yield mechanical(found, places)
    values = sensitivity(found, best)
    residual = float(np.abs(found.figures((0.0, *best)) - target).max())
    told = facts(found, kept, parameters)
    yield Prose(fit_in_words(best, residual, values))
    if kept:
        yield at_its_best(found, (0.0, *kept[-1]))
        yield Prose(bounded_in_words(found, kept, published))
        yield Prose(above_in_words(told, published))
    yield Result("unknowns", {"residual": residual, **told})


def misfit(found, target, place):
    """Root mean square of what four figures of three drives miss, N."""
    return float(np.sqrt(np.mean((found.figures((0.0, *place)) - target) ** 2)))


def fit(found, target):
    """The mass centre (y, z) with the least misfit, by grids that shrink about the best."""
    place, width, count = (0.0, 0.0), REACH, 65
    while width > 1e-7:
        ticks = np.linspace(-width, width, count)
        tried = [(place[0] + y, place[1] + z) for y in ticks for z in ticks]
        place = min(tried, key=lambda at: misfit(found, target, at))
        width, count = 2 * (ticks[1] - ticks[0]), 9
    return place


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
    values = [[misfit(found, target, (y, z)) for y in middles] for z in middles]
    points = [Curve("best fit", *crosses([MM * best[0]], [MM * best[1]], *CROSS))]
    if kept:
        ends = np.array([-REACH, REACH])
        line = clip(np.array([found.bounded(z) for z in ends]), ends)
        points = [
            Curve("no pole", *(MM * of for of in line)),
            *points,
            Curve("peak", *crosses(*(MM * np.array(kept).T), *CROSS)),
        ]
    return HeatMap(
        "Root mean square by which the largest and the three mean forces of three drives miss the "
        "paper's, over the mass centre; the line of mass centres on which two drives have no pole, "
        "and the places on it with the paper's largest force at sunrise.",
        "y of the mass centre, mm", "z of the mass centre, mm", "misfit, N",
        MM * edges, MM * edges, values, MISFIT, curves=points,
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


def fit_in_words(best, residual, values):
    """How well, and how well determined."""
    first, second, third = values
    blind = "0" if third < 1e-6 else f"{third:.1g}"
    y, z = (text_of(MM * at, ".1f") for at in best)
    return (
        "**No mass centre gives the paper's four figures of three drives.** The best, "
        f"y = {y} mm and z = {z} mm, still misses one by {residual:.0f} N. It is not for want of a "
        f"firm answer: the singular values of the fit are {first:.1f} and {second:.1f} N/mm, so "
        "that an error of 1 N in the figures moves the answer by "
        f"{1 / first:.1f} and {1 / second:.1f} mm; the third, of $x$, is {blind}: no force of this "
        "day tells it."
    )


def bounded_in_words(found, kept, published):
    """What a mass centre does for two drives."""
    pole = found.loose[0]
    return (
        "On one line of mass centres two drives keep finite forces, though they still do not hold "
        "the platform at the crossings: there the weights ask for nothing along the motion that "
        f"is not held. A millimetre beside it they ask for {abs(pole.slopes[1]) / MM:.2f} N m of "
        f"the {abs(pole.value):.1f} N m that they ask for with the mass centre at o, and the pole "
        f"is back. The paper's {published.peak_force:g} N at sunrise for both mechanisms then "
        f"leave {len(kept)} places on the line."
    )


def above_in_words(told, published):
    """What comes along with the mass centre above o."""
    (peak, size), (peak_2, size_2) = told["mechanical"]
    low, high = (KILO * of for of in told["energy"])
    same = "equal" if abs(peak / peak_2 - 1) < 0.01 else "unequal"
    y, z = (text_of(MM * at, ".1f") for at in told["place"])
    means, means_2 = (", ".join(f"{m:.0f}" for m in told[key]) for key in ("means", "means_two"))
    return (
        f"**One of them, y = {y} mm and z = {z} mm, brings much of the paper along that was not "
        f"asked for**: {same} peaks of mechanical power, {MILLI * peak:.2f} and "
        f"{MILLI * peak_2:.2f} mW, and a mean that is {'higher' if size > size_2 else 'lower'} "
        f"with three drives; a total that is {'lower' if low < high else 'higher'} with three, "
        f"{low:.1f} against {high:.1f} kJ where the paper has {published.energy[0]:g} and "
        f"{published.energy[1]:g}. It does not bring the means, {means} N and {means_2} N, nor the "
        "ratio of the energies, which no motor enters; and around noon two drives then heat "
        f"{told['noon_two']:.2f} of what they do at sunrise, where the paper has its peaks. The "
        "paper may have had a mass centre near it; its figures do not determine one."
    )


def facts(found, kept, parameters):
    """What the summary needs: the last of the places without poles."""
    if not kept:
        return {}
    centre = (0.0, *kept[-1])
    largest, *means = found.figures(centre).tolist()
    _, *means_two = found.figures_two(centre).tolist()
    return {
        "place": list(kept[-1]), "largest": largest, "means": means, "means_two": means_two,
        "mechanical": found.mechanical(centre), "noon": noon_by_dawn(found.three, kept[-1]),
        "noon_two": noon_by_dawn(found.two, kept[-1]),
        "energy": [constant(parameters) * square for square in found.squares(centre)],
    }  # fmt: skip
