"""The tracker in pinocchio: told of joints, places and masses; it knows no closed form."""

import numpy as np

from armillary.verify.engines import need

from .closure import DRIVES, PER_LEG


class Tree:
    """The platform on its two turns, and some of the legs: see `closure.Engine`.

    Args:
        p: the parameters of one machine.
        legs: which legs it has.
    """

    def __init__(self, p, legs=(0, 1, 2)):
        self._pin = pin = need("pinocchio")
        self.legs = len(legs)
        self.model = pin.Model()
        self.model.gravity.linear = np.array([0.0, 0.0, -p["g"]])
        top = pin.SE3(np.eye(3), np.array([0.0, 0.0, p["h_0"]]))
        turned = self.model.addJoint(0, pin.JointModelRZ(), top, "alpha")
        self.platform = self.model.addJoint(turned, pin.JointModelRX(), pin.SE3.Identity(), "beta")
        self.model.appendBodyToJoint(self.platform, self._plate(p), pin.SE3.Identity())
        self.sockets, self.tips, self.first, self.second = [], [], [], []
        for k in legs:
            arm = p["r"][k] * np.array([np.cos(p["phi"][k]), np.sin(p["phi"][k]), 0.0])
            self.sockets.append(self._frame(f"socket{k}", self.platform, arm))
            self._leg({name: value[k] for name, value in p.items() if np.ndim(value)}, k)
        self.data = self.model.createData()
        self._world = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED

    def _plate(self, p):
        """The platform; its inertia is given about o, pinocchio wants it about the mass centre."""
        r = p["r_sc"]
        moved = p["m_m"] * (r @ r * np.eye(3) - np.outer(r, r))
        return self._pin.Inertia(p["m_m"], r, np.diag(p["I_m"]) - moved)

    def _leg(self, leg, k):
        pin = self._pin
        foot = np.array(
            [leg["R"] * np.cos(leg["theta"]), leg["R"] * np.sin(leg["theta"]), leg["h"]]
        )
        mounted = pin.SE3(pin.rpy.rpyToMatrix(0.0, leg["zeta"], 0.0), foot)
        still = pin.SE3.Identity()
        outer = self.model.addJoint(0, pin.JointModelRZ(), mounted, f"gamma{k}")
        inner = self.model.addJoint(outer, pin.JointModelRX(), still, f"psi{k}")
        slide = self.model.addJoint(inner, pin.JointModelPY(), still, f"q{k}")
        for joint, mass, centre, inertia, frames in (
            (inner, leg["m_t"], np.array([0.0, leg["t"], 0.0]), leg["I_t"], self.first),
            (slide, leg["m_s"], np.array([0.0, -leg["s"], 0.0]), leg["I_s"], self.second),
        ):
            body = pin.Inertia(mass, centre, np.diag(inertia))
            self.model.appendBodyToJoint(joint, body, still)
            frames.append(self._frame(f"centre{k}_{joint}", joint, centre))
        self.tips.append(self._frame(f"tip{k}", slide, np.zeros(3)))

    def _frame(self, name, joint, place):
        kind = self._pin.FrameType.OP_FRAME
        placed = self._pin.SE3(np.eye(3), place)
        return self.model.addFrame(self._pin.Frame(name, joint, placed, kind))

    # -- closure ----------------------------------------------------------------------------------

    def gap(self, x):
        """See `closure.Engine`."""
        self._pin.framesForwardKinematics(self.model, self.data, x)
        return self._apart(lambda frame: self.data.oMf[frame].translation)

    def slope(self, x):
        """See `closure.Engine`."""
        self._pin.computeJointJacobians(self.model, self.data, x)
        self._pin.updateFramePlacements(self.model, self.data)
        return self._apart(
            lambda frame: self._pin.getFrameJacobian(self.model, self.data, frame, self._world)[:3]
        )

    def drift(self, x, v):
        """See `closure.Engine`."""
        self._pin.forwardKinematics(self.model, self.data, x, v, 0 * v)
        self._pin.updateFramePlacements(self.model, self.data)
        return self._apart(lambda frame: self._classical(frame).linear)

    def _apart(self, of):
        pairs = zip(self.sockets, self.tips, strict=True)
        return np.concatenate([of(socket) - of(tip) for socket, tip in pairs])

    def _classical(self, frame):
        return self._pin.getFrameClassicalAcceleration(self.model, self.data, frame, self._world)

    # -- dynamics ---------------------------------------------------------------------------------

    def inverse(self, x, v, a, f_d, n_d):
        """See `closure.Engine`."""
        self._pin.forwardKinematics(self.model, self.data, x)
        back = self.data.oMi[self.platform].rotation.T
        loads = [self._pin.Force.Zero() for _ in range(self.model.njoints)]
        loads[self.platform] = self._pin.Force(back @ f_d, back @ n_d)
        return self._pin.rnea(self.model, self.data, x, v, a, loads).copy()

    def forward(self, motion, forces, f_d, n_d):
        """Accelerations of alpha and beta under forces of the legs, gaps held by multipliers."""
        x, v = motion.x, motion.v
        upper = np.triu(self._pin.crba(self.model, self.data, x))
        mass = upper + np.triu(upper, 1).T
        push = -self.inverse(x, v, 0 * v, f_d, n_d)
        push[DRIVES + PER_LEG - 1 :: PER_LEG] += forces
        slope = self.slope(x)
        nothing = np.zeros((len(slope), len(slope)))
        whole = np.block([[mass, slope.T], [slope, nothing]])
        return np.linalg.solve(whole, np.concatenate([push, -self.drift(x, v)]))[:DRIVES]

    def mass(self, motion):
        """The mass matrix along alpha and beta."""
        upper = np.triu(self._pin.crba(self.model, self.data, motion.x))
        return motion.ways.T @ (upper + np.triu(upper, 1).T) @ motion.ways

    def energies(self, motion):
        """Kinetic and potential energy, J."""
        kinetic = self._pin.computeKineticEnergy(self.model, self.data, motion.x, motion.v)
        return kinetic, self._pin.computePotentialEnergy(self.model, self.data, motion.x)

    def links(self, motion):
        """omega, omega_dot, v_t, a_t, v_s, a_s of the legs, world axes: (legs, 3) each."""
        pin, model, data = self._pin, self.model, self.data
        pin.forwardKinematics(model, data, motion.x, motion.v, motion.a)
        pin.updateFramePlacements(model, data)

        def speed(frames):
            return [pin.getFrameVelocity(model, data, f, self._world) for f in frames]

        def pull(frames):
            return [self._classical(f) for f in frames]

        first, second = speed(self.first), speed(self.second)
        turning, sliding = pull(self.first), pull(self.second)
        found = (
            [m.angular for m in first], [m.angular for m in turning],
            [m.linear for m in first], [m.linear for m in turning],
            [m.linear for m in second], [m.linear for m in sliding],
        )  # fmt: skip
        return tuple(np.array(part) for part in found)

    def turning(self, motion):
        """The platform's angular velocity, world axes."""
        self._pin.forwardKinematics(self.model, self.data, motion.x, motion.v)
        return self._pin.getVelocity(
            self.model, self.data, self.platform, self._world
        ).angular.copy()
