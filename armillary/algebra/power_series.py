"""Arithmetic of power series by their coefficients, of s^0, s^1, ... s^n.

A series is a tuple of scalars or of vectors; those that meet in one operation have one length.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TypeVar

from armillary.algebra import folding as f
from armillary.algebra import scalar as s
from armillary.algebra import vector as v

ScalarJet = tuple[s.Scalar, ...]
VectorJet = tuple[v.Vector, ...]
A = TypeVar("A", s.Scalar, v.Vector)

HALF = s.number(Fraction(1, 2))


def product(
    left: Sequence[A], right: Sequence[A], multiply: Callable[[A, A], s.Scalar]
) -> ScalarJet:
    """The Cauchy product, by the product of scalars or the dot product."""
    return tuple(
        f.total([multiply(left[j], right[k - j]) for j in range(k + 1)]) for k in range(len(left))
    )


def square(jet: Sequence[A], multiply: Callable[[A, A], s.Scalar]) -> ScalarJet:
    """The product of a series with itself."""
    return tuple(f.times(s.number(2), c) for c in half_square(jet, multiply))


def half_square(jet: Sequence[A], multiply: Callable[[A, A], s.Scalar]) -> ScalarJet:
    """Half of a series' product with itself: each mixed pair is met once."""
    found = []
    for k in range(len(jet)):
        pairs = [multiply(jet[j], jet[k - j]) for j in range((k + 1) // 2)]
        if k % 2 == 0:
            pairs.append(f.times(HALF, multiply(jet[k // 2], jet[k // 2])))
        found.append(f.total(pairs))
    return tuple(found)


def scaled(factor: ScalarJet, vector: VectorJet) -> VectorJet:
    """A multiple of a vector."""
    return tuple(
        f.total_vector([f.scaled(factor[j], vector[k - j]) for j in range(k + 1)])
        for k in range(len(vector))
    )


def cross(left: VectorJet, right: VectorJet) -> VectorJet:
    """The cross product."""
    return tuple(
        f.total_vector([f.cross(left[j], right[k - j]) for j in range(k + 1)])
        for k in range(len(left))
    )


def quotient(numerator: ScalarJet, denominator: ScalarJet) -> ScalarJet:
    """The q of n = d q, solved order by order."""
    found: list[s.Scalar] = []
    for k, entry in enumerate(numerator):
        known = [f.times(denominator[j], found[k - j]) for j in range(1, k + 1)]
        found.append(f.over(f.minus(entry, f.total(known)), denominator[0]))
    return tuple(found)


def direction(vector: VectorJet, length: ScalarJet) -> VectorJet:
    """The u of v = |v| u, solved order by order."""
    found: list[v.Vector] = [vector[0] if s.is_one(length[0]) else v.Unit(vector[0])]
    inverse = f.over(s.ONE, length[0])
    for k in range(1, len(vector)):
        known = f.total_vector([f.scaled(length[j], found[k - j]) for j in range(1, k + 1)])
        rest = f.plus_vector(vector[k], f.negative_vector(known))
        found.append(f.scaled(inverse, rest))
    return tuple(found)


def root(first: s.Scalar, half: ScalarJet) -> ScalarJet:
    """The r of r r = a, solved order by order from its first term and half of a."""
    found = [first]
    for k in range(1, len(half)):
        pairs = [f.times(found[j], found[k - j]) for j in range(1, (k + 1) // 2)]
        if k % 2 == 0:
            pairs.append(f.times(HALF, f.times(found[k // 2], found[k // 2])))
        found.append(f.over(f.minus(half[k], f.total(pairs)), first))
    return tuple(found)


def wave(angle: ScalarJet, sine: s.Scalar, cosine: s.Scalar) -> tuple[ScalarJet, ScalarJet]:
    """Sine and cosine from their first terms: S' = C a' and C' = -S a'."""
    up, down = [sine], [cosine]
    for k in range(1, len(angle)):
        speeds = [f.times(s.number(Fraction(j, k)), angle[j]) for j in range(1, k + 1)]
        rise = [f.times(speed, down[k - j]) for j, speed in enumerate(speeds, 1)]
        fall = [f.times(speed, up[k - j]) for j, speed in enumerate(speeds, 1)]
        up.append(f.total(rise))
        down.append(f.negative(f.total(fall)))
    return tuple(up), tuple(down)


def arc_tangent(y: ScalarJet, x: ScalarJet, square: ScalarJet) -> ScalarJet:
    """The angle of (x, y), where `square` is x^2 + y^2: a' = (x y' - y x') / (x^2 + y^2)."""
    speeds: list[s.Scalar] = []
    for k in range(len(y) - 1):
        turn = [
            f.times(s.number(j), f.minus(f.times(x[k + 1 - j], y[j]), f.times(y[k + 1 - j], x[j])))
            for j in range(1, k + 2)
        ]
        known = [f.times(square[j], speeds[k - j]) for j in range(1, k + 1)]
        speeds.append(f.over(f.minus(f.total(turn), f.total(known)), square[0]))
    return _from_speeds(f.angle(y[0], x[0]), speeds)


def arc_sine(sine: ScalarJet, cosine: ScalarJet) -> ScalarJet:
    """The angle in [-pi/2, pi/2] of a sine and its positive cosine: c a' = x'."""
    rates = tuple(f.times(s.number(k), c) for k, c in enumerate(sine) if k)
    return _from_speeds(f.arc_sine(sine[0]), quotient(rates, cosine[:-1]))


def _from_speeds(first: s.Scalar, speeds: Sequence[s.Scalar]) -> ScalarJet:
    """The series of a first term and of a derivative by s."""
    return (first, *(f.times(s.number(Fraction(1, k)), c) for k, c in enumerate(speeds, 1)))
