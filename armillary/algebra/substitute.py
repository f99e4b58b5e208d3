"""Rebuilds an expression with some of its nodes replaced."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any, TypeVar

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.index import Index
from armillary.algebra.indexed import Closing, indices, is_leaf
from armillary.algebra.iteration import Iteration, with_fresh_unknowns
from armillary.algebra.misuse import MisuseError

N = TypeVar("N")
Replacements = Mapping[Any, Any]


def substitute(expression: N, replacements: Replacements) -> N:
    """The expression with symbols or defined values replaced, each wherever it stands.

    What does not change stays the same object, so shared values stay shared.

    Args:
        replacements: from a node, met by identity, to what takes its place: a scalar or a number
            for a scalar, a vector for a vector. A rotation is turned by other angles instead.
    """
    made: N = _Substitution(_checked(replacements))(expression)
    return made


def _checked(replacements: Replacements) -> dict[Any, Any]:
    found = {}
    for node, other in replacements.items():
        new = s.as_scalar(other) if isinstance(node, s.Scalar) else other
        if not any(isinstance(node, k) and isinstance(new, k) for k in (s.Scalar, v.Vector)):
            raise MisuseError(
                f"substitute puts a {type(other).__name__} for a {type(node).__name__}",
                "put a scalar for a scalar and a vector for a vector; "
                "for a rotation, replace its angles",
            )
        found[node] = new
    return found


class _Substitution:
    def __init__(self, replacements: dict[Any, Any]) -> None:
        self.replacements = replacements
        self.done: dict[int, tuple[Any, Any]] = {id(a): (a, b) for a, b in replacements.items()}
        self.opened = frozenset[Index]().union(
            *(indices(new) - indices(old) for old, new in replacements.items())
        )

    def __call__(self, node: Any) -> Any:
        known = self.done.get(id(node))
        if known is None:
            known = (node, self.rebuilt(node))  # the node is held, so its id stays its own
            self.done[id(node)] = known
        return known[1]

    def rebuilt(self, node: Any) -> Any:
        if isinstance(node, tuple):
            parts = tuple(self(p) for p in node)
            return parts if any(a is not b for a, b in zip(parts, node, strict=True)) else node
        if isinstance(node, Iteration):
            return self.iteration(node)
        plain = is_leaf(node) or isinstance(node, Index)
        if plain or not hasattr(node, "__dataclass_fields__"):
            return node
        values = {f.name: getattr(node, f.name) for f in fields(node)}
        changed = {name: new for name, old in values.items() if (new := self(old)) is not old}
        if not changed:
            return node
        if isinstance(node, (s.ScalarReference, v.VectorReference)):
            known = node.given.pairs if node.given else ()
            changed["given"] = s.Given((*known, *self.replacements.items()))
        if isinstance(node, Closing) and node.over in self.opened:
            raise MisuseError(
                f"what is put in runs over {node.over.name}, which is summed, or taken at one "
                "part, around it",
                "use another index for it",
            )
        return replace(node, **changed)

    def iteration(self, node: Iteration) -> Iteration:
        """A copy has unknowns of its own: it may stand in one kernel with the first."""
        parts = (node.start, node.following, node.residuals)
        if all(self(p) is p for p in parts):
            return node
        fresh = with_fresh_unknowns(node)
        inner = _Substitution({**self.replacements, **fresh})
        unknowns = tuple(fresh.values())
        following, residuals = inner(node.following), inner(node.residuals)
        return Iteration(node.turns, unknowns, self(node.start), following, residuals)
