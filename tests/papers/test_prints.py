"""The prints of this project's papers: all of them are there, and what the audit finds in them."""

import re

import pytest

from armillary.derivation.paper import Equation, Unchecked
from armillary.derivation.ranges import Hanging
from armillary.verify.audit.verdict import Verdict

# The numbers in the order printed; a number that stands twice, or over two lines, comes twice.
NUMBERS = {
    "ky": [
        "01", "02", "03", "04", "05", "06", "07", "08", "09", "09'", "10", "11", "11'", "12", "13",
        "14", "15", "16", "17", "18", "19", "20", "21", "22",
    ],
    "musabekov2018": [
        "1", "2", "3", "4", "5", "5'", "6", "7", "8", "9", "10", "11", "11'", "12", "13", "14",
        "15", "16", "17", "18", "19", "20",
    ],
    "mo2023": [str(k) for k in range(1, 40)],
    "salgado2014": ["1", "2", "3"],
    "yu": [str(k) for k in range(1, 37)],
}  # fmt: skip
NAMES_ONLY = {
    "ky": {"04", "07"},
    "musabekov2018": {"1", "2", "4"},
    "mo2023": {"10", "12", "19", "36", "39", "steady error"},
    "salgado2014": {"3", "unit t", "unit d_rec", "degrees", "no row"},
    "yu": {"21", "table: rows", "Fig. 7", "mechanical power", "Fig. 8", "62.1 kJ"},
}
# Prints that something decides which is not printed.
DECIDED = {"yu": {"80 N", "4.5 W", "1.4 W"}}


@pytest.mark.parametrize("name", NUMBERS)
def test_every_numbered_equation_is_printed_in_its_place(papers, name):
    keys = list(papers[name].printed)
    assert [key for key in keys if key in NUMBERS[name]] == NUMBERS[name]
    others = {key for key in keys if re.fullmatch(r"\d+'*", key)} - set(NUMBERS[name])
    # A second reading of a table or the other half of a double equation is an entry of its own.
    assert all(key.endswith("'") and key.rstrip("'") in NUMBERS[name] for key in others)


@pytest.mark.parametrize("name", NUMBERS)
def test_only_what_names_things_goes_unchecked(papers, found, name):
    unchecked = {k for k, made in papers[name].printed.items() if isinstance(made, Unchecked)}
    assert unchecked == NAMES_ONLY[name]
    open_ = {k for k, f in found[name].items() if f.verdict is Verdict.NOT_CHECKABLE} - unchecked
    assert open_ == DECIDED.get(name, set())
    assert all(isinstance(papers[name].printed[key], Hanging) for key in open_)
    assert all(found[name][key].says for key in unchecked)


@pytest.mark.parametrize("name", NUMBERS)
def test_what_is_not_printed_decides(papers, found, name):
    """What is assumed gives another figure, and another choice in the range the one stated."""
    for key in DECIDED.get(name, set()):
        says = found[name][key].says
        assert "which the paper does not print" in says, key
        assert "what is not printed decides" in says, key


@pytest.mark.parametrize("name", NUMBERS)
def test_what_the_lost_figures_leave_open_is_stated(papers, name):
    assert any("figures are lost" in sentence for sentence in papers[name].assumptions)


@pytest.mark.parametrize("name", NUMBERS)
def test_a_print_stands_beside_something_else(papers, name):
    """A claim and its print are two expressions: a print may not be the definition itself."""
    for key, made in papers[name].printed.items():
        if isinstance(made, Equation):
            assert all(made.claims is not r.printed for r in made.readings), key


@pytest.mark.parametrize("name", NUMBERS)
def test_what_fails_has_a_number_that_shows_it(found, name):
    for key, f in found[name].items():
        if f.verdict in (Verdict.HOLDS, Verdict.NOT_CHECKABLE):
            continue
        failing = [r for r in f.readings if r.verdict is not Verdict.HOLDS]
        shown = [r.counterexample for r in failing if r.counterexample is not None]
        assert shown or re.search(r"\d", f.says), key
        assert all(abs(c.error) > 0 for c in shown), key


