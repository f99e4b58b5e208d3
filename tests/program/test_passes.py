"""Each pass keeps every value to 1e-40 and never raises the weighted cost."""

import pytest
import sympy
from hypothesis import given, settings

from armillary import atan2, atan2_or_zero, cos, hypot, sin, sqrt, where
from armillary.program.arithmetic import Reals
from armillary.program.compile import compile_kernel
from armillary.program.cost import cost
from armillary.program.evaluate import evaluate
from armillary.program.lower import strategies
from armillary.program.passes import (
    PASSES,
    expand_multiple_angles,
    factor_sums,
    open_arc_tangents,
    share_reciprocals,
)
from armillary.program.program import STRUCTURED_OPS, Op
from armillary.program.scalarise import scalarise
from tests.expressions import INPUTS, SCALARS, VECTORS, c, record, x, y
from tests.programs import exact, kernel_of, opened, program_of

POINTS = [
    {"x": 0.7, "y": -1.3, "c": [0.3, -0.8, 0.5], "x_dot": 1.0, "y_dot": 2.0, "c_dot": [1, 2, 3]},
    {"x": -2.9, "y": 0.4, "c": [-1.7, 0.2, 0.0], "x_dot": 0.0, "y_dot": 1.0, "c_dot": [0, 0, 1]},
]


def numbers(program):
    found = []
    for point in POINTS:
        for value in evaluate(program, exact(point), Reals()).results.values():
            found += value if isinstance(value, list) else [value]
    return found


def same(before, after):
    for a, b in zip(numbers(before), numbers(after), strict=True):
        assert abs(a - b) <= 1e-40 * (1 + abs(a))


@pytest.mark.parametrize("step", PASSES)
@given(SCALARS, SCALARS)
def test_passes_on_random_scalars(step, first, second):
    program = opened(record, INPUTS, {"r": first, "s": second + first})
    after = step(program)
    same(program, after)
    assert cost(after).weighted <= cost(program).weighted


@given(VECTORS)
def test_scalarise_and_passes_on_random_vectors(expression):
    program = program_of(record, INPUTS, {"r": expression})
    for step in (scalarise, *PASSES):
        after = step(program)
        same(program, after)
        assert cost(after).weighted <= cost(program).weighted
        program = after
    assert not any(i.op in STRUCTURED_OPS for i in program.instructions)


@settings(max_examples=12)
@given(VECTORS)
def test_strategies_agree(expression):
    plain = program_of(record, INPUTS, {"r": expression})
    for strategy in strategies():
        same(plain, program_of(record, INPUTS, {"r": expression}, strategy))


@given(SCALARS)
def test_random_kernels_compile(expression):
    """The compiler proves its own passes: it must accept whatever it is given."""
    compile_kernel(kernel_of(record, INPUTS, {"r": expression}))


@given(SCALARS)
def test_passes_change_nothing_twice(expression):
    program = opened(record, INPUTS, {"r": expression})
    for step in PASSES:
        once = step(program)
        assert step(once).instructions == once.instructions


def ops(program):
    return [i.op for i in program.instructions]


def test_a_common_factor_is_taken_out():
    program = opened(record, INPUTS, {"r": x * sin(y) + x * cos(y) - x * y})
    after = factor_sums(program)
    assert ops(program).count(Op.MULTIPLY) == 3
    assert ops(after).count(Op.MULTIPLY) == 1


def test_a_shared_product_is_left_alone():
    shared = opened(record, INPUTS, {"r": x * y + x * sin(y), "s": x * y})
    assert factor_sums(shared).instructions == shared.instructions
    alone = opened(record, INPUTS, {"r": x * y + x * sin(y)})
    assert factor_sums(alone).instructions != alone.instructions


def test_two_divisions_share_a_reciprocal():
    program = opened(record, INPUTS, {"r": x / (2 + cos(y)), "s": y / (2 + cos(y))})
    assert ops(program).count(Op.DIVIDE) == 2
    assert ops(share_reciprocals(program)).count(Op.DIVIDE) == 1


def test_one_division_stays():
    program = opened(record, INPUTS, {"r": x / (2 + cos(y))})
    assert share_reciprocals(program).instructions == program.instructions


def test_the_reciprocal_of_a_root_serves_its_square():
    square = 3 + cos(y)
    program = opened(record, INPUTS, {"r": x / square, "s": y / sqrt(square)})
    after = share_reciprocals(program)
    assert ops(program).count(Op.DIVIDE) == 2
    assert ops(after).count(Op.DIVIDE) == 1
    assert cost(after).weighted < cost(program).weighted
    same(program, after)


def test_a_root_that_divides_nothing_leaves_its_square_alone():
    square = 3 + cos(y)
    program = opened(record, INPUTS, {"r": x / square, "s": y * sqrt(square)})
    assert share_reciprocals(program).instructions == program.instructions


