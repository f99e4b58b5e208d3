"""The words of a derivation; `armillary` offers them when one is first asked for."""

from armillary.algebra.derivative import partial, time_derivative
from armillary.algebra.direction import atan2_or_zero, direction_angles, full_turn
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench, hat, matrix, vee
from armillary.algebra.rotation import Rotation, elementary
from armillary.algebra.scalar import (
    PI,
    absolute,
    arcsin,
    atan2,
    cos,
    degrees,
    hypot,
    number,
    sin,
    sqrt,
    where,
    wrap,
)
from armillary.algebra.series import truncate
from armillary.algebra.vector import unit, vector
from armillary.derivation.motion import define_motion
from armillary.derivation.paper import Paper
from armillary.derivation.quantity import Kind, Rate
from armillary.derivation.record import Derivation
from armillary.derivation.status import Status
from armillary.mechanism.chain import Chain, X, Y, Z

__all__ = [
    "PI",
    "Chain",
    "Derivation",
    "Kind",
    "Matrix",
    "Paper",
    "Pose",
    "Rate",
    "Rotation",
    "Status",
    "Twist",
    "Wrench",
    "X",
    "Y",
    "Z",
    "absolute",
    "arcsin",
    "atan2",
    "atan2_or_zero",
    "cos",
    "define_motion",
    "degrees",
    "direction_angles",
    "elementary",
    "full_turn",
    "hat",
    "hypot",
    "matrix",
    "number",
    "partial",
    "sin",
    "sqrt",
    "time_derivative",
    "truncate",
    "unit",
    "vector",
    "vee",
    "where",
    "wrap",
]
