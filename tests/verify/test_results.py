"""Results: kept for other systems, never of another state of the derivation, read or left aside."""

import json
from concurrent.futures import ThreadPoolExecutor

import pytest

from armillary.derivation.errors import DerivationError
from armillary.derivation.load import load_all
from armillary.verify import results, runner, tolerances
from tests.verify.systems import AIM, PACKAGE, TWO_AXES, generate, write


@pytest.fixture
def root(tmp_path):
    return write(tmp_path, aim=AIM)


def row(root, system):
    digest = results.checked_digest(root, load_all(root / "derivations")[system])
    return results.Outcome(system, digest, None, "claim", "SymPy", 0, 0.0, 0.0, True)


def known(root, system="aim"):
    record = load_all(root / "derivations")[system]
    return results.standing(root, record, results.read(root))


def test_a_fresh_result_stands(root):
    assert known(root) == results.Standing((), False)
    results.write(root, [row(root, "aim")])
    assert [r["name"] for r in known(root).rows] == ["claim"]
    assert not known(root).outdated


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("atan2(n.z, rho)", "-atan2(n.z, rho)"),
        ("below = n.z < 0", "below = n.z < 1"),
        ("outputs=[azimuth, elevation]", "outputs=[elevation, azimuth]"),
        ("(Status.UNREACHABLE", "(Status.BELOW_HORIZON"),
        ("d.kernel(", 'd.identity("so", rho, rho)\nd.kernel('),
    ],
)
def test_a_result_of_before_an_edit_does_not(root, old, new):
    results.write(root, [row(root, "aim")])
    assert old in AIM
    write(root, aim=AIM.replace(old, new, 1))
    assert known(root) == results.Standing((), True)
    write(root, aim=AIM)
    assert len(known(root).rows) == 1


def test_a_result_of_before_an_edit_of_the_parameters_does_not(root):
    results.write(root, [row(root, "aim")])
    (root / "derivations" / "aim" / "parameters.toml").write_text("[plant]\n", "utf-8")
    assert known(root) == results.Standing((), True)


def test_a_result_of_before_an_edit_beside_the_simulation_does_not(root):
    folder = root / "derivations" / "aim"
    (folder / "simulation.py").write_text("from .rays import checks\n", "utf-8")
    (folder / "rays.py").write_text("def checks(kernels):\n    yield from ()\n", "utf-8")
    results.write(root, [row(root, "aim")])
    assert not known(root).outdated
    (folder / "rays.py").write_text("def checks(kernels):\n    return iter(())\n", "utf-8")
    assert known(root).outdated


def test_words_change_nothing(root):
    results.write(root, [row(root, "aim")])
    write(root, aim=AIM.replace("above the horizon", "measured from the horizon"))
    assert len(known(root).rows) == 1


@pytest.mark.parametrize("name", ["simulation.py", tolerances.NAME])
def test_an_edit_of_what_is_beside_the_derivation_counts_too(root, name):
    results.write(root, [row(root, "aim")])
    (root / "derivations" / "aim" / name).write_text("{}\n", "utf-8")
    assert known(root).outdated


def test_a_used_definition_counts_and_others_of_its_system_do_not(tmp_path):
    text = '''"""User."""
from armillary import Derivation
derivation = d = Derivation("user", title="User")
aim = d.use("aim")
twice = d.define("twice", aim["rho"] * 2, because="for the test")
d.kernel("twice_of", inputs=[aim.quantity("n")], outputs=[twice])
'''
    root = write(tmp_path, aim=AIM, user=text)
    results.write(root, [row(root, "user")])
    write(root, aim=AIM.replace("atan2(n.z, rho)", "-atan2(n.z, rho)"))
    assert len(known(root, "user").rows) == 1
    write(root, aim=AIM.replace("hypot(n.x, n.y)", "hypot(n.x, n.z)"))
    assert known(root, "user").outdated


def test_a_run_tells_of_what_it_checked(tmp_path):
    root = write(tmp_path, aim=AIM)
    generate(root)
    outcomes = list(runner.run(root, PACKAGE, points=3))
    results.write(root, outcomes)
    assert len(known(root).rows) == len(outcomes) > 0


@pytest.mark.parametrize("text", ["", "[{", "{}", "[1]", '[{"system": "aim"}]', "\ufeff[]"])
def test_a_file_that_cannot_be_read_holds_no_results(root, text):
    path = root / results.CHECKS
    path.parent.mkdir()
    path.write_text(text, "utf-8")
    assert results.read(root) == []
    results.write(root, [row(root, "aim")])
    assert len(json.loads(path.read_text("utf-8"))) == 1


def test_bytes_that_are_no_text_hold_no_results(root):
    path = root / results.CHECKS
    path.parent.mkdir()
    path.write_bytes(b"\xff\xfe\xfd")
    assert results.read(root) == []


def test_runs_at_once_keep_each_others_rows(tmp_path):
    names = [f"aim_{letter}" for letter in "abcdefgh"]
    root = write(tmp_path, **{n: AIM.replace('"aim", title', f'"{n}", title') for n in names})
    rows = {name: results.Outcome(name, "", None, "c", "e", 0, 0.0, 0.0, True) for name in names}
    for _ in range(5):
        (root / results.CHECKS).unlink(missing_ok=True)
        with ThreadPoolExecutor(len(names)) as pool:
            list(pool.map(lambda name: results.write(root, [rows[name]]), names))
        assert [r["system"] for r in results.read(root)] == names


@pytest.mark.parametrize(
    "text", ["", "[]", '{"aim": 3}', '{"aim": {"c f64": "x"}}', '{"aim": {"c f64": Infinity}}']
)
def test_malformed_tolerances_are_named_before_any_check_runs(root, text):
    path = root / "derivations" / "aim" / tolerances.NAME
    path.write_text(text, "utf-8")
    with pytest.raises(DerivationError, match=r"tolerances\.json:1: .*\n  mend: .*aim --update"):
        next(runner.run(root, PACKAGE))


def test_another_system_is_not_touched(tmp_path):
    root = write(tmp_path, aim=AIM, two_axes=TWO_AXES)
    results.write(root, [row(root, "aim")])
    results.write(root, [row(root, "two_axes")])
    write(root, two_axes=TWO_AXES.replace("rotate(Z, -a)", "rotate(Z, a)"))
    assert known(root, "two_axes").outdated
    assert len(known(root, "aim").rows) == 1
