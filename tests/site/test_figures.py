"""Drawings: from the chain itself, the same bytes every time, without colours of their own."""

import math
import re
import xml.etree.ElementTree as ET

import numpy as np

from armillary import Chain, Derivation, X, Y, Z
from armillary.derivation.statements import Picture
from armillary.site.figures import Posed, picture_svg
from armillary.site.notation import Notation
from armillary.site.svg import number, plain


def demo():
    d = Derivation("demo", title="Demo")
    gamma, L_0 = d.angle("gamma", "."), d.length("L_0", ".")
    chain = Chain("ground").translate(Z, L_0).rotate(Z, -gamma).translate(Y, 1, frame="tip")
    d.picture(chain, at={"gamma": math.pi / 2, "L_0": 2.0}, caption="A <demo>", sun=X)
    return d


def test_the_pose_is_that_of_the_chain():
    d = demo()
    posed = Posed(d.pictures[0], Notation(d))
    # A clockwise quarter turn carries y to the east.
    np.testing.assert_allclose(posed.last.origin, [1, 0, 2], atol=1e-15)
    np.testing.assert_allclose(posed.last.axes[:, 0], [0, -1, 0], atol=1e-15)


def test_a_picture_is_well_formed_and_repeats():
    d = demo()
    svg = picture_svg(d.pictures[0], Notation(d), "fig")
    assert svg == picture_svg(demo().pictures[0], Notation(d), "fig")
    root = ET.fromstring(svg)
    assert root.find("title").text == "A <demo>"
    assert "style=" not in svg
    assert not re.search(r"#[0-9a-f]{3}|(?:fill|stroke)=", svg)
    assert "γ" in svg
    assert "L₀" in svg


def test_a_chain_of_rotations_is_drawn_on_the_sky():
    d = Derivation("demo", title="Demo")
    hour = d.angle("hour", ".", latex=r"\omega")
    chain = Chain("enu").rotate(X, 0.7).rotate(Y, -hour, frame="sun")
    picture = Picture(chain, {"hour": 0.8}, Z, "Sky", d.source)
    svg = picture_svg(picture, Notation(d), "fig")
    assert 'class="curve-2"' in svg  # the way of a day
    assert "ω" in svg


def test_small_text():
    assert plain(r"\dot{\gamma}") == "γ"
    assert plain("L_{12}") == "L₁₂"
    assert number(-0.001) == "0"
