"""The compiled C from Python: the same functions, the same answers."""

import gc
import os
import subprocess
import sys
import tracemalloc

import numpy as np
import pytest

from armillary.derivation.folders import names
from tests.targets.compilers import needs
from tests.targets.conftest import DERIVATIONS, TARGET, print_all
from tests.targets.reference import agree, answers, points, spoilt
from tests.targets.stress import SYSTEMS, bare

pytestmark = [pytest.mark.tool, needs("gcc")]
POINTS = 40
system = pytest.mark.parametrize("system", [*names(DERIVATIONS), *SYSTEMS])


def kernels(printed, system):
    """(native function, Python function, program) of each kernel of a system."""
    native, module = getattr(printed.module("native"), system), printed.module(system)
    for (of, name), made in printed.compiled.items():
        if of == system:
            yield getattr(native, name), getattr(module, name), made.program


@system
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_native_equals_the_evaluator_and_python(printed, system, dtype):
    for native, python, program in kernels(printed, system):
        for inputs in (points(program, POINTS, dtype), spoilt(program, POINTS, dtype)):
            found, like = native(**inputs), python(**inputs)
            kind = dtype if inputs else np.float64
            expected = answers(program, inputs, 1)
            for answer in (found, like):
                agree(program, answer, expected, inputs, kind)
            assert np.array_equal(found.status, like.status)
            assert found._fields == like._fields
            for a, b in zip(found[:-1], like[:-1], strict=True):
                assert a.dtype == b.dtype
                assert a.shape == b.shape


@system
@pytest.mark.parametrize("batch", [(), (1,), (6,), (2, 3), (0,), (2, 0, 3)])
def test_batches_of_any_shape(printed, system, batch):
    for native, python, program in kernels(printed, system):
        size = int(np.prod(batch, dtype=int))
        flat = points(program, max(size, 1))
        given = {n: a[:size].reshape(batch + a.shape[1:]) for n, a in flat.items()}
        for a, b in zip(native(**given), python(**given), strict=True):
            assert a.shape == b.shape
            assert np.allclose(a, b, rtol=1e-9, atol=1e-9, equal_nan=True)


@system
def test_scalars_are_spread_over_a_batch(printed, system):
    for native, _, program in kernels(printed, system):
        inputs = points(program, 1)
        wanted = [np.asarray(x).reshape(-1) for x in native(**inputs)]
        for q in inputs:
            mixed = {n: a[0].tolist() for n, a in inputs.items()}
            mixed[q] = np.broadcast_to(inputs[q], (4, 2, *inputs[q].shape[1:]))
            found = native(**mixed)
            assert found.status.shape == (4, 2)
            for field, one in zip(found, wanted, strict=True):
                assert np.array_equal(field.reshape(8, -1), np.tile(one, (8, 1)), equal_nan=True)


def test_arrays_need_not_be_contiguous(printed):
    native = printed.module("native").stress.vectors
    inputs = points(printed.compiled["stress", "vectors"].program, 8)
    wanted = native(**inputs)
    odd = {n: np.repeat(a, 2, axis=0)[::2] for n, a in inputs.items()}
    odd["v"] = np.asfortranarray(odd["v"])
    for a, b in zip(native(**odd), wanted, strict=True):
        assert np.array_equal(a, b)


def test_precisions_are_chosen_by_the_arrays(printed):
    both_signs = printed.module("native").answers.both_signs
    single = np.full(2, 0.25, np.float32)
    assert both_signs(x=single, y=0.5).root.dtype == np.float32
    assert both_signs(x=single, y=np.array([1, 0])).root.dtype == np.float32
    assert both_signs(x=single, y=np.full(2, 0.25)).root.dtype == np.float64
    assert both_signs(x=1, y=0).root.dtype == np.float64
    assert both_signs(x=single, y=1e300).status.tolist() == [-1, -1]


def test_wrong_arguments_are_named(printed):
    native = printed.module("native")
    with pytest.raises(TypeError, match=r"answers\.both_signs: arguments missing: y"):
        native.answers.both_signs(x=1.0)
    with pytest.raises(TypeError, match="unknown: z"):
        native.answers.both_signs(x=1.0, y=1.0, z=1.0)
    with pytest.raises(ValueError, match="v is a vector"):
        native.stress.lengths(v=np.zeros(2))
    with pytest.raises(AttributeError, match=r"no system 'moon'; there are .*answers"):
        _ = native.moon


