"""Yu, Wu and Zhang: what the paper prints, in its order.

The figures are lost. The parts stand in files of their own, as the paper's sections.
"""

# The prints stand in the order of these imports.
# isort: off
from . import _yu_kinematics, _yu_links, _yu_dynamics, _yu_sun, _yu_table, _yu_days, _yu_energy
from ._yu_kinematics import paper

__all__ = [
    "_yu_days",
    "_yu_dynamics",
    "_yu_energy",
    "_yu_kinematics",
    "_yu_links",
    "_yu_sun",
    "_yu_table",
    "paper",
]
