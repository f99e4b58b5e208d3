"""Writes the generated pages of a project: whole files, and only those that changed."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from armillary.derivation.load import load_all
from armillary.derivation.record import Derivation
from armillary.site.facts import read_facts
from armillary.site.measured import measured_plots
from armillary.site.pages import index_page, system_page
from armillary.site.references import read_references
from armillary.store.files import digest, digest_of, replace_durably
from armillary.store.lock import locked

FOLDER = "systems"
_LOCK = Path("build") / "pages.lock"


def write_pages(root: Path, docs: Path) -> dict[str, Derivation]:
    """Bring `<docs>/systems` up to date; tells the derivations.

    Raises:
        DerivationError: for anything wrong in a derivation; then no page is touched.
        SiteError: for a paper that is not in the project's table.
    """
    derivations = load_all(root / "derivations")
    facts, references = read_facts(root), read_references(root)
    texts = {"index.md": index_page(derivations.values())}
    for name, derivation in derivations.items():
        texts[f"{name}.md"] = system_page(
            derivation, facts, references, measured_plots(root, name, facts)
        )
    with locked(root / _LOCK, lambda: None):  # held for a moment only
        replace_folder(docs / FOLDER, texts)
    return derivations


def replace_folder(folder: Path, texts: Mapping[str, str]) -> list[str]:
    """Make the Markdown files of a folder these and no others; tells what changed."""
    folder.mkdir(parents=True, exist_ok=True)
    changed = [name for name, text in texts.items() if _write(folder / name, text)]
    for path in sorted(folder.glob("*.md")):
        if path.name not in texts:
            path.unlink()
            changed.append(path.name)
    return changed


def _write(path: Path, text: str) -> bool:
    """Put a file in place as a whole, unless it is already so; a server watches its time."""
    data = text.encode()
    if digest_of(path) == digest(data):
        return False
    replace_durably(path, data)
    return True
