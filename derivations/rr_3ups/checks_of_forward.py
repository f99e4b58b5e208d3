"""Lengths to angles: there and back, against SciPy, where lengths do not fit or do not tell."""

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare

from .reference import jacobian, lengths
from .samples import ANGLES, TABLE, call, fast, of_table

OFF = 0.1  # rad, of guesses for machines at random
# Degrees: the sun's declination, and how far guesses may be off on its path.
SURE = {23.45: 3.0, 0.0: 20.0, -23.45: 30.0}
WAYS = np.arange(12) * np.pi / 6  # in which they are off
ERROR = 2e-3  # m, of lengths that do not fit
DISCORD = 1e-5  # m
STEP = 1e-4  # rad: what the derivation states
HELD = 1e-5  # what it states as well: a part of the sum of r squared q squared
TURN = 2 * np.pi
SITE = np.radians(40.0)  # latitude of the paper's site


def forward_inverts(kernels):
    """From a guess that is off by 0.1 rad, the lengths lead back to the angles."""
    points = guessed(fast(51), OFF, 52)
    found = call(kernels.forward, points)
    yield told(found, Status.OK, "the search ends", points)
    yield back(found, points, "angles, lengths, angles", 1e-12)
    yield compare(
        "lengths of a machine leave nothing", "round trip", found.residual, 0.0, 1e-14, points,
        "forward", relative=False,
    )  # fmt: skip
    turned = {**points, "guess": points["guess"] + TURN * np.array([3, -2])}
    found = call(kernels.forward, turned)
    yield back(found, turned, "guesses that are off by whole turns lead there too", 1e-12)


def forward_by_scipy(kernels):
    """Where lengths do not fit, the squares of what their halved squares lack are least."""
    random = np.random.default_rng(53)
    points = guessed(fast(54, 40), OFF, 55)
    points["q"] = points["q"] + random.uniform(-ERROR, ERROR, points["q"].shape)
    wanted = np.array([_least_squares(row) for row in _rows(points)])
    found = call(kernels.forward, points)
    yield told(found, Status.OK, "the search ends on lengths that do not fit", points)
    aside = {**points, **dict(zip(ANGLES, wanted.T, strict=True))}
    yield back(found, aside, "angles at lengths that do not fit", 1e-7, "SciPy")
    yield compare(
        "what is left of lengths that do not fit", "SciPy", found.residual,
        np.linalg.norm(lengths(aside) - points["q"], axis=1), 1e-8, points, "forward",
        relative=False,
    )  # fmt: skip


def forward_is_redundant(kernels):
    """One of three lengths is told by the others: against that, errors grow as they are."""
    points = guessed(fast(56), OFF, 57)
    columns = jacobian(points) * points["q"][..., None]
    across = np.cross(columns[..., 0], columns[..., 1]) / points["q"]
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    for part in (1.0, 10.0):
        off = {**points, "q": points["q"] + part * DISCORD * across}
        found = call(kernels.forward, off)
        yield compare(
            f"lengths that differ by {part * DISCORD:g} m where angles cannot mend it leave that",
            "linear algebra", found.residual / (part * DISCORD), 1.0, 100 * part * DISCORD, off,
            "forward",
        )  # fmt: skip
        yield back(found, off, f"and move the angles by the square of {part * DISCORD:g} m",
                   1e3 * (part * DISCORD) ** 2, "linear algebra")  # fmt: skip


def forward_of_anything(kernels):
    """Lengths at random: what is answered with OK is a minimum, and its residual is its own."""
    random = np.random.default_rng(58)
    points = guessed(fast(59, 2000), 1.0, 60)
    points["q"] = random.uniform(0.2, 1.5, points["q"].shape)
    found = call(kernels.forward, points)
    good = found.status == Status.OK
    points = {name: value[good] for name, value in points.items()}
    here = {**points, "alpha": found.alpha[good], "beta": found.beta[good]}
    size = lengths(here)
    columns, rest = jacobian(here) * size[..., None], (size**2 - points["q"] ** 2) / 2
    step = np.abs(np.einsum("nij,nj->ni", np.linalg.pinv(columns), rest)).max(axis=1)
    yield compare(
        "where any three lengths end, another step goes no further than stated", "NumPy",
        np.maximum(step - STEP, 0.0), 0.0, 0.0, points, "forward",
    )  # fmt: skip
    yield compare(
        "the residual is what the lengths lack", "NumPy", found.residual[good],
        np.linalg.norm(size - points["q"], axis=1), 1e-13, points, "forward",
    )  # fmt: skip


