"""Truncations against SymPy's derivatives, Taylor coefficients of mpmath, and measured slopes."""

from math import inf

import mpmath
import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from armillary import (
    Chain,
    Derivation,
    Matrix,
    Pose,
    Twist,
    Wrench,
    X,
    Y,
    Z,
    absolute,
    arccos,
    arcsin,
    atan2,
    cos,
    direction_angles,
    elementary,
    hypot,
    partial,
    sin,
    sqrt,
    truncate,
    unit,
    vector,
    where,
)
from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.explicit import Explicit, symbol
from armillary.algebra.misuse import MisuseError
from armillary.algebra.rotation import Composed, RotationSymbol, transpose
from armillary.derivation.units import check_block
from armillary.program.arithmetic import Floats
from armillary.site.notation import Notation
from armillary.site.structure import Structure
from armillary.verify.exact import text_book
from armillary.verify.remainder import remainder_order
from tests import expressions
from tests.programs import program_of, value_of

record = d = Derivation("mount", title="A mount with errors")
theta = d.parameter.angle("theta", "lean to the north", range=(-0.1, 0.1))
psi = d.parameter.angle("psi", "lean to the east", range=(-0.1, 0.1))
chi = d.parameter.angle("chi", "inclination of the second axis", range=(-0.1, 0.1))
a = d.angle("a", "first drive angle")
b = d.angle("b", "second drive angle")
p = d.vector("p_0", "a point", range=(0.5, 1.5))
e = d.vector("e", "a small displacement", range=(-0.1, 0.1))
SMALL = (theta, psi, chi)
AT = {"theta": 3, "psi": 5, "chi": -7, "a": 11, "b": -4, "p_0_x": 9, "p_0_y": 6, "p_0_z": 13,
      "e_x": 2, "e_y": -3, "e_z": 8, "x": 12, "y": -22, "c_x": 5, "c_y": -14, "c_z": 8}  # fmt: skip
POINT = {symbol(name): sympy.Rational(k, 17) for name, k in AT.items()}

base = elementary(0, psi) @ elementary(1, theta)
drive = elementary(1, b) @ elementary(0, chi) @ elementary(2, a)
carried = drive @ (base @ p)
named = d.define("carried", carried, because="It is named.", meaning="point on the mirror")
length = d.define("length", named.norm(), because="It is named.", meaning="its distance")

SCALARS = {
    "sum": theta + a * psi - 2,
    "product of two small ones": theta * psi * cos(a),
    "square": (1 + theta + psi) ** 2,
    "sine of a sum": sin(a + theta * psi + 2 * chi),
    "cosine of a small angle": cos(theta + psi),
    "quotient": (a + theta) / (3 + psi * a - chi),
    "root": sqrt(2 + sin(a) + theta - psi * chi),
    "root of a square": sqrt(p.dot(p) * p.dot(p) + theta),
    "atan2": atan2(sin(a) + theta, 2 + cos(a) * psi),
    "atan2 of numbers at zero": atan2(theta, 1 + psi),
    "atan2 behind": atan2(theta - 1, psi - 2),
    "arcsin": arcsin((sin(a) + theta * psi + chi) / 2),
    "arcsin of a small one": arcsin(theta + psi * a),
    "arccos": arccos((sin(a) + theta * psi + chi) / 2),
    "absolute of what is negative": absolute(theta - 2) * psi,
    "absolute": absolute(sin(a) - 3 + theta),
    "select": where(a < 3 + theta, sin(theta + a), cos(psi)),
    "select that is decided": where(theta - psi < 1, sin(theta + a), cos(psi)),
    "and, not": where((a < 3 + theta) & ~(psi > 1) & (chi < b + 5), theta * a, psi),
    "length": (p + theta * p.cross(vector(1, a, psi))).norm(),
    "length of what turns": carried.norm() * theta,
    "square of what turns": carried.dot(carried) + chi,
    "dot": carried.dot(base @ vector(a, 1, psi)),
    "named": length * psi + named.x,
    "azimuth": direction_angles(carried)[0],
    "elevation": direction_angles(carried)[1],
    "azimuth of a unit vector": direction_angles(unit(carried + p))[0],
    "elevation of a turned unit vector": direction_angles(-(base @ unit(p + theta * p)))[1],
    "elevation of a sum": direction_angles(carried + theta * p)[1],
    "slope of an azimuth": partial(direction_angles(carried)[0], b),
    "slope of an elevation": partial(direction_angles(carried)[1], a),
}
VECTORS = {
    "components": vector(sin(theta), a * psi, 1),
    "turned": carried,
    "small turns of an axis": base @ vector(1, 0, 0),
    "axis": base.column(2),
    "turned by a sum of angles": elementary(1, a + theta + psi * chi) @ p,
    "turned by opposites": (base @ transpose(base)) @ (theta * p),
    "cross": carried.cross(base @ vector(0, 0, 1)),
    "cross with an axis": v.cross(v.Basis(1), carried) + v.cross(carried, v.Basis(0)),
    "scaled": sin(theta + a) * (carried / (2 + psi)),
    "unit": unit(carried + theta * p),
    "unit of components": unit(vector(1, theta, psi)),
    "unit of an axis": unit(base.column(2) + chi * p),
    "a small vector": unit(p + e) + theta * e.cross(p),
    "negation": -carried - theta * p,
    "choice": v.choice(carried, carried, carried),
    "named": named * theta - named,
}


