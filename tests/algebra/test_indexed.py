"""Like parts: sums, single parts, replaced nodes, and Newton's iteration, at fifty digits."""

import math

import pytest

from armillary import (
    Derivation,
    Status,
    any_of,
    at,
    cos,
    degrees,
    determinant,
    matrix,
    partial,
    sin,
    solve,
    solved,
    sqrt,
    substitute,
    time_derivative,
    total,
    vector,
    where,
)
from armillary.algebra.explicit import Explicit
from armillary.algebra.indexed import indices
from armillary.algebra.misuse import MisuseError
from armillary.derivation.errors import DerivationError
from armillary.derivation.symbols import leaves
from armillary.verify import exact
from armillary.verify.identities import prove


@pytest.fixture
def d():
    return Derivation("legs", title="Legs")


def three(d):
    return d.index("leg", 3)


def thirds(d, leg):
    return d.constant("theta", (0, degrees(120), degrees(-120)), "azimuth of a leg", per=leg)


def test_what_is_per_part_is_an_array_with_a_name_for_each(d):
    leg = three(d)
    r = d.length("r", "radius", per=leg)
    p = d.vector("joint", "joint", per=leg)
    assert r.shape == (3,)
    assert r.parts == ("r_1", "r_2", "r_3")
    assert p.shape == (3, 3)
    assert p.parts[:4] == ("joint_1_x", "joint_1_y", "joint_1_z", "joint_2_x")
    assert indices(r * p.x) == {leg}
    assert indices(total(r * p, over=leg)) == frozenset()
    assert indices(at(r, leg, 1)) == frozenset()


def test_a_sum_over_parts_is_the_sum_of_its_terms(d):
    leg = three(d)
    theta = thirds(d, leg)
    a = d.angle("a", "direction")
    spread = total(cos(a - theta) * cos(a - theta), over=leg)
    d.identity("three halves in every direction", spread, sqrt(2) * sqrt("1.125"))
    d.identity("the legs balance", total(vector(cos(theta), sin(theta), 0), over=leg),
               vector(0, 0, 0))  # fmt: skip
    d.identity("it could fail", total(cos(a - theta), over=leg), a * 0 + "0.1")
    found = [prove(identity) for identity in d.identities]
    assert [f.engine for f in found] == ["SymPy", "SymPy", "50 digits"]
    assert [f.worst <= f.tolerance for f in found] == [True, True, False]


def test_an_identity_is_proved_at_every_part(d):
    leg = three(d)
    theta = thirds(d, leg)
    d.identity("thirds of a turn", sin(3 * theta), theta * 0)
    d.identity("not all at the front", cos(theta), theta * 0 + 1)
    assert prove(d.identities[0]).engine == "SymPy"
    assert prove(d.identities[1]).worst == pytest.approx(1.5)


def test_derivatives_go_into_sums_and_parts(d):
    leg = three(d)
    theta = thirds(d, leg)
    a = d.angle("a", "direction")
    a_dot = a.rate()
    w = cos(a - theta)
    d.identity("of a sum", time_derivative(total(w * w * w, over=leg)),
               total(-3 * w * w * sin(a - theta) * a_dot, over=leg))  # fmt: skip
    d.identity("of a part", partial(at(w, leg, 2), a), -sin(a + degrees(120)))
    d.identity("of what is the same for all", partial(total(theta + 2 * a, over=leg), a),
               a * 0 + 6)  # fmt: skip
    assert [prove(i).engine for i in d.identities] == ["SymPy"] * 3


def test_substitution_keeps_what_does_not_change(d):
    a, b = d.angle("a", "first"), d.angle("b", "second")
    inner = d.define("inner", sin(a), because="named")
    kept = cos(b)
    whole = inner * kept
    turned = substitute(whole, {a: 2 * b})
    assert turned.right is kept
    assert Explicit()(turned) == Explicit()(sin(2 * b) * kept)
    assert {leaf.name for leaf in leaves(turned)} == {"b"}
    assert substitute(whole, {d.angle("c", "third"): 1}) is whole
    named = substitute(whole, {inner: "0.5"})
    assert Explicit()(named) == Explicit()(kept) / 2


