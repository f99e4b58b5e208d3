"""K4 by recursive Newton-Euler in the links' own axes, every intermediate named.

The tree is platform and legs, cut at the spherical joints; the closure gives the legs' joint
rates, and the Jacobian of their angles carries their moments over to alpha and beta.
"""

from __future__ import annotations

from dataclasses import dataclass

from benchmarks.matrices import (
    Matrix,
    Ops,
    Scalar,
    Vector,
    apply,
    cross,
    diagonal,
    dot,
    minus,
    plus,
    product,
    rotation,
    times,
    total,
    transpose,
    turn_matrix,
)
from benchmarks.tracker import Leg, Tracker, least_norm, sorted_out


@dataclass(frozen=True)
class Platform:
    """Rotation, angular velocity and acceleration in its own axes, and the two drive axes."""

    rotation: Matrix
    omega: Vector
    omega_dot: Vector
    axes: list[Vector]


@dataclass(frozen=True)
class Pose:
    """A leg's length, the part of it across the first axis, the sine and cosine of psi, frames."""

    q: Scalar
    level: Scalar
    c_psi: Scalar
    s_psi: Scalar
    frame: Matrix
    from_platform: Matrix


@dataclass(frozen=True)
class Motion:
    """How a leg turns, and how its second link slides, in the leg's axes."""

    omega: Vector
    omega_dot: Vector
    sliding: Vector


def by_recursion(ops: Ops, v: Vector) -> Vector:
    """Outwards the motions, inwards the forces, then the closure and the least norm."""
    m = sorted_out(v)
    platform, tau = _platform(ops, m)
    jacobian = []
    for leg in m.legs:
        joint = ops.named(leg.joint(ops))
        pose = _pose(ops, m, leg, platform, joint)
        ways = [ops.named(apply(pose.from_platform, cross(axis, joint))) for axis in platform.axes]
        motion = _motion(ops, platform, pose, joint)
        moment, push = _demand(ops, m, leg, pose, motion)
        about = apply(turn_matrix("x", pose.c_psi, pose.s_psi), moment)[2]
        share = [
            total([-way[0] / pose.level * about, way[2] / pose.q * moment[0], way[1] * push])
            for way in ways
        ]
        jacobian.append([way[1] for way in ways])
        tau = ops.named(plus(tau, share))
    return least_norm(jacobian, tau)


def _platform(ops: Ops, m: Tracker) -> tuple[Platform, Vector]:
    """How the platform moves, and the moments about both axes that it asks for."""
    z_turn, x_turn = (rotation(ops, a, angle) for a, angle in zip("zx", m.x, strict=True))
    back = transpose(x_turn)
    attitude = _named_rows(ops, product(z_turn, x_turn))
    carried = ops.named(apply(back, [0, 0, m.x_dot[0]]))
    hinge = [m.x_dot[1], 0, 0]
    omega = ops.named(plus(carried, hinge))
    turned = apply(back, [0, 0, m.x_ddot[0]])
    omega_dot = ops.named(plus(turned, cross(carried, hinge), [m.x_ddot[1], 0, 0]))
    up = ops.named(apply(transpose(attitude), times(-1, m.gravity)))
    moment = plus(_own_moment(ops, m.I_m, omega, omega_dot), cross(m.r_sc, times(m.m_m, up)))
    moment = ops.named(minus(moment, apply(transpose(attitude), m.n_d)))
    axes = [apply(back, [0, 0, 1]), [1, 0, 0]]
    return Platform(attitude, omega, omega_dot, axes), [apply(x_turn, moment)[2], moment[0]]


def _pose(ops: Ops, m: Tracker, leg: Leg, platform: Platform, joint: Vector) -> Pose:
    """Length and angles of a leg by its closure."""
    mount = rotation(ops, "y", leg.zeta)
    top = plus([0, 0, m.h_0], apply(platform.rotation, joint))
    along = ops.named(apply(transpose(mount), minus(top, leg.foot(ops))))
    (level,) = ops.named([ops.sqrt(along[0] * along[0] + along[1] * along[1])])
    (q,) = ops.named([ops.sqrt(dot(along, along))])
    c_gamma, s_gamma = ops.named([along[1] / level, -along[0] / level])
    c_psi, s_psi = ops.named([level / q, along[2] / q])
    turns = (turn_matrix("z", c_gamma, s_gamma), turn_matrix("x", c_psi, s_psi))
    frame = _named_rows(ops, product(mount, *turns))
    from_platform = _named_rows(ops, product(transpose(frame), platform.rotation))
    return Pose(q, level, c_psi, s_psi, frame, from_platform)


def _motion(ops: Ops, platform: Platform, pose: Pose, joint: Vector) -> Motion:
    """Joint rates and accelerations of a leg by those of its end, and what they do."""
    velocity = ops.named(cross(platform.omega, joint))
    turning = cross(platform.omega_dot, joint)
    acceleration = ops.named(plus(turning, cross(platform.omega, velocity)))
    q, c, s = pose.q, pose.c_psi, pose.s_psi
    vx, q_dot, vz = ops.named(apply(pose.from_platform, velocity))
    gamma_dot, psi_dot = ops.named([-vx / pose.level, vz / q])
    omega = ops.named([psi_dot, gamma_dot * s, gamma_dot * c])
    gyric = ops.named([0, gamma_dot * psi_dot * c, -gamma_dot * psi_dot * s])
    sliding = ops.named(times(2, cross(omega, [0, q_dot, 0])))
    swing = ops.named(cross(omega, cross(omega, [0, q, 0])))
    drift = plus(sliding, cross(gyric, [0, q, 0]), swing)
    ax, q_ddot, az = ops.named(minus(apply(pose.from_platform, acceleration), drift))
    gamma_ddot, psi_ddot = ops.named([-ax / pose.level, az / q])
    omega_dot = ops.named(plus(gyric, [psi_ddot, gamma_ddot * s, gamma_ddot * c]))
    return Motion(omega, omega_dot, plus(sliding, [0, q_ddot, 0]))


def _demand(ops: Ops, m: Tracker, leg: Leg, pose: Pose, motion: Motion) -> tuple[Vector, Scalar]:
    """Moment about the universal joint and force along the leg that its links ask for."""
    up = ops.named(apply(transpose(pose.frame), times(-1, m.gravity)))
    first, second = [0, leg.t, 0], [0, pose.q - leg.s, 0]
    f_t = _link_force(ops, leg.m_t, motion, first, up)
    f_s = _link_force(ops, leg.m_s, motion, second, plus(up, motion.sliding))
    own = [
        _own_moment(ops, inertia, motion.omega, motion.omega_dot) for inertia in (leg.I_t, leg.I_s)
    ]
    return ops.named(plus(*own, cross(first, f_t), cross(second, f_s))), f_s[1]


def _link_force(ops: Ops, mass: Scalar, motion: Motion, arm: Vector, base: Vector) -> Vector:
    """Mass times acceleration of a link's centre, `arm` from a point that has `base`."""
    around = ops.named(cross(motion.omega, arm))
    bent = cross(motion.omega, around)
    return ops.named(times(mass, plus(base, cross(motion.omega_dot, arm), bent)))


def _own_moment(ops: Ops, inertia: Vector, omega: Vector, omega_dot: Vector) -> Vector:
    """Euler's equations in principal axes."""
    tensor = diagonal(inertia)
    momentum = ops.named(apply(tensor, omega))
    return ops.named(plus(apply(tensor, omega_dot), cross(omega, momentum)))


def _named_rows(ops: Ops, m: Matrix) -> Matrix:
    return [ops.named(row) for row in m]