GUARDS = {
    "length": hypot(c.x, c.y) < "1e-9",
    "the other order": hypot(c.y, c.x) < "1e-9",
    "square": c.x * c.x + c.y * c.y < "1e-18",
}


@pytest.mark.parametrize("free", GUARDS.values(), ids=list(GUARDS))
def test_the_sine_of_a_guarded_arc_tangent_is_a_quotient(free):
    angle = atan2_or_zero(-c.y, c.x, free)
    program = opened(record, INPUTS, {"a": angle, "r": sin(angle), "s": cos(angle)})
    after = open_arc_tangents(program)
    assert cost(program).trigonometry == 2
    assert cost(after).trigonometry == 0
    assert cost(share_reciprocals(after)).divide == 1
    same(program, after)
    nowhere = exact({**POINTS[0], "c": [0, 0, 1]})
    found = evaluate(after, nowhere, Reals()).results
    assert (found["a"], found["r"], found["s"]) == (0, 0, 1)


UNPROVED = {
    "no guard": atan2(c.y, c.x),
    "a guard of another length": atan2_or_zero(c.y, c.x, hypot(c.x, c.z) < "1e-9"),
    "a guard of one argument": atan2(where(hypot(c.x, c.y) < "1e-9", 0, c.y), c.x),
    "a guard that lets 0 pass": atan2_or_zero(c.y, c.x, hypot(c.x, c.y) < 0),
    "a guard that varies": atan2_or_zero(c.y, c.x, hypot(c.x, c.y) < x),
    "a guard of a sum": atan2_or_zero(c.y, c.x, c.x * c.x + c.y * c.z < "1e-9"),
    "the other way round": atan2_or_zero(c.y, c.x, hypot(c.x, c.y) > "1e-9"),
    "another angle where it is free": atan2(
        where(hypot(c.x, c.y) < "1e-9", 1, c.y), where(hypot(c.x, c.y) < "1e-9", 1, c.x)
    ),
}


@pytest.mark.parametrize("angle", UNPROVED.values(), ids=list(UNPROVED))
def test_the_sine_of_an_arc_tangent_stays_where_0_may_be_met(angle):
    program = opened(record, INPUTS, {"r": sin(angle), "s": cos(angle)})
    assert open_arc_tangents(program).instructions == program.instructions


def test_a_series_calls_the_library_twice():
    series = sum((cos(k * x) + sin(k * x) for k in range(2, 5)), cos(x) + sin(x))
    program = opened(record, INPUTS, {"r": series})
    after = expand_multiple_angles(program)
    assert cost(program).trigonometry == 8
    assert cost(after).trigonometry == 2


def test_lone_harmonics_are_not_worth_a_recurrence():
    """cos(8x) beside sin(x) would need cos(x) as well."""
    program = opened(record, INPUTS, {"r": cos(8 * x) + sin(x)})
    assert expand_multiple_angles(program).instructions == program.instructions
    halves = opened(record, INPUTS, {"r": cos(3 * x) + cos(2 * x)})
    assert cost(expand_multiple_angles(halves)).trigonometry == 2


def test_a_multiple_may_stand_before_its_base():
    """sin(x) is twice the half angle's product, wherever the half angle is written."""
    program = opened(record, INPUTS, {"r": sin(x) + cos(x), "s": sin(x / 2) * cos(x / 2)})
    after = expand_multiple_angles(program)
    assert cost(program).trigonometry == 4
    assert cost(after).trigonometry == 2
    same(program, after)


def test_a_broken_pass_is_refused(monkeypatch):
    """The proof inside the compiler is not decoration."""
    from armillary.program import compile as compiler
    from armillary.program.rewrite import Rewriter

    class Wrong(Rewriter):
        def rewrite(self, number):
            if self.program.instructions[number].op is Op.CONSTANT:
                return self.builder.constant(sympy.Rational(1, 7))
            return super().rewrite(number)

    monkeypatch.setattr(compiler, "STAGES", (scalarise, lambda p: Wrong(p).run()))
    with pytest.raises(compiler.PassError, match="changed a value"):
        compile_kernel(kernel_of(record, INPUTS, {"r": 3 * sin(x) + y}))


def test_a_dear_pass_is_refused(monkeypatch):
    from armillary.program import compile as compiler

    monkeypatch.setattr(compiler, "STAGES", (scalarise, _twice))
    with pytest.raises(compiler.PassError, match="raised the cost"):
        compile_kernel(kernel_of(record, INPUTS, {"r": sqrt(3 + x) + y}))


def _twice(program):
    """|root| by squaring and taking the root again: right, and dear."""
    from armillary.program.rewrite import Rewriter

    class Dear(Rewriter):
        def rewrite(self, number):
            i, b = self.program.instructions[number], self.builder
            if i.op is Op.SQRT:
                root = b.sqrt(self.new[i.args[0]])
                return b.sqrt(b.multiply(root, root))
            return super().rewrite(number)

    return Dear(program).run()
