"""A sun that passes near the zenith, which it never does at the paper's site."""

import numpy as np

from armillary.verify.plots import Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .study_basis import SUMMER, declination, hour_angle_of

NOON = 12.0


def zenith(kernels, sun, parameters):
    """Both ways of aiming through noon, at some distances from the zenith."""
    given = parameters.zenith
    count = 2 * round(given.span / given.step)
    # Noon falls between two aims: at noon itself half of the turn would be one of them.
    minutes = given.step * (np.arange(count) - (count - 1) / 2)
    found = {miss: ways(kernels, toward(sun, parameters, miss, minutes)) for miss in given.misses}
    yield Heading("Near the zenith")
    clear = abs(parameters.site.latitude - parameters.days.declination[SUMMER])
    yield Prose(
        f"At the paper's site the sun comes within {clear:.2f} degrees of the zenith. Where it "
        "passes nearer, on a site nearer the equator, the attitude with β ≥ 0 must turn half about "
        "within the pass. The kernel aim_nearest goes on from the attitude before: it follows "
        "where α turns by less than a quarter from one aim to the next, else α stays and β changes "
        "its sign, which is the same direction."
    )
    shown = given.misses[-2] if len(given.misses) > 1 else given.misses[0]
    yield Plot(
        "Turn and tilt of the platform while the sun passes the zenith, at the least distance but "
        "one of the table.",
        "time from noon, min", "degrees",
        [
            Curve(f"{letter}, {name}", minutes, np.degrees(angles))
            for name, (alpha, beta) in found[shown].items()
            for letter, angles in (("α", alpha), ("β", beta))
        ],
    )  # fmt: skip
    yield table(found, given)


def toward(sun, parameters, miss, minutes):
    """Directions to a sun that culminates so many degrees south of the zenith."""
    angle = declination(parameters, SUMMER)
    return sun.direction(
        latitude=angle + np.radians(miss),
        declination=angle,
        hour_angle=hour_angle_of(NOON + minutes / 60),
    ).enu


def ways(kernels, enu):
    """Turn and tilt by either kernel, rad."""
    plain = kernels.aim(enu=enu)
    alpha, beta = [float(plain.alpha[0])], [float(plain.beta[0])]
    for direction in enu[1:]:
        at = kernels.aim_nearest(enu=direction, alpha_before=alpha[-1], beta_before=beta[-1])
        alpha.append(float(at.alpha))
        beta.append(float(at.beta))
    return {"aim": (plain.alpha, plain.beta), "aim_nearest": (np.array(alpha), np.array(beta))}


def table(found, given):
    """The largest turns from one aim to the next."""
    rows = []
    for miss, by in found.items():
        steps = [
            float(np.degrees(np.abs(np.diff(np.asarray(angles))).max()))
            for angles in (by["aim"][0], *by["aim_nearest"])
        ]
        changes = bool(np.min(by["aim_nearest"][1]) < 0)
        rows.append((miss, *steps, "yes" if changes else "no"))
    return Table(
        f"Largest change from one aim to the next, {given.step:g} min apart, by the least distance "
        "of the sun from the zenith.",
        [
            Column("distance", "degrees", "g"), Column("aim: α", "degrees", ".1f"),
            Column("aim_nearest: α", "degrees", ".1f"),
            Column("aim_nearest: β", "degrees", ".2f"), "β changes its sign",
        ],
        rows,
    )  # fmt: skip
