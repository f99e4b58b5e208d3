"""Parts are found, with what they stand on and want; wrong ones are refused with the mend."""

import re

import pytest

from armillary.verify.studies.errors import StudyError
from armillary.verify.studies.parts import parts_of, with_needed
from tests.verify.studies.small import project

TWO = """
from functools import partial
from armillary.verify.study import Part
from .one import first
from .two import second

def inner(kernels, size):
    yield from ()

parts = [("first", first), Part("second", second, needs=["first"]),
         ("third", partial(inner, size=3)), ("fourth", inner_of := (lambda k: ()))]
"""
ONE = "from .common import X\n\ndef first(k, parameters, sun, more=3):\n    yield from ()\n"
SECOND = "def second(kernels, tell, results):\n    yield from ()\n"


def test_a_part_counts_on_its_own_file_and_those_that_it_imports(tmp_path):
    study = project(tmp_path, TWO, one=ONE, two=SECOND, common="X = 1\n", apart="Y = 1\n")
    first, second, third, fourth = parts_of(study.path)
    assert [f.name for f in first.files] == ["common.py", "one.py"]
    assert [f.name for f in second.files] == ["two.py"]
    whole = ["common.py", "one.py", "study.py", "two.py"]
    assert [f.name for f in third.files] == [f.name for f in fourth.files] == whole
    assert first.wants == ("parameters", "sun")
    assert (second.wants, second.needs) == (("tell", "results"), ("first",))
    assert (third.wants, fourth.wants) == ((), ())


def test_the_chosen_come_with_what_they_need(tmp_path):
    study = project(tmp_path, TWO, one=ONE, two=SECOND, common="X = 1\n")
    parts = parts_of(study.path)
    assert [p.name for p in with_needed(parts, ["second"])] == ["first", "second"]
    assert [p.name for p in with_needed(parts, [])] == ["first", "second", "third", "fourth"]
    with pytest.raises(StudyError, match="no part 'fifth'\n  mend: choose from first, second"):
        with_needed(parts, ["fifth"])


START = "from armillary.verify.study import Part\n\ndef a(kernels): ...\n\n"
WRONG = {
    "neither": ("", "has no study"),
    "not a list": (START + "parts = a", "`parts` is no list"),
    "empty": (START + "parts = []", "`parts` is no list"),
    "no pair": (START + "parts = [a]", "is no part"),
    "a name that no file can have": (START + "parts = [('A b', a)]", "has the name 'A b'"),
    "no function": (START + "parts = [('a', 3)]", "has no function"),
    "needs a string": (START + "parts = [Part('a', a, needs='b')]", "needs are no list"),
    "one name twice": (START + "parts = [('a', a), ('a', a)]", "two parts have one name"),
    "a need that is no part": (
        START + "parts = [Part('a', a, needs=['b'])]",
        "needs 'b', which is no part\n  mend: choose from a",
    ),
    "a ring": (
        START + "parts = [Part('a', a, needs=['b']), Part('b', a, needs=['a']), ('c', a)]",
        "in a ring: a, b",
    ),
    "an argument that nobody gives": (
        "def study(kernels, p): ...",
        "takes 'p', which nobody gives\n  mend: after the kernels there are parameters, tell,",
    ),
    "arguments without a name": ("def study(kernels, *others): ...", "takes *others"),
    "no kernels": ("def study(): ...", "takes no kernels"),
}


@pytest.mark.parametrize("case", WRONG)
def test_wrong_parts_are_refused(tmp_path, case):
    text, says = WRONG[case]
    with pytest.raises(StudyError, match=re.escape(says)):
        parts_of(project(tmp_path, text).path)
