"""What is derived of every serial tracker alike: its pose, its velocities and its Jacobian."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

from armillary.algebra.rigid import Matrix, Pose, Twist
from armillary.algebra.vector import Vector
from armillary.derivation.errors import DerivationError, caller
from armillary.derivation.quantity import Quantity
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Block
from armillary.mechanism.chain import Chain

B = TypeVar("B", bound=Block)

_MEANINGS = {
    "M": "pose of the {tip} in East-North-Up axes at {foot}: its rotation beside the position "
    "of its origin in m",
    "Omega_space": "angular velocity of the {tip} in East-North-Up axes",
    "Omega_body": "angular velocity of the {tip} in its own axes",
    "v_origin": "velocity of the {tip}'s origin in East-North-Up axes",
    "v_spatial": "velocity of the {tip}'s point that passes {foot}",
    "V_space": "velocity matrix of the {tip}: skew angular velocity in rad/s beside the velocity "
    "at {foot} in m/s, East-North-Up axes",
    "J": "Jacobian of the {tip} in East-North-Up axes: three rows for the velocity of its origin, "
    "m per unit of drive, over three for its angular velocity; columns {drives}",
}
_REASONS = {
    "M": "The pose of the {tip} is the product of its joints from the {base} up.",
    "Omega_space": "Angular velocities add, each about its axis as the joints before it have "
    "turned it.",
    "Omega_body": "The same sum, each axis carried inward to the {tip} instead of out to the "
    "{base}.",
    "v_origin": "Each joint moves the {tip}'s origin by its axis crossed with the arm from the "
    "axis to that origin.",
    "v_spatial": "Each joint moves {foot}, taken along as a point of the {tip}, by its axis "
    "crossed with the arm from the axis to there.",
    "V_space": "The rate of the pose times its inverse is the skew matrix of the angular velocity "
    "beside the velocity of the point at {foot}.",
    "J": "Column by column, the motion of the {tip} while one drive runs at unit speed.",
}


@dataclass(frozen=True, eq=False)
class Motion:
    """The definitions that `define_motion` makes, under their names."""

    M: Pose
    Omega_space: Vector
    Omega_body: Vector
    v_origin: Vector
    v_spatial: Vector
    V_space: Twist
    J: Matrix


@dataclass(frozen=True)
class _Words:
    """What is said of each definition, for one mechanism."""

    d: Derivation
    words: Mapping[str, str]
    printed: Mapping[str, str]
    because: Mapping[str, str]

    def __post_init__(self) -> None:
        for name in (*self.printed, *self.because):
            if name not in _MEANINGS:
                known = ", ".join(_MEANINGS)
                raise DerivationError(
                    f"define_motion defines no {name}", f"it defines {known}", caller()
                )

    def define(self, name: str, value: B) -> B:
        return self.d.define(
            name,
            value,
            because=self.because.get(name, _REASONS[name].format(**self.words)),
            meaning=_MEANINGS[name].format(**self.words),
            printed=self.printed.get(name),
        )


def define_motion(
    d: Derivation,
    chain: Chain,
    tip: str,
    drives: Sequence[Quantity],
    *,
    foot: str = "",
    printed: Mapping[str, str] | None = None,
    because: Mapping[str, str] | None = None,
) -> Motion:
    """State the pose of a chain's frame and how it moves; make pose, velocity and jacobian.

    The definitions are M, Omega_space, Omega_body, v_origin, v_spatial, V_space and J; `velocity`
    takes the rate of each drive after the drives.

    Args:
        tip: the frame that moves; its name stands in every meaning.
        drives: the angles and distances that are driven, in the order of the kernels' inputs.
        foot: what stands at the origin of the base, such as "the foot of the column".
        printed: numbers of the paper's equations, by the name of the definition.
        because: reasons that say more of this mechanism, by the name of the definition.
    """
    for q in drives:
        q.rate()  # before the first definition that differentiates
    words = {"tip": tip, "base": chain.base, "foot": foot or f"the origin of the {chain.base}"}
    words["drives"] = ", ".join(q.name for q in drives)
    define = _Words(d, words, printed or {}, because or {}).define

    M = define("M", chain.pose(chain.base, tip))
    Omega_space = define("Omega_space", chain.angular_velocity(tip))
    Omega_body = define("Omega_body", chain.body_angular_velocity(tip))
    v_origin = define("v_origin", chain.velocity(tip))
    v_spatial = define("v_spatial", chain.spatial_velocity(tip))
    V_space = define("V_space", Twist(Omega_space, v_spatial))
    J = define("J", chain.jacobian(tip, tuple(drives)))

    motion = Motion(M, Omega_space, Omega_body, v_origin, v_spatial, V_space, J)
    _ask_for_kernels(d, tip, drives, motion)
    return motion


def _ask_for_kernels(d: Derivation, tip: str, drives: Sequence[Quantity], motion: Motion) -> None:
    one = len(drives) == 1
    running = f"Motion of the {tip} while the {'drive runs' if one else 'drives run'}."
    per_speed = f"Motion of the {tip} per unit speed of {'the' if one else 'each'} drive."
    moving: list[Block] = [
        motion.Omega_space,
        motion.Omega_body,
        motion.v_origin,
        motion.v_spatial,
        motion.V_space,
    ]
    rates = [q.rate() for q in drives]
    d.kernel("pose", inputs=drives, outputs=[motion.M], summary=f"Pose of the {tip}.")
    d.kernel("velocity", inputs=[*drives, *rates], outputs=moving, summary=running)
    d.kernel("jacobian", inputs=drives, outputs=[motion.J], summary=per_speed)
