"""Golden files: text that is committed beside the test that compares with it."""

import difflib
from pathlib import Path


def compare_or_update(path: Path, text: str, update: bool) -> None:
    """Compare `text` with a committed file, or write it there.

    Raises:
        AssertionError: with the unified diff, and how to accept it.
    """
    known = path.read_text("utf-8") if path.is_file() else None
    if known == text:
        return
    if update:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
        return
    if known is None:
        raise AssertionError(f"{path} is not there; `pytest --update` writes it.\n\n{text}")
    lines = difflib.unified_diff(
        known.splitlines(keepends=True), text.splitlines(keepends=True), str(path), "now"
    )
    raise AssertionError(
        f"{''.join(lines)}\n{path} is not what came out.\n"
        "If the new text is right, `pytest --update` writes it; look at the diff, then commit it."
    )
