"""`python -m benchmarks --check` tells what differs."""

from dataclasses import replace

import pytest

from benchmarks.__main__ import check
from benchmarks.table import load

ROWS = load()


def test_the_same_rows_pass():
    assert check(ROWS, ROWS) == 0


@pytest.mark.parametrize("finished", [True, False])
def test_a_missing_row_fails(finished, capsys):
    row = next(r for r in ROWS if (r.counts is not None) == finished)
    assert check([r for r in ROWS if r is not row], ROWS) == 1
    assert row.recipe in capsys.readouterr().out


def test_another_count_fails(capsys):
    row = next(r for r in ROWS if r.counts is not None)
    other = replace(row, counts=replace(row.counts, mul=row.counts.mul + 1))
    assert check([other if r is row else r for r in ROWS], ROWS) == 1
    assert "1 of" in capsys.readouterr().out
