"""Targets against the evaluator: the right one passes, every kind of wrong one does not."""

import numpy as np
import pytest

from armillary import Derivation, number
from armillary.program.arithmetic import Floats
from armillary.program.compile import compile_kernel
from armillary.program.evaluate import evaluate, guard_status
from armillary.verify import parity
from armillary.verify.implementations import Implementation
from armillary.verify.points import rows_of
from tests.verify.systems import AIM, TWO_AXES, record_and_programs, write


def by_floats(programs, spoil=lambda kernel, row, results, status: (results, status)):
    """A target that runs the program in Python's floats; `spoil` breaks it."""

    def call(kernel, inputs):
        program = programs[kernel]
        columns = {o.name: [] for o in program.kernel.outputs}
        statuses = []
        for row in rows_of(inputs):
            status, results = guard_status(program.guards, row), {}
            if status == 0:
                answer = evaluate(program, row, Floats())
                status, results = answer.status, answer.results
            results, status = spoil(kernel, row, dict(results), status)
            statuses.append(status)
            for o in program.kernel.outputs:
                missing = np.full(o.shape, np.nan)
                columns[o.name].append(np.reshape(results.get(o.name, missing), o.shape))
        return {n: np.array(c) for n, c in columns.items()} | {"status": np.array(statuses)}

    return Implementation("floats f64", np.float64, call)


@pytest.fixture
def aim(tmp_path):
    return record_and_programs(write(tmp_path, aim=AIM), "aim")[1]


@pytest.fixture
def two_axes(tmp_path):
    return record_and_programs(write(tmp_path, two_axes=TWO_AXES), "two_axes")[1]


def compared(programs, kernel, implementation, tolerance=1e-14):
    return list(
        parity.compare_target(parity.Reference(programs[kernel]), implementation, tolerance)
    )


def test_a_right_target_passes(two_axes, aim):
    for programs in (two_axes, aim):
        for kernel in programs:
            values, statuses = compared(programs, kernel, by_floats(programs))
            assert values.passed, values
            assert values.worst > 0 or kernel == "aim"
            assert statuses.passed, statuses
            assert values.points > 60 or kernel == "aim"
            assert statuses.points > values.points


def test_an_error_in_one_entry_is_found(two_axes):
    def spoil(kernel, row, results, status):
        if "M" in results and row["a"] > 0:
            results["M"][7] += 1e-12
        return results, status

    values, statuses = compared(two_axes, "pose", by_floats(two_axes, spoil))
    assert not values.passed
    assert values.at["a"] > 0
    assert statuses.passed


def test_an_error_at_one_awkward_angle_is_found(two_axes):
    def spoil(kernel, row, results, status):
        if row["a"] == 999.0:
            results = {n: np.array(r) + 1e-9 for n, r in results.items()}
        return results, status

    values, _ = compared(two_axes, "pose", by_floats(two_axes, spoil))
    assert not values.passed
    assert values.at["a"] == 999.0


def test_whole_turns_make_no_difference(aim):
    def spoil(kernel, row, results, status):
        if results and results["azimuth"] > 0.1:
            results["azimuth"] -= 2 * np.pi
        return results, status

    values, _ = compared(aim, "aim", by_floats(aim, spoil))
    assert values.passed


def broken_status(change):
    def spoil(kernel, row, results, status):
        return change(results, status)

    return spoil


SOME = {"azimuth": 0.0, "elevation": 0.0}
BROKEN = {
    "a singular point called regular": lambda r, s: (r, 0 if s == 2 else s),
    "a refusal called success": lambda r, s: (SOME, 0) if s == -2 else (r, s),
    "not finite called out of range": lambda r, s: (r, -2 if s == -1 else s),
    "unreachable called singular": lambda r, s: (SOME, 2) if s == -3 else (r, s),
    "results beside a negative status": lambda r, s: (SOME, s) if s < 0 else (r, s),
    "success without results": lambda r, s: ({}, s),
}


@pytest.mark.parametrize("case", BROKEN)
def test_a_wrong_status_is_found(aim, case):
    spoil = broken_status(BROKEN[case])
    _, statuses = compared(aim, "aim", by_floats(aim, spoil))
    assert not statuses.passed
    assert statuses.why


def test_a_result_that_is_nan_is_found(aim):
    spoil = broken_status(lambda r, s: ({"azimuth": np.nan, "elevation": 0.0}, s))
    values, _ = compared(aim, "aim", by_floats(aim, spoil))
    assert not values.passed
    assert "not finite" in values.why


def test_what_a_target_raises_is_reported(aim):
    def call(kernel, inputs):
        raise RuntimeError("it broke")

    (made,) = compared(aim, "aim", Implementation("broken", np.float64, call))
    assert not made.passed
    assert made.why == "RuntimeError: it broke"


def test_a_wrong_shape_is_reported(two_axes):
    right = by_floats(two_axes)

    def call(kernel, inputs):
        found = right.call(kernel, inputs)
        return found | {"M": np.swapaxes(found["M"], 0, 1)}

    (made,) = compared(two_axes, "pose", Implementation("turned", np.float64, call))
    assert "shape" in made.why


def test_the_evaluator_itself_must_have_a_value(tmp_path):
    """A kernel that divides by zero at a legal point is wrong on every target."""
    text = (
        "from armillary import Derivation\n"
        'derivation = d = Derivation("bad", title="Bad")\n'
        't = d.angle("t", "an angle")\n'
        'd.kernel("k", inputs=[t], outputs={"r": 1 / t})\n'
    )
    _, programs = record_and_programs(write(tmp_path, bad=text), "bad")
    fine = Implementation(
        "any", np.float64, lambda k, i: {"r": np.ones_like(i["t"]), "status": np.zeros(len(i["t"]))}
    )
    values = compared(programs, "k", fine, tolerance=1e300)[0]
    assert not values.passed
    assert values.why.startswith("no real value")
    assert values.at == {"t": 0.0}


def test_a_kernel_that_reads_nothing_has_one_point():
    d = Derivation("demo", title="Demo")
    d.parameter.length("r", "not read")
    d.kernel("origin", inputs=[], outputs={"zero": number(0)})
    assert parity.Reference(compile_kernel(d.kernels["origin"]).program).points == {}
