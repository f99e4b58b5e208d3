# ruff: noqa: E501
"""Every wrong use names the file, the line and the mend."""

import re

import pytest

from armillary.derivation.errors import DerivationError
from armillary.derivation.load import load, load_all

HEAD = '''"""Demo."""

from armillary import *
from armillary import Chain, Derivation, Rate, X, Y, Z, cos, sin

derivation = d = Derivation("demo", title="Demo")
t = d.angle("t", "an angle", rate=Rate.TICK)
m = d.angle("m", "a slow angle", rate=Rate.DAY)
L = d.parameter.length("L", "a length")
r = d.define("r", L * sin(t), because="the arm turns")
'''
LINE = HEAD.count("\n") + 1

WRONG = {
    "a unit that does not fit": ('d.define("q", L + t, because="x")', "units in q.*do not fit"),
    "a sine of a length": ('d.define("q", sin(L), because="x")', "sine of a quantity in m: it takes an angle"),
    "a stated unit": ('from armillary.derivation.units import SECOND\nd.define("q", L * 2, because="x", unit=SECOND)', "q is stated in s, but its expression is in m"),
    "a turn by a length": ('d.define("q", Chain("g").rotate(X, L, frame="f").pose("g", "f"), because="x")', "a rotation of a quantity in m"),
    "a position in radians": ('d.define("q", Chain("g").translate(X, t, frame="f").pose("g", "f"), because="x")', "the position of a pose is in rad, it should be in m"),
    "a comparison of unlike units": ('d.define("q", where(L < t, 1, 2), because="x")', "a comparison.*do not fit"),
    "an undefined symbol": ('other = Derivation("other", title="Other")\nd.define("q", other.angle("z", "far"), because="x")', "uses z, which demo does not define"),
    "a reserved name, C": ('d.angle("double", "x")', "'double' cannot name a quantity: it is a C keyword"),
    "a reserved name, macro": ('d.angle("B0", "x")', "'B0' cannot name a quantity: it is a macro"),
    "a reserved name, complex.h": ('d.define("I", t, because="x")', "'I' cannot name a definition"),
    "a reserved name, Python": ('d.angle("lambda", "x")', "a Python keyword"),
    "a name with a space": ('d.angle("two words", "x")', "'two words' cannot name a quantity"),
    "a name with two underscores": ('d.angle("a__b", "x")', "cannot name"),
    "a second definition": ('d.define("r", t, because="x")', r"r is defined twice in demo"),
    "a quantity with a definition's name": ('d.angle("r", "x")', "r is defined twice"),
    "no reason": ('d.define("q", t, because="  ")', "q gives no reason"),
    "an unlisted input": ('d.kernel("k", inputs=[m], outputs=[r])', "result r of kernel k needs t, which is neither an input"),
    "a parameter as input": ('d.kernel("k", inputs=[t, L], outputs=[r])', "L is a parameter, not an input"),
    "no quantity as input": ('d.kernel("k", inputs=[r], outputs=[r])', "an input of kernel k is not a quantity"),
    "an output without a name": ('d.kernel("k", inputs=[t], outputs=[2 * r])', "an output is not a definition"),
    "two kernels of one name": ('d.kernel("k", inputs=[t], outputs=[r])\nd.kernel("k", inputs=[t], outputs=[r])', "two kernels of demo are named k"),
    "a whole wrench": ('from armillary import Wrench, vector\nd.kernel("k", inputs=[t], outputs={"w": Wrench(vector(0, 0, 0), vector(0, 0, 0))})', "which no kernel returns whole"),
    "a rate that is not there": ('d.define("q", time_derivative(sin(t)), because="x")', "t changes every tick, but it has no rate"),
    "a constant that is no number": ('d.constant("q", L, "x")', "the value of q is not a number"),
    "a system that is not there": ('d.use("moon")', "there is no system 'moon' to use"),
    "an error of Python": ("1 / 0", "ZeroDivisionError"),
    "an if on a condition": ("if t < m:\n    pass", "TypeError.*use where"),
    "a frame that is not there": ('Chain("g").pose("g", "h")', "no frame named 'h'"),
    "a syntax error": ("d.define(", "SyntaxError"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_file_line_and_mend(project, case):
    line, wanted = WRONG[case]
    root = project(demo=HEAD + line + "\n")
    path = root / "derivations" / "demo" / "derivation.py"
    with pytest.raises(DerivationError) as caught:
        load(path)
    text = str(caught.value)
    at = LINE + line.split("\n    ")[0].count("\n")
    if case == "a rate that is not there":
        at = HEAD.splitlines().index('t = d.angle("t", "an angle", rate=Rate.TICK)') + 1
    assert text.startswith(f"{path}:{at}: "), text
    assert re.search(wanted, text), text
    assert "\n  mend: " in text
    assert len(text.split("mend: ")[1]) > 10


def test_the_head_itself_is_right(project):
    """Else every case above would prove nothing."""
    root = project(demo=HEAD + 'd.kernel("k", inputs=[t], outputs=[r])\n')
    record = load(root / "derivations" / "demo" / "derivation.py")
    assert record.definitions["r"].source.line == LINE - 1
    assert record.definitions["r"].identifier == "demo-r"


def test_a_ring_of_use(project):
    text = (
        "from armillary import Derivation\n"
        'derivation = d = Derivation("{0}", title="x")\nd.use("{1}")\n'
    )
    root = project(a=text.format("a", "b"), b=text.format("b", "a"))
    with pytest.raises(DerivationError, match=r"use each other in a ring: .*a -> b -> a"):
        load(root / "derivations" / "a" / "derivation.py")


def test_a_file_without_a_derivation(project):
    root = project(demo="x = 1\n")
    with pytest.raises(DerivationError, match="the file makes no derivation") as caught:
        load(root / "derivations" / "demo" / "derivation.py")
    assert "derivation.py:1:" in str(caught.value)


def test_the_folder_and_the_name_agree(project):
    root = project(demo=HEAD.replace('"demo"', '"other"'))
    with pytest.raises(DerivationError, match="give both one name"):
        load(root / "derivations" / "demo" / "derivation.py")


def test_definitions_of_another_system(project):
    user = (
        "from armillary import Derivation\n"
        'derivation = d = Derivation("user", title="x")\n'
        'demo = d.use("demo")\n'
        'twice = d.define("twice", 2 * demo["r"], because="for the test")\n'
        'd.kernel("k", inputs=[demo.quantity("t")], outputs={"q": demo["r"] * 0 + 1})\n'
    )
    root = project(demo=HEAD, user=user)
    records = load_all(root / "derivations")
    assert set(records) == {"demo", "user"}
    assert records["user"].used["demo"].derivation is records["demo"]


def test_a_misspelt_definition_is_told_with_the_known_ones(project):
    user = (
        "from armillary import Derivation\n"
        'derivation = d = Derivation("user", title="x")\n'
        'd.use("demo")["rr"]\n'
    )
    root = project(demo=HEAD, user=user)
    with pytest.raises(
        DerivationError, match=r"derivation.py:3: demo defines no rr\n.*it defines r"
    ):
        load(root / "derivations" / "user" / "derivation.py")