def test_a_parameter_becomes_one_for_each_part(d):
    facet = d.index("facet", 4, letter="k")
    phi = d.parameter.angle("phi", "azimuth")
    each = d.constant("phi_k", tuple(degrees(90 * k) for k in range(4)), "azimuths", per=facet)
    point = vector(cos(phi), sin(phi), 0)
    assert indices(substitute(point, {phi: each})) == {facet}
    d.identity("the fourth points south", at(substitute(point, {phi: each}), facet, 3),
               vector(0, -1, 0))  # fmt: skip
    assert prove(d.identities[0]).engine == "SymPy"


def test_substitution_refuses_to_catch_an_index(d):
    leg = three(d)
    r, a = d.length("r", "radius", per=leg), d.length("a", "length")
    with pytest.raises(MisuseError, match="use another index"):
        substitute(total(r * a, over=leg), {a: r})
    with pytest.raises(MisuseError, match="expected a scalar"):
        substitute(r * a, {a: vector(1, 2, 3)})


def test_cramers_rule_takes_entries_of_unlike_units(d):
    x, y, z = (d.scalar(name, name) for name in ("x", "y", "z"))
    rows = [[x + 4, y, z], [z, x * y + 5, 1 + y], [y * z, x, 6 + z]]
    right = [x, y * y, z + 1]
    found = solved(rows, right)
    for k, (row, wanted) in enumerate(zip(rows, right, strict=True)):
        left = row[0] * found[0] + row[1] * found[1] + row[2] * found[2]
        d.identity(f"row {k}", left, wanted)
    book = Explicit()(matrix(*rows)).det()
    d.identity("two by two", determinant([[x, y], [z, x]]), x * x - y * z)
    assert all(prove(i).engine == "SymPy" for i in d.identities)
    assert (Explicit()(determinant(rows)) - book).expand() == 0
    (one,) = solved([[x + 4]], [y])
    assert Explicit()(one) == Explicit()(y / (x + 4))
    with pytest.raises(MisuseError, match="1 to 3"):
        determinant([[x] * 4] * 4)


def test_newton_finds_the_root_and_says_what_it_started_from(d):
    a = d.scalar("a", "a number", range=(1.0, 9.0))
    x, y = d.unknown("x", "root"), d.unknown("y", "root of the root")
    found = solve([x * x - a, y * y - x], {x: a, y: 2}, name="roots", steps=9)
    root = d.define("root", found[1], because="a fourth root")
    assert [leaf.name for leaf in leaves(root)] == ["a"]
    assert float(exact.text_book(root)({"a": 7.0})[0]) == pytest.approx(7**0.25, abs=1e-15)
    one_step = solve([x * x - a], {x: a}, name="step", steps=1)[0]
    assert float(exact.text_book(one_step)({"a": 3.0})[0]) == pytest.approx(2.0)


def test_newton_over_the_parts_of_an_index(d):
    pair = d.index("pair", 2)
    phase = d.constant("phase", (0, degrees(90)), "phase", per=pair)
    goal = d.scalar("goal", "what is wanted", per=pair)
    u, v = d.unknown("u", "first"), d.unknown("v", "second")
    residual = u * cos(phase) + v * v * sin(phase) - goal
    found = solve(residual, {u: 1, v: 1}, name="pairs", steps=9)
    values = [float(exact.text_book(f)({"goal": [0.3, 2.0]})[0]) for f in found]
    assert values == pytest.approx([0.3, math.sqrt(2)])


