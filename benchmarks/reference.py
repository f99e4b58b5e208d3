"""What the kernels must return, to 50 digits, and the points at which they are asked.

Nothing here is shared with the recipes: vectors are turned by Rodrigues' formula instead of
matrices, the sun is a chain of turns instead of a formula, and derivatives are carried by dual
numbers instead of being derived.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence

import mpmath

from benchmarks import tracker_reference
from benchmarks.duals import (
    Number,
    Numbers,
    X,
    Y,
    Z,
    atan2,
    cos,
    derivative,
    dot,
    rotate,
    sin,
    sqrt,
    unit,
)

DIGITS = 50

Step = tuple[str, Sequence[int], Number]


def carry(chain: Sequence[Step], point: Sequence[Number]) -> Numbers:
    """Image of a point under a chain of turns and shifts, read from the outermost frame in."""
    p = list(point)
    for kind, axis, amount in reversed(chain):
        if kind == "turn":
            p = rotate(axis, amount, p)
        else:
            p = [p[i] + amount * axis[i] for i in range(3)]
    return p


def images(chain: Sequence[Step]) -> Numbers:
    """Images of the origin and of the three unit points: 12 numbers that fix the pose."""
    return [x for point in ((0, 0, 0), X, Y, Z) for x in carry(chain, point)]


def frame(chain: Sequence[Step]) -> tuple[Numbers, list[Numbers]]:
    """Origin and unit vectors of the last frame."""
    flat = images(chain)
    origin = flat[:3]
    return origin, [[flat[3 * k + i] - origin[i] for i in range(3)] for k in (1, 2, 3)]


def twist(build: Callable[[Numbers], list[Step]], v: Numbers, along: Sequence[int]) -> Numbers:
    """Velocity of the last frame's origin, then its angular velocity, as one input moves."""
    slopes = derivative(lambda u: images(build(u)), v, along)
    velocity = slopes[:3]
    _, units = frame(build(v))
    rates = [[slopes[3 * k + i] - velocity[i] for i in range(3)] for k in (1, 2, 3)]
    # omega . e_x = e_z . de_y/dt and cyclic; then back from the frame's own components.
    own = [dot(units[2], rates[1]), dot(units[0], rates[2]), dot(units[1], rates[0])]
    return velocity + [sum(own[k] * units[k][i] for k in range(3)) for i in range(3)]


def geometric_jacobian(build: Callable[[Numbers], list[Step]], v: Numbers, joints: int) -> Numbers:
    """Twists for unit rates of the first inputs, as the columns of a row-major 6 x n matrix."""
    columns = [twist(build, v, unit(len(v), joint)) for joint in range(joints)]
    return [columns[joint][row] for row in range(6) for joint in range(joints)]


# --- the kernels --------------------------------------------------------------------------------


def _two_axis_chain(v: Numbers) -> list[Step]:
    gamma, nu, l0, l1, l2 = v
    return [
        ("shift", Z, l0),
        ("turn", Z, gamma),
        ("shift", Y, l1),
        ("turn", X, nu),
        ("shift", Z, l2),
    ]


def _two_axis(v: Numbers) -> Numbers:
    origin, units = frame(_two_axis_chain(v))
    rows = [[units[0][i], units[1][i], units[2][i], origin[i]] for i in range(3)]
    return [*rows[0], *rows[1], *rows[2], 0, 0, 0, 1, *geometric_jacobian(_two_axis_chain, v, 2)]


def _heliostat_values(v: Numbers) -> Numbers:
    hour, dec, lat, bx, by, bz, theta, psi, chi = v
    pole = [0 * lat, cos(lat), sin(lat)]
    sun = rotate(pole, -hour, rotate(X, lat - dec, Z))
    m = [bx + sun[0], by + sun[1], bz + sun[2]]
    size = sqrt(dot(m, m))
    n = [component / size for component in m]
    n = rotate(X, -theta, rotate(Y, -psi, rotate(Z, -chi, n)))
    return [*n, atan2(n[0], n[1]), atan2(n[2], sqrt(n[0] * n[0] + n[1] * n[1]))]


def _heliostat(v: Numbers) -> Numbers:
    columns = [derivative(_heliostat_values, v, unit(9, place))[3:] for place in (6, 7, 8)]
    return _heliostat_values(v) + [columns[k][row] for row in range(2) for k in range(3)]


