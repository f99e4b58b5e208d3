"""Random serial chains, in the engine's words and, by hand, in pinocchio's."""

from dataclasses import dataclass

from hypothesis import strategies as st

from armillary import Chain, Derivation
from armillary.derivation.units import METRE

NAMES = tuple(f"q{k}" for k in range(1, 7))


@dataclass(frozen=True)
class Joint:
    """A moving step: `turning` or sliding along an axis, by a positive or a negative amount."""

    turning: bool
    axis: int
    sign: int


JOINTS = st.lists(
    st.builds(Joint, st.booleans(), st.integers(0, 2), st.sampled_from([1, -1])),
    min_size=1,
    max_size=6,
)


def chain_of(joints):
    """The chain, its record and its variables; frame `f<k>` is reached by the k-th joint."""
    d = Derivation("chain", title="Random chain")
    chain, variables = Chain("base"), []
    for k, joint in enumerate(joints):
        if joint.turning:
            q = d.angle(NAMES[k], "angle")
            chain = chain.rotate(joint.axis, joint.sign * q, frame=f"f{k}")
        else:
            q = d.scalar(NAMES[k], "distance", unit=METRE, limits=(-1e6, 1e6))
            chain = chain.translate(joint.axis, joint.sign * q, frame=f"f{k}")
        variables.append(q)
    return d, chain, tuple(variables)


def mechanism_of(joints):
    """The same in pinocchio."""
    from armillary.verify.engines.rigid import Mechanism, Prismatic, Revolute

    made = []
    for joint in joints:
        axis = [joint.sign * float(k == joint.axis) for k in range(3)]
        made.append(Revolute(axis) if joint.turning else Prismatic(axis))
    return Mechanism(made)
