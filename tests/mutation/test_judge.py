"""What becomes of a mutant: seen, without effect, or no change at all."""

import pytest

from mutation.judge import EQUIVALENT, KILLED, ROOT, UNCHANGED, judge
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
    assert "| a | 1 | 2 | 33.3% | 1 |" in page(rows)
