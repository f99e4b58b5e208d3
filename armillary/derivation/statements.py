"""What a derivation states: definitions, identities, kernels."""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.index import Index
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation
from armillary.derivation.errors import Source
from armillary.derivation.names import is_macro
from armillary.derivation.quantity import AnyQuantity, Quantity
from armillary.derivation.status import Status
from armillary.derivation.units import Unit
from armillary.mechanism.chain import Chain
from armillary.mechanism.scene import Scene

Block = Pose | Twist | Wrench | Matrix | Rotation | s.Scalar | v.Vector | s.Condition


@dataclass(frozen=True, eq=False)
class Definition:
    """`name := expression`, with the reason for the step.

    `value` is what later lines use (it carries the name); `expression` is what was written. It is
    stated for each part of its `indices`.
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
    indices: tuple[Index, ...] = ()


@dataclass(frozen=True, eq=False)
class Identity:
    """Two expressions that must be equal for reasons the definitions do not share."""

    claim: str
    left: Block
    right: Block
    source: Source


@dataclass(frozen=True, eq=False)
class Output:
    """A named result of a kernel, for each part of its `indices`, the first one outermost."""

    name: str
    value: s.Scalar | v.Vector | Rotation | Matrix
    definition: Definition | None
    unit: Unit | None
    indices: tuple[Index, ...] = ()

    @property
    def shape(self) -> tuple[int, ...]:
        """The whole shape; a matrix of one row is flat, and such a row for each part a matrix."""
        own = self._own_shape
        if len(own) == 2 and own[0] == 1:
            own = own[1:]
        return (*(i.size for i in self.indices), *own)

    @property
    def _own_shape(self) -> tuple[int, ...]:
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
class Drawn:
    """What an input is at the points of checks: an expression, or up to `by` off it."""

    quantity: AnyQuantity
    output: Output
    by: float


@dataclass(frozen=True, eq=False)
class Kernel:
    """A function that every target prints.

    Attributes:
        drawn: the inputs that are not drawn from their ranges for the checks.
        states: of an update, the inputs that are kept from call to call; the results that follow
            the others have their names. Of an init, what its results are.
        stateful: "init" or "update" of a controller.
        controller: the name that the two share.
        stage: "setup" or "step" of a kernel that was divided; no derivation states one.
        whole: the name of that kernel.
    """

    system: str
    name: str
    summary: str
    inputs: tuple[AnyQuantity, ...]
    parameters: tuple[AnyQuantity, ...]
    outputs: tuple[Output, ...]
    cases: tuple[Case, ...]
    source: Source
    states: tuple[Quantity, ...] = ()
    stateful: str = ""
    controller: str = ""
    drawn: tuple[Drawn, ...] = ()
    stage: str = ""
    whole: str = ""

    def result_argument(self, name: str) -> str:
        """A result's name in C: `v_out` if an input, or a macro, is named `v`."""
        taken = set(self.argument_names())
        if name in taken or is_macro(name):
            taken |= {o.name for o in self.outputs}
        while name in taken or is_macro(name):
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
    """A chain or a scene to be drawn, posed at the values given.

    Attributes:
        at: value of each symbol by name; other angles are drawn at 0.5 rad, other lengths at 1 m.
        sun: axis of the last frame that is drawn pointing to the sun; None draws no sun.
    """

    shown: Chain | Scene
    at: dict[str, float]
    sun: int | None
    caption: str
    source: Source

    @property
    def chain(self) -> Chain:
        """What is shown, where it is a chain."""
        assert isinstance(self.shown, Chain)
        return self.shown
