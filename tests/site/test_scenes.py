"""Pictures of platforms: every like part is drawn, where its expression says."""

import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from armillary import (
    Derivation,
    Frame,
    Plate,
    Ray,
    Rod,
    Scene,
    Trace,
    Z,
    cos,
    degrees,
    elementary,
    sin,
    vector,
)
from armillary.site.figures import picture_svg
from armillary.site.notation import Notation
from armillary.site.projection import Paper
from armillary.site.scenes import Numbers


@pytest.fixture
def d():
    d = Derivation("demo", title="Demo")
    leg = d.index("leg", 3)
    facet = d.index("facet", 4)
    theta = d.constant("theta", (0, degrees(120), degrees(240)), "azimuth", per=leg)
    phi = d.constant("phi_N", tuple(degrees(90 * k) for k in range(4)), "azimuth", per=facet)
    height, lean = d.length("height", "."), d.angle("lean", ".")
    centre = vector(3 * cos(phi), 3 * sin(phi), 0)
    base = centre + vector(cos(theta), sin(theta), 0)
    top = base + vector(0, 0, height)
    parts = (
        Frame("H", vector(0, 0, 0), elementary(Z, lean)),
        Plate(base, over=leg, kind="ground"),
        Plate(top, over=leg),
        Rod(base, top, name="l"),
        Trace(vector(cos(lean), sin(lean), height), lean, 0.0, 1.0),
        Ray(vector(0, 0, 0), vector(0, 0, 1), length=2, sun=True),
    )
    d.picture(Scene(parts), at={"height": 2.0}, caption="Four tripods")
    return d


def drawn(d):
    return picture_svg(d.pictures[0], Notation(d), "fig")


def test_every_part_of_every_index_is_drawn(d):
    root = ET.fromstring(drawn(d))
    paths = [e for e in root if e.tag == "path"]
    by_kind = {kind: [p for p in paths if p.get("class") == kind] for kind in
               ("link", "ground", "joint", "curve-2", "sun")}  # fmt: skip
    assert {k: len(v) for k, v in by_kind.items()} == {
        "link": 12, "ground": 4, "joint": 4, "curve-2": 1, "sun": 1,
    }  # fmt: skip
    assert all(p.get("d").endswith("Z") and p.get("d").count("L") == 2 for p in by_kind["ground"])
    assert sum(e.tag == "circle" and e.get("class") == "joint" for e in root) == 24
    assert [e.text for e in root if e.tag == "text"] == ["x", "y", "z", "H", "l"]


def test_rods_stand_where_their_expressions_say(d):
    svg = drawn(d)
    links = re.findall(r'class="link" d="M([-\d.]+) ([-\d.]+)L([-\d.]+) ([-\d.]+)"', svg)
    ends = np.array(links, dtype=float).reshape(12, 2, 2)
    paper = Paper(np.hypot(4.0, 2.0))
    for k, (start, end) in enumerate(ends):
        facet, leg = divmod(k, 3)
        az, at = np.pi / 2 * facet, 2 * np.pi / 3 * leg
        foot = np.array([3 * np.cos(az) + np.cos(at), 3 * np.sin(az) + np.sin(at), 0])
        np.testing.assert_allclose(start, paper(foot), atol=0.011)
        np.testing.assert_allclose(end, paper(np.add(foot, [0, 0, 2.0])), atol=0.011)


def test_the_same_scene_gives_the_same_bytes(d):
    assert drawn(d) == drawn(d)
    assert "style=" not in drawn(d)


def test_what_is_not_given_takes_a_plain_value(d):
    numbers = Numbers({"height": 2.0})
    lean, height = d.quantities["lean"], d.quantities["height"]
    np.testing.assert_allclose(numbers(vector(lean, height, 0)), [0.5, 2.0, 0.0])
