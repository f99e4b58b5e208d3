"""The command line: what it makes, shows and refuses."""

import json
from pathlib import Path

import pytest

from armillary import __version__
from armillary.project.config import Project
from tests.project.conftest import Run
from tests.project.projects import edit, regenerate

COMMANDS = ("init", "new", "list", "show", "generate", "check", "audit", "study", "site")


def test_help_names_every_command_and_keeps_its_examples(run: Run, tmp_path: Path):
    said = run(tmp_path, "--help").stdout
    for command in COMMANDS:
        assert f"\n  {command} " in said
        assert run(tmp_path, command, "--help").returncode == 0
    assert "\n    armillary new my_tracker    a mechanism that already works\n" in said
    assert run(tmp_path, "--version").stdout == f"armillary {__version__}\n"


@pytest.mark.slow
def test_an_empty_folder_becomes_a_project_with_a_working_mechanism(run: Run, tmp_path: Path):
    root = tmp_path / "My plant"
    root.mkdir()
    assert run(root, "init").returncode == 0
    assert run(root, "generate").returncode == 0
    assert (root / "generated/c/src/my_plant_kernels/armillary_status.h").is_file()
    assert "no system yet" in run(root, "list").stdout
    assert run(root, "site", "build").returncode == 0
    assert run(root, "new", "demo").returncode == 0
    done = run(root, "generate")
    assert done.returncode == 0, done.stderr
    assert "demo.pose: new, 8 flops, 4 sin/cos" in done.stdout
    done = run(root, "check")
    assert done.returncode == 0, done.stdout + done.stderr
    assert " 0 failed" in done.stdout
    checks = json.loads((root / "build/checks.json").read_text("utf-8"))
    assert {c["engine"] for c in checks} >= {"SymPy", "numpy f64"}
    assert run(root, "generate", "--check").returncode == 0
    done = run(root, "site", "build")
    assert done.returncode == 0, done.stderr
    assert done.stdout.endswith(f"built {root / 'site' / 'index.html'}\n")
    assert (root / "site" / "systems" / "demo.html").is_file()
    done = run(root, "show", "demo", "aim")
    assert "SINGULAR: the sun is overhead" in done.stdout
    assert "numpy f64" in done.stdout


def test_init_overwrites_nothing(run: Run, tmp_path: Path):
    (tmp_path / "mkdocs.yml").write_text("mine", "utf-8")
    done = run(tmp_path, "init", "--name", "demo")
    assert done.returncode == 1
    assert done.stderr.startswith("error: already there: ")
    assert [path.name for path in tmp_path.iterdir()] == ["mkdocs.yml"]


def test_init_wants_a_name_that_python_and_c_take(run: Run, tmp_path: Path):
    done = run(tmp_path, "init", "--name", "2-axis")
    assert (done.returncode, list(tmp_path.iterdir())) == (1, [])
    assert "--name" in done.stderr


@pytest.mark.parametrize("name", ["class", "9lives", "a__b", "M_PI", "native", "papers", "Alone"])
def test_new_refuses_a_name_that_a_language_claims(run: Run, small: Project, name: str):
    done = run(small.root, "new", name)
    assert done.returncode == 1
    assert "mend:" in done.stderr
    assert not (small.derivations / name).exists()


def test_new_overwrites_nothing(run: Run, small: Project):
    done = run(small.root, "new", "alone")
    assert done.returncode == 1
    assert "already there" in done.stderr


def test_outside_a_project_it_says_what_is_missing(run: Run, tmp_path: Path):
    done = run(tmp_path, "generate")
    assert done.returncode == 1
    assert "[tool.armillary]" in done.stderr
    assert "armillary init" in done.stderr


def test_an_error_of_a_derivation_has_a_place_and_no_traceback(run: Run, small: Project):
    edit(small.root, "alone", "3 * x", "3 * z")
    done = run(small.root, "generate")
    assert done.returncode == 1
    assert "alone/derivation.py:5: NameError" in done.stderr
    assert "Traceback" not in done.stderr
    done = run(small.root, "--debug", "generate")
    assert done.returncode == 1
    assert "Traceback" in done.stderr


def test_list_tells_costs_and_what_is_out_of_date(run: Run, small: Project):
    assert "alone  (not generated yet)" in run(small.root, "list").stdout
    regenerate(small)
    edit(small.root, "base", "2 * cos", "3 * cos")
    lines = run(small.root, "list").stdout.splitlines()
    assert "base  (out of date: run `armillary generate`)" in lines
    assert "user  (out of date: run `armillary generate`)" in lines
    assert "alone" in lines
    assert "  far_off                  2 flops, 1 sin/cos" in lines


def test_show_tells_reasons_places_and_formulas(run: Run, small: Project):
    said = run(small.root, "show", "user").stdout
    assert "user-far" in said
    assert "derivations/user/derivation.py:5" in said
    assert "because: one further" in said
    assert "far = reach + 1" in said
    assert "user_far_off_f32(" in said
    said = run(small.root, "show", "base", "both", "--latex").stdout
    assert "\\mathrm{reach} = 2 \\cos{\\left(turn \\right)}" in said
    done = run(small.root, "show", "base", "nothing")
    assert (done.returncode, done.stderr) == (
        1,
        "error: base has no kernel 'nothing'\n  mend: it has both, one\n",
    )


def test_a_failing_check_fails_the_command(run: Run, small: Project):
    edit(small.root, "alone", "d.kernel", 'd.identity("false", y, 2 * x)\nd.kernel')
    regenerate(small)
    done = run(small.root, "check", "alone")
    assert done.returncode == 1
    assert any(
        line.split()[0] == "FAILED" and line.endswith("false") for line in done.stdout.splitlines()
    )
    assert " 1 failed" in done.stdout


def test_show_tells_that_an_edit_was_not_checked(run: Run, small: Project):
    regenerate(small)
    assert "checks: none yet; run `armillary check`" in run(small.root, "show", "alone").stdout
    run(small.root, "check", "alone")
    said = run(small.root, "show", "alone").stdout
    assert "numpy f64" in said
    edit(small.root, "alone", "3 * x", "-3 * x")
    said = run(small.root, "show", "alone").stdout
    assert "numpy f64" not in said
    assert "  checks: not checked since the last edit; run `armillary check`" in said


def test_files_that_cannot_be_read_give_no_traceback(run: Run, small: Project):
    regenerate(small)
    small.build.mkdir(exist_ok=True)
    (small.build / "checks.json").write_text("[{", "utf-8")
    assert "none yet" in run(small.root, "show", "alone").stdout
    path = small.derivations / "alone" / "tolerances.json"
    path.write_text('{"thrice": 3}', "utf-8")
    done = run(small.root, "check", "alone")
    assert done.returncode == 1
    assert "tolerances.json:1: the tolerances cannot be read" in done.stderr
    assert "Traceback" not in done.stderr
    path.unlink()
    done = run(small.root, "check", "alone")
    assert done.returncode == 0, done.stdout + done.stderr
