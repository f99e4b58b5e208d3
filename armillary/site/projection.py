"""Space on paper: the viewer stands south-south-east of a mechanism and looks down on it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from armillary.site.svg import Point2

Array = NDArray[np.float64]

_BEARING, _HEIGHT = np.radians(-62.0), np.radians(24.0)
_RIGHT = np.array([-np.sin(_BEARING), np.cos(_BEARING), 0.0])
_UP = np.array(
    [-np.sin(_HEIGHT) * np.cos(_BEARING), -np.sin(_HEIGHT) * np.sin(_BEARING), np.cos(_HEIGHT)]
)
_PIXELS = 330.0


class Paper:
    """Points of the base frame on the paper, in pixels to the right and down."""

    def __init__(self, size: float) -> None:
        self.scale = _PIXELS / (1.25 * (size if size > 0 else 1.0))

    def __call__(self, point: Array) -> Point2:
        return float(_RIGHT @ point) * self.scale, float(-_UP @ point) * self.scale
