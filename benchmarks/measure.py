"""From generated code to a row: count it, and refuse it if its values are wrong."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

from benchmarks import reference
from benchmarks.count import run_source
from benchmarks.count.count import dearest
from benchmarks.peers import Generated
from benchmarks.recipes import Kernel
from benchmarks.table import Row

TOLERANCE = 1e-12


class WrongValuesError(RuntimeError):
    """Code that computes something else is not worth counting."""


def measure(
    kernel: Kernel,
    generated: Generated,
    *,
    tool: str,
    version: str,
    recipe: str,
    include_dirs: Sequence[Path] = (),
) -> Row:
    """Count one variant of a kernel after comparing its values with the reference."""
    points, expected = _asked(kernel.name)
    runs = run_source(generated.source, generated.call, points, kernel.n_out, include_dirs)
    for point, run, wanted in zip(points, runs, expected, strict=True):
        for place, (got, want) in enumerate(zip(run.values, wanted, strict=True)):
            if not abs(got - want) <= TOLERANCE * max(1.0, abs(want)):
                raise WrongValuesError(
                    f"{kernel.name} by {tool} ({generated.options}): output {place} is {got!r},"
                    f" must be {want!r}, at {point}"
                )
    return Row(kernel.name, tool, version, generated.options, recipe, dearest(runs))


@cache
def _asked(kernel: str) -> tuple[list[list[float]], list[list[float]]]:
    points = reference.points(kernel)
    return points, [reference.values(kernel, point) for point in points]
