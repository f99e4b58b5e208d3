"""Salgado Conrado et al. 2014: what the paper prints, in its order.

The figures are lost, and so is (3) with all that follows. The parts stand in files of their own.
"""

# The prints stand in the order of these imports.
# isort: off
from . import _salgado2014_units, _salgado2014_forces
from ._salgado2014_units import paper

__all__ = ["_salgado2014_forces", "_salgado2014_units", "paper"]
