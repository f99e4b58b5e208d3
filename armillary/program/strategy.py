"""What the algebra leaves open, and the ways to settle it.

How a vector is carried through several rotations, in which direction a product of rotations is
formed, which of the equal forms of a vector is computed, and where a unit vector is normalised. A
`Strategy` settles it for a kernel as a whole, a `Decision` for one vector.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product

from armillary.algebra.vector import Vector

FORMS = ("nested", "summed", "merged", "inner")
CARRIES = ("steps", "matrix")
# Before the turns that carry a unit vector, or after them: a rotation keeps the norm.
NORMALISED = ("first", "last")


@dataclass(frozen=True)
class Strategy:
    """A direction of evaluation.

    Attributes:
        carry: "steps" turns a vector by one elementary rotation after another, "matrix" multiplies
            it with the product.
        compose: "inward" forms a product's columns from the innermost factor out, "outward" keeps
            every prefix of the product and mixes its columns.
        form: which of the equal forms of a vector is taken (see `Choice`); with "merged",
            products of rotations about one axis are merged too.
    """

    carry: str = "steps"
    compose: str = "inward"
    form: str = "nested"


def strategies() -> list[Strategy]:
    """Every direction of evaluation; the first is the plain one and wins ties."""
    return [
        Strategy(carry, compose, form)
        for form, carry, compose in product(FORMS, CARRIES, ("inward", "outward"))
    ]


Local = Mapping[Vector, str]


@dataclass(frozen=True)
class Decision:
    """A vector that can be computed in more than one way, and the ways not taken."""

    node: Vector
    options: tuple[str, ...]
