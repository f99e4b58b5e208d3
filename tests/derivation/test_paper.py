"""The record of a paper, what it refuses, and how it is loaded."""

import pytest

from armillary import Derivation, Paper, Rotation, X, Z, elementary, matrix, sin, vector
from armillary.derivation.entries import rows_of, shape_of
from armillary.derivation.errors import DerivationError
from armillary.derivation.folders import paper_names
from armillary.derivation.papers import load_paper, load_papers

SYSTEM = """
from armillary import Derivation, cos, sin
derivation = d = Derivation("arm", title="Arm")
a = d.angle("a", "turn")
x = d.define("x", cos(a), because="a projection")
"""
PAPER = """
from armillary import Paper, cos, sin
from ._more import tell
paper = p = Paper("first", title="The first")
arm = p.use("arm")
p.equation("1", words="x", claims=arm["x"], printed=cos(arm.quantity("a")))
tell(p)
"""
MORE = """
def tell(p):
    p.unchecked("2", "a name", "It names something.")
"""


@pytest.fixture
def p():
    return Paper("a_paper", title="A paper")


@pytest.fixture
def root(project):
    root = project(arm=SYSTEM) / "derivations"
    (root / "papers").mkdir()
    (root / "papers" / "first.py").write_text(PAPER, "utf-8")
    (root / "papers" / "_more.py").write_text(MORE, "utf-8")
    return root


def test_a_key_is_used_once(p):
    a = p.angle("a", "x")
    p.equation("1", words="x", claims=a, printed=a)
    with pytest.raises(DerivationError, match="two prints of a_paper have the key '1'"):
        p.unchecked("1", "x", "y")


def test_an_unknown_word_is_refused(p):
    a = p.angle("a", "x")
    with pytest.raises(DerivationError, match=r"'round' is no property.*\n  mend: say sing"):
        p.word("1", "they are round", "round", {"A": matrix((a, 0), (0, 1))})


@pytest.mark.parametrize(
    ("say", "error"),
    [
        (lambda p, a: p.equation("1", words="x", claims=a, printed={}), "has no reading"),
        (
            lambda p, a: p.equation("1", words="x", claims=a, printed=a, given=False),
            r"given= is False\n  mend: give a condition",
        ),
        (
            lambda p, a: p.equation("1", words="x", claims=a, printed=a, small=["a"]),
            r"small in \(1\) is 'a'\n  mend: give a quantity",
        ),
        (lambda p, a: p.needed("1", "q", [sin(a)], of=a), r"small in \(1\) is"),
        (lambda p, a: p.negligible("1", "q", a, of=a, beside=[2]), r"small in \(1\) is 2"),
        (lambda p, a: p.negligible("1", "q", a, of=a, beside=[]), "compares with nothing"),
        (lambda p, a: p.spans("1", "q", elementary(X, a), [a]), "names 1 angles"),
        (lambda p, a: p.word("1", "q", "singular", {}), "said of no matrix"),
        (lambda p, a: p.word("1", "q", "singular", {"A": matrix((a, 0))}), "A is 1 by 2"),
    ],
)
def test_what_cannot_be_compared_is_refused_where_it_is_written(p, say, error):
    with pytest.raises(DerivationError, match=error):
        say(p, p.angle("a", "x"))


def test_a_foreign_symbol_is_refused(p):
    other = Derivation("other", title="Other").angle("other", "x")
    a = p.angle("a", "x")
    for claims, printed in ((other, a), (a, sin(other))):
        with pytest.raises(DerivationError, match=r"equation \(1\) of a_paper uses other"):
            p.equation("1", words="x", claims=claims, printed=printed)


def test_what_is_no_expression_is_refused(p):
    a = p.angle("a", "x")
    with pytest.raises(DerivationError, match=r"equation \(1\) is .* not an expression"):
        p.equation("1", words="x", claims=a, printed=2)


def test_shapes_must_agree(p):
    a = p.angle("a", "x")
    with pytest.raises(DerivationError, match="3 by 1 entries, but what it claims has 1 by 1"):
        p.equation("1", words="x", claims=a, printed=vector(a, a, a))
    with pytest.raises(DerivationError, match="prints 3 by 1 entries"):
        p.equation("1", words="x", claims=a, printed={"one": a, "two": vector(a, a, a)})


def test_readings_keep_their_names(p):
    a = p.angle("a", "x")
    p.equation("1", words="x", claims=a, printed={"one": a, "two": 2 * a})
    p.equation("2", words="x", claims=a, printed=a)
    assert [r.name for r in p.printed["1"].readings] == ["one", "two"]
    assert [r.name for r in p.printed["2"].readings] == [""]


def test_the_entries_of_blocks(p):
    a = p.angle("a", "x")
    R: Rotation = elementary(Z, a) @ elementary(X, a)
    assert shape_of(a) == (1, 1)
    assert shape_of(vector(a, a, a)) == (3, 1)
    assert shape_of(R) == shape_of(R.matrix()) == (3, 3)
    assert shape_of(a < 0) == (1, 1)
    assert rows_of(matrix((a, 1), (2, 3)))[0][0] is a


def test_papers_are_found_and_loaded(root):
    assert paper_names(root) == ["first"]
    (paper,) = load_papers(root).values()
    assert list(paper.printed) == ["1", "2"]
    assert [f.rsplit("/", 1)[1] for f in paper.files] == ["_more.py", "first.py"]
    assert paper.printed["1"].source.path.endswith("first.py")


def test_papers_share_the_systems_they_use(root):
    text = PAPER.replace('"first"', '"second"')
    (root / "papers" / "second.py").write_text(text, "utf-8")
    first, second = load_papers(root).values()
    assert first.used["arm"].derivation is second.used["arm"].derivation


def test_no_papers(project):
    root = project(arm=SYSTEM) / "derivations"
    assert paper_names(root) == []
    assert load_papers(root) == {}


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("x = 1", "the file makes no paper\n  mend: write `paper = Paper"),
        (PAPER.replace('"first"', '"other"'), "the paper is named 'other' but its file 'first.py'"),
        ("1 / 0", "ZeroDivisionError"),
        ("from ._gone import x", "there is no _gone.py"),
        (PAPER.replace('use("arm")', 'use("leg")'), "there is no system 'leg' to use"),
    ],
)
def test_errors_of_a_file_name_the_line_and_the_mend(root, text, error):
    path = root / "papers" / "first.py"
    path.write_text(text, "utf-8")
    with pytest.raises(DerivationError, match="(?s)first.py.*" + error):
        load_paper(path)


def test_a_paper_that_is_not_there(root):
    with pytest.raises(DerivationError, match=r"there is no .*third.py\n  mend: .*: first"):
        load_paper(root / "papers" / "third.py")
