"""A new language is one small class: JavaScript here, and Python's own floats."""

import inspect
import json
import math

import pytest

from armillary.program.evaluate import evaluate
from armillary.program.program import results_length
from armillary.targets.body import Language, write_body
from armillary.targets.language import Assignment, For, Numbers, Variable
from armillary.targets.numbers import F64, shortest
from tests.loops import POINT, PROGRAMS, at_random
from tests.programs import exact
from tests.targets.compilers import needs, run
from tests.targets.reference import answers, points


class JavaScript(Language):
    """JavaScript expressions."""

    def constant(self, value):
        return shortest(value, F64)

    def call(self, function, *arguments):
        return f"Math.{function}({', '.join(arguments)})"

    def both(self, a, b):
        return f"{a} && {b}"

    def invert(self, a):
        return f"!{a}"

    def select(self, condition, then, otherwise):
        return f"{condition} ? {then} : {otherwise}"


class Floats(JavaScript):
    """The same in Python, which differs in three lines."""

    def both(self, a, b):
        return f"{a} and {b}"

    def invert(self, a):
        return f"not {a}"

    def select(self, condition, then, otherwise):
        return f"{then} if {condition} else {otherwise}"


KERNELS = [
    ("stress", "vectors"),
    ("stress", "bounds"),
    ("answers", "both_signs"),
    ("names", "all"),
    ("attitudes", "carried"),
    ("sun", "angles"),
    ("altazimuth", "velocity"),
    ("loops", "shares"),
    ("loops", "arms"),
    ("loops", "grid"),
    ("iterations", "forward"),
    ("iterations", "kepler"),
]


def javascript(lines):
    """Lines of a body in JavaScript: what a language must say of loops."""
    for line in lines:
        if isinstance(line, For):
            v = line.variable
            yield f"for (let {v} = 0; {v} < {line.size}; {v}++) {{"
            yield from javascript(line.lines)
            yield "}"
        elif isinstance(line, Numbers):
            yield f"const {line.name} = [{', '.join(line.values)}];"
        elif isinstance(line, Variable):
            text = line.initial or "0"
            for size in reversed(line.sizes):
                text = f"Array.from({{length: {size}}}, () => {text})"
            yield f"let {line.name} = {text};"
        elif isinstance(line, Assignment):
            yield f"{line.target} = {line.expression};"
        else:
            yield f"const {line.name} = {line.expression};"


def python(lines, indent=""):
    """The same in Python."""
    for line in lines:
        if isinstance(line, For):
            yield f"{indent}for {line.variable} in range({line.size}):"
            yield from python(line.lines, indent + " ")
        elif isinstance(line, Numbers):
            yield f"{indent}{line.name} = [{', '.join(line.values)}]"
        elif isinstance(line, Variable):
            text = line.initial or "None"
            for size in reversed(line.sizes):
                text = f"[{text} for _ in range({size})]"
            yield f"{indent}{line.name} = {text}"
        else:
            name = line.target if isinstance(line, Assignment) else line.name
            yield f"{indent}{name} = {line.expression}"


def flat(program, inputs):
    """Vectors as their components and rotations as their entries, as bodies name them.

    What runs over an index stays an array.
    """
    found = {}
    for q in (*program.kernel.inputs, *program.kernel.parameters):
        if q.name in inputs and q.facts.per:
            found[q.name] = inputs[q.name].reshape(-1, len(q.parts)).tolist()
        elif q.name in inputs:
            columns = inputs[q.name].reshape(-1, len(q.parts)).T.tolist()
            found.update(zip(q.parts, columns, strict=True))
    return found


def agree(program, found, inputs):
    for row, (status, wanted) in zip(found, answers(program, inputs, 1), strict=True):
        if status >= 0:
            exact = [float(x) for o in program.kernel.outputs for x in wanted[o.name]]
            assert row == pytest.approx(exact, rel=1e-12, abs=1e-12)


def test_it_is_small():
    assert len(inspect.getsource(JavaScript).splitlines()) < 25


@needs("node")
@pytest.mark.tool
@pytest.mark.parametrize("key", KERNELS, ids=".".join)
def test_javascript_computes_the_same(printed, tmp_path, key):
    program = printed.compiled[key].program
    inputs = points(program, 20)
    columns = flat(program, inputs)
    body = write_body(program, JavaScript(), frozenset(columns))
    lines = [f"const kernel = ({', '.join(columns)}) => {{"]
    lines += [f"  {line}" for line in javascript(body.statements)]
    lines += [f"  return [{', '.join(e for r in body.results for e in r)}];", "};"]
    lines += [f"const rows = {json.dumps(list(zip(*columns.values(), strict=True)))};"]
    lines += ["console.log(JSON.stringify(rows.map((row) => kernel(...row))));"]
    script = tmp_path / "kernel.js"
    script.write_text("\n".join(lines))
    agree(program, json.loads(run("node", script).stdout), inputs)


@pytest.mark.parametrize("key", KERNELS, ids=".".join)
def test_plain_python_computes_the_same(printed, key):
    program = printed.compiled[key].program
    inputs = points(program, 20)
    columns = flat(program, inputs)
    body = write_body(program, Floats(), frozenset(columns))
    found = []
    for values in zip(*columns.values(), strict=True):
        scope = {"Math": _Math, **dict(zip(columns, values, strict=True))}
        exec("\n".join(python(body.statements)), scope)
        found.append([eval(e, scope) for r in body.results for e in r])
    agree(program, found, inputs)


@pytest.mark.parametrize("make", PROGRAMS.values(), ids=PROGRAMS)
def test_loops_by_hand_compute_the_same(make):
    plain(make())


@pytest.mark.parametrize("seed", range(80))
def test_loops_at_random_compute_the_same(seed):
    plain(at_random(seed))


def plain(program):
    """Run a body in Python's own floats, its results both at the end and stored in loops."""
    wanted = evaluate(program, exact(POINT)).results
    columns = {n: v for n, v in POINT.items() if n != "v"} | {"v": POINT["v"]}
    stored = {r.name: f"{r.name}_stored" for r in program.results if r.indices}
    for late in (None, False, True):
        more = {} if late is None else {"stored": stored, "late": late}
        body = write_body(program, Floats(), frozenset({*columns, *stored.values()}), **more)
        scope = {"Math": _Math, **columns}
        scope |= {stored[r.name]: [None] * results_length(r) for r in program.results if r.indices}
        exec("\n".join(python((*body.statements, *body.stores))), scope)
        for result, texts in zip(program.results, body.results, strict=True):
            values = [eval(text, scope) for text in texts]
            found = scope[stored[result.name]] if more and result.indices else values
            exact_ones = wanted[result.name]
            exact_ones = exact_ones if isinstance(exact_ones, list) else [exact_ones]
            assert found == pytest.approx([float(n) for n in exact_ones], rel=1e-9, abs=1e-9)


class _Math:
    sqrt, sin, cos, atan2, abs = math.sqrt, math.sin, math.cos, math.atan2, abs


def test_cases_come_with_their_conditions(printed):
    program = printed.compiled["answers", "both_signs"].program
    body = write_body(program, JavaScript(), frozenset("xy"))
    assert [status for status, _ in body.cases] == [-4, -3, 1, 2, 5]
    labels = {s.name: s.identifiers for s in body.statements}
    assert labels["root"] == ("answers-root",)
    assert labels["far"] == ("answers-far",)
    assert evaluate(program, {"x": 0.1, "y": 0.1}).status == 0
