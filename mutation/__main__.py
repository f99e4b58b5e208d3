"""Change derivations in small ways and count how many of the changes the checks see."""

from __future__ import annotations

import argparse
import multiprocessing
import os
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from armillary.derivation.beside import files_of
from mutation.judge import ROOT, Judgement, failing, judge
from mutation.operators import Mutant, mutants
from mutation.table import Row, lost, share, write

LEAST = 0.95  # share of the changes that the checks must see


@dataclass(frozen=True)
class Task:
    """One mutant of one file of a system."""

    system: str
    file: str
    mutant: Mutant


def main(arguments: Sequence[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m mutation", description=__doc__)
    parser.add_argument("systems", nargs="*", help="systems to change; all unless given")
    parser.add_argument(
        "--check",
        action="store_true",
        help="write nothing; fail if a survivor has no reason in survivors.toml",
    )
    parser.add_argument(
        "--most",
        type=int,
        metavar="N",
        help="judge no more than N changes of a system, evenly spread; nothing is written",
    )
    options = parser.parse_args(arguments)
    tasks = list(all_tasks(options.systems or systems()))
    rows = list(judged(tasks if options.most is None else thinned(tasks, options.most)))
    if not options.check and options.most is None:
        write(rows)
    unexplained = lost(rows)
    for row in unexplained:
        print(f"survived: {row.place}: {row.before} -> {row.after} ({row.kind})")
    killed, counted = share(rows)
    print(f"{killed} of {counted} killed; survivors without a reason: {len(unexplained)}")
    too_few = not options.systems and killed < LEAST * counted
    return 1 if unexplained or too_few else 0


def systems() -> list[str]:
    """Every system that has a simulation to check it."""
    found = (ROOT / "derivations").glob("*/simulation.py")
    return sorted(p.parent.name for p in found)


def all_tasks(chosen: Sequence[str]) -> Iterator[Task]:
    """Every mutant of some systems."""
    for system in chosen:
        for path in sorted(files_of(ROOT / "derivations" / system / "derivation.py")):
            for mutant in mutants(path.read_text()):
                yield Task(system, path.name, mutant)


def thinned(tasks: Sequence[Task], most: int) -> list[Task]:
    """At most so many mutants of each system, evenly spread over its files."""
    kept: list[Task] = []
    for system in dict.fromkeys(task.system for task in tasks):
        own = [task for task in tasks if task.system == system]
        count = min(most, len(own))
        kept += [own[k * len(own) // count] for k in range(count)]
    return kept


def judged(tasks: Sequence[Task]) -> Iterator[Row]:
    """The mutants with what became of them, each in a process of its own.

    Raises:
        SystemExit: if a system fails its checks as it stands.
    """
    _load_engines()
    context = multiprocessing.get_context("fork")
    with context.Pool(os.cpu_count() or 1, maxtasksperchild=1) as pool:
        for system, check in pool.imap(failing, sorted({task.system for task in tasks})):
            if check:
                sys.exit(f"{system} fails its own checks, every change of it would: {check}")
        for done, (task, found) in enumerate(pool.imap(_judge, tasks, chunksize=1), 1):
            m = task.mutant
            if done % 20 == 0 or done == len(tasks):
                print(f"{done} of {len(tasks)}", flush=True)
            yield Row(
                task.system, task.file, m.line, m.kind, _short(m.before), _short(m.after),
                found.state, found.by,
            )  # fmt: skip


def _judge(task: Task) -> tuple[Task, Judgement]:
    return task, judge(task.system, task.file, task.mutant.source)


def _load_engines() -> None:
    """Import once what every mutant needs: a fork then has it."""
    import erfa  # noqa: F401
    import pinocchio  # noqa: F401
    import pvlib  # noqa: F401
    import scipy.optimize
    import scipy.spatial.transform  # noqa: F401


def _short(text: str) -> str:
    """The end of a long chain tells more than its beginning."""
    return text if len(text) <= 100 else "..." + text[-97:]


if __name__ == "__main__":
    sys.exit(main())