def matrix_of(node):
    form = Explicit()(node)
    return form if isinstance(form, sympy.MatrixBase) else sympy.Matrix([form])


def names_of(small):
    return {n for q in small for n in ([q.name] if isinstance(q, s.Symbol) else q.parts)}


def by_sympy(node, small, order):
    """The coefficients of s^0 ... s^order, by SymPy's derivatives in s at 0."""
    scale, names = sympy.Symbol("s", real=True), names_of(small)
    # Numbers first: SymPy differentiates a function of s alone.
    point = {x: value * scale if x.name in names else value for x, value in POINT.items()}
    form = matrix_of(node).subs(point, simultaneous=True)
    for k in range(order + 1):
        term = (form.diff(scale, k) if k else form).subs(scale, 0) / sympy.factorial(k)
        with mpmath.workdps(50):
            yield [mpmath.mpf(sympy.N(x, 50)) for x in term]


def by_mpmath(node, small, order):
    """The same by numeric differentiation; every call works at the precision it is called at."""
    names, symbols = names_of(small), list(POINT)
    function = sympy.lambdify(symbols, list(matrix_of(node)), modules="mpmath", cse=True)

    def along(i):
        def at(scale):
            values = (mpmath.mpf(x.p) / x.q for x in POINT.values())
            pairs = zip(symbols, values, strict=True)
            return function(*(scale * x if n.name in names else x for n, x in pairs))[i]

        return at

    with mpmath.workdps(50):
        entries = range(len(matrix_of(node)))
        columns = [mpmath.taylor(along(i), 0, order) for i in entries]
    return list(zip(*columns, strict=True))


def value_of_entries(node):
    function = sympy.lambdify(list(POINT), list(matrix_of(node)), modules="mpmath", cse=True)
    with mpmath.workdps(50):
        return function(*(mpmath.mpf(x.p) / x.q for x in POINT.values()))


def agree(node, wanted):
    with mpmath.workdps(50):
        pairs = zip(value_of_entries(node), wanted, strict=True)
        errors = [abs(found - w) / (1 + abs(w)) for found, w in pairs]
    assert max(errors) < 1e-35


def hold(node, small, order, way=by_mpmath):
    made = truncate(node, order, small)
    wanted = list(way(node, small, order + 1))
    for part, coefficients in zip([*made.terms, made.remainder], wanted, strict=True):
        agree(part, coefficients)
    with mpmath.workdps(50):
        totals = [mpmath.fsum(entry[:-1]) for entry in zip(*wanted, strict=True)]
    agree(made.value, totals)


# SymPy takes minutes for the derivatives of these; numeric differentiation does not.
LONG = ("azimuth", "elevation", "slope", "unit", "length", "named", "square of what", "a small",
        "dot", "scaled", "cross")  # fmt: skip


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("name", SCALARS)
def test_scalars_agree_with_taylor(name, order):
    hold(SCALARS[name], SMALL, order)


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("name", VECTORS)
def test_vectors_agree_with_taylor(name, order):
    hold(VECTORS[name], (*SMALL, e), order)


