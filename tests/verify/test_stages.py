"""Set-up and step in C are held to the evaluator, and a wrong one is found."""

import numpy as np
import pytest

from armillary.verify import parity, runner
from armillary.verify.implementations import forget
from armillary.verify.stages import stages_implementations
from tests.targets.compilers import needs
from tests.verify.systems import PACKAGE, generate, write

pytestmark = [pytest.mark.tool, needs("cc")]
ARM = """
from armillary import Derivation, Rate, Status, cos, sin, sqrt, where
derivation = d = Derivation("arm", title="Arm")
t, tilt = d.angle("t", "turn"), d.angle("tilt", "tilt of the base", rate=Rate.MOUNT)
L = d.parameter.length("L", "length", range=(0.5, 2), limits=(0, 5))
steep = d.define("steep", tilt > 1, because="it is asked for")
far = d.define("far", t > 1, because="it is asked for")
x = d.define("x", L * cos(tilt) * sin(t), because="it is asked for", meaning="a place")
d.kernel("place", inputs=[t, tilt], outputs={"x": x},
         cases=[(Status.UNREACHABLE, steep, "too steep"), (Status.LIMIT, far, "too far")])
d.kernel("whole", inputs=[t], outputs={"y": 2 * t})
"""
BREAKAGES = {
    "another value": ("*x = ", "*x = 1.001f * ", "c f32 in steps"),
    "a status less": ("if (steep)", "if (steep > 1)", "c f32 in steps"),
    "a guard of the mount less": (
        "fabs(tilt) <= 1000.0)",
        "fabs(tilt) <= 2.0e3)",
        "c f64 in steps",
    ),
    "a guard of the step less": ("fabs(t) <= 1000.0)", "fabs(t) <= 2.0e3)", "c f64 in steps"),
    "a field of something else": ("ctx->m1 = ", "ctx->m1 = 1.001 * ", "c f64 in steps"),
    "a mount that is let pass": ("ARMILLARY_UNREACHABLE", "ARMILLARY_OK", "c f64 in steps"),
    "a mark that is not left": ("ctx->ready = 0x", "ctx->ready = 1 + 0x", "c f64 in steps"),
}


@pytest.fixture
def root(tmp_path):
    made = write(tmp_path, arm=ARM)
    generate(made)
    return made


def outcomes(root):
    return [o for o in runner.run(root, PACKAGE) if o.engine.endswith("in steps")]


def test_the_stages_of_a_divided_kernel_are_compared_and_agree(root):
    made = outcomes(root)
    assert [str(o) for o in made if o.failed] == []
    assert {(o.engine, o.name, o.kernel) for o in made} == {
        (f"c {p} in steps", name, "place")
        for p in ("f32", "f64") for name in (parity.VALUES, parity.STATUSES)
    }  # fmt: skip
    statuses = next(o for o in made if o.name == parity.STATUSES)
    assert statuses.points > 2 * parity.POINTS  # those that are refused are among them


@pytest.mark.parametrize(("right", "wrong", "engine"), BREAKAGES.values(), ids=BREAKAGES)
def test_a_wrong_stage_is_found(root, right, wrong, engine):
    precision = engine.split()[1]
    (source,) = (root / "generated").rglob(f"arm_place_step_{precision}.c")
    text = source.read_text("utf-8")
    assert right in text
    source.write_text(text.replace(right, wrong), "utf-8")
    assert engine in {o.engine for o in outcomes(root) if o.failed}


def test_both_refusals_count_as_those_of_one_call(root):
    forget(PACKAGE)
    folder = root / "generated" / "python"
    (make,) = [m for name, m in stages_implementations(folder, PACKAGE, "arm") if "f64" in name]
    nan, wild = np.nan, 1e9
    steep, shallow = 1.5, 0.2
    given = {
        "t": [0.1, 0.1, nan, wild, nan, wild, 0.1, wild, nan],
        "tilt": [steep, shallow, shallow, shallow, steep, steep, nan, nan, wild],
    }
    inputs = {**{n: np.array(v) for n, v in given.items()}, "L": np.full(9, 1.0)}
    found = make().call("place", inputs)
    assert found["status"].tolist() == [-3, 0, -1, -2, -1, -2, -1, -2, -2]
    assert np.isnan(np.delete(found["x"], 1)).all()
