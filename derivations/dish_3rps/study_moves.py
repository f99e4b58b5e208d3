"""The concentrator in MuJoCo: its moves from and to the initial position, and Figs. 14 and 16."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Axis, Curve, Panels, Plot
from armillary.verify.study import Column, Heading, Prose, Table

from .days import FACETS, MM, attitude, clock_words, toward
from .drawing import EYE_AZIMUTH, EYE_ELEVATION, GAP, NORMAL, seen
from .multibody import bases, ring
from .study_day import MRAD, day_of
from .tracking import AHEAD, PID, Stage, figures, follow, outline

CLOCK = (10.0, 12.0, 14.0)  # of Fig. 16
UPWARD = np.array([0.0, 0.0, 1.0])
NAMES = (PID, AHEAD)


def moves(kernels, native, sun, parameters, results, tell):
    """From the initial position to the sun in the morning, and back in the afternoon."""
    need("mujoco")
    stage = Stage(kernels, native, sun, parameters, results["gains"])
    days, tracking = parameters.days, parameters.tracking
    ends = [attitude(kernels, sun, parameters, tracking.day, h) for h in (days.first, days.last)]
    runs = {
        f"to {clock_words(days.first)}": run(stage, ends[0], outward=True),
        f"from {clock_words(days.last)}": run(stage, ends[1], outward=False),
    }
    tell(0.9)
    yield Heading("Fig. 14: the initial position, and the moves from it and to it")
    yield Prose(
        "With the sun at the zenith $\\alpha = \\beta = 0$: the initial position. From there the "
        "dish leans towards the sun of the morning, at that sun's azimuth all the way; from the "
        "last sun of the day it comes up again. The angle follows a polynomial of fifth degree, "
        "with neither speed nor acceleration at its ends, as long as the fastest rod's limit of "
        f"{MM * tracking.speed_limit:g} mm/s wants it: "
        + "; ".join(f"{name}: {of['duration']:.0f} s" for name, of in runs.items())
        + "."
    )
    first = next(iter(runs.values()))
    yield drawing(
        "Fig. 14: the concentrator in its initial position, as it stands in MuJoCo.",
        stage.shape, first["origins"], first["attitudes"], UPWARD,
    )  # fmt: skip
    yield Panels(
        "The largest error of the twelve rods in the moves.",
        [
            Plot(name, "time, s", Axis("largest error, mm", low=0.0), of["curves"])
            for name, of in runs.items()
        ],
    )
    yield table(runs)
    words = (f"The move {name}: {laws(of['rows'])}." for name, of in runs.items())
    yield Prose(" ".join(words))


def laws(rows):
    """What each law comes to in a move."""
    return "; ".join(
        f"under {law} a rod is off by up to {peak:.3f} mm and a normal by up to {tilt:.3f} mrad"
        for law, peak, tilt, *_ in rows
    )


def table(runs):
    """Move by move, law by law."""
    return Table(
        "The moves: errors, forces and speeds.",
        [
            "move", "law", Column("largest error of a rod", "mm", ".3f"),
            Column("largest error of a normal", "mrad", ".3f"), Column("largest force", "N", ".0f"),
            Column("fastest rod", "mm/s", ".1f"), Column("left at the end", "mm", ".3f"),
        ],
        [(name, *row) for name, of in runs.items() for row in of["rows"]],
    )  # fmt: skip


def run(stage, end, outward):
    """One move: its curves and rows, and the pose before it begins."""
    tracking = stage.parameters.tracking
    tilts = (0.0, float(end["beta"])) if outward else (float(end["beta"]), 0.0)
    azimuth = float(end["alpha"])
    # At one second the rods are as many times too fast as the move must be longer.
    second = stage.move(azimuth, tilts, 1.0)(tracking.settling + np.linspace(0.0, 1.0, 501))
    duration = float(np.ceil(np.abs(second.rates).max() / tracking.speed_limit))
    way = stage.move(azimuth, tilts, duration)
    loops = {name: stage.loop(name) for name in NAMES}
    time = stage.times(duration + 2 * tracking.settling)
    before = time < tracking.settling
    follow(loops, way, time[before])
    machine = loops[AHEAD].machine
    origins, attitudes = machine.origins, machine.attitudes
    follow(loops, way, time[~before])
    speed = np.abs(way(time[::50]).rates).max()
    rows, curves = [], []
    for name, loop in loops.items():
        of = figures(loop.record, tracking.settling)
        errors = MM * np.abs(loop.record.joined("errors")).max(axis=1)
        row = (MM * of.peak, MRAD * of.tilt, of.force, MM * speed, errors[-1])
        rows.append((name, *map(float, row)))
        curves.append(Curve(name, *outline(time[~before], errors[~before])))
    return {
        "duration": duration, "origins": origins, "attitudes": attitudes, "rows": rows,
        "curves": curves,
    }  # fmt: skip


# -- Fig. 16 --------------------------------------------------------------------------------------


def attitudes_in_mujoco(kernels, native, sun, parameters, results):
    """Fig. 16: where the tuned law has brought the facets."""
    need("mujoco")
    stage = Stage(kernels, native, sun, parameters, results["gains"])
    day, settling = parameters.tracking.day, parameters.tracking.settling
    drawings, rows = [], []
    for letter, hour in zip("abc", CLOCK, strict=True):
        loops = {PID: stage.loop(PID)}
        way, time = stage.day(hour, 1.0), stage.times(settling)
        follow(loops, way, time)
        machine, last = loops[PID].machine, way(time[-1:])
        drawings.append(
            drawing(
                f"({letter}) {clock_words(hour)}", stage.shape, machine.origins, machine.attitudes,
                toward(sun, parameters, day, hour),
            )
        )  # fmt: skip
        tilts = loops[PID].record.tilts[-1][-1]
        apart = np.linalg.norm(machine.origins - last.origins[0], axis=-1)
        for k, facet in enumerate(FACETS):
            at = (*(MM * machine.origins[k]), MM * apart[k], MRAD * tilts[k])
            rows.append((clock_words(hour), facet, *map(float, at)))
    yield Heading("Fig. 16: the concentrator at 10, 12 and 14 h")
    yield Prose(
        f"As it stands in MuJoCo after {settling:g} s under the tuned PID in real time, seen "
        f"from azimuth {EYE_AZIMUTH:.0f} degrees, {EYE_ELEVATION:.0f} degrees above the horizon."
    )
    yield Panels(f"Fig. 16: the concentrator at three times ({day_of(parameters)}).", drawings)
    yield Table(
        "Fig. 16 in numbers: the facets' points M in MuJoCo, and how far they and the normals are "
        "from where they should be.",
        [
            "time", "facet", *(Column(f"$M_{x}$", "mm", ".2f") for x in "xyz"),
            Column("M off by", "mm", ".3f"), Column("normal off by", "mrad", ".3f"),
        ],
        rows,
    )  # fmt: skip


def drawing(caption, shape, origins, attitudes, to_sun):
    """Four facets with bases, rods, platforms, normals, and rays to the sun."""
    feet, _ = bases(shape)
    ends = origins[:, None] + np.einsum("kab,ib->kia", attitudes, ring(shape["r_m"]))
    rods = [np.stack([a, b]) for a, b in zip(feet.reshape(-1, 3), ends.reshape(-1, 3), strict=True)]
    lines = {
        "rods": rods,
        "platforms": [np.concatenate([ring_, ring_[:1]]) for ring_ in ends],
        "bases": [np.concatenate([ring_, ring_[:1]]) for ring_ in feet],
        "normals": [
            np.stack([m, m + NORMAL * r[:, 2]]) for m, r in zip(origins, attitudes, strict=True)
        ],
        "to the sun": [np.stack([m, m + NORMAL * to_sun]) for m in origins],
    }
    curves = [Curve(name, *seen(broken(pieces))) for name, pieces in lines.items()]
    return Plot(caption, "to the right, m", "upward, m", curves, equal=True)


def broken(pieces):
    """Lines one after another, with gaps between."""
    return np.concatenate([part for piece in pieces for part in (piece, GAP)][:-1])
