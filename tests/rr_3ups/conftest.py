"""Parts of the study of the RR-3UPS tracker, run here, with parameters set and nothing kept."""

import inspect
from functools import lru_cache
from pathlib import Path

import pytest

from armillary.derivation.beside import run
from armillary.verify.implementations import generated_module
from armillary.verify.parameters import NAME, read_parameters, with_settings
from armillary.verify.study import Part, Prose, Result, Table

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "derivations" / "rr_3ups"


class Study:
    """The parts of the study by name, each run when it is first asked for."""

    def __init__(self, settings):
        package = ROOT / "generated" / "python"
        listed = run(FOLDER / "study.py").module.parts
        self._parts = {
            part.name: part for part in (p if isinstance(p, Part) else Part(*p) for p in listed)
        }
        self._given = {
            "kernels": generated_module(package, "armillary_kernels", "rr_3ups"),
            "sun": generated_module(package, "armillary_kernels", "sun"),
            "parameters": with_settings(read_parameters(FOLDER / NAME), settings),
        }
        self._items = {}

    def items(self, name):
        """What a part yields."""
        if name not in self._items:
            part = self._parts[name]
            results = {k: v for need in part.needs for k, v in self.results(need).items()}
            given = {**self._given, "results": results}
            names = inspect.signature(part.run).parameters
            self._items[name] = tuple(part.run(*(given[wanted] for wanted in names)))
        return self._items[name]

    def results(self, name):
        """What a part leaves to others."""
        return {one.name: one.value for one in self.items(name) if isinstance(one, Result)}

    def prose(self, name):
        """All paragraphs of a part."""
        return "\n\n".join(one.text for one in self.items(name) if isinstance(one, Prose))

    def captions(self, name):
        """The captions of a part."""
        return "\n".join(getattr(one, "caption", "") for one in self.items(name))

    @property
    def verdicts(self):
        """The verdict on each claim."""
        return self.results("verdict")["verdicts"]

    @property
    def rows(self):
        """The rows of the table of verdicts by their first cell."""
        (table,) = (one for one in self.items("verdict") if isinstance(one, Table))
        return {row[0]: row[1:] for row in table.texts()}


@lru_cache
def studied(*settings):
    """The study with these parameters set; the days in coarser steps, which is quicker."""
    return Study(("sampling.step=4", *settings))


@pytest.fixture(scope="session")
def study():
    """`study("h=0.3,0.3,0")` is the study with these parameters set."""
    return studied
