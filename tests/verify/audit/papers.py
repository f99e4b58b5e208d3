"""A small paper and the system that it is about, for tests of the audit."""

from __future__ import annotations

from armillary import Chain, Derivation, Paper, X, Y, Z
from armillary.derivation.record import Used
from armillary.verify.audit.audit import audit


class Arm:
    """A turntable with a tilting arm: its derivation, and a paper that prints of it."""

    def __init__(self) -> None:
        self.d = d = Derivation("arm", title="Arm")
        self.g, self.u = d.angle("g", "turn"), d.angle("u", "tilt")
        self.g_dot, self.u_dot = self.g.rate(), self.u.rate()
        self.L_1, self.L_2 = d.parameter.length("L_1", "post"), d.parameter.length("L_2", "arm")
        self.theta = d.angle("theta", "lean", range=(-0.3, 0.3))
        self.psi = d.angle("psi", "lean", range=(-0.3, 0.3))
        self.chain = (
            Chain("ground").rotate(Z, self.g).translate(Z, self.L_1).rotate(X, self.u)
            .translate(Y, self.L_2, frame="tip")
        )  # fmt: skip
        self.M = d.define("M", self.chain.pose("ground", "tip"), because="compose")
        self.R = d.define("R", self.chain.rotation("ground", "tip"), because="compose")
        self.w = d.define(
            "w", self.chain.angular_velocity("tip"), because="add", meaning="speed, outside"
        )
        self.w_tip = d.define(
            "w_tip", self.chain.body_angular_velocity("tip"), because="add", meaning="speed, inside"
        )
        self.lean = d.define(
            "lean", Chain("a").rotate(X, self.psi).rotate(Y, self.theta, frame="b")
            .rotation("a", "b"), because="compose",
        )  # fmt: skip
        self.p = Paper("arm_paper")
        self.p.used["arm"] = Used(d)


def only(arm, latex=None):
    """The finding on the one print of the paper."""
    (finding,) = audit(arm.p, latex)
    return finding
