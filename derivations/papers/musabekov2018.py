"""Musabekov et al. 2018: what the paper prints, in its order.

The figures are lost. The parts stand in files of their own: frames, then sun and drive angles.
"""

from . import _musabekov2018_drive
from ._musabekov2018_frames import paper

__all__ = ["_musabekov2018_drive", "paper"]
