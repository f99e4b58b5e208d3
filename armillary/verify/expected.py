"""What a kernel must answer at a point: by the evaluator at 50 digits, on the rounded inputs.

A target computes in floating point, so no formula can be held to be closer than what one rounding
of its inputs would change. That change is measured too, by moving the inputs by one rounding, and
an error counts relative to it where it is larger than the result itself: the azimuth near the
zenith may be worse than a length, and neither tolerance hides the other.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import mpmath
import numpy as np

from armillary.derivation.statements import Output
from armillary.derivation.units import ONE
from armillary.program.arithmetic import Reals
from armillary.program.evaluate import guard_status
from armillary.program.guards import Guard
from armillary.program.program import Program
from armillary.verify import exact

_TINY = 1e-30  # of a result that is zero and stays zero, any error is too much
_MOVES = 2


@dataclass(frozen=True)
class Entry:
    """One result at one point: exact entries, row-major, and what errors are relative to."""

    values: tuple[Any, ...]
    scale: float
    turn: bool

    def error(self, found: Sequence[float]) -> float:
        """The largest error of the entries, relative to the scale; NaN if one is not finite."""
        worst = 0.0
        for f, wanted in zip(found, self.values, strict=True):
            if not np.isfinite(f):
                return float("nan")
            worst = max(worst, float(_distance(mpmath.mpf(float(f)), wanted, self.turn)))
        return worst / self.scale


@dataclass(frozen=True)
class Expected:
    """The answer at one point.

    Attributes:
        status: what the evaluator says.
        statuses: all that may be answered, because a rounding of the inputs would give them.
        entries: by result; empty where the status is negative.
        fault: why the evaluator itself could not answer; then the kernel is wrong, not the target.
    """

    status: int
    statuses: frozenset[int]
    entries: dict[str, Entry]
    fault: str = ""


def expect(program: Program, row: exact.Row, epsilon: float, reals: Reals) -> Expected:
    """What is expected at one point.

    Args:
        row: inputs, already rounded to the target's precision.
        epsilon: the target's rounding unit, 2^-52 or 2^-23.
    """
    guarded = {guard_status(_widened(program.guards, w * epsilon), row) for w in (-2, 0, 2)}
    refused = guard_status(program.guards, row)
    if refused < 0 and guarded == {refused}:
        return Expected(refused, frozenset({refused}), {})
    try:
        answer = exact.run(program, row, reals)
        values = {name: _reals(value) for name, value in answer.results.items()}
    except (ZeroDivisionError, TypeError, ValueError) as problem:
        return Expected(
            refused, frozenset(guarded), {}, f"no real value: {str(problem) or 'a division by 0'}"
        )
    moved = _moved(program, row, epsilon, reals)
    statuses = {answer.status, *(status for status, _ in moved), *(g for g in guarded if g < 0)}
    if refused < 0:
        return Expected(refused, frozenset(statuses), {})
    entries = {
        output.name: _entry(output, values[output.name], moved, epsilon)
        for output in program.kernel.outputs
        if output.name in values
    }
    return Expected(answer.status, frozenset(statuses), entries)


def is_angle(output: Output) -> bool:
    """Whether whole turns make no difference to a result."""
    return output.unit is not None and output.unit.agrees(ONE) and output.unit.angle == 1


Moved = list[tuple[int, dict[str, list[Any]]]]


def _entry(output: Output, values: list[Any], moved: Moved, epsilon: float) -> Entry:
    turn = is_angle(output)
    scale = max([_TINY, *(float(abs(v)) for v in values)])
    for _, others in moved:
        if output.name in others:
            pairs = zip(others[output.name], values, strict=True)
            change = max(float(_distance(a, b, turn)) for a, b in pairs)
            scale = max(scale, change / epsilon)
    return Entry(tuple(values), scale, turn)


def _moved(program: Program, row: exact.Row, epsilon: float, reals: Reals) -> Moved:
    """Answers at inputs that are off by about one rounding."""
    found: Moved = []
    for k in range(_MOVES):
        stream = np.random.default_rng([6, k])
        near = {name: _nudged(value, epsilon, stream) for name, value in row.items()}
        try:
            answer = exact.run(program, near, reals)
            values = {name: _reals(value) for name, value in answer.results.items()}
        except (ZeroDivisionError, TypeError, ValueError):
            continue  # the point itself has a value: that is what counts
        found.append((answer.status, values))
    return found


def _nudged(value: Any, epsilon: float, stream: np.random.Generator) -> Any:
    if isinstance(value, list):
        return [_nudged(c, epsilon, stream) for c in value]
    way = 1.0 if stream.random() < 0.5 else -1.0
    # At 50 digits, so that a step below the spacing of floats is a step all the same.
    with mpmath.workdps(60):
        return mpmath.mpf(value) + way * mpmath.mpf(epsilon) * max(1.0, abs(value))


def _widened(guards: Sequence[Guard], by: float) -> list[Guard]:
    """The guards with both bounds moved outward.

    A target rounds a bound such as 0.1 to its own precision, and refuses accordingly.
    """
    return [replace(g, low=g.low - by * abs(g.low), high=g.high + by * abs(g.high)) for g in guards]


def _reals(value: Any) -> list[Any]:
    found = exact.flat(value)
    for number in found:
        if not hasattr(number, "_mpf_"):
            raise ValueError(f"{number} is not a real number")
        if not mpmath.isfinite(number):
            raise ValueError(f"{number} is not finite")
    return found


def _distance(a: Any, b: Any, turn: bool) -> Any:
    with mpmath.workdps(60):
        difference = mpmath.mpf(a) - mpmath.mpf(b)
        if turn:
            difference -= 2 * mpmath.pi * mpmath.nint(difference / (2 * mpmath.pi))
        return abs(difference)
