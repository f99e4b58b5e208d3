"""What a derivation states: definitions, identities, kernels."""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation
from armillary.derivation.errors import Source
from armillary.derivation.quantity import AnyQuantity
from armillary.derivation.status import Status
from armillary.derivation.units import Unit
from armillary.mechanism.chain import Chain

Block = Pose | Twist | Wrench | Matrix | Rotation | s.Scalar | v.Vector | s.Condition


@dataclass(frozen=True, eq=False)
class Definition:
    """`name := expression`, with the reason for the step.

    `value` is what later lines use (it carries the name); `expression` is what was written.
    """

    name: str
    identifier: str
    expression: Block
    value: Block
    because: str
    meaning: str
    printed: str | None
    unit: Unit | None
    latex: str
    source: Source


@dataclass(frozen=True, eq=False)
class Identity:
    """Two expressions that must be equal for reasons the definitions do not share."""

    claim: str
    left: Block
    right: Block
    source: Source


@dataclass(frozen=True, eq=False)
class Output:
    """A named result of a kernel."""

    name: str
    value: s.Scalar | v.Vector | Rotation | Matrix
    definition: Definition | None
    unit: Unit | None

    @property
    def shape(self) -> tuple[int, ...]:
        if isinstance(self.value, Matrix):
            return self.value.shape
        if isinstance(self.value, Rotation):
            return (3, 3)
        return (3,) if isinstance(self.value, v.Vector) else ()


@dataclass(frozen=True, eq=False)
class Case:
    """A condition under which a kernel answers with a status of its own."""

    status: Status
    condition: s.Condition
    because: str


@dataclass(frozen=True, eq=False)
class Kernel:
    """A function that every target prints."""

    system: str
    name: str
    summary: str
    inputs: tuple[AnyQuantity, ...]
    parameters: tuple[AnyQuantity, ...]
    outputs: tuple[Output, ...]
    cases: tuple[Case, ...]
    source: Source

    def result_argument(self, name: str) -> str:
        """A result's name where results stand beside inputs: `v_out` if an input is named `v`."""
        taken = set(self.argument_names())
        if name in taken:
            taken |= {o.name for o in self.outputs}
        while name in taken:
            name += "_out"
        return name

    def argument_names(self) -> list[str]:
        """The names that inputs and parameters take in printed code, arrays by part too."""
        return [
            name
            for q in (*self.inputs, *self.parameters)
            for name in (q.name, *(q.parts if q.shape else ()))
        ]


@dataclass(frozen=True, eq=False)
class Picture:
    """A chain to be drawn, posed at the values given.

    Attributes:
        at: value of each symbol by name; other angles are drawn at 0.5 rad, other lengths at 1 m.
        sun: axis of the last frame that is drawn pointing to the sun; None draws no sun.
    """

    chain: Chain
    at: dict[str, float]
    sun: int | None
    caption: str
    source: Source
