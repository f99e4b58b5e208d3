"""Plots: the same bytes everywhere, no colours of their own, nothing beyond the paper."""

import math
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from itertools import pairwise

import pytest

from armillary.site.plots import plot_html
from armillary.site.plots.axes import PANEL, WHOLE, label_of, log_ticks, scale, ticks
from armillary.site.plots.levels import Classes, classes_of
from armillary.site.plots.maps import at
from armillary.verify.plots import Axis, Curve, HeatMap, Mark, Panels, Plot
from tests.site import figures
from tests.site.conftest import ROOT

THEME = ROOT / "armillary" / "site" / "theme" / "css"
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")
SCRIPT = """
import hashlib
from armillary.site.plots import plot_html
from tests.site.figures import ALL
for name, make in ALL.items():
    print(name, hashlib.sha256(plot_html(make(), "p").encode()).hexdigest())
"""


@pytest.fixture(params=sorted(figures.ALL))
def html(request) -> str:
    return plot_html(figures.ALL[request.param](), f"p-{request.param}")


def svgs(html: str) -> list[ET.Element]:
    return list(ET.fromstring(f"<div>{html}</div>").iter("svg"))


@pytest.mark.parametrize("name", sorted(figures.ALL))
def test_drawings_stay_as_they_are(name, golden):
    text = plot_html(figures.ALL[name](), name).replace("><", ">\n<")
    golden(f"plot_{name}.svg", text + "\n")


def test_the_bytes_do_not_depend_on_the_hash_seed():
    told = []
    for seed in ("0", "1"):
        environment = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONHASHSEED": seed}
        done = subprocess.run(
            [sys.executable, "-c", SCRIPT],
            capture_output=True, text=True, env=environment, cwd=ROOT, check=True,
        )  # fmt: skip
        told.append(done.stdout)
    assert told[0] == told[1]
    assert told[0].count("\n") == len(figures.ALL)


def test_the_page_gives_the_colours(html):
    assert not re.search(r"#[0-9a-f]{3}|(?:fill|stroke|style|color)=|rgb|nan|inf\b|None", html)
    sheet = (THEME / "figures.css").read_text("utf-8")
    for kind in {c for found in re.findall(r'class="([^"]+)"', html) for c in found.split()}:
        known = f".{kind}" in sheet or f'[class^="{kind.split("-")[0]}-"]' in sheet
        assert known, f"the theme does not say what {kind} looks like"


def test_nothing_stands_beyond_the_paper(html):
    for svg in svgs(html):
        left, top, width, height = map(float, svg.get("viewBox").split())
        for element in svg.iter():
            for x, y in points(element):
                assert left <= x <= left + width, ET.tostring(element)
                assert top <= y <= top + height, ET.tostring(element)


def points(element):
    """Places that are absolute: ends of lines, begins of markers, labels."""
    if element.get("x"):
        yield float(element.get("x")), float(element.get("y"))
    path = element.get("d") or ""
    for found in re.findall(rf"[ML]({NUMBER.pattern}) ({NUMBER.pattern})", path):
        yield float(found[0]), float(found[1])


def test_it_can_be_listened_to(html):
    found = svgs(html)
    ids = [e.get("id") for svg in found for e in svg.iter() if e.get("id")]
    assert len(ids) == len(set(ids))
    for svg in found:
        assert svg.get("role") == "img"
        for label in svg.get("aria-labelledby").split():
            (named,) = [e for e in svg.iter() if e.get("id") == label]
            assert named.text.strip()


def test_the_words_tell_the_numbers():
    assert "azimuth 1.25, elevation 0.75, both 1.46" in plot_html(figures.bars(), "p")
    described = plot_html(figures.line(), "p")
    assert "sine from −1 to 1" in described
    assert "line at 0.8: limit &lt;one&gt;" in described
    assert '<title id="p-title">Waves of \\sin x &amp; more.</title>' in described


def test_a_gap_breaks_a_line():
    def drawn(y):
        plot = Plot("c", "x", "y", [Curve("one", [0, 1, 2, 3, 4], y)])
        text = plot_html(plot, "p")
        return text.count('<path class="curve-1"') - 1, text.count('class="marker-1"')

    assert drawn([0, 1, 2, 1, 0]) == (1, 0)
    assert drawn([0, 1, math.nan, 1, 0]) == (2, 0)
    assert drawn([0, None, 2, None, 0]) == (0, 1)  # points between gaps are marked, not lost