def test_no_paper_is_left_out(papers):
    assert set(papers) == set(NUMBERS)


# -- what the audit must find by itself ------------------------------------------------------


def verdicts(finding):
    return {r.reading: r.verdict for r in finding.readings}


def repairs(finding):
    """All repairs of a finding: those of the whole and those of entries."""
    return [
        r for read in finding.readings for r in (read.whole, *(e.repair for e in read.entries)) if r
    ]


def test_a_matrix_that_is_not_orthonormal(found):
    for key in ("8", "9"):
        finding = found["musabekov2018"][key]
        assert finding.verdict is Verdict.WRONG
        (read,) = finding.readings
        assert any("not orthonormal" in told for told in read.properties)
        assert 0.2 < read.worst < 0.3  # sin(0.3), the end of the range of chi
        wrong = {(e.row, e.column) for e in read.entries if e.verdict is Verdict.WRONG}
        mirrored = {(j, i) for i, j in wrong}
        assert {(1, 1), (1, 2), (3, 1), (3, 2)} in (wrong, mirrored)


@pytest.mark.parametrize("key", ["11", "11'"])
def test_a_formula_that_is_true_at_noon_only(found, key):
    finding = found["ky"][key]
    assert finding.verdict is Verdict.WRONG
    (repair,) = repairs(finding)
    assert repair.kind == "special value"
    assert "hour_angle = 0" in repair.words
    assert finding.readings[0].worst > 1.5


def test_a_translation_column_that_belongs_to_another_product(found):
    finding = found["ky"]["15"]
    assert finding.verdict is Verdict.WRONG
    (repair,) = repairs(finding)
    assert repair.kind == "order of factors"
    assert "translation column" in repair.words
    assert "L_1" in repair.words
    assert "upsilon" in repair.words
    bad = {(e.row, e.column) for e in finding.readings[0].entries if e.verdict is not Verdict.HOLDS}
    assert bad == {(1, 4), (2, 4), (3, 4)}


@pytest.mark.parametrize("key", ["16", "19"])
def test_angular_velocities_in_another_frame_with_another_sign(found, key):
    finding = found["ky"][key]
    assert finding.verdict is Verdict.WRONG
    (repair,) = repairs(finding)
    assert repair.kind == "frame"
    assert "minus" in repair.words
    assert "Omega_body" in repair.words


def test_an_angular_velocity_with_a_sign_and_perhaps_a_dot(found):
    finding = found["ky"]["22"]
    assert verdicts(finding) == {"with a dot": Verdict.SIGN, "without": Verdict.MISPRINT}
    assert any("lost dot" in r.kind and "sign" in r.kind for r in repairs(finding))


def test_a_sine_for_a_cosine(found):
    finding = found["ky"]["12"]
    assert finding.verdict is Verdict.MISPRINT
    (repair,) = repairs(finding)
    assert repair.kind == "function"
    assert repair.words == "sin for cos of hour_angle"


def test_a_word_for_another_word(found):
    finding = found["musabekov2018"]["singular"]
    assert finding.verdict in (Verdict.WRONG, Verdict.MISPRINT)
    assert "orthogonal" in finding.says
    assert "determinant" in finding.says


def test_a_dot_that_stands_on_one_of_two_factors(found):
    assert verdicts(found["ky"]["09"]) == {
        "dot on Rot": Verdict.SIGN,
        "dot on Rot^T": Verdict.HOLDS,
    }
    assert verdicts(found["ky"]["09'"]) == {
        "dot on the last T": Verdict.HOLDS,
        "dot on the first T": Verdict.WRONG,
    }


def test_conclusions_that_fail(found):
    chi = found["musabekov2018"]["chi"]
    assert chi.verdict is Verdict.WRONG
    assert "1 times" in chi.says  # as large as the effects that must be taken into account
    assert found["musabekov2018"]["theta and psi"].verdict is Verdict.HOLDS
    assert found["musabekov2018"]["all stars"].verdict is Verdict.WRONG
    assert found["ky"]["declination speed"].verdict is Verdict.WRONG


