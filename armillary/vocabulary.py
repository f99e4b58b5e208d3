"""The words of a derivation; `armillary` offers them when one is first asked for."""

from armillary.algebra.derivative import partial, time_derivative
from armillary.algebra.direction import atan2_or_zero, direction_angles, full_turn
from armillary.algebra.functions import (
    absolute,
    arccos,
    arcsin,
    atan2,
    cos,
    degrees,
    hypot,
    reciprocal_or_zero,
    sin,
    sqrt,
    where,
    wrap,
)
from armillary.algebra.indexed import any_of, at, one_like, total
from armillary.algebra.iteration import solve
from armillary.algebra.linear import determinant, solved
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench, hat, matrix, vee
from armillary.algebra.rotation import Rotation, elementary
from armillary.algebra.scalar import PI, number
from armillary.algebra.series import truncate
from armillary.algebra.substitute import substitute
from armillary.algebra.vector import unit, vector
from armillary.derivation.drawing import near
from armillary.derivation.motion import define_motion
from armillary.derivation.paper import Paper
from armillary.derivation.quantity import Kind, Rate
from armillary.derivation.record import Derivation
from armillary.derivation.status import Status
from armillary.mechanism.attitude import Axes, tilted, tilting
from armillary.mechanism.body import Body
from armillary.mechanism.chain import Chain, X, Y, Z
from armillary.mechanism.platform import Leg, Place, Platform, stack_wrenches, virtual_work
from armillary.mechanism.scene import Frame, Plate, Ray, Rod, Scene, Trace
from armillary.mechanism.universal import UniversalLeg, leg_axes, second_axis

__all__ = [
    "PI",
    "Axes",
    "Body",
    "Chain",
    "Derivation",
    "Frame",
    "Kind",
    "Leg",
    "Matrix",
    "Paper",
    "Place",
    "Plate",
    "Platform",
    "Pose",
    "Rate",
    "Ray",
    "Rod",
    "Rotation",
    "Scene",
    "Status",
    "Trace",
    "Twist",
    "UniversalLeg",
    "Wrench",
    "X",
    "Y",
    "Z",
    "absolute",
    "any_of",
    "arccos",
    "arcsin",
    "at",
    "atan2",
    "atan2_or_zero",
    "cos",
    "define_motion",
    "degrees",
    "determinant",
    "direction_angles",
    "elementary",
    "full_turn",
    "hat",
    "hypot",
    "leg_axes",
    "matrix",
    "near",
    "number",
    "one_like",
    "partial",
    "reciprocal_or_zero",
    "second_axis",
    "sin",
    "solve",
    "solved",
    "sqrt",
    "stack_wrenches",
    "substitute",
    "tilted",
    "tilting",
    "time_derivative",
    "total",
    "truncate",
    "unit",
    "vector",
    "vee",
    "virtual_work",
    "where",
    "wrap",
]
