"""What the tests of the command line and of regeneration share."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from armillary.project.config import Project, find_project
from tests.project.projects import ALONE, BASE, SETTINGS, USER, environment, write_system

Run = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture
def run() -> Run:
    """`run(folder, "generate", "--check")` runs the command line in a folder."""

    def call(folder: Path, *words: str, **more: str) -> "subprocess.CompletedProcess[str]":
        command = [sys.executable, "-m", "armillary.cli", *words]
        return subprocess.run(
            command,
            cwd=folder,
            env=environment(**more),
            capture_output=True,
            text=True,
            check=False,
        )

    return call


@pytest.fixture
def small(tmp_path: Path) -> Project:
    """A project of three systems; `user` uses `base`."""
    (tmp_path / "pyproject.toml").write_text(SETTINGS, "utf-8")
    for name, text in (("base", BASE), ("user", USER), ("alone", ALONE)):
        write_system(tmp_path, name, text)
    return find_project(tmp_path)
