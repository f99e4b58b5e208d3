"""Studies on the pages: run when something they stand on changed, shown with their data."""

import logging
import re

import pytest

from armillary.project.config import find_project
from armillary.project.generate import generate
from armillary.site.build import build_site
from armillary.site.errors import SiteError
from armillary.site.studies import Studied, studied, telling
from armillary.site.study_page import blocks, words
from armillary.verify.study import Absent, Column, Heading, Prose, Table
from tests.project.projects import ALONE, SETTINGS, edit, write_system
from tests.site import figures

STUDY = """
import numpy as np
from armillary.verify.plots import Curve, Plot
from armillary.verify.study import Column, Heading, Prose, Table
from .angles import ANGLES


def study(kernels):
    with open(__file__.replace("study.py", "runs.txt"), "a") as runs:
        runs.write("run\\n")
    y = kernels.thrice(x=ANGLES).y
    yield Heading("How much is <thrice>?")
    yield Prose(f"At $x_1 = 2$ it is **{y[1]:.1f}**, which is > 5.")
    columns = ["place", Column("y", "rad", ".2f")]
    yield Table("All of $y$.", columns, [("first", y[0]), ("next", y[1])])
    yield Plot("It is a line.", "x, rad", "y, rad", [Curve("y", ANGLES, y)])
    yield Heading("How much is <thrice>?")
"""
ANGLES = "import numpy as np\n\nANGLES = np.array([1.0, 2.0])\n"


@pytest.fixture
def root(tmp_path):
    (tmp_path / "pyproject.toml").write_text(SETTINGS, "utf-8")
    write_system(tmp_path, "alone", ALONE)
    folder = tmp_path / "derivations" / "alone"
    (folder / "study.py").write_text(STUDY, "utf-8")
    (folder / "angles.py").write_text(ANGLES, "utf-8")
    (tmp_path / "mkdocs.yml").write_text("site_name: Small\n", "utf-8")
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "index.md").write_text("# Home\n", "utf-8")
    generate(find_project(tmp_path), (), lambda line: None)
    return tmp_path


def of(root) -> Studied:
    return studied(root, "demo_kernels", "alone")


def runs(root) -> int:
    path = root / "derivations" / "alone" / "runs.txt"
    return path.read_text().count("run") if path.is_file() else 0


def test_what_is_kept_is_what_was_found(root):
    fresh = of(root)
    assert [type(item).__name__ for item in fresh.items] == [
        "Heading", "Prose", "Table", "Plot", "Heading",
    ]  # fmt: skip
    assert of(root) == fresh
    assert runs(root) == 1


@pytest.mark.parametrize("name", sorted(figures.ALL))
def test_every_kind_of_plot_is_kept(root, name):
    text = f"from tests.site.figures import ALL\n\ndef study(kernels):\n    yield ALL[{name!r}]()\n"
    (root / "derivations" / "alone" / "study.py").write_text(text, "utf-8")
    fresh = of(root)
    assert fresh.items == (figures.ALL[name](),)
    (root / "derivations" / "alone" / "study.py").touch()
    assert of(root) == fresh


def test_it_runs_again_after_an_edit_and_only_then(root):
    folder = root / "derivations" / "alone"
    of(root)
    (folder / "study.py").write_text(STUDY.replace("which is", "that is"), "utf-8")
    of(root)
    assert runs(root) == 2
    (folder / "angles.py").write_text(ANGLES.replace("2.0", "3.0"), "utf-8")
    assert "**9.0**" in of(root).items[1].text
    assert runs(root) == 3
    edit(root, "alone", "3 * x", "4 * x")
    of(root)  # the kernels are what they were
    assert runs(root) == 3
    generate(find_project(root), (), lambda line: None)
    assert "**12.0**" in of(root).items[1].text
    of(root)
    assert runs(root) == 4


def test_a_kept_study_that_cannot_be_read_is_made_again(root):
    fresh = of(root)
    (path,) = (root / "build" / "studies" / "alone" / "study").glob("*.json")
    path.write_text(path.read_text().replace('"Prose"', '"Poem"'), "utf-8")
    assert of(root) == fresh
    assert runs(root) == 2


def test_the_page_shows_it(root):
    lines: list[str] = []
    build_site(root, root / "site", say=lines.append)
    assert "studying alone" in lines
    page = (root / "site" / "systems" / "alone.html").read_text("utf-8")
    assert page.index('id="studies"') < page.index('id="checks"')
    assert 'id="study-alone-how-much-is-thrice"' in page
    assert 'id="study-alone-how-much-is-thrice-2"' in page
    assert "How much is &lt;thrice&gt;?" in page
    assert '<span class="tex" data-tex="x_1 = 2"></span> it is <strong>6.0</strong>' in page
    assert '<td class="num">6.00</td>' in page
    assert '<th scope="row">next</th>' in page
    assert 'id="plot-alone-1"' in page
    assert "<b>Figure 1.</b> It is a line. <a" in page
    for name in ("all-of-y.csv", "it-is-a-line.csv"):
        assert f'<a class="data" href="alone/{name}" type="text/csv" download>CSV</a>' in page
    data = root / "site" / "systems" / "alone"
    assert (data / "all-of-y.csv").read_text("utf-8") == 'place,"y, rad"\nfirst,3.0\nnext,6.0\n'
    assert (data / "it-is-a-line.csv").read_text("utf-8").startswith('curve,"x, rad","y, rad"\n')
    build_site(root, root / "site", say=lines.append)
    assert lines.count("studying alone") == 1
    assert runs(root) == 1


