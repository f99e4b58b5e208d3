"""`armillary check`: runs the checks and tells what each found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from armillary.project.config import Project
from armillary.project.generate import Say
from armillary.verify import runner

HEADER = f"{'state':<7} {'engine':<20} {'points':>7} {'worst':>8} {'allowed':>8}  claim"


def check(project: Project, names: tuple[str, ...], update: bool, say: Say) -> bool:
    """Run the checks of some systems, or of all; tells whether none failed.

    Args:
        update: measure every target anew and write the tolerances that are committed.
    """
    systems = project.chosen(names)
    run = runner.update_tolerances if update else runner.run
    outcomes, system = [], ""
    for outcome in run(project.root, project.kernels, systems):
        if outcome.system != system:
            system = outcome.system
            say(system)
            say(f"  {HEADER}")
        outcomes.append(outcome)
        say(f"  {row(asdict(outcome))}")
        if outcome.failed or outcome.skipped:
            say(f"{'':10}{_more(outcome)}")
    if not update:
        runner.write(project.root, outcomes)
    failed = sum(o.failed for o in outcomes)
    skipped = sum(o.skipped for o in outcomes)
    say(f"{len(outcomes) - failed - skipped} passed, {failed} failed, {skipped} skipped")
    return not failed


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


def _more(outcome: runner.Outcome) -> str:
    """Why a check failed or was skipped, and at which inputs."""
    at = ", ".join(f"{name} = {value}" for name, value in outcome.at.items())
    return "; ".join(part for part in (outcome.why, f"at {at}" if at else "") if part)
