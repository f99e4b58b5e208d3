"""Mo et al. 2023: what the paper prints, in its order.

The figures and the tables are lost. The parts stand in files of their own, as the paper's sections.
"""

from . import _mo2023_platform, _mo2023_rods, _mo2023_study, _mo2023_sun
from ._mo2023_frames import paper

__all__ = ["_mo2023_platform", "_mo2023_rods", "_mo2023_study", "_mo2023_sun", "paper"]
