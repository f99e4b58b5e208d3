"""What MkDocs calls while it builds an Armillary site; `build.py` names this file to it.

MkDocs reads the project's own mkdocs.yml. These events add what only the derivations know: the
pages of the systems and papers before the build, their place in the navigation, the marks in
hand-written pages, and the search index as a script after it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from armillary.derivation.record import Derivation
from armillary.site.files import FOLDER, write_pages
from armillary.site.marks import fill_marks
from armillary.site.papers import PAPERS
from armillary.site.search import wrap_search_index

SECTION = "Systems"
PAPER_SECTION = "Papers"
# What the generated pages are written in.
_EXTENSIONS: dict[str, dict[str, Any]] = {
    "admonition": {},
    "attr_list": {},
    "def_list": {},
    "footnotes": {},
    "md_in_html": {},
    "tables": {},
    "toc": {"permalink": "#", "permalink_title": "Link to this heading"},
}
_derivations: dict[str, Derivation] = {}
_papers: dict[str, str] = {}


def on_config(config: Any) -> Any:
    """Write the pages of the systems, and give them their place."""
    refresh(config)
    return configure(config)


def refresh(config: Any) -> None:
    """Read the derivations, and write their pages."""
    found = write_pages(Path(config.config_file_path).parent, Path(config.docs_dir))
    _derivations.clear()
    _derivations.update(found.derivations)
    _papers.clear()
    _papers.update(found.papers)


def is_fresh() -> bool:
    """Whether there are pages that were read without an error."""
    return bool(_derivations)


def configure(config: Any) -> Any:
    """Tell MkDocs what the pages need."""
    config.use_directory_urls = False  # a page opened from file:// has no server to add index.html
    config.nav = with_papers(with_systems(config.nav, _derivations), _papers)
    for name, options in _EXTENSIONS.items():
        if name not in config.markdown_extensions:
            config.markdown_extensions.append(name)
        config.mdx_configs[name] = {**options, **(config.mdx_configs.get(name) or {})}
    config.theme.static_templates.discard("sitemap.xml")  # it holds the day of the build
    return config


def with_systems(nav: list[Any] | None, derivations: dict[str, Derivation]) -> list[Any] | None:
    """The navigation with the systems in their section; none stays none: MkDocs lists all files."""
    if nav is None:
        return None
    pages: list[Any] = [{"Overview": f"{FOLDER}/index.md"}]
    pages += [{d.title: f"{FOLDER}/{name}.md"} for name, d in derivations.items()]
    filled = [
        {SECTION: pages} if isinstance(item, dict) and SECTION in item else item for item in nav
    ]
    return filled if {SECTION: pages} in filled else [*filled, {SECTION: pages}]


def with_papers(nav: list[Any] | None, papers: dict[str, str]) -> list[Any] | None:
    """The navigation with the papers in their section; without papers there is none."""
    if nav is None:
        return None
    pages = [{"Overview": f"{PAPERS}/index.md"}]
    pages += [{short: f"{PAPERS}/{key}.md"} for key, short in papers.items()]
    section = [{PAPER_SECTION: pages}] if papers else []
    rest = [item for item in nav if not (isinstance(item, dict) and PAPER_SECTION in item)]
    place = next((k for k, item in enumerate(nav) if item not in rest), len(rest))
    return [*rest[:place], *section, *rest[place:]]


def on_files(files: Any, **_: Any) -> Any:
    """Leave out what MkDocs would now copy as it is: the unfilled template of the site map."""
    for file in list(files):
        if file.src_uri == "sitemap.xml":
            files.remove(file)
    return files


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Replace the marks of a hand-written page."""
    if page.file.src_uri.startswith((f"{FOLDER}/", f"{PAPERS}/")):
        return markdown
    return fill_marks(markdown, _derivations, page.file.src_uri)


def on_post_build(config: Any) -> None:
    """Let the search work without a server."""
    wrap_search_index(Path(config.site_dir))
