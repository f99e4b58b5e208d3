"""Curves that a simulation measured, for the page of its system to draw.

`simulation.py` may have a function `plots(kernels)` that yields these, as `checks` yields results.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Curve:
    """One line of a plot: its name, and its points from left to right."""

    name: str
    x: Sequence[float]
    y: Sequence[float]


@dataclass(frozen=True)
class Plot:
    """Up to four curves over one axis.

    Attributes:
        caption: what the plot shows, in a sentence.
        across: label of the horizontal axis, with its unit.
        up: label of the vertical axis, with its unit.
    """

    caption: str
    across: str
    up: str
    curves: tuple[Curve, ...]
