"""What a trough turned by water does: the questions that the lost part of the paper left."""

from .study_day import day
from .study_pulses import swings
from .study_reversal import reversal
from .study_sizes import sizes
from .study_smooth import smooth
from .study_start import start
from .study_surface import surface

parts = [
    ("start", start),
    ("pulses", swings),
    ("sizes", sizes),
    ("surface", surface),
    ("day", day),
    ("reversal", reversal),
    ("smooth", smooth),
]
