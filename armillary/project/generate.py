"""Brings the generated files up to date, all of them or none."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from armillary.project.config import Project
from armillary.project.report import system_report
from armillary.project.stamp import (
    STAMP,
    Inputs,
    Mark,
    Stamp,
    is_fresh,
    read_stamp,
    take_inputs,
)
from armillary.store.files import digest, digest_of
from armillary.store.lock import locked
from armillary.store.transaction import Recovery, commit, recover
from armillary.targets.manifest import (
    MANIFEST,
    Entry,
    Manifest,
    read_manifest,
    strangers,
)

if TYPE_CHECKING:
    from armillary.project.work import Made

LOCK = ".lock"
Say = Callable[[str], None]


@dataclass
class State:
    """What is on disk when a run begins."""

    inputs: Inputs
    stamp: Stamp
    manifest: Manifest | None
    stale: list[str]

    def entry(self, name: str) -> Entry | None:
        """What the manifest has of a system."""
        return self.manifest.systems.get(name) if self.manifest else None


class Progress:
    """Says what is at work when that takes long."""

    PATIENCE = 1.0

    def __init__(self, say: Say) -> None:
        self._say = say
        self._last = time.monotonic()

    def kernel(self, system: str, name: str) -> None:
        """A kernel is about to be compiled."""
        if time.monotonic() - self._last > self.PATIENCE:
            self.tell(f"at work on {system}.{name}")

    def system(self, name: str, made: Made) -> None:
        """A system has come out."""
        self.tell(f"made {name} anew")

    def tell(self, line: str) -> None:
        """Say a line, and remember when."""
        self._say(line)
        self._last = time.monotonic()


class Reporter(Progress):
    """Says what changed in each kernel too."""

    def __init__(self, state: State, say: Say) -> None:
        super().__init__(say)
        self._state = state

    def system(self, name: str, made: Made) -> None:
        """A system has come out."""
        for line in system_report(name, self._state.entry(name), made.entry):
            self.tell(line)


def generate(project: Project, names: tuple[str, ...], say: Say) -> bool:
    """Regenerate what is out of date; tells whether anything was written.

    Args:
        names: regenerate these and what uses them; the others only when their files are damaged.
        say: takes lines for the person at the keyboard.

    Raises:
        ProjectError: for a system that is not there.
        DerivationError: for anything wrong in a derivation; then nothing is written.
    """
    project.chosen(names)
    with locked(project.generated / LOCK, lambda: say("waiting for another run to finish")):
        _tidy(project, say)
        state = survey(project)
        todo, later = _split(project, state, names)
        if later:
            say(f"left as they are, though out of date: {', '.join(later)}")
        if not todo and _shared_is_fresh(project, state):
            say(_up_to_date(project))
            _warn_of_strangers(project, state.manifest, say)
            return False
        return _regenerate(project, state, todo, say)


def survey(project: Project) -> State:
    """Compare the project with its manifest and its stamp; needs no SymPy."""
    inputs = take_inputs(project)
    stamp = read_stamp(project.build / STAMP)
    manifest = read_manifest(project.generated)
    entries = manifest.systems if manifest else {}
    stale = [
        name
        for name in project.systems()
        if not is_fresh(project, inputs, stamp.marks.get(name), entries.get(name))
    ]
    return State(inputs, stamp, manifest, stale)


def _tidy(project: Project, say: Say) -> None:
    found = recover(project.generated)
    if found is Recovery.FINISHED:
        say("finished what an interrupted run had begun")
    elif found is Recovery.DISCARDED:
        say("discarded what an interrupted run had left behind")


def _split(project: Project, state: State, names: tuple[str, ...]) -> tuple[list[str], list[str]]:
    """The stale systems: which to do now, and which to leave because nobody asked."""

    def due(name: str) -> bool:
        entry = state.entry(name)
        if not names or name in names or entry is None:
            return True
        mark = state.stamp.marks.get(name)
        if not entry.intact(project.generated) or mark is None or mark.entry != entry.digest():
            return True
        used = {f"derivations/{other}/derivation.py" for other in names}
        return bool(used & set(mark.reads))

    todo = [name for name in state.stale if due(name)]
    return todo, [name for name in state.stale if name not in todo]


def _shared_is_fresh(project: Project, state: State) -> bool:
    return (
        state.manifest is not None
        and state.stamp.base == state.inputs.base
        and set(state.manifest.systems) == set(project.systems())
        and state.manifest.shared.intact(project.generated)
    )


def _up_to_date(project: Project) -> str:
    count = len(project.systems())
    return f"nothing to do: {count} system{'s are' if count != 1 else ' is'} up to date"


def _regenerate(project: Project, state: State, todo: list[str], say: Say) -> bool:
    from armillary.project import work

    listener = Reporter(state, say)
    done = {name: work.make_system(project, name, listener) for name in todo}
    rendered = {name: made.rendered for name, made in done.items()}
    entries = {name: made.entry for name, made in done.items()}
    for name in project.systems():
        entry = state.entry(name)
        if name not in done and entry is not None:
            table = state.stamp.marks[name].table
            rendered[name] = work.known_system(project, name, entry, table)
            entries[name] = entry
    shared, manifest = work.make_shared(project, rendered, entries)
    texts = {n: text for made in done.values() for n, text in made.rendered.files.items()}
    wrote = _write(project, state, {**texts, **shared}, manifest, say)
    _stamp(project, state, done)
    return wrote


def _write(
    project: Project, state: State, texts: dict[str, str], manifest: Manifest, say: Say
) -> bool:
    """Change what differs on disk, as one."""
    folder, seal = project.generated, manifest.text().encode()
    write = {
        name: text.encode()
        for name, text in texts.items()
        if digest_of(folder / name) != manifest.files[name]
    }
    old = state.manifest.files if state.manifest else {}
    remove = [n for n in old if n not in manifest.files and (folder / n).is_file()]
    if write or remove or digest_of(folder / MANIFEST) != digest(seal):
        commit(folder, MANIFEST, {**write, MANIFEST: seal}, remove)
    same = len(manifest.files) - len(write)
    say(f"{len(write)} files written, {len(remove)} removed, {same} as they were")
    _warn_of_strangers(project, manifest, say)
    return bool(write or remove)


def _warn_of_strangers(project: Project, manifest: Manifest | None, say: Say) -> None:
    for name in strangers(project.generated, manifest.files if manifest else {}):
        say(f"warning: generated/{name} is not made by any derivation; remove it")


def _stamp(project: Project, state: State, done: dict[str, Made]) -> None:
    marks = {n: m for n, m in state.stamp.marks.items() if n in project.systems()}
    for name, made in done.items():
        inputs = state.inputs.digest(made.reads)
        marks[name] = Mark(made.reads, inputs, made.entry.digest(), made.table)
    Stamp(state.inputs.base, marks).write(project.build / STAMP)
