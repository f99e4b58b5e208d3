"""The kernels of a system as a page shows them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from armillary.derivation.fingerprint import kernel_definitions
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Kernel, Output
from armillary.derivation.status import MEANINGS, Status
from armillary.derivation.symbols import leaves
from armillary.site.facts import Facts
from armillary.site.notation import Notation
from armillary.site.steps import Link, definition_link, unit_text
from armillary.site.structure import Structure


@dataclass(frozen=True)
class Argument:
    """One input or result."""

    name: str
    about: str


@dataclass(frozen=True)
class Badge:
    """A number of operations."""

    kind: str
    count: int
    what: str


@dataclass(frozen=True)
class Answer:
    """One status that a kernel may answer."""

    number: int
    name: str
    about: str


@dataclass(frozen=True)
class Drawn:
    """What an input is at the points of checks; `by` is how far it may be off."""

    latex: str
    by: str


@dataclass(frozen=True)
class Stage:
    """A set-up or a step: its name, what it costs, and its prototypes."""

    name: str
    cost: str
    c_signatures: tuple[str, ...]


@dataclass(frozen=True)
class Card:
    """One kernel."""

    name: str
    identifier: str
    meaning: str
    c_signatures: tuple[str, ...]
    python_signature: str
    costs: tuple[Badge, ...]
    digest: str
    stages: tuple[Stage, ...]
    inputs: tuple[Argument, ...]
    parameters: tuple[str, ...]
    results: tuple[Argument, ...]
    answers: tuple[Answer, ...]
    stands_on: tuple[Link, ...]
    drawn: tuple[Drawn, ...]


def cards(derivation: Derivation, facts: Facts) -> list[Card]:
    """Every kernel of a system, in the order stated."""
    return [_card(derivation, kernel, facts) for kernel in derivation.kernels.values()]


def _card(derivation: Derivation, kernel: Kernel, facts: Facts) -> Card:
    printed = facts.printed(derivation, kernel)
    definitions = kernel_definitions(derivation, kernel).values()
    return Card(
        kernel.name,
        f"kernel-{derivation.name}-{kernel.name}",
        kernel.summary,
        tuple(printed.signatures.values()) if printed else (),
        _python_signature(kernel) if printed else "",
        _costs(printed.cost) if printed else (),
        printed.digest[:12] if printed else "",
        tuple(Stage(f"{kernel.name}_{name}", str(stage.cost), tuple(stage.signatures.values()))
              for name, stage in (printed.stages.items() if printed else ())),
        tuple(Argument(q.name, _about(q.facts.meaning, unit_text(q.unit), q.shape))
              for q in kernel.inputs),
        tuple(q.name for q in kernel.parameters if q.name in _read(kernel)),
        tuple(_result(output) for output in kernel.outputs),
        tuple(_answers(kernel)),
        tuple(definition_link(derivation, d) for d in definitions),
        tuple(_drawn(derivation, kernel)),
    )  # fmt: skip


def _drawn(derivation: Derivation, kernel: Kernel) -> Iterator[Drawn]:
    notation = Notation(derivation)
    written = Structure(notation)
    for one in kernel.drawn:
        latex = f"{notation.leaf(one.quantity)} = {written(one.output.value)}"
        unit = unit_text(one.quantity.unit)
        yield Drawn(latex, f"{one.by:g}{' ' + unit if unit else ''}" if one.by else "")


def _python_signature(kernel: Kernel) -> str:
    names = [q.name for q in (*kernel.inputs, *kernel.parameters)]
    given = f"*, {', '.join(names)}" if names else ""
    results = ", ".join([*(o.name for o in kernel.outputs), "status"])
    return f"{kernel.system}.{kernel.name}({given}) -> ({results})"


def _costs(cost: object) -> tuple[Badge, ...]:
    counts = {name: int(getattr(cost, name)) for name in ("flops", "divide", "sqrt")}
    trigonometry, inverse = (int(getattr(cost, n)) for n in ("trigonometry", "inverse"))
    badges = [Badge("flops", counts["flops"], "flops")]
    badges += [Badge("div", counts["divide"], "of them divisions")] if counts["divide"] else []
    badges += [Badge("sqrt", counts["sqrt"], "of them roots")] if counts["sqrt"] else []
    badges += [Badge("trig", trigonometry, "sin or cos")] if trigonometry else []
    badges += [Badge("trig", inverse, "atan2")] if inverse else []
    return tuple(badges)


def _about(meaning: str, unit: str, shape: tuple[int, ...]) -> str:
    size = f" [{'×'.join(map(str, shape))}]" if shape else ""
    return f"{size} {meaning}{', ' + unit if unit else ''}".strip()


def _result(output: Output) -> Argument:
    definition = output.definition
    meaning = (definition.meaning if definition else "") or "as the page derives it"
    return Argument(output.name, _about(meaning, unit_text(output.unit), output.shape))


def _read(kernel: Kernel) -> set[str]:
    """Names of all quantities that the results and the statuses stand on."""
    found: set[str] = set()
    for block in (*(o.value for o in kernel.outputs), *(c.condition for c in kernel.cases)):
        found |= {leaf.name for leaf in leaves(block)}
    return found


def _answers(kernel: Kernel) -> list[Answer]:
    """What a kernel may answer; the guards answer for every input."""
    found = [Answer(0, "OK", MEANINGS[Status.OK])]
    found += [Answer(int(c.status), c.status.name, c.because) for c in kernel.cases]
    if kernel.inputs or kernel.parameters:
        for status in (Status.NOT_FINITE, Status.OUT_OF_RANGE):
            found.append(Answer(int(status), status.name, MEANINGS[status]))
    return found
