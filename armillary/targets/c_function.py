"""The body of one C function: loads, guards, arithmetic, statuses, stores."""

from __future__ import annotations

import textwrap

import sympy

from armillary.derivation.quantity import AnyQuantity
from armillary.derivation.status import Status
from armillary.program.guards import Form, Guard
from armillary.program.program import Program
from armillary.targets.body import Body, Language, unused, write_body
from armillary.targets.numbers import Precision, shortest

WIDTH = 100


class C(Language):
    """C expressions in one precision, fully parenthesised."""

    def __init__(self, precision: Precision) -> None:
        self.precision = precision
        self.type = "float" if precision.name == "f32" else "double"
        self.suffix = "f" if precision.name == "f32" else ""
        self.largest = "FLT_MAX" if precision.name == "f32" else "DBL_MAX"

    def constant(self, value: sympy.Expr | float) -> str:
        return shortest(value, self.precision) + self.suffix

    def call(self, function: str, *arguments: str) -> str:
        name = "fabs" if function == "abs" else function
        return f"{name}{self.suffix}({', '.join(arguments)})"

    def both(self, a: str, b: str) -> str:
        return f"{a} && {b}"

    def invert(self, a: str) -> str:
        return f"!{a}"

    def select(self, condition: str, then: str, otherwise: str) -> str:
        return f"{condition} ? {then} : {otherwise}"


def function_body(program: Program, language: C) -> list[str]:
    """The lines between a function's braces.

    Inputs are read before anything is written, so that a call in place is legal.
    """
    kernel = program.kernel
    taken = {*kernel.argument_names(), "p", "status"}
    taken |= {kernel.result_argument(o.name) for o in kernel.outputs}
    tests = []
    parts = {q.name: q.parts for q in (*kernel.inputs, *kernel.parameters)}
    for guard in program.guards:
        test = GuardTest(guard, parts[guard.name], language, taken)
        taken.add(test.local)
        tests.append(test)
    lines = _loads(program, language)
    lines += [line for t in tests for line in t.load()]
    lines += ["int status = ARMILLARY_OK;"]
    if kernel.parameters and not any(q.name in program.inputs_used() for q in kernel.parameters):
        lines += ["(void)p;"]
    lines = [f"  {line}" for line in lines]
    body = write_body(program, language, frozenset(taken))
    if not tests:
        lines += [f"  {line}" for line in _computation(program, language, body)]
        return [*lines, "  return status;"]
    lines += ["", f"  if ({_joined([t.outside() for t in tests], 6)}) {{"]
    lines += ["    status = ARMILLARY_NOT_FINITE;"]
    lines += [f"    if ({_joined([t.finite_outside() for t in tests], 8)}) {{"]
    lines += ["      status = ARMILLARY_OUT_OF_RANGE;", "    }", "  } else {"]
    lines += [f"    {line}" for line in _computation(program, language, body)]
    return [*lines, "  }", "  return status;"]


def filled(text: str, first: str, rest: str, width: int = WIDTH - 2) -> list[str]:
    """Text in lines of a width, broken at spaces only."""
    return textwrap.wrap(
        text,
        width,
        initial_indent=first,
        subsequent_indent=rest,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _joined(terms: list[str], indent: int) -> str:
    return f" ||\n{' ' * indent}".join(terms)


def _loads(program: Program, language: C) -> list[str]:
    kernel, used = program.kernel, program.inputs_used()
    guarded = {g.name for g in program.guards}
    lines = []
    fields = [q for q in kernel.parameters if q.name in used]
    for q in fields:
        lines += _load(q, f"p->{q.name}", language)
    for q in kernel.inputs:
        if q.shape and (q.name in used or q.name in guarded):
            lines += _load(q, q.name, language)
    return lines


def _load(quantity: AnyQuantity, place: str, language: C) -> list[str]:
    if not quantity.shape:
        return [f"const {language.type} {quantity.name} = {place};"]
    return [
        f"const {language.type} {part} = {place}[{k}];" for k, part in enumerate(quantity.parts)
    ]


def _computation(program: Program, language: C, body: Body) -> list[str]:
    room = WIDTH - 6
    lines = []
    for s in body.statements:
        kind = "int" if s.condition else language.type
        note = f"/* {', '.join(dict.fromkeys(s.identifiers))} */" if s.identifiers else ""
        line = f"const {kind} {s.name} = {s.expression};"
        if len(line) + len(note) + 1 > room:
            lines += [note] if note else []
            lines += filled(line, "", "    ", room)
        else:
            lines.append(f"{line} {note}".rstrip())
    order = sorted(body.cases, key=lambda case: (case[0] < 0, abs(case[0])))
    for status, condition in order:
        lines += [f"if ({condition}) {{", f"  status = ARMILLARY_{Status(status).name};", "}"]
    stores = []
    for result, entries in zip(program.results, body.results, strict=True):
        for k, text in enumerate(entries):
            name = program.kernel.result_argument(result.name)
            place = f"{name}[{k}]" if result.shape else f"*{name}"
            stores += filled(f"{place} = {text};", "", "    ", room)
    if any(status < 0 for status, _ in body.cases):
        return [*lines, "if (status >= 0) {", *(f"  {s}" for s in stores), "}"]
    return [*lines, *stores]


class GuardTest:
    """The tests of one guard; a form of several parts has a local of its own."""

    def __init__(self, guard: Guard, parts: tuple[str, ...], language: C, taken: set[str]) -> None:
        self.guard, self.parts, self.c = guard, parts, language
        if guard.form is not None:
            self.local = unused(f"{guard.name}_{guard.form.label}", taken)
        else:
            self.local = parts[guard.index or 0]
        self.magnitude = f"fabs{language.suffix}({self.local})"

    def load(self) -> list[str]:
        """How far a form is from its value."""
        form = self.guard.form
        if form is None:
            return []
        line = f"const {self.c.type} {self.local} = {self._distance(form)};"
        return filled(line, "", "    ")

    def _distance(self, form: Form) -> str:
        products = [
            ("-" if sign < 0 else "+", f"({' * '.join(self.parts[k] for k in places)})")
            for sign, places in form.terms
        ]
        first, *rest = products
        total = first[1] + "".join(f" {sign} {product}" for sign, product in rest)
        return f"({total}) - {self.c.constant(form.value)}" if form.value else total

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
        return line if len(line) + 12 <= WIDTH else f"({finite} &&\n         !({self._inside()}))"