def test_a_line_beyond_the_axis_is_cut_at_its_edge():
    plot = Plot("c", "x", Axis("y", low=0.0, high=1.0), [Curve("one", [0.0, 1.0], [-1.0, 3.0])])
    (path, _) = re.findall(r'<path class="curve-1" d="([^"]+)"', plot_html(plot, "p"))
    # It rises from -1 to 3: through 0 after a quarter of the way and through 1 after half of it.
    assert path == f"M{WHOLE.width / 4:g} {WHOLE.height:g}L{WHOLE.width / 2:g} 0"


def test_a_drawing_has_one_unit():
    square = Curve("square", [0.0, 1.0, 1.0, 0.0, 0.0], [4.0, 4.0, 5.0, 5.0, 4.0])
    for width, height in ((1.0, 1.0), (3.0, 1.0), (1.0, 3.0)):
        far = Curve("far", [0.0, width], [4.0, 4.0 + height])
        plot = Plot("c", "x", "y", [square, far], equal=True)
        (path, _) = re.findall(r'<path class="curve-1" d="([^"]+)"', plot_html(plot, "p"))
        numbers = [float(number) for number in re.findall(r"-?[0-9.]+", path)]
        x, y = numbers[::2], numbers[1::2]
        assert max(x) - min(x) == pytest.approx(max(y) - min(y), abs=0.02)
        assert min(x) >= 0
        assert max(x) <= WHOLE.width
        assert min(y) >= 0
        assert max(y) <= WHOLE.height


def test_drawings_side_by_side_have_one_unit():
    small, large = (
        Plot(name, "x", "y", [Curve("one", [0.0, size], [0.0, size])], equal=True)
        for name, size in (("small", 1.0), ("large", 4.0))
    )
    text = plot_html(Panels("c", [small, large]), "p")
    paths = re.findall(r'<path class="curve-1" d="M([-0-9.]+) [-0-9.]+L([-0-9.]+) ', text)
    widths = [float(end) - float(start) for start, end in paths[:2]]
    assert widths[1] == pytest.approx(4 * widths[0], abs=0.1)


def test_every_curve_stands_where_its_numbers_say():
    plot = figures.powers()
    (path, _) = re.findall(r'<path class="curve-1" d="([^"]+)"', plot_html(plot, "p"))
    drawn = [tuple(map(float, p.split())) for p in path[1:].split("L")]
    for (x, y), a, b in zip(drawn, plot.curves[0].x, plot.curves[0].y, strict=True):
        assert x == pytest.approx((math.log10(a) + 3) / 2 * WHOLE.width, abs=0.01)
        assert y == pytest.approx((-2 - math.log10(b)) / 6 * WHOLE.height, abs=0.01)


@pytest.mark.parametrize(
    ("low", "high", "wanted"),
    [
        (-1.0, 1.0, [-1, -0.5, 0, 0.5, 1]),
        (0.0, 1e-7, [k * 2e-8 for k in range(6)]),
        (3.0, 3.0000004, None),
        (1e6, 5e6, [1e6, 2e6, 3e6, 4e6, 5e6]),
    ],
)
def test_ticks_are_round(low, high, wanted):
    found = ticks(low, high)
    assert found[0] <= low
    assert found[-1] >= high
    assert 3 <= len(found) <= 9
    if wanted:
        assert found == pytest.approx(wanted)


@pytest.mark.parametrize(
    ("low", "high"), [(1e-9, 1.0), (1e-3, 0.1), (0.02, 0.03), (3.0, 7e12), (1.0, 10.0)]
)
def test_logarithmic_ticks_enclose_the_numbers(low, high):
    found = log_ticks(low, high)
    assert found[0] <= low * (1 + 1e-9)
    assert found[-1] >= high * (1 - 1e-9)
    assert 2 <= len(found) <= 12
    assert found == sorted(found)


def test_a_scale_of_one_value_has_room():
    for axis in (Axis("a"), Axis("a", log=True), Axis("a", low=2.0), Axis("a", high=2.0)):
        made = scale(axis, [2.0], 0.0, 100.0, 5)
        assert 0 <= made.at(2.0) <= 100
        assert made.low < made.high


def test_numbers_on_axes():
    assert label_of(-0.25) == "−0.25"
    assert label_of(1e-7) == "10⁻⁷"
    assert label_of(-2.5e9) == "−2.5·10⁹"
    assert label_of(0.0) == "0"


