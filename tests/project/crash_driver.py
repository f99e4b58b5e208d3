"""Kills regeneration at the n-th write, rename or unlink, for every n, and looks at what is left.

    python crash_driver.py BEFORE AFTER WORK

BEFORE is a generated project, AFTER the same with other derivations. WORK is made from them again
and again. A child process regenerates it and dies at the n-th call; what a reader then sees, and
what the next run makes of it, must be as promised. Prints how many deaths were survived.
"""

import itertools
import os
import shutil
import signal
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

from armillary.project import stamp, work
from armillary.project.config import Project, find_project
from armillary.project.generate import generate
from armillary.targets.manifest import read_finished
from tests.project.projects import snapshot

CALLS = ("fsync", "mkdir", "open", "rename", "replace", "rmdir", "unlink", "write")
made_systems = work.make_system


class Death:
    """Kills this process at the n-th call that changes a disk; a write is torn first."""

    def __init__(self, at: int) -> None:
        self.at, self.count = at, 0
        for name in CALLS:
            setattr(os, name, self.wrap(name, getattr(os, name)))

    def wrap(self, name: str, real: Callable[..., object]) -> Callable[..., object]:
        def call(*arguments: object, **more: object) -> object:
            reads = name == "open" and not int(arguments[1]) & os.O_CREAT
            if not reads:
                self.count += 1
            if self.count == self.at and not reads:
                if name == "write":
                    real(arguments[0], bytes(arguments[1])[: len(arguments[1]) // 2])
                os.kill(os.getpid(), signal.SIGKILL)
            return real(*arguments, **more)

        return call


def remembered(known: dict[tuple[str, str], work.Made]) -> Callable[..., work.Made]:
    """Make each system once: it is the writing that is tested here."""

    def make(project: Project, name: str, listener: work.Listener) -> work.Made:
        texts = sorted(project.derivations.glob("*/derivation.py"))
        key = (name, "".join(path.read_text("utf-8") for path in texts))
        if key not in known:
            known[key] = made_systems(project, name, listener)
        listener.system(name, known[key])
        return known[key]

    return make


def remembered_shared() -> Callable[..., dict[str, str]]:
    """The files common to all systems, made once for each set of systems."""
    known: dict[str, dict[str, str]] = {}
    real = work.render_shared

    def make(target: object, rendered: dict[str, work.Rendered]) -> dict[str, str]:
        key = repr({name: one.table for name, one in rendered.items()})
        if key not in known:
            known[key] = real(target, rendered)
        return known[key]

    return make


def in_child(action: Callable[[], object]) -> bool:
    """Whether the action came to its end."""
    child = os.fork()
    if child == 0:
        try:
            action()
        except BaseException as problem:
            print(f"{type(problem).__name__}: {problem}", file=sys.stderr, flush=True)
            os._exit(3)
        os._exit(0)
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return False
    assert os.WEXITSTATUS(status) == 0, "a run failed without being killed"
    return True


class Trial:
    """The same regeneration, killed again and again."""

    def __init__(self, before: Path, after: Path, folder: Path) -> None:
        self.before, self.after, self.folder = before, after, folder
        self.prepare()
        self.old = snapshot(folder / "generated")
        self.run()
        self.new = snapshot(folder / "generated")
        assert self.old != self.new

    def prepare(self) -> None:
        """The project as it is when the derivations have just been edited."""
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(self.before, self.folder)
        shutil.rmtree(self.folder / "derivations")
        shutil.copytree(self.after / "derivations", self.folder / "derivations")

    def run(self, dies_at: int = 0) -> None:
        if dies_at:
            Death(dies_at)
        generate(find_project(self.folder), (), lambda line: None)

    def look(self) -> str:
        """What a reader sees now: the old set, the new set, or an unfinished one."""
        folder = self.folder / "generated"
        manifest = read_finished(folder)
        if manifest is None:
            return "unfinished"
        found = {**manifest.files, "manifest.json": ""}
        for state, wanted in (("old", self.old), ("new", self.new)):
            if set(found) == set(wanted):
                assert all((folder / n).read_bytes() == wanted[n] for n in found), "a mixture"
                return state
        raise AssertionError("a finished set that is neither the old nor the new one")

    def recover(self) -> None:
        """An undisturbed run must give what it gives without any death before."""
        assert in_child(self.run)
        found = snapshot(self.folder / "generated")
        differing = [n for n in {**found, **self.new} if found.get(n) != self.new.get(n)]
        assert not differing, differing
        assert self.look() == "new"
        hidden = [p.name for p in (self.folder / "generated").glob(".*")]
        assert hidden == [".lock"], f"left behind: {hidden}"
        again: list[str] = []
        generate(find_project(self.folder), (), again.append)
        assert again[0].startswith("nothing to do"), again

    def survive_all(self) -> list[str]:
        """Die at every call; what was seen after each death."""
        seen = []
        while True:
            self.prepare()
            if in_child(partial(self.run, len(seen) + 1)):
                return seen
            seen.append(self.look())
            self.recover()

    def survive_twice(self, first: int) -> int:
        """Die at one call, then at every call of the run that recovers."""
        for second in itertools.count(1):
            self.prepare()
            assert not in_child(partial(self.run, first))
            if in_child(partial(self.run, second)):
                break
            self.look()
            self.recover()
        return second - 1


def main() -> None:
    """Try every death; from an old set also every second death, after one amid the moves."""
    before, after, folder = map(Path, sys.argv[1:])
    work.make_system = remembered({})
    work.render_shared = remembered_shared()
    stamp.base_digest = lambda project: "the engine stays as it is"
    trial = Trial(before, after, folder)
    # Neither a mixture, nor a way back from the new set to the old one.
    seen = trial.survive_all()
    order = {"old": 0, "unfinished": 1, "new": 2}
    assert seen == sorted(seen, key=lambda state: order[state])
    unfinished = [n + 1 for n, state in enumerate(seen) if state == "unfinished"]
    amid = unfinished[len(unfinished) // 3]
    print(len(seen), len(unfinished), trial.survive_twice(amid) if trial.old else 0)


if __name__ == "__main__":
    main()
