"""What all tests share: fixed random seeds, golden files, small projects."""

from collections.abc import Callable
from pathlib import Path

import hypothesis
import pytest

from tests.golden import compare_or_update

hypothesis.settings.register_profile(
    "fixed", derandomize=True, deadline=None, database=None, max_examples=40, print_blob=False
)
hypothesis.settings.load_profile("fixed")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update", action="store_true", help="write golden files instead of comparing with them"
    )


# Made once for all tests; a process of its own would make each again.
SHARED = ("site", "found")


def pytest_itemcollected(item: pytest.Item) -> None:
    """Tests that look at the same large thing stay in one process."""
    for name in SHARED:
        if name in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.xdist_group(name))


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Callable[[str, str], None]:
    """`golden("name.txt", text)` compares with `golden/name.txt` beside the test."""
    folder = Path(request.path).parent / "golden"
    update = bool(request.config.getoption("--update"))
    return lambda name, text: compare_or_update(folder / name, text, update)


@pytest.fixture
def project(tmp_path: Path) -> Callable[..., Path]:
    """`project(demo="...text of derivation.py...")` writes derivations and gives their root."""

    def write(**texts: str) -> Path:
        for name, text in texts.items():
            path = tmp_path / "derivations" / name / "derivation.py"
            path.parent.mkdir(parents=True)
            path.write_text(text, "utf-8")
        return tmp_path

    return write