def test_a_neighbouring_index(found):
    for key, reading in {"13": "n_zeta first, psi", "16": "n_xi * theta"}.items():
        finding = found["musabekov2018"][key]
        assert verdicts(finding)[reading] is Verdict.MISPRINT
        made = [r for r in repairs(finding) if r.kind == "index"]
        assert made
        assert all("n_xi" in r.words and "n_zeta" in r.words and r.order == 1 for r in made)


def test_orders_in_the_small_angles(found):
    prints = found["musabekov2018"]
    assert prints["6"].label == prints["7"].label == "holds to order 1"
    assert any("mixed order" in told for told in prints["6"].readings[0].properties)
    assert prints["7'"].verdict is Verdict.MISPRINT
    assert prints["7'"].readings[0].whole.kind == "transposition"


def test_an_arc_sine_that_knows_half_the_circle(found):
    finding = found["musabekov2018"]["20"]
    assert found["musabekov2018"]["19"].verdict is Verdict.HOLDS
    assert finding.verdict is Verdict.WRONG
    (repair,) = repairs(finding)
    assert "chi = 0" in repair.words
    assert "cosine" in repair.words
    assert finding.readings[0].worst > 3


def test_names_against_products(found):
    assert found["ky"]["ZYX"].verdict is Verdict.HOLDS
    assert "axis y for x" in repairs(found["ky"]["ZYZ"])[0].words
    assert found["ky"]["T&T"].verdict is Verdict.WRONG
    assert found["ky"]["ZXX"].verdict is not Verdict.HOLDS
    assert found["ky"]["3 angles BRYANT"].verdict is Verdict.HOLDS
    lebian = found["ky"]["3 angles LEBIAN"]
    assert lebian.verdict is Verdict.WRONG
    assert "rank 2" in lebian.says


# -- Mo et al. -------------------------------------------------------------------------------


@pytest.fixture
def mo(found):
    return found["mo2023"]


def bad_places(finding):
    """The entries that fail, of a print with one reading."""
    (read,) = finding.readings
    return {(e.row, e.column) for e in read.entries if e.verdict is not Verdict.HOLDS}


def test_an_element_that_repeats_another(mo):
    finding = mo["13 elements"]
    assert finding.verdict is Verdict.MISPRINT
    assert bad_places(finding) == {(3, 2)}
    (repair,) = repairs(finding)
    assert (repair.kind, repair.words) == ("copy", "repeats entry (2, 3)")
    assert mo["cosines"].verdict is Verdict.WRONG  # with that element n, o, a are no axes


def test_a_row_of_cosines(mo):
    assert bad_places(mo["8"]) == {(2, 1), (2, 4)}
    assert {r.words for r in repairs(mo["8"])} == {"sin for cos of phi"}


@pytest.mark.parametrize("key", ["planes", "from the planes"])
def test_the_frame_in_which_the_planes_stand(mo, key):
    assert mo[key].verdict is Verdict.WRONG
    (repair,) = repairs(mo[key])
    assert (repair.kind, repair.words) == ("frame", "true of the components in {P}")


def test_a_condition_that_is_not_imposed(mo):
    """The planes give three conditions; two are solved for x and y, and the third fails."""
    assert mo["14, 15 from (13)"].verdict is Verdict.HOLDS
    assert mo["third plane"].verdict is Verdict.WRONG
    assert mo["joints"].readings[0].worst > 0.1
    assert repairs(mo["13"])[0].words == "holds only where beta = 0"
    assert repairs(mo["14 in {P}"])[0].words == "holds only where beta = 0"
    assert {mo[key].verdict for key in ("14", "15", "13'")} == {Verdict.WRONG}


