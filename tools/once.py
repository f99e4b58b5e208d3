"""Run a command unless nothing it reads has changed since it last succeeded.

    python tools/once.py STAMP --reads PATH... [--updates PATH...] [--makes PATH...] -- COMMAND...

The Makefile's steps go through this instead of comparing times of files, because contents do not
lie: switching a branch back, touching a file or importing a module costs nothing, while a deleted
or hand-edited file, a renamed derivation or a changed command is seen. The file STAMP keeps a
digest of what the command read, taken before it ran, so that an edit made meanwhile counts as new,
and of what it updates (regeneration both reads and writes the kernels), taken afterwards.
"""

import argparse
import hashlib
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORKED = ROOT / "build" / "worked"  # there once a step had something to do; the Makefile removes it

# Made on the way, or by a later step; never an input.
PASSED_OVER = {"__pycache__", ".lock", "katex.new", "site_docs/systems", "site_docs/papers"}


def files(path: Path) -> Iterator[Path]:
    """Every file at or under path that can be an input, in an order fixed by the names."""
    name = path.name
    if name in PASSED_OVER or name.startswith(".staging"):
        return
    if path.relative_to(ROOT).as_posix() in PASSED_OVER:
        return
    if path.is_dir():
        for child in sorted(path.iterdir()):
            yield from files(child)
    elif path.is_file():
        yield path


def digest(paths: list[str]) -> str:
    """One number for the names and contents of all files at or under the paths."""
    total = hashlib.sha256()
    for top in paths:
        for file in files(ROOT / top):
            total.update(b"\0" + os.fsencode(file.relative_to(ROOT)) + b"\0")
            total.update(hashlib.sha256(file.read_bytes()).digest())
    return total.hexdigest()


def main() -> int:
    """Judge, run, remember."""
    border = sys.argv.index("--")
    own, command = sys.argv[1:border], sys.argv[border + 1 :]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("stamp", type=Path)
    parser.add_argument("--reads", nargs="+", required=True)
    parser.add_argument("--updates", nargs="+", default=[])
    parser.add_argument("--makes", nargs="+", default=[])
    step = parser.parse_args(own)

    def state(read: str) -> str:
        return "\n".join([*command, read, digest(step.updates)])

    def missing() -> list[str]:
        return [path for path in step.makes if not (ROOT / path).exists()]

    stamp = ROOT / step.stamp
    read = digest(step.reads)
    if stamp.exists() and not missing() and stamp.read_text("utf-8") == state(read):
        return 0
    stamp.unlink(missing_ok=True)
    WORKED.parent.mkdir(exist_ok=True)
    WORKED.touch()
    print(f"== {stamp.name}", flush=True)
    status = subprocess.run(command, cwd=ROOT, check=False).returncode
    if status == 0 and missing():
        print(f"{stamp.name}: `{' '.join(command)}` did not make {', '.join(missing())}")
        status = 1
    if status == 0:
        stamp.parent.mkdir(parents=True, exist_ok=True)
        stamp.write_text(state(read), "utf-8")
    return status


if __name__ == "__main__":
    sys.exit(main())
