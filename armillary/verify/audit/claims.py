"""What a print may stand for instead: the derived side, changed.

Its negative, its transpose, the same vector in another frame, another definition of the same
system, or the printed product with its factors in another order.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.indexed import indices
from armillary.algebra.rigid import Pose
from armillary.algebra.rotation import Rotation
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
    if sides.shape == (1, 1) and sides.bench.turns(derived[0][0]):
        yield from _complements(derived[0][0])
    yield from _elsewhere(equation, paper, sides.shape)
    yield from _of_other_products(equation, sides)


def _complements(angle: s.Scalar) -> Iterator[Claim]:
    """An angle counted from elsewhere: from the zenith, from the south, the other way round."""
    half = s.divide(s.PI, s.number(2))
    for words, other in (
        ("90 deg less what is derived", half - angle),
        ("what is derived less 90 deg", angle - half),
        ("what is derived and 90 deg more", angle + half),
        ("what is derived and 180 deg more", angle + s.PI),
        ("180 deg less what is derived", s.PI - angle),
    ):
        yield Claim("definition", words, ((other,),))


def instead(equation: Equation, paper: Paper) -> list[Block]:
    """All blocks that the claim may be replaced with: their quantities are needed to try them."""
    near: list[Block] = [d.value for d in _near(equation.claims, paper)]
    near += [rotation for _, rotation in _frames(equation, paper)]
    near += [other for meant in equation.meant for _, other in meant.names]
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
        for name, rotation in _frames(equation, paper):
            back = rows_of(rotation.transpose() @ equation.claims)
            out = rows_of(rotation @ equation.claims)
            found.append(("frame", f"what is derived, turned by the transpose of {name}", back))
            found.append(("frame", f"what is derived, turned by {name}", out))
    for kind, words, rows in found:
        yield Claim(kind, words, rows)
    for kind, words, rows in found:
        yield Claim(kind, f"minus {words}", negated(rows), 2)


def _frames(equation: Equation, paper: Paper) -> list[tuple[str, Rotation]]:
    """The rotations that are given, then those that the claim's own system defines."""
    found = list(equation.frames)
    home = _home(equation.claims, paper)
    for definition in home.definitions.values() if home is not None else ():
        value = definition.value
        if isinstance(value, Pose):
            found.append((f"the rotation of {definition.identifier}", value.rotation))
        elif isinstance(value, Rotation):
            found.append((definition.identifier, value))
    return found


def _home(claim: Block, paper: Paper) -> Derivation | None:
    """The system whose definition a claim is."""
    own = claimed(claim, paper)
    return next((d for d in _systems(paper) if own in d.definitions.values()), None)


def _near(claim: Block, paper: Paper) -> list[Definition]:
    """The other definitions of the claim's own system, of its unit."""
    own, home = claimed(claim, paper), _home(claim, paper)
    if own is None or home is None or (isinstance(claim, s.Scalar) and claim is not own.value):
        return []
    opened = indices(claim)
    return [
        d for d in home.definitions.values()
        if d is not own and d.unit == own.unit and not isinstance(d.value, s.Condition)
        and indices(d.value) <= opened
    ]  # fmt: skip


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
