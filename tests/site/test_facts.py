"""A page tells costs, prototypes and checks of the derivation as it stands, and no others."""

from pathlib import Path

import pytest

from armillary.derivation.load import load_all
from armillary.project.config import find_project
from armillary.site.facts import read_facts
from armillary.site.kernels import cards
from armillary.site.pages import system_page
from armillary.verify import results
from tests.project.projects import edit, regenerate, write_system

SETTINGS = '[tool.armillary]\nkernels = "demo_kernels"\nversion = "0.1.0"\nprecisions = {}\n'
DEMO = """
from armillary import Derivation, Status
derivation = d = Derivation("demo", title="Demo")
t, u = d.angle("t_f64", "turn"), d.scalar("u", "another", limits=(-5, 5))
d.identity("so", t + u, u + t)
d.kernel("pose", inputs=[t, u], outputs={"r": 2 * t}, cases=[(Status.LIMIT, t < 1, "why")])
"""
EDITS = [("2 * t", "3 * t"), ("[t, u]", "[u, t]"), ("(-5, 5)", "(-6, 5)"), ("t < 1", "t < 2")]


def made(root: Path, precisions: str = '["f32", "f64"]') -> Path:
    (root / "pyproject.toml").write_text(SETTINGS.format(precisions), "utf-8")
    write_system(root, "demo", DEMO)
    regenerate(find_project(root))
    return root


def demo(root: Path):
    return load_all(root / "derivations")["demo"]


def page(root: Path) -> str:
    return system_page(demo(root), read_facts(root), {})


@pytest.mark.parametrize(("old", "new"), EDITS)
def test_a_kernel_that_changed_has_no_cost(tmp_path, old, new):
    root = made(tmp_path)
    assert cards(demo(root), read_facts(root))[0].costs
    edit(root, "demo", old, new)
    card = cards(demo(root), read_facts(root))[0]
    assert (card.costs, card.c_signatures, card.digest) == ((), (), "")
    assert "Not generated from the derivation as it stands" in page(root)


def test_prototypes_are_those_that_were_generated(tmp_path):
    root = made(tmp_path, '["f64"]')
    card = cards(demo(root), read_facts(root))[0]
    assert card.c_signatures == ("int demo_pose_f64(double t_f64, double u, double *r)",)
    narrow = made(tmp_path)
    assert cards(demo(narrow), read_facts(narrow))[0].c_signatures == (
        "int demo_pose_f32(float t_f64, float u, float *r)",
        "int demo_pose_f64(double t_f64, double u, double *r)",
    )


def test_checks_of_before_a_sign_edit_are_not_shown(tmp_path):
    root = made(tmp_path)
    assert "Nothing was checked yet" in page(root)
    digest = results.checked_digest(root, demo(root))
    proof = results.Outcome("demo", digest, None, "so", "SymPy", 0, 0.0, 0.0, True)
    engine = results.Outcome("demo", digest, "pose", "r by hand", "NumPy", 3, 0.0, 0.0, True)
    results.write(root, [proof, engine])
    assert "r by hand" in page(root)
    assert ">holds<" in page(root)
    edit(root, "demo", "2 * t", "-2 * t")
    assert "Not checked since the last edit: run <code>armillary check</code>" in page(root)
    assert "r by hand" not in page(root)
    assert ">holds<" not in page(root)
    assert ">not checked<" in page(root)


def test_kernels_made_anew_were_not_checked(tmp_path):
    root = made(tmp_path)
    digest = results.checked_digest(root, demo(root))
    results.write(root, [results.Outcome("demo", digest, None, "so", "SymPy", 0, 0.0, 0.0, True)])
    made(tmp_path, '["f64"]')
    assert "Not checked since the last edit" in page(root)


def test_a_manifest_of_another_format_tells_nothing(tmp_path):
    root = made(tmp_path)
    path = root / "generated" / "manifest.json"
    path.write_text(path.read_text("utf-8").replace('"format": ', '"format": 9'), "utf-8")
    facts = read_facts(root)
    assert (facts.package, dict(facts.systems)) == ("", {})


def test_a_divided_kernel_tells_what_set_up_and_step_cost(tmp_path):
    root = made(tmp_path)
    card = cards(demo(root), read_facts(root))[0]
    assert card.stages == ()
    assert "demo_pose_setup" not in page(root)
    angle = 't, u = d.angle("t_f64", "turn", rate=Rate.MOUNT)'
    edit(root, "demo", 't, u = d.angle("t_f64", "turn")', angle)
    edit(root, "demo", "Derivation, Status", "Derivation, Rate, Status, sin")
    edit(root, "demo", "2 * t", "u * sin(t)")
    regenerate(find_project(root))
    setup, step = cards(demo(root), read_facts(root))[0].stages
    assert (setup.name, step.name) == ("pose_setup", "pose_step")
    assert "1 sin/cos" in setup.cost
    assert "1 flops (1 mul, 0 add, 0 div, 0 sqrt), 0 sin/cos" in step.cost
    text = page(root)
    assert f"<code>pose_step</code> {step.cost}" in text
    for stage in (setup, step):
        assert len(stage.c_signatures) == 2
        for prototype in stage.c_signatures:
            assert prototype.startswith(f"int demo_{stage.name}_f")
            assert f"<code>{prototype};</code>" in text
