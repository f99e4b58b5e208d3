"""Units that a nomenclature prints: what holds, and the slip that explains what does not."""

import pytest

from armillary import Derivation, Paper, matrix, vector
from armillary.derivation.errors import DerivationError
from armillary.derivation.record import Used
from armillary.derivation.units import (
    KILOGRAM,
    METRE,
    NEWTON,
    NEWTON_METRE,
    SECOND,
    UnitError,
)
from armillary.verify.audit.audit import audit
from armillary.verify.audit.verdict import Verdict


@pytest.fixture
def wheel():
    """A paper on a wheel, whose quantities have the units that a test asks about."""
    d = Derivation("wheel", title="Wheel")
    p = Paper("wheel_paper")
    p.used["wheel"] = Used(d)
    p.of = {
        "turn": d.angle("turn", "turn"),
        "mass": d.scalar("mass", "mass", unit=KILOGRAM),
        "inertia": d.scalar("inertia", "inertia", unit=KILOGRAM * METRE**2),
        "moment": d.scalar("moment", "moment", unit=NEWTON_METRE),
        "pull": d.scalar("pull", "acceleration", unit=METRE / SECOND**2),
        "ratio": d.scalar("ratio", "ratio"),
        "force": d.define(
            "force", vector(1, 0, 0) * d.scalar("F_0", "force", unit=NEWTON), because="It pulls."
        ),
    }
    return p


def judged(paper, name, unit):
    paper.in_unit(name, f"{name} [{unit}]", paper.of[name], unit)
    return audit(paper)[-1]


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("turn", "deg"), ("turn", "rad"), ("mass", "kg"), ("inertia", "N m s^2"), ("moment", "N m"),
        ("pull", "m/s^2"), ("force", "kg m/s^2"), ("ratio", "1"),
    ],
)  # fmt: skip
def test_a_unit_that_holds(wheel, name, unit):
    found = judged(wheel, name, unit)
    assert found.verdict is Verdict.HOLDS
    assert found.readings[0].whole is None


@pytest.mark.parametrize(
    ("name", "unit", "words"),
    [
        ("moment", "N m^2", "N m for N m^2"),  # a power
        ("moment", "N", None),  # a factor is lost: no slip that is tried
        ("pull", "m^2/s", "m/s^2 for m^2/s"),  # powers exchanged
        ("inertia", "N m^2", "kg m^2 for N m^2"),  # another unit
        ("mass", "m", "kg for m"),
        ("force", "kg m/s", "kg m/s^2 for kg m/s"),
        ("turn", "m^2/s", None),
        ("mass", "1", None),
    ],
)
def test_the_smallest_slip(wheel, name, unit, words):
    found = judged(wheel, name, unit)
    (read,) = found.readings
    if words is None:
        assert found.verdict is Verdict.WRONG
        assert read.whole is None
    else:
        assert found.verdict is Verdict.MISPRINT
        assert (read.whole.kind, read.whole.words) == ("unit", words)
        assert words in found.says


def test_a_row_leads_to_the_definition(wheel):
    assert judged(wheel, "force", "N").claims == ("wheel-force",)
    assert judged(wheel, "mass", "kg").claims == ()


def test_the_entries_of_a_matrix_have_one_unit(wheel):
    F, m = wheel.of["force"].x, wheel.of["mass"]
    wheel.in_unit("both", "two forces [N]", matrix([F, 2 * F]), "N")
    found = audit(wheel)[-1]
    assert found.verdict is Verdict.HOLDS
    assert found.claims == ("wheel-force",)  # once, though both entries name it
    wheel.in_unit("mixed", "a force and a mass [N]", matrix([F, m]), "N")
    with pytest.raises(UnitError, match="mixed"):
        audit(wheel)


@pytest.mark.parametrize("text", ["", "furlong", "m^-2", "m/s/s", "m*s"])
def test_what_is_no_unit(wheel, text):
    with pytest.raises(DerivationError, match="no unit"):
        wheel.in_unit("mass", "mass", wheel.of["mass"], text)
