# ruff: noqa: E501
"""Every wrong use names the file, the line and the mend."""

import re

import pytest

from armillary import Derivation
from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.load import load, load_all
from armillary.derivation.names import check_name
from armillary.program.compile import compile_kernel

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
    "a position in radians": ('d.define("q", Chain("g").translate(X, t, frame="f").pose("g", "f"), because="x")', "the position of a pose is in rad, it should be in m\n  mend: a position is made of lengths"),
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
    "a rate of a rotation": ('R = d.rotation("R", "attitude"); d.define("q", time_derivative(R @ vector(1, 2, 3)), because="x")', "R changes every tick, and a rotation has no rate\n  mend: declare it with rate=Rate.DAY"),
    "a name that an entry has": ('R, e = d.rotation("R", "attitude"), d.length("R_23", "length"); d.kernel("k", inputs=[R, e], outputs={"z": R.entry(X, Z) * e})', "two arguments that print as R_23\n  mend: rename one of them.*R_11 to R_33"),
    "a fourth row": ('d.define("q", d.rotation("R", "attitude").entry(3, Z), because="x")', "a rotation has no row or column 3\n  mend: rows and columns count from 0 to 2"),
    "a constant that is no number": ('d.constant("q", L, "x")', "the value of q is not a number"),
    "a system that is not there": ('d.use("moon")', "there is no system 'moon' to use"),
    "an error of Python": ("1 / 0", "ZeroDivisionError"),
    "an if on a condition": ("if t < m:\n    pass", "a condition has no value.*\n  mend: use where"),
    "a frame that is not there": ('Chain("g").pose("g", "h")', "no frame named 'h'"),
    "a syntax error": ("d.define(", "SyntaxError"),
    "a comparison with ==": ('d.define("q", where(t == 1, t, m), because="x")', "a condition is wanted, not False: == does not compare here\n  mend: use < and >"),
    "an == behind &": ('d.define("q", where((t < m) & (t == 1), t, m), because="x")', "== does not compare here"),
    "an == before &": ('d.define("q", where((t == 1) & (t < m), t, m), because="x")', "== does not compare here"),
    "an == turned round": ('d.define("q", where(~int(t == 1), t, m), because="x")', "a condition is wanted, not -1"),
    "an == as a number": ('d.define("q", (t == 1) * t, because="x")', "False is not a number: == does not compare here"),
    "a comparison with <=": ('d.define("q", where(t <= m, t, m), because="x")', "<= does not compare.*\n  mend: write ~\\(a > b\\)"),
    "a condition with |": ('d.define("q", where((t < m) | (m < t), t, m), because="x")', "\\| does not join"),
    "a quantity as condition": ('d.define("q", where(t, t, m), because="x")', "a condition is wanted, not a value of type Quantity"),
    "a macro of float.h": ('d.angle("FLT_MAX", "x")', "'FLT_MAX' cannot name a quantity: it is one of a family.*\n  mend: .*flt_max"),
    "a name of the generated headers": ('d.define("ARMILLARY_x", t, because="x")', "'ARMILLARY_x' cannot name a definition"),
    "a macro of windows.h": ('d.angle("near", "x")', "'near' cannot name a quantity: it is a macro of <windows.h>"),
    "a result with a macro's name": ('d.kernel("k", inputs=[t], outputs={"OUT": r})', "'OUT' cannot name a result"),
    "a kernel named step": ('d.kernel("step", inputs=[t], outputs=[r])', "'step' cannot name a kernel: it is used by the generated kernels"),
    "a kernel named NamedTuple": ('d.kernel("NamedTuple", inputs=[t], outputs=[r])', "'NamedTuple' cannot name a kernel"),
    "a system named math": ('Derivation("math", title="x")', "'math' cannot name a derivation: it is the name of a C header"),
    "limits that are not finite": ('d.angle("q", "x", limits=(0.0, float("inf")))', "limits= of q holds inf, which is not finite"),
    "a range that is not finite": ('d.angle("q", "x", range=(float("nan"), 1.0))', "range= of q holds nan"),
    "limits turned round": ('d.angle("q", "x", limits=(1.0, -1.0))', "limits= of q is \\(1, -1\\): the first must be the smaller"),
    "an empty range": ('d.angle("q", "x", range=(1.0, 1.0))', "range= of q is \\(1, 1\\)"),
    "limits beyond f32": ('d.scalar("q", "x", limits=(0.0, 1e31))', "limits= of q holds 1e\\+31, which is beyond 1e\\+30"),
    "limits of one number": ('d.scalar("q", "x", limits=5)', "limits= of q is not a pair of numbers"),
    "a range outside the limits": ('d.angle("q", "x", limits=(0.0, 1.0), range=(0.0, 2.0))', "the range of q, \\(0, 2\\), is not inside its limits \\(0, 1\\)"),
    "a length with negative limits": ('d.length("q", "x", limits=(-1.0, 1.0))', "q is never negative, but its limits= begin at -1"),
    "no meaning": ('d.angle("q", " ")', "q has no meaning"),
    "a constant without meaning": ('d.constant("q", 1, "")', "q has no meaning"),
    "a case without a reason": ('d.kernel("k", inputs=[t], outputs=[r], cases=[(Status.SINGULAR, t < 0)])', "a case of kernel k is not a triple"),
    "a case that is not in a list": ('d.kernel("k", inputs=[t], outputs=[r], cases=(Status.SINGULAR, t < 0, "x"))', "a case of kernel k is not a triple"),
    "a case with a number": ('d.kernel("k", inputs=[t], outputs=[r], cases=[(2, t < 0, "x")])', "a case of kernel k begins with 2, not with a Status"),
    "a case that is OK": ('d.kernel("k", inputs=[t], outputs=[r], cases=[(Status.OK, t < 0, "x")])', "a case of kernel k answers OK"),
    "a case of the guards": ('d.kernel("k", inputs=[t], outputs=[r], cases=[(Status.OUT_OF_RANGE, t < 0, "x")])', "answers OUT_OF_RANGE, which belongs to the limits.*\n  mend: declare limits="),
    "a case of ==": ('d.kernel("k", inputs=[t], outputs=[r], cases=[(Status.LIMIT, t == 0, "x")])', "a case of kernel k has no condition: .*== does not compare here"),
    "a case that says nothing": ('d.kernel("k", inputs=[t], outputs=[r], cases=[(Status.LIMIT, t < 0, "")])', "a case of kernel k says nothing"),
    "a case of unlike units": ('d.kernel("k", inputs=[t], outputs=[r], cases=[(Status.LIMIT, t < L, "x")])', "units in the case LIMIT of kernel k: a comparison.*do not fit"),
    "no outputs": ('d.kernel("k", inputs=[t], outputs=[])', "kernel k has no outputs"),
    "no outputs in a mapping": ('d.kernel("k", inputs=[t], outputs={})', "kernel k has no outputs"),
    "one output without a list": ('d.kernel("k", inputs=[t], outputs=r)', "outputs= is a value of type ScalarReference, not a list\n  mend: write outputs=\\[...\\]"),
    "one input without a list": ('d.kernel("k", inputs=t, outputs=[r])', "inputs= is a value of type Quantity, not a list"),
    "an identity of unlike units": ('d.identity("so", L, t)', "identity 'so' compares m with rad"),
    "an identity with wrong units inside": ('d.identity("so", t, L + t)', "units in the right side of identity 'so': a sum.*do not fit"),
    "an identity of unlike shapes": ('d.identity("so", t, vector(t, t, t))', "identity 'so' compares a scalar with a vector"),
    "an identity of unlike matrices": ('d.identity("so", Chain("g").rotate(X, t, frame="f").pose("g", "f"), elementary(X, t))', "compares a 4 by 4 matrix with a 3 by 3 matrix"),
    "an identity of unlike kinds": ('n = vector(0, 0, 0)\nd.identity("so", Twist(n, n), Wrench(n, n))', "compares a twist with a wrench"),
    "an identity of conditions": ('d.identity("so", t < m, m > t)', "identity 'so' compares conditions"),
    "an identity with a number": ('d.identity("so", t, 3)', "the right side of identity 'so' is 3, not an expression\n  mend: wrap numbers in number"),
    "a number for an expression": ('d.define("q", 3, because="x")', "definition q is 3, not an expression\n  mend: wrap numbers in number"),
    "nothing for an expression": ('d.define("q", None, because="x")', "definition q is None, not an expression\n  mend: .*return"),
    "a list for an expression": ('d.define("q", [t, t, t], because="x")', "definition q is a value of type list.*\n  mend: .*vector"),
    "a truth value for an expression": ('d.define("q", t == m, because="x")', "definition q is False.*\n  mend: == does not compare"),
    "SymPy's for an expression": ('import sympy\nd.define("q", sympy.pi, because="x")', "definition q is a value of type Pi.*\n  mend: wrap numbers in number"),
    "a chain for an expression": ('d.define("q", Chain("g"), because="x")', "definition q is a value of type Chain.*\n  mend: ask the chain"),
    "a method for an expression": ('d.define("q", t.rate, because="x")', "definition q is a value of type method.*\n  mend: call it"),
    "a number for a result": ('d.kernel("k", inputs=[t], outputs={"q": 3})', "result q is 3, not an expression"),
    "a number that is none": ('number(float("nan"))', "nan is not a number\n  mend: give a finite number"),
    "a word for a number": ('d.define("q", t + "one", because="x")', "'one' is not a number"),
    "SymPy's symbol for a number": ('import sympy\nd.define("q", t + sympy.Symbol("z"), because="x")', "z of SymPy is not a real number"),
    "a name nobody knows": ('d.define("q", t * zeta, because="x")', "NameError: name 'zeta' is not defined\n  mend: declare zeta above this line, or import it"),
    "a library that is not there": ("import there_is_no_such_thing", "ModuleNotFoundError.*\n  mend: correct the spelling of there_is_no_such_thing, or install it"),
    "a word that armillary lacks": ("from armillary import sinus", "ImportError.*\n  mend: import words that armillary has: .*sin"),
    "a module that armillary lacks": ("import armillary.sinus", "ModuleNotFoundError.*\n  mend: import what a derivation needs with"),
    "a sine of Python": ('import math\nd.define("q", math.sin(t), because="x")', "TypeError.*\n  mend: use armillary.sin, not math.sin"),
    "an arc tangent of NumPy": ('import numpy as np\nd.define("q", np.arctan2(t, m), because="x")', "AttributeError.*\n  mend: use armillary.atan2, not np.arctan2"),
    "a sine of NumPy": ('import numpy as np\nd.define("q", np.sin(t), because="x")', "TypeError.*\n  mend: use armillary.sin, not np.sin"),
    "a sine of SymPy": ('import sympy\nd.define("q", sympy.sin(t), because="x")', "SympifyError.*\n  mend: use armillary.sin, not sympy.sin"),
    "a function without a word": ('import math\nd.define("q", math.tan(t), because="x")', "mend: use sin\\(x\\) / cos\\(x\\), not math.tan"),
    "a function that is not ours": ('import math\nd.define("q", math.exp(t), because="x")', "TypeError.*\n  mend: use armillary.sin, armillary.cos, ..., not the functions"),
    "a bare absolute value": ('d.define("q", abs(t), because="x")', "mend: use armillary.absolute"),
    "no because": ('d.define("q", t)', "because.*\n  mend: say in because= why"),
    "a meaning left out": ('d.angle("q")', "meaning.*\n  mend: say in a few words what it is"),
    "an argument nobody knows": ('d.angle("q", "x", limit=(0, 1))', "unexpected keyword.*\n  mend: correct the spelling of that argument"),
    "a broken power": ('d.define("q", t**0.5, because="x")', "only whole powers.*not 0.5\n  mend: use sqrt"),
    "a negative power": ('d.define("q", t**-1, because="x")', "only whole powers.*not -1\n  mend: .*1 / x"),
    "a vector and a number": ('d.define("q", vector(t, t, t) + 1, because="x")', "mend: add vectors to vectors"),
    "a vector and a scalar": ('d.define("q", t + vector(t, t, t), because="x")', "expected a scalar or a number, not a value of type Components\n  mend: take a component"),
    "an axis that is not there": ('Chain("g").rotate(7, t)', "ValueError.*\n  mend: write X, Y or Z"),
    "a frame that is there twice": ('Chain("g").rotate(X, t, frame="g")', "already has a frame named 'g'\n  mend: name each frame once"),
    "a division by 0": ('d.define("q", t / 0, because="x")', "division by the number 0.*\n  mend: divide by something"),
    "an attribute that is not there": ("t.velocty", "AttributeError.*\n  mend: correct the spelling"),
    "a second name for a rate": ('t.rate()\nt.rate("speed")', "t already has the rate t_dot .rate of t.\n  mend: name it where it is first made, at .*derivation.py:\\d+, or"),
    "a second meaning for a rate": ('t.rate("w", "turn")\nt.rate("w", "spin")', "t already has the rate w .turn."),
    "a second box for a rate": ('t.rate()\nt.rate(limits=(-5.0, 5.0))', "t already has the rate t_dot .rate of t. with the limits -1e\\+06 to 1e\\+06"),
    "a second range for a rate": ('t.rate(range=(-1.0, 1.0))\nt.rate(range=(-2.0, 1.0))', "t already has the rate t_dot .rate of t. with the range -1 to 1"),
    "a vector's second box": ('n = d.vector("n", "x")\nn.rate()\nn.rate(limits=(-5.0, 5.0))', "n already has the rate n_dot .* with the limits"),
    "a vector's second rate": ('n = d.vector("n", "x")\nn.rate()\nn.rate("speed")', "n already has the rate n_dot"),
    "a twist turned round": ('T = d.time("T", "x")\nd.define("q", Twist(vector(L / T, 0, 0), vector(L / T, 0, 0)), because="x")', "the angular part of a twist.*\n  mend: Twist\\(angular, linear\\) takes"),
    "a wrench turned round": ('d.define("q", Wrench(vector(L, 0, 0), vector(L, 0, 0)), because="x")', "the moment of a wrench.*\n  mend: Wrench\\(moment, force\\) takes"),
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


