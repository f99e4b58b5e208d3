"""Small projects, and ways to work on them."""

import os
from pathlib import Path

import armillary
from armillary.project.config import Project
from armillary.project.generate import generate

HOME = Path(armillary.__file__).resolve().parents[1]

SETTINGS = '[tool.armillary]\nkernels = "demo_kernels"\nversion = "0.1.0"\nprecisions = ["f32"]\n'
BASE = """
from armillary import Derivation, cos, sin
derivation = d = Derivation("base", title="Base")
turn = d.angle("turn", "an angle")
reach = d.define("reach", 2 * cos(turn), because="a projection")
lift = d.define("lift", sin(turn), because="another")
d.kernel("both", inputs=[turn], outputs=[reach, lift])
d.kernel("one", inputs=[turn], outputs=[lift])
"""
USER = """
from armillary import Derivation
derivation = d = Derivation("user", title="User")
base = d.use("base")
far = d.define("far", base["reach"] + 1, because="one further")
d.kernel("far_off", inputs=[base.quantity("turn")], outputs={"distance": far})
"""
ALONE = """
from armillary import Derivation
derivation = d = Derivation("alone", title="Alone")
x = d.angle("x", "an angle")
y = d.define("y", 3 * x, because="thrice")
d.kernel("thrice", inputs=[x], outputs=[y])
"""


def environment(**more: str) -> dict[str, str]:
    """The environment in which this very Armillary is found."""
    path = os.pathsep.join(filter(None, [str(HOME), os.environ.get("PYTHONPATH", "")]))
    return {**os.environ, "PYTHONPATH": path, "PYTHONDONTWRITEBYTECODE": "1", **more}


def write_system(root: Path, name: str, text: str) -> None:
    folder = root / "derivations" / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "derivation.py").write_text(text, "utf-8")


def edit(root: Path, name: str, old: str, new: str) -> None:
    path = root / "derivations" / name / "derivation.py"
    text = path.read_text("utf-8")
    assert old in text
    path.write_text(text.replace(old, new), "utf-8")


def regenerate(project: Project, *names: str) -> list[str]:
    """What a run says."""
    lines: list[str] = []
    generate(project, names, lines.append)
    return lines


def snapshot(folder: Path) -> dict[str, bytes]:
    """Every file that is part of the set, by name."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and not path.relative_to(folder).parts[0].startswith(".")
    }


def times(folder: Path) -> dict[str, int]:
    return {str(path): path.stat().st_mtime_ns for path in sorted(folder.rglob("*"))}
