"""Formulas: as they were written, and written out."""

import pytest

from armillary import (
    PI,
    Chain,
    Derivation,
    X,
    Y,
    Z,
    arccos,
    arcsin,
    atan2,
    cos,
    degrees,
    elementary,
    full_turn,
    hypot,
    number,
    sin,
    substitute,
    unit,
    vector,
    where,
    wrap,
)
from armillary.site.explicit import LONGEST_ENTRY, visible_length, written_out
from armillary.site.idioms import number_latex
from armillary.site.notation import Notation, definition_latex, subscripted
from armillary.site.steps import values_text
from armillary.site.structure import Structure


@pytest.fixture
def d():
    return Derivation("demo", title="Demo")


def latex(d, expression):
    return Structure(Notation(d))(expression)


def test_a_chain_is_the_product_of_its_joints(d):
    gamma, L_0, L_2 = d.angle("gamma", "."), d.length("L_0", "."), d.length("L_2", ".")
    chain = Chain("a").translate(Z, L_0).rotate(Z, -gamma).translate(Y, L_2, frame="b")
    assert latex(d, chain.pose("a", "b")) == (
        r"T_z\left(L_{0}\right)\,R_z\left(-\gamma\right)\,T_y\left(L_{2}\right)"
    )
    back = latex(d, chain.pose("b", "a"))
    assert back.startswith(r"\begin{bmatrix}")


def test_scalars_read_as_on_paper(d):
    x, y = d.scalar("x", "."), d.scalar("y", ".")
    cases = {
        x - (y - 1): r"x - \left(y - 1\right)",
        -(x + y): r"-\left(x + y\right)",
        x * (x + 1): r"x\,\left(x + 1\right)",
        x * x: r"{x}^2",
        (x / y) / y: r"\frac{x}{{y}^2}",
        2 * PI * x / 365: r"\frac{2\,\pi\,x}{365}",
        sin(x + y): r"\sin \left(x + y\right)",
        arcsin(x / y): r"\arcsin\left(\frac{x}{y}\right)",
        arccos(x / y): r"\arccos\left(\frac{x}{y}\right)",
        wrap(x): r"\operatorname{wrap}\left(x\right)",
        full_turn(x): r"x \bmod 2 \pi",
        where(
            x < y, 1, 0
        ): r"\begin{cases} 1 & \text{if } x < y \\ 0 & \text{otherwise} \end{cases}",
        hypot(x, y): r"\sqrt{{x}^2 + {y}^2}",
        atan2(y, x): r"\operatorname{atan2}\left(y,\; x\right)",
    }
    for expression, wanted in cases.items():
        assert latex(d, expression) == wanted
    assert latex(d, x > 0) == "x > 0"


def test_vectors_read_as_on_paper(d):
    a, b = d.vector("a", "."), d.vector("b", ".")
    assert latex(d, a.cross(b + a)) == r"\mathbf{a} \times \left(\mathbf{b} + \mathbf{a}\right)"
    assert latex(d, unit(a)) == r"\frac{\mathbf{a}}{\left\lVert \mathbf{a} \right\rVert}"
    assert latex(d, vector(0, 0, 1)) == r"\mathbf{e}_z"
    assert latex(d, a.x) == r"\mathbf{a}_{x}"


def test_rotations_read_as_on_paper(d):
    R, v, t = d.rotation("R", "."), d.vector("v", "."), d.angle("t", ".")
    R_1 = d.rotation("R_1", ".")
    cases = {
        R @ v: r"R\,\mathbf{v}",
        R.transpose() @ elementary(Z, t) @ v: r"R^\top\,R_z\left(t\right)\,\mathbf{v}",
        R.column(Z): r"R\,\mathbf{e}_z",
        R.entry(X, Z) + R_1.entry(Z, Y): r"R_{13} + R_{1,32}",
        R @ R_1.transpose(): r"R\,R_{1}^\top",
    }
    for expression, wanted in cases.items():
        assert latex(d, expression) == wanted
    turned = d.define("w", R.transpose() @ v, because=".")
    (definition,) = [x for x in d.definitions.values() if x.value is turned]
    body = written_out(Notation(d), definition).formula.latex
    assert r"R_{11}\,\mathbf{v}_x" in body or r"R_{11}\,\mathbf{v}_{x}" in body
    d.define("r", hypot(R.entry(X, Z), R.entry(Y, Z)), because=".")
    assert written_out(Notation(d), d.definitions["r"]) is None
    assert [values_text(R)] == [("rotations", "RᵀR = 1 ± 0.001")]


def test_numbers_print_as_they_were_written():
    values = {
        number("0.006918"): "0.006918",
        number("1e-6"): "0.000001",
        number("1e-9"): "10^{-9}",
        number(1): "1",
        degrees("23.45"): r"23.45^\circ",
        degrees(180): r"\pi",
    }
    for value, wanted in values.items():
        assert number_latex(value.value) == wanted


def test_what_a_name_stands_for_is_not_opened(d):
    x = d.scalar("x", ".")
    first = d.define("first", cos(x), because=".", latex="f + g")
    second = d.define("long_name", 2 * first, because=".")
    assert latex(d, d.definitions["long_name"].expression) == r"2\,\left(f + g\right)"
    assert definition_latex(d.definitions["long_name"]) == r"\text{long name}"
    assert second is not first


def test_subscripts_join():
    assert subscripted("L_0", "x") == "L_{0,x}"
    assert subscripted(r"\mathbf{c}_{12}", "x") == r"\mathbf{c}_{12,x}"
    assert subscripted(r"\mathbf{u}_\mathrm{r}", "x") == r"\mathbf{u}_{\mathrm{r},x}"
    assert subscripted(r"\dot{\mathbf{c}}", "x") == r"\dot{\mathbf{c}}_{x}"
    assert subscripted(r"\mathbf{F}_A^{*}", "11") == r"\mathbf{F}_{A,11}^{*}"
    assert subscripted(r"S_\mathrm{w}'", "x") == r"S_{\mathrm{w},x}'"
    assert subscripted(r"\mathbf{S}^{*}", "x") == r"\mathbf{S}^{*}_{x}"


def test_long_entries_get_a_name(d):
    angles = [d.angle(f"q_{k}", ".") for k in range(5)]
    chain = Chain("a")
    for k, q in enumerate(angles):
        chain = chain.rotate((X, Y, Z)[k % 3], q, frame=str(k))
    d.define("R", chain.rotation("a", "4"), because=".")
    found = written_out(Notation(d), d.definitions["R"])
    assert found is not None
    assert found.entries
    matrix = found.formula.latex.split(r"\begin{bmatrix}")[1].removesuffix(r"\end{bmatrix}")
    for row in matrix.split(r"\\"):
        for entry in row.split("&"):
            assert visible_length(entry) <= LONGEST_ENTRY
    assert "q_{0}" in found.compact


def test_a_plain_scalar_is_not_written_out_again(d):
    d.define("y", 2 * d.scalar("x", "."), because=".")
    assert written_out(Notation(d), d.definitions["y"]) is None


def test_a_component_of_what_was_replaced_keeps_its_brackets(d):
    x, y = (d.scalar(name, "a number") for name in ("x_in", "y_in"))
    whole = d.define("whole", vector(x, 2 * x, x * x), because="it is asked for", latex="S_w")
    part = substitute(whole, {x: y}).y
    assert latex(d, part) == r"\left(S_w\big\rvert_{x_{\mathrm{in}} = y_{\mathrm{in}}}\right)_y"
