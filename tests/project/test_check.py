"""`generate --check` finds every difference, shows it, and writes nothing."""

import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from armillary.project.config import Project
from armillary.project.difference import differences
from armillary.store.lock import locked
from tests.project.conftest import Run
from tests.project.projects import edit, regenerate, times


@pytest.fixture
def made(small: Project) -> Project:
    regenerate(small)
    return small


def compared(project: Project, *names: str) -> tuple[int, str]:
    lines: list[str] = []
    before = times(project.root)
    wrong = differences(project, names, lines.append)
    assert times(project.root) == before
    return wrong, "\n".join(lines)


def test_nothing_differs_after_a_run(made: Project):
    assert compared(made)[0] == 0


def test_a_changed_file_is_shown_as_a_diff(made: Project):
    path = made.generated / "c/src/demo_kernels/alone_thrice_f32.c"
    path.write_text(path.read_text("utf-8").replace("3", "4"), "utf-8")
    wrong, said = compared(made)
    assert wrong == 1
    assert "changed: generated/c/src/demo_kernels/alone_thrice_f32.c" in said
    assert "--- generated/c/src/demo_kernels/alone_thrice_f32.c" in said
    assert "+++ generated/c/src/demo_kernels/alone_thrice_f32.c (from the derivations)" in said
    assert any(line.startswith("-") and "4" in line for line in said.splitlines())


def test_a_carriage_return_and_a_missing_last_end_are_differences(made: Project):
    path = made.generated / "python/demo_kernels/alone.py"
    whole = path.read_bytes()
    path.write_bytes(whole.replace(b"\n", b"\r\n"))
    assert "\\r" in compared(made)[1]
    path.write_bytes(whole.rstrip(b"\n"))
    assert "no newline at end of file" in compared(made)[1]


def test_missing_and_extra_files_are_found(made: Project):
    (made.generated / "python/demo_kernels/base.py").unlink()
    (made.generated / "c/src/demo_kernels/left_over.c").write_text("int x;\n", "utf-8")
    (made.generated / "budgets.json").write_text("{}", "utf-8")
    cache = made.generated / "python/demo_kernels/__pycache__"
    cache.mkdir()
    (cache / "base.cpython-311.pyc").write_bytes(b"")
    wrong, said = compared(made)
    assert wrong == 2
    assert "missing: generated/python/demo_kernels/base.py" in said
    assert "--- /dev/null" in said
    assert "extra: generated/c/src/demo_kernels/left_over.c" in said


def test_neither_manifest_nor_stamp_is_trusted(made: Project):
    """A changed derivation shows although every digest on disk agrees with the others."""
    edit(made.root, "base", "2 * cos", "3 * cos")
    wrong, said = compared(made)
    assert wrong >= 5
    assert "changed: generated/manifest.json" in said
    assert "changed: generated/python/demo_kernels/user.py" in said
    assert "alone" not in said.replace("made alone anew", "")


def test_named_systems_are_compared_alone(made: Project):
    edit(made.root, "base", "2 * cos", "3 * cos")
    assert compared(made, "alone")[0] == 0
    assert compared(made, "user")[0] == 3


def test_an_interrupted_run_is_named(made: Project):
    staging = made.generated / ".staging"
    staging.mkdir()
    (staging / "journal.json").write_text("{}", "utf-8")
    wrong, said = compared(made)
    assert wrong == 1
    assert "interrupted" in said


def test_without_anything_generated_all_is_missing_and_nothing_is_made(small: Project):
    wrong, said = compared(small)
    assert wrong > 10
    assert not small.generated.exists()
    assert "missing: generated/manifest.json" in said


def test_it_waits_for_a_run_at_work(made: Project, run: Run):
    said: list[str] = []
    with ThreadPoolExecutor() as pool:
        with locked(made.generated / ".lock", lambda: None):
            other = pool.submit(differences, made, (), said.append)
            while not said:
                time.sleep(0.01)
        assert other.result() == 0
    assert said[0] == "waiting for another run to finish"


def test_the_command_fails_with_the_diff(made: Project, run: Run):
    assert run(made.root, "generate", "--check").returncode == 0
    path: Path = made.generated / "python/demo_kernels/__init__.py"
    path.write_text("", "utf-8")
    done = run(made.root, "generate", "--check")
    assert done.returncode == 1
    assert "+++ generated/python/demo_kernels/__init__.py" in done.stdout
    assert done.stderr.startswith("error: 1 file is not what the derivations give\n  mend: ")
