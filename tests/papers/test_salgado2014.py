"""What the audit finds in Salgado Conrado et al.: units, and what the balance of forces lacks."""

import pytest

from armillary.verify.audit.verdict import Verdict

UNITS = {
    "unit a": "m/s^2 for m^2/s",
    "unit M_FA": "N m for N m^2",
    "unit M_FB": "N m for N m^2",
    "unit I_zz": "kg m^2 for N m^2",
}


@pytest.fixture
def salgado(found):
    return found["salgado2014"]


def whole(finding):
    (read,) = finding.readings
    return read.whole


def test_units_that_are_no_unit_of_what_they_stand_beside(salgado):
    units = {key: f for key, f in salgado.items() if key.startswith("unit ")}
    wrong = {key: f for key, f in units.items() if f.verdict is Verdict.MISPRINT}
    assert {key: whole(f).words for key, f in wrong.items()} == UNITS
    unjudged = {key for key, f in units.items() if f.verdict is Verdict.NOT_CHECKABLE}
    assert unjudged == {"unit t", "unit d_rec"}
    others = [f.verdict for key, f in units.items() if key not in {*UNITS, *unjudged}]
    assert set(others) == {Verdict.HOLDS}
    assert len(others) == 20


def test_a_row_of_three_moments_of_inertia_is_judged_by_all_three(papers):
    (row,) = papers["salgado2014"].printed["unit I_zz"].value.rows
    assert [entry.name for entry in row] == ["I_xx", "I_yy", "inertia"]


CONCENTRATOR, ALL = "M the concentrator's mass", "M the mass of all that moves"
ITS_OWN, OF_ALL = (
    "a of the concentrator's centre of mass", "a of the mass centre of trough and water"
)  # fmt: skip
ONCE = "true without F_1 and F_2: M has the mass of the water already"
DRY = "true of a trough without water"


def explained(finding):
    """What each reading is true of, its repair where it is a misprint, None where it holds."""
    repairs = {
        r.reading: r.whole or next((e.repair for e in r.entries if e.repair), None)
        for r in finding.readings
    }
    return {reading: repair and repair.words for reading, repair in repairs.items()}


def test_the_balance_lacks_what_the_water_needs(salgado):
    """However M and a are read, it is true at rest only, or has the water's weight twice."""
    finding = salgado["2"]
    assert finding.verdict is Verdict.WRONG
    at_rest = "true of a trough at rest with an empty tube"
    assert explained(finding) == {
        f"{CONCENTRATOR}, {ITS_OWN}": at_rest,
        f"{CONCENTRATOR}, {OF_ALL}": at_rest,
        f"{ALL}, {ITS_OWN}": ONCE.replace("true", "true at rest"),
        f"{ALL}, {OF_ALL}": ONCE,
    }
    assert min(read.worst for read in finding.readings) > 10  # newtons


def test_with_all_mass_only_the_weight_is_wrong(salgado):
    """The part of (2) along i, and that across, hold then."""
    read = salgado["2"].readings[-1]
    assert [e.verdict for e in read.entries] == [Verdict.HOLDS, Verdict.WRONG, Verdict.HOLDS]


def test_the_weight_of_the_water_in_the_tube(salgado):
    """It is lost where M is the concentrator's; the other water's is double where M is of all."""
    finding = salgado["2 at rest"]
    assert finding.verdict is Verdict.AMBIGUOUS
    assert explained(finding) == {CONCENTRATOR: "g m_t added", ALL: ONCE}


def test_forces_on_the_containers_for_weights(salgado):
    """They mend the balance along j but for the tube; along i they are lost."""
    along_j, along_i = salgado["2 along j"], salgado["2 along i"]
    assert along_j.verdict is Verdict.WRONG
    assert explained(along_j) == {
        f"{CONCENTRATOR}, {ITS_OWN}": "true of an empty tube",
        f"{CONCENTRATOR}, {OF_ALL}": DRY,
        f"{ALL}, {ITS_OWN}": DRY,
        f"{ALL}, {OF_ALL}": ONCE,
    }
    assert along_i.verdict is Verdict.AMBIGUOUS
    assert explained(along_i) == {
        f"{CONCENTRATOR}, {ITS_OWN}": DRY,
        f"{CONCENTRATOR}, {OF_ALL}": DRY,
        f"{ALL}, {ITS_OWN}": "a_held_x for a_c_x",
        f"{ALL}, {OF_ALL}": None,
    }


def test_what_nothing_left_decides_is_no_finding(salgado):
    """Degrees beside radians: no printed equation joins the two."""
    assert salgado["degrees"].verdict is Verdict.NOT_CHECKABLE
    assert "180/pi" in salgado["degrees"].says


def test_the_moment_equation_is_lost(salgado):
    assert salgado["3"].verdict is Verdict.NOT_CHECKABLE
    assert "lost" in salgado["3"].says
