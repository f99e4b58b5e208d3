"""What a direction does not depend on: a positive factor leaves it alone."""

from __future__ import annotations

from armillary.algebra import vector as v
from armillary.algebra.direction import normalised_in
from armillary.algebra.rotation import rotate


def of_the_same_direction(node: v.Vector) -> v.Vector:
    """A vector of the same direction that need not be normalised; the node where none is."""
    if normalised_in(node) is None:
        return node
    if isinstance(node, v.Unit):
        return of_the_same_direction(node.vector)
    if isinstance(node, v.Rotated):
        return rotate(node.rotation, of_the_same_direction(node.vector))
    if isinstance(node, v.VectorNegate):
        return v.negate_vector(of_the_same_direction(node.argument))
    assert isinstance(node, v.VectorReference)
    return of_the_same_direction(node.expression)