@pytest.mark.parametrize("name", [n for n in SCALARS | VECTORS if not n.startswith(LONG)])
def test_short_ones_agree_with_sympy(name):
    hold((SCALARS | VECTORS)[name], SMALL, 2, by_sympy)


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("block", [
    base, drive, drive @ base, transpose(drive),
    Pose(base, carried), Twist(carried, p + theta * p), Wrench(base @ p, p),
    Matrix(((theta * psi, cos(theta)), (a, 1 / (1 + chi)))),
], ids=["base", "drive", "both", "inverse", "pose", "twist", "wrench", "matrix"])  # fmt: skip
def test_blocks_agree_with_sympy(block, order):
    hold(block, SMALL, order, by_sympy)


def hold_at_random(node, small, order):
    try:
        hold(node, small, order)
    except MisuseError:
        assume(False)


@settings(max_examples=50, deadline=None)
@given(node=expressions.SCALARS, both=st.booleans())
def test_random_scalars_agree_with_taylor(node, both):
    hold_at_random(node, (expressions.x, expressions.y) if both else (expressions.x,), 3)


@settings(max_examples=20, deadline=None)
@given(node=expressions.VECTORS, both=st.booleans())
def test_random_vectors_agree_with_taylor(node, both):
    hold_at_random(node, (expressions.x, expressions.y) if both else (expressions.x,), 2)


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("node", [
    carried, drive @ base, unit(carried + theta * p), direction_angles(carried)[0],
    direction_angles(carried)[1], sqrt(2 + theta - psi), atan2(1 + theta, 2 + psi * a + chi),
], ids=["vector", "rotation", "unit", "azimuth", "elevation", "root", "atan2"])  # fmt: skip
def test_the_error_falls_as_the_next_order(node, order):
    made = truncate(node, order, SMALL)
    assert abs(remainder_order(made, n=4) - (order + 1)) < 1e-3


def degrees_of(entry):
    polynomial = sympy.Poly(sympy.expand(entry), *(symbol(q.name) for q in SMALL))
    return [sum(powers) for powers, value in polynomial.terms() if value != 0]


@pytest.mark.parametrize("order", [1, 2, 3])
def test_no_entry_is_of_mixed_order(order):
    made = truncate(drive @ base, order, SMALL)
    kept = [k for entry in matrix_of(made.value) for k in degrees_of(entry)]
    assert max(kept) == order
    for k, term in enumerate([*made.terms, made.remainder]):
        assert {n for entry in matrix_of(term) for n in degrees_of(entry)} == {k}


def test_a_first_order_matrix_is_one_and_a_skew_one():
    found = matrix_of(truncate(base, 1, (theta, psi)).value)
    t, u = symbol("theta"), symbol("psi")
    assert found == sympy.Matrix([[1, 0, t], [0, 1, -u], [-t, u, 1]])


@pytest.mark.parametrize("order", [1, 2, 3])
def test_a_truncated_rotation_is_orthonormal_to_its_order(order):
    found = matrix_of(truncate(base @ elementary(2, chi), order, SMALL).value)
    defect = (found.T * found - sympy.eye(3)).applyfunc(sympy.expand)
    assert min(k for entry in defect if entry != 0 for k in degrees_of(entry)) == order + 1


def test_what_does_not_change_is_the_node_itself():
    still = unit(elementary(2, a) @ p)
    assert truncate(still, 2, SMALL).value is still
    free = truncate(length, 2, (d_free,))
    assert free.value is length
    assert s.is_zero(free.remainder)
    assert truncate(d_named + theta, 1, SMALL).terms[0] is d_named
    matrix = Matrix(((a, b), (b, a)))
    assert truncate(matrix, 1, SMALL).value is matrix


d_free = d.angle("free", "an angle that nothing here stands on")
d_named = d.define("named_still", hypot(a, b), because="It is named.", meaning="a length")


def test_turns_that_are_not_small_stay_turns():
    rotation = elementary(2, a) @ elementary(0, b)
    value = truncate(rotation @ (base @ p), 1, SMALL).value
    assert isinstance(value, v.Rotated)
    assert value.rotation is rotation or isinstance(value.rotation, Composed)
    given = RotationSymbol("R")
    assert isinstance(truncate(given @ (base @ p), 2, SMALL).value, v.Rotated)


