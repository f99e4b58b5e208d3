"""The typed program that every target prints.

An instruction refers to earlier instructions by number. It has a domain, the indices that its value
depends on (see `domains`): it stands for a value at each point of it, and targets print a loop. A
lowered program still holds vectors and elementary rotations; `scalarise` opens them. Definitions
keep their names and ids as labels.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from functools import wraps
from math import prod
from typing import Any, TypeVar, Union

import sympy

from armillary.algebra.index import Index
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
    # Over the points of an index.
    TABLE = "table"
    SUM = "sum"
    ANY = "any"
    ELEMENT = "element"
    PHI = "phi"
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
CONDITION_OPS = frozenset({Op.LESS, Op.BOTH, Op.NOT, Op.ANY})
# What takes away an index from the domain of its argument.
CLOSING_OPS = frozenset({Op.SUM, Op.ANY, Op.ELEMENT})

Domain = frozenset[Index]
# Evaluated at run time by mypy's reckoning, so not with |: SymPy has no types.
Data = Union[  # noqa: UP007
    sympy.Expr,
    str,
    int,
    Index,
    tuple[str, int],
    tuple[str, Index, int, int],
    tuple[Index, int],
    tuple[Index, str],
    tuple[Index, tuple[sympy.Expr, ...]],
    None,
]


@dataclass(frozen=True)
class Instruction:
    """One operation.

    `data` is, by operation: a CONSTANT's value; an INPUT's name, with a place, or with an index, a
    stride and an offset (the place is index * stride + offset, and flat); an axis or a component; a
    TABLE's index and values; the index of a SUM or ANY; index and place of an ELEMENT; a PHI's
    sequential index and the name of what it carries.
    """

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
    """A kernel's result: entries in row-major order.

    With `indices`, there is a block of entries for each point of them, the first index outermost;
    `shape` is that of the whole.
    """

    name: str
    shape: tuple[int, ...]
    entries: tuple[int, ...]
    indices: tuple[Index, ...] = field(default=(), repr=False)


@dataclass(frozen=True)
class Field:
    """What a set-up hands to a step: a number or, with an index, an array over it."""

    name: str
    index: Index | None
    condition: bool
    identifiers: tuple[str, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        return () if self.index is None else (self.index.size,)


@dataclass(frozen=True)
class Program:
    """Instructions in order, what they return, and under which conditions a status.

    A PHI has the value of its argument in the first turn of its iteration, and afterwards the one
    that the instruction `carried[phi]`, later in the order, had in the turn before. `phi_domains`
    tells what each PHI depends on. `beforehand` names the quantities that a set-up is told: what
    follows from them alone is not counted (see `rates`). A step reads `fields` beside its inputs.
    """

    kernel: Kernel
    instructions: tuple[Instruction, ...]
    results: tuple[Result, ...]
    cases: tuple[tuple[Status, int], ...]
    labels: dict[int, tuple[Label, ...]] = field(default_factory=dict)
    carried: dict[int, int] = field(default_factory=dict)
    phi_domains: dict[int, Domain] = field(default_factory=dict)
    beforehand: frozenset[str] = frozenset()
    fields: tuple[Field, ...] = ()
    _asked: dict[object, object] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

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
                found.add(input_name(instruction))
        return frozenset(found)

    def key(self) -> object:
        """What tells it apart from another program of its kernel."""
        dicts = (self.labels, self.carried, self.phi_domains)
        return self.instructions, self.results, self.cases, *(tuple(d.items()) for d in dicts)

    def digest(self) -> str:
        """A hash of everything a target prints."""
        text = [repr(self.name), repr([(q.name, q.shape) for q in self.kernel.inputs])]
        text += [f"{i.op.value} {i.args} {_written(i.data)}" for i in self.instructions]
        text += [repr(self.results), repr([(int(s), c) for s, c in self.cases])]
        text += [repr(sorted(self.labels.items())), repr(self.guards)]
        if any(domains(self)) or any(r.indices for r in self.results):
            text += [repr(sorted(self.carried.items())), repr([r.indices for r in self.results])]
            text += [repr(sorted(map(_named, domains(self)[phi]))) for phi in self.carried]
        if self.kernel.stage:
            text += [self.kernel.stage, repr(self.fields)]
        if self.kernel.stateful:
            text += [self.kernel.stateful, repr([(q.name, q.shape) for q in self.kernel.states])]
        return hashlib.sha256("\n".join(text).encode()).hexdigest()


def _written(data: Data) -> str:
    if isinstance(data, sympy.Expr):
        return str(sympy.srepr(data))
    if isinstance(data, tuple) and isinstance(data[1], tuple):
        return repr((data[0], [_written(value) for value in data[1]]))
    return repr(data)


def _named(index: Index) -> tuple[str, int]:
    return index.name, index.size


T = TypeVar("T")


def asked_once(question: Callable[[Program], T]) -> Callable[[Program], T]:
    """A function of a program that keeps its answers with the program."""

    @wraps(question)
    def ask(program: Program) -> T:
        known = program._asked
        if question not in known:
            known[question] = question(program)
        return known[question]  # type: ignore[return-value]

    return ask


@asked_once
def domains(program: Program) -> tuple[Domain, ...]:
    """The indices that each instruction's value depends on."""
    found: list[Domain] = []
    for number, instruction in enumerate(program.instructions):
        known = program.phi_domains.get(number)
        found.append(domain_of(instruction, found) if known is None else known)
    return tuple(found)


def domain_of(instruction: Instruction, found: Sequence[Domain]) -> Domain:
    """The domain of an instruction from those of its arguments; of a PHI, a part of it."""
    own: Domain = frozenset().union(*(found[a] for a in instruction.args))
    index = index_of(instruction)
    if index is None:
        return own
    return own - {index} if instruction.op in CLOSING_OPS else own | {index}


def index_of(instruction: Instruction) -> Index | None:
    """The index that an instruction brings into its domain, or takes out of it."""
    data = instruction.data
    if isinstance(data, tuple):
        return next((part for part in data[:2] if isinstance(part, Index)), None)
    return data if isinstance(data, Index) else None


def input_name(instruction: Instruction) -> str:
    """The quantity that an INPUT reads."""
    data = instruction.data
    return str(data[0] if isinstance(data, tuple) else data)


def place_of(data: tuple[Any, ...], point: Mapping[Index, int]) -> int:
    """The flat place that an INPUT of an array reads at a point."""
    if len(data) == 2:
        return int(data[1])
    _, index, stride, offset = data
    return point[index] * int(stride) + int(offset)


def is_vector(instructions: Sequence[Instruction], number: int) -> bool:
    """Whether a value is a vector of three."""
    while instructions[number].op in (Op.SUM, Op.ELEMENT):
        number = instructions[number].args[0]
    return instructions[number].op in VECTOR_OPS


def turns(domain: Domain) -> int:
    """How many points a domain has: how often an instruction of it runs."""
    return prod(index.size for index in domain)


def results_length(result: Result) -> int:
    """How many numbers a result has, over all points of its indices."""
    return len(result.entries) * turns(frozenset(result.indices))
