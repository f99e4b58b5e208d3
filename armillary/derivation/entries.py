"""The scalars of a block, row by row: what is compared with what, entry by entry."""

from __future__ import annotations

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation
from armillary.derivation.statements import Block

Rows = tuple[tuple[s.Scalar, ...], ...]


def rows_of(block: Block) -> Rows:
    """The entries of a block: (1, 1) of a scalar, (3, 1) of a vector, (3, 3) of a rotation.

    A pose and a twist are their 4 by 4 matrices, a wrench is force over moment, and a condition
    is 1 where it holds, else 0.
    """
    if isinstance(block, s.Scalar):
        return ((block,),)
    if isinstance(block, s.Condition):
        return ((s.Select(block, s.ONE, s.ZERO),),)
    if isinstance(block, v.Vector):
        return _column(block)
    if isinstance(block, Rotation):
        columns = [block.column(j) for j in range(3)]
        return tuple(tuple(v.component(c, i) for c in columns) for i in range(3))
    if isinstance(block, Wrench):
        return _column(block.force) + _column(block.moment)
    matrix = block if isinstance(block, Matrix) else _matrix(block)
    return matrix.rows


def shape_of(block: Block) -> tuple[int, int]:
    """Rows and columns of a block's entries."""
    rows = rows_of(block)
    return len(rows), len(rows[0])


def _matrix(block: Pose | Twist) -> Matrix:
    return block.matrix()


def _column(vector: v.Vector) -> Rows:
    return tuple((v.component(vector, i),) for i in range(3))
