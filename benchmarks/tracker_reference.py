"""What K4 must return: the work of inertia, weight and loads, body by body.

No angular velocity and no law of Euler's: a rigid body's rotation is that of three unit vectors
`e_k` with the second moments `S_k` for masses, so that it takes `S_k e_k'' . d e_k` of virtual
work. Velocities, accelerations and the ways of the bodies come of positions by dual numbers.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import mpmath

from benchmarks.duals import Number, Numbers, X, Y, Z, derivative, dot, rotate, sqrt
from benchmarks.tracker import SIZES

Uniform = Callable[[float, float], float]
PER_LEG = 16  # numbers of a leg in `_places`: its length, two centres, three axes
FEET = [math.radians(azimuth) for azimuth in (-150, -30, 90)]


@dataclass(frozen=True)
class Work:
    """How each number of `_places` changes by alpha and by beta, and its second derivative."""

    ways: list[Numbers]
    acceleration: Numbers

    def of(self, mass: Number, first: int, way: int, lift: Number = 0) -> Number:
        """Virtual work of a mass at a point whose three numbers start at `first`."""
        upwards = [0, 0, lift]
        return mass * sum(
            (self.acceleration[first + i] + upwards[i]) * self.ways[way][first + i]
            for i in range(3)
        )


def forces(v: Numbers) -> Numbers:
    """Forces of least norm: orthogonal to what does no work, and of the work that is due."""
    given, position = {}, 0
    for name, size in SIZES.items():
        given[name] = v[position : position + size]
        position += size
    angles, speeds, rates = (
        [*given["alpha" + order], *given["beta" + order]] for order in ("", "_dot", "_ddot")
    )

    def places(at: Numbers) -> Numbers:
        return _places(at, given)

    ways = [derivative(places, angles, along) for along in ((1, 0), (0, 1))]
    drift = derivative(lambda at: derivative(places, at, speeds), angles, speeds)
    acceleration = [d + a * rates[0] + b * rates[1] for d, a, b in zip(drift, *ways, strict=True)]
    tau = [_generalised(given, Work(ways, acceleration), way) for way in (0, 1)]
    a, b = ([ways[way][PER_LEG * leg] for leg in range(3)] for way in (0, 1))
    idle = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    return list(mpmath.lu_solve(mpmath.matrix([a, b, idle]), mpmath.matrix([*tau, 0])))


def _places(at: Numbers, given: dict[str, Numbers]) -> Numbers:
    """Of each leg the length, the bodies' centres and the axes; then the platform's axes."""
    alpha, beta = at
    found = []
    for i in range(3):
        R, theta, r, phi = (given[name][i] for name in ("R", "theta", "r", "phi"))
        foot = [R * mpmath.cos(theta), R * mpmath.sin(theta), given["h"][i]]
        joint = [r * mpmath.cos(phi), r * mpmath.sin(phi), 0]
        top = rotate(Z, alpha, rotate(X, beta, joint))
        top = [top[0], top[1], top[2] + given["h_0"][0]]
        along = [top[k] - foot[k] for k in range(3)]
        q = sqrt(dot(along, along))
        w = [x / q for x in along]
        first = rotate(Y, given["zeta"][i], Z)
        beside = [w[k - 2] * first[k - 1] - w[k - 1] * first[k - 2] for k in range(3)]
        size = sqrt(dot(beside, beside))
        second = [x / size for x in beside]
        third = [second[k - 2] * w[k - 1] - second[k - 1] * w[k - 2] for k in range(3)]
        lower = [foot[k] + given["t"][i] * w[k] for k in range(3)]
        upper = [top[k] - given["s"][i] * w[k] for k in range(3)]
        found += [q, *lower, *upper, *second, *w, *third]
    return found + [x for axis in (X, Y, Z) for x in rotate(Z, alpha, rotate(X, beta, axis))]


def _generalised(given: dict[str, Numbers], work: Work, way: int) -> Number:
    """Work that the drives must do as alpha (0) or beta (1) grows by one."""
    g, alpha = given["g"][0], given["alpha"][0]
    done = [-dot(given["n_d"], Z if way == 0 else rotate(Z, alpha, X))]
    for leg in range(3):
        start = PER_LEG * leg
        for mass, inertia, centre in (("m_t", "I_t", 1), ("m_s", "I_s", 4)):
            done.append(work.of(given[mass][leg], start + centre, way, lift=g))
            moments = given[inertia][3 * leg : 3 * leg + 3]
            done += [
                work.of(second, start + 7 + 3 * k, way)
                for k, second in enumerate(_second_moments(moments))
            ]
    for k, second in enumerate(_second_moments(given["I_m"])):
        axis = 3 * PER_LEG + 3 * k
        weight = given["m_m"][0] * g * given["r_sc"][k]
        done += [work.of(second, axis, way), weight * work.ways[way][axis + 2]]
    return sum(done)


def _second_moments(inertia: Sequence[Number]) -> Numbers:
    """Sums of m x^2 of a body, of its moments of inertia."""
    half = sum(inertia) / 2
    return [half - moment for moment in inertia]


def point(uniform: Uniform) -> list[float]:
    """A tracker like the paper's with every dimension moved, in fast motion."""

    def three(low: float, high: float) -> list[float]:
        return [uniform(low, high) for _ in range(3)]

    def near_feet() -> list[float]:
        return [azimuth + uniform(-0.3, 0.3) for azimuth in FEET]

    ends = [*three(0.2, 0.5), *near_feet(), *three(0.4, 0.8), *near_feet(), *three(-0.4, 0.1)]
    masses = [*three(0.1, 0.3), *three(0.1, 0.3), *three(1, 12), *three(1, 8)]
    inertias = [uniform(0.1, 2) for _ in range(18)]
    platform = [*three(2, 12), uniform(0.5, 0.8), uniform(20, 80), *three(-0.1, 0.1), 9.8]
    motion = [uniform(-3, 3), uniform(-1, 1), *(uniform(-3, 3) for _ in range(4))]
    loads = [*three(-200, 200), *three(-100, 100)]
    return [*ends, *three(-1.6, 0.6), *masses, *inertias, *platform, *motion, *loads]
