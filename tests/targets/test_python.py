"""The Python kernels: values by three array libraries, shapes, refusals, arguments."""

import array_api_strict
import dask.array
import numpy as np
import pytest

from armillary.derivation.folders import names
from tests.targets.conftest import DERIVATIONS
from tests.targets.reference import NAN, agree, answers, points, spoilt
from tests.targets.stress import SYSTEMS

POINTS = 24
LIBRARIES = {
    "numpy": np.asarray,
    "array-api-strict": array_api_strict.asarray,
    "dask": lambda a: dask.array.from_array(a, chunks=(12, *a.shape[1:])),
}
system = pytest.mark.parametrize("system", [*names(DERIVATIONS), *SYSTEMS])


def kernels(printed, system):
    """(function, program) of each kernel of a system."""
    module = printed.module(system)
    for (of, name), made in printed.compiled.items():
        if of == system:
            yield getattr(module, name), made.program


# -- values ---------------------------------------------------------------------------------------


@system
@pytest.mark.parametrize("library", LIBRARIES)
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_results_are_the_exact_ones(printed, system, library, dtype):
    convert = LIBRARIES[library]
    for function, program in kernels(printed, system):
        for inputs in (points(program, POINTS, dtype), spoilt(program, POINTS, dtype)):
            result = function(**{n: convert(a) for n, a in inputs.items()})
            expected = answers(program, inputs, 1)
            agree(program, result, expected, inputs, dtype if inputs else np.float64)


def test_results_stay_in_the_callers_library(printed):
    function = printed.module("stress").vectors
    program = printed.compiled["stress", "vectors"].program
    inputs = points(program, 3)
    for convert in (LIBRARIES["array-api-strict"], LIBRARIES["dask"]):
        given = {n: convert(a) for n, a in inputs.items()}
        for field in function(**given):
            assert type(field) is type(given["turn"])


def test_of_several_negative_statuses_the_most_negative_is_told(printed):
    both_signs = printed.module("answers").both_signs
    x = [0.1, 1.5, 0.1, 1.5, -1.2, 0.0, -0.1, NAN, 9.0, NAN]
    y = [0.1, 0.1, 1.5, 1.5, 1.0, 0.0, -0.1, 1.5, NAN, 0.0]
    found = both_signs(x=np.array(x), y=np.array(y))
    assert found.status.tolist() == [0, -3, -4, -4, 1, 2, 5, -1, -2, -1]


def test_the_sign_of_zero_is_kept_as_in_c(printed):
    found = printed.module("answers").signs(x=np.array([0.0, -0.0]), y=np.array([-1.0, -0.5]))
    assert np.signbit(found.minus).tolist() == [True, False]
    assert found.a[1] == np.pi


# -- shapes ---------------------------------------------------------------------------------------


@system
@pytest.mark.parametrize("batch", [(), (1,), (6,), (2, 3), (0,), (2, 0, 3)])
def test_batches_of_any_shape(printed, system, batch):
    for function, program in kernels(printed, system):
        size = int(np.prod(batch, dtype=int))
        flat = points(program, max(size, 1))
        given = {n: a[:size].reshape(batch + a.shape[1:]) for n, a in flat.items()}
        found = function(**given)
        shape = batch if given else ()
        assert found.status.shape == shape
        for output in program.kernel.outputs:
            array = getattr(found, output.name)
            assert array.shape == shape + output.shape
            assert array.dtype == np.float64
            whole = getattr(function(**flat), output.name)
            if size and given:
                assert np.array_equal(array.ravel(), whole[:size].ravel(), equal_nan=True)


@system
def test_scalars_are_spread_over_a_batch(printed, system):
    for function, program in kernels(printed, system):
        many = points(program, 40)
        answered = int(np.argmax(np.ravel(function(**many).status) >= 0))
        inputs = {name: a[answered : answered + 1] for name, a in many.items()}
        wanted = [np.asarray(x).reshape(-1) for x in function(**inputs)]
        assert all(np.isfinite(one).all() for one in wanted)
        for q in inputs:
            mixed = {n: a[0].tolist() for n, a in inputs.items()}
            mixed[q] = np.broadcast_to(inputs[q], (4, 2, *inputs[q].shape[1:]))
            found = function(**mixed)
            assert found.status.shape == (4, 2)
            for field, one in zip(found, wanted, strict=True):
                assert np.array_equal(field.reshape(8, -1), np.tile(one, (8, 1)))


def test_batches_are_broadcast(printed):
    function = printed.module("answers").both_signs
    x, y = np.linspace(-1, 0.9, 5)[:, None], np.linspace(-0.9, 0.8, 3)
    found = function(x=x, y=y)
    assert found.root.shape == found.status.shape == (5, 3)
    assert found.a[4, 1] == function(x=x[4, 0], y=y[1]).a


