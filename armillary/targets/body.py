"""Turns a program into named lines and loops: what every language has in common.

Values used once are written where they are used, everything else becomes a local under its
definition's name. What is used after the loop that made it is declared ahead of the loop.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import count

import sympy

from armillary.algebra.index import Index
from armillary.program.guards import index_of_parts
from armillary.program.homes import Home, homes
from armillary.program.program import CONDITION_OPS, Instruction, Op, Program
from armillary.program.rewrite import appearances
from armillary.program.schedule import Chain, Loop, Step, Store, schedule
from armillary.program.sources import has_line, sources, taken
from armillary.program.walk import points
from armillary.targets.language import (
    Assignment,
    For,
    Language,
    Line,
    Numbers,
    Statement,
    Variable,
    flat_place,
    unused,
)

__all__ = ["Body", "Language", "unused", "write_body"]

# Longer expressions are hard to compare with the page, so they get a name on the way.
LARGEST_EXPRESSION = 6
# Costly operations keep a line of their own.
_OWN_LINE = frozenset({Op.SIN, Op.COS, Op.SQRT, Op.ATAN2, Op.DIVIDE, Op.SELECT, Op.ELEMENT})
_OPERANDS = frozenset({Op.CONSTANT, Op.INPUT, Op.TABLE, Op.ELEMENT})

FUNCTIONS = {Op.SQRT: "sqrt", Op.SIN: "sin", Op.COS: "cos", Op.ATAN2: "atan2", Op.ABSOLUTE: "abs"}

# An expression, and whether it stands alone: it needs no parentheses as an operand.
Text = tuple[str, bool]


@dataclass(frozen=True)
class Body:
    """What runs in order, and the expression of each result entry and case.

    Attributes:
        results: an expression for each number of each result, row-major over its indices and
            shape; none for what is stored.
        stores: what runs once the status is known.
    """

    statements: tuple[Line, ...]
    results: tuple[tuple[str, ...], ...]
    cases: tuple[tuple[int, str], ...]
    stores: tuple[Line, ...] = ()


def write_body(
    program: Program,
    language: Language,
    taken: frozenset[str],
    *,
    arrays: Mapping[str, str] | None = None,
    stored: Mapping[str, str] | None = None,
    late: bool = False,
) -> Body:
    """The body of a kernel; locals avoid the names in `taken`.

    Args:
        arrays: how a quantity that is per index is reached, where not by its name.
        stored: flat arrays that results are written to in loops, by the result's name.
        late: whether they are written only once the status is known.
    """
    return _Writer(program, language, taken, arrays or {}, stored or {}, late).write()


class _Writer:
    def __init__(
        self,
        program: Program,
        language: Language,
        taken: frozenset[str],
        arrays: Mapping[str, str],
        stored: Mapping[str, str],
        late: bool,
    ) -> None:
        self.program, self.language, self.stored = program, language, stored
        kernel = program.kernel
        quantities = (*kernel.inputs, *kernel.parameters)
        self.parts = {q.name: q.parts for q in quantities}
        self.arrays = {q.name: arrays.get(q.name, q.name) for q in quantities if index_of_parts(q)}
        self.arrays |= {f.name: arrays.get(f.name, f.name) for f in program.fields if f.index}
        self.taken = set(taken)
        self.temporaries = 0
        self.uses = appearances(program)
        self.plan = schedule(program, frozenset(stored), late)
        self.homes = homes(program, self.plan)
        self.following = set(program.carried.values())
        self.variables: dict[Index, str] = {}
        self.names: dict[int, str] = {}  # of what is declared ahead, and of tables
        self.turning: dict[int, str] = {}  # of what an iteration carries
        self.written: dict[int, Text] = {}
        self.sizes: dict[int, int] = {}

    def write(self) -> Body:
        tables = tuple(self.tables())
        lines = (*tables, *self.block(self.plan.steps, ()))
        results = tuple(
            () if result.name in self.stored else tuple(self.entries(k))
            for k, result in enumerate(self.program.results)
        )
        cases = tuple((int(status), self.text(c)[0]) for status, c in self.program.cases)
        return Body(lines, results, cases, tuple(self.block(self.plan.stores, ())))

    def entries(self, k: int) -> Iterator[str]:
        """Every number of a result that is not stored in loops."""
        result = self.program.results[k]
        for point in points(result.indices):
            yield from (self.text(entry, point)[0] for entry in result.entries)

    # -- lines --------------------------------------------------------------------------------

    def tables(self) -> Iterator[Line]:
        for number, i in enumerate(self.program.instructions):
            if i.op is Op.TABLE and isinstance(i.data, tuple):
                index, values = i.data
                self.names[number] = self.named(self._label(number) or self.numbered(index))
                assert isinstance(values, tuple)
                yield Numbers(self.names[number], tuple(self.signed(value) for value in values))

    def numbered(self, index: Index) -> str:
        """leg_constants, leg_constants_2, ..."""
        names = (f"{index}_constants{f'_{k}' if k > 1 else ''}" for k in count(1))
        return next(name for name in names if name not in self.taken)

    def signed(self, value: sympy.Expr) -> str:
        """A number, its sign outside of the literal."""
        if value.could_extract_minus_sign():
            return self.language.negate(self.language.constant(-value))
        return self.language.constant(value)

    def block(self, steps: tuple[Step, ...], chain: Chain) -> Iterator[Line]:
        """The lines of one depth."""
        for step in steps:
            if isinstance(step, Loop):
                yield from self.loop(step, chain)
            elif isinstance(step, Store):
                yield self.store(step)
            else:
                yield from self.line(step)

    def loop(self, loop: Loop, chain: Chain) -> Iterator[Line]:
        """A loop after what it fills, and at the end of a turn what is carried."""
        inner = (*chain, (loop.key, loop.index))
        phis = [s for s in loop.steps if isinstance(s, int) and s in self.program.carried]
        for phi in phis:
            yield self.started(phi)
        made = [n for n, at in self.plan.chains.items() if at[: len(inner)] == inner]
        for number in sorted(n for n in made if isinstance(n, int)):
            home = self.homes.arrays.get(number)
            if home is not None and home.block == chain:
                yield self.declared(number, home)
        if loop.index not in self.variables:
            self.variables[loop.index] = self.named(loop.index.name)
        variable = self.variables[loop.index]
        lines = (*self.block(loop.steps, inner), *self.carried(phis))
        yield For(variable, loop.index.size, lines)

    def declared(self, number: int, home: Home) -> Variable:
        """The home of a value ahead of the loop that fills it."""
        self.names[number] = self.named(self.wanted(number))
        condition, op = self.is_condition(number), self.program.instructions[number].op
        initial = None
        if not home.dims or op in (Op.SUM, Op.ANY):
            zero = self.language.constant(sympy.Integer(0))
            initial = self.language.never() if condition else zero
        sizes = tuple(index.size for index in home.dims)
        return Variable(self.names[number], sizes, initial, condition)

    def started(self, phi: int) -> Variable:
        """What an iteration carries, before its first turn."""
        self.turning[phi] = self.named(self.wanted(phi))
        initial = self.varying(self.program.instructions[phi].args[0])
        return Variable(self.turning[phi], (), initial, False)

    def varying(self, number: int) -> str:
        """A value; a mere number as one that may vary."""
        text = self.text(number)[0]
        while self.program.instructions[number].op is Op.NEGATE:
            number = self.program.instructions[number].args[0]
        fixed = self.program.instructions[number].op in (Op.CONSTANT, Op.TABLE)
        return self.language.start(text) if fixed else text

    def carried(self, phis: list[int]) -> Iterator[Line]:
        """The values of the next turn, all from this one."""
        texts = {}
        for phi in phis:
            following = self.program.carried[phi]
            texts[phi] = self.varying(following)
            behind = {source.number for source in sources(self.program, following)}
            if behind & (set(phis) - {phi}):
                # It is what another one holds in this turn.
                name = self.temporary()
                yield Statement(name, texts[phi], False, ())
                texts[phi] = name
        for phi in phis:
            if texts[phi] != self.turning[phi]:
                yield Assignment(self.turning[phi], texts[phi])

    def store(self, store: Store) -> Assignment:
        """An entry of a result, at its place."""
        result = self.program.results[store.result]
        width = len(result.entries)
        strides, step = [], width
        for index in reversed(result.indices):
            strides.append(step)
            step *= index.size
        pairs = list(zip(result.indices, reversed(strides), strict=True))
        place = flat_place([(self.variables[i], n) for i, n in pairs], store.entry)
        array = self.stored[result.name]
        text = self.text(result.entries[store.entry])[0]
        return Assignment(self.language.element(array, place), text)

    def line(self, number: int) -> Iterator[Line]:
        """The line of a value; none for one that is written where it is used."""
        ids = tuple(label.identifier for label in self.program.labels.get(number, ()))
        if number in self.homes.arrays:
            yield Assignment(self.placed(number), self.joined(number), ids)
            return
        text, alone = self.expression(number)
        size = 1 + sum(self.size(a) for a in self.program.instructions[number].args)
        if self.is_local(number, size):
            name = self.named(self.wanted(number))
            yield Statement(name, text, self.is_condition(number), ids)
            text, alone, size = name, True, 0
        self.written[number], self.sizes[number] = (text, alone), size

    def joined(self, number: int) -> str:
        """What a home is assigned: a value, or what it held and one more term."""
        i = self.program.instructions[number]
        if i.op is Op.SUM:
            return self.language.add(self.placed(number), self.operand(i.args[0]))
        if i.op is Op.ANY:
            return self.language.either(self.placed(number), self.operand(i.args[0]))
        return self.expression(number)[0]

    def is_local(self, number: int, size: int) -> bool:
        op = self.program.instructions[number].op
        if op is Op.PHI:
            return False  # it has a name already
        named = number in self.program.labels or number in self.following
        many = self.uses[number] > 1 or number in self.homes.shared
        return named or many or op in _OWN_LINE or op in CONDITION_OPS or size > LARGEST_EXPRESSION

    # -- names --------------------------------------------------------------------------------

    def wanted(self, number: int) -> str:
        """The definition's name, that of the angle it is the sine of, or t1, t2, ..."""
        i, label = self.program.instructions[number], self._label(number)
        if label:
            return label
        if i.op in (Op.SIN, Op.COS) and _plain(self.program, i.args[0]):
            return f"{i.op.value}_{self.program.instructions[i.args[0]].data}"
        if i.op is Op.PHI and isinstance(i.data, tuple):
            return str(i.data[1])
        self.temporaries += 1
        return f"t{self.temporaries}"

    def _label(self, number: int) -> str | None:
        label = self.program.labels.get(number)
        return label[0].names[0] if label else None

    def named(self, wanted: str) -> str:
        """A name that nothing has yet, taken."""
        name = unused(wanted, self.taken)
        self.taken.add(name)
        return name

    def temporary(self) -> str:
        self.temporaries += 1
        return self.named(f"t{self.temporaries}")

    # -- expressions --------------------------------------------------------------------------

    def text(self, number: int, point: Mapping[Index, int] | None = None) -> Text:
        """A value where it is used; with a point, what it was there, its loops being over."""
        at = point or {}
        i = self.program.instructions[number]
        if not has_line(self.program, number):
            return self.in_place(number, i, at)
        phi = self.homes.carried.get(number)
        if phi is not None and at:
            return self.turning[phi], True
        if number in self.homes.arrays:
            return self.placed(number, at), True
        return self.written[number]

    def in_place(self, number: int, i: Instruction, at: Mapping[Index, int]) -> Text:
        """What has no line of its own."""
        if i.op is Op.CONSTANT:
            assert isinstance(i.data, sympy.Expr)
            return self.language.constant(i.data), True
        if i.op is Op.INPUT:
            return self.input(i.data, at), True
        if i.op is Op.NEGATE:
            return self.language.negate(self.operand(i.args[0], at)), False
        if i.op is Op.ELEMENT:
            index, place = taken(self.program, number)
            return self.text(i.args[0], {**at, index: place})
        assert isinstance(i.data, tuple)
        assert isinstance(i.data[0], Index)
        return self.language.element(self.names[number], self.at(i.data[0], at)), True

    def input(self, data: object, at: Mapping[Index, int]) -> str:
        """A quantity, a part of it, or its part at a place."""
        if not isinstance(data, tuple):
            return str(data)
        name = data[0]
        if name not in self.arrays:
            return self.parts[name][data[1]]
        if len(data) == 2:
            return self.language.element(self.arrays[name], str(data[1]))
        _, index, stride, offset = data
        if index in at:
            return self.language.element(self.arrays[name], str(at[index] * stride + offset))
        place = flat_place([(self.variables[index], stride)], offset)
        return self.language.element(self.arrays[name], place)

    def at(self, index: Index, at: Mapping[Index, int]) -> str:
        return str(at[index]) if index in at else self.variables[index]

    def placed(self, number: int, at: Mapping[Index, int] | None = None) -> str:
        """A value at home."""
        places = [self.at(index, at or {}) for index in self.homes.arrays[number].dims]
        return self.language.element(self.names[number], *places)

    def size(self, number: int) -> int:
        """How many operations the text of a value holds."""
        op = self.program.instructions[number].op
        if op in _OPERANDS:
            return 0
        if op is Op.NEGATE:
            return 1 + self.size(self.program.instructions[number].args[0])
        return self.sizes.get(number, 0)  # none for what has a home

    def is_condition(self, number: int) -> bool:
        while self.program.instructions[number].op is Op.ELEMENT:
            number = self.program.instructions[number].args[0]
        return self.program.instructions[number].op in CONDITION_OPS

    def operand(self, number: int, at: Mapping[Index, int] | None = None) -> str:
        text, alone = self.text(number, at)
        return text if alone else self.language.inside(text)

    def expression(self, number: int) -> Text:
        """What a value is made of."""
        i = self.program.instructions[number]
        if i.op is Op.PHI:
            return self.turning[number], True
        if i.op is Op.ADD:
            return self._sum(*i.args), False
        if i.op is Op.ELEMENT:
            return self.in_place(number, i, {})
        methods: dict[Op, Callable[..., str]] = {
            Op.MULTIPLY: self.language.multiply,
            Op.DIVIDE: self.language.divide,
            Op.LESS: self.language.less,
            Op.BOTH: self.language.both,
            Op.NOT: self.language.invert,
            Op.SELECT: self.language.select,
        }
        if i.op in methods:
            return methods[i.op](*(self.operand(a) for a in i.args)), False
        arguments = (self.text(a)[0] for a in i.args)
        return self.language.call(FUNCTIONS[i.op], *arguments), True

    def _sum(self, left: int, right: int) -> str:
        """A sum with a negated term is a difference."""
        for first, second in ((left, right), (right, left)):
            i = self.program.instructions[second]
            if i.op is Op.NEGATE:
                return self.language.subtract(self.operand(first), self.operand(i.args[0]))
        return self.language.add(self.operand(left), self.operand(right))


def _plain(program: Program, number: int) -> bool:
    i = program.instructions[number]
    return i.op is Op.INPUT and isinstance(i.data, str)
