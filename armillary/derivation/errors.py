"""Errors of a derivation: they name the file, the line and the mend."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class Source:
    """Where a thing was written."""

    path: str
    line: int

    def __str__(self) -> str:
        return f"{self.path}:{self.line}"


class DerivationError(Exception):
    """A derivation was written wrongly."""

    def __init__(self, problem: str, mend: str, source: Source | None = None) -> None:
        self.problem, self.mend, self.source = problem, mend, source
        place = f"{source}: " if source else ""
        super().__init__(f"{place}{problem}\n  mend: {mend}")


def caller() -> Source:
    """The nearest line outside this package: the line of the derivation at work."""
    frame = sys._getframe(1)
    while frame.f_back is not None:
        path = Path(frame.f_code.co_filename)
        if _PACKAGE not in path.resolve().parents:
            break
        frame = frame.f_back
    return Source(frame.f_code.co_filename, frame.f_lineno)
