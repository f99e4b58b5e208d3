"""A worker process from the outside."""

from __future__ import annotations

import json
import os
import queue
import subprocess
import sys
import threading
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from armillary.verify.studies.compute import Study

Message = dict[str, Any]
Heard = queue.Queue[tuple[str, Message]]

# Side by side, workers share the cores: one thread each for linear algebra.
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
_COMMAND = ("-P", "-m", "armillary.verify.studies.worker")


class Process:
    """Runs a part; what it says goes to `heard` with its name, at last {"ended": exit status}."""

    def __init__(self, study: Study, part: str, results: Mapping[str, Any], heard: Heard) -> None:
        job = asdict(study) | {"root": str(study.root.resolve()), "part": part, "results": results}
        paths = [str(Path(entry).resolve()) for entry in sys.path]
        environment = {**dict.fromkeys(_THREADS, "1"), **os.environ}
        self._process = subprocess.Popen(
            [sys.executable, *_COMMAND],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={**environment, "PYTHONPATH": os.pathsep.join(paths)},
            encoding="utf-8",
        )
        self._part, self._job, self._heard = part, json.dumps(job), heard
        self._thread = threading.Thread(target=self._talk, daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """End it, if it has not ended; what it has not finished is lost."""
        self._process.terminate()
        self._thread.join()

    def _talk(self) -> None:
        with self._process as process:
            assert process.stdin is not None
            assert process.stdout is not None
            try:
                process.stdin.write(self._job + "\n")
                process.stdin.close()
            except BrokenPipeError:
                pass  # it ended before it read; its status says so
            for line in process.stdout:
                self._heard.put((self._part, json.loads(line)))
            status = process.wait()
        self._heard.put((self._part, {"ended": status}))
