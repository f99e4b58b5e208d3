"""The benchmark kernels, each written once as a text book writes it, and given to every tool.

Text-book means full matrices, multiplied in order, and derivatives left to the tool. No
intermediate result is named for the tool's benefit, so that what is measured is what the tool
finds; K4 is also written as a recursion that names each of its steps.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from benchmarks import tracker, tracker_recursion
from benchmarks.matrices import (
    Matrix,
    Ops,
    Recipe,
    Vector,
    apply,
    column,
    cross,
    dot,
    flat,
    product,
    rotation,
    shift,
    transpose,
    turn,
)


@dataclass(frozen=True)
class Kernel:
    """One benchmark problem: what goes in, what comes out (flat, row-major), how it is written."""

    name: str
    title: str
    definition: str
    inputs: tuple[str, ...]
    outputs: Mapping[str, int]
    recipes: Mapping[str, Recipe]

    @property
    def n_out(self) -> int:
        """Number of scalars that the kernel returns."""
        return sum(self.outputs.values())


# --- K1: two-axis pose --------------------------------------------------------------------------


def two_axis_pose(ops: Ops, v: Vector) -> Vector:
    """Pose of the outer frame, then the geometric Jacobian with its linear rows first."""
    gamma, nu, l0, l1, l2 = v
    inner = product(shift("z", l0), turn(ops, "z", gamma))
    outer = product(inner, shift("y", l1), turn(ops, "x", nu))
    pose = product(outer, shift("z", l2))
    linear = ops.jacobian(column(pose), [gamma, nu])
    angular = transpose([column(inner, "z"), column(outer, "x")])
    return flat(pose) + flat(linear) + flat(angular)


# --- K2: heliostat ------------------------------------------------------------------------------


def heliostat_angles(ops: Ops, v: Vector) -> Vector:
    """Mirror normal in the tilted base frame, its azimuth and elevation, and their Jacobian."""
    hour, dec, lat, bx, by, bz, theta, psi, chi = v
    sun = [
        -ops.cos(dec) * ops.sin(hour),
        ops.sin(dec) * ops.cos(lat) - ops.cos(dec) * ops.cos(hour) * ops.sin(lat),
        ops.sin(dec) * ops.sin(lat) + ops.cos(dec) * ops.cos(hour) * ops.cos(lat),
    ]
    bisector = [b + c for b, c in zip([bx, by, bz], sun, strict=True)]
    norm = ops.sqrt(dot(bisector, bisector))
    normal = [component / norm for component in bisector]
    base = product(rotation(ops, "z", chi), rotation(ops, "y", psi), rotation(ops, "x", theta))
    n = apply(transpose(base), normal)
    azimuth = ops.atan2(n[0], n[1])
    elevation = ops.atan2(n[2], ops.sqrt(n[0] * n[0] + n[1] * n[1]))
    jacobian = ops.jacobian([azimuth, elevation], [theta, psi, chi])
    return [*n, azimuth, elevation, *flat(jacobian)]


# --- K3: RR-3UPS --------------------------------------------------------------------------------


def platform_legs(ops: Ops, v: Vector) -> Vector:
    """Lengths and rates of three legs, their Jacobian, and its derivative by time."""
    alpha, beta, alpha_dot, beta_dot, h0 = v[:5]
    rates = [alpha_dot, beta_dot]
    attitude = product(rotation(ops, "z", alpha), rotation(ops, "x", beta))
    lengths = []
    for leg in range(3):
        a, b = v[5 + 3 * leg : 8 + 3 * leg], v[14 + 3 * leg : 17 + 3 * leg]
        p = apply(attitude, a)
        s = [b[0] - p[0], b[1] - p[1], b[2] - h0 - p[2]]
        lengths.append(ops.sqrt(dot(s, s)))
    jacobian = ops.jacobian(lengths, [alpha, beta])
    speeds = apply(jacobian, rates)
    jacobian_rate = apply(ops.jacobian(flat(jacobian), [alpha, beta]), rates)
    return lengths + speeds + flat(jacobian) + jacobian_rate


# --- A6: six-axis arm ---------------------------------------------------------------------------

ARM_AXES = "zyyxyx"


def _arm_frames(ops: Ops, v: Vector) -> list[Matrix]:
    """The frame each joint turns in (right after its rotation), then the tool frame."""
    d1, a2, a3, d6 = v[6:]
    links = [shift("z", d1), shift("z", a2), shift("x", a3), None, None, shift("x", d6)]
    frames: list[Matrix] = []
    pose: Matrix | None = None
    for axis, angle, link in zip(ARM_AXES, v[:6], links, strict=True):
        joint = turn(ops, axis, angle)
        pose = joint if pose is None else product(pose, joint)
        frames.append(pose)
        if link is not None:
            pose = product(pose, link)
    assert pose is not None
    return [*frames, pose]


def arm_by_differentiation(ops: Ops, v: Vector) -> Vector:
    """Linear rows: the tool's position, differentiated by the joint angles."""
    *joints, tool = _arm_frames(ops, v)
    linear = ops.jacobian(column(tool), v[:6])
    axes = [column(frame, axis) for frame, axis in zip(joints, ARM_AXES, strict=True)]
    return flat(linear) + flat(transpose(axes))