WITHOUT_VALUE = {
    "a root of something negative": ("sqrt(t - 10)", "result q"),
    "a root of a negative number": ("t + sqrt(number(-2))", "result q"),
    "a division by what is always 0": ("1 / (t - t)", "result q"),
    "a division by a sine of 0": ("t / sin(0 * t)", "result q"),
}


@pytest.mark.parametrize("case", WITHOUT_VALUE)
def test_a_kernel_without_a_real_value(project, case):
    expression, what = WITHOUT_VALUE[case]
    line = f'd.kernel("k", inputs=[t], outputs={{"fine": r, "q": {expression}}})\n'
    path = project(demo=HEAD + line) / "derivations" / "demo" / "derivation.py"
    kernel = load(path).kernels["k"]
    with pytest.raises(DerivationError) as caught:
        compile_kernel(kernel)
    text = str(caught.value)
    assert text.startswith(f"{path}:{LINE}: {what} of kernel k of demo has no real value"), text
    assert "\n  mend: guard it with where(" in text
    assert "narrow range=" in text


def test_a_case_without_a_real_value(project):
    line = (
        'd.kernel("k", inputs=[t], outputs=[r], '
        'cases=[(Status.LIMIT, sqrt(t - 10) < 1, "for the test")])\n'
    )
    path = project(demo=HEAD + line) / "derivations" / "demo" / "derivation.py"
    with pytest.raises(DerivationError, match=r":\d+: the case LIMIT of kernel k of demo"):
        compile_kernel(load(path).kernels["k"])


