"""The data of every kind of plot, and of tables, as CSV."""

import csv
import io

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
    Series,
)
from armillary.verify.studies.data import LONGEST, files, names, text_of
from armillary.verify.study import Absent, Column, Heading, ParameterTable, Prose, Table
from tests.site import figures


def rows(item) -> list[list[str]]:
    return list(csv.reader(io.StringIO(text_of(item))))


def test_a_table_keeps_its_digits_and_says_nothing_for_no_value():
    columns = ["day", Column("$\\Delta$, worst", "mrad", ".1f"), Column("n")]
    table = Table("c", columns, [["June, the longest", 1 / 3, 2], ["none", None, True]])
    assert rows(table) == [
        ["day", "$\\Delta$, worst, mrad", "n"],
        ["June, the longest", "0.333333333", "2"],
        ["none", "", "yes"],
    ]
    assert "\r" not in text_of(table)


def test_a_plot_has_a_row_for_each_point_of_each_curve_band_and_mark():
    plot = Plot(
        "c", "time, s", Axis("height, m"),
        [Curve("a", [0, 1], [2.5, None]), Curve("b", [3], [1e-9])],
        [Mark(0.5, "limit"), Mark(4, "", across=True)],
        [Band("spread", [0, 1], [1, 2], [3, 4])],
    )  # fmt: skip
    assert rows(plot) == [
        ["curve", "time, s", "height, m"],
        ["a", "0.0", "2.5"],
        ["a", "1.0", ""],
        ["b", "3.0", "1e-09"],
        ["spread, low", "0.0", "1.0"],
        ["spread, low", "1.0", "2.0"],
        ["spread, high", "0.0", "3.0"],
        ["spread, high", "1.0", "4.0"],
        ["limit", "", "0.5"],
        ["", "4.0", ""],
    ]


def test_a_histogram_and_bars():
    histogram = Histogram("c", "error, m", "share", [0, 1, 3], [Series("s", [0.25, 0.75])])
    assert rows(histogram) == [
        ["series", "error, m, from", "error, m, to", "share"],
        ["s", "0.0", "1.0", "0.25"],
        ["s", "1.0", "3.0", "0.75"],
    ]
    bars = Bars("c", "rod", "error, m", ["1", "2"], [Series("P", [1, 2]), Series("PID", [3, None])])
    assert rows(bars) == [
        ["series", "rod", "error, m"],
        ["P", "1", "1.0"],
        ["P", "2", "2.0"],
        ["PID", "1", "3.0"],
        ["PID", "2", ""],
    ]


def test_a_map_has_a_row_for_each_cell_and_each_point_of_its_curves():
    heat = HeatMap(
        "c", "x, m", "y, m", "f, N", [0, 1, 2], [5, 6], [[7, None]], curves=[Curve("way", [1], [5])]
    )
    assert rows(heat) == [
        ["x, m, from", "x, m, to", "y, m, from", "y, m, to", "f, N", "curve"],
        ["0.0", "1.0", "5.0", "6.0", "7.0", ""],
        ["1.0", "2.0", "5.0", "6.0", "", ""],
        ["1.0", "1.0", "5.0", "5.0", "", "way"],
    ]


def test_panels_have_a_column_more_and_name_axes_that_differ():
    plots = [
        Plot("left", "time, s", "height, m", [Curve("a", [0], [1])]),
        Plot("right", "way, m", "height, m", [Curve("a", [2], [3])]),
    ]
    assert rows(Panels("c", plots)) == [
        ["panel", "curve", "time, s / way, m", "height, m"],
        ["left", "a", "0.0", "1.0"],
        ["right", "a", "2.0", "3.0"],
    ]


@pytest.mark.parametrize("name", sorted(figures.ALL))
def test_every_kind_of_plot_has_data_of_one_width(name):
    (text,) = files([figures.ALL[name]()]).values()
    found = list(csv.reader(io.StringIO(text)))
    assert len(found) > 2
    assert len({len(row) for row in found}) == 1
    assert len(set(found[0])) == len(found[0])


def table(caption):
    return Table(caption, ["a"], [[1]])


def test_names_come_from_captions():
    items = [
        Heading("Of rods"), Prose("Words."), Absent("b", "gone"), ParameterTable("P."),
        table("Fig. 6 (a): rods through the $\\Delta_A$ day."), table("  Ünder 5 %! "), table("a."),
        table("A"), table("a"), table("…"),
    ]  # fmt: skip
    assert names(items) == [
        "", "", "", "", "fig-6-a-rods-through-the-delta-a-day.csv", "nder-5.csv", "a.csv",
        "a-2.csv", "a-3.csv", "data.csv",
    ]  # fmt: skip
    assert list(files(items)) == [name for name in names(items) if name]


def test_a_long_name_ends_with_a_whole_word():
    (name,) = names([table("x" * 40 + " " + "y" * 19 + " z")])
    assert name == "x" * 40 + "-" + "y" * 19 + ".csv"
    (name,) = names([table("x" * 40 + " " + "y" * 25)])
    assert name == "x" * 40 + ".csv"
    (name,) = names([table("x" * 90)])
    assert name == "x" * LONGEST + ".csv"
