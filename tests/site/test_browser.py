"""Every page from file:// in Chromium: formulas, console, width, search."""

import time
import os

import pytest

from tests.site.browser import Browser, available

pytestmark = pytest.mark.tool


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
