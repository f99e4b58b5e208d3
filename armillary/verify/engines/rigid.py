"""Serial mechanisms in pinocchio, from a plain list of joints.

A simulation writes its mechanism down here by hand, in the order from the base to the tip, and so
shares no expression with the derivation it checks.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from armillary.verify.engines import need

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Fixed:
    """A placement that does not move: a translation (m), then a turn by roll, pitch and yaw.

    The turn is Rz(yaw) Ry(pitch) Rx(roll), in radians.
    """

    xyz: Sequence[float] = (0.0, 0.0, 0.0)
    rpy: Sequence[float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Revolute:
    """A joint that turns about an axis of the frame reached so far, right-handed, in radians."""

    axis: Sequence[float]


@dataclass(frozen=True)
class Prismatic:
    """A joint that slides along an axis of the frame reached so far, in metres."""

    axis: Sequence[float]


Joint = Fixed | Revolute | Prismatic


class Mechanism:
    """A serial mechanism; joint positions q are taken in the order of the moving joints.

    Every answer is about the tip: the frame behind the last joint of the list, in the base frame.
    """

    def __init__(self, joints: Sequence[Joint]) -> None:
        pin: Any = need("pinocchio")
        self._pin = pin
        self.model = pin.Model()
        self.data: Any = None
        parent, placement = 0, pin.SE3.Identity()
        for k, joint in enumerate(joints):
            if isinstance(joint, Fixed):
                turn = pin.rpy.rpyToMatrix(np.asarray(joint.rpy, dtype=float))
                placement = placement * pin.SE3(turn, np.asarray(joint.xyz, dtype=float))
                continue
            axis = np.asarray(joint.axis, dtype=float)
            axis = axis / np.linalg.norm(axis)
            made = pin.JointModelRevoluteUnaligned if isinstance(joint, Revolute) else (
                pin.JointModelPrismaticUnaligned
            )  # fmt: skip
            parent = self.model.addJoint(parent, made(axis), placement, f"joint_{k}")
            placement = pin.SE3.Identity()
        frame = pin.Frame("tip", parent, placement, pin.FrameType.OP_FRAME)
        self.tip = self.model.addFrame(frame)
        self.data = self.model.createData()

    def pose(self, q: ArrayLike) -> Array:
        """Pose of the tip in the base, 4 by 4 (n, 4, 4 for q of shape (n, k))."""
        return self._each(self._pose, q)

    def jacobian(self, q: ArrayLike) -> Array:
        """6 by k: velocity of the tip's origin over angular velocity, in the base frame."""
        return self._each(self._jacobian, q)

    def velocity(self, q: ArrayLike, q_dot: ArrayLike) -> Array:
        """Velocity of the tip's origin (m/s), then angular velocity (rad/s), in the base frame."""
        return self._each(self._velocity, q, q_dot)

    def body_velocity(self, q: ArrayLike, q_dot: ArrayLike) -> Array:
        """The same motion in the tip's own components."""
        return self._each(self._body_velocity, q, q_dot)

    def _each(self, function: Any, *arguments: ArrayLike) -> Array:
        arrays = [np.asarray(a, dtype=float) for a in arguments]
        if arrays[0].ndim == 1:
            return np.asarray(function(*arrays))
        return np.stack([function(*row) for row in zip(*arrays, strict=True)])

    def _pose(self, q: Array) -> Array:
        self._pin.framesForwardKinematics(self.model, self.data, q)
        return np.array(self.data.oMf[self.tip].homogeneous)

    def _jacobian(self, q: Array) -> Array:
        aligned = self._pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        found = self._pin.computeFrameJacobian(self.model, self.data, q, self.tip, aligned)
        return np.array(found).reshape(6, -1)  # a single column arrives flat

    def _velocity(self, q: Array, q_dot: Array) -> Array:
        return self._motion(q, q_dot, self._pin.ReferenceFrame.LOCAL_WORLD_ALIGNED)

    def _body_velocity(self, q: Array, q_dot: Array) -> Array:
        return self._motion(q, q_dot, self._pin.ReferenceFrame.LOCAL)

    def _motion(self, q: Array, q_dot: Array, frame: Any) -> Array:
        self._pin.forwardKinematics(self.model, self.data, q, q_dot)
        motion = self._pin.getFrameVelocity(self.model, self.data, self.tip, frame)
        return np.concatenate([motion.linear, motion.angular])
