"""What it costs to ignore theta, psi or chi, and whether chi is negligible."""

import numpy as np

from armillary.verify.plots import Band, Curve, Mark, Panels, Plot, centres, sky_map
from armillary.verify.study import Column, Heading, Prose, Table

from .sky import (
    EAST,
    IDEAL,
    LATITUDE,
    LOWEST,
    MILLI,
    NORTH,
    RISE,
    ROUND,
    SIZES,
    UP,
    around,
    astray,
    beam_shift,
    elevation_of,
    exactly,
    facing,
    field,
    middle,
    rms,
    spelled,
    toward,
)

SYMBOLS = {"theta": "$\\theta$", "psi": "$\\psi$", "chi": "$\\chi$"}
LETTERS = {"theta": "θ", "psi": "ψ", "chi": "χ"}
SHARES = (0.1, 0.5)
SKIES = (("facing the sun", facing), ("on receivers", field))
ASKED = 0.1  # mrad of normal


def neglect(kernels):
    """One misalignment ignored at a time, and whether chi is negligible."""
    yield Heading("What does it cost to ignore one of them?")
    yield Prose(
        "The drive angles are computed for ideal axes; the machine has one misalignment. The sun "
        f"goes through a year at {LATITUDE:g} degrees north, at least {LOWEST:g} degrees high, "
        "every half hour counting alike. A mirror faces it, or mirrors all round a tower, in "
        f"{len(ROUND)} directions, throw it on a receiver {RISE:g} degrees high."
    )
    done = {name: costs(kernels, sky()) for name, sky in SKIES}
    yield table(done, "Root mean square", rms)
    yield table(done, "Worst", np.max)
    yield closed_forms(kernels, done)
    yield over_the_sky(kernels)
    yield Heading("Is chi negligible?")
    yield by_elevation(kernels)
    yield verdict(done)


def costs(kernels, points):
    """Angles of normal and beam in mrad, by misalignment and size; and the normals' elevation."""
    angles = kernels.drive(**points, **IDEAL)
    return {
        (name, size): np.array(astray(kernels, points, angles, exactly(**{name: size * MILLI})))
        / MILLI
        for name in SYMBOLS
        for size in SIZES
    }


def table(done, kind, over):
    """One number over the sky for each: of the normal, then of the beam."""
    rows = [
        (symbol, sky, what, *(over(cost[name, size][k]) for size in SIZES))
        for name, symbol in SYMBOLS.items()
        for sky, cost in done.items()
        for k, what in enumerate(("normal", "beam"))
    ]
    return Table(
        f"{kind} over the working sky of the angle between normal or beam and the one that is "
        f"wanted, with one misalignment of {SIZES[0]:g} to {SIZES[-1]:g} mrad ignored.",
        [
            "ignored",
            "mirror",
            "angle of",
            *(Column(f"for {s:g} mrad", "mrad", ".2f") for s in SIZES),
        ],
        rows,
    )


def unit_costs(cost):
    """What the smallest size of each misalignment costs, over that size."""
    return [found / size for (_, size), found in cost.items() if size == SIZES[0]]


# -- closed forms ---------------------------------------------------------------------------------


def slips(points):
    """The closed form: the vector that the normal moves by, per unit of each misalignment."""
    n = middle(points)
    level = n - n[..., 2:] * UP
    axes = {"theta": EAST, "psi": NORTH, "chi": level / np.linalg.norm(level, axis=-1)[..., None]}
    return {name: np.cross(axis, n) for name, axis in axes.items()}


def closed_forms(kernels, done):
    """How well they fit, at the largest size, and the answer."""
    worst = np.max([found.max(axis=1) for cost in done.values() for found in unit_costs(cost)], 0)
    size, points = SIZES[-1] * MILLI, field()
    angles = kernels.drive(**points, **IDEAL)
    off = [0.0, 0.0]
    for name, slip in slips(points).items():
        normal, beam = astray(kernels, points, angles, exactly(**{name: size}))
        for k, (exact, closed) in enumerate(
            ((normal, np.linalg.norm(slip, axis=-1)), (beam, beam_shift(points, slip)))
        ):
            off[k] = max(off[k], np.abs(exact - size * closed).max() / exact.max())
    return Prose(
        "A slip turns the normal about an axis, east for $\\theta$, north for $\\psi$, and for "
        "$\\chi$ the level line towards the normal's azimuth; so the normal moves by "
        "$\\delta_\\theta = |\\theta| \\sqrt{1 - \\cos^2 E \\sin^2 A}$, "
        "$\\delta_\\psi = |\\psi| \\sqrt{1 - \\cos^2 E \\cos^2 A}$ and "
        "$\\delta_\\chi = |\\chi| \\sin |E|$. The beam moves by "
        "$2 \\sqrt{(\\mathbf{c} \\cdot \\delta\\mathbf{n})^2 + "
        "(\\mathbf{c} \\cdot \\mathbf{n})^2 |\\delta\\mathbf{n}|^2}$: by twice as much when the "
        "mirror faces the sun, by less when the light comes in at a slant across the slip. At "
        f"{SIZES[-1]:g} mrad the exact kernels differ by at most {100 * off[0]:.1g}% of the "
        f"worst normal and {100 * off[1]:.1g}% of the worst beam. "
        f"**Each mrad that is ignored moves the normal by up to {worst[0]:.2f} mrad and the beam "
        f"by up to {worst[1]:.2f} mrad.**"
    )


