"""The pages of papers: from findings made by hand, and from a small paper that is audited."""

import re
from pathlib import Path

import pytest

from armillary.derivation.papers import load_paper
from armillary.project.audit import audit
from armillary.project.config import find_project
from armillary.site.build import build_site
from armillary.site.errors import SiteError
from armillary.site.files import write_pages
from armillary.site.hooks import with_papers
from armillary.site.papers import Audited, audited_papers, paper_page, papers_index, prints_of
from armillary.site.prints import anchors, print_views
from armillary.site.references import Reference
from armillary.site.verdicts import KINDS, key_label
from armillary.verify.audit import kept
from armillary.verify.audit.verdict import (
    Counterexample,
    Entry,
    Finding,
    Read,
    Repair,
    Verdict,
)
from tests.project.projects import SETTINGS, edit, write_system
from tests.site.tree import Site

MAST = """
from armillary import Chain, Derivation, Y, X, Z, sin
derivation = d = Derivation("mast", title="Mast", paper="smith")
tilt = d.angle("tilt", "tilt from the zenith", latex=r"\\tau")
tilt_dot = tilt.rate()
arm = d.parameter.length("arm", "length of the arm")
mount = Chain("ground").rotate(X, -tilt).translate(Z, arm, frame="tip")
M = d.define("M", mount.pose("ground", "tip"), because="the arm leans", meaning="pose", printed="2")
R = d.define("R", mount.rotation("ground", "tip"), because="its turn", printed="9")
d.kernel("tip", inputs=[tilt], outputs=[M])
"""
PAPER = """
from armillary import Chain, Paper, Rotation, X, Z, cos, matrix, number, sin, vector
paper = p = Paper("smith", title="On masts")
mast = p.use("mast")
tilt, arm = mast.quantity("tilt"), mast.quantity("arm")
p.assume("The mast does not bend.")
reach = p.define("rho", mast["M"].position.y, because="Smith calls it reach & <range>.")
p.equation(
    "2", words="pose of the tip", claims=mast["M"],
    product=Chain("a").rotate(X, -tilt).translate(Z, arm, frame="b"),
    printed=matrix(
        (1, 0, 0, 0),
        (0, cos(tilt), sin(tilt), arm * cos(tilt)),
        (0, -sin(tilt), cos(tilt), arm * cos(tilt)),
        (0, 0, 0, 1),
    ),
)
p.equation(
    "3", words="the reach", claims=reach,
    printed={"with a dot": arm * mast.quantity("tilt_dot"), "without": arm * sin(tilt)},
)
p.word("same", "The <matrices> & more", "symmetric", {"the turn": mast["R"].matrix()})
p.between("reach", "less than the arm", reach, -arm, arm, words="the reach")
p.equation("3'", words="for small tilts", claims=reach, printed=arm * tilt, small=[tilt])
p.unchecked("4", "names", "It names the parts.")
"""
REFERENCES = """
[smith]
short = "Smith"
authors = "J. Smith & Co"
title = "On <masts>"
published = "Journal, 1"
"""
REFERENCE = Reference("smith", "Smith", "J. Smith & Co", "On <masts>", "Journal, 1")


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A project with a system and a paper on it."""
    for name, text in {
        "pyproject.toml": SETTINGS,
        "mkdocs.yml": "site_name: Small\n",
        "docs/index.md": "# Home\n",
        "derivations/papers/references.toml": REFERENCES,
        "derivations/papers/smith.py": PAPER,
    }.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, "utf-8")
    write_system(tmp_path, "mast", MAST)
    return tmp_path


def audit_all(root: Path) -> None:
    audit(find_project(root), (), lambda line: None)


def smith(root: Path):
    return load_paper(root / "derivations" / "papers" / "smith.py")


def by_hand() -> dict[str, Finding]:
    """Findings of every kind on the paper above; the numbers are made up."""
    good, bad = Entry(1, 1, Verdict.HOLDS), Repair("function", "sin for cos", r"l\,\sin \tau", 1, 1)
    example = Counterexample({"tilt": 0.5235987755982988, "arm": 1.0}, 0.866, 0.5, 2, 4)
    wrong = Entry(2, 4, Verdict.MISPRINT, repair=bad, worst=14.1)
    worse = Entry(3, 4, Verdict.ORDER, order=2, worst=0.25)
    reads = {
        "2": (
            Read("", Verdict.MISPRINT, None, None, (good, wrong, worse), (), example, 14.1),
        ),
        "3": (
            Read("with a dot", Verdict.SIGN, None, Repair("sign", "a < b", "-x", 1), (good,)),
            Read("without", Verdict.HOLDS, None, None, (good,)),
        ),
        "same": (Read("", Verdict.WRONG, None, None, (), (), example, 2.0),),
        "reach": (),
        "3'": (Read("", Verdict.ORDER, 1, None, (good,), (), None, 0.5),),
        "4": (),
    }  # fmt: skip
    verdicts = {
        "2": Verdict.MISPRINT, "3": Verdict.AMBIGUOUS, "same": Verdict.WRONG,
        "reach": Verdict.HOLDS, "3'": Verdict.ORDER, "4": Verdict.NOT_CHECKABLE,
    }  # fmt: skip
    claims = {"2": ("mast-M",), "3'": ("mast-M",), "same": ("mast-R", "mast-M")}
    return {
        key: Finding(
            "smith", key, verdict, 1 if verdict is Verdict.ORDER else None,
            "the pose" if key == "2" else "", "The <matrices> & more" if key == "same" else "",
            f"Says <b>{key}</b> & more. Second.", claims.get(key, ()), reads[key], "m",
        )
        for key, verdict in verdicts.items()
    }  # fmt: skip


def page_of(root: Path, findings: dict[str, Finding], outdated: bool = False) -> str:
    return paper_page(Audited(smith(root), findings, outdated), REFERENCE, explained=True)


# -- from findings made by hand -----------------------------------------------------------


def test_the_page_is_the_golden_one(root: Path, golden):
    golden("paper.md", page_of(root, by_hand()))


def test_the_overview_is_the_golden_one(root: Path, golden):
    audited = [Audited(smith(root), by_hand(), False)]
    text = papers_index(audited, {"smith": REFERENCE}, explained=True)
    drawing = re.search(r"<svg.*</svg>", text)
    assert drawing is not None
    assert "misprint" in drawing[0]
    golden("papers.md", text.replace(drawing[0], "<svg></svg>"))


def test_what_papers_say_is_escaped(root: Path):
    page = page_of(root, by_hand())
    for raw in ("<masts>", "<range>", "<matrices>", "Says <b>", "a < b"):
        assert raw not in page
    for escaped in (
        "&lt;masts&gt;",
        "&lt;range&gt;",
        "&lt;matrices&gt; &amp; more",
        "Says &lt;b&gt;",
    ):
        assert escaped in page


def test_bad_entries_are_boxed_and_told_in_a_table(root: Path):
    views = {view.anchor: view for view in print_views(smith(root), by_hand())}
    (reading,) = views["print-2"].readings
    (formula,) = reading.formulas
    boxed = re.findall(r"\\boxed\{(.*?)\} (?:&|\\\\|\\end)", formula.latex)
    assert boxed == [r"\text{arm}\,\cos \tau"]  # the other one holds to an order
    assert [(row.place, row.badge.word, row.repaired) for row in reading.rows] == [
        ("2, 4", "misprint", r"l\,\sin \tau"),
        ("3, 4", "holds to order 2", ""),
    ]
    assert reading.rows[0].repair == "sin for cos; then it holds to order 1"
    assert reading.holding == 1
    assert reading.example is not None
    assert reading.example.at == ((r"\tau", "30°"), (r"\text{arm}", "1 m"))
    assert (reading.example.error, reading.example.unit) == ("0.366", "m")


def test_every_reading_has_its_verdict(root: Path):
    views = {view.anchor: view for view in print_views(smith(root), by_hand())}
    readings = views["print-3"].readings
    assert [(r.name, r.badge.word) for r in readings if r.badge] == [
        ("with a dot", "sign"),
        ("without", "holds"),
    ]
    assert "with a dot: sign; without: holds" in page_of(root, by_hand())


def test_sentences_are_put_as_formulas(root: Path):
    views = {view.anchor: view for view in print_views(smith(root), {})}
    assert views["print-same"].quote == "The <matrices> & more"
    assert views["print-same"].readings[0].formulas[0].latex.startswith(r"\text{the turn} = ")
    (bounds,) = views["print-reach"].readings[0].formulas
    assert bounds.latex == r"-\text{arm} \le \rho \le \text{arm}"
    assert views["print-4"].says == "It names the parts."


def test_without_an_audit_there_is_no_verdict(root: Path):
    never, before = page_of(root, {}), page_of(root, {}, outdated=True)
    assert "Not audited yet: run <code>armillary audit smith</code>" in never
    assert "was edited since the last audit: run <code>armillary audit smith</code>" in before
    for page in (never, before):
        assert "badge verdict" not in page
        assert "## Findings" not in page
        assert 'id="print-3-prime"' in page  # what is printed stands there all the same


def test_addresses_are_unique(root: Path):
    paper = smith(root)
    for key in ("3' ", "a b", "a-b", "11''"):
        paper.unchecked(key, "x", "y")
    found = anchors(paper)
    assert found["3'"] == "print-3-prime"
    assert found["3' "] == "print-3-prime-2"
    assert found["11''"] == "print-11-prime-prime"
    assert len(set(found.values())) == len(found) == len(paper.printed)


def test_numbers_stand_in_parentheses_and_words_do_not():
    keys = ("14", "01", "11''", "3a", "3 angles", "singular")
    assert [key_label(key) for key in keys] == [
        "(14)", "(01)", "(11'')", "(3a)", "3 angles", "singular",
    ]  # fmt: skip


def test_every_verdict_has_a_badge_and_its_colours():
    assert set(KINDS) == set(Verdict)
    theme = Path(__file__).parents[2] / "armillary" / "site" / "theme"
    css = (theme / "css" / "papers.css").read_text("utf-8")
    for kind in KINDS.values():
        assert re.search(rf"\.{kind}\b", css), kind
    assert '"papers"' in (theme / "main.html").read_text("utf-8")


def test_steps_lead_to_what_is_printed_of_them(root: Path):
    found = prints_of([Audited(smith(root), by_hand(), False)], {"smith": REFERENCE})
    assert [link.key for link in found.by_definition["mast-M"]] == ["2", "same", "3'"]
    link = found.by_key["smith", "2"]
    assert (link.text, link.href) == ("Smith (2)", "../papers/smith.html#print-2")
    assert link.badge.word == "misprint"


def test_papers_take_their_place_in_the_navigation():
    pages = {"Papers": [{"Overview": "papers/index.md"}, {"Smith": "papers/smith.md"}]}
    home, end, place = {"Home": "a.md"}, {"End": "b.md"}, {"Papers": "papers/index.md"}
    assert with_papers([home, place, end], {"smith": "Smith"}) == [home, pages, end]
    assert with_papers([home, end], {"smith": "Smith"}) == [home, end, pages]
    assert with_papers([home, place, end], {}) == [home, end]
    assert with_papers(None, {"smith": "Smith"}) is None


# -- from an audit --------------------------------------------------------------------------


def test_a_site_with_a_paper_is_whole(root: Path):
    audit_all(root)
    site = Site(build_site(root))
    page = site.page("papers/smith.html")
    ids = {p.path: set(p.reader.ids) for p in site.pages}
    assert len(ids[page.path]) == len(page.reader.ids)
    for one in site.pages:
        for link in one.reader.links:
            path, _, fragment = link.partition("#")
            if "://" in path or not (path or fragment):
                continue
            target = (one.path.parent / path).resolve() if path else one.path
            assert target.is_file(), f"{one.path}: {link}"
            assert not fragment or fragment in ids[target], f"{one.path}: {link}"
    assert "../systems/mast.html#eq-mast-M" in page.reader.links
    assert "#print-2" in page.reader.links
    assert "../papers/smith.html#print-2" in site.page("systems/mast.html").reader.links
    assert "papers/smith.html" in site.page("index.html").reader.links


def test_the_badge_of_a_step_carries_the_verdict_while_the_audit_is_current(root: Path):
    def step() -> str:
        write_pages(root, root / "docs")
        return (root / "docs" / "systems" / "mast.md").read_text("utf-8")

    assert "print: " not in step()
    audit_all(root)
    text = step()
    assert 'Smith (2)</span> <span class="badge verdict misprint">print: misprint</span>' in text
    assert "Smith (9)</span></summary>" in text  # the paper's record has no (9)
    edit(root, "mast", "the arm leans", "the arm leans over")
    assert "print: " not in step()
    page = (root / "docs" / "papers" / "smith.md").read_text("utf-8")
    assert "was edited since the last audit" in page


def test_the_verdicts_of_a_small_paper(root: Path):
    audit_all(root)
    (one,) = audited_papers(root)
    verdicts = {key: finding.verdict for key, finding in one.findings.items()}
    assert verdicts.pop("same") is not Verdict.HOLDS
    assert verdicts == {
        "2": Verdict.MISPRINT,
        "3": Verdict.AMBIGUOUS,
        "reach": Verdict.HOLDS,
        "3'": Verdict.ORDER,
        "4": Verdict.NOT_CHECKABLE,
    }
    (entry,) = (e for e in one.findings["2"].readings[0].entries if e.verdict is not Verdict.HOLDS)
    assert (entry.row, entry.column) == (2, 4)
    assert entry.repair is not None
    assert entry.repair.latex == r"\text{arm}\,\sin \tau"


def test_the_same_page_again(root: Path):
    audit_all(root)
    (root / "docs").mkdir(exist_ok=True)
    write_pages(root, root / "docs")
    first = (root / "docs" / "papers" / "smith.md").read_bytes()
    (root / kept.AUDIT).unlink()
    audit_all(root)
    write_pages(root, root / "docs")
    assert (root / "docs" / "papers" / "smith.md").read_bytes() == first


def test_a_paper_without_a_reference_is_told(root: Path):
    (root / "derivations" / "papers" / "references.toml").write_text("", "utf-8")
    with pytest.raises(SiteError, match=r"references\.toml"):
        write_pages(root, root / "docs")


def test_without_papers_there_is_neither_page_nor_section(root: Path):
    audit_all(root)
    write_pages(root, root / "docs")
    assert (root / "docs" / "papers" / "index.md").is_file()
    (root / "derivations" / "papers" / "smith.py").unlink()
    (root / "mkdocs.yml").write_text(
        "site_name: Small\nnav:\n- Home: index.md\n- Papers: papers/index.md\n", "utf-8"
    )
    site = build_site(root)
    assert not list((root / "docs" / "papers").glob("*.md"))
    assert "Papers" not in (site / "index.html").read_text("utf-8")


MORE = """
from armillary import Paper, at, sin, vector
paper = p = Paper("smith", title="On masts")
mast = p.use("mast")
tilt, arm = mast.quantity("tilt"), mast.quantity("arm")
stay = p.index("stay", 3)
offset = p.constant("offset", (0, 1, 2), "where a stay is tied", per=stay)
pull = p.define("pull", sin(tilt + offset), because="Each stay pulls by its own.", latex="P")
many = pull
for k in range(15):
    for _ in range(10):
        many = many * sin(tilt + k)
    many = many + pull
