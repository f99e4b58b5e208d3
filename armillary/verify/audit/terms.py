"""Sums taken apart into terms, products into factors, and put together again."""

from __future__ import annotations

from armillary.algebra import scalar as s
from armillary.algebra import vector as v


def terms_of(node: s.Scalar) -> list[tuple[bool, s.Scalar]]:
    """The terms of a sum, and whether each is subtracted; brackets stay terms."""
    if isinstance(node, s.Add):
        return terms_of(node.left) + terms_of(node.right)
    if isinstance(node, s.Negate):
        return [(True, node.argument)]
    parts = factors_of(node)
    minus = [part for part in parts if isinstance(part, s.Negate)]
    if not minus:
        return [(False, node)]
    # -a b is written as (-a) b: the sign is the term's.
    bare = [part.argument if isinstance(part, s.Negate) else part for part in parts]
    return [(len(minus) % 2 == 1, multiplied(bare))]


def factors_of(node: s.Scalar) -> list[s.Scalar]:
    """The factors of a product, from left to right."""
    if isinstance(node, s.Multiply):
        return factors_of(node.left) + factors_of(node.right)
    return [node]


def vector_terms(node: v.Vector) -> list[tuple[bool, v.Vector]]:
    """The terms of a sum of vectors, and whether each is subtracted."""
    if isinstance(node, v.VectorSum):
        return vector_terms(node.left) + vector_terms(node.right)
    return [(True, node.argument)] if isinstance(node, v.VectorNegate) else [(False, node)]


def summed(terms: list[tuple[bool, s.Scalar]]) -> s.Scalar:
    """The sum of terms, of which some are subtracted."""
    total: s.Scalar = s.ZERO
    for negative, term in terms:
        total = s.add(total, s.negate(term) if negative else term)
    return total


def vectors_summed(terms: list[tuple[bool, v.Vector]]) -> v.Vector:
    """The same of vectors."""
    total: v.Vector = v.NULL
    for negative, term in terms:
        total = v.add_vectors(total, v.negate_vector(term) if negative else term)
    return total


def multiplied(parts: list[s.Scalar]) -> s.Scalar:
    """The product of factors in their order."""
    product: s.Scalar = s.ONE
    for part in parts:
        product = s.multiply(product, part)
    return product
