"""The chapters, followed word for word."""

import json
import os
import re
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from tests.site.conftest import ROOT
from tests.targets.compilers import needs


def blocks(chapter: str, language: str) -> list[str]:
    text = (ROOT / "site_docs" / chapter).read_text("utf-8")
    found = re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert found, f"{chapter} has no {language}"
    return found


def shell(commands: str, folder: Path, **more: str) -> str:
    path = f"{folder / 'bin'}:{os.environ['PATH']}"
    done = subprocess.run(
        ["sh", "-e", "-c", commands],
        cwd=folder,
        env={"PATH": path, "HOME": str(folder), "LANG": "C.UTF-8", **more},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.tool
@needs("cc")
def test_the_c_chapter(tmp_path):
    (tmp_path / "generated").symlink_to(ROOT / "generated")
    sources, commands = blocks("using-c.md", "c"), blocks("using-c.md", "sh")
    for name, source in zip(("tracker.c", "steps.c"), sources, strict=True):
        (tmp_path / name).write_text(source, "utf-8")
    strict = "".join(commands).replace("-O2", "-O2 -Wall -Wextra -Wdouble-promotion -Werror")
    told = shell(strict, tmp_path)
    # 3.2 m up to the axis, less half a metre times the sine of the tilt
    assert "tilt 0.3841 height 3.0126" in told
    assert re.findall(r"status 0 alpha (\S+) beta (\S+)", told) == steps_of_the_chapter()


def steps_of_the_chapter():
    """What the undivided kernel answers."""
    source = ROOT / "generated" / "python"
    asked = (
        "from armillary_kernels import heliostat\n"
        "for k in range(3):\n"
        "    a = heliostat.track(latitude=0.698, b=[0, 0.8, 0.6], declination=0.409,"
        " hour_angle=0.3 + 0.1 * k, theta=0.01, psi=-0.02, chi=0.005)\n"
        "    print(f'{float(a.alpha):.4f} {float(a.beta):.4f}')\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", asked], env={"PYTHONPATH": str(source)}, capture_output=True,
        text=True, check=True,
    )  # fmt: skip
    return [tuple(line.split()) for line in done.stdout.splitlines()]


def python_examples():
    found = []
    for source in blocks("using-python.md", "python"):
        marks = [pytest.mark.tool, needs("cc")] if "native" in source else []
        found.append(pytest.param(source, marks=marks))
    return found


@pytest.mark.parametrize("source", python_examples())
def test_the_python_chapter(source, tmp_path):
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", source],
        env={
            "PYTHONPATH": str(ROOT / "generated" / "python"),
            "PATH": os.environ["PATH"],
            "HOME": str(tmp_path),
        },
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout


def offer_armillary(folder: Path) -> None:
    """Put this very Armillary on the path of `shell`."""
    command = folder / "bin" / "armillary"
    command.parent.mkdir()
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m armillary.cli "$@"\n', "utf-8")
    command.chmod(command.stat().st_mode | stat.S_IXUSR)


@pytest.mark.slow
def test_the_chapter_on_adding_a_mechanism(tmp_path):
    offer_armillary(tmp_path)
    for commands in blocks("adding-a-mechanism.md", "sh"):
        shell(commands, tmp_path, PYTHONPATH=str(ROOT))
    page = (tmp_path / "site" / "systems" / "demo.html").read_text("utf-8")
    assert 'id="kernel-demo-pose"' in page
    assert "run <code>armillary" not in page  # generated, checked, and shown
    assert 'class="badge fail"' not in page
    (study,) = (b for b in blocks("adding-a-mechanism.md", "python") if "def study(" in b)
    (tmp_path / "derivations" / "demo" / "study.py").write_text(study, "utf-8")
    told = shell("armillary study demo; armillary site build", tmp_path, PYTHONPATH=str(ROOT))
    assert "From 2.021 m to 2.300 m" in told
    page = (tmp_path / "site" / "systems" / "demo.html").read_text("utf-8")
    assert 'id="study-demo-how-high-does-it-reach"' in page
    (height,) = (b for b in blocks("adding-a-mechanism.md", "toml") if "[mount.height]" in b)
    (tmp_path / "derivations" / "demo" / "parameters.toml").write_text(height, "utf-8")
    taken = study.replace("study(kernels)", "study(kernels, parameters)")
    taken = taken.replace("height=2.0", "height=parameters.mount.height")
    (tmp_path / "derivations" / "demo" / "study.py").write_text(taken, "utf-8")
    assert "From 2.021 m" in shell("armillary study demo", tmp_path, PYTHONPATH=str(ROOT))
    set_higher = "armillary study demo --set height=3"
    assert "From 3.021 m" in shell(set_higher, tmp_path, PYTHONPATH=str(ROOT))