def test_the_sign_of_the_horizontal_direction(mo):
    assert mo["axis by (16)"].verdict is Verdict.HOLDS
    finding = mo["axis by (16), (29)"]
    assert finding.verdict is Verdict.SIGN
    assert bad_places(finding) == {(1, 1), (2, 1)}
    assert verdicts(mo["16"]) == {
        "gamma_s from the north, clockwise": Verdict.HOLDS,
        "gamma_s by (29), from the south": Verdict.SIGN,
    }
    assert repairs(mo["29'"])[0].words == "what is derived and 180 deg more"


def test_misprints_of_rates(mo):
    assert bad_places(mo["23'"]) == {(3, 1)}  # the height depends on alpha
    assert bad_places(mo["23''"]) == {(1, 1), (3, 1)}
    assert [r.words for r in repairs(mo["23''"])] == ["k_3 for k_1"]
    assert repairs(mo["25"])[0].words.startswith("dish_3rps-Omega_O")
    assert [r.words for r in repairs(mo["27"])] == ["z_dot for z_O"]
    assert bad_places(mo["17"]) == {(4, 1)}


def test_numbers_and_units_of_the_almanac(mo):
    wanted = {
        "30": "0.002697 for 0.002679",
        "32": "E_t divided by 60",
        "34": "0.040849 for 0.0409",
        "3": "x_m for y_m",
        "from {P} to {H}": "Rz(-(phi - pi)) turning the other way",
    }
    assert {key: repairs(mo[key])[0].words for key in wanted} == wanted


def test_claims_of_the_days(mo):
    held = ("solstices", "shortest, longest", "two sections", "rod 1")
    assert {mo[key].verdict for key in held} == {Verdict.HOLDS}
    failed = ("monotonic", "afternoon", "59 deg", "four extremes", "35", "35'", "35''")
    assert {mo[key].verdict for key in failed} == {Verdict.WRONG}
    assert 20 < mo["59 deg"].readings[0].worst < 35  # degrees beyond the cone
    assert 0.1 < mo["rods in {H}"].readings[0].worst < 0.3
    assert 0.03 < mo["rods in {P}"].readings[0].worst < 0.1


HOLD = {
    "ky": ["02", "03", "05", "06", "08", "10", "13", "14", "17", "18", "20", "21", "antisymmetric"],
    "musabekov2018": ["3", "5", "5'", "10", "12", "12'", "15", "18'", "19", "clockwise"],
    "mo2023": [
        "1", "2", "4", "5", "6", "7", "9", "11", "11'", "16'", "16''", "18", "20", "21", "22",
        "23'''", "28", "29", "31", "33", "37", "14, 15 from (13)", "morning", "two sections",
    ],
    "salgado2014": ["incidence", "principle", "imbalance", "1", "unit F_1", "unit theta"],
    "yu": [
        "1", "2", "3", "4", "6", "7", "8", "8'", "9", "10'", "11", "13", "15", "18'", "rotations",
        "x axis", "y axis",
    ],
}  # fmt: skip


@pytest.mark.parametrize("name", HOLD)
def test_what_is_right_is_called_right(found, name):
    assert {key: found[name][key].label for key in HOLD[name]} == dict.fromkeys(HOLD[name], "holds")


@pytest.mark.parametrize("name", NUMBERS)
def test_the_whole_list_of_findings(found, name, golden):
    golden(f"{name}.txt", "".join(f"{line}\n" for f in found[name].values() for line in told(f)))


def told(finding):
    """Verdicts of readings and entries and the repairs: what a changed print would change."""
    yield f"({finding.key}) {finding.label}"
    if finding.quote and not any(read.entries for read in finding.readings):
        yield f"  {finding.says}"
    for read in finding.readings:
        entries = " ".join(short(e) for e in read.entries)
        yield f"  {read.reading or 'as printed'}: {read.verdict}, {read.worst:.2g} off: {entries}"
        for repair in (read.whole, *(e.repair for e in read.entries)):
            if repair:
                yield f"    {repair.kind}: {repair.words}"


def short(entry):
    letter = {"holds": "=", "holds to order": "o", "sign": "-", "misprint": "m"}
    return letter.get(entry.verdict, "x") + ("" if entry.order is None else str(entry.order))
