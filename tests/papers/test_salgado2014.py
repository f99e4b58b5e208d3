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
    others = [f.verdict for key, f in units.items() if key not in UNITS and key != "unit d_rec"]
    assert set(others) == {Verdict.HOLDS}
    assert len(others) == 20


def test_a_rate_in_radians_of_an_angle_in_degrees(salgado):
    (entry,) = salgado["degrees"].readings[0].entries
    assert entry.repair.words == "the divisor degree left out"
    at = salgado["degrees"].readings[0].counterexample
    assert at.printed / at.derived == pytest.approx(57.29577951308232)


def test_the_balance_lacks_what_the_water_needs(salgado):
    """However its acceleration is read, it is true only where nothing moves."""
    finding = salgado["2"]
    assert finding.verdict is Verdict.WRONG
    assert len(finding.readings) == 2
    for read in finding.readings:
        assert read.whole.words == "true of a trough at rest with an empty tube"
        assert read.worst > 10  # newtons


def test_the_weight_of_the_water_in_the_tube(salgado):
    (entry,) = salgado["2 at rest"].readings[0].entries
    assert salgado["2 at rest"].verdict is Verdict.MISPRINT
    assert entry.repair.words == "g m_t added"


def test_forces_on_the_containers_for_weights(salgado):
    """As forces they mend the balance along j but for the tube; along i there are none."""
    assert whole(salgado["2 along j"]).words == "true of an empty tube"
    assert salgado["2 along i"].verdict is Verdict.WRONG
    assert whole(salgado["2 along i"]).words == "true of a trough without water"


def test_the_moment_equation_is_lost(salgado):
    assert salgado["3"].verdict is Verdict.NOT_CHECKABLE
    assert "lost" in salgado["3"].says
