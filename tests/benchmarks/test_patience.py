"""Slow rows: kept while nothing changes, measured anew otherwise, and given up in time."""

from dataclasses import replace

import pytest

from benchmarks import patience
from benchmarks.peers import peers
from benchmarks.recipes import KERNELS
from benchmarks.table import Row, load

SYMPY = next(peer for peer in peers() if peer.PEER.name == "SymPy")
K1, RECIPE = KERNELS["K1"], "text-book"


def row(**changes):
    digest = patience.digest(SYMPY, K1, RECIPE)
    made = Row("K1", "SymPy", "1", "cse", RECIPE, None, digest=digest)
    return replace(made, **changes)


def rows(committed, check):
    return patience.slow_rows(SYMPY, K1, RECIPE, committed, check=check)


@pytest.mark.parametrize("check", [True, False])
def test_a_row_that_would_come_out_the_same_is_kept(check):
    others = [row(kernel="K2"), row(tool="CasADi"), row(recipe="another")]
    assert rows([row(), *others], check) == [row()]


def test_a_check_takes_no_time_over_a_row_that_changed():
    assert rows([row(digest="of another recipe")], check=True) == []


@pytest.mark.tool
def test_a_row_that_changed_is_measured():
    found = rows([row(digest="of another recipe")], check=False)
    assert [r.options for r in found] == list(SYMPY.OPTIONS)
    assert all(r.counts.trig == 4 and r.digest == row().digest for r in found)


def test_what_is_not_ready_in_time_is_given_up():
    module = SYMPY.__name__
    assert patience.generate_in_time(module, "K4", "leg axes, differentiated", 1) == []


def test_slow_rows_of_the_page_are_up_to_date():
    committed = load()
    for tool, kernel, recipe in sorted(patience.SLOW):
        peer = next(p for p in peers() if p.PEER.name == tool)
        if not peer.PEER.installed:
            continue
        kept = patience.slow_rows(peer, KERNELS[kernel], recipe, committed, check=True)
        assert [r.options for r in kept] == sorted(peer.OPTIONS, key=list(peer.OPTIONS).index)
