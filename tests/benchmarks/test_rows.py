"""What the page may be quoted for; `python -m benchmarks --check` tells that its rows are so."""

import pytest

from benchmarks.recipes import KERNELS
from benchmarks.table import OURS, PAGE, STEP, WHOLE, Row, load, to_json, to_markdown
from benchmarks.yardstick import TOOL

ROWS = load()


def only(kernel, tool, stage=WHOLE):
    """The counts of one row."""
    (found,) = [r for r in ROWS if (r.kernel, r.tool, r.stage) == (kernel, tool, stage)]
    return found.counts


def test_the_page_shows_the_rows():
    assert PAGE.read_text() == to_markdown(ROWS)


@pytest.mark.parametrize("kernel", KERNELS)
def test_no_peer_needs_less(kernel):
    others = [r for r in ROWS if r.kernel == kernel and r.tool not in (OURS, TOOL)]
    assert others
    assert all(r.counts is None or r.counts.cost > only(kernel, OURS).cost for r in others)


def test_legs_are_as_cheap_as_by_hand():
    counts = only("K3", OURS)
    assert counts.flops <= 160
    assert counts.div <= 3
    assert counts.sqrt <= 3


def test_forces_are_nearly_as_cheap_as_by_hand():
    assert only("K4", OURS).cost <= 1.15 * only("K4", TOOL).cost


def test_steps_leave_the_mount_behind():
    assert only("K2", OURS, STEP).flops <= 50
    for kernel in ("K2", "K4"):
        assert only(kernel, OURS, STEP).trig == 4


def test_rows_survive_their_file(tmp_path):
    unfinished = Row("K1", "SymPy", "1", "cse", "text-book", None, digest="0")
    path = tmp_path / "results.json"
    path.write_text(to_json([*ROWS, unfinished]))
    assert set(load(path)) == {*ROWS, unfinished}
