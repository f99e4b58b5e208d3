"""The cost that a header states is what the code performs: counted by running it."""

import pytest

from armillary.program.compile import compile_kernel, compile_stages
from armillary.program.cost import cost
from armillary.program.program import Op, results_length
from armillary.program.sample import sample_points
from armillary.targets.c import function_name, params_type, state_type
from benchmarks.count.count import run_source
from benchmarks.printed import Asked, Printed, in_order
from benchmarks.table import SETUP, STEP
from tests.targets.compilers import needs
from tests.targets.stress import stress
from tests.targets.stress_loops import loops


@pytest.mark.tool
@needs("g++")
def test_stated_cost_is_what_runs(printed):
    checked = 0
    for (system, name), made in printed.compiled.items():
        program, kernel = made.program, made.program.kernel
        target = printed.target.c
        source = printed.c / f"{system}_{name}_f64.c"
        text = f'#include "{system}.h"\n' + source.read_text().replace(f'#include "{system}.h"', "")
        point = sample_points(kernel, 1)[0]
        values, arguments, setup = [], [], ""
        if kernel.parameters:
            setup = f"{params_type(system, target, 'f64')} p = {{}}; "
            arguments.append("&p")
            for q in kernel.parameters:
                for k in range(len(q.parts)):
                    field = f"{q.name}[{k}]" if q.shape else q.name
                    setup += f"p.{field} = in[{len(values)}]; "
                    values.append(float(point[q.name][k] if q.shape else point[q.name]))
        states = {q.name: q for q in kernel.states}
        if kernel.stateful:
            setup += f"{state_type(kernel, target, 'f64')} state = {{}}; "
        if kernel.stateful == "update":
            arguments.append("&state")
        for q in kernel.inputs:
            if q.name in states:
                for k, value in enumerate(point[q.name] if q.shape else [point[q.name]]):
                    setup += f"state.{q.name}{f'[{k}]' if q.shape else ''} = in[{len(values)}]; "
                    values.append(float(value))
                continue
            arguments.append(f"in + {len(values)}" if q.shape else f"in[{len(values)}]")
            values += [float(x) for x in (point[q.name] if q.shape else [point[q.name]])]
        place = 0
        for result in program.results:
            if result.name not in states:
                arguments.append(f"out + {place}")
                place += results_length(result)
        if kernel.stateful == "init":
            arguments.append("&state")
        symbol = function_name(kernel, target, "f64")
        # What is refused is not computed; what has another status is.
        refused = "if (status == -1 || status == -2) std::abort();"
        call = f"{setup}const int status = {symbol}({', '.join(arguments)}); {refused}"
        (run,) = run_source(text, call, [values], place, [printed.c])
        stated = cost(program)
        # The guards of unit vectors and rotations multiply and add: they are apart in the cost.
        forms = [guard.form for guard in program.guards if guard.form]
        added = sum(len(form.terms) - 1 + bool(form.value) for form in forms)
        multiplied = sum(len(places) - 1 for form in forms for _, places in form.terms)
        found = run.counts
        counted = (found.add - added, found.mul - multiplied, found.div, found.sqrt)
        wanted = (stated.add, stated.multiply, stated.divide, stated.sqrt)
        trigonometry = (found.trig, found.inverse)
        if any(i.op is Op.SELECT for i in program.instructions):
            # The side of a ?: that is not taken does not run.
            assert all(a <= b for a, b in zip(counted, wanted, strict=True)), symbol
        else:
            assert counted == wanted, symbol
            assert trigonometry == (stated.trigonometry, stated.inverse), symbol
        assert found.pow == 0
        checked += 1
    assert checked >= 35


@pytest.mark.tool
@needs("g++")
@pytest.mark.parametrize(("make", "name"), [(stress, "carry"), (loops, "rods"), (loops, "shares")])
def test_stated_cost_of_a_stage_is_what_runs(make, name):
    """The mark of a context is an integer: to ask for it costs no operation."""
    d = make()
    kernel = d.kernels[name]
    places = in_order((*kernel.inputs, *d.parameters))
    printed = Printed(Asked(d, name, places=places))
    point = sample_points(kernel, 1)[0]
    values = [0.0] * (max(places.values()) + 9)
    for q, place in places.items():
        given = point.get(q, 0)
        numbers = given if isinstance(given, list | tuple) else [given]
        values[place : place + len(numbers)] = [float(x) for x in numbers]
    stages = compile_stages(compile_kernel(kernel))
    for stage, program in ((SETUP, stages.setup), (STEP, stages.step)):
        length = sum(results_length(r) for r in stages.step.results)
        (run,) = run_source(printed.source, printed.call(stage), [values], length, [])
        stated, found = cost(program), run.counts
        counted = (found.add, found.mul, found.div, found.sqrt, found.trig, found.inverse)
        assert counted == (
            *(stated.add, stated.multiply, stated.divide, stated.sqrt),
            *(stated.trigonometry, stated.inverse),
        ), (name, stage)
