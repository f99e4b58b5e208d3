"""Runs the parts of a study: what is kept is taken, the rest runs side by side.

A part runs in a process of its own when others can run at the same time, and else in this one. One
that fails does not stop the others; whatever is finished is kept, however this ends.
"""

from __future__ import annotations

import math
import os
import queue
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from armillary.verify.engines import EngineMissing
from armillary.verify.studies.compute import Study, compute, key_of
from armillary.verify.studies.errors import StudyError, told
from armillary.verify.studies.kept import Kept, find, last_seconds, read
from armillary.verify.studies.parts import ALONE, Found, parts_of, with_needed
from armillary.verify.studies.process import Heard, Message, Process
from armillary.verify.study import Absent, Item, Result

Say = Callable[[str], None]
Outcome = Kept | Absent | StudyError


def run_study(study: Study, only: Sequence[str], say: Say) -> tuple[Item, ...]:
    """What the parts of a study found, in the order of the page.

    Args:
        only: names of parts; all unless given.
        say: takes lines on how it goes on; none when everything is kept.

    Raises:
        StudyError: for anything that goes wrong in the author's files; of several, the first.
        ParameterError: for anything wrong with the parameters.
    """
    try:
        parts = parts_of(study.path)
    except EngineMissing as missing:
        return (_absent("", missing.engine),)
    except Exception as problem:  # a study is the author's code: say which line of it
        raise told(study.path, problem) from problem
    run = _Run(study, with_needed(parts, only), say)
    try:
        run.to_the_end()
    except KeyboardInterrupt:
        say(f"stopped studying {study.system}; what was finished is kept")
        raise
    shown = [part.name for part in parts if not only or part.name in only]
    return tuple(item for name in shown for item in run.items(name))