def arm_by_cross_products(ops: Ops, v: Vector) -> Vector:
    """Linear rows: each joint's axis, crossed with the lever arm from the joint to the tool."""
    *joints, tool = _arm_frames(ops, v)
    axes = [column(frame, axis) for frame, axis in zip(joints, ARM_AXES, strict=True)]
    linear = []
    for frame, axis in zip(joints, axes, strict=True):
        arm = [t - o for t, o in zip(column(tool), column(frame), strict=True)]
        linear.append(cross(axis, arm))
    return flat(transpose(linear)) + flat(transpose(axes))


TEXT_BOOK = "text-book"

KERNELS: dict[str, Kernel] = {
    kernel.name: kernel
    for kernel in (
        Kernel(
            name="K1",
            title="two-axis pose and geometric Jacobian",
            definition=(
                "`T = Tz(L0) Rz(gamma) Ty(L1) Rx(nu) Tz(L2)`; all 16 entries of `T`, and the 6x2"
                " geometric Jacobian by (gamma, nu), linear rows first, in the base frame."
            ),
            inputs=("gamma", "nu", "L0", "L1", "L2"),
            outputs={"T": 16, "J": 12},
            recipes={TEXT_BOOK: two_axis_pose},
        ),
        Kernel(
            name="K2",
            title="heliostat angles and Jacobian on a tilted base",
            definition=(
                "Sun direction `c` (east, north, up) from hour angle, declination and latitude;"
                " `n = (b + c)/|b + c|` in the base frame `Rz(chi) Ry(psi) Rx(theta)`; azimuth"
                " `atan2(nx, ny)`, elevation `atan2(nz, hypot(nx, ny))`, and their 2x3 Jacobian"
                " by (theta, psi, chi)."
            ),
            inputs=("hour", "dec", "lat", "bx", "by", "bz", "theta", "psi", "chi"),
            outputs={"n": 3, "azimuth": 1, "elevation": 1, "J": 6},
            recipes={TEXT_BOOK: heliostat_angles},
        ),
        Kernel(
            name="K3",
            title="RR-3UPS leg lengths, rates, Jacobian and its rate",
            definition=(
                "`q_i = |b_i - h0 e_z - Rz(alpha) Rx(beta) a_i|` for three legs; their rates, the"
                " 3x2 Jacobian by (alpha, beta), and the derivative of that Jacobian by time."
            ),
            inputs=(
                *("alpha", "beta", "alpha_dot", "beta_dot", "h0"),
                *(f"{point}{leg}{axis}" for point in "ab" for leg in "012" for axis in "xyz"),
            ),
            outputs={"q": 3, "q_dot": 3, "J": 6, "J_dot": 6},
            recipes={TEXT_BOOK: platform_legs},
        ),
        Kernel(
            name="A6",
            title="geometric Jacobian of a six-axis arm with a spherical wrist",
            definition=(
                "`T = Rz(q1) Tz(d1) Ry(q2) Tz(a2) Ry(q3) Tx(a3) Rx(q4) Ry(q5) Rx(q6) Tx(d6)`; the"
                " 6x6 geometric Jacobian of the tool point (the origin of the last frame) by"
                " q1 to q6, linear rows first, in the base frame. The tool point lies on the last"
                " axis, so q6 drops out and column 6 has no linear part."
            ),
            inputs=("q1", "q2", "q3", "q4", "q5", "q6", "d1", "a2", "a3", "d6"),
            outputs={"J": 36},
            recipes={
                "position differentiated": arm_by_differentiation,
                "axis x lever arm": arm_by_cross_products,
            },
        ),
        Kernel(
            name="K4",
            title="RR-3UPS leg forces",
            definition=(
                "Inverse dynamics of the tracker on three legs: the forces of least norm along the"
                " legs that drive the motion (alpha, beta and their first and second derivatives)"
                " against inertia and weight of the platform and of two bodies a leg, and a"
                " moment on the platform. All dimensions are inputs. `f_d` does no work."
            ),
            inputs=tracker.INPUTS,
            outputs={"F": 3},
            recipes={
                "leg angles, differentiated": tracker.by_leg_angles,
                "leg axes, differentiated": tracker.by_leg_axes,
                "recursion, named steps": tracker_recursion.by_recursion,
            },
        ),
    )
}
