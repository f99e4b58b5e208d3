"""What can go wrong with a site; told without a traceback."""

from __future__ import annotations


class SiteError(Exception):
    """Something the person at the keyboard can mend; `mend` says how."""

    def __init__(self, problem: str, mend: str) -> None:
        self.problem, self.mend = problem, mend
        super().__init__(f"{problem}\n  mend: {mend}")