def cores() -> int:
    """How many parts may run side by side."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _absent(part: str, engine: str) -> Absent:
    return Absent(part, f"{engine} is not installed")


class _Run:
    """Some parts of a study on their way; of each that has ended, the outcome."""

    def __init__(self, study: Study, parts: Sequence[Found], say: Say) -> None:
        self._study, self._parts, self._say = study, parts, say
        self._surroundings = study.surroundings()
        self._outcomes: dict[str, Outcome] = {}
        self._ready: dict[str, Found] = {}
        self._running: dict[str, Process] = {}
        self._heard: Heard = queue.Queue()

    def to_the_end(self) -> None:
        """Run all that is not kept.

        Raises:
            StudyError: that of the first part that failed, once the others have ended.
        """
        most = cores()
        try:
            while self._look() or self._running:
                if not self._running and (most == 1 or len(self._ready) == 1):
                    self._run_here(self._next())
                    continue
                while self._ready and len(self._running) < most:
                    self._start(self._next())
                self._hear(*self._heard.get())
        finally:
            for process in self._running.values():
                process.stop()
        for outcome in self._outcomes.values():
            if isinstance(outcome, StudyError):
                raise outcome

    def items(self, name: str) -> tuple[Item, ...]:
        """What stands on the page for a part that has ended well."""
        outcome = self._outcomes[name]
        assert not isinstance(outcome, StudyError)
        if isinstance(outcome, Absent):
            return (outcome,)
        return tuple(item for item in outcome.items if not isinstance(item, Result))

    # -- what is to be done -----------------------------------------------------------------------

    def _look(self) -> bool:
        """Find the parts that can run, and whether there are any; take those that are kept."""
        known = -1
        while known != len(self._outcomes):  # one that is kept may let others run
            known = len(self._outcomes)
            for part in self._parts:
                if not self._is_known(part) and self._outcomes.keys() >= set(part.needs):
                    self._take(part)
        return bool(self._ready)

    def _is_known(self, part: Found) -> bool:
        return any(part.name in known for known in (self._outcomes, self._ready, self._running))

    def _take(self, part: Found) -> None:
        """A part whose needs have ended: it is kept, cannot run, or is ready."""
        for need in part.needs:
            outcome = self._outcomes[need]
            if isinstance(outcome, StudyError):
                self._outcomes[part.name] = outcome
                return
            if isinstance(outcome, Absent):
                self._outcomes[part.name] = Absent(part.name, outcome.why)
                return
        twice = _twice(self._outcomes[need] for need in part.needs)
        if twice:
            self._outcomes[part.name] = StudyError(
                f"two parts that {part.name!r} needs leave a result {twice!r}", "rename one"
            )
            return
        key = key_of(self._study, part, self._results(part))
        found = find(self._study.folder(part.name), key, self._surroundings.are)
        if found is not None:
            self._outcomes[part.name] = found
        else:
            self._ready[part.name] = part

    def _results(self, part: Found) -> Mapping[str, Any]:
        """What the parts that it needs have left."""
        needed = [self._outcomes[need] for need in part.needs]
        return {
            name: value
            for outcome in needed
            if isinstance(outcome, Kept)
            for name, value in outcome.results.items()
        }

    def _next(self) -> Found:
        """The part to run now: one that has not run yet, or that took longest."""

        def last(name: str) -> float:
            seconds = last_seconds(self._study.folder(name))
            return math.inf if seconds is None else seconds

        return self._ready.pop(max(self._ready, key=last))

    # -- doing it ---------------------------------------------------------------------------------

    def _run_here(self, part: Found) -> None:
        self._say(f"studying {self._title(part.name)}")
        try:
            found = compute(
                self._study,
                part,
                self._results(part),
                lambda fraction, words: self._tell(part.name, fraction, words),
                lambda: self._wait(part.name),
            )
        except EngineMissing as missing:
            self._end(part.name, _absent(part.name, missing.engine))
        except StudyError as problem:
            self._end(part.name, problem)
        else:
            self._end(part.name, found)

    def _start(self, part: Found) -> None:
        self._say(f"studying {self._title(part.name)}")
        results = self._results(part)
        self._running[part.name] = Process(self._study, part.name, results, self._heard)

    def _hear(self, name: str, message: Message) -> None:
        """Take one message of a worker."""
        if "tell" in message:
            self._tell(name, *message["tell"])
        elif "waiting" in message:
            self._wait(name)
        elif "done" in message:
            found = read(self._study.folder(name) / message["done"])
            self._end(name, found or _lost(name, "what it kept cannot be read"))
        elif "missing" in message:
            self._end(name, _absent(name, message["missing"]))
        elif "error" in message:
            self._end(name, StudyError(*message["error"]))
        else:
            del self._running[name]
            if name not in self._outcomes:
                self._end(name, _lost(name, f"its process ended with {message['ended']}"))

    def _end(self, name: str, outcome: Outcome) -> None:
        self._outcomes[name] = outcome
        if isinstance(outcome, Kept):
            self._say(f"studied {self._title(name)}, {outcome.seconds:.1f} s")
        elif isinstance(outcome, Absent):
            self._say(f"left out {self._title(name)}: {outcome.why}")
        elif len(self._parts) > 1:  # the error itself comes when the others have ended
            self._say(f"failed {self._title(name)}: {outcome.problem}")

    def _tell(self, name: str, fraction: float, words: str) -> None:
        more = f", {words}" if words else ""
        self._say(f"  {self._title(name)}: {fraction:.0%}{more}")

    def _wait(self, name: str) -> None:
        self._say(f"  {self._title(name)}: waiting for another run of it to finish")

    def _title(self, name: str) -> str:
        return self._study.system if name == ALONE else f"{self._study.system} {name}"


def _twice(outcomes: Iterable[Outcome]) -> str:
    """A name that results of two parts have; empty if there is none."""
    found = Counter(n for outcome in outcomes if isinstance(outcome, Kept) for n in outcome.results)
    return next((name for name, count in found.items() if count > 1), "")


def _lost(name: str, how: str) -> StudyError:
    return StudyError(
        f"the part {name!r} was lost: {how}",
        f"run `armillary study` with `--only {name}`, which runs it without another process",
    )
