"""Every page from file:// in Chromium: formulas, console, width, search."""

import os
import time

import pytest

from armillary.site.build import THEME as THEME_FOLDER
from armillary.site.plots import plot_html
from tests.site import figures
from tests.site.browser import Browser, available

pytestmark = pytest.mark.tool
THEME = THEME_FOLDER / "css"


@pytest.fixture(scope="module")
def browser():
    if not available():
        assert not os.environ.get("ARMILLARY_REQUIRE_ALL"), "chromium or chromedriver is missing"
        pytest.skip("chromium or chromedriver is missing")
    found = Browser()
    yield found
    found.close()


def test_every_page_opens_from_a_file(site, browser):
    pages = [page for page in site.pages if page.path.name != "404.html"]
    formulas = 0
    for page in pages:
        browser.size(1280, 900)
        browser.open(page.path.as_uri())
        browser.run("window.armillaryMath && armillaryMath.renderAll()")
        wanted = len(page.reader.formulas)
        formulas += wanted
        assert browser.run("return document.querySelectorAll('.math-error').length") == 0, page
        assert browser.run("return document.querySelectorAll('[data-tex] .katex').length") >= wanted
        assert browser.errors() == [], page
    assert formulas > 50


def test_no_page_is_wider_than_a_telephone(site, browser):
    for page in site.pages:
        browser.size(390, 844)
        browser.open(page.path.as_uri())
        browser.run("window.armillaryMath && armillaryMath.renderAll()")
        assert browser.run("return document.documentElement.scrollWidth") <= 390, page


def test_an_address_opens_its_step(site, browser):
    page = site.folder / "systems" / "altazimuth.html"
    browser.open(f"{page.as_uri()}#eq-altazimuth-M")
    assert browser.run("return document.getElementById('eq-altazimuth-M').open") is True


def test_the_search_finds_a_system(site, browser):
    browser.size(1280, 900)
    browser.open((site.folder / "index.html").as_uri())
    browser.run(
        "const box = document.getElementById('search-input'); box.focus();"
        "box.value = 'altazimuth'; box.dispatchEvent(new Event('input'));"
    )
    deadline = time.monotonic() + 10
    found: list[str] = []
    while not found and time.monotonic() < deadline:
        time.sleep(0.05)
        found = browser.run(
            "document.getElementById('search-input').dispatchEvent(new Event('input'));"
            "return [...document.querySelectorAll('#search-results a')].map(a => a.href)"
        )
    assert any("systems/altazimuth.html" in address for address in found)


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [400, 1400])
def test_plots_fit_the_page(browser, tmp_path, width, scheme):
    page = tmp_path / "plots.html"
    page.write_text(gallery(scheme), "utf-8")
    browser.size(width, 900)
    browser.errors()  # those of other pages
    browser.open(page.as_uri())
    assert browser.errors() == []
    assert browser.run("return document.documentElement.scrollWidth") <= width
    drawings = browser.run(
        "return [...document.querySelectorAll('figure svg')].map(svg => {"
        " const box = svg.getBoundingClientRect(), figure = svg.closest('figure');"
        " const inner = figure.getBoundingClientRect();"
        " const words = [...svg.querySelectorAll('text')].map(t => t.getBoundingClientRect());"
        " return [figure.id, box.width, box.height,"
        "  box.left >= inner.left - 1 && box.right <= inner.right + 1,"
        "  words.every(w => w.left >= box.left - 1 && w.right <= box.right + 1"
        "   && w.top >= box.top - 1 && w.bottom <= box.bottom + 1)]; })"
    )
    assert len(drawings) == len(figures.ALL) + 5  # panels: three and two, with a legend each
    for name, wide, high, inside, whole in drawings:
        assert min(wide, high) > 20, name
        assert inside, f"{name} is wider than its column"
        assert whole, f"words of {name} are cut off"
    painted = "return getComputedStyle(document.querySelector('.curve-1')).stroke"
    assert (
        browser.run(painted) == {"light": "rgb(31, 95, 191)", "dark": "rgb(130, 180, 255)"}[scheme]
    )


def gallery(scheme: str) -> str:
    """A page of all kinds of plots in the theme of the site."""
    sheets = "".join(
        f'<link rel="stylesheet" href="{(THEME / f"{name}.css").as_uri()}">'
        for name in ("tokens", "base", "layout", "tables", "figures")
    )
    drawn = "".join(
        f'<figure id="{name}">{plot_html(make(), f"plot-{name}")}</figure>'
        for name, make in figures.ALL.items()
    )
    return (
        f'<!doctype html><html lang="en" data-scheme="{scheme}"><head><meta charset="utf-8">'
        f'<meta name="viewport" content="width=device-width"><title>Plots</title>{sheets}</head>'
        f'<body><main class="prose">{drawn}</main></body></html>'
    )
