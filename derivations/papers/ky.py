"""Ky, Dianda, Savadogo, Bathiebo: what the paper prints, in its order.

The figures are lost, and with them the axes' compass directions: the systems that are claimed here
read x as east, y as north and z as up. The parts stand in files of their own.
"""

from . import _ky_trackers
from ._ky_mathematics import paper

__all__ = ["_ky_trackers", "paper"]
