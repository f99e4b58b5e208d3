"""Products of joints as they are printed, with one factor changed or elsewhere."""

from __future__ import annotations

from collections.abc import Iterator

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Pose
from armillary.algebra.rotation import Elementary
from armillary.mechanism.chain import Chain, Shift, Step, Turn
from armillary.verify.audit.changes import RANKS, Change, Changes
from armillary.verify.audit.plain import plain

Steps = tuple[Step, ...]


def pose_of(steps: Steps) -> Pose:
    """What a product of joints multiplies out to."""
    return Chain("first", steps, {"last": len(steps)}).pose("first", "last")


def orders(steps: Steps) -> Iterator[tuple[Steps, str]]:
    """The product with two neighbours exchanged, then with one factor moved elsewhere."""
    for k in range(len(steps) - 1):
        swapped = (*steps[:k], steps[k + 1], steps[k], *steps[k + 2 :])
        yield swapped, f"{told(steps[k])} and {told(steps[k + 1])} exchanged"
    for k, step in enumerate(steps):
        rest = (*steps[:k], *steps[k + 1 :])
        for at in range(len(rest) + 1):
            if abs(at - k) > 1:
                where = f"before {told(rest[at])}" if at < len(rest) else "at the end"
                yield (*rest[:at], step, *rest[at:]), f"{told(step)} moved to stand {where}"


def misprints(steps: Steps, changes: Changes) -> list[Change]:
    """Single changes of a printed product; the node of each is its pose."""
    made: list[Change] = []
    for k, step in enumerate(steps):
        for change in _of_step(step, changes):
            pose = pose_of((*steps[:k], change.node, *steps[k + 1 :]))
            made.append(Change(change.kind, change.words, change.rank, pose))
    for swapped, words in orders(steps):
        rank = RANKS["order of factors"]
        made.append(Change("order of factors", words, rank, pose_of(swapped)))
    return sorted(made, key=lambda change: change.rank)


def told(step: Step) -> str:
    """A factor in plain words: Rx(-upsilon), Tz(L_0)."""
    if isinstance(step, Turn):
        return f"R{v.AXIS_NAMES[step.axis]}({plain(step.angle)})"
    scale, axis = _along(step)
    return f"T({plain(step.offset)})" if axis is None else f"T{v.AXIS_NAMES[axis]}({plain(scale)})"


def _of_step(step: Step, changes: Changes) -> Iterator[Change]:
    if isinstance(step, Turn):
        for change in changes.turn(Elementary(step.axis, step.angle)):
            yield Change(
                change.kind, change.words, change.rank, Turn(change.node.axis, change.node.angle)
            )
        return
    scale, axis = _along(step)
    for change in changes.vector_sum(step.offset, top=True):
        yield Change(change.kind, change.words, change.rank, Shift(change.node))
    if axis is not None:
        for other in range(3):
            if other != axis:
                words = f"axis {v.AXIS_NAMES[other]} for {v.AXIS_NAMES[axis]} of {told(step)}"
                yield Change("axis", words, RANKS["axis"], Shift(v.scale(scale, v.Basis(other))))


def _along(step: Shift) -> tuple[s.Scalar, int | None]:
    """Distance and axis of a shift; None for one that follows no axis."""
    offset = step.offset
    if isinstance(offset, v.VectorNegate):
        scale, axis = _along(Shift(offset.argument))
        return s.negate(scale), axis
    if isinstance(offset, v.Basis):
        return s.ONE, offset.axis
    if isinstance(offset, v.Scaled) and isinstance(offset.vector, v.Basis):
        return offset.factor, offset.vector.axis
    return s.ONE, None
