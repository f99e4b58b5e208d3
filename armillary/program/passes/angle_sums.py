"""The sine of an angle and a constant of each part is mixed from one sine and cosine.

sin(a + c), where a stays the same in a loop and c is a number for each part, needs no trigonometry
of its own: sin(a) cos(c) + cos(a) sin(c). A step may have c of each part from its set-up.
"""

from __future__ import annotations

from armillary.program.cost import measure
from armillary.program.program import Op, Program, domains
from armillary.program.rates import handed
from armillary.program.rewrite import Rewriter


def open_angle_sums(program: Program) -> Program:
    """Take the trigonometry of what a loop does not change out of the loop."""
    if not any(domains(program)):
        return program
    opened = _Open(program).run()
    return opened if measure(opened) <= measure(program) else program


class _Open(Rewriter):
    def __init__(self, program: Program) -> None:
        super().__init__(program)
        self.domains, self.handed = domains(program), handed(program)

    def rewrite(self, number: int) -> int:
        i = self.program.instructions[number]
        parts = self._parts(i.args[0]) if i.op in (Op.SIN, Op.COS) else None
        if parts is None:
            return super().rewrite(number)
        angle, constant = parts
        b = self.builder
        sine, cosine = b.sin(angle), b.cos(angle)
        if i.op is Op.SIN:
            return b.add(b.multiply(sine, b.cos(constant)), b.multiply(cosine, b.sin(constant)))
        mixed = b.multiply(sine, b.sin(constant))
        return b.add(b.multiply(cosine, b.cos(constant)), b.negate(mixed))

    def _parts(self, number: int) -> tuple[int, int] | None:
        """What a sum is of, if one part is held in the loop and the other costs no turn."""
        i = self.program.instructions[number]
        if i.op is not Op.ADD:
            return None
        for angle, other in (i.args, i.args[::-1]):
            held = self.domains[angle] < self.domains[number]
            free = self.handed[other] and not self.handed[angle]
            if held and (free or self.builder.tabled(self.new[other]) is not None):
                return self.new[angle], self.new[other]
        return None
