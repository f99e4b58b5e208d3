"""The paper's study: its figures under their numbers, and why its numbers differ from ours."""

from armillary.verify.study import Part

from .study_bounds import bounds
from .study_forces import forces
from .study_forward import forward
from .study_heights import heights
from .study_lengths import lengths
from .study_motor import motor
from .study_pace import pace
from .study_paths import paths
from .study_power import power
from .study_readings import readings
from .study_singular import singular
from .study_start import start
from .study_unknowns import unknowns
from .study_verdict import NEEDS, verdict
from .study_zenith import zenith

parts = [
    Part("verdict", verdict, needs=NEEDS),
    ("start", start),
    ("paths", paths),
    ("lengths", lengths),
    ("forces", forces),
    ("power", power),
    Part("motor", motor, needs=("power",)),
    ("singular", singular),
    ("bounds", bounds),
    ("heights", heights),
    ("unknowns", unknowns),
    ("readings", readings),
    ("pace", pace),
    ("zenith", zenith),
    ("forward", forward),
]
