"""Changes of a print: which there are, in what order, and in what words."""

import numpy as np
import pytest

from armillary import (
    Chain,
    Derivation,
    Paper,
    X,
    Y,
    Z,
    arccos,
    arcsin,
    at,
    cos,
    elementary,
    number,
    sin,
    sqrt,
    total,
    vector,
)
from armillary.algebra import vector as v
from armillary.algebra.functions import where
from armillary.verify.audit.changes import Changes
from armillary.verify.audit.numbers import Doubles
from armillary.verify.audit.numeric import Values
from armillary.verify.audit.plain import plain
from armillary.verify.audit.points import quantities, sample
from armillary.verify.audit.pool import Pool
from armillary.verify.audit.products import misprints, orders, pose_of
from armillary.verify.audit.terms import terms_of
from armillary.verify.audit.walking import parts, replaced, stands_in


@pytest.fixture
def d():
    return Derivation("print", title="Print")


def told(node, *more, paper=None):
    changes = Changes(Pool(node, more, paper))
    return [(c.kind, c.words, plain(c.node)) for c in changes.whole(node)]


def test_all_changes_of_a_small_sum(d):
    a, b = d.angle("a", "x"), d.angle("b", "x")
    found = [c for c in told(sin(a) - 2 * cos(b)) if not c[1].endswith(("added", "subtracted"))]
    lost = (" times ", " divided by ")
    assert [c for c in found if not any(words in c[1] for words in lost)] == [
        ("sign", "the other sign of the whole", "-(sin(a) - 2 cos(b))"),
        ("sign", "minus for plus before sin(a)", "-sin(a) - 2 cos(b)"),
        ("sign", "plus for minus before 2 cos(b)", "sin(a) + 2 cos(b)"),
        ("function", "cos for sin of a", "cos(a) - 2 cos(b)"),
        ("function", "sin for cos of b", "sin(a) - 2 sin(b)"),
        ("term", "the term sin(a) left out", "-2 cos(b)"),
        ("term", "the term 2 cos(b) left out", "sin(a)"),
        ("factor", "twice sin(a)", "2 sin(a) - 2 cos(b)"),
        ("factor", "twice 2 cos(b)", "sin(a) - 2 2 cos(b)"),
        ("factor", "the factor 2 left out", "sin(a) - cos(b)"),
        ("factor", "the factor cos(b) left out", "sin(a) - 2"),
        ("factor", "the square of cos(b)", "sin(a) - 2 cos(b) cos(b)"),
        ("function", "cos of b for sin of a", "cos(b) - 2 cos(b)"),
        ("index", "b for a", "sin(b) - 2 cos(b)"),
        ("function", "sin of a for cos of b", "sin(a) - 2 sin(a)"),
        ("index", "a for b", "sin(a) - 2 cos(a)"),
    ]


def test_a_function_of_another_angle_is_far_fetched(d):
    """A sine is taken for another's cosine only where nothing nearer will do."""
    a, b, L = d.angle("a", "x"), d.angle("b", "x"), d.length("L", "x")
    changes = Changes(Pool(L * cos(a), (b,)))
    ranks = {c.words: c.rank for c in changes.whole(L * cos(a)) if c.kind == "function"}
    assert ranks == {"sin for cos of a": 1, "sin of b for cos of a": 8}


def test_a_cross_for_a_dot(d):
    u, w = d.unit_vector("u", "x"), d.unit_vector("w", "x")
    ((words, node),) = [
        (c.words, c.node) for c in Changes(Pool(u, (w,))).whole(u.cross(w).norm())
        if "product" in c.words
    ]  # fmt: skip
    assert words == "the dot product for the cross product of u and w"
    assert (node.left, node.right) == (u, w)
    of_sum = Changes(Pool(u, (w,))).whole((u + w).norm())
    assert not [c for c in of_sum if "product" in c.words]