def _leg_lengths(v: Numbers) -> Numbers:
    lengths = []
    for leg in range(3):
        a, b = v[5 + 3 * leg : 8 + 3 * leg], v[14 + 3 * leg : 17 + 3 * leg]
        p = carry([("shift", Z, v[4]), ("turn", Z, v[0]), ("turn", X, v[1])], a)
        s = [b[i] - p[i] for i in range(3)]
        lengths.append(sqrt(dot(s, s)))
    return lengths


def _leg_jacobian(v: Numbers) -> Numbers:
    columns = [derivative(_leg_lengths, v, unit(len(v), place)) for place in (0, 1)]
    return [columns[k][leg] for leg in range(3) for k in range(2)]


def _legs(v: Numbers) -> Numbers:
    motion = [v[2], v[3]] + [0] * (len(v) - 2)
    return [
        *_leg_lengths(v),
        *derivative(_leg_lengths, v, motion),
        *_leg_jacobian(v),
        *derivative(_leg_jacobian, v, motion),
    ]


def _arm_chain(v: Numbers) -> list[Step]:
    d1, a2, a3, d6 = v[6:]
    return [
        *(("turn", Z, v[0]), ("shift", Z, d1)),
        *(("turn", Y, v[1]), ("shift", Z, a2)),
        *(("turn", Y, v[2]), ("shift", X, a3)),
        *(("turn", X, v[3]), ("turn", Y, v[4]), ("turn", X, v[5]), ("shift", X, d6)),
    ]


def _arm(v: Numbers) -> Numbers:
    return geometric_jacobian(_arm_chain, v, 6)


_MODELS = {
    "K1": _two_axis,
    "K2": _heliostat,
    "K3": _legs,
    "A6": _arm,
    "K4": tracker_reference.forces,
}


def values(kernel: str, point: Sequence[float]) -> list[float]:
    """What a kernel must return at a point, computed with 50 digits and then rounded."""
    with mpmath.workdps(DIGITS):
        return [float(y) for y in _MODELS[kernel]([mpmath.mpf(x) for x in point])]


# --- the points ---------------------------------------------------------------------------------


def points(kernel: str, n: int = 16) -> list[list[float]]:
    """Points in the working range, the same in every run, away from singularities."""
    uniform = random.Random(kernel).uniform
    return [_POINTS[kernel](uniform) for _ in range(n)]


Uniform = Callable[[float, float], float]


def _two_axis_point(uniform: Uniform) -> list[float]:
    ranges = ((-3, 3), (-1.4, 1.4), (1, 3), (-0.3, 0.3), (0.1, 1))
    return [uniform(*bounds) for bounds in ranges]


def _heliostat_point(uniform: Uniform) -> list[float]:
    bearing, height = uniform(-3, 3), uniform(-0.3, 0.5)
    b = [math.sin(bearing) * math.cos(height), math.cos(bearing) * math.cos(height)]
    sun = [uniform(-1.2, 1.2), uniform(-0.41, 0.41), uniform(-0.9, 0.9)]
    return [*sun, *b, math.sin(height), *(uniform(-0.4, 0.4) for _ in range(3))]


def _legs_point(uniform: Uniform) -> list[float]:
    def ring(radius: float) -> list[float]:
        """Three anchors near a regular triangle, none of them exactly on it."""
        anchors = []
        for leg in range(3):
            angle = 2 * math.pi * leg / 3 + uniform(-0.1, 0.1)
            anchors += [radius * math.cos(angle), radius * math.sin(angle), uniform(-0.05, 0.05)]
        return anchors

    motion = [uniform(-0.6, 0.6) for _ in range(4)]
    return [*motion, uniform(1.2, 1.6), *ring(0.5), *ring(0.9)]


def _arm_point(uniform: Uniform) -> list[float]:
    return [uniform(-3, 3) for _ in range(6)] + [uniform(0.1, 1) for _ in range(4)]


_POINTS: dict[str, Callable[[Uniform], list[float]]] = {
    "K1": _two_axis_point,
    "K2": _heliostat_point,
    "K3": _legs_point,
    "A6": _arm_point,
    "K4": tracker_reference.point,
}