WRONG = {
    "an error of Python": ("    yield 1 / 0\n", "study.py:2: ZeroDivisionError"),
    "a plot that cannot be drawn": (
        "    from armillary.verify.plots import Curve\n    yield Curve('a', [0], [float('inf')])\n",
        "study.py:3: y of the curve 'a' is infinite somewhere\n  mend: give None",
    ),
    "something else": ("    yield 3\n", "the study yields int\n  mend: yield Bars, Heading"),
    "a file that is not there": (
        "    from .nowhere import x\n    yield x\n",
        "ModuleNotFoundError",
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_an_error_names_the_line_of_the_study(root, case):
    body, says = WRONG[case]
    text = f"def study(kernels):\n{body}"
    (root / "derivations" / "alone" / "study.py").write_text(text, "utf-8")
    with pytest.raises(SiteError, match=re.escape(says)):
        of(root)


def test_a_missing_engine_is_said_and_not_kept(root):
    path = root / "derivations" / "alone" / "study.py"
    text = (
        "from armillary.verify.engines import need\n\n\ndef study(kernels):\n    yield need({!r})\n"
    )
    path.write_text(text.format("nowhere_to_be_found"), "utf-8")
    found = of(root)
    assert found == Studied((Absent("study", "nowhere_to_be_found is not installed"),))
    assert found.missing == "nowhere_to_be_found is not installed"
    assert not list((root / "build" / "studies").rglob("*.json"))
    build_site(root, root / "site", say=lambda line: None)
    page = (root / "site" / "systems" / "alone.html").read_text("utf-8")
    assert "Not computed here: nowhere_to_be_found is not installed." in page


PARTS = """
from armillary.verify.engines import need
from armillary.verify.study import Heading, ParameterTable, Prose

def bodies(kernels):
    need("nowhere_to_be_found")
    yield Prose("never")

def curves(kernels, parameters):
    yield Heading("Curves")
    yield ParameterTable("What it was computed with.")
    yield Prose(f"mass {parameters.plant.mass:g}")

parts = [("bodies", bodies), ("curves", curves)]
"""
MASS = """
[plant]
mass = { value = 2.5, unit = "kg", meaning = "its $m$", provenance = "ours", source = "Ours." }
"""


def test_a_part_that_misses_its_engine_says_so_in_its_place(root):
    folder = root / "derivations" / "alone"
    (folder / "study.py").write_text(PARTS, "utf-8")
    (folder / "parameters.toml").write_text(MASS, "utf-8")
    build_site(root, root / "site", say=lambda line: None)
    page = (root / "site" / "systems" / "alone.html").read_text("utf-8")
    missing = page.index("Not computed here (bodies): nowhere_to_be_found is not installed.")
    assert missing < page.index('id="study-alone-curves"') < page.index("mass 2.5")
    assert 'its <span class="tex" data-tex="m"></span>' in page
    data = root / "site" / "systems" / "alone" / "what-it-was-computed-with.csv"
    assert data.read_text("utf-8") == (
        "name,value,unit,meaning,from,source\nplant.mass,2.5,kg,its $m$,ours,Ours.\n"
    )


def test_data_that_nothing_links_any_more_are_removed(root):
    build_site(root, root / "site", say=lambda line: None)
    data = root / "docs" / "systems" / "alone"
    assert sorted(path.name for path in data.iterdir()) == ["all-of-y.csv", "it-is-a-line.csv"]
    study = root / "derivations" / "alone" / "study.py"
    study.write_text(STUDY.replace("All of $y$.", "Some."), "utf-8")
    build_site(root, root / "site", say=lambda line: None)
    assert sorted(path.name for path in data.iterdir()) == ["it-is-a-line.csv", "some.csv"]
    study.unlink()
    build_site(root, root / "site", say=lambda line: None)
    assert not data.exists()
    assert not (root / "site" / "systems" / "alone").exists()


def test_wrong_parameters_are_told(root):
    folder = root / "derivations" / "alone"
    (folder / "parameters.toml").write_text("[plant]\nmass = {}\n", "utf-8")
    with pytest.raises(SiteError, match=r"plant\.mass has no value"):
        of(root)


def test_without_kernels_there_is_no_study(root):
    (root / "generated" / "python" / "demo_kernels" / "alone.py").unlink()
    assert of(root) == Studied()


def test_telling_ends_with_its_block():
    said: list[str] = []
    with telling(said.append):
        pass

    logging.getLogger("mkdocs.armillary").info("late")
    assert said == []


def test_words_are_escaped_and_formulas_are_not():
    assert words("a < b & $x < y$") == (
        'a &lt; b &amp; <span class="tex" data-tex="x &lt; y"></span>'
    )


def test_columns_of_numbers_stand_right():
    table = Table("c", ["name", Column("n", "m")], [["a", 1], ["b", None]])
    (block,) = blocks([table], "s", 0)
    assert '<th scope="col" class="num">n<br><small>m</small></th>' in block
    assert '<td class="num">–</td>' in block


def test_figures_are_counted_on():
    found = blocks([Heading("A b"), Prose(" x "), figures.bars(), figures.heat()], "s", 2)
    assert found[0] == "### A b {: #study-s-a-b }"
    assert found[1] == "x"
    assert "<b>Figure 3.</b>" in found[2]
    assert "<b>Figure 4.</b>" in found[3]
    assert not any("\n" in block for block in found)  # Markdown would end the HTML there
