"""A part runs again when something that it reads has changed, and is taken as kept otherwise."""

import pytest

from armillary.verify.studies import kept, versions
from armillary.verify.studies.compute import Study
from armillary.verify.study import Table
from tests.verify.studies.small import (
    ARMS,
    HEAD,
    KERNELS,
    PARAMETERS,
    THREE,
    WINDS,
    ran,
    set_to,
    texts,
    write,
    write_kernels,
)


def test_a_part_runs_again_when_what_it_reads_has_changed_and_only_then(study):
    assert sorted(ran(study)) == ["arms", "suns", "winds"]
    root, folder = study.root, study.path.parent
    write(root, arms=ARMS + "\n# a word\n")
    assert ran(study) == ["arms"]
    write(root, study=THREE + "\n# a word\n")
    assert ran(study) == []
    write_kernels(root, "arm", KERNELS.replace("3 * x", "x + x + x"))
    assert ran(study) == ["arms"]
    write_kernels(root, "arm", KERNELS.replace("Three times.", "Thrice."))
    assert ran(study) == []  # the kernels of the beginning, with another word
    write_kernels(root, "sun", KERNELS.replace("2 * x", "x + x"))
    assert ran(study) == ["suns"]
    write_kernels(root, "sun", KERNELS.replace('"thrice", "twice"', '"thrice", "twice", "more"'))
    assert ran(study) == []
    write_kernels(root, "sun", KERNELS + "\nTABLE = (1, 2)\n")
    assert ran(study) == ["suns"]
    (folder / "parameters.toml").write_text(PARAMETERS.replace("7.0", "8.0"), "utf-8")
    assert ran(study) == ["winds"]
    (folder / "parameters.toml").write_text(PARAMETERS.replace("a force", "push"), "utf-8")
    assert ran(study) == []
    (root / "generated" / "python" / "demo_kernels" / "_runtime.py").write_text("A = 1\n", "utf-8")
    assert sorted(ran(study)) == ["arms", "suns", "winds"]


def test_a_part_that_names_the_package_counts_on_all_of_it(study):
    write(study.root, winds=WINDS + "\n# demo_kernels\n")
    ran(study)
    write_kernels(study.root, "sun", KERNELS.replace("3 * x", "x + x + x"))
    assert ran(study) == ["winds"]


def test_a_part_that_imports_the_derivation_counts_on_what_it_states(study):
    derivation = study.path.with_name("derivation.py")
    text = """from armillary import Derivation
derivation = d = Derivation("arm", title="Arm")
x = d.angle("x", "an angle")
y = d.define("y", 3 * x, because="thrice")
"""
    derivation.write_text(text, "utf-8")
    write(study.root, winds=WINDS.replace("import os", "import os\nfrom .derivation import y"))
    assert "winds" in ran(study)
    derivation.write_text(text.replace("3 * x", "4 * x"), "utf-8")
    assert ran(study) == ["winds"]


def test_versions_of_what_a_part_needs_count(study, monkeypatch):
    write(study.root, winds=WINDS + "\ndef more():\n    need('scipy.optimize')\n")
    ran(study)
    real = versions.version
    monkeypatch.setattr(versions, "version", lambda n: "0" if n == "scipy" else real(n))
    assert ran(study) == ["winds"]


def test_what_is_set_is_kept_apart(study):
    assert len(ran(study)) == 3
    heavy = set_to(study, "mass=3")
    assert ran(heavy) == ["arms"]
    assert texts(heavy)[1] == "arms 9.0"
    assert texts(study)[1] == "arms 6.0"
    assert ran(study) == ran(heavy) == ran(set_to(study, "rods=4")) == []


def test_old_ones_are_thrown_away_when_there_are_many(study, monkeypatch):
    monkeypatch.setattr(kept, "MOST", 3)
    ran(study)
    for k in range(6):
        ran(set_to(study, f"mass={k + 3}"), "arms")
        assert ran(study) == []  # looked at each time
    assert len(list(study.folder("arms").glob("*.json"))) == 3


@pytest.mark.parametrize("old", ['"Prose"', '"reads"', '"text"'])
def test_what_is_kept_and_cannot_be_read_is_made_again(study, old):
    ran(study)
    (path,) = study.folder("arms").glob("*.json")
    text = path.read_text("utf-8")
    assert old in text
    path.write_text(text.replace(old, '"Poem"'), "utf-8")
    assert ran(study) == ["arms"]
    assert ran(study) == []


@pytest.mark.tool
def test_native_kernels_are_given_and_heard(tmp_path):
    """On a generated project: compiled, and run again when the C has changed."""
    from armillary.project.config import find_project
    from armillary.project.generate import generate
    from tests.project.projects import ALONE, SETTINGS, edit, write_system

    (tmp_path / "pyproject.toml").write_text(SETTINGS.replace('["f32"]', '["f32", "f64"]'), "utf-8")
    write_system(tmp_path, "alone", ALONE)
    project = find_project(tmp_path)
    generate(project, (), lambda line: None)
    text = HEAD + "def study(kernels, native):\n    yield Prose(f'{native.thrice(x=2.0).y}')\n"
    (tmp_path / "derivations" / "alone" / "study.py").write_text(text, "utf-8")
    study = Study(tmp_path, "demo_kernels", "alone")
    assert texts(study) == ["6.0"]
    assert ran(study) == []
    edit(tmp_path, "alone", "3 * x", "4 * x")
    generate(project, (), lambda line: None)
    assert texts(study) == ["8.0"]


def test_every_item_stays_what_it_was(study):
    table = Table("c", ["a", "b"], [[1, None], ["x", 2.5]])
    item = kept.Kept("key", {"parameter plant.mass": "ab"}, 1.5, (table,))
    kept.keep(study.folder("some"), item)
    assert kept.find(study.folder("some"), "key", lambda reads: True) == item
    assert kept.find(study.folder("some"), "key", lambda reads: False) is None
    assert kept.find(study.folder("some"), "other", lambda reads: True) is None
