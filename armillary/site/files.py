"""Writes the generated pages of a project: whole files, and only those that changed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from armillary.derivation.load import load_all, shared
from armillary.derivation.record import Derivation
from armillary.site.facts import read_facts
from armillary.site.pages import index_page, system_page
from armillary.site.papers import PAPERS, audited_papers, paper_texts, prints_of
from armillary.site.references import read_references
from armillary.site.studies import studied
from armillary.store.files import digest, digest_of, remove_empty_folders, replace_durably
from armillary.store.lock import locked
from armillary.verify.studies.data import files as data_files

FOLDER = "systems"
CHAPTER = "auditing.md"  # where a project explains the audit
_LOCK = Path("build") / "pages.lock"


@dataclass(frozen=True)
class Written:
    """What has pages: the derivations by name, and the short names of the papers by key."""

    derivations: dict[str, Derivation]
    papers: dict[str, str]


def write_pages(root: Path, docs: Path) -> Written:
    """Bring `<docs>/systems` and `<docs>/papers` up to date; tells what has a page.

    Raises:
        DerivationError: for anything wrong in a derivation or a paper; then no page is touched.
        SiteError: for a paper that is not in the project's table.
    """
    with shared():
        derivations = load_all(root / "derivations")
        papers = audited_papers(root)
    facts, references = read_facts(root), read_references(root)
    printed = prints_of(papers, references)
    texts = {"index.md": index_page(derivations.values())}
    for name, derivation in derivations.items():
        study = studied(root, facts.package, name)
        texts[f"{name}.md"] = system_page(derivation, facts, references, study, printed)
        texts |= {f"{name}/{file}": text for file, text in data_files(study.items).items()}
    told = paper_texts(papers, references, (docs / CHAPTER).is_file())
    with locked(root / _LOCK, lambda: None):  # held for a moment only
        replace_folder(docs / FOLDER, texts)
        if told or (docs / PAPERS).is_dir():
            replace_folder(docs / PAPERS, told)
    return Written(
        derivations, {one.paper.name: references[one.paper.name].short for one in papers}
    )


def replace_folder(folder: Path, texts: Mapping[str, str]) -> list[str]:
    """Make the pages and data of a folder these and no others; tells what changed."""
    folder.mkdir(parents=True, exist_ok=True)
    changed = [name for name, text in texts.items() if _write(folder / name, text)]
    for path in sorted((*folder.glob("*.md"), *folder.glob("*/*.csv"))):
        name = path.relative_to(folder).as_posix()
        if name not in texts:
            path.unlink()
            remove_empty_folders(path.parent, folder)
            changed.append(name)
    return changed


def _write(path: Path, text: str) -> bool:
    """Put a file in place as a whole, unless it is already so; a server watches its time."""
    data = text.encode()
    if digest_of(path) == digest(data):
        return False
    replace_durably(path, data)
    return True