def test_the_forces_of_the_chapter_on_adding_a_mechanism(tmp_path):
    offer_armillary(tmp_path)
    shell("armillary init --name field", tmp_path, PYTHONPATH=str(ROOT))
    (source,) = (b for b in blocks("adding-a-mechanism.md", "python") if "virtual_work(" in b)
    folder = tmp_path / "derivations" / "arm"
    folder.mkdir()
    (folder / "derivation.py").write_text('"""An arm."""\n\n' + source, "utf-8")
    asked = (
        "import math, sys; sys.path.insert(0, 'generated/python')\n"
        "from field_kernels import arm\n"
        "machine = dict(length=1.5, mass=2.0, inertia=[0.3, 1.0, 1.0], g=9.81)\n"
        "still = arm.moment(tilt=-math.pi / 2, tilt_dot=0.0, tilt_ddot=0.0, **machine)\n"
        "fast = arm.moment(tilt=0.0, tilt_dot=3.0, tilt_ddot=2.0, **machine)\n"
        "print(f'{float(still.moment):.2f} {float(fast.moment):.2f}')\n"
    )
    (tmp_path / "ask.py").write_text(asked, "utf-8")
    told = shell(f"armillary generate && '{sys.executable}' ask.py", tmp_path, PYTHONPATH=str(ROOT))
    # weight times arm; (inertia + mass times arm squared) times acceleration
    assert told.splitlines()[-1] == f"{2 * 9.81 * 1.5:.2f} {(0.3 + 2 * 1.5**2) * 2:.2f}"


@pytest.mark.slow
def test_the_chapter_on_the_audit(tmp_path):
    offer_armillary(tmp_path)
    begin, audit, site = blocks("auditing.md", "sh")
    (reference,), (paper,) = blocks("auditing.md", "toml"), blocks("auditing.md", "python")
    shell(begin, tmp_path, PYTHONPATH=str(ROOT))
    papers = tmp_path / "derivations" / "papers"
    (papers / "references.toml").write_text(reference, "utf-8")
    (papers / "smith.py").write_text(paper, "utf-8")
    told = shell(audit, tmp_path, PYTHONPATH=str(ROOT))
    assert "1 hold, 1 misprint, 1 sign\n" in told
    assert "It holds with cos for sin of tilt" in told
    assert "difference" in told
    shell(site, tmp_path, PYTHONPATH=str(ROOT))
    page = (tmp_path / "site" / "papers" / "smith.html").read_text("utf-8")
    assert page.count("badge verdict misprint") >= 3  # in the count, in the table, at the print
    step = (tmp_path / "site" / "systems" / "demo.html").read_text("utf-8")
    assert "../papers/smith.html#print-2" in step
    (data,) = blocks("auditing.md", "json")
    kept = json.loads((tmp_path / "build" / "audit.json").read_text("utf-8"))
    assert_same_form(json.loads(data), kept)


def assert_same_form(shown: object, found: object) -> None:
    """What a chapter shows has keys and values that are there; it may leave out others."""
    if isinstance(shown, dict):
        assert isinstance(found, dict)
        for key, inner in shown.items():
            if inner != "…":
                assert_same_form(inner, found[key])
    elif isinstance(shown, list):
        assert isinstance(found, list)
        for inner in shown:
            keys = [
                one for one in found if not isinstance(inner, dict) or one["key"] == inner["key"]
            ]
            assert_same_form(inner, keys[0])
    else:
        assert shown == found


@pytest.mark.slow
@needs("cc")
def test_the_chapter_on_loops_and_states(tmp_path):
    folder = tmp_path / "winches"
    folder.mkdir()
    offer_armillary(folder)
    shell("armillary init", folder, PYTHONPATH=str(ROOT))
    derivation, use = blocks("loops-and-states.md", "python")
    (program,) = blocks("loops-and-states.md", "c")
    system = folder / "derivations" / "cables"
    system.mkdir(parents=True)
    (system / "derivation.py").write_text(derivation, "utf-8")
    (folder / "main.c").write_text(program, "utf-8")
    (folder / "use.py").write_text(use, "utf-8")
    told = shell("armillary generate; armillary check", folder, PYTHONPATH=str(ROOT))
    assert " 0 failed" in told
    strict = "-std=c99 -O2 -Wall -Wextra -Werror -Igenerated/c/src"
    build = f"cc {strict} main.c generated/c/src/winches_kernels/*_f64.c -lm -o main; ./main"
    assert shell(build, folder) == "0.100 -0.200 1.500\n20.00\n"
    told = shell(f'"{sys.executable}" use.py', folder, PYTHONPATH=f"{ROOT}:generated/python")
    assert told.endswith("20.0\n")
    assert "east=array(0.1)" in told
