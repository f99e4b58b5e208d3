"""Every derivation of the project and the stress ones, printed once into a temporary folder."""

import importlib
import sys
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

import pytest

from armillary.derivation.load import load_all
from armillary.derivation.record import Derivation
from armillary.program.compile import Compiled
from armillary.program.stages import Stages
from armillary.targets import files
from armillary.targets.files import Target, render_shared, render_system
from tests.targets.stress import SYSTEMS

DERIVATIONS = Path(__file__).parents[2] / "derivations"
TARGET = Target("printed_kernels", "armillary", "", ("f32", "f64"), "0.1.0")


@dataclass(frozen=True)
class Printed:
    """Files of several systems in one folder, with what they were printed from."""

    folder: Path
    target: Target
    records: dict[str, Derivation]
    compiled: dict[tuple[str, str], Compiled]
    stages: dict[tuple[str, str], Stages]

    @property
    def c(self) -> Path:
        return self.folder / "c" / "src" / self.target.folder

    def sources(self, precision: str = "*") -> list[Path]:
        return sorted(self.c.glob(f"*_{precision}.c"))

    def module(self, name: str) -> ModuleType:
        """A module of the printed Python package."""
        sys.path.insert(0, str(self.folder / "python"))
        try:
            importlib.invalidate_caches()
            return importlib.import_module(f"{self.target.package}.{name}")
        finally:
            sys.path.remove(str(self.folder / "python"))


def print_all(folder: Path, target: Target, records: dict[str, Derivation]) -> Printed:
    """Render systems and write them, as the project does."""
    compiled, stages = {}, {}

    def remember(kernel):
        made = compile_kernel(kernel)
        compiled[kernel.system, kernel.name] = made
        return made

    def remember_stages(made):
        found, kernel = compile_stages(made), made.program.kernel
        if found:
            stages[kernel.system, kernel.name] = found
        return found

    compile_kernel, compile_stages = files.compile_kernel, files.compile_stages
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(files, "compile_kernel", remember)
        patch.setattr(files, "compile_stages", remember_stages)
        rendered = {name: render_system(record, target) for name, record in records.items()}
    texts = render_shared(target, rendered)
    for system in rendered.values():
        texts.update(system.files)
    for path, text in texts.items():
        place = folder / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, "utf-8")
    return Printed(folder, target, records, compiled, stages)


@pytest.fixture(scope="session", autouse=True)
def _own_cache(tmp_path_factory: pytest.TempPathFactory):
    """Compiled kernels stay out of the user's cache."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        yield


@pytest.fixture(scope="session")
def printed(tmp_path_factory: pytest.TempPathFactory) -> Printed:
    records = {**load_all(DERIVATIONS), **{name: make() for name, make in SYSTEMS.items()}}
    return print_all(tmp_path_factory.mktemp("printed"), TARGET, records)