def over_the_sky(kernels):
    """How far each moves the normal, over the sky of normals."""
    azimuth, elevation = np.arange(0.0, 361.0, 6.0), np.arange(0.0, 91.0, 5.0)
    n = toward(*np.meshgrid(centres(azimuth), centres(elevation)))
    angles = kernels.drive(c=n, b=n, **IDEAL)
    found = kernels.normal_errors(alpha=angles.alpha, beta=angles.beta, **IDEAL)
    levels = np.linspace(0.0, 1.0, 6)
    return Panels(
        "How far the normal moves for each mrad that is ignored, by where it points.",
        [
            sky_map(
                letter, "mrad per mrad", azimuth, elevation, getattr(found, f"e_{name}"), levels
            )
            for name, letter in LETTERS.items()
        ],
    )


# -- chi ------------------------------------------------------------------------------------------


def by_elevation(kernels):
    """The exact shift of the normal for 1 mrad of each, against its elevation."""
    rise = np.append(np.arange(0.5, 89.0, 2.0), 89.5)
    shift = {name: [] for name in SYMBOLS}
    for elevation in rise:
        points = around(elevation)
        angles = kernels.drive(**points, **IDEAL)
        for name in SYMBOLS:
            machine = exactly(**{name: MILLI})
            shift[name].append(astray(kernels, points, angles, machine)[0] / MILLI)
    theta = np.array(shift["theta"])
    chi = np.array(shift["chi"]).mean(axis=1)
    return Plot(
        "Angle of the normal when 1 mrad of $\\theta$ or of $\\chi$ is ignored; for $\\psi$ it is "
        "as for $\\theta$, a quarter turn on. What $\\chi$ does is what $\\theta$ does where it "
        "does least.",
        "elevation of the normal, degrees",
        "angle of the normal, mrad",
        [
            Curve("θ, root mean square all round", rise, np.sqrt((theta**2).mean(axis=1))),
            Curve("χ", rise, chi),
        ],
        [Mark(height_of(share), f"{share:.0%} of θ", across=True) for share in SHARES],
        [Band("θ, least to most", rise, theta.min(axis=1), theta.max(axis=1))],
    )


def height_of(share):
    """Elevation in degrees at which chi does that share of what theta does, all round."""
    # sin(E) = share sqrt(1 - cos(E)^2 / 2), solved for sin(E)
    return np.degrees(np.arcsin(share / np.sqrt(2 - share**2)))


def verdict(done):
    """Whether the conclusion of the paper is right."""
    ratio = {
        (sky, k): rms(cost["chi", 1.0][k]) / rms(cost["theta", 1.0][k])
        for sky, cost in done.items()
        for k in (0, 1)
    }
    low = [np.mean(elevation_of(middle(sky())) < height_of(SHARES[1])) for _, sky in SKIES]
    worst = [cost["chi", 1.0][1].max() for cost in done.values()]
    heights = (15.0, 30.0, 60.0)
    most = spelled(ASKED / np.sin(np.radians(heights)), ".2f")
    (first, second), (facing_, field_) = SHARES, done
    return Prose(
        "The paper concludes that the influence of $\\chi$ is negligible. All round, it moves the "
        "normal by $\\sin E / \\sqrt{1 - \\tfrac{1}{2} \\cos^2 E}$ of what a $\\theta$ of the same "
        f"size does: less than {first:.0%} only below {height_of(first):.1f} degrees of the "
        f"normal's elevation, less than {second:.0%} below {height_of(second):.1f} degrees, and "
        "just as much at the zenith. The working sky has its normal below the latter for "
        f"{low[0]:.0%} of the time when the mirror faces the sun and for {low[1]:.0%} on "
        "receivers. Over this sky $\\chi$ does "
        f"{ratio[facing_, 0]:.0%} of what $\\theta$ does to the normal, {ratio[field_, 0]:.0%} on "
        f"receivers, where it does {ratio[field_, 1]:.0%} to the beam. **So $\\chi$ is not "
        f"negligible: ignored, each mrad moves the beam by up to {worst[0]:.2f} mrad, and by "
        f"{worst[1]:.2f} mrad on receivers.** It may be ignored when it is small itself: to keep "
        f"the normal within {ASKED:g} mrad it must stay below {ASKED:g} mrad$/\\sin E$, which is "
        f"{most} mrad at {spelled(heights)} degrees. To first order it leaves the elevation drive "
        "alone, and a level normal does not feel it at all; so much of the conclusion holds."
    )
