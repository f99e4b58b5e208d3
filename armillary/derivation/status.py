"""Statuses of a kernel. The numbers are part of the ABI and never change."""

from __future__ import annotations

from enum import IntEnum


class Status(IntEnum):
    """Positive: every output is defined and finite. Negative: outputs are untouched."""

    OK = 0
    CLAMPED = 1
    SINGULAR = 2
    STICKING = 3
    BELOW_HORIZON = 4
    LIMIT = 5
    NOT_FINITE = -1
    OUT_OF_RANGE = -2
    UNREACHABLE = -3
    NOT_CONVERGED = -4


MEANINGS = {
    Status.OK: "every output is as accurate as the rounding of the inputs allows",
    Status.CLAMPED: "the nearest reachable answer was returned",
    Status.SINGULAR: "an angle is free here, or nearly, and was set to 0: "
    "hold that axis where it is",
    Status.STICKING: "friction holds the mechanism at rest",
    Status.BELOW_HORIZON: "the sun does not rise",
    Status.LIMIT: "a limit of stroke was met",
    Status.NOT_FINITE: "an input is NaN or infinite; outputs were not written",
    Status.OUT_OF_RANGE: "an input lies beyond its limits or has no physical meaning, or the "
    "context of a step is not ready; outputs were not written",
    Status.UNREACHABLE: "no pose of the mechanism answers; outputs were not written",
    Status.NOT_CONVERGED: "the iteration did not converge; outputs were not written",
}


def worse(first: int, second: int) -> int:
    """Of two statuses the one to report: the most negative wins, else the largest."""
    low = min(first, second)
    return low if low < 0 else max(first, second)
