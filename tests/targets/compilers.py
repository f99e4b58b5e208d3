"""Compilers of this machine, and the warnings that the generated C is held to."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

WARNINGS = [
    *("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Wfloat-equal"),
    *("-Wshadow", "-Wundef", "-Wstrict-prototypes", "-Wmissing-prototypes", "-Wcast-qual"),
    *("-Wvla", "-Werror"),
]


def needs(*programs: str) -> pytest.MarkDecorator:
    """Skips a test where a program is missing, unless the run asks for every tool."""
    missing = [program for program in programs if shutil.which(program) is None]
    wanted = bool(os.environ.get("ARMILLARY_REQUIRE_ALL"))
    return pytest.mark.skipif(
        bool(missing) and not wanted, reason=f"{', '.join(missing)} is missing: `make tools`"
    )


def run(*command: object, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run a command; a failure shows what it said."""
    done = attempt(*command, cwd=cwd)
    assert done.returncode == 0, f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
    return done


def attempt(*command: object, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run a command that may fail."""
    words = [str(word) for word in command]
    return subprocess.run(words, capture_output=True, text=True, check=False, cwd=cwd)
