"""Runs every check of a project, one result at a time.

for outcome in run(root, package="armillary_kernels"):
    print(outcome)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TypeGuard

from armillary.derivation import beside
from armillary.derivation.folders import names
from armillary.derivation.load import load_all
from armillary.derivation.record import Derivation
from armillary.program.compile import compile_kernel
from armillary.program.program import Program
from armillary.store.lock import locked
from armillary.verify import duals, identities, parity, tolerances
from armillary.verify.engines import EngineMissing
from armillary.verify.implementations import (
    Implementation,
    forget,
    generated_module,
    native_implementations,
    python_implementations,
)
from armillary.verify.measured import Measured, Skipped
from armillary.verify.results import Outcome, checked_digest
from armillary.verify.stages import stages_implementations

_LOCK = Path("build") / "tolerances.lock"


def run(
    root: Path,
    package: str,
    systems: Sequence[str] | None = None,
    *,
    points: int = parity.POINTS,
) -> Iterator[Outcome]:
    """Every check of some systems (all by default), in the order of trust.

    Identities, text-book forms and dual numbers need only the derivation; the simulations and the
    parity of targets run the generated files below `<root>/generated`.

    Raises:
        DerivationError: if a derivation or its tolerances cannot be read.
    """
    forget(package)
    records = load_all(root / "derivations")
    chosen = list(systems) if systems is not None else names(root / "derivations")
    digests: dict[str, str] = {}
    for system in chosen:  # before any check runs: an edit made meanwhile counts as new
        tolerances.read(root / "derivations" / system)
        digests[system] = checked_digest(root, records[system])
    for system in chosen:
        for measured in _of_system(root, package, records[system], points):
            yield _outcome(system, digests[system], measured)


def update_tolerances(
    root: Path, package: str, systems: Sequence[str] | None = None
) -> Iterator[Outcome]:
    """Measure every target anew and commit what was found to `tolerances.json`.

    A target that is not available here keeps its old tolerance; one whose statuses are wrong, or
    that returns no number, gets none.
    """
    forget(package)
    records = load_all(root / "derivations")
    for system in systems if systems is not None else names(root / "derivations"):
        folder = root / "derivations" / system
        measured: list[tuple[str, str, float]] = []
        for found, implementation in _parity(root, package, records[system], parity.POINTS):
            if implementation is not None and _is_number(found):
                tolerance = tolerances.rounded_up(found.worst, implementation.epsilon)
                measured.append((str(found.kernel), implementation.key, tolerance))
                found = replace(found, tolerance=tolerance, why="")
            yield _outcome(system, "", found)
        kernels = records[system].kernels
        with locked(root / _LOCK, lambda: None):  # held for a moment only
            known = tolerances.read(folder)
            kept = {kernel: targets for kernel, targets in known.items() if kernel in kernels}
            tolerances.write(folder, tolerances.merged(kept, measured))


# -- one system -----------------------------------------------------------------------------------


Found = Measured | Skipped


def _is_number(found: Found) -> TypeGuard[Measured]:
    """Whether a target's values were measured, and there is something to commit."""
    if isinstance(found, Skipped) or found.name != parity.VALUES:
        return False
    return math.isfinite(found.worst)


def _of_system(root: Path, package: str, record: Derivation, points: int) -> Iterator[Found]:
    programs = {name: compile_kernel(k).program for name, k in record.kernels.items()}
    yield from proofs(record)
    for name, kernel in record.kernels.items():
        yield from identities.text_book_expression(kernel, programs[name])
    yield from duals.checks(record, programs)
    yield from simulation(root, package, record)
    for found, _ in _parity(root, package, record, points, programs):
        yield found


def proofs(record: Derivation) -> Iterator[Measured]:
    """What an author claims, and that every rotation is one."""
    for identity in record.identities:
        try:
            yield identities.prove(identity)
        except identities.NotComparableError as problem:
            nan = float("nan")
            yield Measured(identity.claim, "SymPy", None, 0, nan, 0.0, {}, str(problem))
    for definition in record.definitions.values():
        proof = identities.text_book_rotation(definition)
        if proof is not None:
            yield proof


def simulation(root: Path, package: str, record: Derivation) -> Iterator[Found]:
    """The checks of `simulation.py`, as far as its engines are installed."""
    path = root / "derivations" / record.name / "simulation.py"
    if not path.is_file():
        return
    try:
        module = beside.run(path).module
        kernels = generated_module(root / "generated" / "python", package, record.name)
        yield from module.checks(kernels)
    except EngineMissing as missing:
        yield Skipped("simulation", missing.engine, str(missing))
    except Exception as problem:  # a simulation is the author's code: report it, go on
        text = f"{type(problem).__name__}: {problem}"
        yield Measured("simulation", "simulation.py", None, 0, float("nan"), 0.0, {}, text)


def _parity(
    root: Path,
    package: str,
    record: Derivation,
    points: int,
    programs: dict[str, Program] | None = None,
) -> Iterator[tuple[Found, Implementation | None]]:
    if not record.kernels:
        return
    if programs is None:
        programs = {name: compile_kernel(k).program for name, k in record.kernels.items()}
    references = {name: parity.Reference(p, points) for name, p in programs.items()}
    known = tolerances.read(root / "derivations" / record.name)
    for name, make in _targets(root, package, record.name):
        try:
            implementation = make()
        except EngineMissing as missing:
            yield Skipped(parity.VALUES, name, str(missing)), None
            continue
        except Exception as problem:
            text = f"{type(problem).__name__}: {problem}"
            yield Measured(parity.VALUES, name, None, 0, float("nan"), 0.0, {}, text), None
            continue
        for reference in references.values():
            if not implementation.has(reference.program.kernel.name):
                continue
            for found in _on_target(reference, implementation, known):
                yield found, implementation


def _on_target(
    reference: parity.Reference, implementation: Implementation, known: tolerances.Tolerances
) -> Iterator[Measured]:
    tolerance = parity.tolerance_of(known, reference.program.kernel.name, implementation)
    why = ""
    if tolerance is None:
        tolerance = tolerances.DEFAULT_ROUNDINGS * implementation.epsilon
        why = (
            f"no tolerance is committed; held to {tolerances.DEFAULT_ROUNDINGS} roundings; if this "
            "is rounding, commit one with --update-tolerances"
        )
    yield from parity.compare_target(reference, implementation, tolerance, why)


def _targets(
    root: Path, package: str, system: str
) -> list[tuple[str, Callable[[], Implementation]]]:
    folder = root / "generated" / "python"
    try:
        module = generated_module(folder, package, system)
    except ModuleNotFoundError as problem:
        missing = problem  # named apart, because `problem` ends with this clause

        def absent() -> Implementation:
            raise missing

        return [("numpy f64", absent)]
    compiled = native_implementations(folder, package, system)
    stages = stages_implementations(folder, package, system)
    return [*python_implementations(module), *compiled, *stages]


# -- results --------------------------------------------------------------------------------------


def _outcome(system: str, digest: str, found: Found) -> Outcome:
    if isinstance(found, Skipped):
        return Outcome(
            system, digest, None, found.name, found.engine, 0, None, 0.0, False, True, found.why
        )
    worst = found.worst if math.isfinite(found.worst) else None
    return Outcome(
        system, digest, found.kernel, found.name, found.engine, found.points, worst,
        found.tolerance, found.passed, False, found.why, found.at,
    )  # fmt: skip
