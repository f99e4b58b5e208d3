"""Indices: what runs over the like parts of a machine, and over the turns of an iteration."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Index:
    """Like parts, told by one name; a loop in a program.

    Attributes:
        size: how many there are; parts count from 0.
        sequential: whether each turn stands on the one before, as in an iteration.
        letter: how it is printed as a subscript.
    """

    name: str
    size: int
    sequential: bool = False
    letter: str = "i"

    def __str__(self) -> str:
        return self.name
