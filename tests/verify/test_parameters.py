"""The parameters of a study: read, refused, set by hand, and heard when they are read."""

import copy
import pickle

import pytest

from armillary.verify.parameters import (
    Parameter,
    ParameterError,
    bounds_text,
    read_parameters,
    with_settings,
)

TEXT = """
[plant]
mass.value = 176.0
mass.unit = "kg"
mass.meaning = "mass that a rod moves"
mass.provenance = "ours"
mass.source = "A third of a facet, a rod, a screw."
mass.low = 1.0
mass.high = 1e4
rods = { value = 12, unit = "1", meaning = "n", provenance = "printed", source = "Fig.", low = 1 }

[days.number]
value = [80, 172]
unit = "1"
meaning = "days of the year"
provenance = "printed"
source = "Section 5."

[corner]
mass = { value = 2e3, unit = "kg", meaning = "same", provenance = "inferred", source = "Twice." }
grid = { value = [[1.0, 2], [3, 4]], unit = "m", meaning = "g", provenance = "ours", source = "-" }

[corner.centre]
value = [0, 0.5, 1]
unit = "m"
meaning = "a point"
provenance = "ours"
source = "Ours."
low = -1
high = 1
"""
MASS = 'mass = { value = 1.0, unit = "kg", meaning = "m", provenance = "ours", source = "Ours." }'


@pytest.fixture
def path(tmp_path):
    path = tmp_path / "parameters.toml"
    path.write_text(TEXT, "utf-8")
    return path


def test_values_have_the_types_of_the_file(path):
    p = read_parameters(path)
    assert (p.plant.mass, p["plant"]["rods"]) == (176.0, 12)
    assert isinstance(p.plant.rods, int)
    assert p.days.number == (80, 172)
    assert all(isinstance(x, int) for x in p.days.number)
    assert p.corner.centre == (0.0, 0.5, 1.0)  # one float among them: all are
    assert all(isinstance(x, float) for x in p.corner.centre)
    assert p.corner.grid == ((1.0, 2.0), (3.0, 4.0))
    assert list(p) == ["plant", "days", "corner"]
    assert dict(**p.plant) == {"mass": 176.0, "rods": 12}
    assert p.record("plant.mass") == Parameter(
        "plant", "mass", 176.0, "kg", "mass that a rod moves", "ours",
        "A third of a facet, a rod, a screw.", 1.0, 1e4,
    )  # fmt: skip


def test_what_is_not_there_is_told_with_what_is(path):
    p = read_parameters(path)
    with pytest.raises(AttributeError, match="no section 'plants'; there are plant, days, corner"):
        p.plants  # noqa: B018
    with pytest.raises(AttributeError, match="no 'mas' in their section; it has mass, rods"):
        p.plant.mas  # noqa: B018
    with pytest.raises(KeyError):
        p["plant"]["mas"]
    with pytest.raises(ParameterError, match="no section 'plan'\n  mend: choose from plant"):
        p.records(["plan"])


def test_they_can_be_copied(path):
    p = read_parameters(path).plant
    assert copy.copy(p).mass == 176.0
    assert pickle.loads(pickle.dumps(read_parameters(path).record("plant.rods"))).value == 12


def edited(old, new):
    assert old in MASS
    return f"[plant]\n{MASS.replace(old, new, 1)}"