def test_parameters_that_are_not_read_are_accepted(printed):
    native = printed.module("native").stress
    every = {q.name: np.full(q.shape, np.nan) for q in printed.records["stress"].parameters}
    assert native.lengths(v=np.ones(3), **every).status == 0
    assert native.lengths(v=np.ones(3), unread=None).status == 0


# -- prepared calls -------------------------------------------------------------------------------


@pytest.mark.parametrize("system", [*SYSTEMS, "heliostat"])
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_a_prepared_call_answers_like_a_call(printed, system, dtype):
    for native, _, program in kernels(printed, system):
        inputs = spoilt(program, POINTS, dtype)
        call = native.prepare(**inputs)
        assert set(call.inputs) == set(inputs)
        call.run()
        wanted = native(**inputs)
        assert type(call.results) is type(wanted)
        states = {q.name for q in program.kernel.states}
        for name, a, b in zip(wanted._fields, call.results, wanted, strict=True):
            assert (a.dtype, a.shape) == (b.dtype, b.shape)
            if name in states:  # they are kept where the status is negative
                a, b = a[wanted.status >= 0], b[wanted.status >= 0]
            assert np.array_equal(a, b, equal_nan=True)


def test_a_prepared_call_reads_its_arrays_anew(printed):
    native = printed.module("native").loops
    call = native.rods.prepare(l=np.ones((5, 3)), x=1.0, turn=np.zeros(5), R=[0.1, 0.2, 0.3])
    call.inputs["l"][:, 1] = 2.0
    call.inputs["x"][...] = 0.5
    call.run()
    wanted = native.rods(l=[1.0, 2.0, 1.0], x=0.5, turn=np.zeros(5), R=[0.1, 0.2, 0.3])
    assert np.array_equal(call.results.rod, wanted.rod)
    call.inputs["l"][3, 0] = np.nan
    call.run()
    assert call.results.status.tolist() == [0, 0, 0, -1, 0]
    assert np.isnan(call.results.rod[3]).all()


def test_a_prepared_call_allocates_nothing(printed):
    run = printed.module("native").bare.root.prepare(x=np.linspace(0, 1, 12)).run
    run()
    tracemalloc.start()
    for _ in range(1000):
        run()
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 4096


def test_the_run_of_a_prepared_call_outlives_it(printed):
    call = printed.module("native").bare.root.prepare(x=np.linspace(0, 1, 1000))
    run, results = call.run, call.results
    del call
    gc.collect()
    run()
    assert results.r[-1] == 1.0


# -- states ---------------------------------------------------------------------------------------


def test_a_prepared_update_goes_on_where_it_ended(printed):
    native, module = printed.module("native").keepers, printed.module("keepers")
    each = np.linspace(-1, 1, 12).reshape(4, 3)
    begun = native.array_init(each=each)
    call = native.array_update.prepare(each=each, gain=0.25, several=begun.several, last=begun.last)
    assert call.results.several is call.inputs["several"]
    several, last = begun.several, begun.last
    for _ in range(3):
        call.run()
        wanted = module.array_update(each=each, gain=0.25, several=several, last=last)
        several, last = wanted.several, wanted.last
        for found, exact in zip(call.results, wanted, strict=True):
            assert np.allclose(found, exact, rtol=1e-14, atol=1e-14)


def test_a_state_is_left_as_it_was_where_the_status_is_negative(printed):
    update = printed.module("native").keepers.array_update
    given = {"gain": 0.25, "several": np.zeros((2, 3)), "last": 0.5}
    call = update.prepare(each=[[0.5, 0.5, 0.5], [0.5, 1.5, 0.5]], **given)
    call.run()
    assert call.results.status.tolist() == [0, -3]
    assert call.inputs["several"].tolist() == [[0.125] * 3, [0.0] * 3]
    assert call.inputs["last"].tolist() == [0.0, 0.5]
    assert np.isnan(call.results.moved[1]).all()
    # A plain call keeps nothing: its states are results like the others.
    assert np.isnan(update(each=[0.5, 1.5, 0.5], **given).several).all()


