"""What the paper says of the days and of the lengths (Figs. 4 and 5), judged."""

import numpy as np

from .study_basis import AUTUMN, NAMES, SUMMER, WINTER
from .study_claims import MOTION, Claim, judged, yes
from .study_paths import ordered

MM = 1e3
SAME = 1e-9  # rad or m: less is rounding


def of_the_paths(facts):
    """Fig. 4."""
    noon, length, apart = facts["noon"], facts["length"], facts["apart"]
    beta = ", ".join(f"{b:.2f}" for k, b in enumerate(noon) if k != AUTUMN)
    yield Claim(
        ("Fig. 4",), MOTION, "Fig. 4: curves from bottom to top", "summer, equinox, winter",
        f"tilt at noon {beta} degrees", judged(ordered(facts)), "the sun and the latitude decide",
    )  # fmt: skip
    calendar = np.degrees(facts["calendar"])
    yield Claim(
        ("equinoxes",), MOTION, "the equinoxes have one path", "yes",
        "yes" if apart < SAME else f"up to {np.degrees(apart):.2f} degrees apart",
        judged(apart < SAME),
        "with the declinations that the study takes; by the calendar they are "
        f"{calendar:.2f} degrees apart",
    )  # fmt: skip
    first = noon[SUMMER] == min(noon) and length[SUMMER] == max(length)
    last = noon[WINTER] == max(noon) and length[WINTER] == min(length)
    ends = " and ".join(f"{90 - noon[k]:.2f} degrees, {length[k]:.2f} h" for k in (SUMMER, WINTER))
    yield Claim(
        ("summer and winter", "daylight"), MOTION,
        "sun highest and day longest in summer, lowest and shortest in winter", "yes", ends,
        judged(first and last), f"{NAMES[SUMMER]} and {NAMES[WINTER]}",
    )  # fmt: skip


def of_the_lengths(facts):
    """Fig. 5."""
    strokes, mirrored = facts["strokes"], facts["mirrored"]
    yield Claim(
        ("Fig. 5",), MOTION, "Fig. 5: $q_3$ varies little, $q_1$ and $q_2$ much", "yes",
        "{:.0f}, {:.0f} and {:.0f} mm".format(*(MM * strokes[k] for k in (2, 0, 1))),
        judged(strokes[2] < min(strokes[:2])), "longest less shortest, $q_3$ first",
    )  # fmt: skip
    yield Claim(
        ("Fig. 5'",), MOTION, "$q_1$ and $q_2$ symmetric", yes(True),
        "mirrored about noon" if mirrored < SAME else f"up to {MM * mirrored:.3g} mm apart",
        judged(mirrored < SAME), "$q_1$ as long before noon as $q_2$ after it",
    )  # fmt: skip
