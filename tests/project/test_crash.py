"""Killed at every write, rename and unlink, a run leaves a set that the next one makes whole."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from armillary.project.config import Project
from tests.project.projects import ALONE, HOME, edit, environment, regenerate, write_system

DRIVER = Path(__file__).with_name("crash_driver.py")


@pytest.mark.slow
@pytest.mark.parametrize("begun", [True, False], ids=["over an old set", "into nothing"])
def test_every_death_is_survived(small: Project, tmp_path_factory: pytest.TempPathFactory, begun):
    after = tmp_path_factory.mktemp("after")
    shutil.copytree(small.derivations, after / "derivations")
    edit(after, "base", "2 * cos(turn)", "3 * cos(turn)")
    if begun:
        regenerate(small)
        shutil.rmtree(after / "derivations" / "alone")
        write_system(after, "newcomer", ALONE.replace('"alone"', '"newcomer"'))
    done = subprocess.run(
        [sys.executable, DRIVER, small.root, after, after / "work"],
        cwd=HOME,
        env=environment(PYTHONPATH=str(HOME)),
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    deaths, unfinished, second = map(int, done.stdout.split())
    assert deaths > 60
    assert unfinished > 15
    assert second > 15 or not begun
