"""The tracker in MuJoCo: hinges and slides; inverse dynamics of the open tree."""

import numpy as np

from armillary.verify.engines import need


class Tree:
    """The platform on its two hinges, and some of the legs: see `closure.Engine`.

    Args:
        p: the parameters of one machine; its bodies must be such as matter permits.
        legs: which legs it has.
    """

    def __init__(self, p, legs=(0, 1, 2)):
        self._mujoco = mujoco = need("mujoco")
        self.legs = len(legs)
        spec = mujoco.MjSpec()
        spec.option.gravity = (0.0, 0.0, -p["g"])
        spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
        plate = spec.worldbody.add_body(name="platform", pos=(0.0, 0.0, p["h_0"]))
        self._turn(plate, "alpha", (0, 0, 1))
        self._turn(plate, "beta", (1, 0, 0))
        self._weigh_plate(plate, p)
        for k in legs:
            arm = p["r"][k] * np.array([np.cos(p["phi"][k]), np.sin(p["phi"][k]), 0.0])
            plate.add_site(name=f"socket{k}", pos=arm)
            self._leg(spec, {name: v[k] for name, v in p.items() if np.ndim(v)}, k)
        self.model = spec.compile()
        self.data = mujoco.MjData(self.model)
        self.platform = self.model.body("platform").id
        self.sockets = [self.model.site(f"socket{k}").id for k in legs]
        self.tips = [self.model.site(f"tip{k}").id for k in legs]

    def _turn(self, body, name, axis):
        body.add_joint(name=name, type=self._mujoco.mjtJoint.mjJNT_HINGE, axis=axis)

    def _weigh_plate(self, plate, p):
        """Its inertia is given about o, MuJoCo wants it about the mass centre."""
        r = p["r_sc"]
        full = np.diag(p["I_m"]) - p["m_m"] * (r @ r * np.eye(3) - np.outer(r, r))
        plate.explicitinertial, plate.mass, plate.ipos = True, p["m_m"], r
        plate.fullinertia = full[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]

    def _leg(self, spec, leg, k):
        half = leg["zeta"] / 2
        foot = (leg["R"] * np.cos(leg["theta"]), leg["R"] * np.sin(leg["theta"]), leg["h"])
        first = spec.worldbody.add_body(
            name=f"first{k}", pos=foot, quat=(np.cos(half), 0.0, np.sin(half), 0.0)
        )
        self._turn(first, f"gamma{k}", (0, 0, 1))
        self._turn(first, f"psi{k}", (1, 0, 0))
        second = first.add_body(name=f"second{k}")
        slide = self._mujoco.mjtJoint.mjJNT_SLIDE
        second.add_joint(name=f"q{k}", type=slide, axis=(0, 1, 0))
        second.add_site(name=f"tip{k}")
        for body, mass, centre, inertia in (
            (first, leg["m_t"], leg["t"], leg["I_t"]),
            (second, leg["m_s"], -leg["s"], leg["I_s"]),
        ):
            body.explicitinertial, body.mass = True, mass
            body.ipos, body.inertia = (0.0, centre, 0.0), inertia

    # -- closure ----------------------------------------------------------------------------------

    def gap(self, x):
        """See `closure.Engine`."""
        self._place(x)
        return (self.data.site_xpos[self.sockets] - self.data.site_xpos[self.tips]).ravel()

    def slope(self, x):
        """See `closure.Engine`."""
        self._place(x)
        return self._apart(self._mujoco.mj_jacSite)

    def drift(self, x, v):
        """See `closure.Engine`."""
        self._place(x)
        self.data.qvel[:] = v
        self._mujoco.mj_comVel(self.model, self.data)

        def change(model, data, linear, angular, site):
            body = model.site_bodyid[site]
            self._mujoco.mj_jacDot(model, data, linear, angular, data.site_xpos[site], body)

        return self._apart(change) @ v

    def _place(self, x):
        self.data.qpos[:] = x
        self._mujoco.mj_kinematics(self.model, self.data)
        self._mujoco.mj_comPos(self.model, self.data)

    def _apart(self, of):
        """Of sockets less of tips: matrices (3, coordinates), one below the other."""

        def found(site):
            linear = np.zeros((3, self.model.nv))
            of(self.model, self.data, linear, np.zeros((3, self.model.nv)), site)
            return linear

        pairs = zip(self.sockets, self.tips, strict=True)
        return np.concatenate([found(socket) - found(tip) for socket, tip in pairs])

    # -- dynamics ---------------------------------------------------------------------------------

    def inverse(self, x, v, a, f_d, n_d):
        """See `closure.Engine`."""
        data, mujoco = self.data, self._mujoco
        data.qpos[:], data.qvel[:], data.qacc[:] = x, v, a
        mujoco.mj_inverse(self.model, data)
        pushed = np.zeros(self.model.nv)
        at = data.xpos[self.platform]
        mujoco.mj_applyFT(self.model, data, f_d, n_d, at, self.platform, pushed)
        return data.qfrc_inverse - pushed
