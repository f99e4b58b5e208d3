"""Serving: an edit reaches the page, and a mistake is told without losing it."""

import subprocess
import sys
import time
import urllib.error
import urllib.request
from pathlib import Path

import pytest

from tests.site.browser import free_port
from tests.site.test_build import DEMO

pytestmark = pytest.mark.slow


def until(address: str, text: str) -> None:
    """Wait until a page has a text."""
    end = time.monotonic() + 40
    while True:
        try:
            with urllib.request.urlopen(address, timeout=20) as answer:
                if text in answer.read().decode():
                    return
        except (urllib.error.URLError, ConnectionError, TimeoutError):
            pass
        assert time.monotonic() < end, f"no {text!r} at {address}"
        time.sleep(0.2)


def test_edits_reach_the_page_and_mistakes_do_not(tmp_path):
    path = tmp_path / "derivations" / "demo" / "derivation.py"
    path.parent.mkdir(parents=True)
    path.write_text(DEMO.format(paper=""), "utf-8")
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "index.md").write_text("# Home\n", "utf-8")
    (tmp_path / "mkdocs.yml").write_text("site_name: Small\n", "utf-8")
    port = free_port()
    command = (
        "import sys; from pathlib import Path; from armillary.site.build import serve;"
        f"serve(Path({str(tmp_path)!r}), '127.0.0.1:{port}')"
    )
    log = tmp_path / "log"
    root = Path(__file__).resolve().parents[2]
    with log.open("w") as out:
        server = subprocess.Popen(
            [sys.executable, "-c", command], cwd=root, stdout=out, stderr=subprocess.STDOUT
        )
    try:
        address = f"http://127.0.0.1:{port}/systems/demo.html"
        until(address, "because")
        good = path.read_text("utf-8")
        path.write_text(good.replace('because="because"', 'because="for another reason"'), "utf-8")
        until(address, "for another reason")
        path.write_text(good + "\n1 / 0\n", "utf-8")
        end = time.monotonic() + 40
        while "The pages stay as they were" not in log.read_text("utf-8"):
            assert time.monotonic() < end, log.read_text("utf-8")
            time.sleep(0.2)
        until(address, "for another reason")
        assert "Traceback" not in log.read_text("utf-8")
        path.write_text(good.replace('because="because"', 'because="mended"'), "utf-8")
        until(address, "mended")
    finally:
        server.terminate()
        server.wait()
