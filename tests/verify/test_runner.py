"""The whole run on a small project, with real targets."""

import json

import pytest

from armillary.verify import parity, results, runner, tolerances
from tests.verify.systems import AIM, PACKAGE, TWO_AXES, generate, write

SIMULATION = """
import numpy as np
from armillary.verify.engines import each, need
from armillary.verify.measured import compare


def by_numpy(kernels):
    a = np.linspace(-3.0, 3.0, 7)
    found = kernels.pose(a=a, b=0.0, L=2.0).M[:, 0, 3]
    yield compare("x of the tip", "NumPy", found, FACTOR * np.sin(a), 1e-14, {"a": a}, "pose")


def by_gazebo(kernels):
    need("gazebo")
    yield None


def checks(kernels):
    yield from each(kernels, by_numpy, by_gazebo)
"""


@pytest.fixture(scope="module")
def root(tmp_path_factory):
    made = write(tmp_path_factory.mktemp("project"), two_axes=TWO_AXES, aim=AIM)
    generate(made)
    return made


@pytest.fixture
def simulated(root):
    path = root / "derivations" / "two_axes" / "simulation.py"

    def put(factor):
        path.write_text(SIMULATION.replace("FACTOR", factor), "utf-8")

    yield put
    path.unlink()


def test_everything_passes_on_every_target(root, simulated):
    simulated("2")
    made = list(runner.run(root, PACKAGE))
    assert [str(o) for o in made if o.failed] == []
    engines = {o.engine for o in made if o.name == parity.VALUES and not o.skipped}
    assert {"numpy f64", "numpy f32"} <= engines
    assert {o.engine for o in made if o.kernel == "pose"} >= {"NumPy", "SymPy, 50 digits"}
    skipped = [o for o in made if o.engine == "gazebo"]
    assert [(o.skipped, o.passed, o.failed) for o in skipped] == [(True, False, False)]
    assert "pip install" in skipped[0].why


def test_a_failing_simulation_fails(root, simulated):
    simulated("2.001")
    failed = [o for o in runner.run(root, PACKAGE, ["two_axes"]) if o.failed]
    assert [(o.name, o.engine, o.kernel) for o in failed] == [("x of the tip", "NumPy", "pose")]
    assert str(failed[0]).startswith("FAILED two_axes pose: x of the tip [NumPy] ")


def test_a_simulation_that_breaks_is_reported_and_the_rest_runs(root, simulated):
    simulated("nonsense")
    made = list(runner.run(root, PACKAGE, ["two_axes"]))
    failed = [o for o in made if o.failed]
    assert [o.engine for o in failed] == ["simulation.py"]
    assert "NameError" in failed[0].why
    assert any(o.name == parity.STATUSES for o in made)


def test_checks_are_written_as_json(root):
    made = list(runner.run(root, PACKAGE, ["aim"]))
    path = results.write(root, made)
    lines = json.loads(path.read_text())
    assert {"system", "digest", "kernel", "name", "engine", "points", "worst", "tolerance",
            "passed", "skipped", "why", "at"} == set(lines[0])  # fmt: skip
    assert lines == results.read(root)
    results.write(root, list(runner.run(root, PACKAGE, ["two_axes"])))
    assert {o["system"] for o in results.read(root)} == {"aim", "two_axes"}


def test_a_generated_file_that_is_wrong_is_found(root):
    path = root / "generated" / "python" / PACKAGE / "two_axes.py"
    text = path.read_text()
    try:
        path.write_text(text.replace("xp.sin", "xp.cos", 1))
        failed = [o for o in runner.run(root, PACKAGE, ["two_axes"]) if o.failed]
        assert {o.name for o in failed} == {parity.VALUES}
        assert "numpy f64" in {o.engine for o in failed}
        assert not {o.engine for o in failed} & {"c f64", "c f32"}
    finally:
        path.write_text(text)


def test_kernels_that_were_not_generated_fail_by_name(tmp_path):
    write(tmp_path, aim=AIM)
    failed = [o for o in runner.run(tmp_path, PACKAGE) if o.failed]
    assert failed
    assert all("ModuleNotFoundError" in o.why for o in failed)


def test_tolerances_are_measured_and_then_met(root):
    made = list(runner.update_tolerances(root, PACKAGE, ["aim"]))
    folder = root / "derivations" / "aim"
    known = tolerances.read(folder)
    try:
        assert 8e-16 <= known["aim"]["numpy f64"] < 1e-13
        assert 4e-7 <= known["aim"]["numpy f32"] < 1e-4
        assert all(o.passed or o.skipped for o in made)
        again = [o for o in runner.run(root, PACKAGE, ["aim"]) if o.failed]
        assert again == []
        tolerances.write(folder, {"aim": {"numpy f64": 1e-18}})
        failed = [o for o in runner.run(root, PACKAGE, ["aim"]) if o.failed]
        assert [(o.engine, o.tolerance) for o in failed] == [("numpy f64", 1e-18)]
    finally:
        (folder / tolerances.NAME).unlink()
