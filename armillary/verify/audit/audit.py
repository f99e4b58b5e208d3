"""Every print of a paper compared with what is derived."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from armillary.derivation.paper import (
    Equation,
    Needed,
    Negligible,
    Paper,
    Printed,
    Spans,
    Unchecked,
    Word,
)
from armillary.derivation.printed_units import InUnit
from armillary.derivation.ranges import Between, Extremes, Hanging, LeastMoved
from armillary.verify.audit import ranges, sentences, unprinted, words
from armillary.verify.audit.claims import claimed
from armillary.verify.audit.nomenclature import in_unit
from armillary.verify.audit.reading import read
from armillary.verify.audit.verdict import Finding, Verdict


def audit(paper: Paper, latex: Callable[[Any], str] | None = None) -> tuple[Finding, ...]:
    """The findings on all prints of a paper, in the order printed.

    Args:
        latex: prints a repaired entry; without it repairs have words only.
    """
    return tuple(finding(paper, printed, latex) for printed in paper.printed.values())


def finding(paper: Paper, printed: Printed, latex: Callable[[Any], str] | None = None) -> Finding:
    """The finding on one print."""
    if isinstance(printed, Equation):
        return _equation(paper, printed, latex)
    if isinstance(printed, Word):
        return sentences.word(paper, printed)
    if isinstance(printed, Negligible):
        return sentences.negligible(paper, printed)
    if isinstance(printed, Needed):
        return sentences.needed(paper, printed)
    if isinstance(printed, Between):
        return ranges.between(paper, printed)
    if isinstance(printed, Extremes):
        return ranges.extremes(paper, printed)
    if isinstance(printed, Hanging):
        return unprinted.hanging(paper, printed)
    if isinstance(printed, LeastMoved):
        return ranges.least_moved(paper, printed)
    if isinstance(printed, Spans):
        return sentences.spans(paper, printed)
    if isinstance(printed, InUnit):
        return in_unit(paper, printed)
    assert isinstance(printed, Unchecked)
    return Finding(
        paper.name, printed.key, Verdict.NOT_CHECKABLE, None, printed.words, "", printed.reason
    )


def _equation(paper: Paper, equation: Equation, latex: Callable[[Any], str] | None) -> Finding:
    reads = tuple(
        read(equation, reading.name, reading.printed, paper, latex) for reading in equation.readings
    )
    verdicts = {(r.verdict, r.order if r.verdict is Verdict.ORDER else None) for r in reads}
    one = len(verdicts) == 1
    unit = words.unit_of(equation.claims)
    small = [q.name for q in equation.small]
    says = (
        words.reading(reads[0], small, unit) if len(reads) == 1
        else words.several(reads, small, unit)
    )  # fmt: skip
    definition = claimed(equation.claims, paper)
    return Finding(
        paper=paper.name,
        key=equation.key,
        verdict=reads[0].verdict if one else Verdict.AMBIGUOUS,
        order=min((r.order for r in reads if r.order is not None), default=None) if one else None,
        words=equation.words,
        quote=equation.quote,
        says=says,
        claims=(definition.identifier,) if definition is not None else (),
        readings=reads,
        unit=unit,
    )
