"""`armillary study`: as text, with parameters set, one part, its data, its parameters."""

from pathlib import Path

import pytest

from armillary.project.config import Project
from tests.project.conftest import Run
from tests.project.projects import regenerate

STUDY = """
from armillary.verify.plots import Curve, Plot
from armillary.verify.study import Column, Heading, ParameterTable, Prose, Table

def rows(kernels, parameters):
    x = parameters.motion.angles
    y = kernels.thrice(x=x).y
    yield Heading("Thrice")
    yield Prose(f"The last is **{y[-1]:.1f}**.")
    yield ParameterTable("Computed with.")
    yield Table("All of $y$.", ["place", Column("y", "rad", ".2f")], list(enumerate(y)))

def curve(kernels, parameters):
    x = parameters.motion.angles
    yield Plot("It is a line.", "x, rad", "y, rad", [Curve("y", x, kernels.thrice(x=x).y)])

parts = [("rows", rows), ("curve", curve)]
"""
PARAMETERS = """
[motion.angles]
value = [1.0, 2.0]
unit = "rad"
meaning = "angles to try"
provenance = "ours"
source = "Ours."
low = 0.0
high = 9.0
"""


@pytest.fixture
def studied(small: Project) -> Project:
    regenerate(small, "alone")
    folder = small.derivations / "alone"
    (folder / "study.py").write_text(STUDY, "utf-8")
    (folder / "parameters.toml").write_text(PARAMETERS, "utf-8")
    return small


def test_it_is_told_as_text_and_kept(run: Run, studied: Project):
    done = run(studied.root, "study", "alone")
    assert done.returncode == 0, done.stderr
    assert "studying alone rows\n" in done.stderr
    assert "studied alone curve, " in done.stderr
    assert "Thrice\n======\n\nThe last is **6.0**.\n\n" in done.stdout
    assert (
        "All of $y$.\nplace  y, rad\n-------------\n    0    3.00\n    1    6.00\n" in done.stdout
    )
    assert "motion.angles  1, 2   rad   0 to 9  angles to try  ours  Ours.\n" in done.stdout
    assert done.stdout.rstrip().endswith("[figure] It is a line.")
    again = run(studied.root, "study", "alone")
    assert (again.stdout, again.stderr) == (done.stdout, "")


def test_a_parameter_is_set_for_one_run(run: Run, studied: Project):
    done = run(studied.root, "study", "alone", "--set", "angles=1,3", "--only", "rows")
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("[set] motion.angles = 1, 3 rad, otherwise 1, 2\n\n")
    assert "**9.0**" in done.stdout
    assert "set   Set by hand; otherwise 1, 2 (ours)." in done.stdout
    assert "[figure]" not in done.stdout
    assert "**6.0**" in run(studied.root, "study", "alone").stdout


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("--set", "angle=1"), "no parameter 'angle'\n  mend: choose from angles"),
        (("--set", "angles=1"), "angles cannot be 1\n  mend: give 2 numbers in rad"),
        (("--set", "angles=1,10"), "angles is 10 rad\n  mend: give 0 to 9 rad"),
        (("--only", "row"), "the study has no part 'row'\n  mend: choose from rows, curve"),
        (("--parameters", "--set", "angle=1"), "no parameter 'angle'"),
    ],
)
def test_what_cannot_be_is_refused_with_the_mend(run: Run, studied: Project, words, says):
    done = run(studied.root, "study", "alone", *words)
    assert (done.returncode, done.stdout) == (1, "")
    assert says in done.stderr
    assert "Traceback" not in done.stderr


def test_the_parameters_are_listed_without_running_anything(run: Run, studied: Project):
    done = run(studied.root, "study", "alone", "--parameters", "--set", "angles=1,3")
    assert done.returncode == 0, done.stderr
    assert done.stdout == (
        "[motion]\n  angles = 1, 3 rad (0 to 9): angles to try\n"
        "      set: Set by hand; otherwise 1, 2 (ours).\n"
    )
    assert not (studied.root / "build" / "studies").exists()
    done = run(studied.root, "study", "base", "--parameters")
    assert done.returncode == 1
    assert "base has no parameters" in done.stderr


def test_its_data_are_written_where_one_says(run: Run, studied: Project, tmp_path: Path):
    done = run(studied.root, "study", "alone", "--csv", "data")
    assert done.returncode == 0, done.stderr
    assert done.stderr.endswith("wrote 3 files to data\n")
    found = {path.name: path.read_text("utf-8") for path in (studied.root / "data").iterdir()}
    assert found["all-of-y.csv"] == 'place,"y, rad"\n0,3.0\n1,6.0\n'
    assert found["it-is-a-line.csv"] == 'curve,"x, rad","y, rad"\ny,1.0,3.0\ny,2.0,6.0\n'
    assert sorted(found) == ["all-of-y.csv", "computed-with.csv", "it-is-a-line.csv"]


def test_what_is_missing_is_told(run: Run, studied: Project):
    folder = studied.derivations / "alone"
    need = "def lost(kernels):\n    from armillary.verify.engines import need\n    need('gone')\n"
    (folder / "study.py").write_text(
        STUDY.replace("parts = [", f"{need}\nparts = [('lost', lost), "), "utf-8"
    )
    done = run(studied.root, "study", "alone")
    assert done.returncode == 0, done.stderr
    assert "left out alone lost: gone is not installed" in done.stderr
    assert done.stdout.startswith("[not computed here] lost: gone is not installed\n\nThrice\n")
    done = run(studied.root, "study", "alone", "--only", "lost")
    assert done.returncode == 1
    assert done.stderr.endswith("gone is not installed\n  mend: install it beside armillary\n")


def test_without_a_study_or_kernels_it_says_what_to_do(run: Run, studied: Project):
    done = run(studied.root, "study", "base")
    assert done.returncode == 1
    assert "error: base has no study\n  mend: write " in done.stderr
    (studied.generated / "python" / "demo_kernels" / "alone.py").unlink()
    done = run(studied.root, "study", "alone")
    assert done.returncode == 1
    assert "run `armillary generate` first" in done.stderr
