"""How the direction of a vector moves: the part that turns it, and the part that is left.

A direction turns with the frames that carry it, which costs a cross product with an axis instead of
the derivative of every component. What is left is the motion inside the innermost frame. It is
taken of the vector before any normalisation, because a direction does not know the length.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.direction import (
    AzimuthCosine,
    AzimuthSine,
    ElevationTangent,
    horizontal_length,
    is_unit,
)
from armillary.algebra.rotation import keeps_norms, rotate

if TYPE_CHECKING:
    from armillary.algebra.derivative import Differentiator


@dataclass(frozen=True)
class Turning:
    """The motion of a direction: `along` moves by `spin` cross `along` plus `slip`.

    Attributes:
        spin: the angular velocity of the frames that carry the vector, in the outer frame.
        slip: the rest; null for a vector that is held in the innermost frame.
        along: a positive multiple of the vector, not normalised.
    """

    spin: v.Vector
    slip: v.Vector
    along: v.Vector


def turning(node: v.Vector, d: Differentiator) -> Turning:
    """How the direction of a vector moves under the seed of `d`."""
    if isinstance(node, v.Unit):
        return turning(node.vector, d)
    if isinstance(node, v.Rotated) and keeps_norms(node.rotation):
        inner = turning(node.vector, d)
        return Turning(
            v.add_vectors(d.angular_velocity(node.rotation), rotate(node.rotation, inner.spin)),
            rotate(node.rotation, inner.slip),
            _kept(node, node.vector, inner.along) or rotate(node.rotation, inner.along),
        )
    if isinstance(node, v.VectorNegate):
        inner = turning(node.argument, d)
        along = _kept(node, node.argument, inner.along) or v.negate_vector(inner.along)
        return Turning(inner.spin, v.negate_vector(inner.slip), along)
    if isinstance(node, v.VectorReference):
        inner = turning(node.expression, d)
        along = _kept(node, node.expression, inner.along) or inner.along
        return Turning(inner.spin, inner.slip, along)
    return Turning(v.NULL, d.vector(node), node)


def _kept(node: v.Vector, before: v.Vector, after: v.Vector) -> v.Vector | None:
    """The node itself where nothing in it was normalised: what is shared stays shared."""
    return node if after is before else None


def azimuth_rate(vector: v.Vector, motion: Turning) -> s.Scalar:
    """d(azimuth) = t (w_x sin + w_y cos) - w_z, and (x', y') across the azimuth over rho."""
    w, slip, along = motion.spin, motion.slip, motion.along
    if v.is_null(w) and is_unit(along):
        # Nothing else asks for sine and cosine; 1/rho serves the elevation too.
        turn = s.add(s.multiply(along.y, slip.x), s.negate(s.multiply(along.x, slip.y)))
        inverse = s.divide(s.ONE, horizontal_length(along))
        return s.multiply(turn, s.multiply(inverse, inverse))
    sine, cosine = AzimuthSine(vector), AzimuthCosine(vector)
    tilt = s.add(s.multiply(w.x, sine), s.multiply(w.y, cosine))
    turned = s.add(s.multiply(ElevationTangent(vector), tilt), s.negate(w.z))
    across = s.add(s.multiply(cosine, slip.x), s.negate(s.multiply(sine, slip.y)))
    return s.add(turned, s.divide(across, horizontal_length(along)))


def elevation_rate(vector: v.Vector, motion: Turning) -> s.Scalar:
    """d(elevation) = w_x cos - w_y sin, and the rise of what slips, seen from the origin."""
    w, slip, along = motion.spin, motion.slip, motion.along
    sine, cosine = AzimuthSine(vector), AzimuthCosine(vector)
    turned = s.add(s.multiply(w.x, cosine), s.negate(s.multiply(w.y, sine)))
    if v.is_null(slip):
        return turned
    rho = horizontal_length(along)
    if is_unit(along):  # its length cannot change, so the rise says it all
        return s.add(turned, s.divide(slip.z, rho))
    outward = s.add(s.multiply(sine, slip.x), s.multiply(cosine, slip.y))
    rise = s.add(slip.z, s.negate(s.multiply(ElevationTangent(vector), outward)))
    # Summed in the order of hypot: the squares of x and y are shared with it.
    flat = s.add(s.multiply(along.x, along.x), s.multiply(along.y, along.y))
    square = s.add(flat, s.multiply(along.z, along.z))
    return s.add(turned, s.multiply(rise, s.divide(rho, square)))