def test_null_and_identity():
    assert truncate(s.ZERO, 1, SMALL).value is s.ZERO
    assert v.is_null(truncate(v.NULL, 3, SMALL).value)
    nothing = truncate(Composed(()), 2, SMALL)
    assert matrix_of(nothing.value) == sympy.eye(3)
    assert matrix_of(nothing.remainder) == sympy.zeros(3, 3)
    assert remainder_order(truncate(theta * a, 1, SMALL), n=2) == inf


@pytest.mark.parametrize(
    ("node", "order", "small", "said"),
    [
        (sin(theta), 0, SMALL, "whole order"),
        (sin(theta), -1, SMALL, "whole order"),
        (sin(theta), True, SMALL, "whole order"),
        (sin(theta), 1.0, SMALL, "whole order"),
        (sin(theta), 1, (), "no small quantity"),
        (sin(theta), 1, "theta", "no small quantity"),
        (sin(theta), 1, (theta + psi,), "a small quantity is"),
        (sin(theta), 1, ("theta",), "a small quantity is"),
        (theta < psi, 1, SMALL, "have series"),
        ("theta", 1, SMALL, "have series"),
        (1 / theta, 1, SMALL, "a denominator vanishes"),
        (sin(theta) / theta, 1, SMALL, "a denominator vanishes"),
        (1 / (cos(theta) - 1), 1, SMALL, "a denominator vanishes"),
        (1 / (sin(a) ** 2 + cos(a + theta) ** 2 - 1), 1, SMALL, "a denominator vanishes"),
        (sqrt(theta + psi), 1, SMALL, "under a square root vanishes"),
        (sqrt(where(a < b, 1 + theta, 0)), 1, SMALL, "under a square root vanishes"),
        (hypot(theta, psi), 1, SMALL, "under a square root vanishes"),
        (vector(theta, psi, 0).norm(), 1, SMALL, "the length of a vector vanishes"),
        (unit(base @ vector(theta, psi, 0)), 1, SMALL, "the length of a vector vanishes"),
        (atan2(theta, psi), 1, SMALL, "the point of an atan2 vanishes"),
        (atan2(theta * a, cos(b) - cos(b + psi)), 1, SMALL, "the point of an atan2 vanishes"),
        (direction_angles(base.column(2))[0], 1, SMALL, "the point of an atan2 vanishes"),
        (direction_angles(base.column(2))[1], 1, SMALL, "under a square root vanishes"),
        (arcsin(1 - theta), 1, SMALL, "under a square root vanishes"),
        (absolute(theta), 1, SMALL, "an absolute value vanishes"),
        (where(theta < psi, theta, 0), 1, SMALL, "a condition changes"),
        (where(cos(a) < cos(a + theta), theta, 0), 1, SMALL, "a condition changes"),
    ],
)
def test_what_has_no_series_is_refused_with_a_mend(node, order, small, said):
    with pytest.raises(MisuseError, match=said) as caught:
        truncate(node, order, small)
    assert caught.value.mend


def test_a_unit_vector_is_not_small():
    sun = d.unit_vector("sun", "to the sun")
    with pytest.raises(MisuseError, match="is not small"):
        truncate(carried.dot(sun), 1, (sun,))


def test_a_truncated_rotation_is_defined_and_printed_and_compiled():
    own = Derivation("small", title="Small")
    t = own.parameter.angle("t", "a small angle", range=(-0.1, 0.1))
    q = own.angle("q", "an angle")
    mount = Chain("ground").rotate(X, t).rotate(Z, q).rotate(Y, t, frame="top")
    made = truncate(mount.rotation("ground", "top"), 2, (t,))
    R = own.define("R", made.value, because="Truncated.", meaning="a rotation, to second order")
    assert check_block(made.value) is None
    assert Structure(Notation(own))(made.value)
    program = program_of(own, [q], {"R": R})
    row = {"t": 0.03, "q": 0.8}
    found = value_of(program, row, "R", Floats())
    wanted = text_book(mount.rotation("ground", "top"))(row)
    assert max(abs(x - float(y)) for x, y in zip(found, wanted, strict=True)) < 0.06**3 / 6
