"""What becomes of a mutant: seen, without effect, or no change at all."""

import pytest

from armillary.verify.measured import Measured
from mutation import judge as judging
from mutation.judge import EQUIVALENT, KILLED, ROOT, SURVIVED, UNCHANGED, failing, judge
from mutation.table import Row, lost, page, share

SOURCE = (ROOT / "derivations" / "equatorial" / "derivation.py").read_text()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("before", "after", "state"),
    [
        (".rotate(X, -incl", ".rotate(X, incl", KILLED),
        ("because=", "meaning='x', because=", KILLED),  # meaning is given twice: refused
        ("Chain(", "(Chain)(", UNCHANGED),
        (".translate(Z, L_1)", ".translate(Z, L_1 * 1 + 0 * L_1)", UNCHANGED),
        ("L_0)", "L_0 / 2 + L_0 / 2)", EQUIVALENT),
    ],
)
def test_judgement(before, after, state):
    assert before in SOURCE
    changed = SOURCE.replace(before, after, 1)
    assert judge("equatorial", "derivation.py", changed).state == state


def test_only_survivors_without_a_reason_are_lost(monkeypatch):
    rows = [
        Row("a", "f.py", 1, "flipped sign", "x", "-x", "survived", ""),
        Row("a", "f.py", 2, "flipped sign", "y", "-y", "survived", ""),
        Row("a", "f.py", 3, "flipped sign", "z", "-z", "killed", "a check"),
        Row("a", "f.py", 4, "flipped sign", "w", "-w", "equivalent", ""),
    ]
    monkeypatch.setattr("mutation.table.reasons", lambda: {rows[0].change: "It is even."})
    assert lost(rows) == [rows[1]]
    assert share(rows) == (1, 3)
    assert "It is even." in page(rows)
    assert "| a | 1 | 0 | 2 | 33.3% | 1 | 0 |" in page(rows)


def test_refusals_are_counted_apart():
    rows = [
        Row("a", "f.py", 1, "swapped factors", "R @ v", "v @ R", "killed", "refused: TypeError"),
        Row("a", "f.py", 2, "flipped sign", "y", "-y", "killed", "a check"),
        Row("a", "f.py", 3, "flipped sign", "z", "-z", "unchanged", ""),
    ]
    assert "| a | 2 | 1 | 0 | 100.0% | 0 | 1 |" in page(rows)


@pytest.mark.slow
def test_a_change_that_shows_at_few_points_is_no_equal():
    """A day without a night is rare: eight points of the range missed it."""
    source = (ROOT / "derivations" / "sun" / "horizon.py").read_text()
    before = "midnight_depth + noon_height < 0"
    assert before in source
    changed = source.replace(before, "midnight_depth < 0")
    assert judge("sun", "horizon.py", changed).state == SURVIVED


@pytest.mark.slow
def test_a_system_that_fails_as_it_stands_is_told(monkeypatch):
    assert failing("steady") == ("steady", "")
    wrong = Measured("always wrong", "nobody", None, 1, 1.0, 0.0, {}, "")
    monkeypatch.setattr(judging, "_checks", lambda *_: iter([wrong]))
    assert failing("steady") == ("steady", "always wrong [nobody]")
