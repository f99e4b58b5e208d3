"""Building: strict, repeatable, and the old site stays until the new one is whole."""

import hashlib
import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from armillary.derivation.errors import DerivationError
from armillary.site.build import build_site
from armillary.site.errors import SiteError
from armillary.site.hooks import with_systems
from armillary.store.lock import locked
from tests.site.conftest import ROOT

DEMO = """
from armillary import Chain, Derivation, Z, X
derivation = d = Derivation("demo", title="A <demo> & more"{paper})
turn = d.angle("turn", "turn")
L = d.parameter.length("L", "length")
chain = Chain("ground").translate(Z, L).rotate(X, turn, frame="tip")
M = d.define("M", chain.pose("ground", "tip"), because="because", meaning="pose")
d.kernel("pose", inputs=[turn], outputs=[M])
d.picture(chain, at={{}}, caption="the demo")
"""


@pytest.fixture
def small(tmp_path):
    def write(paper: str = "", config: str = "site_name: Small\n", index: str = "# Home\n") -> Path:
        for path, text in {
            "derivations/demo/derivation.py": DEMO.format(paper=paper),
            "mkdocs.yml": config,
            "docs/index.md": index,
        }.items():
            (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / path).write_text(text, "utf-8")
        return tmp_path

    return write


def digests(folder: Path) -> dict[str, str]:
    return {
        path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def test_two_builds_give_the_same_bytes(tmp_path):
    command = (
        "import sys; from pathlib import Path; from armillary.site.build import build_site;"
        "build_site(Path(sys.argv[1]), Path(sys.argv[2]))"
    )
    for seed, zone in (("0", "UTC"), ("1", "Asia/Tokyo")):
        subprocess.run(
            [sys.executable, "-c", command, str(ROOT), str(tmp_path / seed)],
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seed, "TZ": zone, "LC_ALL": "C"},
            check=True,
        )
    assert digests(tmp_path / "0") == digests(tmp_path / "1")


def test_the_least_configuration_will_do(small):
    out = build_site(small())
    assert out.name == "site"
    assert not (out / "sitemap.xml").exists()  # it would hold the date
    page = (out / "systems" / "demo.html").read_text("utf-8")
    assert "A &lt;demo&gt; &amp; more" in page
    assert 'id="eq-demo-M"' in page
    assert "armillary generate" in page  # nothing was generated, and the page says so
    assert "armillary check" in page


def test_a_page_without_a_derivation_is_removed(small):
    root = small()
    old = root / "docs" / "systems" / "gone.md"
    old.parent.mkdir()
    old.write_text("# Gone", "utf-8")
    build_site(root)
    assert not old.exists()


def test_pages_that_did_not_change_are_not_written(small):
    root = small()
    build_site(root)
    page = root / "docs" / "systems" / "demo.md"
    before = page.stat().st_mtime_ns
    build_site(root)
    assert page.stat().st_mtime_ns == before


@pytest.mark.parametrize("index", ["[x](nowhere.md)", "[x](systems/demo.md#nowhere)"])
def test_a_broken_link_keeps_the_old_site(small, index):
    root = small()
    out = build_site(root)
    before = digests(out)
    (root / "docs" / "index.md").write_text(f"# Home\n\n{index}\n", "utf-8")
    with pytest.raises(SiteError, match="mend"):
        build_site(root)
    assert digests(out) == before
    build_site(root, strict=False)


def test_what_is_wrong_is_said(small, tmp_path):
    with pytest.raises(SiteError, match=r"references\.toml"):
        build_site(small(paper=', paper="nobody"'))
    with pytest.raises(SiteError, match="nothing to put in the place of"):
        build_site(small(index="# Home\n\n<!-- armillary: picture nothing -->\n"))
    (tmp_path / "derivations" / "demo" / "derivation.py").write_text("1 / 0\n", "utf-8")
    with pytest.raises(DerivationError, match=r"derivation\.py:1"):
        build_site(tmp_path)
    (tmp_path / "mkdocs.yml").unlink()
    with pytest.raises(SiteError, match="site_name"):
        build_site(tmp_path)


def test_two_builds_of_one_site_wait_for_each_other(small):
    root, said = small(), []
    with ThreadPoolExecutor() as pool:
        with locked(root / "build" / "site.lock", lambda: None):
            other = pool.submit(build_site, root, say=said.append)
            while not said and not other.done():
                time.sleep(0.01)
            assert not (root / "site").exists()
        assert (other.result() / "index.html").is_file()
    assert said == ["waiting for another build to finish"]


def test_the_systems_take_their_place_in_the_navigation():
    class Named:
        title = "A"

    pages = [{"Overview": "systems/index.md"}, {"A": "systems/a.md"}]
    nav = with_systems([{"Systems": "systems/index.md"}, {"End": "end.md"}], {"a": Named()})
    assert nav == [{"Systems": pages}, {"End": "end.md"}]
    assert with_systems([{"End": "end.md"}], {"a": Named()}) == [
        {"End": "end.md"},
        {"Systems": pages},
    ]
    assert with_systems(None, {}) is None
