"""A built site as files: pages, their ids, links and formulas."""

from dataclasses import dataclass, field
from functools import cached_property
from html.parser import HTMLParser
from pathlib import Path


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.ids: list[str] = []
        self.links: list[str] = []
        self.resources: list[str] = []
        self.formulas: list[tuple[str, bool]] = []
        self.inline: list[str] = []
        self.text: list[str] = []
        self._script = False

    def handle_starttag(self, tag, attrs):
        found = dict(attrs)
        if found.get("id"):
            self.ids.append(found["id"])
        if tag == "a" and found.get("href") is not None:
            self.links.append(found["href"])
        if tag == "link" and found.get("href"):
            self.resources.append(found["href"])
        if tag in ("script", "img", "iframe", "source", "video", "object", "embed"):
            self.resources += [found[n] for n in ("src", "data", "srcset") if found.get(n)]
        if found.get("data-tex") is not None:
            self.formulas.append((found["data-tex"], tag == "div"))
        if "style" in found or tag == "style" or any(name.startswith("on") for name in found):
            self.inline.append(f"{tag} {found}")
        self._script = tag == "script" and "src" not in found
        if self._script:
            self.inline.append("script")

    def handle_data(self, data):
        self.text.append(data)


@dataclass(frozen=True)
class Page:
    """One HTML file."""

    path: Path
    reader: _Reader = field(repr=False)


@dataclass(frozen=True)
class Site:
    """A folder that a build made."""

    folder: Path

    @cached_property
    def pages(self) -> list[Page]:
        found = []
        for path in sorted(self.folder.rglob("*.html")):
            reader = _Reader()
            reader.feed(path.read_text("utf-8"))
            found.append(Page(path, reader))
        return found

    def page(self, name: str) -> Page:
        return next(p for p in self.pages if p.path == self.folder / name)
