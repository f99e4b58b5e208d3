"""The builder: equal values once, signs outward, zeros and ones away."""

import sympy

from armillary import Derivation
from armillary.program.builder import Builder
from armillary.program.program import Op, Result
from tests.programs import kernel_of


def fresh():
    b = Builder()
    return b, b.emit(Op.INPUT, data="x"), b.emit(Op.INPUT, data="y")


def test_equal_instructions_are_one():
    b, x, y = fresh()
    assert b.add(x, y) == b.add(y, x)
    assert b.multiply(x, y) == b.multiply(y, x)
    assert b.sin(x) == b.sin(x)
    assert b.divide(x, y) != b.divide(y, x)
    assert b.constant(sympy.Rational(1, 2)) == b.constant(sympy.Rational(2, 4))


def test_zeros_and_ones():
    b, x, y = fresh()
    zero, one = b.constant(sympy.Integer(0)), b.constant(sympy.Integer(1))
    assert b.add(x, zero) == x
    assert b.multiply(one, x) == x
    assert b.multiply(x, zero) == zero
    assert b.divide(zero, x) == zero
    assert b.multiply(b.constant(sympy.Integer(-1)), x) == b.negate(x)
    assert b.add(x, b.negate(x)) == zero
    assert b.select(b.less(x, y), x, x) == x


def test_constants_fold_exactly():
    b, x, _ = fresh()
    half, third = b.constant(sympy.Rational(1, 2)), b.constant(sympy.Rational(1, 3))
    assert b.value(b.add(half, third)) == sympy.Rational(5, 6)
    assert b.value(b.sin(b.constant(sympy.pi / 6))) == sympy.Rational(1, 2)
    assert b.value(b.sqrt(b.constant(sympy.Integer(2)))) == sympy.sqrt(2)
    six = b.multiply(b.constant(sympy.Integer(2)), b.multiply(x, b.constant(sympy.Integer(3))))
    assert b.value(b.instructions[six].args[0]) == 6
    assert b.value(b.constant(sympy.Integer(-3))) == -3


def test_signs_go_outward():
    b, x, y = fresh()
    mx, my = b.negate(x), b.negate(y)
    assert b.negate(mx) == x
    assert b.multiply(mx, y) == b.negate(b.multiply(x, y))
    assert b.multiply(mx, my) == b.multiply(x, y)
    assert b.divide(mx, y) == b.negate(b.divide(x, y))
    assert b.add(mx, my) == b.negate(b.add(x, y))
    assert b.sin(mx) == b.negate(b.sin(x))
    assert b.cos(mx) == b.cos(x)
    assert b.absolute(mx) == b.absolute(x)


def test_a_difference_is_the_other_one_negated():
    b, x, y = fresh()
    forward = b.add(x, b.negate(y))
    assert b.add(y, b.negate(x)) == b.negate(forward)


def test_the_sign_stays_inside_an_arc_tangent():
    """atan2(-y, x) is not -atan2(y, x) on the cut, where y = 0 and x < 0."""
    b, x, y = fresh()
    assert b.instructions[b.atan2(b.negate(y), x)].op is Op.ATAN2


def test_what_no_result_needs_is_dropped():
    d = Derivation("drop", title="Drop")
    x = d.angle("x", "angle")
    kernel = kernel_of(d, [x], {"r": x})
    b, number, y = fresh()
    b.sin(y)
    program = b.finish(kernel, (Result("r", (), (number,)),), ())
    assert [i.op for i in program.instructions] == [Op.INPUT]
