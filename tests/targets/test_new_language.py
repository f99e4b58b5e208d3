"""A new language is one small class: JavaScript here, and Python's own floats."""

import inspect
import json
import math

import pytest

from armillary.program.evaluate import evaluate
from armillary.targets.body import Language, write_body
from armillary.targets.numbers import F64, shortest
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
]


def flat(program, inputs):
    """Vectors as their components and rotations as their entries, as bodies name them."""
    found = {}
    for q in (*program.kernel.inputs, *program.kernel.parameters):
        if q.name in inputs:
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
    lines += [f"  const {s.name} = {s.expression};" for s in body.statements]
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
        for s in body.statements:
            scope[s.name] = eval(s.expression, scope)
        found.append([eval(e, scope) for r in body.results for e in r])
    agree(program, found, inputs)


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
