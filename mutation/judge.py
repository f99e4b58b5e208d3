"""Whether the checks of a system see one mutant.

They are those of `armillary check`, from the identities to the independent engines. That the text
of the generated files changes counts for nothing: every mutant changes it.
"""

from __future__ import annotations

import shutil
import signal
import tempfile
import warnings
from collections.abc import Iterator
from copy import copy
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from armillary.derivation.fingerprint import blocks_digest, definition_digest, kernel_digest
from armillary.derivation.load import load
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Definition, Identity
from armillary.program.arithmetic import Reals
from armillary.program.cost import cost
from armillary.program.lower import Strategy, lower
from armillary.program.program import Program
from armillary.program.scalarise import scalarise
from armillary.targets.python import PythonKernel, module_file
from armillary.verify import duals, exact, runner
from armillary.verify.implementations import forget
from armillary.verify.measured import Measured, Skipped
from armillary.verify.points import awkward_points, joined, random_points, rows_of

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = "armillary_kernels"
SECONDS = 300
# Points at which a definition is compared: a change may show at one place in twenty.
POINTS = 200
AGREEMENT = 1e-30

KILLED, SURVIVED, EQUIVALENT, UNCHANGED = "killed", "survived", "equivalent", "unchanged"
REFUSED = "refused"  # by: the derivation could not be read or compiled


@dataclass(frozen=True)
class Judgement:
    """What became of a mutant.

    Attributes:
        state: "killed", "survived", "equivalent" (no value of any definition or kernel differs)
            or "unchanged" (only the text of a check did).
        by: the check that failed.
    """

    state: str
    by: str = ""


def judge(system: str, file: str, source: str) -> Judgement:
    """Run the checks of a system with one file of it replaced, up to the first that fails."""
    signal.signal(signal.SIGALRM, _too_long)
    signal.alarm(SECONDS)
    folder = Path(tempfile.mkdtemp(prefix="mutant-"))
    try:
        # An engine that stumbles over a mutant may warn; only its verdict is wanted.
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return _judged(folder, system, file, source)
    except TimeoutError:
        return Judgement(KILLED, f"no answer within {SECONDS} s")
    finally:
        signal.alarm(0)
        shutil.rmtree(folder, ignore_errors=True)


def _too_long(*_: object) -> None:
    raise TimeoutError


def failing(system: str) -> tuple[str, str]:
    """A system, and the first of its checks that fails with no change made; empty for none.

    A check that always fails would kill every mutant.
    """
    folder = Path(tempfile.mkdtemp(prefix="mutant-"))
    try:
        root = _copied(folder)
        record = load(root / "derivations" / system / "derivation.py")
        return system, _first_failure(root, record, _programs(root, record))
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _judged(folder: Path, system: str, file: str, source: str) -> Judgement:
    root = _copied(folder)
    original = load(root / "derivations" / system / "derivation.py")
    (root / "derivations" / system / file).write_text(source)
    try:
        record = load(root / "derivations" / system / "derivation.py")
        if _digests(record) == _digests(original):
            return Judgement(UNCHANGED)
        programs = _programs(root, record)
    except TimeoutError:
        raise
    except Exception as problem:  # a derivation that is refused is seen
        return Judgement(KILLED, f"{REFUSED}: {type(problem).__name__}")
    failed = _first_failure(root, _touched(original, record), programs)
    if failed:
        return Judgement(KILLED, failed)
    same = _same_values(original, record)
    return Judgement(EQUIVALENT if same else SURVIVED)


def _touched(original: Derivation, record: Derivation) -> Derivation:
    """What of a mutant a check could judge otherwise than before: the rest is proved already."""
    kept = copy(record)
    before = [_identity(original, i) for i in original.identities]
    kept.identities = [i for i in record.identities if _identity(record, i) not in before]
    kept.definitions = {
        name: d
        for name, d in record.definitions.items()
        if _whole(original, original.definitions.get(name)) != _whole(record, d)
    }
    same = all(
        kernel_digest(original, original.kernels[name]) == kernel_digest(record, kernel)
        for name, kernel in record.kernels.items()
    )
    if same:
        kept.kernels = {}
    return kept


