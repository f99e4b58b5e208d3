"""Builds programs: value numbering, and the rewrites that can only remove operations."""

from __future__ import annotations

import sympy

from armillary.derivation.statements import Kernel
from armillary.derivation.status import Status
from armillary.program.program import Data, Instruction, Label, Op, Program, Result

ZERO, ONE = sympy.Integer(0), sympy.Integer(1)
_COMMUTATIVE = frozenset({Op.ADD, Op.MULTIPLY, Op.DOT, Op.BOTH})


class Builder:
    """Emits instructions; equal ones are emitted once. Signs are carried outward."""

    def __init__(self) -> None:
        self.instructions: list[Instruction] = []
        self.labels: dict[int, list[Label]] = {}
        self._numbers: dict[tuple[Op, tuple[int, ...], object], int] = {}

    def emit(self, op: Op, *args: int, data: Data = None) -> int:
        """The number of an instruction, new or known."""
        order = tuple(sorted(args)) if op in _COMMUTATIVE else args
        key = (op, order, sympy.srepr(data) if isinstance(data, sympy.Expr) else data)
        if key not in self._numbers:
            self._numbers[key] = len(self.instructions)
            self.instructions.append(Instruction(op, args, data))
        return self._numbers[key]

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
    ) -> Program:
        """The program of what the results need, renumbered; the rest is dropped."""
        needed: set[int] = set()
        stack = [e for r in results for e in r.entries] + [c for _, c in cases]
        while stack:
            number = stack.pop()
            if number not in needed:
                needed.add(number)
                stack.extend(self.instructions[number].args)
        kept = sorted(needed)
        new = {old: k for k, old in enumerate(kept)}
        instructions = tuple(
            Instruction(i.op, tuple(new[a] for a in i.args), i.data)
            for i in (self.instructions[old] for old in kept)
        )
        return Program(
            kernel,
            instructions,
            tuple(Result(r.name, r.shape, tuple(new[e] for e in r.entries)) for r in results),
            tuple((status, new[c]) for status, c in cases),
            {new[n]: tuple(ls) for n, ls in sorted(self.labels.items()) if n in new},
        )

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

    def negate(self, a: int) -> int:
        inner = self.negated(a)
        if inner is not None:
            return inner
        return a if self.value(a) == ZERO else self.emit(Op.NEGATE, a)

    def add(self, a: int, b: int) -> int:
        va, vb = self.value(a), self.value(b)
        if va is not None and vb is not None:
            return self.constant(va + vb)
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
        if vb is not None:
            a, b, va, vb = b, a, vb, va
        if va is not None:
            if va in (ZERO, ONE, -ONE):
                return {ZERO: a, ONE: b, -ONE: self.negate(b)}[va]
            inner = self.instructions[b]
            if inner.op is Op.MULTIPLY and (first := self.value(inner.args[0])) is not None:
                return self.multiply(self.constant(va * first), inner.args[1])
        na, nb = self.negated(a), self.negated(b)
        if na is not None or nb is not None:
            product = self.multiply(a if na is None else na, b if nb is None else nb)
            return product if na is not None and nb is not None else self.negate(product)
        return self.emit(Op.MULTIPLY, a, b)

    def divide(self, a: int, b: int) -> int:
        va, vb = self.value(a), self.value(b)
        if va == ZERO:
            return a
        if vb is not None:
            return self.multiply(self.constant(1 / vb), a)
        na, nb = self.negated(a), self.negated(b)
        if na is not None or nb is not None:
            quotient = self.divide(a if na is None else na, b if nb is None else nb)
            return quotient if na is not None and nb is not None else self.negate(quotient)
        return self.emit(Op.DIVIDE, a, b)

    def sqrt(self, a: int) -> int:
        value = self.value(a)
        return self.emit(Op.SQRT, a) if value is None else self.constant(sympy.sqrt(value))

    def sin(self, a: int) -> int:
        value, inner = self.value(a), self.negated(a)
        if value is not None:
            return self.constant(sympy.sin(value))
        return self.emit(Op.SIN, a) if inner is None else self.negate(self.emit(Op.SIN, inner))

    def cos(self, a: int) -> int:
        value, inner = self.value(a), self.negated(a)
        if value is not None:
            return self.constant(sympy.cos(value))
        return self.emit(Op.COS, a if inner is None else inner)

    def atan2(self, y: int, x: int) -> int:
        # Odd in y, except on the cut, where y = 0 and x < 0: the sign stays inside.
        return self.emit(Op.ATAN2, y, x)

    def absolute(self, a: int) -> int:
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