def test_newton_stays_within_its_bounds_and_finite_where_the_slope_vanishes(d):
    a = d.scalar("a", "a number")
    x = d.unknown("x", "unknown")
    held = solve([x - a], {x: 0}, name="held", steps=3, within={x: (-1, 1)})[0]
    assert [float(exact.text_book(held)({"a": a})[0]) for a in (-5.0, 0.25, 5.0)] == [-1, 0.25, 1]
    flat = solve([x * x + 1], {x: 0}, name="flat", steps=1)[0]
    assert float(exact.text_book(flat)({"a": 0.0})[0]) == -1


def test_a_copy_of_an_iteration_has_unknowns_of_its_own(d):
    a, b = d.scalar("a", "a number"), d.scalar("b", "another")
    x = d.unknown("x", "root")
    (root,) = solve([x * x - a], {x: 1}, name="root", steps=9)
    both = root + substitute(root, {a: b})
    assert {leaf.name for leaf in leaves(both)} == {"a", "b"}
    value = float(exact.text_book(both)({"a": 4.0, "b": 9.0})[0])
    assert value == pytest.approx(5.0)


def test_an_iteration_in_an_iteration(d):
    a = d.scalar("a", "a number")
    x, y = d.unknown("x", "inner"), d.unknown("y", "outer")
    (root,) = solve([x * x - a], {x: 1}, name="inner", steps=9)
    (fourth,) = solve([y * y - root], {y: root}, name="outer", steps=9)
    assert float(exact.text_book(fourth)({"a": 16.0})[0]) == pytest.approx(2.0)


def test_wrong_uses_of_iterations_are_told(d):
    a = d.scalar("a", "a number")
    x = d.unknown("x", "root")
    with pytest.raises(MisuseError, match="2 residuals for 1 unknowns"):
        solve([x - a, x], {x: 1}, name="s")
    with pytest.raises(MisuseError, match="iteration of 0 steps"):
        solve([x - a], {x: 1}, name="s", steps=0)
    (root,) = solve([x * x - a], {x: 1}, name="s")
    with pytest.raises(MisuseError, match="no derivative"):
        partial(root, a)
    with pytest.raises(DerivationError, match="an unknown outside its iteration"):
        d.kernel("k", inputs=[a], outputs={"y": x - a})


def test_wrong_uses_of_indices_are_told(d):
    leg = three(d)
    r = d.length("r", "radius", per=leg)
    with pytest.raises(DerivationError, match="2 values for 3 parts"):
        d.constant("t", (1, 2), "too few", per=leg)
    with pytest.raises(DerivationError, match="which is no index of legs"):
        d.length("s", "length", per=Derivation("other", title="Other").index("arm", 2))
    with pytest.raises(DerivationError, match="defined twice"):
        d.index("leg", 4)
    with pytest.raises(DerivationError, match="give a whole number from 1 up"):
        d.index("none", 0)
    with pytest.raises(DerivationError, match=r"write any_of\(condition, over=leg\)"):
        d.kernel("k", inputs=[r], outputs={"y": r}, cases=[(Status.LIMIT, r > r / 2, "long")])
    with pytest.raises(MisuseError, match="does not depend on"):
        total(number_of(d), over=leg)
    with pytest.raises(MisuseError, match="no part 3"):
        at(r, leg, 3)


def number_of(d):
    return d.scalar("n", "a number")


def test_any_of_and_where_run_over_parts(d):
    leg = three(d)
    theta = thirds(d, leg)
    a = d.angle("a", "direction")
    behind = any_of(cos(a - theta) < "-0.9", over=leg)
    value = where(behind, 1, 0)
    book = exact.text_book(value)
    assert [int(book({"a": x})[0]) for x in (0.0, math.pi)] == [0, 1]


def test_a_kernel_takes_the_parameters_that_are_declared_after_it(d):
    a = d.angle("a", "direction")
    d.parameter.length("r", "radius")
    d.kernel("k", inputs=[a], outputs={"y": 2 * a})
    d.parameter.length("s", "declared later")
    assert [q.name for q in d.kernels["k"].parameters] == ["r", "s"]
