"""Every target against the evaluator: values to a committed tolerance, statuses to the number."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from armillary.program.arithmetic import Reals
from armillary.program.program import Program
from armillary.verify.expected import Expected, expect
from armillary.verify.implementations import Implementation, Inputs, Results
from armillary.verify.measured import Measured, Point, exceeds
from armillary.verify.points import (
    awkward_points,
    count,
    illegal_points,
    joined,
    random_points,
    rows_of,
)

POINTS = 60
VALUES = "agrees with the evaluator at 50 digits"
STATUSES = "answers with the evaluator's status"

Array = NDArray[Any]


class Reference:
    """One kernel's exact answers, computed once for each precision."""

    def __init__(self, program: Program, points: int = POINTS) -> None:
        self.program = program
        kernel, used = program.kernel, program.inputs_used()
        unread = [q for q in kernel.parameters if q.name not in used]
        # What a kernel does not read has no awkward value, and none that it could refuse.
        read = replace(kernel, parameters=tuple(q for q in kernel.parameters if q not in unread))
        awkward = joined(awkward_points(read), illegal_points(read))
        idle = random_points(unread, count(awkward), seed=8)
        legal = random_points(kernel, points, seed=7)
        # A kernel that reads nothing has one answer, however long the arrays it is given.
        self.points = joined(legal, {**awkward, **idle}) if awkward else {}
        self._known: dict[type[Any], tuple[dict[str, Array], list[Expected]]] = {}

    def at(self, implementation: Implementation) -> tuple[dict[str, Array], list[Expected]]:
        """The points rounded to a target's precision, and the answers there."""
        dtype = implementation.dtype
        if dtype not in self._known:
            with np.errstate(over="ignore", invalid="ignore"):
                rounded = {name: array.astype(dtype) for name, array in self.points.items()}
            reals = Reals()
            epsilon = implementation.epsilon
            answers = [expect(self.program, r, epsilon, reals) for r in rows_of(rounded)]
            self._known[dtype] = (rounded, answers)
        return self._known[dtype]


def compare_target(
    reference: Reference, implementation: Implementation, tolerance: float, why: str = ""
) -> Iterator[Measured]:
    """Two checks of one kernel on one target: its values, then its statuses."""
    name = reference.program.kernel.name
    inputs, answers = reference.at(implementation)
    try:
        found = implementation.call(name, inputs)
        _well_formed(found, reference, len(answers))
    except Exception as problem:  # whatever a target raises is what is reported
        nan = float("nan")
        text = f"{type(problem).__name__}: {problem}"
        yield Measured(VALUES, implementation.name, name, 0, nan, tolerance, {}, text)
        return
    yield _values(reference, implementation, inputs, answers, found, tolerance, why)
    yield _statuses(reference, implementation, inputs, answers, found)


def _well_formed(found: Results, reference: Reference, n: int) -> None:
    shapes = {"status": (), **{o.name: o.shape for o in reference.program.kernel.outputs}}
    for name, shape in shapes.items():
        if name not in found:
            raise KeyError(f"the target returns no {name}")
        wanted = (n, *shape) if reference.points else shape
        if found[name].shape != wanted:
            raise ValueError(f"{name} has the shape {found[name].shape}, not {wanted}")


def _values(
    reference: Reference,
    implementation: Implementation,
    inputs: Inputs,
    answers: list[Expected],
    found: Results,
    tolerance: float,
    why: str,
) -> Measured:
    worst, compared = 0.0, 0
    at: Point = {}
    for k, row in enumerate(rows_of(inputs)):
        answer = answers[k]
        if answer.fault:
            worst, at, why = float("nan"), row, answer.fault
            break
        if int(_at(found["status"], k)) != answer.status or answer.status < 0:
            continue  # the statuses have a check of their own
        compared += 1
        for name, entry in answer.entries.items():
            error = entry.error(np.ravel(_at(found[name], k)).astype(float).tolist())
            if exceeds(error, worst):
                worst, at = error, row
        if math.isnan(worst):
            why = "a result is not finite"
            break
    return Measured(
        VALUES, implementation.name, reference.program.kernel.name, compared, worst, tolerance,
        at, why,
    )  # fmt: skip


def _statuses(
    reference: Reference,
    implementation: Implementation,
    inputs: Inputs,
    answers: list[Expected],
    found: Results,
) -> Measured:
    wrong = 0
    at: Point = {}
    why = ""
    for k, row in enumerate(rows_of(inputs)):
        status = int(_at(found["status"], k))
        problem = ""
        if status not in answers[k].statuses:
            problem = f"status {status}, expected {answers[k].status}"
        elif not _as_status_says(status, found, k):
            problem = f"status {status}, but the results say otherwise"
        if problem:
            wrong += 1
            at, why = (at, why) if wrong > 1 else (row, problem)
    return Measured(
        STATUSES, implementation.name, reference.program.kernel.name, len(answers), float(wrong),
        0.0, at, why,
    )  # fmt: skip


def _as_status_says(status: int, found: Results, k: int) -> bool:
    """NaN where the status is negative, finite everywhere else."""
    test = np.isnan if status < 0 else np.isfinite
    return all(bool(np.all(test(_at(a, k)))) for n, a in found.items() if n != "status")


def _at(array: Array, k: int) -> Any:
    return array[k] if array.ndim else array


def tolerance_of(
    known: Mapping[str, Mapping[str, float]], kernel: str, implementation: Implementation
) -> float | None:
    """The committed tolerance of a kernel on a target, if there is one."""
    return known.get(kernel, {}).get(implementation.key)
