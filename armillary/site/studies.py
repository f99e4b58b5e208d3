"""What the pages show of the studies; what is not kept is run on the way.

A build of the site and `armillary study` keep what they find in one place, so that neither runs
again what the other has run.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from armillary.site.errors import SiteError
from armillary.verify.parameters import ParameterError
from armillary.verify.studies.compute import Study
from armillary.verify.studies.errors import StudyError
from armillary.verify.studies.reads import PYTHON
from armillary.verify.studies.running import run_study
from armillary.verify.studies.tables import shown
from armillary.verify.study import Absent, Item

log = logging.getLogger("mkdocs.armillary")


@dataclass(frozen=True)
class Studied:
    """What a study found, in the order of the page."""

    items: tuple[Item, ...] = ()

    @property
    def missing(self) -> str:
        """Why nothing at all could be computed here; empty if something was."""
        whys = [item.why if isinstance(item, Absent) else "" for item in self.items]
        return whys[0] if whys and all(whys) else ""


def studied(
    root: Path,
    package: str,
    system: str,
    settings: Sequence[str] = (),
    only: Sequence[str] = (),
) -> Studied:
    """The study of a system; empty where it has none or its kernels are not generated.

    Args:
        package: name of the generated Python package; empty before the first generation.
        settings: parameters that are set by hand, as "name=value".
        only: names of parts; all unless given.

    Raises:
        SiteError: for anything that goes wrong in the author's files, with its line.
    """
    study = Study(root, package, system, tuple(settings))
    module = root / PYTHON / package / f"{system}.py"
    if not package or not study.path.is_file() or not module.is_file():
        return Studied()
    try:
        found = run_study(study, only, log.info)
        return Studied(shown(found, study.parameters(), study.path))
    except (StudyError, ParameterError) as problem:
        raise SiteError(problem.problem, problem.mend) from problem


@contextmanager
def telling(say: Callable[[str], None]) -> Iterator[None]:
    """Pass on which study is at work; MkDocs is quiet while it builds."""
    level, handler = log.level, logging.Handler()
    handler.emit = lambda record: say(record.getMessage())  # type: ignore[method-assign]
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    try:
        yield
    finally:
        log.removeHandler(handler)
        log.setLevel(level)