p.define("many", many, because="In words.", latex="L")
p.between("low", "never less", pull, -1, None, words="the pull")
p.extremes("ends", "from ... to", pull, -1, 1, to="0.1", words="the pull")
p.extremes("top", "at most", pull, None, 1, to="0.1", words="the pull")
p.least_moved("still", "stay 2 moves least", pull, over=stay, part=1, words="the pull")
p.in_unit("unit", "arm [m²/s]", arm, "m^2/s")
p.equation("one", words="the first pull", claims=sin(tilt), printed=at(pull, stay, 0))
"""


def test_sentences_on_what_a_value_takes(root):
    (root / "derivations" / "papers" / "smith.py").write_text(MORE, "utf-8")
    (page,) = (
        paper_page(one, REFERENCE) for one in audited_papers(root) if one.paper.name == "smith"
    )
    formulas = re.findall('data-tex="([^"]*)"', page)
    for wanted in (
        r"-1 \le P_{i}", r"\min P_{i} = -1", r"\max P_{i} = 1",
        r"\min_{i} \left(\max P_{i} - \min P_{i}\right)\text{ at } i = 2",
        r"\left[\text{arm}\right] = \mathrm{m}^{2}/\mathrm{s}",
    ):  # fmt: skip
        assert wanted in formulas, wanted
    assert formulas.count(r"\min P_{i} = -1") == 1  # the sentence on the largest names no least


def test_a_name_that_no_reader_would_follow_is_told_in_words(root):
    (root / "derivations" / "papers" / "smith.py").write_text(MORE, "utf-8")
    (one,) = (a for a in audited_papers(root) if a.paper.name == "smith")
    page = paper_page(one, REFERENCE)
    assert 'data-tex="L_{i}"' in page
    assert "In words." in page
    assert r'data-tex="P_{i} = \sin' in page