def test_plain_numbers_and_lists_are_taken(printed):
    quarter = printed.module("attitudes").parts(R=[[0, -1, 0], [1, 0, 0], [0, 0, 1]], Q=np.eye(3))
    assert (quarter.status, quarter.c.tolist()) == (0, [-1.0, 0.0, 0.0])
    module = printed.module("stress")
    found = module.carry(turn=0, v=[1, 2, 3], S_t=(0.5, 0, 0))
    assert found.w.tolist() == [2.0, 2.0, 3.0]
    assert found.status.shape == ()
    assert found.status == 0


@pytest.mark.parametrize("convert", [LIBRARIES["numpy"], LIBRARIES["array-api-strict"]])
def test_integers_are_computed_in_doubles(printed, convert):
    found = printed.module("bare").root(x=convert(np.array([4, 9])))
    assert np.asarray(found.r).tolist() == [2.0, 3.0]
    assert np.asarray(found.r).dtype == np.float64


def test_precisions_mix_as_in_numpy(printed):
    both_signs = printed.module("answers").both_signs
    single, double = np.full(2, 0.25, np.float32), np.full(2, 0.25)
    assert both_signs(x=single, y=0.5).root.dtype == np.float32
    assert both_signs(x=single, y=np.array([1, 0])).root.dtype == np.float32
    assert both_signs(x=single, y=double).root.dtype == np.float64


# -- refusals -------------------------------------------------------------------------------------


def test_a_refused_row_leaves_the_others_alone(printed):
    function = printed.module("stress").vectors
    program = printed.compiled["stress", "vectors"].program
    good = points(program, 6)
    whole = function(**good)
    bad = {n: a.copy() for n, a in good.items()}
    bad["turn"][1], bad["v"][2, 1], bad["c"][3] = np.inf, 2e6, (0.6, 0.6, 0.6)
    found = function(**bad)
    assert found.status.tolist() == [0, -1, -2, -2, 0, 0]
    for now, before in zip(found[:-1], whole[:-1], strict=True):
        assert np.isnan(now[1:4]).all()
        assert np.array_equal(now[[0, 4, 5]], before[[0, 4, 5]])


@pytest.mark.parametrize("library", LIBRARIES)
def test_a_matrix_that_is_no_rotation_leaves_the_others_alone(printed, library):
    module, turned = printed.module("attitudes"), np.tile(np.eye(3)[[1, 2, 0]], (7, 1, 1))
    turned[1, 0, 0], turned[2, 1, 1], turned[3] = np.nan, 1e20, 0.99 * turned[3]
    turned[4, 0] *= -1
    turned[5, :, 0] += 0.01 * turned[5, :, 1]
    given = LIBRARIES[library](turned)
    found = module.parts(R=given, Q=np.eye(3))
    assert np.asarray(found.status).tolist() == [0, -1, -2, -2, -2, -2, 0]
    assert np.asarray(found.c)[[0, 6]].tolist() == [[1.0, 0.0, 0.0]] * 2
    assert np.isnan(np.asarray(found.c)[1:6]).all()
    assert np.asarray(found.t)[0].tolist() == np.eye(3).tolist()


def test_limits_are_met_to_the_last_bit(printed):
    bounds = printed.module("stress").bounds
    good = {"strict": 3.0, "below": -2.0, "L_0": 1.0}
    for dtype in (np.float64, np.float32):
        low, high = dtype(-273.15), dtype(200.0)
        warm = [low, np.nextafter(low, dtype(-np.inf)), high, np.nextafter(high, dtype(np.inf))]
        found = bounds(warm=np.array(warm, dtype), **good)
        assert found.status.tolist() == [0, -2, 0, -2]


def test_minus_zero_is_a_length(printed):
    assert printed.module("bare").root(x=np.array(-0.0)).status == 0


def test_what_a_float_cannot_hold_is_refused_without_a_warning(printed):
    found = printed.module("answers").both_signs(x=np.float32(0.5), y=1e300)
    assert found.status < 0
    assert np.isnan(found.root)


# -- arguments ------------------------------------------------------------------------------------


def test_arguments_are_keywords(printed):
    with pytest.raises(TypeError, match="positional"):
        printed.module("bare").root(4.0)


def test_an_unknown_argument_is_refused(printed):
    with pytest.raises(TypeError, match="unexpected keyword argument 'z'"):
        printed.module("bare").root(x=4.0, z=1.0)


def test_a_missing_argument_is_named(printed):
    with pytest.raises(TypeError, match="'y'"):
        printed.module("answers").both_signs(x=1.0)
    with pytest.raises(TypeError, match="y is missing"):
        printed.module("answers").both_signs(x=1.0, y=None)


@pytest.mark.parametrize("v", [1.0, np.zeros(2), np.zeros((3, 2))])
def test_a_vector_of_another_length_is_named(printed, v):
    with pytest.raises(ValueError, match="v is a vector"):
        printed.module("stress").lengths(v=v)


