"""A set-up and a step compute what the kernel computes, and share nothing but the context."""

import pytest
from hypothesis import given

from armillary import Derivation, Rate, Status, any_of, cos, sin, sqrt, vector, where
from armillary.derivation.status import worse
from armillary.program.arithmetic import Reals
from armillary.program.compile import compile_kernel, compile_stages
from armillary.program.cost import cost, measure, step_cost
from armillary.program.evaluate import evaluate
from armillary.program.lower import Strategy, lower
from armillary.program.passes import STAGES
from armillary.program.program import Op
from armillary.program.sample import sample_points
from armillary.program.stages import divided, has_stages
from tests.expressions import SCALARS, VECTORS, c, record, x, y
from tests.programs import kernel_of

BECAUSE = "it is asked for"


def stages_of(d, name="k"):
    made = compile_kernel(d.kernels[name])
    return made, compile_stages(made)


def run(stages, point):
    """The step after the set-up, which is told of the mount only."""
    kernel = stages.setup.kernel
    told = {q.name for q in (*kernel.inputs, *kernel.parameters)}
    before = evaluate(stages.setup, {n: v for n, v in point.items() if n in told}, Reals())
    if before.status < 0:
        return before
    assert list(before.results) == [f.name for f in stages.fields]
    moving = {q.name for q in (*stages.step.kernel.inputs, *stages.step.kernel.parameters)}
    after = evaluate(stages.step, {**{n: point[n] for n in moving}, **before.results}, Reals())
    assert after.status == worse(before.status, after.status)
    return after


def same(made, stages):
    for point in sample_points(made.program.kernel, 4):
        whole, parts = evaluate(made.program, point, Reals()), run(stages, point)
        assert whole.status == parts.status
        assert list(whole.results) == list(parts.results)
        for name, value in whole.results.items():
            pairs = zip(_flat(value), _flat(parts.results[name]), strict=True)
            assert all(abs(a - b) <= 1e-40 * (1 + abs(a)) for a, b in pairs)


def _flat(value):
    return value if isinstance(value, list) else [value]


def tree():
    """A kernel with everything a field can be: numbers, parts of vectors, arrays, conditions."""
    d = Derivation("tree", title="Tree")
    leg = d.index("leg", 3)
    t, b = d.angle("t", "an angle"), d.vector("b", "of the mount", rate=Rate.MOUNT)
    tilt, r = d.parameter.angle("tilt", "a tilt"), d.parameter.scalar("r", "an arm", per=leg)
    foot = d.parameter.vector("foot", "a foot", per=leg)
    high = d.define("high", tilt > "0.5", because=BECAUSE)
    too_short = d.define("too_short", any_of(r < "0.1", over=leg), because=BECAUSE)
    reach = d.define("reach", r * cos(tilt), because=BECAUSE)
    moved = d.define("moved", sqrt(reach * reach + foot.x * sin(t) + 1e3), because=BECAUSE)
    d.kernel(
        "k",
        inputs=[t, b],
        outputs={
            "moved": moved,
            "b": vector(b.x * t, b.y * t, b.z),
            "still": sin(tilt) * b.z,
            "t_out": where(high, t, 2 * t),
        },
        cases=[(Status.LIMIT, too_short, "an arm is short"), (Status.CLAMPED, t > 1, "far round")],
    )
    return d


def test_fields_are_what_the_step_reads_and_named_like_what_they_hold():
    made, stages = stages_of(tree())
    same(made, stages)
    fields = {f.name: f for f in stages.fields}
    assert {name for name, f in fields.items() if f.condition} == {"high", "too_short"}
    assert {name: f.shape for name, f in fields.items() if f.index} == {"m1": (3,), "foot_x": (3,)}
    assert "tree-high" in fields["high"].identifiers
    read = {i.data if isinstance(i.data, str) else i.data[0]
            for i in stages.step.instructions if i.op is Op.INPUT}  # fmt: skip
    assert read == set(fields) | {"t"}
    assert cost(stages.step).trigonometry == 1
    assert cost(stages.setup).trigonometry == 2


def test_no_field_has_the_name_of_something_else_in_the_step():
    _, stages = stages_of(tree())
    kernel = stages.step.kernel
    taken = {"t", *(o.name for o in kernel.outputs)}
    taken |= {kernel.result_argument(o.name) for o in kernel.outputs}
    names = [f.name for f in stages.fields]
    assert not taken & set(names)
    assert len(names) == len(set(names))


def test_no_field_is_a_macro_of_a_header():
    d = Derivation("wide", title="Wide")
    t, tilt = d.angle("t", "an angle"), d.parameter.angle("tilt", "a tilt")
    far = d.define("far", sin(tilt) * cos(tilt), because=BECAUSE)
    d.kernel("k", inputs=[t], outputs={"r": far * sin(t)})
    _, stages = stages_of(d)
    (field,) = stages.fields
    assert field.name != "far"
    assert field.identifiers == ("wide-far",)


def test_the_set_up_guards_the_mount_and_the_step_the_rest():
    made, stages = stages_of(tree())
    assert {g.name for g in stages.setup.guards} == {"b", "tilt", "r", "foot"}
    assert {g.name for g in stages.step.guards} == {"t"}
    assert set(stages.setup.guards) | set(stages.step.guards) == set(made.program.guards)


