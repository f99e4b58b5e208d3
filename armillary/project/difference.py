"""`generate --check`: makes everything anew in memory and compares it with what is on disk."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping
from pathlib import Path

from armillary.project.config import Project
from armillary.project.generate import LOCK, Progress, Say
from armillary.store.lock import locked_for_reading
from armillary.store.transaction import in_flight
from armillary.targets.manifest import strangers

# Lines of one file's difference that are shown; the rest is counted.
SHOWN = 200


def differences(project: Project, names: tuple[str, ...], say: Say) -> int:
    """Compare; print a unified diff for every file that is not as it should be.

    Nothing on disk is trusted and nothing is written.

    Args:
        names: compare the files of these systems only; all files, and strangers, when empty.

    Returns:
        How many files are not as they should be.
    """
    from armillary.project import work

    project.chosen(names)
    with locked_for_reading(
        project.generated / LOCK, lambda: say("waiting for another run to finish")
    ):
        texts, manifest = work.make_everything(project, Progress(say))
        if names:
            texts = {n: texts[n] for name in names for n in manifest.systems[name].files}
        wrong = sum(_compare(project.generated, name, texts[name], say) for name in sorted(texts))
        if not names:
            wrong += _extra(project.generated, texts, say)
        if in_flight(project.generated):
            say("an interrupted run left its work half done; `armillary generate` finishes it")
            wrong += 1
    return wrong


def _compare(folder: Path, name: str, wanted: str, say: Say) -> bool:
    path = folder / name
    found = path.read_bytes().decode("utf-8", "replace") if path.is_file() else None
    if found == wanted:
        return False
    say(f"missing: generated/{name}" if found is None else f"changed: generated/{name}")
    for line in _diff(name, found or "", wanted, missing=found is None):
        say(line)
    return True


def _extra(folder: Path, known: Mapping[str, object], say: Say) -> int:
    found = strangers(folder, known)
    for name in found:
        say(f"extra: generated/{name}")
    return len(found)


def _diff(name: str, found: str, wanted: str, missing: bool) -> Iterator[str]:
    """A unified diff from what is there to what should be there."""
    lines = list(
        difflib.unified_diff(
            _lines(found),
            _lines(wanted),
            "/dev/null" if missing else f"generated/{name}",
            f"generated/{name} (from the derivations)",
            lineterm="",
        )
    )
    yield from lines[:SHOWN]
    if len(lines) > SHOWN:
        yield f"... and {len(lines) - SHOWN} more lines"


def _lines(text: str) -> list[str]:
    """Lines without their ends; a missing last end and a carriage return show up."""
    lines = text.split("\n")
    if lines[-1]:
        return [*lines[:-1], lines[-1] + "\\ no newline at end of file"]
    return [line.replace("\r", "\\r") for line in lines[:-1]]
