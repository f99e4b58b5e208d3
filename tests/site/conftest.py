"""The project's own site, built once for all tests that look at it."""

from pathlib import Path

import pytest

from armillary.site.build import build_site
from tests.site.tree import Site

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Site:
    return Site(build_site(ROOT, tmp_path_factory.mktemp("site") / "site", strict=True))