def forward_on_the_day(kernels):
    """On the paths of the sun guesses lead back that are off by so much in any direction.

    Least at the summer solstice, which at noon passes where three lengths hardly tell two angles.
    """
    hours = np.radians(np.arange(-110.0, 111.0, 1.0))
    for declination, sure in SURE.items():
        track = kernels.track(
            latitude=SITE, declination=np.radians(declination), hour_angle=hours,
            hour_angle_rate=0.0,
        )  # fmt: skip
        at = np.stack([track.alpha, track.beta], axis=-1)[track.beta < np.pi / 2]
        off = np.radians(sure) * np.stack([np.cos(WAYS), np.sin(WAYS)], axis=-1)
        points = of_table(at.repeat(len(WAYS), axis=0))
        guess = at.repeat(len(WAYS), axis=0) + np.tile(off, (len(at), 1))
        points |= {"q": lengths(points), "guess": guess}
        found = call(kernels.forward, points)
        where = f"at the declination {declination:g}, from {sure:g} degrees off,"
        yield told(found, Status.OK, f"{where} the search ends", points)
        yield back(found, points, f"{where} it ends at the attitude", 1e-9)


def forward_is_blind(kernels):
    """Where some motion changes no length, the guess is given back and the status tells."""
    random = np.random.default_rng(61)
    away = 10.0 ** random.uniform(-8.0, 0.0, (400, 2)) * random.choice([-1.0, 1.0], (400, 2))
    points = of_table(away)
    points |= {"q": lengths(points), "guess": away}
    columns = jacobian(points) * points["q"][..., None]
    area = np.linalg.norm(np.cross(columns[..., 0], columns[..., 1]), axis=1)
    bound = HELD * np.sum((TABLE["r"] * points["q"]) ** 2, axis=1)
    clear = np.abs(area / bound - 1) > 1e-3
    near = {name: value[clear] for name, value in points.items()}
    wanted = np.where((area > bound)[clear], Status.OK, Status.SINGULAR)
    found = call(kernels.forward, near)
    yield told(found, wanted, "around home lengths do not tell the attitude", near)
    yield back(found, near, "around home a guess that is right stays", 1e-9)
    points = {**points, "r": np.zeros_like(points["r"]), "q": lengths(points)}
    found = call(kernels.forward, points)
    yield told(found, Status.SINGULAR, "joints at o tell nothing", points)
    yield back(found, points, "joints at o give the guess back", 1e-15)


# -- what the checks share ------------------------------------------------------------------------


def guessed(points, off, seed):
    """Motions with their lengths, and guesses that are off in random directions."""
    way = np.random.default_rng(seed).uniform(-np.pi, np.pi, len(points["alpha"]))
    angles = np.stack([points[name] for name in ANGLES], axis=-1)
    guess = angles + off * np.stack([np.cos(way), np.sin(way)], axis=-1)
    return {**points, "q": lengths(points), "guess": guess}


def told(found, wanted, claim, points):
    """A status everywhere."""
    return compare(claim, "geometry", found.status, wanted, 0.0, points, "forward")


def back(found, points, claim, tolerance, engine="round trip"):
    """Angles but for whole turns."""
    off = np.stack([getattr(found, name) - points[name] for name in ANGLES], axis=-1)
    off = off - TURN * np.round(off / TURN)
    return compare(claim, engine, off, 0.0, tolerance, points, "forward", relative=False)


def _rows(points):
    for k in range(len(points["alpha"])):
        yield {name: value[k : k + 1] for name, value in points.items()}


def _least_squares(row):
    """The angles by SciPy, from those of the machine that was disturbed."""

    def rest(angles):
        here = {**row, "alpha": angles[:1], "beta": angles[1:]}
        return ((lengths(here) ** 2 - row["q"] ** 2) / 2)[0]

    start = [row[name][0] for name in ANGLES]
    optimize = need("scipy.optimize")
    found = optimize.least_squares(rest, start, method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15)
    return found.x
