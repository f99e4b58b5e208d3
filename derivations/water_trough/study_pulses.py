"""Three pulses of the pump: the trough sticks, slips and swings, and the book of energy closes."""

import numpy as np

from armillary.verify.plots import Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Result, Table, text_of

from .motion_of import Motion, closed, energies
from .pumping import experiment
from .troughs import SIZES, TITLES, trough

MM = 1e3
MOST = 1e-8  # of the range of the energy, that the book may be open by
TIME = "time, s"


def swings(kernels, native, parameters, tell):
    """Both troughs through three pulses; the smaller is drawn."""
    given, record = moved(native, parameters, SIZES[0], lambda part, at: tell(part / 2, at))
    _, other = moved(native, parameters, SIZES[1], lambda part, at: tell((1 + part) / 2, at))
    yield Heading("Three pulses: the trough sticks, slips and swings")
    yield Prose(
        f"The smaller trough is given three pulses within {parameters.pulses.length:g} s, faster "
        "than tracking would ever be. It is integrated from event to event with the compiled "
        "kernels: it stands while `acceleration` answers STICKING, and between two events the "
        "motion is smooth."
    )
    yield from drawn(native, given, record)
    yield listed(record)
    yield drawn_book(native, given, record)
    yield from books(native, parameters, dict(zip(SIZES, (record, other), strict=True)))


def moved(native, parameters, size, tell):
    """A trough and its motion; the larger has flows as much larger as its own pump's."""
    given = trough(parameters, size)
    scale = getattr(parameters, size).q_pump / getattr(parameters, SIZES[0]).q_pump
    first = float(native.rest_angle(s=0.0, **given).theta)
    pieces = experiment(parameters.pulses, scale)
    return given, Motion(native, given).run(pieces, first, tell=tell)


def drawn(native, given, record):
    """Angle, levels, reactions."""
    time, s = record.column("time"), record.column("s")
    levels = native.levels(s=s, **given)
    rest = native.rest_angle(s=s, **given).theta
    forces = native.reactions(**record.states, **given)
    yield Plot(
        "The angle under three pulses: it follows the water.",
        TIME, "angle, degrees",
        [
            Curve("trough", time, np.degrees(record.column("theta"))),
            Curve("rest without friction", time, np.degrees(rest)),
        ],
    )  # fmt: skip
    yield Plot(
        "How far the trough is off the angle at which it would rest without friction. See how it "
        "keeps still when a pulse begins and so falls behind, swings while the pump runs, and is "
        "left by friction beside the rest.",
        TIME, "angle off the rest, degrees",
        [Curve("trough", time, np.degrees(record.column("theta") - rest))],
    )  # fmt: skip
    yield Plot(
        "The levels in the containers: they follow the pump and nothing else.",
        TIME, "level, mm",
        [Curve("container 1", time, MM * levels.h_1), Curve("container 2", time, MM * levels.h_2)],
    )  # fmt: skip
    yield Plot(
        "What the motion adds to the weight that the bearings carry, "
        f"{forces.F_A[0, 1]:.1f} N on A and {forces.F_B[0, 1]:.1f} N on B, which is farther off. "
        "See the spikes where the flow comes and goes, the swings, and the steps where the trough "
        "turns round or stops.",
        TIME, "force less weight, N",
        [
            Curve("A, upward", time, forces.F_A[:, 1] - forces.F_A[0, 1]),
            Curve("B, upward", time, forces.F_B[:, 1] - forces.F_B[0, 1]),
            Curve("A, sideways", time, forces.F_A[:, 0]),
            Curve("B, sideways", time, forces.F_B[:, 0]),
        ],
    )  # fmt: skip


def listed(record):
    """When it begins to slip, turns, and sticks."""
    return Table(
        "The events of the motion.",
        [Column("time", "s", ".6f"), Column("angle", "degrees", ".6f"), "from then on"],
        [(time, np.degrees(theta), mode) for time, theta, mode in record.events],
    )


def drawn_book(native, given, record):
    """The book of energy of the smaller."""
    time, work, heat = (record.column(name) for name in ("time", "work", "heat"))
    total = energies(native, given, record)
    return Plot(
        "The book of energy: what the pump has done, less what the bearings made heat of, is what "
        "trough and water have gained.",
        TIME, "energy, J",
        [
            Curve("work of the pump", time, work), Curve("heat of the bearings", time, heat),
            Curve("gained by trough and water", time, total - total[0]),
        ],
    )  # fmt: skip


def books(native, parameters, records):
    """Both books."""
    rows, worst = [], 0.0
    for size, record in records.items():
        given = trough(parameters, size)
        span = float(np.ptp(energies(native, given, record)))
        off = float(np.abs(closed(native, given, record)).max()) / span
        theta = record.column("theta")
        past = np.abs(theta - native.rest_angle(s=record.column("s"), **given).theta).max()
        rows.append((
            TITLES[size], len(record.events) - 1, np.degrees(np.abs(theta).max()),
            np.degrees(past), record.column("work")[-1], record.column("heat")[-1], span, off,
        ))  # fmt: skip
        worst = max(worst, off)
    yield Table(
        "Both troughs through the pulses; the flows of the larger are as much larger as its pump "
        "is.",
        [
            "trough", "events", Column("largest angle", "degrees", ".2f"),
            Column("farthest off the rest", "degrees", ".2f"),
            Column("work of the pump", "J", ".4f"), Column("heat", "J", ".4f"),
            Column("range of the energy", "J", ".4f"), Column("book open by", "of it", ".1e"),
        ],
        rows,
    )  # fmt: skip
    closes = "closes" if worst <= MOST else "does not close"
    yield Prose(
        f"**The book {closes}** for both: it is open by at most {text_of(worst, '.1e')} of the "
        "range of the energy. The pump's work can be negative: water that sinks gives it back."
    )
    yield Result("book", {"open": worst, "heat": [row[5] for row in rows]})
