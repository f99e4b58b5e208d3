"""Turns that are known beforehand are gathered into a matrix, which a set-up forms.

A vector that is turned three times in a row by known rotations costs 18 operations; one product
with their matrix costs 15, and the matrix is handed over. A known vector that is added on the way
is turned by the set-up: R (b + c) becomes R b + R c, so that the turns before and after the sum
are one run.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy

from armillary.program.cost import measure
from armillary.program.program import Op, Program
from armillary.program.rates import known
from armillary.program.rewrite import Rewriter, uses

# Fewer turns are cheaper one by one: 6 operations each, against 15.
SHORTEST = 3


def gather_turns(program: Program) -> Program:
    """Turn by matrices that are known beforehand, where that makes a step cheaper."""
    if not program.beforehand:
        return program
    gathered = _Gather(program).run()
    return gathered if measure(gathered) < measure(program) else program


@dataclass
class _Run:
    """A vector as known turns of another one, plus known vectors.

    `turns` holds axis, sine and cosine of each, the outermost first; `known` tells of a known
    vector how many of the turns act on it, and whether it is subtracted.
    """

    vector: int
    turns: list[tuple[int, int, int]] = field(default_factory=list)
    known: list[tuple[int, int, bool]] = field(default_factory=list)
    negative: bool = False


class _Gather(Rewriter):
    def __init__(self, program: Program) -> None:
        super().__init__(program)
        self.known, self.uses = known(program), uses(program)

    def rewrite(self, number: int) -> int:
        run = self._run(number)
        real = [sine for _, sine, _ in run.turns if self.builder.value(sine) is None]
        if len(real) < SHORTEST:
            return super().rewrite(number)
        b = self.builder
        whole = self._by_matrix(run)
        if run.negative:
            whole = b.emit(Op.NEGATE_VECTOR, whole)
        for vector, depth, negative in run.known:
            turned = self._turned(run.turns[:depth], self.new[vector])
            if negative:
                turned = b.emit(Op.NEGATE_VECTOR, turned)
            whole = b.emit(Op.ADD_VECTORS, turned, whole)
        return whole

    def _run(self, number: int) -> _Run:
        """The longest run of known turns that ends in a value, nothing in it used elsewhere."""
        run = _Run(number)
        while not self.known[run.vector]:
            i = self.program.instructions[run.vector]
            if run.vector != number and self.uses[run.vector] > 1:
                break
            if i.op is Op.ROTATE and self.known[i.args[0]] and self.known[i.args[1]]:
                assert isinstance(i.data, int)
                run.turns.append((i.data, self.new[i.args[0]], self.new[i.args[1]]))
                run.vector = i.args[2]
            elif i.op is Op.NEGATE_VECTOR and run.turns:
                run.negative = not run.negative
                run.vector = i.args[0]
            elif i.op is Op.ADD_VECTORS and run.turns and any(self.known[a] for a in i.args):
                given, rest = sorted(i.args, key=lambda a: not self.known[a])
                run.known.append((given, len(run.turns), run.negative))
                run.vector = rest
            else:
                break
        return run

    def _turned(self, turns: list[tuple[int, int, int]], vector: int) -> int:
        for axis, sine, cosine in reversed(turns):
            vector = self.builder.emit(Op.ROTATE, sine, cosine, vector, data=axis)
        return vector

    def _by_matrix(self, run: _Run) -> int:
        """The matrix of the turns times the vector."""
        b, vector = self.builder, self.new[run.vector]
        parts = (b.emit(Op.PICK, vector, data=k) for k in range(3))
        whole: int | None = None
        for axis, part in enumerate(parts):
            unit = [b.constant(sympy.Integer(int(axis == k))) for k in range(3)]
            column = self._turned(run.turns, b.emit(Op.PACK, *unit))
            term = b.emit(Op.SCALE, part, column)
            whole = term if whole is None else b.emit(Op.ADD_VECTORS, whole, term)
        assert whole is not None
        return whole
