"""Plots and tables as data: what cannot be shown is refused, and the message teaches."""

import math

import numpy as np
import pytest

from armillary.verify.plots import (
    Axis,
    Band,
    Bars,
    Curve,
    HeatMap,
    Histogram,
    Mark,
    Panels,
    Plot,
    PlotError,
    Series,
    centres,
    sky_map,
)
from armillary.verify.study import Column, Table, text_of

ONE, TWO = Curve("one", [0, 1], [1, 2]), Curve("two", [0], [1])
PLOT = Plot("c", "x", "y", [ONE])
BARS = Bars("c", "x", "y", ["g"], [Series("s", [1])])
LOG = Axis("y", log=True)


def test_arrays_become_plain_numbers():
    x = np.linspace(0, 1, 3, dtype=np.float32)
    curve = Curve("a", x, [np.float64(1 / 3), math.nan, None])
    assert curve.y == (0.333333333, None, None)  # 9 digits: the last bits of a machine do not show
    assert curve.x == (0.0, 0.5, 1.0)
    assert all(type(v) is float for v in curve.x)
    assert str(Curve("z", [0], [-0.0]).y[0]) == "0.0"


def test_an_axis_may_be_a_label():
    plot = Plot("c", "x", LOG, [ONE])
    assert plot.axes == (Axis("x"), LOG)
    assert plot == Plot("c", Axis("x"), LOG, (ONE,))


def test_centres():
    assert centres([0.0, 1.0, 3.0]) == [0.5, 2.0]


WRONG = {
    "infinity": (lambda: Curve("a", [0], [math.inf]), "y of the curve 'a' is infinite.*give None"),
    "unlike lengths": (lambda: Curve("a", [0, 1], [1]), "2 of x, 1 of y"),
    "a style": (lambda: Curve("a", [0], [1], "dots"), 'write "line", "points" or "both"'),
    "no curve": (lambda: Plot("c", "x", "y", []), "a plot of 0 curves"),
    "too many": (
        lambda: Plot("c", "x", "y", [Curve(str(k), [0], [1]) for k in range(7)]),
        "a plot of 7 curves\n  mend: give one to 6; spread more over panels",
    ),
    "one name twice": (lambda: Plot("c", "x", "y", [ONE, ONE]), "curves without names of"),
    "an empty curve": (
        lambda: Plot("c", "x", "y", [Curve("a", [], [])]),
        "the curve 'a' has nothing to draw",
    ),
    "a curve of gaps": (
        lambda: Plot("c", "x", "y", [Curve("a", [0, None], [None, 1])]),
        "the curve 'a' has nothing to draw",
    ),
    "zero on a logarithm": (
        lambda: Plot("c", "x", LOG, [Curve("a", [0, 1], [0, 1])]),
        "the curve 'a' is not positive everywhere.*give None where it is 0",
    ),
    "a band below zero": (
        lambda: Plot("c", "x", LOG, [ONE], bands=[Band("b", [0], [-1], [1])]),
        "the band 'b' is not positive",
    ),
    "equal units on a logarithm": (
        lambda: Plot("c", "x", LOG, [ONE], equal=True),
        "a plot with equal units on a logarithmic axis\n  mend: leave out equal=",
    ),
    "a mark at zero": (lambda: Plot("c", "x", LOG, [ONE], [Mark(0, "m")]), "m is not positive"),
    "a mark nowhere": (lambda: Mark(math.nan, "m"), "the mark 'm' has no value"),
    "no label": (lambda: Axis(" "), "an axis has no label"),
    "an axis turned round": (lambda: Axis("a", low=2, high=1), "runs from 2 to 1"),
    "a logarithm from zero": (lambda: Axis("a", log=True, low=0), "low= of the axis 'a'"),
    "bars without a number": (
        lambda: Bars("c", "x", "y", ["g", "h"], [Series("s", [1])]),
        "s: 1 for 2 groups",
    ),
    "six series": (
        lambda: Bars("c", "x", "y", ["g"], [Series(str(k), [1]) for k in range(6)]),
        "a plot of 6 series\n  mend: give one to 5",
    ),
    "edges that fall": (
        lambda: Histogram("c", "x", "y", [0, 2, 1], [Series("s", [1, 1])]),
        "edges= does not rise",
    ),
    "as many cells as edges": (
        lambda: Histogram("c", "x", "y", [0, 1, 2], [Series("s", [1, 1, 1])]),
        "s: 3 for 2 cells",
    ),
    "a short row": (
        lambda: HeatMap("c", "x", "y", "q", [0, 1, 2], [0, 1], [[1]]),
        "1 for 2 columns of cells",
    ),
    "no row": (lambda: HeatMap("c", "x", "y", "q", [0, 1], [0, 1], []), "0 for 1 rows of cells"),
    "a map of gaps": (
        lambda: HeatMap("c", "x", "y", "q", [0, 1], [0, 1], [[None]]),
        "the map of 'q' has nothing to draw",
    ),
    "levels that leave values out": (
        lambda: HeatMap("c", "x", "y", "q", [0, 1], [0, 1], [[5]], levels=[0, 1]),
        "runs from 5 to 5, its levels from 0 to 1",
    ),
    "too many levels": (
        lambda: HeatMap("c", "x", "y", "q", [0, 1], [0, 1], [[5]], levels=range(12)),
        "has 11 classes\n  mend: give at most 9",
    ),
    "radians in the sky": (
        lambda: sky_map("c", "q", [0, 361], [0, 90], [[1]]),
        "give the edges in degrees",
    ),
    "panels of nothing": (lambda: Panels("c", []), "panels without a plot"),
    "panels of two kinds": (
        lambda: Panels("c", [PLOT, BARS]),
        "panels of several kinds",
    ),
    "panels of other curves": (
        lambda: Panels("c", [PLOT, Plot("c", "x", "y", [TWO])]),
        "panels share one legend",
    ),
    "a table of nothing": (lambda: Table("c", ["a"], []), "a table of nothing"),
    "a row too short": (lambda: Table("c", ["a", "b"], [[1]]), "a row of 1 cells in a table of 2"),
    "an infinite cell": (lambda: Table("c", ["a"], [[math.inf]]), "the table 'c' is infinite"),
    "a format": (lambda: Column("a", format="three"), "the column 'a' has the format 'three'"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_cannot_be_shown_is_refused(case):
    make, says = WRONG[case]
    with pytest.raises(PlotError, match=f"(?s){says}"):
        make()


def test_cells_are_printed_as_one_reads_them():
    table = Table(
        "c", ["what", Column("n", "m", ".2f"), "x"],
        [["a", 1 / 3, 12345], ["b", math.nan, np.int64(7)], ["c", -2, 1.5e-7]],
    )  # fmt: skip
    assert table.texts() == [
        ["a", "0.33", "12345"],
        ["b", "–", "7"],
        ["c", "−2", "1.5·10⁻⁷"],
    ]
    assert [table.is_number(k) for k in range(3)] == [False, True, True]
    assert text_of(1.2e12, ".3g") == "1.2·10¹²"
    assert Table("c", ["a"], [[True]]).texts() == [["yes"]]