@pytest.mark.parametrize("R", [1.0, np.zeros(3), np.zeros(9), np.zeros((3, 2)), np.zeros((2, 9))])
def test_a_rotation_of_another_shape_is_named(printed, R):
    for module in (printed.module("attitudes"), printed.module("native").attitudes):
        with pytest.raises(ValueError, match="R is a rotation: its last two axes"):
            module.parts(R=R, Q=np.eye(3))


@pytest.mark.parametrize("wrong", [1.0, np.zeros(2), np.zeros((3, 2))])
def test_an_array_of_another_shape_is_named(printed, wrong):
    good = {"x": 1.0, "turn": 0.0, "R": np.ones(3)}
    for module in (printed.module("loops"), printed.module("native").loops):
        with pytest.raises(ValueError, match="l is an array: its last axis must have length 3"):
            module.rods(l=wrong, **good)
        with pytest.raises(ValueError, match="v is an array: its last two axes must have length 3"):
            module.ignored(l=np.ones(3), v=wrong)
        with pytest.raises(ValueError, match="h is an array: its last axis must have length 2"):
            module.grid(x=1.0, turn=0.0, h=[1.0, 2.0, 3.0])


def test_what_runs_over_an_index_is_on_the_last_axes(printed):
    grid = printed.module("loops").grid
    turns, h = np.linspace(-1, 1, 5), np.array([0.25, -0.5])
    found = grid(x=0.5, turn=turns, h=h)
    assert [a.shape for a in found] == [(5, 3, 2), (5, 2), (5, 3), (5,), (5,)]
    legs = np.array([0, 2, -2]) * np.pi / 3
    tilt = np.cos(turns[:, None, None] + legs[:, None]) * h + np.array([0.5, -0.5])
    assert np.allclose(found.tilt, tilt)
    assert np.allclose(found.row, (tilt**2).sum(1))
    assert np.allclose(found.column, (tilt / (2 + (tilt**2).sum(1))[:, None, :]).sum(2))
    assert np.allclose(found.all, (tilt**2).sum((1, 2)))


def test_parameters_that_are_not_read_are_accepted(printed):
    module = printed.module("stress")
    record = printed.records["stress"]
    every = {q.name: np.full(q.shape, NAN) for q in record.parameters}
    assert module.lengths(v=np.ones(3), **every).status == 0
    for (of, name), made in printed.compiled.items():
        given = {q.name: None for q in record.parameters} | points(made.program, 2)
        if of == "stress":
            assert not np.any(getattr(module, name)(**given).status)


def test_half_precision_is_raised_to_single(printed):
    half = {q: np.float16(x) for q, x in {"gamma": 1, "upsilon": 0.5, "L_1": 1, "L_2": 1}.items()}
    found = printed.module("altazimuth").pose(**half, L_0=np.float16(np.inf))
    assert (found.status, found.M.dtype) == (-1, np.float32)


@pytest.mark.parametrize("wrong", [1 + 2j, np.complex64(1), "0.3", ["a"], np.array([1j])])
def test_what_is_no_real_number_is_refused(printed, wrong):
    for module in (printed.module("sun"), printed.module("native").sun):
        with pytest.raises(TypeError, match="day must be real numbers"):
            module.cooper(day=wrong)


def test_numpy_numbers_follow_another_library(printed):
    dask = pytest.importorskip("dask.array")
    strict = pytest.importorskip("array_api_strict")
    place = {"latitude": np.float64(0.7), "declination": np.array(0.2)}
    hours = [-1.0, 0.5]
    wanted = printed.module("sun").angles(**place, hour_angle=np.asarray(hours)).azimuth
    for made in (dask.asarray(hours), strict.asarray(hours)):
        found = printed.module("sun").angles(**place, hour_angle=made).azimuth
        assert type(found) is type(made)
        assert np.asarray(found).tolist() == pytest.approx(wanted.tolist(), rel=1e-15)


def test_results_may_be_named_like_arguments(printed):
    found = printed.module("names").same(v=[1.0, 2.0, 3.0], S=[0.5, 0.25, 0.0], step=2.0)
    assert found._fields == ("v", "S", "step", "v_out", "S_y", "status")
    assert [np.asarray(x).tolist() for x in found] == [[1.5, 2.25, 3.0], 1.0, 6.0, 1.0, 0.25, 0]


def test_a_named_tuple_says_its_results(printed):
    found = printed.module("answers").both_signs(x=0.5, y=0.5)
    assert found._fields == ("root", "a", "status")
    assert type(found).__name__ == "BothSignsResult"


def test_the_modules_are_documented(printed):
    module = printed.module("stress")
    assert module.__doc__.startswith('Kernels that are "hard" to print; 10 \\mu m, 5 °')
    assert "\\bar v" in module.vectors.__doc__
    assert "turn: an angle, rad" in module.vectors.__doc__
    assert "R: R, shape (..., 3, 3)" in module.vectors.__doc__
    assert "unread: accepted and not read" in module.vectors.__doc__
    for line in (printed.folder / "python/printed_kernels/answers.py").read_text().splitlines():
        assert len(line) <= 100
