"""Changes of a source: the right ones, one at a time, and nowhere else."""

import ast

from mutation.operators import FUNCTION, ORDER, SIGN, TERM, mutants


def changes(source):
    return {(m.kind, m.before, m.after) for m in mutants(source)}


def test_signs_and_terms_of_a_sum():
    assert changes("x = d.define('x', a + b, because='c - d')") == {
        (SIGN, "a + b", "a - b"),
        (TERM, "a + b", "a"),
        (TERM, "a + b", "b"),
    }


def test_functions_and_arguments():
    assert changes("x = atan2(-sin(a), 1)") == {
        (ORDER, "atan2(-sin(a), 1)", "atan2(1, -sin(a))"),
        (SIGN, "-sin(a)", "sin(a)"),
        (FUNCTION, "sin(a)", "cos(a)"),
    }


def test_products_that_do_not_commute():
    assert changes("x = R @ (a / b)") == {
        (ORDER, "R @ (a / b)", "a / b @ R"),
        (ORDER, "a / b", "b / a"),
    }
    assert changes("x = a.cross(b)") == {(ORDER, "a.cross(b)", "b.cross(a)")}


def test_joints_of_a_chain():
    found = changes("c = Chain('a').rotate(Z, g).translate(X, l)")
    whole = "Chain('a').rotate(Z, g).translate(X, l)"
    assert found == {
        (SIGN, whole, "Chain('a').rotate(Z, g).translate(X, -l)"),
        (TERM, whole, "Chain('a').rotate(Z, g)"),
        (ORDER, whole, "Chain('a').translate(X, l).rotate(Z, g)"),
        (SIGN, "Chain('a').rotate(Z, g)", "Chain('a').rotate(Z, -g)"),
        (TERM, "Chain('a').rotate(Z, g)", "Chain('a')"),
    }


def test_a_frame_keeps_its_place_in_an_exchange():
    found = changes("c = Chain('a').rotate(Z, g, frame='b').translate(X, l, frame='c')")
    swapped = "Chain('a').translate(X, l, frame='b').rotate(Z, g, frame='c')"
    assert swapped in {after for _, _, after in found}


def test_what_states_no_formula_is_left_alone():
    assert not changes("d.identity('claim', a + b, -c)")
    assert not changes("g = d.angle('g', 'angle', limits=(-1, 1 + 2))")
    assert not changes("d.picture(c, at={'x': -1.0}, caption='a' + 'b')")
    assert not changes("x = 'a' + f'{b}'")


def test_one_change_at_a_time():
    source = "x = a + b\ny = a + b\n"
    for mutant in mutants(source):
        lines = mutant.source.splitlines()
        assert [line in source.splitlines() for line in lines].count(False) == 1
        ast.parse(mutant.source)
