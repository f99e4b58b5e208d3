"""What the audit must find in Yu, (19) to (36), in Table 1 and in what the text says of a day."""

import pytest

from armillary.verify.audit.verdict import Verdict

HOLD = [
    "19'", "20", "20'''", "22", "23", "24", "26", "27", "27'", "28", "28'", "29", "30", "30'",
    "31''", "32 on the base of (1)", "33", "33''", "34", "35", "36", "table: I'_m",
    "table: Y axis", "table: y axis", "summer and winter", "daylight", "equinoxes", "Fig. 4",
    "Fig. 5", "Fig. 5'", "4.5 W of both", "mean force lower", "total lower",
]  # fmt: skip


@pytest.fixture
def yu(found):
    return found["yu"]


def only(finding):
    """The one repair of a finding with one reading."""
    (read,) = finding.readings
    (repair,) = {r for r in (read.whole, *(e.repair for e in read.entries)) if r}
    return repair


@pytest.mark.parametrize("key", HOLD)
def test_what_is_right_is_called_right(yu, key):
    assert yu[key].verdict is Verdict.HOLDS


# ---- dynamics ----


@pytest.mark.parametrize(("key", "place"), [("20'", "r_tic"), ("20''", "r_sic")])
def test_weight_that_has_a_moment_about_its_own_centre(yu, key, place):
    repair = only(yu[key])
    assert (yu[key].verdict, repair.kind) == (Verdict.MISPRINT, "term")
    assert f"the term {place} x" in repair.words
    assert "left out" in repair.words


def test_what_that_moment_does_to_the_forces(yu):
    """By virtual work the derived wrenches give the derived forces; those of (20) do not."""
    finding = yu["23 with (20)"]
    assert finding.verdict is Verdict.WRONG
    assert only(finding).words == "true of the moments without that of weight"
    assert finding.readings[0].worst > 50


def test_the_force_on_a_platform_whose_centre_is_not_o(yu):
    assert yu["19"].verdict is Verdict.WRONG
    assert only(yu["19"]).words == "true where v_s is the velocity of the centre of mass"


def test_legs_that_do_not_spin_ask_for_other_forces(yu):
    assert yu["23 with (10)"].verdict is Verdict.WRONG
    assert only(yu["23 with (10)"]).words == "true of a leg that does not spin about itself"


def test_a_matrix_that_is_not_singular(yu):
    finding = yu["singular"]
    assert finding.verdict is Verdict.WRONG
    assert finding.readings[0].worst > 0.01


# ---- the sun ----


@pytest.mark.parametrize(
    ("key", "words"),
    [
        ("25", "the factor 365 left out"),
        ("29'", "the dot product for the cross product of V_bj and V_sun"),
        ("29''", "arcsin for arccos"),
        ("32", "cos for sin of declination"),
        ("32'", "sin of latitude for cos of H"),
        ("33'", "the square of H_dot"),
        ("33'''", "the square of H_dot"),
    ],
)
def test_misprints_of_the_path(yu, key, words):
    assert yu[key].verdict is Verdict.MISPRINT
    assert only(yu[key]).words == words


def test_a_sun_that_stays_at_the_solstice(yu):
    assert yu["25"].readings[0].worst == pytest.approx(2 * 0.4093, abs=2e-3)  # 2 * 23.45 deg


@pytest.mark.parametrize("key", ["31", "31'"])
def test_the_base_of_one_equation_is_not_that_of_the_next(yu, key):
    assert yu[key].verdict is Verdict.WRONG
    assert only(yu[key]).words == "true on a base with X to the west and Y to the south"
    # The angles of (32) are no solution of (27) and (31): the tilt would have the other sign.
    assert yu["32 from (27) and (31)"].verdict is Verdict.SIGN
    assert only(yu["32 from (27) and (31)"]).words == "-beta_32 for beta_32 throughout"


def test_an_arc_tangent_that_knows_half_of_the_circle(yu):
    finding = yu["32 all day"]
    assert finding.verdict is Verdict.WRONG
    assert "the cosine of the derived angle is not negative" in only(finding).words
    assert finding.readings[0].worst > 3


def test_a_clock_that_is_no_sundial(yu):
    assert yu["26 by the clock"].verdict is Verdict.WRONG
    assert yu["26 by the clock"].readings[0].worst == pytest.approx(0.0698 + 0.0727, abs=1e-3)


# ---- Table 1 ----


@pytest.mark.parametrize(("key", "lack"), [("table: I'_t", 1.6), ("table: I'_s", 0.8)])
def test_moments_that_no_body_has(yu, key, lack):
    assert yu[key].verdict is Verdict.WRONG
    assert yu[key].readings[0].worst == pytest.approx(lack)


def test_centres_of_mass_beside_their_legs(yu):
    assert only(yu["table: r'_tc"]).words == "rows 1 and 2 exchanged"
    assert yu["table: r'_sc"].verdict is Verdict.WRONG


# ---- what the text says of the equinox ----


@pytest.mark.parametrize(
    ("key", "printed", "at_o"), [("80 N", "80 N", 26.8), ("4.5 W", "1", 28.2), ("1.4 W", "", 28.2)]
)
def test_figures_that_the_mass_centre_decides(yu, key, printed, at_o):
    """With it at o they do not come out, and elsewhere they do."""
    finding = yu[key]
    assert finding.verdict is Verdict.NOT_CHECKABLE
    assert "With the mass centre at o, which the paper does not print" in finding.says
    assert f" is {at_o}" in finding.says
    assert "y_c = " in finding.says
    assert f"stated is {printed}" in finding.says


def test_peak_and_means_that_no_mass_centre_gives(yu):
    finding = yu["30 N"]
    assert finding.verdict is Verdict.WRONG
    assert "the mean force of leg 1 is 6.6" in finding.says
    assert "No choice within" in finding.says
    assert 5 < finding.readings[0].worst < 8  # newtons off, at the nearest


@pytest.mark.parametrize("key", ["80 N with two", "36 N", "3.8 W", "79.8 kJ"])
def test_figures_of_two_legs_that_have_no_bound(yu, key):
    """Their determinant has both signs: that proves it, no largest sample does."""
    assert yu[key].verdict is Verdict.WRONG
    assert "is -0.0095 to 0.0" in yu[key].says
    assert "inf" not in yu[key].says


def test_what_two_legs_must_do_where_they_cannot(yu):
    """A force has a bound where the determinant is 0 only if nothing is asked along that motion."""
    finding = yu["36 N where the determinant is 0"]
    assert finding.verdict is Verdict.WRONG
    assert finding.readings[0].worst > 15  # newton metres


def test_the_lower_mean_and_the_lower_total(yu):
    for key in ("mean force lower", "total lower"):
        assert yu[key].verdict is Verdict.HOLDS
        assert "with the mass centre at o" in yu[key].says


@pytest.mark.parametrize("key", ["5", "6'", "10", "12", "20'", "23 with (20)", "singular"])
def test_counterexamples_stand_at_table_1(yu, key):
    (read,) = yu[key].readings
    at = read.counterexample.at
    table = {"r": [0.3] * 3, "R": [0.6, 0.6, 0.4], "h": [0.6, 0.6, 0.0], "m_t": [11.0] * 3}
    met = set(at) & set(table)
    assert met
    assert {name: at[name] for name in met} == {name: table[name] for name in met}
