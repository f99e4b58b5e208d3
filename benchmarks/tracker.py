"""K4: the leg forces of a tracker on three legs, as text books derive them.

The platform `Rz(alpha) Rx(beta)` stands at the height `h_0`; leg i runs from `b_i` on the ground,
where a universal joint turns it about the first axis `Ry(zeta) z`, to `P_i` under the platform.
Each leg is two bodies, at `t` from its lower and `s` from its upper end.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from benchmarks.matrices import (
    Matrix,
    Ops,
    Scalar,
    Vector,
    apply,
    column,
    cross,
    diagonal,
    dot,
    flat,
    minus,
    plus,
    product,
    rotation,
    times,
    transpose,
)

_PER_LEG = ("r", "phi", "R", "theta", "h", "zeta", "t", "s", "m_t", "m_s")
SIZES = {
    **dict.fromkeys(_PER_LEG, 3),
    "I_t": 9,
    "I_s": 9,
    "I_m": 3,
    "h_0": 1,
    "m_m": 1,
    "r_sc": 3,
    "g": 1,
    **dict.fromkeys(("alpha", "beta", "alpha_dot", "beta_dot", "alpha_ddot", "beta_ddot"), 1),
    "f_d": 3,
    "n_d": 3,
}
INPUTS = tuple(
    name if size == 1 else f"{name}{i}" for name, size in SIZES.items() for i in range(size)
)


@dataclass(frozen=True)
class Leg:
    """One leg's parameters."""

    r: Scalar
    phi: Scalar
    R: Scalar
    theta: Scalar
    h: Scalar
    zeta: Scalar
    t: Scalar
    s: Scalar
    m_t: Scalar
    m_s: Scalar
    I_t: Vector
    I_s: Vector

    def joint(self, ops: Ops) -> Vector:
        """Spherical joint in the platform's axes."""
        return [self.r * ops.cos(self.phi), self.r * ops.sin(self.phi), 0]

    def foot(self, ops: Ops) -> Vector:
        """Universal joint in the ground's axes."""
        return [self.R * ops.cos(self.theta), self.R * ops.sin(self.theta), self.h]


@dataclass(frozen=True)
class Tracker:
    """What goes into the kernel, sorted."""

    legs: list[Leg]
    I_m: Vector
    h_0: Scalar
    m_m: Scalar
    r_sc: Vector
    gravity: Vector
    x: Vector
    x_dot: Vector
    x_ddot: Vector
    n_d: Vector


def sorted_out(v: Vector) -> Tracker:
    """The inputs in the order of `SIZES`, by name."""
    given, position = {}, 0
    for name, size in SIZES.items():
        given[name] = v[position : position + size]
        position += size
    legs = [
        Leg(
            *(given[name][i] for name in _PER_LEG),
            given["I_t"][3 * i : 3 * i + 3],
            given["I_s"][3 * i : 3 * i + 3],
        )
        for i in range(3)
    ]
    states = [[*given["alpha" + order], *given["beta" + order]] for order in ("", "_dot", "_ddot")]
    gravity = [0, 0, -given["g"][0]]
    (h_0,), (m_m,) = given["h_0"], given["m_m"]
    return Tracker(legs, given["I_m"], h_0, m_m, given["r_sc"], gravity, *states, given["n_d"])


def least_norm(jacobian: Matrix, tau: Vector) -> Vector:
    """The shortest F with J^T F = tau, by the normal equations: J (J^T J)^-1 tau."""
    (a, b), (c, d) = product(transpose(jacobian), jacobian)
    determinant = a * d - b * c
    solved = [
        (d * tau[0] - b * tau[1]) / determinant,
        (a * tau[1] - c * tau[0]) / determinant,
    ]
    return apply(jacobian, solved)


# --- positions, differentiated --------------------------------------------------------------------


def by_leg_angles(ops: Ops, v: Vector) -> Vector:
    """Leg frames by the two angles of the universal joint, as the paper has them."""
    return _by_virtual_work(ops, sorted_out(v), _frame_by_angles)


def by_leg_axes(ops: Ops, v: Vector) -> Vector:
    """Leg frames by cross products, and angular velocities from their matrices."""
    return _by_virtual_work(ops, sorted_out(v), _frame_by_axes)


