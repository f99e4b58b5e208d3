"""`armillary audit`: the table, the JSON, what is kept and when it is made anew."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from armillary.derivation.errors import DerivationError
from armillary.derivation.papers import load_paper
from armillary.derivation.units import METRE, RADIAN
from armillary.project.audit import audit, row, summary, table
from armillary.project.config import Project, find_project
from armillary.project.errors import ProjectError
from armillary.verify.audit import kept
from armillary.verify.audit.shown import figure, input_text, size, worst
from armillary.verify.audit.verdict import (
    Counterexample,
    Entry,
    Finding,
    Read,
    Repair,
    Verdict,
)
from tests.project.conftest import Run
from tests.project.projects import SETTINGS, edit, environment, write_system

MAST = """
from armillary import Derivation, cos, sin, vector
derivation = d = Derivation("mast", title="Mast")
tilt = d.angle("tilt", "tilt from the zenith")
arm = d.parameter.length("arm", "length of the arm")
top = d.define("top", vector(0, arm * sin(tilt), arm * cos(tilt)), because="the arm leans")
"""
PAPER = """
from armillary import Paper, cos, sin, vector
paper = p = Paper("{key}", title="On masts")
mast = p.use("mast")
tilt, arm = mast.quantity("tilt"), mast.quantity("arm")
p.equation("1", words="the tip", claims=mast["top"],
           printed=vector(0, arm * sin(tilt), arm * cos(tilt)))
