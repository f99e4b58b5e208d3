"""Properties of printed matrices, and of sentences that name one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from armillary.derivation.entries import Rows
from armillary.verify.audit.compare import CLOSE, DIGITS, Bench
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.sides import Sides

_SEEN = 1e-52
_SCALES = ("1e-6", "1e-8")


def stacked(values: Values, rows: Rows) -> Any:
    """The matrices of some rows of entries: (n, rows, columns)."""
    return np.stack(
        [np.stack([values.array(entry) for entry in row], axis=-1) for row in rows], axis=-2
    )


def rotation_of(rows: Rows) -> Rows | None:
    """The part of a matrix that would be a rotation; None where there is none."""
    if len(rows) not in (3, 4) or len(rows) != len(rows[0]):
        return None
    return tuple(row[:3] for row in rows[:3])


def not_orthonormal(sides: Sides) -> str:
    """What a print lacks of a rotation where one is derived; empty where it lacks nothing."""
    printed, derived = rotation_of(sides.printed), rotation_of(sides.derived)
    if printed is None or derived is None:
        return ""
    bench = sides.bench
    if not largest(orthonormality(bench.widest, derived)) <= CLOSE:
        return ""
    defect = largest(orthonormality(bench.widest, printed))
    if defect <= CLOSE:
        return ""
    told = f"not orthonormal: R^T R differs from the identity by up to {defect:.2g}"
    order = order_of(bench, lambda values: orthonormality(values, printed))
    if order is None:
        return told
    held = f"orthonormal to order {order}" if order >= 0 else "not even where they are 0"
    small = ", ".join(q.name for q in bench.small)
    return f"{told} ({held} in {small})"


def orthonormality(values: Values, rows: Rows) -> Any:
    """The largest entry of R^T R - 1 at each point."""
    with np.errstate(all="ignore"):
        matrices = stacked(values, rows)
        product = (matrices[:, :, :, None] * matrices[:, :, None, :]).sum(axis=1)
        return abs(product - np.eye(3, dtype=int)).max(axis=(1, 2))


def order_of(bench: Bench, defect: Callable[[Values], Any]) -> int | None:
    """Order of a defect in the small quantities, less one; None without small quantities."""
    if not bench.small:
        return None
    large, little = (defect(values) for values in bench.shrinking)
    mp = DIGITS.mp
    slopes = [
        float(mp.log10(a / max(b, mp.mpf("1e-70")))) / 2
        for a, b in zip(large, little, strict=True)
        if a > mp.mpf(_SEEN)
    ]
    return round(min(slopes)) - 1 if slopes else None


def largest(numbers: Any) -> float:
    """The largest finite one, 0 for none."""
    finite = np.asarray(numbers, dtype=float)
    finite = finite[np.isfinite(finite)]
    return float(finite.max()) if len(finite) else 0.0


# -- words -------------------------------------------------------------------------------------


def violations(word: str, values: Values, rows: Rows) -> Any:
    """By how much matrices lack a property, at each point."""
    matrices = np.asarray(stacked(values, rows), dtype=float)
    if word == "singular":
        return np.abs(np.linalg.det(matrices))
    if word == "orthogonal":
        count = matrices.shape[-1]
        return np.abs(matrices.transpose(0, 2, 1) @ matrices - np.eye(count)).max(axis=(1, 2))
    if word == "symmetric":
        return np.abs(matrices - matrices.transpose(0, 2, 1)).max(axis=(1, 2))
    if word == "skew-symmetric":
        return np.abs(matrices + matrices.transpose(0, 2, 1)).max(axis=(1, 2))
    apart = matrices * (1 - np.eye(matrices.shape[-1]))
    return np.abs(apart).max(axis=(1, 2))


def determinant_range(values: Values, rows: Rows) -> tuple[float, float]:
    """Least and largest determinant."""
    found = np.linalg.det(np.asarray(stacked(values, rows), dtype=float))
    return float(found.min()), float(found.max())


def rank(values: Values, columns: list[Any]) -> tuple[int, int]:
    """Least and largest rank of matrices given by columns of three scalars."""
    rows: Rows = tuple(tuple(column[i] for column in columns) for i in range(3))
    found = np.linalg.matrix_rank(np.asarray(stacked(values, rows), dtype=float), tol=1e-6)
    return int(found.min()), int(found.max())
