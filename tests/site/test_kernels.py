"""The card of a kernel tells what inputs are drawn as for the checks, where they are."""

import pytest

from armillary import Derivation, near
from armillary.site.facts import read_facts
from armillary.site.kernels import Drawn, cards
from armillary.site.pages import system_page


@pytest.fixture
def facts(tmp_path):
    return read_facts(tmp_path)


def record(drawn):
    d = Derivation("demo", title="Demo")
    a, b = d.angle("a", "turn", latex=r"\alpha"), d.length("b", "length")
    x, y = d.angle("x", "first"), d.length("y", "second")
    known = {x: near(2 * a, by=0.25), y: 3 * b} if drawn else {}
    d.kernel("k", inputs=[x, y], outputs={"z": x * y}, drawn=known)
    return d


def test_what_is_drawn_stands_on_the_card(facts):
    (card,) = cards(record(True), facts)
    assert card.drawn == (Drawn(r"x = 2\,\alpha", "0.25 rad"), Drawn(r"y = 3\,b", ""))
    page = system_page(record(True), facts, {})
    assert (
        r'<dt>Checked at</dt><dd><span class="tex" data-tex="x = 2\,\alpha"></span>, up to 0.25 rad'
        r' off<br><span class="tex" data-tex="y = 3\,b"></span></dd>'
    ) in page


def test_where_nothing_is_drawn_nothing_is_said(facts):
    (card,) = cards(record(False), facts)
    assert card.drawn == ()
    assert "Checked at" not in system_page(record(False), facts, {})
