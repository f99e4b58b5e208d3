"""Install the wheel by itself and follow the chapter on adding a mechanism, word for word.

    python tools/try_wheel.py dist/armillary-*.whl

The wheel goes into an environment of its own, which borrows only the libraries of `.venv`: nothing
of this checkout can be imported there. The commands run in an empty folder.
"""

import re
import subprocess
import sys
import sysconfig
import tempfile
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CHAPTER = ROOT / "site_docs" / "adding-a-mechanism.md"


def environment(folder: Path, wheel: Path) -> Path:
    """An environment with the wheel; returns the folder of its programs."""
    venv.create(folder, with_pip=True)
    names = {"base": str(folder), "platbase": str(folder)}
    packages = Path(sysconfig.get_path("purelib", vars=names))
    # Only a site's own folder has its .pth files read, so the editable install stays behind.
    borrowed = sysconfig.get_path("purelib")
    (packages / "borrowed.pth").write_text(borrowed + "\n", encoding="utf-8")
    programs = folder / "bin"
    install = [programs / "python", "-m", "pip", "install", "--quiet", "--no-deps"]
    subprocess.run([*install, "--no-index", wheel], check=True)
    return programs


def main() -> None:
    """Follow the chapter; fail at the first command that does."""
    wheel = Path(sys.argv[1]).resolve()
    text = CHAPTER.read_text(encoding="utf-8")
    blocks = re.findall(r"^```sh\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    if not blocks:
        sys.exit(f"{CHAPTER.name} has no commands")
    with tempfile.TemporaryDirectory() as scratch:
        programs = environment(Path(scratch) / "venv", wheel)
        project = Path(scratch) / "project"
        project.mkdir()
        path = {"PATH": f"{programs}:/usr/bin:/bin", "HOME": scratch, "LANG": "C.UTF-8"}
        where = "import armillary; print(armillary.__file__)"
        found = subprocess.run(
            [programs / "python", "-c", where],
            cwd=project,
            env=path,
            check=True,
            capture_output=True,
            text=True,
        ).stdout.strip()
        if not found.startswith(scratch):
            sys.exit(f"{found} was imported, which is not in the wheel's environment")
        for commands in blocks:
            print(commands, end="", flush=True)
            subprocess.run(["sh", "-e", "-c", commands], cwd=project, env=path, check=True)
        page = project / "site" / "systems" / "demo.html"
        if 'class="badge fail"' in page.read_text(encoding="utf-8"):
            sys.exit("the page of the new mechanism shows a failed check")
        kernel = (
            "from armillary_kernels import native, sun; import math; "
            "a = dict(latitude=0.7, declination=0.2, hour_angle=0.5); "
            "assert math.isclose(native.sun.angles(**a).azimuth, sun.angles(**a).azimuth)"
        )
        subprocess.run([programs / "python", "-c", kernel], env=path, cwd=project, check=True)
    print("The wheel works by itself.")


if __name__ == "__main__":
    main()