WRONG = {
    "not TOML": ("[plant", "Expected ']'"),
    "no section": ("mass = 3.0", "'mass' is no section of parameters"),
    "no table": ("[plant]\nmass = 3.0", "'plant' is no section of parameters"),
    "a name of Python's": (edited("mass", "lambda"), "'lambda' cannot be"),
    "a name of a method": (edited("mass", "items"), "'items' cannot be"),
    "a section named like a method": (f"[record]\n{MASS}", "'record' cannot be"),
    "a hidden name": (edited("mass", "_mass"), "'_mass' cannot be"),
    "no value": (edited("value = 1.0, ", ""), "plant.mass has no value"),
    "an unknown key": (edited("meaning", "means"), "has an unknown 'means'"),
    "no unit": (edited("kg", ""), "has no unit\n  mend: write unit = "),
    "no meaning": (edited('meaning = "m", ', ""), "plant.mass has no meaning"),
    "no provenance": (
        edited('provenance = "ours", ', ""),
        "has no provenance\n  mend: write provenance = one of 'printed', 'inferred'",
    ),
    "another provenance": (edited('"ours"', '"mine"'), "provenance 'mine'"),
    "no source": (edited("Ours.", " "), "plant.mass has no source"),
    "words": (edited("1.0", '"one"'), "has the value 'one'"),
    "a truth value": (edited("1.0", "true"), "has the value True"),
    "infinite": (edited("1.0", "inf"), "has the value inf"),
    "nothing in it": (edited("1.0", "[]"), r"has the value \[\]"),
    "a bound of words": (edited("1.0", '1.0, low = "0"'), "has low = '0'"),
    "out of its bounds": (
        edited("1.0", "[1, 5], high = 3"),
        "plant.mass is 5 kg\n  mend: give at most 3 kg",
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_a_wrong_file_is_refused_with_the_mend(path, case):
    text, says = WRONG[case]
    path.write_text(text, "utf-8")
    with pytest.raises(ParameterError, match=says) as caught:
        read_parameters(path)
    assert str(path) in str(caught.value)
    assert caught.value.mend


def test_a_missing_file_is_told(tmp_path):
    with pytest.raises(ParameterError, match="there is no"):
        read_parameters(tmp_path / "parameters.toml")


def test_what_is_set_is_another_value_of_the_same_kind(path):
    p = read_parameters(path)
    set_ = with_settings(
        p, ["plant.mass=60", "rods=3", "number = 81,173", "centre=[0,0,.5]", "grid=[[1,2],[3,5]]"]
    )
    assert (set_.plant.mass, set_.plant.rods) == (60.0, 3)
    assert isinstance(set_.plant.mass, float)
    assert set_.days.number == (81, 173)
    assert set_.corner.centre == (0.0, 0.0, 0.5)
    assert set_.corner.grid == ((1.0, 2.0), (3.0, 5.0))
    assert set_.record("plant.mass").default == 176.0
    assert set_.record("corner.mass").default is None
    assert p.plant.mass == 176.0
    back = with_settings(p, ["plant.mass=60", "plant.mass=176"])
    assert back.record("plant.mass") == p.record("plant.mass")


SETTINGS = {
    "mass=60": "several parameters 'mass'\n  mend: write plant.mass or corner.mass",
    "rod=3": "no parameter 'rod'\n  mend: choose from rods",
    "rods": "--set rods\n  mend: write --set name=value",
    "rods=": "mend: write --set name=value",
    "plant.mass=heavy": "plant.mass cannot be heavy\n  mend: give a number in kg, as 176.0",
    "plant.mass=True": "plant.mass cannot be True",
    "plant.mass=1e999": "plant.mass cannot be 1e999",
    "plant.mass=1,2": "plant.mass cannot be 1,2",
    "plant.mass=0.5": "plant.mass is 0.5 kg\n  mend: give 1 to 10000 kg",
    "rods=2.5": "rods is a whole number, not 2.5\n  mend: .* write 12.0 in parameters.toml",
    "rods=0": "rods is 0\n  mend: give at least 1",
    "number=80": "number cannot be 80\n  mend: give 2 numbers",
    "number=80,172,266": "number cannot be 80,172,266",
    "centre=0,0,2": "centre is 2 m\n  mend: give -1 to 1 m",
}


@pytest.mark.parametrize("setting", SETTINGS)
def test_what_cannot_be_set_is_refused_with_the_mend(path, setting):
    with pytest.raises(ParameterError, match=SETTINGS[setting]):
        with_settings(read_parameters(path), [setting])


def test_what_is_read_is_heard_and_has_a_state(path):
    heard = []
    p = read_parameters(path).watched(heard.append)
    assert p.plant.mass
    assert heard == ["plant.mass"]
    dict(p.corner)
    assert heard[1:] == ["corner.", "corner.mass", "corner.grid", "corner.centre"]
    heard.clear()
    assert "speed" not in p.plant  # it might be there another time
    assert "wind" not in p
    p.record("plant.rods")
    assert heard == ["plant.", "", "plant.rods*"]
    p.records()
    assert len(heard) == 3

    other = with_settings(p, ["plant.mass=60"])
    assert [other.state(k) == p.state(k) for k in ("plant.mass", "corner.mass", "plant.", "")] == [
        False, True, True, True,
    ]  # fmt: skip
    path.write_text(TEXT.replace("Fig.", "Table."), "utf-8")
    other = read_parameters(path)
    assert other.state("plant.rods") == p.state("plant.rods")
    assert other.state("plant.rods*") != p.state("plant.rods*")
    assert other.state("plant.gone") == ""
    path.write_text(TEXT.replace("rods =", "bars ="), "utf-8")
    assert read_parameters(path).state("plant.") != p.state("plant.")


def test_bounds_in_words(path):
    p = read_parameters(path)
    assert bounds_text(p.record("plant.mass")) == "1 to 10000"
    assert bounds_text(p.record("plant.rods")) == "at least 1"
    assert bounds_text(p.record("days.number")) == ""