def test_a_state_that_was_one_number_is_one_for_each_point(printed):
    update = printed.module("native").keepers.simple_update
    call = update.prepare(given=np.array([0.5, -0.5]), gain=0.5, last=0.0, so_far=0.0)
    for _ in range(2):
        call.run()
    assert call.results.last.tolist() == [0.5, -0.5]
    assert call.results.so_far.tolist() == [-0.25, 0.25]


def test_states_trade_places(printed):
    for module in (printed.module("native").keepers, printed.module("keepers")):
        found = module.exchange_update(each=[1.0, 2.0, 3.0], one=[0.1, 0.2, 0.3], other=[4, 5, 6])
        assert found.one.tolist() == [4.0, 5.0, 6.0]
        assert found.other.tolist() == pytest.approx([1.1, 2.1, 3.1])
        assert found.before.tolist() == [0.1, 0.2, 0.3]
        assert found.first == 4.0


def test_functions_are_documented(printed):
    native, module = printed.module("native"), printed.module("bare")
    assert native.bare.root.__doc__ == module.root.__doc__
    assert "allocated" in native.Prepared.__doc__
    assert "Prepared" in native.bare.root.prepare.__doc__
    assert {"bare", "stress"} <= set(dir(native))


# -- the build ------------------------------------------------------------------------------------


def python(printed, code, **environment):
    """Run code in a fresh interpreter that sees the printed package."""
    paths = [str(printed.folder / "python")]
    given = {**os.environ, "PYTHONPATH": os.pathsep.join(paths), **environment}
    return subprocess.run(
        [sys.executable, "-c", code], env=given, capture_output=True, text=True, check=False
    )


CALL = "from printed_kernels import native; print(native.bare.root(x=4.0).r)"


@pytest.fixture
def small(tmp_path):
    """One system, so that a build takes no time."""
    return print_all(tmp_path / "small", TARGET, {"bare": bare()})


def test_a_build_is_kept_and_used_again(small, tmp_path):
    cache = tmp_path / "cache"
    for _ in range(2):
        done = python(small, CALL, XDG_CACHE_HOME=str(cache))
        assert done.stdout == "2.0\n", done.stderr
        (library,) = (cache / "armillary").iterdir()
        os.utime(library, (1, 1))
    assert library.stat().st_mtime == 1
    assert library.name.startswith("kernels-")


def test_changed_sources_are_built_anew(small, tmp_path):
    cache = tmp_path / "cache"
    python(small, CALL, XDG_CACHE_HOME=str(cache))
    source = small.c / "bare_root_f64.c"
    text = source.read_text()
    source.write_text(text.replace("sqrt(x)", "(7.0 * sqrt(x))"))
    assert python(small, CALL, XDG_CACHE_HOME=str(cache)).stdout == "14.0\n"
    assert len(list((cache / "armillary").iterdir())) == 2


def test_a_build_that_failed_leaves_nothing_and_tells_what_the_compiler_said(small, tmp_path):
    (small.c / "bare_root_f64.c").write_text("this is not C\n")
    cache = tmp_path / "cache"
    done = python(small, CALL, XDG_CACHE_HOME=str(cache))
    assert "NoCompilerError" in done.stderr
    assert "bare_root_f64.c:1" in done.stderr
    assert list((cache / "armillary").iterdir()) == []


def test_a_compiler_that_is_not_there_is_named(small, tmp_path):
    done = python(small, CALL, XDG_CACHE_HOME=str(tmp_path), CC="no-such-cc -O1")
    assert "NoCompilerError: CC=no-such-cc -O1 is not there: install gcc or clang" in done.stderr


def test_without_a_compiler_everything_else_works(small, tmp_path):
    environment = {"XDG_CACHE_HOME": str(tmp_path), "PATH": str(tmp_path), "CC": ""}
    done = python(small, CALL, **environment)
    assert "NoCompilerError: no C compiler (cc, gcc or clang) was found: install" in done.stderr
    other = "from printed_kernels import bare, native; print(bare.root(x=4.0).r)"
    assert python(small, other, **environment).stdout == "2.0\n"


@needs("clang")
def test_cc_chooses_the_compiler(small, tmp_path):
    done = python(small, CALL, XDG_CACHE_HOME=str(tmp_path), CC="clang -O1")
    assert done.stdout == "2.0\n", done.stderr
