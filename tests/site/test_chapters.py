"""The chapters, followed word for word."""

import os
import re
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from tests.site.conftest import ROOT
from tests.targets.compilers import needs


def blocks(chapter: str, language: str) -> list[str]:
    text = (ROOT / "site_docs" / chapter).read_text("utf-8")
    found = re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert found, f"{chapter} has no {language}"
    return found


def shell(commands: str, folder: Path, **more: str) -> str:
    path = f"{folder / 'bin'}:{os.environ['PATH']}"
    done = subprocess.run(
        ["sh", "-e", "-c", commands],
        cwd=folder,
        env={"PATH": path, "HOME": str(folder), "LANG": "C.UTF-8", **more},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.tool
@needs("cc")
def test_the_c_chapter(tmp_path):
    (tmp_path / "generated").symlink_to(ROOT / "generated")
    (source,) = blocks("using-c.md", "c")
    (tmp_path / "tracker.c").write_text(source, "utf-8")
    (commands,) = blocks("using-c.md", "sh")
    # 3.2 m up to the axis, less half a metre times the sine of the tilt
    strict = commands.replace("-O2", "-O2 -Wall -Wextra -Wdouble-promotion -Werror")
    assert "tilt 0.3841 height 3.0126" in shell(strict, tmp_path)


def python_examples():
    found = []
    for source in blocks("using-python.md", "python"):
        marks = [pytest.mark.tool, needs("cc")] if "native" in source else []
        found.append(pytest.param(source, marks=marks))
    return found


@pytest.mark.parametrize("source", python_examples())
def test_the_python_chapter(source, tmp_path):
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", source],
        env={
            "PYTHONPATH": str(ROOT / "generated" / "python"),
            "PATH": os.environ["PATH"],
            "HOME": str(tmp_path),
        },
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout


@pytest.mark.slow
def test_the_chapter_on_adding_a_mechanism(tmp_path):
    command = tmp_path / "bin" / "armillary"
    command.parent.mkdir()
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m armillary.cli "$@"\n', "utf-8")
    command.chmod(command.stat().st_mode | stat.S_IXUSR)
    for commands in blocks("adding-a-mechanism.md", "sh"):
        shell(commands, tmp_path, PYTHONPATH=str(ROOT))
    page = (tmp_path / "site" / "systems" / "demo.html").read_text("utf-8")
    assert 'id="kernel-demo-pose"' in page
    assert "run <code>armillary" not in page  # generated, checked, and shown
    assert 'class="badge fail"' not in page
