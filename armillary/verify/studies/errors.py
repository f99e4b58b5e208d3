"""What can go wrong with a study; told with the line of the author's file."""

from __future__ import annotations

import traceback
from pathlib import Path


class StudyError(Exception):
    """Something that the author of a study can mend; `mend` says how."""

    def __init__(self, problem: str, mend: str) -> None:
        self.problem, self.mend = problem, mend
        super().__init__(f"{problem}\n  mend: {mend}")


def told(path: Path, problem: Exception) -> StudyError:
    """A problem with the innermost line of the study's folder that it went through."""
    if isinstance(problem, StudyError):
        return problem
    frames = traceback.extract_tb(problem.__traceback__)
    lines = [f for f in frames if Path(f.filename).parent == path.resolve().parent]
    place = f"{lines[-1].filename}:{lines[-1].lineno}" if lines else str(path)
    mend = getattr(problem, "mend", "")
    if mend:  # one of our own, such as a plot that cannot be drawn
        return StudyError(f"{place}: {getattr(problem, 'problem', problem)}", mend)
    text = f"{place}: {type(problem).__name__}: {problem}"
    return StudyError(text, "mend this line of the study")
