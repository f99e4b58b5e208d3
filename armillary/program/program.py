"""The typed straight-line program that every target prints.

An instruction refers to earlier instructions by number. A lowered program still holds vectors and
elementary rotations; `scalarise` opens them. Definitions keep their names and ids as labels.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from enum import Enum
from typing import Union

import sympy

from armillary.derivation.statements import Kernel
from armillary.derivation.status import Status
from armillary.program.guards import Guard, guards_of


class Op(Enum):
    """Operations of a program."""

    CONSTANT = "constant"
    INPUT = "input"
    NEGATE = "negate"
    ADD = "add"
    MULTIPLY = "multiply"
    DIVIDE = "divide"
    SQRT = "sqrt"
    SIN = "sin"
    COS = "cos"
    ATAN2 = "atan2"
    ABSOLUTE = "absolute"
    LESS = "less"
    BOTH = "both"
    NOT = "not"
    SELECT = "select"
    # Vectors and rotations, opened by `scalarise`.
    PACK = "pack"
    PICK = "pick"
    ADD_VECTORS = "add_vectors"
    NEGATE_VECTOR = "negate_vector"
    SCALE = "scale"
    ROTATE = "rotate"
    CROSS = "cross"
    DOT = "dot"


VECTOR_OPS = frozenset({Op.PACK, Op.ADD_VECTORS, Op.NEGATE_VECTOR, Op.SCALE, Op.ROTATE, Op.CROSS})
STRUCTURED_OPS = VECTOR_OPS | {Op.PICK, Op.DOT}
CONDITION_OPS = frozenset({Op.LESS, Op.BOTH, Op.NOT})

# Evaluated at run time by mypy's reckoning, so not with |: SymPy has no types.
Data = Union[sympy.Expr, str, int, tuple[str, int], None]  # noqa: UP007


@dataclass(frozen=True)
class Instruction:
    """One operation; `data` is a constant, an input's name and index, an axis or a component."""

    op: Op
    args: tuple[int, ...] = ()
    data: Data = None


@dataclass(frozen=True)
class Label:
    """The definition a value came from: its names (one, or one a component) and its id."""

    names: tuple[str, ...]
    identifier: str


@dataclass(frozen=True)
class Result:
    """A kernel's result: entries in row-major order."""

    name: str
    shape: tuple[int, ...]
    entries: tuple[int, ...]


@dataclass(frozen=True)
class Program:
    """Instructions in order, what they return, and under which conditions a status."""

    kernel: Kernel
    instructions: tuple[Instruction, ...]
    results: tuple[Result, ...]
    cases: tuple[tuple[Status, int], ...]
    labels: dict[int, tuple[Label, ...]] = field(default_factory=dict)

    @property
    def name(self) -> str:
        return f"{self.kernel.system}_{self.kernel.name}"

    @property
    def guards(self) -> tuple[Guard, ...]:
        """What is checked: every argument, and each parameter that a result depends on."""
        used = self.inputs_used()
        checked = [*self.kernel.inputs, *(q for q in self.kernel.parameters if q.name in used)]
        return tuple(g for q in checked for g in guards_of(q))

    def inputs_used(self) -> frozenset[str]:
        """Names of the quantities that some result depends on."""
        found = set()
        for instruction in self.instructions:
            if instruction.op is Op.INPUT:
                data = instruction.data
                found.add(data[0] if isinstance(data, tuple) else str(data))
        return frozenset(found)

    def digest(self) -> str:
        """A hash of everything a target prints."""
        text = [repr(self.name), repr([(q.name, q.shape) for q in self.kernel.inputs])]
        text += [f"{i.op.value} {i.args} {_written(i.data)}" for i in self.instructions]
        text += [repr(self.results), repr([(int(s), c) for s, c in self.cases])]
        text += [repr(sorted(self.labels.items())), repr(self.guards)]
        return hashlib.sha256("\n".join(text).encode()).hexdigest()


def _written(data: Data) -> str:
    return str(sympy.srepr(data)) if isinstance(data, sympy.Expr) else repr(data)
