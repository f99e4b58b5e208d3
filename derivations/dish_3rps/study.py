"""The paper's study: its figures and tables under their numbers, and what it did not ask."""

from armillary.verify.study import Part

from .study_attitude import attitudes
from .study_conditioning import conditioning
from .study_control import searches, tuning
from .study_day import compressed
from .study_forward import forward
from .study_gust import gust
from .study_height import height
from .study_joints import passive_joints
from .study_model import model
from .study_moves import attitudes_in_mujoco, moves
from .study_precision import precision
from .study_receiver import receiver
from .study_rods import rods
from .study_sizes import sizes
from .study_start import start
from .study_sun import sun_paths
from .study_verdict import verdict
from .study_windows import WINDOWS, afternoon, morning, noon, real_time

TUNED = ("tuning",)

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
    Part("verdict", verdict, needs=("day", "real_time", "gust")),
    ("tuning", tuning),
    Part("searches", searches, needs=TUNED),
    Part("moves", moves, needs=TUNED),
    Part("day", compressed, needs=TUNED),
    Part(WINDOWS[0], morning, needs=TUNED),
    Part(WINDOWS[1], noon, needs=TUNED),
    Part(WINDOWS[2], afternoon, needs=TUNED),
    Part("real_time", real_time, needs=("tuning", *WINDOWS)),
    Part("gust", gust, needs=TUNED),
    Part("mujoco", attitudes_in_mujoco, needs=TUNED),
]
