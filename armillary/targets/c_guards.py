"""The tests of a kernel's arguments in C: one compare each, and a slow path that tells why."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from armillary.algebra.index import Index
from armillary.derivation.quantity import AnyQuantity
from armillary.program.guards import Form, Guard, index_of_parts
from armillary.targets.c_language import WIDTH, C, filled
from armillary.targets.language import flat_place


@dataclass(frozen=True)
class Test:
    """The test of one number: `local` is what it is called, `beside` what else a line holds."""

    guard: Guard
    local: str
    c: C
    beside: int = 12

    @property
    def magnitude(self) -> str:
        return f"fabs{self.c.suffix}({self.local})"

    def _inside(self) -> str:
        g, c = self.guard, self.c
        if g.form is not None:
            return f"{self.magnitude} <= {c.constant(g.form.tolerance)}"
        if g.low == -g.high:
            return f"{self.magnitude} <= {c.constant(g.high)}"
        low = f"-{c.constant(-g.low)}" if g.low < 0 else c.constant(g.low)
        high = f"-{c.constant(-g.high)}" if g.high < 0 else c.constant(g.high)
        return f"({self.local} >= {low}) && ({self.local} <= {high})"

    def outside(self) -> str:
        """True for a NaN too."""
        return f"!({self._inside()})"

    def finite_outside(self) -> str:
        """True for a number that is refused; an infinite square is its components' fault."""
        finite = f"({self.magnitude} <= {self.c.largest})"
        line = f"({finite} && !({self._inside()}))"
        return (
            line
            if len(line) + self.beside <= WIDTH
            else f"({finite} &&\n         !({self._inside()}))"
        )


def form_line(local: str, form: Form, parts: tuple[str, ...], c: C) -> list[str]:
    """How far a form of several parts is from its value, under a name."""
    return filled(f"const {c.type} {local} = {_distance(form, parts, c)};", "", "    ")


def _distance(form: Form, parts: tuple[str, ...], c: C) -> str:
    products = [
        ("-" if sign < 0 else "+", f"({' * '.join(parts[k] for k in places)})")
        for sign, places in form.terms
    ]
    first, *rest = products
    total = first[1] + "".join(f" {sign} {product}" for sign, product in rest)
    return f"({total}) - {c.constant(form.value)}" if form.value else total


def refusal(tests: list[Test], indent: int, first: bool) -> list[str]:
    """What sets the status where a test fails; of several faults the most negative wins.

    Args:
        indent: of the lines, for the conditions that are broken.
        first: whether nothing can have set it before.
    """
    lines = [f"if ({_joined([t.outside() for t in tests], indent + 4)}) {{"]
    if first:
        lines += ["  status = ARMILLARY_NOT_FINITE;"]
    else:
        lines += ["  if (status == ARMILLARY_OK) {", "    status = ARMILLARY_NOT_FINITE;", "  }"]
    lines += [f"  if ({_joined([t.finite_outside() for t in tests], indent + 6)}) {{"]
    return [*lines, "    status = ARMILLARY_OUT_OF_RANGE;", "  }"]


def _joined(terms: list[str], indent: int) -> str:
    return f" ||\n{' ' * indent}".join(terms)


def guard_loops(
    quantities: list[AnyQuantity],
    guards: tuple[Guard, ...],
    arrays: Mapping[str, str],
    variables: Mapping[Index, str],
    c: C,
) -> list[str]:
    """A loop over each index, with the tests of the quantities that run over it."""
    lines = []
    for index, variable in variables.items():
        tests = []
        for q in quantities:
            if index_of_parts(q) == index:
                width = len(q.parts) // index.size
                # The parts of one quantity have one pair of bounds.
                guard = next(g for g in guards if g.name == q.name)
                places = (flat_place([(variable, width)], k) for k in range(width))
                tests += [Test(guard, f"{arrays[q.name]}[{place}]", c, 14) for place in places]
        if tests:
            lines += [f"for (int {variable} = 0; {variable} < {index.size}; ++{variable}) {{"]
            lines += [f"  {line}" for line in refusal(tests, 4, first=False)]
            lines += ["  }", "}"]
    return lines
