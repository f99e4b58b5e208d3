"""Set-up and step of the compiled kernels as one call, to be compared like the kernel itself."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from armillary.derivation.status import Status, worse
from armillary.verify.implementations import (
    Implementation,
    Inputs,
    Results,
    generated_module,
    native_implementations,
    native_system,
    need_compiler,
)
from armillary.verify.points import count


def stages_implementations(
    folder: Path, package: str, system: str
) -> list[tuple[str, Callable[[], Implementation]]]:
    """Makers of the stages of the compiled C, held to the tolerances of the undivided kernels.

    None if no kernel of the system is divided. Without a compiler they raise `EngineMissing`.
    """
    native = generated_module(folder, package, "native")
    kernels = native.SYSTEMS[system]["kernels"]
    divided = {name: facts["stages"] for name, facts in kernels.items() if "stages" in facts}
    if not divided:
        return []

    def maker(like: str, precision: str) -> Callable[[], Implementation]:
        def make() -> Implementation:
            need_compiler()
            module = native_system(folder, native, system)
            call = _Call(module, divided, _TYPES[precision])
            only = frozenset(divided)
            return Implementation(f"{like} in steps", _TYPES[precision], call, like, only)

        return make

    whole = native_implementations(folder, package, system)
    return [(f"{like} in steps", maker(like, like.split()[-1])) for like, _ in whole]


_TYPES: dict[str, type[np.floating[Any]]] = {"f64": np.float64, "f32": np.float32}
# What guards answer.
_REFUSED = (int(Status.NOT_FINITE), int(Status.OUT_OF_RANGE))


class _Call:
    """Each point of a batch set up for itself, and stepped once."""

    def __init__(self, module: Any, divided: dict[str, Any], dtype: Any) -> None:
        self.module, self.divided, self.dtype = module, divided, dtype

    def __call__(self, kernel: str, inputs: Inputs) -> Results:
        answers = list(self.answers(kernel, inputs))
        return {name: np.stack([answer[name] for answer in answers]) for name in answers[0]}

    def answers(self, kernel: str, inputs: Inputs) -> Iterator[Results]:
        rows = [{name: a[k] for name, a in inputs.items()} for k in range(count(inputs))]
        contexts = [self.stage(kernel, "setup", row) for row in rows]
        # What a step refuses is asked on any mount that was set up.
        legal = next(context for context in contexts if context.status >= 0)
        for row, context in zip(rows, contexts, strict=True):
            ready = context.status >= 0
            answer = self.stage(kernel, "step", row, context if ready else legal)
            found = {name: np.asarray(getattr(answer, name)) for name in answer._fields}
            yield found if ready else _refused(int(context.status), found)

    def stage(self, kernel: str, stage: str, row: Inputs, *context: Any) -> Any:
        facts = self.divided[kernel][stage]
        names = [*(q for q, _ in facts["inputs"]), *facts["reads"]]
        given = {name: np.asarray(row[name], self.dtype) for name in names}
        return getattr(self.module, f"{kernel}_{stage}")(*context, **given)


def _refused(status: int, found: Results) -> Results:
    """What a set-up that refused and a step on another mount say together."""
    other = int(found["status"])
    if other in _REFUSED:
        # One call tests all of its arguments ahead of any case.
        status = worse(status, other) if status in _REFUSED else other
    nans = {name: np.full_like(a, np.nan) for name, a in found.items() if name != "status"}
    return {**nans, "status": np.asarray(status, np.int8)}
