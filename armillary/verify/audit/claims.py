"""What a print may stand for instead: the derived side, changed.

Its negative, its transpose, the same vector in another frame, another definition of the same
system, or the printed product with its factors in another order.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Pose
from armillary.derivation.entries import Rows, rows_of, shape_of
from armillary.derivation.paper import Equation, Paper
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Block, Definition
from armillary.verify.audit.products import orders, pose_of
from armillary.verify.audit.sides import Place, Sides, blocks, negated, transposed
from armillary.verify.audit.walking import REFERENCES, parts


@dataclass(frozen=True, eq=False)
class Claim:
    """Something else that a print may stand for."""

    kind: str
    words: str
    derived: Rows
    size: int = 1


def other_claims(sides: Sides, equation: Equation, paper: Paper) -> Iterator[Claim]:
    """The simplest first: those that a slip of one sign or of rows and columns would make."""
    derived = sides.derived
    rows, columns = sides.shape
    if sides.shape != (1, 1):
        yield Claim("sign", "the negative of what is derived", negated(derived))
    if rows == columns and rows > 1:
        yield Claim("transposition", "the transpose of what is derived", transposed(derived))
        if isinstance(equation.claims, Pose):
            inverse = rows_of(equation.claims.inverse())
            yield Claim("transposition", "the inverse of what is derived", inverse)
    yield from _elsewhere(equation, paper, sides.shape)
    yield from _of_other_products(equation, sides)


def instead(equation: Equation, paper: Paper) -> list[Block]:
    """All blocks that the claim may be replaced with: their quantities are needed to try them."""
    near: list[Block] = [d.value for d in _near(equation.claims, paper)]
    near += [rotation for _, rotation in equation.frames]
    return near if equation.product is None else [*near, pose_of(equation.product.steps)]


def claimed(claim: Block, paper: Paper) -> Definition | None:
    """The definition that a claim is, or the first that it names; none of the paper's own."""
    found = paper.definition_of(claim)
    known = {
        d.identifier: d for system in _systems(paper) for d in system.definitions.values()
        if system is not paper
    }  # fmt: skip
    if found is not None and found.identifier in known:
        return found
    named = (part.identifier for part in parts(claim) if isinstance(part, REFERENCES))
    return next((known[name] for name in named if name in known), None)


def _elsewhere(equation: Equation, paper: Paper, shape: Place) -> Iterator[Claim]:
    """Other definitions first, because they have names; then the claim seen from other frames."""
    vector = isinstance(equation.claims, v.Vector)
    near = [d for d in _near(equation.claims, paper) if shape_of(d.value) == shape]
    found = [
        ("frame" if vector else "definition", _told(d), rows_of(d.value)) for d in near
    ]  # fmt: skip
    if isinstance(equation.claims, v.Vector):
        for name, rotation in equation.frames:
            back = rows_of(rotation.transpose() @ equation.claims)
            out = rows_of(rotation @ equation.claims)
            found.append(("frame", f"what is derived, turned by the transpose of {name}", back))
            found.append(("frame", f"what is derived, turned by {name}", out))
    for kind, words, rows in found:
        yield Claim(kind, words, rows)
    for kind, words, rows in found:
        yield Claim(kind, f"minus {words}", negated(rows), 2)


def _near(claim: Block, paper: Paper) -> list[Definition]:
    """The other definitions of the claim's own system, of its unit."""
    own = claimed(claim, paper)
    if own is None or (isinstance(claim, s.Scalar) and not _is_whole(claim, own)):
        return []
    home = next(d for d in _systems(paper) if d.definitions.get(own.name) is own)
    return [
        d for d in home.definitions.values()
        if d is not own and d.unit == own.unit and not isinstance(d.value, s.Condition)
    ]  # fmt: skip


def _is_whole(claim: Block, own: Definition) -> bool:
    return claim is own.value


def _systems(paper: Derivation) -> list[Derivation]:
    found: dict[int, Derivation] = {id(paper): paper}
    for used in paper.used.values():
        for system in _systems(used.derivation):
            found[id(system)] = system
    return list(found.values())


def _told(definition: Definition) -> str:
    meaning = f", {definition.meaning}" if definition.meaning else ""
    return f"{definition.identifier}{meaning}"


def _of_other_products(equation: Equation, sides: Sides) -> Iterator[Claim]:
    if equation.product is None:
        return
    where = blocks(sides.shape, sides.bad) or "it"
    for steps, words in orders(equation.product.steps):
        pose = pose_of(steps)
        if sides.shape == (4, 4):
            rows = rows_of(pose)
        elif sides.shape == (3, 3):
            rows = rows_of(pose.rotation)
        elif sides.shape == (3, 1):
            rows = rows_of(pose.position)
        else:
            return
        yield Claim("order of factors", f"{where} belongs to the product with {words}", rows)
