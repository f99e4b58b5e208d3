"""A set-up and the steps after it, compiled: the answers of the undivided kernel."""

import ctypes
import functools

import numpy as np
import pytest

from armillary.derivation.status import Status
from tests.targets.compilers import needs
from tests.targets.reference import ROUNDINGS, points

pytestmark = [pytest.mark.tool, needs("gcc")]
STEPS, MOUNTS = 7, 40


def one_mount(printed, system, name, dtype):
    """Arguments of a set-up that is accepted, the context it made, and of some steps after it."""
    stages = printed.stages[system, name]
    given = points(printed.compiled[system, name].program, MOUNTS, dtype)
    kernel = stages.setup.kernel
    mount = {q.name for q in (*kernel.inputs, *kernel.parameters)}
    mount -= {q.name for q in (*stages.step.kernel.inputs, *stages.step.kernel.parameters)}
    setup = getattr(getattr(printed.module("native"), system), f"{name}_setup")
    # What a mount is of need not fit together where each part is drawn from its range.
    for row in range(MOUNTS):
        read = {n: a[row] for n, a in given.items() if n in mount}
        context = setup(**read)
        if context.status >= 0:
            moving = np.roll(np.arange(MOUNTS), -row)[:STEPS]
            return read, context, {n: a[moving] for n, a in given.items() if n not in mount}
    pytest.fail(f"{system}.{name}_setup refuses each of {MOUNTS} mounts")


def refusals(printed, system, name, dtype):
    """What a step says of a context, told by what was done to it."""
    compiled = getattr(printed.module("native"), system)
    mount, context, moving = one_mount(printed, system, name, dtype)
    step = functools.partial(getattr(compiled, f"{name}_step"), context, **moving)
    before, mark = context.memory.raw, ctypes.sizeof(ctypes.c_ulong)
    assert (step().status == getattr(compiled, name)(**mount, **moving).status).all()
    # Memory that was never set up; all but the mark; a mark that is off by a bit.
    off = bytes([before[0] ^ 1]) + before[1:]
    for memory in (bytes(len(before)), b"\xff" * len(before), bytes(mark) + before[mark:], off):
        context.memory.raw = memory
        yield step()
    # The set-up of another mount, refused.
    context.memory.raw = before
    wrong = {q: np.full_like(value, np.nan) for q, value in mount.items()}
    again = getattr(compiled, f"{name}_setup")
    context.memory.raw = set_up_into(printed, again, context, wrong, before)
    yield step()


def set_up_into(printed, setup, context, mount, before):
    """The memory of a context after another set-up of it that is refused."""
    native = printed.module("native")
    with pytest.MonkeyPatch.context() as patch:
        memory = ctypes.create_string_buffer(before, len(before))
        patch.setattr(native.ctypes, "create_string_buffer", lambda size: memory)
        assert setup(**mount).status == Status.NOT_FINITE
    assert memory.raw != before
    return memory.raw


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_a_step_refuses_a_context_that_is_not_ready(printed, dtype):
    for system, name in printed.stages:
        for answer in refusals(printed, system, name, dtype):
            assert (answer.status == Status.OUT_OF_RANGE).all(), (system, name)
            assert all(np.isnan(value).all() for value in answer[:-1]), (system, name)


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_steps_answer_like_the_kernel(printed, dtype):
    native = printed.module("native")
    assert printed.stages
    for system, name in printed.stages:
        compiled = getattr(native, system)
        mount, context, moving = one_mount(printed, system, name, dtype)
        assert (context.status, context.precision) == (0, "f32" if dtype == np.float32 else "f64")
        found = getattr(compiled, f"{name}_step")(context, **moving)
        like = getattr(compiled, name)(**mount, **moving)
        assert found._fields == like._fields
        assert np.array_equal(found.status, like.status)
        for a, b in zip(found[:-1], like[:-1], strict=True):
            assert (a.dtype, a.shape) == (b.dtype, b.shape)
            if not printed.compiled[system, name].program.carried:
                _near(a, b, (system, name))


def _near(a, b, where):
    epsilon = float(np.finfo(a.dtype).eps)
    scale = max(1.0, float(np.nanmax(np.abs(b), initial=1.0)))
    assert np.allclose(a, b, rtol=0, atol=2 * ROUNDINGS * epsilon * scale, equal_nan=True), where


def stress(printed):
    return printed.module("native").stress


def carried(printed):
    """A set-up of a small kernel."""
    return stress(printed).carry_setup(S_t=[1.0, 2.0, 3.0])


def test_a_prepared_step_runs_again_on_new_inputs(printed):
    call = stress(printed).carry_step.prepare(carried(printed), turn=[0.1, 0.2], v=[1.0, 0.0, 0.0])
    call.inputs["turn"][...] = 0.3
    call.run()
    like = stress(printed).carry(turn=[0.3, 0.3], v=[1.0, 0.0, 0.0], S_t=[1.0, 2.0, 3.0])
    assert np.allclose(call.results.w, like.w)


def test_parameters_that_a_stage_does_not_read_are_accepted(printed):
    context = stress(printed).carry_setup(S_t=[1.0, 2.0, 3.0], L_0=2.0)
    answer = stress(printed).carry_step(context, turn=0.1, v=[1.0, 0.0, 0.0], L_0=2.0)
    assert int(answer.status) == 0


def test_a_context_of_another_kernel_is_refused(printed):
    other = stress(printed).bounds_setup(L_0=2.0)
    with pytest.raises(TypeError, match="needs the context of carry_setup"):
        stress(printed).carry_step(other, turn=0.1, v=[1.0, 0.0, 0.0])
    with pytest.raises(TypeError, match="needs the context of carry_setup"):
        stress(printed).carry_step(None, turn=0.1, v=[1.0, 0.0, 0.0])


def test_no_step_runs_after_a_set_up_that_refused(printed):
    context = stress(printed).carry_setup(S_t=[1.0, np.nan, 3.0])
    assert context.status == -1
    with pytest.raises(ValueError, match="carry_setup answered -1"):
        stress(printed).carry_step(context, turn=0.1, v=[1.0, 0.0, 0.0])


def test_a_set_up_is_of_one_mount(printed):
    with pytest.raises(ValueError, match="one mount, not a batch"):
        stress(printed).carry_setup(S_t=[[1.0, 2.0, 3.0]] * 2)


def test_names_are_checked(printed):
    with pytest.raises(TypeError, match="missing: S_t"):
        stress(printed).carry_setup()
    with pytest.raises(TypeError, match="unknown: turn"):
        stress(printed).carry_setup(S_t=[1.0, 2.0, 3.0], turn=0.1)


def test_a_kernel_that_is_not_divided_has_no_stages(printed):
    assert ("stress", "numbers") not in printed.stages
    with pytest.raises(AttributeError, match="no kernel 'numbers_setup'"):
        stress(printed).numbers_setup()
