"""The built site as files: what a browser would ask for is there, and nothing else is asked for."""

import re
from urllib.parse import unquote, urlsplit

import pytest

from armillary.derivation.folders import names
from armillary.site.search import wrap_search_index
from tests.site.conftest import ROOT


def test_every_system_has_a_page_in_the_navigation(site):
    links = site.page("index.html").reader.links
    systems = names(ROOT / "derivations")
    assert systems
    for name in systems:
        assert f"systems/{name}.html" in links


def test_nothing_is_asked_of_the_network(site):
    for page in site.pages:
        outside = [r for r in page.reader.resources if urlsplit(r).scheme or r.startswith("//")]
        assert not outside, f"{page.path}: {outside}"
    for path in [*site.folder.rglob("*.css"), *site.folder.rglob("*.js")]:
        text = path.read_text("utf-8")
        asked = re.findall(r"url\(\s*['\"]?(?:https?:)?//[^)]*\)|@import[^;]*//[^;]*;", text)
        asked += re.findall(r"(?:fetch|import|importScripts)\(\s*['\"](?:https?:)?//", text)
        assert not asked, f"{path}: {asked}"


def test_nothing_is_inline(site):
    for page in site.pages:
        assert not page.reader.inline, f"{page.path}: {page.reader.inline}"


def test_ids_are_unique(site):
    for page in site.pages:
        ids = page.reader.ids
        assert len(ids) == len(set(ids)), (
            f"{page.path}: {sorted(i for i in ids if ids.count(i) > 1)}"
        )


def test_links_and_anchors_lead_somewhere(site):
    ids = {page.path: set(page.reader.ids) for page in site.pages}
    for page in site.pages:
        for link in page.reader.links + page.reader.resources:
            parts = urlsplit(link)
            if parts.scheme:
                continue
            target = (page.path.parent / unquote(parts.path)).resolve() if parts.path else page.path
            assert target.is_file(), f"{page.path}: {link}"
            if parts.fragment and target.suffix == ".html":
                assert unquote(parts.fragment) in ids[target], f"{page.path}: {link}"


def test_formulas_have_balanced_braces(site):
    for page in site.pages:
        for latex, _ in page.reader.formulas:
            bare = latex.replace(r"\{", "").replace(r"\}", "")
            assert bare.count("{") == bare.count("}"), f"{page.path}: {latex}"


def test_every_definition_and_kernel_has_an_address(site):
    from armillary.derivation.load import load_all

    for name, derivation in load_all(ROOT / "derivations").items():
        ids = set(site.page(f"systems/{name}.html").reader.ids)
        for definition in derivation.definitions.values():
            assert f"eq-{definition.identifier}" in ids
        for kernel in derivation.kernels:
            assert f"kernel-{name}-{kernel}" in ids


def test_the_search_index_is_a_script(site):
    text = (site.folder / "search" / "search_index.js").read_text("ascii")
    assert text.startswith("window.armillarySearchIndex=")
    assert "altazimuth" in text


def test_a_site_without_an_index_is_refused(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"plugins.*mkdocs\.yml"):
        wrap_search_index(tmp_path)
