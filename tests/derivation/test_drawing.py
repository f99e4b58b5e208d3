"""What a kernel says its inputs are drawn as: what is kept, and what is refused."""

import pytest

from armillary import Derivation, Matrix, near, number, vector
from armillary.derivation.errors import DerivationError
from armillary.derivation.fingerprint import kernel_digest, system_digest
from armillary.derivation.units import METRE, RADIAN
from armillary.program.sample import sample_points


class Record:
    """Two lengths and an angle to draw, and what to draw them by."""

    def __init__(self):
        self.d = d = Derivation("drawn", title="Drawn")
        self.leg, self.way = d.index("leg", 3), d.index("way", 2)
        self.t, self.b = d.angle("t", "angle"), d.length("b", "length")
        self.L = d.parameter.length("L", "length of a leg", per=self.leg)
        self.x, self.y = d.length("x", "drawn"), d.length("y", "drawn too")
        self.xs = d.length("xs", "drawn per leg", per=self.leg)
        self.pair = d.scalar("pair", "drawn in two ways", unit=RADIAN, per=self.way)
        self.c = d.unit_vector("c", "drawn direction")
        self.v = d.vector("v", "drawn position", unit=METRE)
        self.A = d.rotation("A", "drawn attitude")
        self.state = d.state.length("memory", "kept")
        self.u = d.unknown("u", "looked for", unit=METRE)
        self.half = d.constant("half", "0.5", "half a metre", unit=METRE)

    def kernel(self, drawn):
        self.d.kernel(
            "k",
            inputs=[self.x, self.y, self.xs, self.pair, self.c, self.v, self.A],
            outputs={"z": self.x + self.y},
            drawn=drawn,
        )
        return self.d.kernels["k"]


def test_what_is_drawn_is_kept_with_its_distance():
    r = Record()
    drawn = {
        r.x: r.b + r.half,
        r.y: near(2 * r.b, by=0.25),
        r.xs: r.L * number("0.5"),
        r.pair: Matrix(((r.t, -r.t),)),
    }
    made = r.kernel(drawn).drawn
    assert [(one.quantity.name, one.by) for one in made] == [
        ("x", 0.0), ("y", 0.25), ("xs", 0.0), ("pair", 0.0)
    ]  # fmt: skip
    assert [one.output.shape for one in made] == [(), (), (3,), (2,)]


def test_a_parameter_may_be_drawn_by_others():
    r = Record()
    sides = r.d.parameter.length("a", "one side"), r.d.parameter.length("ab", "both")
    (made,) = r.kernel({sides[1]: sides[0] + r.b}).drawn
    assert made.quantity is sides[1]
    for point in sample_points(r.d.kernels["k"], 5):
        assert point["ab"] == point["a"] + point["b"]


def test_what_is_drawn_counts_for_the_checks_and_not_for_the_kernel():
    digests = []
    for by in (None, 0.25, 0.5):
        r = Record()
        kernel = r.kernel({r.x: r.b} if by is None else {r.x: near(r.b, by=by)})
        digests.append((system_digest(r.d), kernel_digest(r.d, kernel)))
    systems, kernels = zip(*digests, strict=True)
    assert len(set(systems)) == 3
    assert len(set(kernels)) == 1


WRONG = {
    "no mapping": (lambda r: [r.x], "drawn= of kernel k is a value of type list, not a mapping"),
    "what is no input": (lambda r: {r.b: r.x}, "tells what b is, which is no input or"),
    "what is no quantity": (lambda r: {"x": r.b}, "tells what 'x' is, which is no input"),
    "another unit": (lambda r: {r.x: r.t}, "x of kernel k is drawn as is stated in m.*in rad"),
    "a pair in another unit": (lambda r: {r.pair: Matrix(((r.t, r.b),))}, "stated in rad.*in m"),
    "a vector for a scalar": (lambda r: {r.x: vector(r.b, r.b, r.b)}, r"is \(3,\), and x is a sc"),
    "one for each leg": (lambda r: {r.x: r.L}, r"is \(3,\), and x is a scalar.*\n.*runs over it"),
    "one for all legs": (lambda r: {r.xs: r.b}, r"is a scalar, and xs is \(3,\)"),
    "a condition": (lambda r: {r.x: r.b < 1 * r.half}, "no value of an input, and x is a scalar"),
    "a number": (lambda r: {r.x: 3}, "x of kernel k is drawn as is 3, not an expression"),
    "one that is drawn too": (lambda r: {r.x: r.y, r.y: r.b}, "expression of y, which is drawn by"),
    "itself": (lambda r: {r.x: 2 * r.x}, "expression of x, which is drawn by"),
    "a state": (lambda r: {r.x: r.state}, "an expression of memory, which is a state"),
    "an unknown": (lambda r: {r.x: r.u}, "an expression of u, which is an unknown"),
    "near a direction": (lambda r: {r.c: near(vector(1, 0, 0), by=0.1)}, "is near a unit vector"),
    "near by nothing": (lambda r: {r.x: near(r.b, by=0)}, "is off by 0.*\n.*a number above 0"),
    "near by a quantity": (lambda r: {r.x: near(r.b, by=r.b)}, "is off by a value of type Quan"),
    "no rotation": (lambda r: {r.A: Matrix((((0 * r.t),) * 3,) * 3)}, r"and A is \(3, 3\)"),
}


@pytest.mark.parametrize("case", WRONG)
def test_wrong_use_names_line_and_mend(case):
    make, why = WRONG[case]
    r = Record()
    with pytest.raises(DerivationError, match=why) as caught:
        r.kernel(make(r))
    assert "test_drawing.py:" in str(caught.value)
    assert "\n  mend: " in str(caught.value)


def test_a_quantity_of_another_derivation_is_refused():
    r = Record()
    other = Derivation("other", title="Other").length("outer", "length")
    with pytest.raises(DerivationError, match="uses outer, which drawn does not define"):
        r.kernel({r.x: other})