def test_what_may_have_been_lost(d):
    a, L = d.angle("a", "x"), d.length("L", "x")
    found = told(sin(a), L)
    assert [words for kind, words, _ in found if " times " in words] == [
        "sin(a) times cos(a)", "sin(a) times sin(a)", "sin(a) times a", "sin(a) times L",
    ]  # fmt: skip
    assert [words for kind, words, _ in found if " divided by " in words] == [
        "sin(a) divided by cos(a)", "sin(a) divided by sin(a)", "sin(a) divided by a",
        "sin(a) divided by L",
    ]  # fmt: skip
    assert [words for kind, words, _ in told(2 * L, a) if kind == "lost term"] == [
        "L added", "L subtracted", "L cos(a) added", "L cos(a) subtracted", "L sin(a) added",
        "L sin(a) subtracted",
    ]  # fmt: skip
    assert not [
        words for kind, words, _ in told(number(0), a) if kind == "lost term" and "cos" in words
    ]


def test_numbers_are_taken_from_what_is_derived(d):
    a, year = d.angle("a", "x"), d.constant("year", 365, "days")
    derived = d.define("x", sin(a / year), because="a name")
    found = [words for kind, words, _ in told(sin(a / 366), derived) if kind == "number"]
    assert found == ["365 for 366"]


def test_every_change_changes_something(d):
    """A copy that is always equal to the print would mend nothing and cost time."""
    a, b, L = d.angle("a", "x"), d.angle("b", "x"), d.length("L", "x", range=(1.0, 2.0))
    u = d.unit_vector("u", "x")
    node = (L * sin(a + b) - u.y * cos(b) / sqrt(1 + u.x)) / (2 + sin(a))
    values = Values(Doubles(), sample(quantities(node), 5, 0))
    for change in Changes(Pool(node, ())).whole(node):
        with np.errstate(all="ignore"):
            assert not np.allclose(values.array(change.node), values.array(node)), change.words


def test_a_leading_minus_is_the_sign_of_its_term(d):
    a, b = d.angle("a", "x"), d.angle("b", "x")
    assert [(n, plain(t)) for n, t in terms_of(-sin(a) * cos(b) * a - b)] == [
        (True, "sin(a) cos(b) a"),
        (True, "b"),
    ]


def test_neighbours_come_before_strangers(d):
    n_xi, n_eta, other = (d.scalar(name, "x") for name in ("n_xi", "n_eta", "other"))
    length = d.length("L", "x")
    changes = Changes(Pool(n_xi, (other, length, n_eta)))
    assert [(c.words, c.rank) for c in changes.whole(n_xi) if c.kind == "index"] == [
        ("n_eta for n_xi", 2),
        ("other for n_xi", 8),
    ]


def test_components_and_dots(d):
    u = d.unit_vector("u", "x")
    w = d.unit_vector("w", "x")
    a = d.angle("a", "x")
    a_dot = a.rate()
    found = {words for _, words, _ in told(u.x + a, w)}
    assert {"u_y for u_x", "u_z for u_x", "w_x for u_x", "a_dot for a"} <= found
    assert ("dot too many", "a for a_dot", "a") in told(a_dot, a)


def test_symbols_of_the_paper_are_tried(d):
    paper = Paper("a_paper")
    n_1 = paper.scalar("n_1", "x")
    paper.scalar("n_2", "x")
    paper.define("n_3", 2 * n_1, because="a shorthand")
    words = [words for kind, words, _ in told(n_1, paper=paper) if kind == "index"]
    assert words == ["n_2 for n_1", "n_3 for n_1"]


def test_rotations_and_vectors(d):
    a, b = d.angle("a", "x"), d.angle("b", "x")
    product = elementary(Z, a) @ elementary(X, b)
    found = {(kind, words) for kind, words, _ in told(product)}
    assert {
        ("axis", "axis x for z of Rz(a)"),
        ("sign", "Rx(b) turning the other way"),
        ("order of factors", "Rx(b) before Rz(a)"),
        ("transposition", "the transpose of Rz(a) Rx(b)"),
        ("index", "b for a"),
    } <= found
    u, w = d.vector("u", "x"), d.vector("w", "x")
    found = {(kind, words) for kind, words, _ in told(u.cross(w) - 2 * u)}
    assert {
        ("sign", "plus for minus before 2 u"),
        ("term", "the term 2 u left out"),
        ("index", "w for u"),
    } <= found
    assert ("function", "cos for sin of a", "(cos(a), 0, 0)") in told(vector(sin(a), 0, 0))


