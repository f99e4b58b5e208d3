"""`armillary check`: runs the checks and tells what each found."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict
from itertools import groupby
from typing import Any

from armillary.project.config import Project
from armillary.project.generate import Say
from armillary.verify import runner
from armillary.verify.results import Outcome, write

HEADER = f"{'state':<7} {'engine':<20} {'points':>7} {'worst':>8} {'allowed':>8}  claim"


def check(
    project: Project, names: tuple[str, ...], update: bool, say: Say, verbose: bool = False
) -> bool:
    """Run the checks of some systems, or of all; tells whether none failed.

    Args:
        update: measure every target anew and write the tolerances that are committed.
        verbose: a row for every check, not only for what fails or is skipped.
    """
    systems = project.chosen(names)
    run = runner.update_tolerances if update else runner.run
    outcomes: list[Outcome] = []
    for system, group in groupby(
        run(project.root, project.kernels, systems), key=lambda outcome: outcome.system
    ):
        say(system)
        if verbose:
            say(f"  {HEADER}")
        done = list(_told(group, say, verbose))
        if not verbose:
            for line in summary(done):
                say(f"  {line}")
        outcomes += done
    if not update:
        write(project.root, outcomes)
    failed = sum(o.failed for o in outcomes)
    skipped = sum(o.skipped for o in outcomes)
    say(f"{len(outcomes) - failed - skipped} passed, {failed} failed, {skipped} skipped")
    return not failed


def _told(group: Iterable[Outcome], say: Say, verbose: bool) -> Iterator[Outcome]:
    """Pass outcomes on as they come, telling those that are worth a row."""
    for outcome in group:
        bad = outcome.failed or outcome.skipped
        if verbose or bad:
            say(f"  {row(asdict(outcome))}")
        if bad:
            say(f"{'':10}{_more(outcome)}")
        yield outcome


def summary(outcomes: list[Outcome]) -> list[str]:
    """A line for each engine, in the order met: checks, points, share of what is allowed."""
    lines = []
    for engine in dict.fromkeys(o.engine for o in outcomes if o.passed):
        mine = [o for o in outcomes if o.engine == engine and o.passed]
        points = sum(o.points for o in mine)
        if not points:
            lines.append(f"{engine:<22} {len(mine):>3} ok, for all values")
            continue
        shares = [o.worst / o.tolerance for o in mine if o.worst and o.tolerance]
        used = f"worst at {max(shares):.0%} of what is allowed" if shares else "exactly equal"
        lines.append(f"{engine:<22} {len(mine):>3} ok, {points:>6} points, {used}")
    return lines


def row(check: Mapping[str, Any]) -> str:
    """One row of a table of checks, below `HEADER`."""
    state = "skipped" if check["skipped"] else "ok" if check["passed"] else "FAILED"
    worst, allowed = _figure(check["worst"]), _figure(check["tolerance"])
    kernel = f"{check['kernel']}: " if check["kernel"] else ""
    return (
        f"{state:<7} {check['engine']:<20} {check['points']:>7} {worst:>8} "
        f"{allowed:>8}  {kernel}{check['name']}"
    )


def _figure(value: float | None) -> str:
    return "-" if value is None else f"{value:.1e}" if value else "0"


def _more(outcome: Outcome) -> str:
    """Why a check failed or was skipped, and at which inputs."""
    at = ", ".join(f"{name} = {value}" for name, value in outcome.at.items())
    return "; ".join(part for part in (outcome.why, f"at {at}" if at else "") if part)
