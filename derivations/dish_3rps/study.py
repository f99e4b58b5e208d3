"""The paper's study: its figures and tables under their numbers, and what it did not ask."""

from .study_attitude import attitudes
from .study_conditioning import conditioning
from .study_forward import forward
from .study_height import height
from .study_joints import passive_joints
from .study_model import model
from .study_precision import precision
from .study_receiver import receiver
from .study_rods import rods
from .study_sizes import sizes
from .study_start import start
from .study_sun import sun_paths

parts = [
    ("start", start),
    ("sun", sun_paths),
    ("height", height),
    ("rods", rods),
    ("attitudes", attitudes),
    ("joints", passive_joints),
    ("conditioning", conditioning),
    ("model", model),
    ("receiver", receiver),
    ("sizes", sizes),
    ("forward", forward),
    ("precision", precision),
]
