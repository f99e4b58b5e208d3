"""Puts a definition's name on its expression, so that later lines keep it."""

from __future__ import annotations

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation, RotationReference
from armillary.derivation.statements import Block


def named(name: str, identifier: str, expression: Block) -> Block:
    """The expression under its name; blocks carry the name on their parts."""
    if isinstance(expression, s.Scalar):
        return s.ScalarReference(name, identifier, expression)
    if isinstance(expression, v.Vector):
        return v.VectorReference(name, identifier, expression)
    if isinstance(expression, Rotation):
        return RotationReference(name, identifier, expression)
    if isinstance(expression, s.Condition):
        return s.ConditionReference(name, identifier, expression)
    if isinstance(expression, Pose):
        return Pose(
            RotationReference(f"{name}_R", identifier, expression.rotation),
            v.VectorReference(f"{name}_p", identifier, expression.position),
        )
    if isinstance(expression, Twist):
        return Twist(
            v.VectorReference(f"{name}_angular", identifier, expression.angular),
            v.VectorReference(f"{name}_linear", identifier, expression.linear),
        )
    if isinstance(expression, Wrench):
        return Wrench(
            v.VectorReference(f"{name}_moment", identifier, expression.moment),
            v.VectorReference(f"{name}_force", identifier, expression.force),
        )
    rows = tuple(
        tuple(_entry(name, identifier, i, j, entry) for j, entry in enumerate(row))
        for i, row in enumerate(expression.rows)
    )
    return Matrix(rows)


def _entry(name: str, identifier: str, i: int, j: int, entry: s.Scalar) -> s.Scalar:
    if isinstance(entry, s.Number):
        return entry
    return s.ScalarReference(f"{name}_{i + 1}{j + 1}", identifier, entry)


def latex_name(name: str) -> str:
    """The printed form of a code name: Omega_space, L_0, gamma_dot."""
    printed = str(sympy.latex(sympy.Symbol(name)))
    # A word in italics would read as a product of letters.
    return rf"\mathrm{{{name}}}" if printed == name and len(name) > 1 else printed


def rate_latex(latex: str) -> str:
    """The printed form of the time derivative: a dot, or the second one over the first."""
    dotted = latex.startswith("\\dot{") and latex.endswith("}")
    return f"\\d{latex[1:]}" if dotted else f"\\dot{{{latex}}}"
