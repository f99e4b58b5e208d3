"""What a length and a direction do not depend on.

A turn, a sign and a name leave a length alone; a positive factor leaves a direction alone.
"""

from __future__ import annotations

from armillary.algebra import vector as v
from armillary.algebra.direction import normalised_in
from armillary.algebra.rotation import keeps_norms, rotate


def of_the_same_length(node: v.Vector) -> v.Vector:
    """The vector inside turns, signs and names."""
    while True:
        if isinstance(node, v.Rotated) and keeps_norms(node.rotation):
            node = node.vector
        elif isinstance(node, v.VectorNegate):
            node = node.argument
        elif isinstance(node, v.VectorReference):
            node = node.expression
        else:
            return node


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
