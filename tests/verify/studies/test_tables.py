"""Tables of parameters: filled in when they are shown, with what was set."""

import pytest

from armillary.verify.parameters import ParameterError, with_settings
from armillary.verify.plots import PlotError
from armillary.verify.studies.errors import StudyError
from armillary.verify.studies.tables import parameter_table, shown, text
from armillary.verify.study import ParameterTable, Prose
from tests.verify.studies.small import PARAMETERS, project

BOUNDED = """
[a.x]
value = [0.5, 1e-6]
unit = "m"
meaning = "$x$"
provenance = "inferred"
source = "Here."
low = 0
"""


@pytest.fixture
def study(tmp_path):
    return project(tmp_path, "def study(kernels): ...\n", PARAMETERS)


def test_a_table_is_filled_in(study):
    items = shown([Prose("a"), ParameterTable("All.")], study.parameters(), study.path)
    assert items[0] == Prose("a")
    assert [c.name for c in items[1].heads] == [
        "name",
        "value",
        "unit",
        "meaning",
        "from",
        "source",
    ]
    assert items[1].rows[:2] == (
        ("plant.mass", 2.0, "kg", "a mass", "ours", "Ours."),
        ("plant.rods", 3, "", "rods", "printed", "Fig. 1."),
    )
    assert len(items[1].rows) == 3
    assert items[1].texts()[0][1] == "2"


def test_some_sections_and_what_was_set(study):
    found = with_settings(study.parameters(), ["wind.force=8"])
    table = parameter_table("Some.", found, ["wind"])
    assert table.rows == (
        ("wind.force", 8.0, "N", "a force", "set", "Set by hand; otherwise 7 (ours)."),
    )
    with pytest.raises(ParameterError, match="no section 'winds'\n  mend: choose from wind"):
        parameter_table("Some.", found, ["winds"])


def test_bounds_have_a_column_where_there_are_any(tmp_path):
    study = project(tmp_path, "def study(kernels): ...\n", BOUNDED)
    table = parameter_table("All.", study.parameters())
    assert table.heads[3].name == "may be"
    assert table.rows == (("a.x", "0.5, 1·10⁻⁶", "m", "at least 0", "$x$", "inferred", "Here."),)


def test_values_in_words():
    assert text(((1.0, 2), (3, 4.5))) == "[1, 2], [3, 4.5]"
    assert text(-3) == "−3"


def test_what_cannot_be_shown_is_refused(study):
    with pytest.raises(StudyError, match="a table of parameters, and there are none"):
        shown([ParameterTable("All.")], None, study.path)
    with pytest.raises(PlotError, match="sections='wind'\n  mend: give a list"):
        ParameterTable("All.", "wind")