def test_orders_of_a_product(d):
    a, L = d.angle("a", "x"), d.length("L", "x")
    steps = Chain("o").translate(Z, L).rotate(X, a).translate(Y, -L, frame="e").steps
    assert [words for _, words in orders(steps)] == [
        "Tz(L) and Rx(a) exchanged",
        "Rx(a) and Ty(-L) exchanged",
        "Tz(L) moved to stand at the end",
        "Ty(-L) moved to stand before Tz(L)",
    ]
    for moved, _ in orders(steps):
        assert sorted(map(id, moved)) == sorted(map(id, steps))
    found = {(c.kind, c.words) for c in misprints(steps, Changes(Pool(pose_of(steps), ())))}
    assert {
        ("axis", "axis y for x of Rx(a)"),
        ("axis", "axis x for y of Ty(-L)"),
        ("sign", "Rx(a) turning the other way"),
        ("sign", "minus for plus before L e_z"),
    } <= found


def test_walking_does_not_open_names(d):
    a = d.angle("a", "x")
    x = d.define("x", sin(a), because="a name")
    node = x * cos(a)
    assert stands_in(a, node)
    assert not stands_in(a, x)
    assert [type(p).__name__ for p in parts(node)] == [
        "Multiply", "ScalarReference", "Cosine", "Quantity",
    ]  # fmt: skip
    other = d.angle("b", "x")
    assert plain(replaced(node, {id(a): other})) == "x cos(b)"
    assert replaced(node, {id(other): a}) is node


def test_plain_text_keeps_brackets_where_they_matter(d):
    a, b, u = d.angle("a", "x"), d.angle("b", "x"), d.unit_vector("u", "x")
    assert plain((a + b) * (a - b) / (a * b)) == "(a + b) (a - b) / (a b)"
    assert plain(-(a + b)) == "-(a + b)"
    assert plain(a - (b - a)) == "a - (b - a)"
    assert plain(sqrt(u.x) + u.dot(u)) == "sqrt(u_x) + u . u"
    assert plain(where(a < b, a, b)) == "(a if a < b else b)"
    assert plain(v.unit(u + u)) == "unit(u + u)"


def test_a_lost_sign_of_differentiation(d):
    a, L = d.angle("a", "x"), d.length("L", "x")
    _, words, node = next(c for c in told(L * sin(a) / a) if c[0] == "lost d")
    assert words == "the derivative of L sin(a) by a for their quotient"
    assert node == "L cos(a)"
    assert not [c for c in told(L / sin(a)) if c[0] == "lost d"]  # by a symbol only


def test_arc_functions_and_half_turns(d):
    a, b = d.angle("a", "x"), d.angle("b", "x")
    assert ("function", "arcsin for arccos", "arcsin(a / b)") in told(arccos(a / b))
    assert ("function", "arccos for arcsin", "arccos(a / b)") in told(arcsin(a / b))
    assert ("index", "b for a", "arccos(b)") in told(arccos(a), b)
    turned = told(elementary(Z, a) @ elementary(X, b))
    assert ("half turn", "Rz(a) turning half a turn further", "Rz(a + pi) Rx(b)") in turned


def test_a_lost_divisor_may_be_a_number(d):
    a, b = d.angle("a", "x"), d.angle("b", "x")
    assert ("factor", "b divided by 60", "a + b / 60") in told(a + b, a + b / 60)


def test_parts_of_an_index(d):
    leg = d.index("leg", 3)
    L, W = d.length("L", "x", per=leg), d.length("W", "x")
    found = [(kind, words) for kind, words, _ in told(at(L, leg, 0))]
    assert ("index", "L_2 for L_1") in found
    assert ("index", "L_3 for L_1") in found
    assert ("function", "cos for sin of L") in [c[:2] for c in told(total(sin(L), over=leg))]
    # A length per leg is no candidate for a length of the whole.
    assert [words for kind, words, _ in told(W, at(L, leg, 0)) if kind == "index"] == []


def test_decimals_are_told_with_a_point():
    assert [plain(number(x)) for x in ("0.040849", "0.5", "1/3")] == ["0.040849", "1/2", "1/3"]
