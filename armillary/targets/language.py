"""What a language says of itself, and the lines that a program is written in.

A language is a subclass of `Language` with one short method for each operation. A program without
indices is a list of `Statement`s; loops bring in the other lines.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Collection
from dataclasses import dataclass

import sympy


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

    def either(self, a: str, b: str) -> str:
        """Whether one of two conditions holds."""
        neither = self.both(self.inside(self.invert(a)), self.inside(self.invert(b)))
        return self.invert(self.inside(neither))

    def never(self) -> str:
        """A condition that does not hold."""
        return "0"

    def element(self, array: str, *places: str) -> str:
        """One place of an array, of as many indices as it has."""
        return array + "".join(f"[{place}]" for place in places)

    def start(self, number: str) -> str:
        """A number as the value of what will vary."""
        return number


@dataclass(frozen=True)
class Statement:
    """`name = expression`, with the definitions that the value belongs to."""

    name: str
    expression: str
    condition: bool
    identifiers: tuple[str, ...]


@dataclass(frozen=True)
class Variable:
    """A variable that is assigned later, or an array of some sizes, and where it starts.

    An array that starts somewhere starts so in every place; one that does not has no values yet.
    """

    name: str
    sizes: tuple[int, ...]
    initial: str | None
    condition: bool


@dataclass(frozen=True)
class Numbers:
    """An array of constants."""

    name: str
    values: tuple[str, ...]


@dataclass(frozen=True)
class Assignment:
    """`target = expression`, to a variable, a place of an array or a result."""

    target: str
    expression: str
    identifiers: tuple[str, ...] = ()


@dataclass(frozen=True)
class For:
    """Lines that run for `variable` from 0 to `size` - 1."""

    variable: str
    size: int
    lines: tuple[Line, ...]


Line = Statement | Variable | Numbers | Assignment | For


def unused(wanted: str, used: Collection[str]) -> str:
    """A name like the one wanted that nothing has yet."""
    name, k = wanted, 1
    while name in used:
        name = f"{wanted}_value" if k == 1 else f"{wanted}_value{k}"
        k += 1
    return name


def flat_place(terms: list[tuple[str, int]], offset: int) -> str:
    """A place in a flat array: loop variables by their strides, and an offset."""
    alone = len(terms) == 1 and not offset
    parts = []
    for variable, stride in terms:
        product = f"{stride} * {variable}"
        parts.append(variable if stride == 1 else product if alone else f"({product})")
    if offset or not parts:
        parts.append(str(offset))
    return " + ".join(parts)


def subscripts_kept(text: str, wrap: Callable[[str], list[str]]) -> list[str]:
    """Lines of a text that is broken at spaces, but not inside of a subscript."""
    kept = re.sub(r"\[[^\[\]]*\]", lambda found: found[0].replace(" ", "\0"), text)
    return [line.replace("\0", " ") for line in wrap(kept)]
