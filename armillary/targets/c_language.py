"""C expressions and lines in one precision."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator

import sympy

from armillary.targets.language import (
    Assignment,
    For,
    Language,
    Line,
    Numbers,
    Statement,
    Variable,
    subscripts_kept,
)
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

    def either(self, a: str, b: str) -> str:
        return f"{a} || {b}"

    def invert(self, a: str) -> str:
        return f"!{a}"

    def select(self, condition: str, then: str, otherwise: str) -> str:
        return f"{condition} ? {then} : {otherwise}"

    # -- lines --------------------------------------------------------------------------------

    def lines(self, given: Iterable[Line], room: int) -> Iterator[str]:
        """Lines of a body, none longer than `room`."""
        for line in given:
            if isinstance(line, For):
                v = line.variable
                yield f"for (int {v} = 0; {v} < {line.size}; ++{v}) {{"
                yield from (f"  {inner}" for inner in self.lines(line.lines, room - 2))
                yield "}"
            elif isinstance(line, Statement):
                kind = self._kind(line.condition)
                text = f"const {kind} {line.name} = {line.expression};"
                yield from _noted(text, line.identifiers, room)
            elif isinstance(line, Assignment):
                text = f"{line.target} = {line.expression};"
                yield from _noted(text, line.identifiers, room)
            else:
                yield from filled(self._declared(line), "", "    ", room)

    def _declared(self, line: Variable | Numbers) -> str:
        if isinstance(line, Numbers):
            values = ", ".join(line.values)
            return f"const {self.type} {line.name}[{len(line.values)}] = {{{values}}};"
        kind, sizes = self._kind(line.condition), "".join(f"[{n}]" for n in line.sizes)
        if line.initial is None:
            return f"{kind} {line.name}{sizes};"
        depth = len(line.sizes)
        return f"{kind} {line.name}{sizes} = {'{' * depth}{line.initial}{'}' * depth};"

    def _kind(self, condition: bool) -> str:
        return "int" if condition else self.type


def _noted(line: str, identifiers: tuple[str, ...], room: int) -> list[str]:
    """A line with the definitions it belongs to beside it, or above it where it is long."""
    note = f"/* {', '.join(dict.fromkeys(identifiers))} */" if identifiers else ""
    if len(line) + len(note) + 1 > room:
        broken = subscripts_kept(line, lambda text: filled(text, "", "    ", room))
        return [*([note] if note else []), *broken]
    return [f"{line} {note}".rstrip()]


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
