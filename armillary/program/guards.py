"""What a kernel accepts: one guard for each part of an input, and what its parts owe together.

A unit vector must have a square of 1. The entries of a rotation must make columns of square 1 that
are perpendicular, and a determinant above 0, which a reflection has not.
"""

from __future__ import annotations

from dataclasses import dataclass

from armillary.algebra.index import Index
from armillary.derivation.quantity import AnyQuantity, Kind

FORM_TOLERANCE = 1e-3

# A sign, and the places of the parts that are multiplied.
Term = tuple[int, tuple[int, ...]]


@dataclass(frozen=True)
class Form:
    """A polynomial of an input's parts that must be near a value."""

    label: str
    terms: tuple[Term, ...]
    value: float
    tolerance: float


@dataclass(frozen=True)
class Guard:
    """Bounds of one part of an input, or of a form of several."""

    name: str
    index: int | None
    low: float
    high: float
    form: Form | None = None


def index_of_parts(quantity: AnyQuantity) -> Index | None:
    """The index that a quantity has a value for each part of; a rotation has none."""
    return quantity.facts.per


def guards_of(quantity: AnyQuantity) -> tuple[Guard, ...]:
    """The guards of one quantity."""
    low, high = quantity.facts.limits
    if quantity.shape == ():
        return (Guard(quantity.name, None, low, high),)
    bounds = [Guard(quantity.name, k, low, high) for k in range(len(quantity.parts))]
    forms = _FORMS.get(quantity.facts.kind, ())
    return (*bounds, *(_guard_of(quantity.name, form) for form in forms))


def _guard_of(name: str, form: Form) -> Guard:
    return Guard(name, None, form.value - form.tolerance, form.value + form.tolerance, form)


def _product(label: str, first: tuple[int, ...], second: tuple[int, ...], value: float) -> Form:
    """The dot product of two vectors, each given by the places of its components."""
    terms = tuple((1, pair) for pair in zip(first, second, strict=True))
    return Form(label, terms, value, FORM_TOLERANCE)


def _orthonormal() -> tuple[Form, ...]:
    columns = [tuple(3 * i + j for i in range(3)) for j in range(3)]
    squares = [_product(f"square_{j + 1}", c, c, 1.0) for j, c in enumerate(columns)]
    pairs = [(0, 1), (0, 2), (1, 2)]
    dots = [_product(f"dot_{i + 1}{j + 1}", columns[i], columns[j], 0.0) for i, j in pairs]
    return (*squares, *dots, _DETERMINANT)


# Where the columns are orthonormal it is near 1 or near -1: any bound between tells them apart.
_DETERMINANT = Form(
    "determinant",
    (
        (1, (0, 4, 8)),
        (1, (1, 5, 6)),
        (1, (2, 3, 7)),
        (-1, (2, 4, 6)),
        (-1, (1, 3, 8)),
        (-1, (0, 5, 7)),
    ),
    1.0,
    1.0,
)
_FORMS = {
    Kind.UNIT_VECTOR: (_product("excess", (0, 1, 2), (0, 1, 2), 1.0),),
    Kind.ROTATION: _orthonormal(),
}
