"""What a kernel must answer: the evaluator at 50 digits, after the guards."""

from dataclasses import replace

import numpy as np

from armillary.program.arithmetic import Reals
from armillary.program.evaluate import evaluate, guard_status
from armillary.verify.expected import expect
from armillary.verify.points import random_points, rows_of

ROUNDINGS = 64
NAN, INF = float("nan"), float("inf")


def read_quantities(program):
    """What the results depend on, and every input."""
    kernel, used = program.kernel, program.inputs_used()
    return [*kernel.inputs, *(q for q in kernel.parameters if q.name in used)]


def points(program, count, dtype=np.float64, seed=3):
    """Random points of the working range, or as the kernel draws them, in a precision."""
    kernel, wanted = program.kernel, read_quantities(program)
    read = replace(kernel, parameters=tuple(q for q in kernel.parameters if q in wanted))
    return {n: a.astype(dtype) for n, a in random_points(read, count, seed).items()}


def spoilt(program, count, dtype=np.float64, seed=4):
    """The same, every other point with one fault in one argument."""
    found = points(program, count, dtype, seed)
    stream = np.random.default_rng(seed)
    wanted = read_quantities(program)
    for row in range(0, count if wanted else 0, 2):
        q = wanted[row // 2 % len(wanted)]
        low, high = q.facts.limits
        faults = (NAN, INF, -INF, 2 * high + 1, low - abs(low) - 1, 1e30)
        place = found[q.name]
        if q.shape:
            place[row, stream.integers(q.shape[0])] = stream.choice(faults)
        else:
            place[row] = stream.choice(faults)
    return found


def answers(program, inputs, count):
    """(status, {result: flat list}) at each point."""
    reals = Reals()
    rows = list(rows_of(inputs)) if inputs else [{}] * count
    return [_answer(program, row, reals) for row in rows]


def _answer(program, row, reals):
    status = guard_status(program.guards, row)
    if status < 0:
        return status, {}
    exact = {
        n: [reals.number(c) for c in x] if isinstance(x, list) else reals.number(x)
        for n, x in row.items()
    }
    answer = evaluate(program, exact, reals)
    flat = {n: x if isinstance(x, list) else [x] for n, x in answer.results.items()}
    return answer.status, flat


def agree(program, result, expected, inputs, dtype=np.float64):
    """A call's results are the exact ones to a few roundings of the result's largest entry.

    Near a singularity a rounding of the inputs alone moves them by more: then to as many of that.
    """
    assert np.asarray(result.status).dtype == np.int8
    statuses = np.atleast_1d(np.asarray(result.status)).tolist()
    assert statuses == [status for status, _ in expected], program.name
    for output in program.kernel.outputs:
        array = np.asarray(getattr(result, output.name))
        assert array.dtype == dtype
        rows = array.reshape(len(expected), -1)
        refused = np.array(statuses) < 0
        assert np.isnan(rows[refused]).all(), program.name
        exact = [wanted[output.name] for status, wanted in expected if status >= 0]
        scale = max(1.0, *(abs(float(x)) for row in exact for x in row), 0.0)
        for k, wanted in zip(np.flatnonzero(~refused), exact, strict=True):
            worst = max(abs(float(x - float(a))) for x, a in zip(wanted, rows[k], strict=True))
            bound = ROUNDINGS * float(np.finfo(dtype).eps) * scale
            if worst > bound:
                bound *= _moved(program, inputs, k, output.name, dtype) / scale
            assert worst <= bound, f"{program.name}.{output.name}: {worst}"


def _moved(program, inputs, k, name, dtype):
    """By how many roundings a result moves where the inputs move by one."""
    row = list(rows_of(inputs))[k]
    return expect(program, row, float(np.finfo(dtype).eps), Reals()).entries[name].scale
