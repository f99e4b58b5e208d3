"""Builds programs: value numbering, and the rewrites that can only remove operations."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

import sympy

from armillary.algebra.index import Index
from armillary.derivation.statements import Kernel
from armillary.derivation.status import Status
from armillary.program.program import (
    Data,
    Domain,
    Instruction,
    Label,
    Op,
    Program,
    Result,
    domain_of,
    is_vector,
    place_of,
)

ZERO, ONE = sympy.Integer(0), sympy.Integer(1)
_COMMUTATIVE = frozenset({Op.ADD, Op.MULTIPLY, Op.DOT, Op.BOTH})


Values = tuple[sympy.Expr, ...]


class Builder:
    """Emits instructions; equal ones are emitted once. Signs are carried outward.

    `domains` holds the indices that each value depends on.
    """

    def __init__(self) -> None:
        self.instructions: list[Instruction] = []
        self.domains: list[Domain] = []
        self.labels: dict[int, list[Label]] = {}
        self.carried: dict[int, int] = {}
        self._numbers: dict[tuple[Op, tuple[int, ...], object], int] = {}

    def emit(self, op: Op, *args: int, data: Data = None) -> int:
        """The number of an instruction, new or known."""
        order = tuple(sorted(args)) if op in _COMMUTATIVE else args
        key = (op, order, sympy.srepr(data) if isinstance(data, sympy.Expr) else data)
        if key not in self._numbers:
            self._numbers[key] = self._append(Instruction(op, args, data))
        return self._numbers[key]

    def _append(self, instruction: Instruction) -> int:
        self.instructions.append(instruction)
        self.domains.append(domain_of(instruction, self.domains))
        return len(self.instructions) - 1

    def label(self, number: int, names: tuple[str, ...], identifier: str) -> None:
        """Give a value a definition's name."""
        label = Label(names, identifier)
        known = self.labels.setdefault(number, [])
        if label not in known:
            known.append(label)

    def finish(
        self,
        kernel: Kernel,
        results: tuple[Result, ...],
        cases: tuple[tuple[Status, int], ...],
        beforehand: frozenset[str] = frozenset(),
    ) -> Program:
        """The program of what the results need, renumbered; the rest is dropped."""
        _check_domains(self.domains, results, cases)
        kept = sorted(self._needed([e for r in results for e in r.entries] + [c for _, c in cases]))
        new = {old: k for k, old in enumerate(kept)}
        instructions = tuple(
            Instruction(i.op, tuple(new[a] for a in i.args), i.data)
            for i in (self.instructions[old] for old in kept)
        )
        phis = [n for n in kept if self.instructions[n].op is Op.PHI]
        return Program(
            kernel,
            instructions,
            tuple(replace(r, entries=tuple(new[e] for e in r.entries)) for r in results),
            tuple((status, new[c]) for status, c in cases),
            {new[n]: tuple(ls) for n, ls in sorted(self.labels.items()) if n in new},
            {new[n]: new[self.carried[n]] for n in phis},
            {new[n]: self.domains[n] for n in phis},
            beforehand,
        )

    def _needed(self, stack: list[int]) -> set[int]:
        needed: set[int] = set()
        while stack:
            number = stack.pop()
            if number in needed:
                continue
            needed.add(number)
            stack.extend(self.instructions[number].args)
            if self.instructions[number].op is Op.PHI:
                if number not in self.carried:
                    raise ValueError(f"nothing is carried to {self.instructions[number]}")
                stack.append(self.carried[number])
        return needed

    # -- scalars ------------------------------------------------------------------------------

    def constant(self, value: sympy.Expr) -> int:
        if value.could_extract_minus_sign():
            return self.emit(Op.NEGATE, self.emit(Op.CONSTANT, data=-value))
        return self.emit(Op.CONSTANT, data=value)

    def value(self, number: int) -> sympy.Expr | None:
        """The number a constant stands for, sign included."""
        instruction = self.instructions[number]
        if instruction.op is Op.CONSTANT:
            assert isinstance(instruction.data, sympy.Expr)
            return instruction.data
        inner = self.negated(number)
        if inner is not None and self.instructions[inner].op is Op.CONSTANT:
            value = self.value(inner)
            return None if value is None else -value
        return None

    def negated(self, number: int) -> int | None:
        """What a negation negates."""
        instruction = self.instructions[number]
        return instruction.args[0] if instruction.op is Op.NEGATE else None

    def table(self, index: Index, values: Iterable[sympy.Expr]) -> int:
        """Constants, one for each part of an index; a constant where all are the same."""
        given = tuple(values)
        if len(given) != index.size:
            raise ValueError(f"{len(given)} values for the {index.size} parts of {index}")
        if len({sympy.srepr(value) for value in given}) == 1:
            return self.constant(given[0])
        first = next(value for value in given if value != ZERO)
        if first.could_extract_minus_sign():
            return self.emit(Op.NEGATE, self._table(index, tuple(-value for value in given)))
        return self._table(index, given)

    def _table(self, index: Index, values: Values) -> int:
        return self.emit(Op.TABLE, data=(index, values))

    def tabled(self, number: int) -> tuple[Index, Values] | None:
        """The index and the numbers of a table, sign included."""
        inner = self.negated(number)
        instruction = self.instructions[number if inner is None else inner]
        if instruction.op is not Op.TABLE:
            return None
        data: Any = instruction.data
        index, values = data
        return index, values if inner is None else tuple(-value for value in values)

    def _folded(self, rule: Callable[..., sympy.Expr], *args: int) -> int | None:
        """A rule of numbers on tables of one index, or on a table and a constant."""
        tables = [self.tabled(a) for a in args]
        index = next((t[0] for t in tables if t is not None), None)
        if index is None:
            return None
        rows: list[Values] = []
        for a, known in zip(args, tables, strict=True):
            value = self.value(a)
            if known is not None and known[0] == index:
                rows.append(known[1])
            elif value is not None:
                rows.append((value,) * index.size)
            else:
                return None
        return self.table(index, (rule(*row) for row in zip(*rows, strict=True)))

    def negate(self, a: int) -> int:
        inner = self.negated(a)
        if inner is not None:
            return inner
        return a if self.value(a) == ZERO else self.emit(Op.NEGATE, a)

    def add(self, a: int, b: int) -> int:
        va, vb = self.value(a), self.value(b)
        if va is not None and vb is not None:
            return self.constant(va + vb)
        if (folded := self._folded(lambda x, y: x + y, a, b)) is not None:
            return folded
        if va == ZERO:
            return b
        if vb == ZERO:
            return a
        na, nb = self.negated(a), self.negated(b)
        if na is not None and nb is not None:
            return self.negate(self.add(na, nb))
        if na == b or nb == a:
            return self.constant(ZERO)
        if nb is not None and self._known(Op.ADD, nb, self.negate(a)):
            return self.negate(self.emit(Op.ADD, nb, self.negate(a)))
        if na is not None and self._known(Op.ADD, na, self.negate(b)):
            return self.negate(self.emit(Op.ADD, na, self.negate(b)))
        return self.emit(Op.ADD, a, b)

    def _known(self, op: Op, *args: int) -> bool:
        return (op, tuple(sorted(args)), None) in self._numbers

    def multiply(self, a: int, b: int) -> int:
        va, vb = self.value(a), self.value(b)
        if va is not None and vb is not None:
            return self.constant(va * vb)
        if (folded := self._folded(lambda x, y: x * y, a, b)) is not None:
            return folded
        if vb is not None:
            a, b, va, vb = b, a, vb, va
        if va is not None:
            if va in (ZERO, ONE, -ONE):
                return {ZERO: a, ONE: b, -ONE: self.negate(b)}[va]
            inner = self.instructions[b]
            if inner.op is Op.MULTIPLY and (first := self.value(inner.args[0])) is not None:
                return self.multiply(self.constant(va * first), inner.args[1])
        if (regrouped := self._regrouped(a, b)) is not None:
            return regrouped
        na, nb = self.negated(a), self.negated(b)
        if na is not None or nb is not None:
            product = self.multiply(a if na is None else na, b if nb is None else nb)
            return product if na is not None and nb is not None else self.negate(product)
        return self.emit(Op.MULTIPLY, a, b)

    def _regrouped(self, a: int, b: int) -> int | None:
        """A table times what a table or a constant is the first factor of, and the other way."""
        for first, second in ((a, b), (b, a)):
            inner = self.instructions[second]
            if inner.op is not Op.MULTIPLY:
                continue
            factor = self._folded(lambda x, y: x * y, first, inner.args[0])
            if factor is not None:
                return self.multiply(factor, inner.args[1])
        return None

    def divide(self, a: int, b: int) -> int:
        va, vb = self.value(a), self.value(b)
        if va == ZERO:
            return a
        if vb is not None:
            return self.multiply(self.constant(1 / vb), a)
        divisors = self.tabled(b)
        if divisors is not None and ZERO not in divisors[1]:
            return self.multiply(self.table(divisors[0], (1 / v for v in divisors[1])), a)
        na, nb = self.negated(a), self.negated(b)
        if na is not None or nb is not None:
            quotient = self.divide(a if na is None else na, b if nb is None else nb)
            return quotient if na is not None and nb is not None else self.negate(quotient)
        return self.emit(Op.DIVIDE, a, b)

    def sqrt(self, a: int) -> int:
        value, table = self.value(a), self.tabled(a)
        if table is not None and all(v.is_nonnegative for v in table[1]):
            return self.table(table[0], map(sympy.sqrt, table[1]))
        return self.emit(Op.SQRT, a) if value is None else self.constant(sympy.sqrt(value))

    def sin(self, a: int) -> int:
        value, inner = self.value(a), self.negated(a)
        if value is not None:
            return self.constant(sympy.sin(value))
        if (folded := self._folded(sympy.sin, a)) is not None:
            return folded
        return self.emit(Op.SIN, a) if inner is None else self.negate(self.emit(Op.SIN, inner))

    def cos(self, a: int) -> int:
        value, inner = self.value(a), self.negated(a)
        if value is not None:
            return self.constant(sympy.cos(value))
        if (folded := self._folded(sympy.cos, a)) is not None:
            return folded
        return self.emit(Op.COS, a if inner is None else inner)

    def atan2(self, y: int, x: int) -> int:
        # Odd in y, except on the cut, where y = 0 and x < 0: the sign stays inside.
        return self.emit(Op.ATAN2, y, x)

    def absolute(self, a: int) -> int:
        if (folded := self._folded(sympy.Abs, a)) is not None:
            return folded
        inner = self.negated(a)
        return self.emit(Op.ABSOLUTE, a if inner is None else inner)

    def less(self, a: int, b: int) -> int:
        return self.emit(Op.LESS, a, b)

    def both(self, a: int, b: int) -> int:
        return a if a == b else self.emit(Op.BOTH, a, b)

    def invert(self, a: int) -> int:
        instruction = self.instructions[a]
        return instruction.args[0] if instruction.op is Op.NOT else self.emit(Op.NOT, a)

    def select(self, condition: int, then: int, otherwise: int) -> int:
        return then if then == otherwise else self.emit(Op.SELECT, condition, then, otherwise)

    # -- over an index ------------------------------------------------------------------------

    def sum(self, a: int, index: Index) -> int:
        """The sum of the values at all points of an index."""
        if index not in self.domains[a]:
            size = self.constant(sympy.Integer(index.size))
            return (
                self.emit(Op.SCALE, size, a)
                if is_vector(self.instructions, a)
                else self.multiply(size, a)
            )
        if (table := self.tabled(a)) is not None:
            return self.constant(sympy.Add(*table[1]))
        inner = self.negated(a)
        if inner is not None:
            return self.negate(self.emit(Op.SUM, inner, data=index))
        return self.emit(Op.SUM, a, data=index)

    def any_of(self, a: int, index: Index) -> int:
        """Whether a condition holds at some point of an index."""
        return self.emit(Op.ANY, a, data=index) if index in self.domains[a] else a

    def element(self, a: int, index: Index, place: int) -> int:
        """The value at one point of an index."""
        if not 0 <= place < index.size:
            raise ValueError(f"{index} has no place {place}")
        if index not in self.domains[a]:
            return a
        if (table := self.tabled(a)) is not None:
            return self.constant(table[1][place])
        inner, data = self.negated(a), self.instructions[a].data
        if inner is not None:
            return self.negate(self.element(inner, index, place))
        if self.instructions[a].op is Op.INPUT:
            assert isinstance(data, tuple)
            return self.emit(Op.INPUT, data=(str(data[0]), place_of(data, {index: place})))
        return self.emit(Op.ELEMENT, a, data=(index, place))

    def phi(self, initial: int, index: Index, name: str, over: Iterable[Index] = ()) -> int:
        """What an iteration carries: `initial` in the first turn, then what `carry` tells.

        Args:
            index: counts the turns; it is sequential.
            name: of what is carried.
            over: the indices that the carried values depend on, where `initial` does not.
        """
        if not index.sequential or index in self.domains[initial]:
            raise ValueError(f"{name} cannot be carried along {index} from where it starts")
        # Never one that is known: two iterations may start alike and go on otherwise.
        number = self._append(Instruction(Op.PHI, (initial,), (index, name)))
        self.domains[number] |= frozenset(over)
        return number

    def carry(self, phi: int, following: int) -> None:
        """What a phi has in the next turn."""
        more = self.domains[following] - self.domains[phi]
        if more:
            names = ", ".join(sorted(index.name for index in more))
            raise ValueError(f"what is carried depends on {names}, and its start does not")
        self.carried[phi] = following


def _check_domains(
    domains: list[Domain], results: tuple[Result, ...], cases: tuple[tuple[Status, int], ...]
) -> None:
    """A result may depend on its own indices, a case on none."""
    for result in results:
        if any(domains[entry] - frozenset(result.indices) for entry in result.entries):
            raise ValueError(f"the result {result.name} depends on an index that it has not")
    for status, condition in cases:
        if domains[condition]:
            raise ValueError(f"the case {status.name} depends on an index: take any of it")
