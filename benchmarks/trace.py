"""Scalars that remember only how they came about: two recipes alike give the same mark."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

from benchmarks.matrices import Matrix, Scalar, Vector
from benchmarks.recipes import Kernel


@dataclass(frozen=True)
class Trace:
    """A scalar, told by a digest of the operation and what it was done to."""

    mark: str

    def __add__(self, other: Scalar) -> Trace:
        """Sum."""
        return made("add", self, other)

    def __radd__(self, other: Scalar) -> Trace:
        """Sum, with a number before."""
        return made("add", other, self)

    def __sub__(self, other: Scalar) -> Trace:
        """Difference."""
        return made("sub", self, other)

    def __rsub__(self, other: Scalar) -> Trace:
        """Difference, from a number."""
        return made("sub", other, self)

    def __mul__(self, other: Scalar) -> Trace:
        """Product."""
        return made("mul", self, other)

    def __rmul__(self, other: Scalar) -> Trace:
        """Product, with a number before."""
        return made("mul", other, self)

    def __truediv__(self, other: Scalar) -> Trace:
        """Quotient."""
        return made("div", self, other)

    def __rtruediv__(self, other: Scalar) -> Trace:
        """Quotient, of a number."""
        return made("div", other, self)

    def __neg__(self) -> Trace:
        """Opposite."""
        return made("neg", self)


def made(*parts: Scalar) -> Trace:
    """What comes of an operation and its operands."""
    text = " ".join(part.mark if isinstance(part, Trace) else repr(part) for part in parts)
    return Trace(hashlib.sha256(text.encode()).hexdigest())


class TraceOps:
    """The recipe's operations, remembered."""

    def sin(self, x: Scalar, /) -> Trace:
        """Sine."""
        return made("sin", x)

    def cos(self, x: Scalar, /) -> Trace:
        """Cosine."""
        return made("cos", x)

    def sqrt(self, x: Scalar, /) -> Trace:
        """Square root."""
        return made("sqrt", x)

    def atan2(self, y: Scalar, x: Scalar, /) -> Trace:
        """Angle."""
        return made("atan2", y, x)

    def jacobian(self, values: Vector, variables: Vector, /) -> Matrix:
        """A derivative is told by what is differentiated by what."""
        return [[made("derivative", y, x) for x in variables] for y in values]

    def named(self, values: Vector, /) -> Vector:
        """A name is told from what it names."""
        return [made("named", value) for value in values]


def digest(kernel: Kernel, recipe: str) -> str:
    """Tells one recipe's operations from another's, however they are written down."""
    inputs = [Trace(name) for name in kernel.inputs]
    return made(*kernel.recipes[recipe](TraceOps(), inputs)).mark
