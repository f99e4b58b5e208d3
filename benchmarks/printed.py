"""What this project prints of a kernel, and how the benchmark calls it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from math import prod

from armillary import Derivation, __version__
from armillary.derivation.quantity import AnyQuantity
from armillary.derivation.statements import Kernel
from armillary.program.compile import compile_kernel, compile_stages
from armillary.targets.c import (
    CKernel,
    CTarget,
    context_type,
    function_name,
    header_file,
    params_type,
    source_file,
    stages_file,
    status_header,
)
from benchmarks.table import SETUP, STEP, WHOLE

TARGET = CTarget("armillary", "", ("f64",), __version__)
PRECISION = "f64"
ABI = "0x0UL"
TALLY = "counting::Tally"
COUNT = "counting::tally"


@dataclass(frozen=True)
class Asked:
    """A kernel of a derivation.

    Attributes:
        places: where in the benchmark's inputs the first number of each parameter and input
            stands; None if they stand in the kernel's order.
    """

    derivation: Derivation
    kernel: str = "run"
    recipe: str = "chain of joints"
    places: Mapping[str, int] | None = None


class Printed:
    """A kernel in C, whole and in two stages."""

    def __init__(self, asked: Asked) -> None:
        """Compile it."""
        self.asked = asked
        self.kernel = asked.derivation.kernels[asked.kernel]
        made = compile_kernel(self.kernel)
        self._made = CKernel(made.program, made.cost, compile_stages(made))

    @property
    def stages(self) -> tuple[str, ...]:
        """What can be called."""
        return (WHOLE,) if self._made.stages is None else (WHOLE, SETUP, STEP)

    @cached_property
    def source(self) -> str:
        """The generated C as one text, without what ties its files together."""
        d, made = self.asked.derivation, self._made
        parts = [
            status_header(__version__),
            header_file(d.name, d.title, d.parameters, [made], TARGET, ABI),
            source_file(made, TARGET, PRECISION, ABI),
        ]
        if made.stages is not None:
            parts.append(stages_file(made.stages, TARGET, PRECISION, ABI))
        lines = [line for part in parts for line in part.splitlines()]
        return "\n".join(line for line in lines if not line.startswith('#include "'))

    def call(self, stage: str) -> str:
        """The statements that hand the benchmark's arrays over; only the stage asked is counted."""
        filled = self._parameters()
        if stage == WHOLE or self._made.stages is None:
            return " ".join([*filled, self._run(self.kernel)])
        context = context_type(self._made.stages.setup.kernel, TARGET, PRECISION)
        setup, step = (
            self._run(p.kernel) for p in (self._made.stages.setup, self._made.stages.step)
        )
        forget, keep = f"{COUNT} = {TALLY}();", f"const {TALLY} kept = {COUNT};"
        after = f"{COUNT} = kept;"
        counted = [setup, keep, step, after] if stage == SETUP else [setup, forget, step]
        return " ".join([*filled, f"{context} ctx = {{}};", *counted])

    def _run(self, kernel: Kernel) -> str:
        arguments = ["&p"] if kernel.parameters else []
        if kernel.stage == STEP:
            arguments.append("&ctx")
        for quantity in kernel.inputs:
            place = self._places[quantity.name]
            arguments.append(f"in + {place}" if quantity.shape else f"in[{place}]")
        starts = accumulate((prod(o.shape) for o in kernel.outputs), initial=0)
        arguments += [f"out + {start}" for _, start in zip(kernel.outputs, starts, strict=False)]
        if kernel.stage == SETUP:
            arguments.append("&ctx")
        return f"(void){function_name(kernel, TARGET, PRECISION)}({', '.join(arguments)});"

    @cached_property
    def _places(self) -> Mapping[str, int]:
        return in_order(self.kernel.inputs) if self.asked.places is None else self.asked.places

    def _parameters(self) -> list[str]:
        """A struct of zeros with what the benchmark gives."""
        d = self.asked.derivation
        if not d.parameters:
            return []
        lines = [f"{params_type(d.name, TARGET, PRECISION)} p = {{}};"]
        for quantity in d.parameters:
            if quantity.name not in self._places:
                continue
            for i in range(len(quantity.parts)):
                entry = f"{quantity.name}[{i}]" if quantity.shape else quantity.name
                lines.append(f"p.{entry} = in[{self._places[quantity.name] + i}];")
        return lines


def in_order(quantities: Sequence[AnyQuantity]) -> dict[str, int]:
    """Where the numbers of each start when they follow each other."""
    starts = accumulate((len(q.parts) for q in quantities), initial=0)
    return {q.name: start for q, start in zip(quantities, starts, strict=False)}
