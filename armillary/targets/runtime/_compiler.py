"""Builds the C kernels into a shared library, once, and keeps it in the user's cache."""

import hashlib
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

FLAGS = ["-std=c99", "-O2", "-ffp-contract=off", "-fno-math-errno", "-fPIC", "-shared"]


class NoCompilerError(RuntimeError):
    """There is no C compiler on this machine, or it cannot build the kernels."""


def library(sources: Path, names: Sequence[str], extra: str) -> Path:
    """The shared library of some sources in a folder and one more text.

    Raises:
        NoCompilerError: says what to install, or what the compiler said.
    """
    headers, inputs = sorted(sources.glob("*.h")), [sources / name for name in names]
    if not headers:
        raise FileNotFoundError(f"no C kernels in {sources}")
    # The compiler is looked for only when there is something to compile.
    machine = [os.environ.get("CC", ""), sys.platform, platform.machine()]
    key = hashlib.sha256(" ".join([*FLAGS, *machine]).encode())
    for file in (*inputs, *headers):
        key.update(file.name.encode() + file.read_bytes())
    key.update(extra.encode())
    target = _cache() / f"kernels-{key.hexdigest()[:24]}.so"
    if not target.exists():
        _build(_compiler(), sources, inputs, extra, target)
    return target


def _compiler() -> list[str]:
    named = os.environ.get("CC")
    for command in [named] if named else ["cc", "gcc", "clang"]:
        words = shlex.split(command)
        if shutil.which(words[0]):
            return words
    what = f"CC={named} is not there" if named else "no C compiler (cc, gcc or clang) was found"
    raise NoCompilerError(
        f"{what}: install gcc or clang (on Debian: apt-get install gcc), or set CC; "
        "the functions outside `native` need none"
    )


def _cache() -> Path:
    base = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    folder = Path(base) / "armillary"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError:
        # No home to write to, as in many containers: built anew for each process.
        return Path(tempfile.mkdtemp(prefix="armillary-"))


def _build(
    compiler: list[str], folder: Path, inputs: Sequence[Path], extra: str, target: Path
) -> None:
    with tempfile.TemporaryDirectory(dir=target.parent) as scratch:
        batch = Path(scratch) / "batch.c"
        batch.write_text(extra, encoding="utf-8")
        made = Path(scratch) / target.name
        texts = [str(path) for path in (batch, *inputs)]
        command = [*compiler, *FLAGS, f"-I{folder}", "-o", str(made), *texts, "-lm"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise NoCompilerError(f"{done.stderr}\n{shlex.join(command)} failed as said above")
        made.replace(target)