def test_a_parameter_that_changes_is_read_by_the_step():
    d = Derivation("moving", title="Moving")
    x, a = d.angle("x", "an angle"), d.parameter.length("a", "a length")
    h = d.parameter.length("h", "a height that changes", rate=Rate.TICK)
    d.parameter.length("unread", "a length")
    d.kernel("k", inputs=[x], outputs={"r": a * a * h * x})
    made, stages = stages_of(d)
    same(made, stages)
    assert [q.name for q in stages.step.kernel.parameters] == ["h"]
    assert [f.name for f in stages.fields] == ["m1"]


@pytest.mark.parametrize(
    ("rates", "divided"),
    [
        ((Rate.MOUNT, Rate.TICK), True),
        ((Rate.MOUNT, Rate.DAY), True),
        ((Rate.MOUNT, Rate.MOUNT), False),
        ((Rate.DAY, Rate.TICK), False),
    ],
)
def test_only_what_reads_both_is_divided(rates, divided):
    d = Derivation("both", title="Both")
    first, second = (d.angle(n, n, rate=r) for n, r in zip("uv", rates, strict=True))
    d.parameter.angle("unread", "an angle")
    d.kernel("k", inputs=[first, second], outputs={"r": sin(first) * second})
    _, stages = stages_of(d)
    assert (stages is not None) == divided == has_stages(d.kernels["k"], {"u", "v"})


@pytest.mark.parametrize(("hoisted", "gained"), [(0, False), (1, True)])
def test_a_step_that_costs_no_less_than_the_call_is_not_made(hoisted, gained):
    d = Derivation("idle", title="Idle")
    t, a = d.angle("t", "an angle"), d.parameter.scalar("a", "a number")
    d.kernel("k", inputs=[t], outputs={"r": sin(t) * (a + hoisted)})
    made, stages = stages_of(d)
    assert has_stages(made.program.kernel, made.program.inputs_used())
    assert (stages is not None) == gained
    if stages:
        assert cost(stages.step).weighted == made.cost.weighted - 1


def gated(status):
    """A kernel with a case that the mount decides, and one that it does not."""
    d = Derivation("gated", title="Gated")
    t, a = d.angle("t", "an angle"), d.parameter.scalar("a", "a number")
    tight = d.define("tight", a * a < "0.2", because=BECAUSE)
    cases = [(Status.SINGULAR, t > 1, "far round"), (status, tight, "of the mount")]
    d.kernel("k", inputs=[t], outputs={"r": sin(t) * sin(a)}, cases=cases)
    return d


@pytest.mark.parametrize("status", [Status.LIMIT, Status.UNREACHABLE, Status.NOT_CONVERGED])
def test_the_set_up_tells_the_cases_of_the_mount_and_steps_repeat_what_does_not_end(status):
    made, stages = stages_of(gated(status))
    same(made, stages)
    assert [case.status for case in stages.setup.kernel.cases] == [status]
    repeated = [Status.SINGULAR, status] if status > 0 else [Status.SINGULAR]
    assert [case.status for case in stages.step.kernel.cases] == repeated
    assert [f.name for f in stages.fields] == ["sin_a", "tight"][: len(repeated)]
    for a in ("0.1", "0.5"):
        found = run(stages, {"t": Reals().number("0.3"), "a": Reals().number(a)})
        assert found.status == (status if a == "0.1" else 0)


def test_a_controller_is_not_divided():
    d = Derivation("kept", title="Kept")
    gain, x = d.parameter.scalar("gain", "a gain"), d.scalar("x", "a number")
    last = d.state.scalar("last", "what came before")
    outputs, states = {"r": gain * last}, {last: gain * x}
    d.controller("hold", inputs=[x], outputs=outputs, states=states, start={last: 0})
    assert all(compile_stages(compile_kernel(k)) is None for k in d.kernels.values())


TOLD = pytest.mark.parametrize("told", [{"x"}, {"c"}, {"x", "c"}, {"x", "y", "c"}])


def close(before, after):
    for a, b in zip(before, after, strict=True):
        assert abs(a - b) <= 1e-40 * (1 + abs(a))


@TOLD
@given(first=SCALARS, second=SCALARS, third=VECTORS)
def test_random_programs_keep_their_values_through_every_pass_and_in_two(
    told, first, second, third
):
    kernel = kernel_of(record, [x, y, c], {"r": first + second, "s": second, "v": third})
    points = sample_points(kernel, 2)

    def values(program):
        answers = (evaluate(program, point, Reals()).results for point in points)
        return [v for found in answers for value in found.values() for v in _flat(value)]

    program = lower(kernel, Strategy(), None, frozenset(told))
    wanted = values(program)
    for step in STAGES:
        after = step(program)
        assert measure(after)[0] <= measure(program)[0], step.__name__
        program = after
    close(wanted, values(program))
    stages = divided(program)
    assert cost(stages.step) == step_cost(program)
    parts = [v for p in points for value in run(stages, p).results.values() for v in _flat(value)]
    close(wanted, parts)
