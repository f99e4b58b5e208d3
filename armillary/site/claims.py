"""What prints state, as formulas: their entries, and the sentences of the text."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import singledispatch

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix
from armillary.derivation.paper import Needed, Negligible, Spans, Word
from armillary.derivation.printed_units import InUnit, written
from armillary.derivation.quantity import Quantity
from armillary.derivation.ranges import Between, Extremes, Hanging, LeastMoved
from armillary.derivation.statements import Block
from armillary.derivation.symbols import leaves
from armillary.site.notation import quantity_latex
from armillary.site.structure import Structure


def entries_of(block: Block) -> list[list[s.Scalar]] | None:
    """The entries of a print that shows each of them; None where it is written as a whole."""
    if isinstance(block, Matrix):
        return [list(row) for row in block.rows]
    if isinstance(block, v.Components):
        return [[component] for component in block.components]
    return None


@singledispatch
def claim_latex(printed: object, structure: Structure) -> Iterator[str]:
    """What a sentence states, as formulas; none where words say it all."""
    yield from ()


@claim_latex.register
def _(printed: Word, structure: Structure) -> Iterator[str]:
    for name, matrix in printed.of:
        left = rf"\text{{{name}}} = " if re.fullmatch(r"[\w ()'.,-]+", name) else f"{name} = "
        yield left + structure(matrix)


@claim_latex.register
def _(printed: Negligible, structure: Structure) -> Iterator[str]:
    small = quantity_latex(printed.small)
    beside = r",\; ".join(map(quantity_latex, printed.beside))
    yield rf"{structure(printed.of)}\Big|_{{{small} = 0}} \approx {structure(printed.of)}" + (
        rf"\quad\text{{while }} {beside} \text{{ must be kept}}" if beside else ""
    )


@claim_latex.register
def _(printed: Needed, structure: Structure) -> Iterator[str]:
    for small in map(quantity_latex, printed.small):
        of = structure(printed.of)
        yield rf"{of}\Big|_{{{small} = 0}} \not\approx {of}"


@claim_latex.register
def _(printed: Between, structure: Structure) -> Iterator[str]:
    low = "" if printed.low is None else rf"{structure(printed.low)} \le "
    high = "" if printed.high is None else rf" \le {structure(printed.high)}"
    yield f"{low}{structure(printed.value)}{high}"


@claim_latex.register
def _(printed: Extremes, structure: Structure) -> Iterator[str]:
    value = structure(printed.value)
    for word, stated in ((r"\min", printed.least), (r"\max", printed.largest)):
        if stated is not None:
            yield rf"{word} {value} = {structure(stated)}"


@claim_latex.register
def _(printed: Hanging, structure: Structure) -> Iterator[str]:
    chosen = [quantity for quantity, _ in printed.on]
    for figure in printed.figures:
        over = [q for q in leaves(figure.value) if isinstance(q, Quantity) and q not in chosen]
        value = structure(figure.value)
        if over:
            value = rf"\max_{{{', '.join(map(quantity_latex, over))}}} {value}"
        low, high = (None if b is None else structure(b) for b in (figure.low, figure.high))
        if low == high:
            yield f"{value} = {high}"
            continue
        yield (
            ("" if low is None else rf"{low} \le ")
            + value
            + ("" if high is None else rf" \le {high}")
        )


@claim_latex.register
def _(printed: LeastMoved, structure: Structure) -> Iterator[str]:
    value, letter = structure(printed.value), printed.over.letter
    yield (
        rf"\min_{{{letter}}} \left(\max {value} - \min {value}\right)"
        rf"\text{{ at }} {letter} = {printed.part + 1}"
    )


@claim_latex.register
def _(printed: Spans, structure: Structure) -> Iterator[str]:
    yield structure(printed.turns)


@claim_latex.register
def _(printed: InUnit, structure: Structure) -> Iterator[str]:
    unit = written(printed.factors, _upright, r"\,")
    yield rf"\left[{structure(printed.value)}\right] = {unit}"


def _upright(unit: str, power: int) -> str:
    return rf"\mathrm{{{unit}}}" + (f"^{{{power}}}" if power > 1 else "")
