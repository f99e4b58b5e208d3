"""Inputs that are drawn as expressions of other quantities: their values at a point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from armillary.derivation.drawing import others
from armillary.derivation.errors import DerivationError
from armillary.derivation.statements import Drawn, Kernel
from armillary.program.arithmetic import Reals
from armillary.program.evaluate import evaluate
from armillary.program.lower import Strategy, lower


class Drawing:
    """What a kernel's `drawn` says, as a function of a point.

    Attributes:
        others: quantities that a point must have beside those of the kernel.
    """

    def __init__(self, kernel: Kernel) -> None:
        self.others = others(kernel)
        self._kernel = kernel
        outputs = tuple(one.output for one in kernel.drawn)
        self._program = lower(replace(kernel, outputs=outputs, cases=()), Strategy())

    def at(self, row: Mapping[str, Any], reals: Reals) -> dict[str, Any]:
        """The values of the inputs drawn, at 50 digits: scalars, and flat lists, row-major.

        Args:
            row: a value of every quantity, arrays flat. The value that an input which is drawn
                near an expression has in its range is where it lies about the expression.

        Raises:
            DerivationError: where an expression has no real value, or one beyond the limits.
        """
        given = {
            name: [reals.number(c) for c in x] if isinstance(x, list) else reals.number(x)
            for name, x in row.items()
        }
        try:
            values = evaluate(self._program, given, reals).results
        except (ArithmeticError, TypeError, ValueError):
            raise self._error("has no real value everywhere", self._kernel.drawn[0]) from None
        return {
            one.quantity.name: self._about(one, values[one.quantity.name], given, reals)
            for one in self._kernel.drawn
        }

    def _about(self, one: Drawn, value: Any, given: Mapping[str, Any], reals: Reals) -> Any:
        place = given[one.quantity.name]
        values, places = (x if isinstance(x, list) else [x] for x in (value, place))
        low, high = one.quantity.facts.range
        made = []
        for middle, p in zip(values, places, strict=True):
            off = one.by * (2 * (p - low) / (reals.number(high) - low) - 1) if one.by else 0
            made.append(self._legal(one, middle + off))
        return made if isinstance(value, list) else made[0]

    def _legal(self, one: Drawn, value: Any) -> Any:
        low, high = one.quantity.facts.limits
        if not hasattr(value, "_mpf_"):
            raise self._error("has no real value everywhere", one)
        if not low <= value <= high:
            raise self._error("lies beyond its limits somewhere", one)
        return value

    def _error(self, problem: str, one: Drawn) -> DerivationError:
        kernel = self._kernel
        return DerivationError(
            f"what {one.quantity.name} of kernel {kernel.name} of {kernel.system} is drawn as "
            f"{problem}",
            "narrow range= of the quantities that it stands on",
            kernel.source,
        )