def test_a_defect_of_the_compiler_is_not_laid_to_the_derivation(project, monkeypatch):
    """Only what cannot be computed is the derivation's fault."""
    from armillary.program import compile as compiler

    def broken(kernel):
        raise TypeError("a defect")

    path = project(demo=HEAD + 'd.kernel("k", inputs=[t], outputs=[r])\n')
    kernel = load(path / "derivations" / "demo" / "derivation.py").kernels["k"]
    monkeypatch.setattr(compiler, "cheapest", broken)
    with pytest.raises(TypeError, match="a defect"):
        compile_kernel(kernel)


def test_the_usual_range_keeps_inside_the_limits(project):
    lines = (
        'q = d.angle("q", "an angle", limits=(0.0, 1.0))\n'
        'w = d.angle("w", "an angle", limits=(20.0, 30.0))\n'
    )
    quantities = load(
        project(demo=HEAD + lines) / "derivations" / "demo" / "derivation.py"
    ).quantities
    assert quantities["q"].facts.range == (0.0, 1.0)
    assert quantities["w"].facts.range == (20.0, 30.0)


@pytest.mark.parametrize("name", ["math", "float", "limits", "string", "stdlib", "time", "errno"])
def test_a_new_system_is_not_named_like_a_header(name):
    with pytest.raises(DerivationError, match=f"x.py:1: '{name}' cannot name a system"):
        check_name(name, "system", Source("x.py", 1))


@pytest.mark.parametrize(
    ("name", "what"),
    [("step", "quantity"), ("Any", "definition"), ("far", "definition"), ("limits", "kernel")],
)
def test_a_name_is_refused_only_where_it_would_clash(name, what):
    check_name(name, what, Source("x.py", 1))


def test_the_same_rate_may_be_asked_for_again(project):
    lines = 'a = t.rate("w", "turn")\nassert t.rate() is a is t.rate("w") is t.rate("w", "turn")\n'
    load(project(demo=HEAD + lines) / "derivations" / "demo" / "derivation.py")


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


def test_a_result_may_be_named_like_a_macro_and_has_another_name_in_c():
    d = Derivation("demo", title="Demo")
    t = d.angle("t", "an angle")
    d.kernel("k", inputs=[t], outputs={"F": 2 * t})
    assert d.kernels["k"].result_argument("F") == "F_out"