p.equation("2", words="its height", claims=mast["top"].z, printed=arm * {wrong}(tilt))
p.equation("2'", words="its reach", claims=mast["top"].y, printed=-arm * sin(tilt))
p.unchecked("3", "names of the parts", "It only names them.")
"""


def write_paper(root: Path, key: str, wrong: str = "sin") -> Path:
    path = root / "derivations" / "papers" / f"{key}.py"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(PAPER.format(key=key, wrong=wrong), "utf-8")
    return path


@pytest.fixture
def printed(tmp_path: Path) -> Project:
    """A project with one system and two papers on it."""
    (tmp_path / "pyproject.toml").write_text(SETTINGS, "utf-8")
    write_system(tmp_path, "mast", MAST)
    for key in ("smith", "jones"):
        write_paper(tmp_path, key)
    return find_project(tmp_path)


def said_by(project: Project, *names: str) -> list[str]:
    lines: list[str] = []
    audit(project, names, lines.append)
    return lines


def content(project: Project) -> dict:
    return json.loads((project.root / kept.AUDIT).read_text("utf-8"))


# -- the command ----------------------------------------------------------------------------


def test_the_table_has_a_row_for_every_print(printed: Project, run: Run):
    done = run(printed.root, "audit")
    assert done.returncode == 0, done.stderr
    assert "smith: On masts" in done.stdout
    rows = [line.split() for line in done.stdout.splitlines() if line.startswith("  ")]
    keys = ("1", "2", "2'", "3")
    verdicts = {r[0]: " ".join(r[1:]) for r in reversed(rows) if r[0] in keys}
    assert verdicts["1"].startswith("holds")
    assert verdicts["2"].startswith("misprint")
    assert verdicts["2'"].startswith("sign")
    assert verdicts["3"].startswith("not checkable")
    assert "1 hold, 1 misprint, 1 sign, 1 not checkable" in done.stdout
    assert all(len(line) <= 100 for line in done.stdout.splitlines())


def test_a_repair_stands_in_the_row_and_the_counterexample_behind_verbose(
    printed: Project, run: Run
):
    plain = run(printed.root, "audit", "smith").stdout
    assert "cos" in plain
    assert "jones" not in plain
    assert "row 1" not in plain
    told = run(printed.root, "audit", "-v", "smith").stdout
    assert all(f"row {row}, column 1: holds" in told for row in (1, 2, 3))
    assert "difference" in told


def test_json_is_what_is_kept(printed: Project, run: Run):
    done = run(printed.root, "audit", "--json", "smith")
    assert done.returncode == 0
    told = json.loads(done.stdout)
    assert told["format"] == kept.FORMAT
    assert list(told["papers"]) == ["smith"]
    paper = told["papers"]["smith"]
    assert set(paper) == {"digest", "counts", "findings"}
    assert paper["counts"] == {
        "holds": 1, "holds to order": 0, "misprint": 1, "sign": 1, "wrong": 0, "ambiguous": 0,
        "not checkable": 1,
    }  # fmt: skip
    assert [f["key"] for f in paper["findings"]] == ["1", "2", "2'", "3"]
    misprint = paper["findings"][1]
    assert set(misprint) == {
        "paper", "key", "verdict", "order", "words", "quote", "says", "claims", "readings", "unit",
    }  # fmt: skip
    assert misprint["claims"] == ["mast-top"]
    assert misprint["unit"] == "m"
    (reading,) = misprint["readings"]
    assert set(reading["entries"][0]) == {"row", "column", "verdict", "order", "repair", "worst"}
    example = reading["counterexample"]
    assert example["printed"] != example["derived"]
    assert set(example["at"]) == {"tilt", "arm"}
    assert reading["worst"] == pytest.approx(10 * 2**0.5, rel=0.05)  # arm ±10 m, all tilts
    assert content(printed)["papers"]["smith"] == paper


def test_an_unknown_paper_teaches(printed: Project, tmp_path: Path, run: Run):
    done = run(printed.root, "audit", "smyth")
    assert done.returncode == 1
    assert done.stderr == "error: there is no paper 'smyth'\n  mend: choose from jones, smith\n"
    assert not (printed.root / kept.AUDIT).exists()
    empty = tmp_path / "empty"
    empty.mkdir()
    (empty / "pyproject.toml").write_text(SETTINGS, "utf-8")
    assert "derivations/papers/x.py" in run(empty, "audit", "x").stderr
    none = run(empty, "audit")
    assert none.returncode == 0
    assert "no paper yet" in none.stdout


def test_a_paper_that_is_wrong_python_is_an_error_with_its_line(printed: Project, run: Run):
    path = write_paper(printed.root, "smith")
    path.write_text(path.read_text("utf-8") + "1 / 0\n", "utf-8")
    done = run(printed.root, "audit", "smith")
    assert done.returncode == 1
    assert "smith.py:11" in done.stderr
    with pytest.raises(DerivationError):
        load_paper(path)


def test_the_list_names_the_papers(printed: Project, run: Run):
    assert "papers: jones, smith" in run(printed.root, "list").stdout


# -- what is kept -----------------------------------------------------------------------------


def test_only_what_changed_is_audited_anew(printed: Project):
    assert said_by(printed) == ["auditing jones: 4 prints", "auditing smith: 4 prints"]
    again = said_by(printed)
    assert again == [f"{key} is as it was when it was audited" for key in ("jones", "smith")]
    write_paper(printed.root, "smith", wrong="cos")
    before = content(printed)["papers"]
    assert said_by(printed) == [again[0], "auditing smith: 4 prints"]
    now = content(printed)["papers"]
    assert now["jones"] == before["jones"]
    assert now["smith"]["digest"] != before["smith"]["digest"]
    assert now["smith"]["counts"]["holds"] == 2


def test_an_edit_of_a_system_outdates_its_papers(printed: Project):
    audit(printed, ("smith",), lambda line: None)
    paper = load_paper(printed.derivations / "papers" / "smith.py")
    assert kept.current(paper, kept.read(printed.root)) is not None
    edit(printed.root, "mast", "arm * cos(tilt)", "arm * sin(tilt)")
    edited = load_paper(printed.derivations / "papers" / "smith.py")
    assert kept.current(edited, kept.read(printed.root)) is None
    ((_, anew),) = audit(printed, ("smith",), lambda line: None).values()
    assert {f.key: f.verdict for f in anew.findings}["2"] is Verdict.HOLDS


def test_an_edit_of_a_systems_numbers_outdates_its_papers(printed: Project):
    audit(printed, ("smith",), lambda line: None)
    paper = load_paper(printed.derivations / "papers" / "smith.py")
    (printed.derivations / "mast" / "parameters.toml").write_text("# none yet\n", "utf-8")
    assert kept.current(paper, kept.read(printed.root)) is None


def test_other_papers_stay_and_those_without_a_file_go(printed: Project):
    audit(printed, ("jones",), lambda line: None)
    audit(printed, ("smith",), lambda line: None)
    assert list(content(printed)["papers"]) == ["jones", "smith"]
    (printed.derivations / "papers" / "jones.py").unlink()
    write_paper(printed.root, "smith", wrong="cos")
    audit(printed, (), lambda line: None)
    assert list(content(printed)["papers"]) == ["smith"]


def test_a_file_that_cannot_be_read_is_none(printed: Project):
    path = printed.root / kept.AUDIT
    for text in ("", "[]", "null", '{"format": 0, "papers": {}}', '{"format": 1}'):
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, "utf-8")
        assert kept.read(printed.root) == {}
    audit(printed, ("smith",), lambda line: None)
    assert list(kept.read(printed.root)) == ["smith"]


def test_an_audit_that_fails_keeps_the_old_findings(printed: Project, monkeypatch):
    audit(printed, (), lambda line: None)
    before = (printed.root / kept.AUDIT).read_bytes()
    write_paper(printed.root, "jones", wrong="cos")
    monkeypatch.setattr(os, "fsync", _full)
    with pytest.raises(OSError, match="full"):
        audit(printed, (), lambda line: None)
    assert (printed.root / kept.AUDIT).read_bytes() == before


def _full(handle: int) -> None:
    raise OSError("the disk is full")


def test_the_same_bytes_under_every_hash_seed(printed: Project):
    found = set()
    for seed in ("0", "1"):
        done = subprocess.run(
            [sys.executable, "-m", "armillary.cli", "audit", "--json"],
            cwd=printed.root,
            env=environment(PYTHONHASHSEED=seed),
            capture_output=True,
            check=True,
        )
        (printed.root / kept.AUDIT).unlink()
        found.add(done.stdout)
    assert len(found) == 1


# -- hand-made findings -------------------------------------------------------------------


def made(**more) -> Finding:
    bad = Entry(2, 1, Verdict.SIGN, repair=Repair("sign", "minus for plus", "-x", 1), worst=0.5)
    example = Counterexample({"tilt": 0.5235987755982988, "sun": [0.0, 0.6, 0.8]}, 0.5, -0.5)
    read = Read(
        "with a dot", Verdict.SIGN, None, None, (Entry(1, 1, Verdict.HOLDS), bad), ("odd",),
        example, 1.0,
    )  # fmt: skip
    facts = {
        "paper": "x", "key": "7", "verdict": Verdict.SIGN, "order": None, "words": "w",
        "quote": "", "says": "s.", "claims": ("mast-top",), "readings": (read,), "unit": "rad",
    }  # fmt: skip
    return Finding(**{**facts, **more})


def test_findings_come_back_as_they_were(tmp_path: Path):
    whole = Read("", Verdict.WRONG, None, Repair("frame", "R^T v", "", 1, 1), (), worst=2.0)
    findings = (
        made(),
        made(key="8", verdict=Verdict.ORDER, order=1, readings=(whole,), claims=()),
        made(key="9", verdict=Verdict.NOT_CHECKABLE, readings=()),
    )
    kept.write(tmp_path, {"x": kept.Audit("d", findings)}, ["x"])
    assert kept.read(tmp_path) == {"x": kept.Audit("d", findings)}


def test_what_is_not_finite_is_a_string(tmp_path: Path):
    read = Read("", Verdict.WRONG, None, None, (), worst=float("inf"))
    kept.write(tmp_path, {"x": kept.Audit("d", (made(readings=(read,)),))}, ["x"])
    assert '"worst": "inf"' in (tmp_path / kept.AUDIT).read_text("utf-8")
    (back,) = kept.read(tmp_path)["x"].findings
    assert back.readings[0].worst == float("inf")


def test_numbers_are_told_as_people_read_them():
    assert input_text(0.5235987755982988, RADIAN) == "30°"
    assert input_text(-0.7853981633974483, RADIAN) == "−45°"
    assert input_text(0.01, RADIAN) == "0.01 rad"
    assert input_text(0.0, RADIAN) == "0 rad"
    assert input_text([0.0, 0.6, 0.8], None) == "(0, 0.6, 0.8)"
    assert input_text(1.5, METRE) == "1.5 m"
    assert size(1.234e-5, "rad") == "1.2e−5 rad"
    assert size(0.5, "1") == "0.5"
    assert figure(-0.0) == "0"
    assert worst(made()) == 1.0


def test_long_findings_are_wrapped_beside_their_key():
    lines = list(row("it", made(says="word " * 60), (5, 9, 12)))
    assert len(lines) > 3
    assert all(len(line) <= 100 for line in lines)
    assert all(line.startswith(" " * 31) for line in lines[1:])


def test_verbose_tells_readings_entries_and_counterexample(printed: Project):
    paper = load_paper(printed.derivations / "papers" / "smith.py")
    told = "\n".join(table(paper, kept.Audit("", (made(key="2"),)), verbose=True))
    assert "read as with a dot: sign" in told
    assert "odd" in told
    assert "row 2, column 1: sign: minus for plus, error up to 0.5 rad" in told
    assert "at tilt = 30°, sun = (0, 0.6, 0.8): printed 0.5, derived −0.5 rad" in told
    assert "read as" not in "\n".join(table(paper, kept.Audit("", (made(key="2"),)), verbose=False))


def test_the_summary_leaves_out_what_nothing_has():
    assert summary([made(), made(verdict=Verdict.HOLDS)]) == "1 hold, 1 sign"
    assert summary([]) == "nothing is printed"


def test_names_are_chosen_in_the_order_of_the_project(printed: Project):
    assert printed.chosen_papers(("smith", "jones")) == ["jones", "smith"]
    with pytest.raises(ProjectError, match="no paper"):
        printed.chosen_papers(("nobody",))
