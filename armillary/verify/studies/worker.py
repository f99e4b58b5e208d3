"""A process that runs one part of a study: `python -m armillary.verify.studies.worker`.

It reads one line of JSON from its input, and writes lines of JSON to its output: {"tell": ...},
{"waiting": true}, and at last {"done": file}, {"missing": name} or {"error": ...}. What the part
prints goes to the error output.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, TextIO

from armillary.verify.engines import EngineMissing
from armillary.verify.parameters import ParameterError
from armillary.verify.studies.compute import Study, compute
from armillary.verify.studies.errors import StudyError
from armillary.verify.studies.parts import parts_of


def main() -> int:
    """Run the part that the input names."""
    job = json.loads(sys.stdin.readline())
    out = _own_output()

    def send(**message: Any) -> None:
        print(json.dumps(message), file=out, flush=True)

    try:
        send(**_answer(job, send))
    except KeyboardInterrupt:
        return 130  # the person at the keyboard is told by the process that started this one
    return 0


def _answer(job: dict[str, Any], send: Callable[..., None]) -> dict[str, Any]:
    study = Study(Path(job["root"]), job["package"], job["system"], tuple(job["settings"]))
    try:
        part = next(part for part in parts_of(study.path) if part.name == job["part"])
        kept = compute(
            study,
            part,
            job["results"],
            lambda fraction, words: send(tell=[fraction, words]),
            lambda: send(waiting=True),
        )
    except EngineMissing as missing:
        return {"missing": missing.engine}
    except (StudyError, ParameterError) as problem:
        return {"error": [problem.problem, problem.mend]}
    return {"done": kept.file}


def _own_output() -> TextIO:
    """The output for messages alone; what else is printed goes to the error output."""
    sys.stdout.flush()
    mine = os.dup(1)
    os.dup2(2, 1)
    return os.fdopen(mine, "w", encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