FrameOf = Callable[[Ops, Leg, Vector, Vector], tuple[Matrix, Matrix]]


def _frame_by_angles(ops: Ops, leg: Leg, w: Vector, x: Vector) -> tuple[Matrix, Matrix]:
    """Rotation `Ry(zeta) Rz(gamma) Rx(psi)` of a leg and its Jacobian."""
    mount = rotation(ops, "y", leg.zeta)
    seen = apply(transpose(mount), w)
    gamma = ops.atan2(-seen[0], seen[1])
    psi = ops.atan2(seen[2], ops.sqrt(seen[0] * seen[0] + seen[1] * seen[1]))
    frame = product(mount, rotation(ops, "z", gamma), rotation(ops, "x", psi))
    axes = transpose([column(mount, "z"), column(frame, "x")])
    return frame, product(axes, ops.jacobian([gamma, psi], x))


def _frame_by_axes(ops: Ops, leg: Leg, w: Vector, x: Vector) -> tuple[Matrix, Matrix]:
    """Axes x (the joint's second), w and their normal; the Jacobian from those of the entries."""
    beside = cross(w, column(rotation(ops, "y", leg.zeta), "z"))
    second = times(1 / ops.sqrt(dot(beside, beside)), beside)
    frame = transpose([second, w, cross(second, w)])
    return frame, _turning(ops, frame, x)


def _turning(ops: Ops, frame: Matrix, x: Vector) -> Matrix:
    """Angular velocities `vee(R_x R^T)` of a rotation for each of the coordinates, as columns."""
    changes = ops.jacobian(flat(frame), x)
    columns = []
    for k in range(len(x)):
        change = [[changes[3 * i + j][k] for j in range(3)] for i in range(3)]
        spin = product(change, transpose(frame))
        columns.append([spin[2][1], spin[0][2], spin[1][0]])
    return transpose(columns)


def _by_virtual_work(ops: Ops, m: Tracker, frame_of: FrameOf) -> Vector:
    """Newton's and Euler's laws of every body, projected by the bodies' Jacobians."""
    platform = product(rotation(ops, "z", m.x[0]), rotation(ops, "x", m.x[1]))
    weight = cross(apply(platform, m.r_sc), times(m.m_m, m.gravity))
    own = _turning(ops, platform, m.x)
    moment = minus(minus(_euler(ops, m, platform, own, m.I_m), weight), m.n_d)
    parts = [apply(transpose(own), moment)]
    lengths = []
    for leg in m.legs:
        foot = leg.foot(ops)
        top = plus([0, 0, m.h_0], apply(platform, leg.joint(ops)))
        along = minus(top, foot)
        q = ops.sqrt(dot(along, along))
        w = [entry / q for entry in along]
        frame, turning = frame_of(ops, leg, w, m.x)
        centres = (plus(foot, times(leg.t, w)), minus(top, times(leg.s, w)))
        for mass, inertia, centre in zip(
            (leg.m_t, leg.m_s), (leg.I_t, leg.I_s), centres, strict=True
        ):
            moving = ops.jacobian(centre, m.x)
            _, acceleration = _motion(ops, m, moving)
            force = times(mass, minus(acceleration, m.gravity))
            parts.append(apply(transpose(moving), force))
            moment = _euler(ops, m, frame, turning, inertia)
            parts.append(apply(transpose(turning), moment))
        lengths.append(q)
    return least_norm(ops.jacobian(lengths, m.x), plus(*parts))


def _motion(ops: Ops, m: Tracker, jacobian: Matrix) -> tuple[Vector, Vector]:
    """Velocity `J x_dot` and acceleration `J x_ddot + (J x_dot)_x x_dot`."""
    velocity = apply(jacobian, m.x_dot)
    drift = apply(ops.jacobian(velocity, m.x), m.x_dot)
    return velocity, plus(apply(jacobian, m.x_ddot), drift)


def _euler(ops: Ops, m: Tracker, frame: Matrix, turning: Matrix, inertia: Vector) -> Vector:
    """Moment that a body's rotation takes, in the ground's axes."""
    omega, omega_dot = _motion(ops, m, turning)
    tensor = product(frame, diagonal(inertia), transpose(frame))
    return plus(apply(tensor, omega_dot), cross(omega, apply(tensor, omega)))
