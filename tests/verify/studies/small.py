"""A small project with a study; its kernels are written by hand, as if they were generated."""

from pathlib import Path

from armillary.verify.studies.compute import Study
from armillary.verify.studies.running import run_study

PACKAGE = "demo_kernels"
KERNELS = '''"""The system."""

__all__ = ["thrice", "twice"]


def thrice(*, x):
    """Three times."""
    return 3 * x


def twice(*, x):
    """Two times."""
    return 2 * x
'''
PARAMETERS = """
[plant]
mass = { value = 2.0, unit = "kg", meaning = "a mass", provenance = "ours", source = "Ours." }
rods = { value = 3, unit = "1", meaning = "rods", provenance = "printed", source = "Fig. 1." }

[wind]
force = { value = 7.0, unit = "N", meaning = "a force", provenance = "ours", source = "Ours." }
"""

HEAD = """
import os
from armillary.verify.engines import need
from armillary.verify.study import Heading, Part, Prose, Result, Table

"""
THREE = f"""{HEAD}
from .arms import arms
from .suns import suns
from .winds import winds

parts = [("arms", arms), ("winds", winds), ("suns", suns)]
"""
ARMS = f"""{HEAD}
def arms(kernels, parameters):
    yield Heading("Arms")
    yield Prose(f"arms {{kernels.thrice(x=parameters.plant.mass)}}")
"""
WINDS = f"""{HEAD}
def winds(kernels, parameters, tell):
    tell(0.5, "half")
    yield Prose(f"winds {{kernels.twice(x=parameters.wind.force)}} in {{os.getpid()}}")
    print("to the error output")
"""
SUNS = f"""{HEAD}
def suns(kernels, sun):
    yield Prose(f"sun {{sun.twice(x=4)}}")
"""


def project(root: Path, study: str, parameters: str = "", **beside: str) -> Study:
    """Write a project with the systems `arm`, which has the study, and `sun`."""
    for system in ("arm", "sun"):
        folder = root / "derivations" / system
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "derivation.py").write_text("", "utf-8")
        write_kernels(root, system, KERNELS)
    package = root / "generated" / "python" / PACKAGE
    (package / "__init__.py").write_text("", "utf-8")
    (package / "_runtime.py").write_text("", "utf-8")
    write(root, study=study, **beside)
    if parameters:
        (root / "derivations" / "arm" / "parameters.toml").write_text(parameters, "utf-8")
    return Study(root, PACKAGE, "arm")


def write(root: Path, **files: str) -> None:
    """Files of the study."""
    for name, text in files.items():
        (root / "derivations" / "arm" / f"{name}.py").write_text(text, "utf-8")


def write_kernels(root: Path, system: str, text: str) -> None:
    path = root / "generated" / "python" / PACKAGE / f"{system}.py"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")


def ran(study: Study, *only: str) -> list[str]:
    """The parts that a run of the study had to run, in the order in which they ended."""
    said: list[str] = []
    run_study(study, only, said.append)
    ended = [line.split(",")[0].split() for line in said if line.startswith("studied")]
    return [words[-1] for words in ended]


def texts(study: Study, *only: str) -> list[str]:
    """The paragraphs of a study."""
    return [getattr(i, "text", f"{i}") for i in run_study(study, only, lambda line: None)]


def set_to(study: Study, *settings: str) -> Study:
    """The study with parameters set."""
    return Study(study.root, study.package, study.system, settings)
