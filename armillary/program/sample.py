"""Points at which kernels are compared: spread over the declared ranges, the same every run."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from armillary.derivation.quantity import AnyQuantity, Kind
from armillary.derivation.statements import Kernel
from armillary.program.arithmetic import Reals
from armillary.program.drawing import Drawing

_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79)


def sample_points(kernel: Kernel, count: int) -> list[dict[str, Any]]:
    """Low-discrepancy points in the working range, at 50 digits, with exact unit vectors.

    Rotations are exact ones too. Inputs that are drawn as expressions have their values.

    Raises:
        DerivationError: where such an expression has no value.
    """
    reals, drawing = Reals(), Drawing(kernel)
    known = [*kernel.inputs, *kernel.parameters, *drawing.others]
    points = [
        {q.name: _value(q, _stream(k + 1, i), reals) for i, q in enumerate(known)}
        for k in range(count)
    ]
    return [point | drawing.at(point, reals) for point in points]


def _stream(k: int, offset: int) -> Iterator[Fraction]:
    """Van der Corput numbers of index k in one prime base after another."""
    position = offset
    while True:
        base = _PRIMES[position % len(_PRIMES)]
        yield _radical_inverse(k + 7 * (position // len(_PRIMES)) + 1, base)
        position += 5


def _radical_inverse(k: int, base: int) -> Fraction:
    total, scale = Fraction(0), Fraction(1)
    while k:
        scale /= base
        total += scale * (k % base)
        k //= base
    return total


def _value(quantity: AnyQuantity, stream: Iterator[Fraction], reals: Reals) -> Any:
    low, high = quantity.facts.range

    def one() -> Any:
        part = next(stream)
        return low + (high - low) * reals.number(part.numerator) / part.denominator

    if quantity.shape == ():
        return one()
    if quantity.facts.kind is Kind.ROTATION:
        return rotation_of(_normalised([one() for _ in range(4)], reals))
    vector = [one() for _ in quantity.parts]
    return _normalised(vector, reals) if quantity.facts.kind is Kind.UNIT_VECTOR else vector


def _normalised(vector: list[Any], reals: Reals) -> list[Any]:
    length = reals.sqrt(sum(c * c for c in vector))
    return [c / length for c in vector]


def rotation_of(quaternion: list[Any]) -> list[Any]:
    """The entries, row-major, of the rotation that a unit quaternion (w, x, y, z) stands for."""
    w, x, y, z = quaternion
    return [
        1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
        2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y),
    ]  # fmt: skip