def _identity(record: Derivation, identity: Identity) -> tuple[str, str]:
    return identity.claim, blocks_digest(record, identity.left, identity.right)


def _whole(record: Derivation, definition: Definition | None) -> str:
    return "" if definition is None else blocks_digest(record, definition.value)


def _copied(folder: Path) -> Path:
    """A project of its own with the derivations and the Python kernels."""
    root = folder / "project"
    shutil.copytree(ROOT / "derivations", root / "derivations")
    shutil.copytree(ROOT / "generated" / "python", root / "generated" / "python")
    return root


def _programs(root: Path, record: Derivation) -> dict[str, Program]:
    """The programs of a system, with its Python kernels written."""
    programs = {name: lower(k, Strategy()) for name, k in record.kernels.items()}
    _write_kernels(root, record, programs)
    return programs


def _first_failure(root: Path, record: Derivation, programs: dict[str, Program]) -> str:
    """The first check that fails; empty when all pass."""
    for found in _checks(root, record, programs):
        if isinstance(found, Measured) and not found.passed:
            return f"{found.name} [{found.engine}]"
    return ""


def _digests(record: Derivation) -> dict[str, str]:
    made = {name: definition_digest(d) for name, d in record.definitions.items()}
    return made | {f"{n}()": kernel_digest(record, k) for n, k in record.kernels.items()}


def _write_kernels(root: Path, record: Derivation, programs: dict[str, Program]) -> None:
    """The Python kernels, without the search for the cheapest program: the values are the same."""
    opened = [scalarise(p) for p in programs.values()]
    kernels = [PythonKernel(p, cost(p)) for p in opened]
    path = root / "generated" / "python" / PACKAGE / f"{record.name}.py"
    path.write_text(module_file(record.name, record.title, kernels, "0"))


def _checks(
    root: Path, record: Derivation, programs: dict[str, Program]
) -> Iterator[Measured | Skipped]:
    """The checks of `armillary check`, without those that hold of any derivation."""
    forget(PACKAGE)
    if not record.kernels:  # none has changed: a proof is the likeliest to see what has
        yield from runner.proofs(record)
    yield from runner.simulation(root, PACKAGE, record)
    if record.kernels:
        yield from duals.checks(record, programs)
        yield from runner.proofs(record)


def _same_values(first: Derivation, second: Derivation) -> bool:
    """Whether no definition and no kernel differs anywhere that was tried, to 30 digits."""
    if first.definitions.keys() != second.definitions.keys():
        return False
    return all(_same_kernel(first, second, name) for name in first.kernels) and all(
        _same_definition(first, second, name) for name in first.definitions
    )


def _same_kernel(first: Derivation, second: Derivation, name: str) -> bool:
    a, b = first.kernels[name], second.kernels[name]
    programs = lower(a, Strategy()), lower(b, Strategy())
    points = joined(random_points(a, 30, seed=11), awkward_points(a))
    reals = Reals()
    for row in rows_of(points):
        one, two = (_run(program, row, reals) for program in programs)
        if (one is None) != (two is None):
            return False
        if one is None or two is None:
            continue
        if one.status != two.status:
            return False
        for key, value in one.results.items():
            error = exact.worst(exact.flat(two.results[key]), exact.flat(value))
            if not error <= AGREEMENT:
                return False
    return True


def _run(program: Program, row: dict[str, Any], reals: Reals) -> Any:
    try:
        return exact.run(program, row, reals)
    except (ArithmeticError, TypeError, ValueError):
        return None


def _same_definition(first: Derivation, second: Derivation, name: str) -> bool:
    a, b = first.definitions[name], second.definitions[name]
    if definition_digest(a) == definition_digest(b):
        return True
    try:
        books = exact.text_book(a.expression), exact.text_book(b.expression)
        needed = {q.name: q for book in books for q in book.quantities}
        for row in rows_of(random_points(list(needed.values()), POINTS, seed=12)):
            if not exact.worst(books[1](row), books[0](row)) <= AGREEMENT:
                return False
    except (TypeError, KeyError, ArithmeticError):
        return False
    return True
