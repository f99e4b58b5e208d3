"""Passes: pure functions from a program to a cheaper one with the same values."""

from armillary.program.passes.angle_sums import open_angle_sums
from armillary.program.passes.arc_tangents import open_arc_tangents
from armillary.program.passes.divisions import share_reciprocals
from armillary.program.passes.factor import factor_sums
from armillary.program.passes.gather import gather_turns
from armillary.program.passes.multiple_angles import expand_multiple_angles
from armillary.program.passes.regroup import regroup_products
from armillary.program.scalarise import scalarise

PASSES = (
    expand_multiple_angles,
    open_angle_sums,
    open_arc_tangents,
    regroup_products,
    factor_sums,
    share_reciprocals,
    regroup_products,
)
# From what is lowered to what is printed: vectors and rotations are opened in between.
STAGES = (gather_turns, scalarise, *PASSES)

__all__ = [
    "PASSES",
    "STAGES",
    "expand_multiple_angles",
    "factor_sums",
    "gather_turns",
    "open_angle_sums",
    "open_arc_tangents",
    "regroup_products",
    "share_reciprocals",
]
