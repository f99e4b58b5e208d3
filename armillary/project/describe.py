"""What `armillary list` and `armillary show` tell of a project."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from textwrap import indent

import sympy

from armillary.algebra.explicit import Explicit
from armillary.derivation.fingerprint import kernel_definitions
from armillary.derivation.load import load
from armillary.derivation.quantity import AnyQuantity
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Definition, Kernel, Output
from armillary.derivation.status import Status
from armillary.program.compile import compile_kernel
from armillary.project.checks import row
from armillary.project.config import Project
from armillary.project.errors import ProjectError
from armillary.project.work import signature_of
from armillary.verify.results import Standing, standing
from armillary.verify.results import read as read_checks


def show(project: Project, system: str, kernel: str | None, latex: bool) -> Iterator[str]:
    """The lines of `armillary show`.

    Raises:
        ProjectError: for a system or kernel that is not there.
        DerivationError: if the derivation cannot be read.
    """
    project.chosen((system,))
    derivation = load(project.derivations / system / "derivation.py")
    if kernel is not None and kernel not in derivation.kernels:
        raise ProjectError(
            f"{system} has no kernel {kernel!r}", f"it has {', '.join(derivation.kernels)}"
        )
    checks = standing(project.root, derivation, read_checks(project.root))
    yield f"{system}: {derivation.title}"
    yield f"  {_place(project, derivation.source.path, derivation.source.line)}"
    if kernel is None:
        yield from _quantities(derivation)
        yield from _definitions(project, derivation.definitions.values(), latex)
    chosen = [k for name, k in derivation.kernels.items() if kernel in (None, name)]
    for one in chosen:
        yield from _kernel(project, derivation, one, checks, latex, alone=kernel is not None)
    if kernel is None:
        yield from _checks("checks of the derivation", checks, None)


def _place(project: Project, path: str, line: int) -> str:
    place = Path(path).resolve()
    inside = project.root in place.parents
    return f"{place.relative_to(project.root) if inside else place}:{line}"


def _quantities(derivation: Derivation) -> Iterator[str]:
    if not derivation.quantities:
        return
    yield ""
    yield "quantities"
    for q in derivation.quantities.values():
        facts = q.facts
        kind = f"{facts.role.value}, {facts.rate.value}"
        yield f"  {_sized(q):<20} {facts.unit!s:<8} {kind:<16} {facts.meaning}"


def _definitions(project: Project, chosen: Iterable[Definition], latex: bool) -> Iterator[str]:
    yield ""
    yield "definitions"
    for definition in chosen:
        yield from _definition(project, definition, latex)


def _definition(project: Project, definition: Definition, latex: bool) -> Iterator[str]:
    printed = f"  paper ({definition.printed})" if definition.printed else ""
    unit = f" [{definition.unit}]" if definition.unit else ""
    place = _place(project, definition.source.path, definition.source.line)
    yield f"  {definition.identifier}{unit}{printed}  {place}"
    if definition.meaning:
        yield f"    {definition.meaning}"
    yield f"    because: {definition.because}"
    yield indent(_formula(definition, latex), "      ")


def _formula(definition: Definition, latex: bool) -> str:
    """The definition in terms of those before it."""
    explicit = Explicit(named=True)(definition.expression)
    if latex:
        return f"{definition.latex} = {sympy.latex(explicit)}"
    if isinstance(explicit, sympy.MatrixBase):
        rows = [", ".join(sympy.sstr(entry) for entry in row) for row in explicit.tolist()]
        return "\n".join([f"{definition.name} =", *(f"  [{row}]" for row in rows)])
    return f"{definition.name} = {sympy.sstr(explicit)}"


def _kernel(
    project: Project,
    derivation: Derivation,
    kernel: Kernel,
    checks: Standing,
    latex: bool,
    alone: bool,
) -> Iterator[str]:
    made = compile_kernel(kernel)
    yield ""
    yield f"kernel {kernel.name}  {_place(project, kernel.source.path, kernel.source.line)}"
    if kernel.summary:
        yield f"  {kernel.summary}"
    yield f"  {signature_of(project, kernel)};"
    yield f"  costs {made.cost}"
    others = f", {made.local} of them otherwise" if made.local else ""
    yield f"  evaluated with {made.strategy.form} vectors, carried by {made.strategy.carry}{others}"
    yield from _arguments(kernel, made.program.inputs_used())
    yield from _statuses(kernel)
    if alone:
        yield from _definitions(project, kernel_definitions(derivation, kernel).values(), latex)
    yield from _checks("  checks", checks, kernel.name)


def _arguments(kernel: Kernel, used: frozenset[str]) -> Iterator[str]:
    yield f"  takes {', '.join(_sized(q) for q in kernel.inputs) or 'no input'}"
    read = [_sized(q) for q in kernel.parameters if q.name in used]
    if read:
        yield f"  reads the parameters {', '.join(read)}"
    results = [_sized(o) for o in kernel.outputs]
    yield f"  returns {', '.join(results)}"


def _sized(named: AnyQuantity | Output) -> str:
    return named.name + "".join(f"[{n}]" for n in named.shape)


def _statuses(kernel: Kernel) -> Iterator[str]:
    yield f"  {Status.OK:>4} OK"
    for case in kernel.cases:
        yield f"  {case.status:>4} {case.status.name}: {case.because}"
    yield f"  {Status.NOT_FINITE:>4} NOT_FINITE, {Status.OUT_OF_RANGE} OUT_OF_RANGE: for inputs"


def _checks(title: str, checks: Standing, kernel: str | None) -> Iterator[str]:
    margin = " " * (len(title) - len(title.lstrip()))
    rows = [row for row in checks.rows if row["kernel"] == kernel]
    missing = "not checked since the last edit" if checks.outdated else "none yet"
    yield f"{title}:" if rows else f"{title}: {missing}; run `armillary check`"
    for check in rows:
        yield f"{margin}  {row(check)}"
