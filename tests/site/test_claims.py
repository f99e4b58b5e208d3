"""Sentences of a paper as formulas."""

from armillary import Paper, sin
from armillary.site.claims import claim_latex
from armillary.site.notation import Notation
from armillary.site.structure import Structure


def formulas(paper, key):
    return list(claim_latex(paper.printed[key], Structure(Notation(paper))))


def test_figures_that_hang_on_what_is_not_printed():
    """The largest is over all but what is chosen; a value that nothing else moves has none."""
    p = Paper("swing", title="Swing")
    size = p.scalar("size", "its size", latex="a", range=(0.0, 2.0))
    t = p.scalar("t", "time", latex="t", range=(0.0, 3.0))
    p.hanging(
        "1", "q", {"the reach": (size * sin(t), 1, 1), "the size": (size, None, "0.5"),
                   "its square": (size**2, 2, 3)},
        on={size: 1}, words="a size of 1",
    )  # fmt: skip
    reach, alone, both = formulas(p, "1")
    assert reach.startswith(r"\max_{t} ")
    assert reach.endswith(" = 1")
    assert alone == r"a \le 0.5"
    assert both == r"2 \le {a}^2 \le 3"


def test_a_unit_of_the_nomenclature_stands_upright():
    p = Paper("swing", title="Swing")
    size = p.scalar("size", "its size", latex="a")
    wanted = {
        "N m^2": r"\mathrm{N}\,\mathrm{m}^{2}",
        "m^3/s": r"\mathrm{m}^{3}/\mathrm{s}",
        "/s^2": r"1/\mathrm{s}^{2}",
        "1": "1",
    }
    for unit, latex in wanted.items():
        p.in_unit(unit, "a row", size, unit)
        assert formulas(p, unit) == [rf"\left[a\right] = {latex}"]
