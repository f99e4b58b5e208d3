"""One run at a time: a lock on a file, which the system releases when its owner dies."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from armillary.store.files import make_folder


@contextmanager
def locked(path: Path, waiting: Callable[[], None]) -> Iterator[None]:
    """Hold the lock; `waiting` is called once when another run has it."""
    make_folder(path.parent)
    handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        _wait(handle, waiting, shared=False)
        yield
    finally:
        os.close(handle)


@contextmanager
def locked_for_reading(path: Path, waiting: Callable[[], None]) -> Iterator[None]:
    """Keep writers out, and write nothing: with no lock file there is no writer to wait for."""
    try:
        handle = os.open(path, os.O_RDONLY)
    except FileNotFoundError:
        yield
        return
    try:
        _wait(handle, waiting, shared=True)
        yield
    finally:
        os.close(handle)


if sys.platform == "win32":
    import msvcrt

    def _wait(handle: int, waiting: Callable[[], None], shared: bool) -> None:
        told = False
        while True:
            try:
                msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
                return
            except OSError:
                if not told:
                    waiting()
                told = True
                time.sleep(0.1)

else:
    import fcntl

    def _wait(handle: int, waiting: Callable[[], None], shared: bool) -> None:
        kind = fcntl.LOCK_SH if shared else fcntl.LOCK_EX
        try:
            fcntl.flock(handle, kind | fcntl.LOCK_NB)
        except BlockingIOError:
            waiting()
            fcntl.flock(handle, kind)
