"""Other readings of what is printed, and what comes out by each."""

import numpy as np

from armillary.verify.study import Column, Heading, Prose, Table

from .study_basis import centre_words, day_of, mean, mount, near, sign_changes, three, two

HALF = np.pi
BODIES = (
    "weights of both links twice",
    "weights of first links twice",
    "no weight of the legs, mass centre 50 mm above o",
    "mass centre at [200 0 0] mm",
    "mass centre at [0 200 0] mm",
    "mass centre at [0 0 200] mm",
    "mass centre at [0 0 −200] mm",
)


def readings(kernels, sun, parameters):
    """Forces of the equinox, reading by reading."""
    day = day_of(kernels, sun, parameters)
    published = parameters.published
    rows = [
        (name, *figures(kernels, parameters, day, **how)) for name, how in ways(parameters).items()
    ]
    rows.append(
        ("the paper", published.peak_force, *published.mean_forces, None, published.peak_force)
    )
    yield Heading("Other readings")
    yield Prose(
        "What is printed leaves choices. Each row changes one, the platform's mass centre "
        f"{centre_words(parameters)} where it is not said otherwise. At the sun's pace a weight "
        "that is counted twice, as (20) does for a mass centre along the leg, is a mass that is "
        "doubled."
    )
    yield Table(
        "Forces on the equinox by reading; two drives have a largest force where they are not "
        "singular.",
        [
            "reading", Column("three drives: largest", "N", ".1f"),
            *(Column(f"mean, leg {i}", "N", ".1f") for i in (1, 2, 3)),
            "two drives: crossings", Column("largest", "N", ".1f"),
        ],
        rows,
    )  # fmt: skip
    yield Prose(words(rows, published))


def ways(parameters):
    """Readings: kernel parameters that change, and how the platform turns."""
    bodies = parameters.bodies
    m_t, m_s = np.array(bodies.m_t), np.array(bodies.m_s)
    h, R = np.array(parameters.mount.h), np.array(parameters.mount.R)
    flat = np.array([0.0, 0.0, h[2]])
    return {
        "as in this study": {},
        "the frame of (31): leg 3 to the south": {"turn": HALF},
        "tilt of the other sign": {"turn": HALF, "sign": -1.0},
        "weights of both links twice": {"m_t": 2 * m_t, "m_s": 2 * m_s},
        "weights of first links twice": {"m_t": 2 * m_t},
        "no weight of the legs, mass centre 50 mm above o": {
            "m_t": 0 * m_t, "m_s": 0 * m_s, "r_sc": np.array([0.0, 0.0, 0.05]),
        },
        "mass centre at [200 0 0] mm": {"r_sc": np.array([0.2, 0.0, 0.0])},
        "mass centre at [0 200 0] mm": {"r_sc": np.array([0.0, 0.2, 0.0])},
        "mass centre at [0 0 200] mm": {"r_sc": np.array([0.0, 0.0, 0.2])},
        "mass centre at [0 0 −200] mm": {"r_sc": np.array([0.0, 0.0, -0.2])},
        "universal joints 1 and 2 on the ground": {"h": flat},
        "universal joint 3 as far out as the others": {"R": np.full(3, R[0])},
    }  # fmt: skip


def figures(kernels, parameters, day, turn=0.0, sign=1.0, **changed):
    """Largest and mean forces, crossings, and the largest force of two drives or None."""
    size = mount(parameters, **changed)
    state = {name: (sign if "beta" in name else 1.0) * of for name, of in day.state.items()}
    state["alpha"] = state["alpha"] + turn
    F = np.abs(three(kernels, state, size))
    det = kernels.singularity(alpha=state["alpha"], beta=state["beta"], **size).det_2
    count = len(sign_changes(det, day.clock))
    largest = None if count else float(np.nanmax(np.abs(two(kernels, state, size))))
    return float(F.max()), *(mean(column, day.clock) for column in F.T), count, largest


def words(rows, published):
    """Whether any fits, and what two drives do."""
    *ours, theirs = rows
    fits = [row[0] for row in ours if all(near(a, b) for a, b in zip(row[1:5], theirs[1:5],
                                                                     strict=True))]  # fmt: skip
    off = [max(abs(a - b) for a, b in zip(row[1:5], theirs[1:5], strict=True)) for row in ours]
    best = min(range(len(ours)), key=off.__getitem__)
    found = (
        f"**{', '.join(f'“{name}”' for name in fits)} gives the paper's four figures of three "
        "drives.**"
        if fits
        else "**Of these, none gives the paper's four figures of three drives**; the nearest, "
        f"“{ours[best][0]}”, misses one by {off[best]:.0f} N."
    )
    return f"{found} {of_two(ours, published)}"


def of_two(ours, published):
    """In how many readings two drives are singular, and what decides it."""
    singular = sum(row[5] > 0 for row in ours)
    first, *others = ours
    same = all(row[5] == first[5] for row in others if row[0] in BODIES)
    moved = [f"“{row[0]}”" for row in others if (row[5] > 0) != (first[5] > 0)]
    decides = (
        "; the mass centre and the weights do not change how often"
        if same
        else "; the weights change how often"
    )
    but = f", {', '.join(moved)} {'does' if len(moved) == 1 else 'do'}" if moved else ""
    held = [row for row in ours if row[5] == 0]
    bound = min((row[6] for row in held), default=0.0)
    rest = (
        f" Where they hold, their largest force is at least {bound:.0f} N; the paper has "
        f"{published.peak_force:g} N."
        if held
        else ""
    )
    return f"In {singular} of {len(ours)} two drives are singular on the way{decides}{but}.{rest}"
