"""Turns a program into named statements: what every language has in common.

A language is a subclass of `Language` with one short method for each operation. Values used once
are written where they are used, everything else becomes a local under its definition's name.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass

import sympy

from armillary.program.program import CONDITION_OPS, Op, Program
from armillary.program.rewrite import uses

# Longer expressions are hard to compare with the page, so they get a name on the way.
LARGEST_EXPRESSION = 6
# Costly operations keep a line of their own.
_OWN_LINE = frozenset({Op.SIN, Op.COS, Op.SQRT, Op.ATAN2, Op.DIVIDE, Op.SELECT})


FUNCTIONS = {Op.SQRT: "sqrt", Op.SIN: "sin", Op.COS: "cos", Op.ATAN2: "atan2", Op.ABSOLUTE: "abs"}


class Language(ABC):
    """How one language writes the operations; each operand comes ready to be used inside.

    The signs of arithmetic are those of every language met so far; the rest differs.
    """

    @abstractmethod
    def constant(self, value: sympy.Expr) -> str:
        """A literal."""

    @abstractmethod
    def call(self, function: str, *arguments: str) -> str:
        """A call of `sqrt`, `sin`, `cos`, `atan2` (y first) or `abs`."""

    @abstractmethod
    def both(self, a: str, b: str) -> str:
        """Whether two conditions hold."""

    @abstractmethod
    def invert(self, a: str) -> str:
        """Whether a condition does not hold."""

    @abstractmethod
    def select(self, condition: str, then: str, otherwise: str) -> str:
        """One of two values."""

    def negate(self, a: str) -> str:
        """The other sign."""
        return f"-{a}"

    def add(self, a: str, b: str) -> str:
        """A sum."""
        return f"{a} + {b}"

    def subtract(self, a: str, b: str) -> str:
        """A difference."""
        return f"{a} - {b}"

    def multiply(self, a: str, b: str) -> str:
        """A product."""
        return f"{a} * {b}"

    def divide(self, a: str, b: str) -> str:
        """A quotient."""
        return f"{a} / {b}"

    def less(self, a: str, b: str) -> str:
        """Whether a is below b."""
        return f"{a} < {b}"

    def inside(self, expression: str) -> str:
        """An expression as an operand of another."""
        return f"({expression})"


@dataclass(frozen=True)
class Statement:
    """`name = expression`, with the definitions that the value belongs to."""

    name: str
    expression: str
    condition: bool
    identifiers: tuple[str, ...]


@dataclass(frozen=True)
class Body:
    """Statements in order, and the expression of each result entry and case."""

    statements: tuple[Statement, ...]
    results: tuple[tuple[str, ...], ...]
    cases: tuple[tuple[int, str], ...]


def write_body(program: Program, language: Language, taken: frozenset[str]) -> Body:
    """The body of a kernel; locals avoid the names in `taken`."""
    return _Writer(program, language, taken).write()


class _Writer:
    def __init__(self, program: Program, language: Language, taken: frozenset[str]) -> None:
        self.program, self.language = program, language
        kernel = program.kernel
        self.parts = {q.name: q.parts for q in (*kernel.inputs, *kernel.parameters)}
        self.taken = set(taken)
        self.temporaries = 0
        self.uses = appearances(program)
        self.written: list[tuple[str, bool]] = []  # the text, and whether it stands alone
        self.sizes: list[int] = []

    def write(self) -> Body:
        statements = []
        for number, instruction in enumerate(self.program.instructions):
            text, alone = self._expression(number)
            size = 1 + sum(self.sizes[a] for a in instruction.args)
            if self._is_local(number, size):
                name = self._name(number)
                ids = tuple(label.identifier for label in self.program.labels.get(number, ()))
                condition = instruction.op in CONDITION_OPS
                statements.append(Statement(name, text, condition, ids))
                text, alone, size = name, True, 0
            self.written.append((text, alone))
            self.sizes.append(0 if instruction.op in (Op.CONSTANT, Op.INPUT) else size)
        results = tuple(
            tuple(self.written[e][0] for e in result.entries) for result in self.program.results
        )
        cases = tuple((int(status), self.written[c][0]) for status, c in self.program.cases)
        return Body(tuple(statements), results, cases)

    def _is_local(self, number: int, size: int) -> bool:
        op = self.program.instructions[number].op
        if op in (Op.CONSTANT, Op.INPUT):
            return False
        if op is Op.NEGATE:
            # A sign is written where it is used; a name for it would hide the value behind.
            return False
        named = number in self.program.labels
        many = self.uses[number] > 1
        return named or many or op in _OWN_LINE or op in CONDITION_OPS or size > LARGEST_EXPRESSION

    def _name(self, number: int) -> str:
        """The definition's name, that of the angle it is the sine of, or t1, t2, ..."""
        i, label = self.program.instructions[number], self.program.labels.get(number)
        if label:
            wanted = label[0].names[0]
        elif i.op in (Op.SIN, Op.COS) and _plain(self.program, i.args[0]):
            wanted = f"{i.op.value}_{self.program.instructions[i.args[0]].data}"
        else:
            self.temporaries += 1
            wanted = f"t{self.temporaries}"
        name = unused(wanted, self.taken)
        self.taken.add(name)
        return name

    def _operand(self, number: int) -> str:
        text, alone = self.written[number]
        return text if alone else self.language.inside(text)

    def _expression(self, number: int) -> tuple[str, bool]:
        i = self.program.instructions[number]
        if i.op is Op.INPUT:
            data = i.data
            name = self.parts[data[0]][data[1]] if isinstance(data, tuple) else str(data)
            return name, True
        if i.op is Op.CONSTANT:
            assert isinstance(i.data, sympy.Expr)
            return self.language.constant(i.data), True
        if i.op is Op.ADD:
            return self._sum(*i.args), False
        methods: dict[Op, Callable[..., str]] = {
            Op.NEGATE: self.language.negate,
            Op.MULTIPLY: self.language.multiply,
            Op.DIVIDE: self.language.divide,
            Op.LESS: self.language.less,
            Op.BOTH: self.language.both,
            Op.NOT: self.language.invert,
            Op.SELECT: self.language.select,
        }
        if i.op in methods:
            return methods[i.op](*(self._operand(a) for a in i.args)), False
        arguments = (self.written[a][0] for a in i.args)
        return self.language.call(FUNCTIONS[i.op], *arguments), True

    def _sum(self, left: int, right: int) -> str:
        """A sum with a negated term is a difference."""
        for first, second in ((left, right), (right, left)):
            i = self.program.instructions[second]
            if i.op is Op.NEGATE:
                return self.language.subtract(self._operand(first), self._operand(i.args[0]))
        return self.language.add(self._operand(left), self._operand(right))


def appearances(program: Program) -> list[int]:
    """How often each value would be written out if nothing but signs had no name of its own."""
    count = uses(program)
    for number in reversed(range(len(program.instructions))):
        i = program.instructions[number]
        if i.op is Op.NEGATE:
            # The sign goes where the value goes: as many times as both together.
            count[i.args[0]] += count[number] - 1
    return count


def _plain(program: Program, number: int) -> bool:
    i = program.instructions[number]
    return i.op is Op.INPUT and isinstance(i.data, str)


def unused(wanted: str, used: set[str]) -> str:
    """A name like the one wanted that nothing has yet."""
    name, k = wanted, 1
    while name in used:
        name = f"{wanted}_value" if k == 1 else f"{wanted}_value{k}"
        k += 1
    return name
