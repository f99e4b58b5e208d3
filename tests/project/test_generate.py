"""Regeneration: only what an edit touches, the same bytes everywhere, one run at a time."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from armillary.derivation.errors import DerivationError
from armillary.project.config import Project
from armillary.project.errors import ProjectError
from armillary.store.lock import locked
from armillary.targets.manifest import read_finished
from tests.project.conftest import Run
from tests.project.projects import (
    ALONE,
    HOME,
    edit,
    environment,
    regenerate,
    snapshot,
    times,
    write_system,
)


def touched(lines: list[str]) -> set[str]:
    """The systems that a run says something of."""
    return {line.split(".")[0] for line in lines if "." in line.split(":")[0]}


def test_first_run_makes_all_and_second_nothing(small: Project):
    assert touched(regenerate(small)) == {"alone", "base", "user"}
    before = times(small.generated)
    assert regenerate(small) == ["nothing to do: 3 systems are up to date"]
    assert times(small.generated) == before
    assert read_finished(small.generated) is not None


def test_nothing_to_do_loads_nothing_heavy(small: Project):
    regenerate(small)
    program = (
        "import sys; from armillary.cli import main; main(['generate'], standalone_mode=False);"
        "print(sorted({'sympy', 'mpmath', 'numpy', 'jinja2', 'mkdocs'} & sys.modules.keys()))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=small.root, env=environment(), check=True, capture_output=True, text=True,
    )  # fmt: skip
    assert done.stdout.splitlines()[-1] == "[]"


def test_an_edit_touches_its_system_and_its_users_only(small: Project):
    regenerate(small)
    before = times(small.generated)
    edit(small.root, "base", "2 * cos(turn)", "3 * cos(turn)")
    lines = regenerate(small)
    assert touched(lines) == {"base", "user"}
    changed = {Path(n).name for n, t in times(small.generated).items() if before.get(n) != t}
    files = {name for name in changed if "." in name.lstrip(".")}
    assert not {name for name in files if name.startswith("alone")}
    assert {"base_both_f32.c", "user_far_off_f32.c", "manifest.json"} <= files


def test_an_edit_of_a_file_beside_touches_its_system_and_its_users(small: Project):
    folder = small.derivations / "base"
    part = folder / "reach.py"
    text = "from armillary import cos\n\ndef reach_of(turn):\n    return 2 * cos(turn)\n"
    part.write_text(text, "utf-8")
    edit(small.root, "base", "2 * cos(turn)", "reach_of(turn)")
    edit(
        small.root,
        "base",
        "import Derivation",
        "import Derivation, cos, sin\nfrom .reach import reach_of  #",
    )
    regenerate(small)
    assert regenerate(small) == ["nothing to do: 3 systems are up to date"]
    before = snapshot(small.generated)
    part.write_text(text.replace("2 *", "3 *"), "utf-8")
    lines = regenerate(small)
    assert touched(lines) == {"base", "user"}
    assert "base.one: unchanged, 0 flops, 1 sin/cos" in lines
    part.write_text(text, "utf-8")
    regenerate(small)
    assert snapshot(small.generated) == before


def test_it_says_which_definitions_changed_and_what_that_costs(small: Project):
    regenerate(small)
    edit(small.root, "base", "2 * cos(turn)", "2 * cos(turn) + sin(turn) * 5")
    lines = regenerate(small)
    assert "base.one: unchanged, 0 flops, 1 sin/cos" in lines
    assert "base.both: changed reach, 1 flops, 2 sin/cos -> 3 flops, 2 sin/cos" in lines
    edit(small.root, "alone", 'd.kernel("thrice"', 'd.kernel("three_times"')
    lines = regenerate(small)
    assert "alone.three_times: new, 1 flops" in lines
    assert "alone.thrice: removed" in lines
    assert not list(small.generated.rglob("alone_thrice*"))


def test_an_edit_taken_back_gives_the_old_bytes(small: Project):
    regenerate(small)
    before = snapshot(small.generated)
    edit(small.root, "alone", "3 * x", "4 * x")
    regenerate(small)
    assert snapshot(small.generated) != before
    edit(small.root, "alone", "4 * x", "3 * x")
    regenerate(small)
    assert snapshot(small.generated) == before


def test_one_system_by_name_leaves_others_for_later(small: Project):
    regenerate(small)
    edit(small.root, "alone", "3 * x", "4 * x")
    edit(small.root, "base", "2 * cos", "3 * cos")
    lines = regenerate(small, "base")
    assert touched(lines) == {"base", "user"}
    assert lines[0] == "left as they are, though out of date: alone"
    assert touched(regenerate(small)) == {"alone"}


def test_a_removed_system_takes_its_files_along(small: Project):
    regenerate(small)
    shutil.rmtree(small.derivations / "alone")
    lines = regenerate(small)
    assert touched(lines) == set()
    assert not [name for name in snapshot(small.generated) if "alone" in name]


def test_damaged_and_missing_files_are_made_again(small: Project):
    regenerate(small)
    good = snapshot(small.generated)
    (small.generated / "c/src/demo_kernels/base.h").write_text("edited", "utf-8")
    (small.generated / "python/demo_kernels/alone.py").unlink()
    (small.generated / "python/demo_kernels/_runtime.py").unlink()
    assert read_finished(small.generated) is None
    assert touched(regenerate(small)) == {"alone", "base"}
    assert snapshot(small.generated) == good
    (small.generated / "manifest.json").unlink()
    regenerate(small)
    assert snapshot(small.generated) == good


def test_a_generated_set_of_other_derivations_is_not_taken_for_ours(small: Project):
    regenerate(small)
    good = snapshot(small.generated)
    shutil.copytree(small.generated, small.root / "kept")
    edit(small.root, "alone", "3 * x", "4 * x")
    regenerate(small)
    shutil.rmtree(small.generated)
    (small.root / "kept").rename(small.generated)
    assert touched(regenerate(small)) == {"alone"}
    edit(small.root, "alone", "4 * x", "3 * x")
    regenerate(small)
    assert snapshot(small.generated) == good


def test_strangers_are_named_and_kept(small: Project):
    (small.generated / "notes").mkdir(parents=True)
    (small.generated / "notes" / "mine.txt").write_text("mine", "utf-8")
    (small.generated / "budgets.json").write_text("{}", "utf-8")
    lines = regenerate(small)
    warning = "warning: generated/notes/mine.txt is not made by any derivation; remove it"
    assert [line for line in lines if "warning" in line] == [warning]
    assert warning in regenerate(small)
    assert (small.generated / "notes" / "mine.txt").is_file()


def test_an_error_writes_nothing(small: Project):
    regenerate(small)
    before = times(small.generated)
    edit(small.root, "alone", "3 * x", "3 * z")
    edit(small.root, "base", "2 * cos", "3 * cos")
    with pytest.raises(DerivationError, match=r"derivation\.py:5"):
        regenerate(small)
    assert times(small.generated) == before


def test_an_unknown_system_is_refused_with_a_choice(small: Project):
    with pytest.raises(ProjectError, match="alone, base, user"):
        regenerate(small, "nobody")


def test_two_files_of_one_name_are_refused(small: Project):
    write_system(small.root, "base_one", ALONE.replace('"alone"', '"base_one"'))
    edit(small.root, "base_one", '"thrice", inputs', '"more", inputs')
    edit(small.root, "base", 'd.kernel("one"', 'd.kernel("one_more"')
    with pytest.raises(ProjectError, match=r"base_one and .* both make generated/"):
        regenerate(small)
    assert not (small.generated / "manifest.json").exists()


def test_the_manifest_holds_only_what_comes_out_the_same(small: Project):
    regenerate(small)
    text = (small.generated / "manifest.json").read_text("utf-8")
    content = json.loads(text)
    assert set(content) == {"engine", "format", "shared", "systems"}
    assert str(small.root) not in text
    facts = content["systems"]["user"]["kernels"]["far_off"]
    told = {"cost", "definitions", "digest", "signatures", "stages", "stated", "strategy"}
    assert set(facts) == told
    assert facts["signatures"].keys() == {"f32"}
    assert set(facts["definitions"]) == {"base-reach", "user-far"}


def test_a_second_run_waits_and_says_so(small: Project):
    with locked(small.generated / ".lock", lambda: None):
        other = subprocess.Popen(
            [sys.executable, "-m", "armillary.cli", "generate"],
            cwd=small.root,
            env=environment(),
            stdout=subprocess.PIPE,
            text=True,
        )
        assert other.stdout is not None
        assert other.stdout.readline() == "waiting for another run to finish\n"
        assert not (small.generated / "manifest.json").exists()
    rest = other.communicate()[0]
    assert other.returncode == 0
    assert "files written" in rest


def test_two_runs_at_once_give_one_whole_set(small: Project, tmp_path: Path):
    regenerate(small)
    wanted = snapshot(small.generated)
    shutil.rmtree(small.generated)
    shutil.rmtree(small.build)
    runs = [
        subprocess.Popen(
            [sys.executable, "-m", "armillary.cli", "generate"],
            cwd=small.root,
            env=environment(),
            stdout=subprocess.PIPE,
            text=True,
        )
        for _ in range(3)
    ]
    said = [one.communicate()[0] for one in runs]
    assert [one.returncode for one in runs] == [0, 0, 0]
    assert sum("nothing to do" in text for text in said) == 2
    assert snapshot(small.generated) == wanted


@pytest.mark.slow
def test_the_same_bytes_everywhere(run: Run, tmp_path: Path):
    """Hash seeds, working folder, place of the project, locale and time zone change nothing."""
    circumstances = [
        {"PYTHONHASHSEED": "0", "TZ": "UTC", "LC_ALL": "C"},
        {"PYTHONHASHSEED": "1", "TZ": "Asia/Kathmandu", "LC_ALL": "C.UTF-8"},
        {"PYTHONHASHSEED": "2", "TZ": "America/St_Johns", "LC_ALL": "de_DE.UTF-8"},
    ]
    found = []
    for number, circumstance in enumerate(circumstances):
        root = tmp_path / ("deep/" * number) / f"copy {number}"
        shutil.copytree(HOME / "derivations", root / "derivations")
        shutil.copy(HOME / "pyproject.toml", root)
        write_system(root, "alone", ALONE)
        inside = root / "derivations" / "alone" if number else root
        done = run(inside, "generate", **circumstance)
        assert done.returncode == 0, done.stderr
        found.append(snapshot(root / "generated"))
    assert len(found[0]) > 10
    assert found[0] == found[1] == found[2]