def test_the_sky_is_seen_as_on_a_map():
    # North above, east to the right, the zenith in the middle.
    assert at(90.0, 0.0, 0.0) == pytest.approx((0, -90))
    assert at(90.0, 90.0, 0.0) == pytest.approx((90, 0))
    assert at(90.0, 180.0, 45.0) == pytest.approx((0, 45))
    assert at(90.0, 77.0, 90.0) == pytest.approx((0, 0))


def test_cells_of_the_sky_cover_it_once():
    """The areas of all sectors, from their own corners, add up to the disc less its gap."""
    plot = figures.sky()
    html = plot_html(plot, "p")
    radius = WHOLE.height * 0.6
    area = 0.0
    for path in re.findall(r'<path class="level-\d" d="(M-?[\d.]+ -?[\d.]+A[^"]+)"', html):
        for sector in path.split("Z")[:-1]:
            head, tail = sector[1:].split("A", 1)
            x, y = map(float, head.split())
            outer = tail.split("L")[0].split()
            u, v = float(outer[5]), float(outer[6])
            turn = math.atan2(x * v - y * u, x * u + y * v) % (2 * math.pi)
            inner = float(tail.split("A")[1].split()[0]) if "A" in tail else 0.0
            area += turn / 2 * (float(outer[0]) ** 2 - inner**2)
    gap = math.radians(30) / 2 * (radius**2 - (radius * 80 / 90) ** 2)
    assert area == pytest.approx(math.pi * radius**2 - gap, rel=1e-3)


def test_classes():
    classes = Classes((0.0, 1.0, 2.0, 4.0), False)
    assert [classes.of(v) for v in (0.0, 0.99, 1.0, 3.9, 4.0)] == [0, 0, 1, 2, 2]
    assert [classes.kind(k) for k in range(3)] == ["level-1", "level-5", "level-9"]
    flat = HeatMap("c", "x", "y", "q", [0, 1, 2], [0, 1], [[3.0, 3.0]])
    found = classes_of([flat])
    assert found.edges[0] <= 3.0 <= found.edges[-1]
    wide = HeatMap("c", "x", "y", "q", [0, 1, 2], [0, 1], [[1e-20, 1e20]], log=True)
    assert 2 <= classes_of([wide]).count <= 9


def test_panels_share_their_scale():
    text = plot_html(figures.panels(), "p")
    labels = [re.findall(r'text-anchor="end">([^<]+)<', part) for part in text.split("</svg>")]
    assert labels[0] == labels[1] == labels[2]
    assert len(labels[0]) <= PANEL.up + 4
    assert text.count(">sine<") == 1  # one legend


def test_a_mark_may_stand_alone():
    text = plot_html(Plot("c", "x", "y", [Curve("one", [0], [0])], [Mark(5.0, "far")]), "p")
    assert ">far<" in text


# -- colours --------------------------------------------------------------------------------------


def tokens() -> dict[str, tuple[str, str]]:
    found = re.findall(
        r"--([\w-]+): light-dark\((#[0-9a-f]{6}), (#[0-9a-f]{6})\)",
        (THEME / "tokens.css").read_text("utf-8"),
    )
    return {name: (light, dark) for name, light, dark in found}


def luminance(colour: str) -> float:
    """Relative luminance as WCAG 2 defines it."""
    parts = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    red, green, blue = (p / 12.92 if p <= 0.03928 else ((p + 0.055) / 1.055) ** 2.4 for p in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("scheme", [0, 1])
def test_lines_stand_out_from_the_page(scheme):
    colours = tokens()
    page = colours["page"][scheme]
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    for name in (*(f"curve-{k}" for k in range(1, 7)), "edge", "soft", "ink"):
        assert contrast(colours[name][scheme], page) >= 3, name


@pytest.mark.parametrize("scheme", [0, 1])
def test_classes_of_colour_rise_in_lightness(scheme):
    """So they can be told apart in grey; the last stands out from the page."""
    colours = tokens()
    levels = [colours[f"level-{k}"][scheme] for k in range(1, 10)]
    page = colours["page"][scheme]
    steps = [luminance(b) - luminance(a) for a, b in pairwise(levels)]
    assert all(step > 0 for step in steps) or all(step < 0 for step in steps)
    neighbours = [contrast(a, b) for a, b in pairwise(levels)]
    assert min(neighbours) >= 1.15
    assert contrast(levels[0], levels[-1]) >= 7
    assert contrast(levels[-1], page) >= 7
