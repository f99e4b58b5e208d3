"""The search index as a script: a page opened from file:// may load scripts, but not fetch data."""

import json
import re
from pathlib import Path

_GLOBAL = "armillarySearchIndex"
_PERMALINK = re.compile(r"(?<!\S)[#¶](?!\S)\s*")  # beside each heading; MkDocs takes it for text


def wrap_search_index(site_dir: Path) -> None:
    """Write ``search/search_index.js`` from the ``search_index.json`` that MkDocs left beside it.

    The script sets ``window.armillarySearchIndex`` to the documents of the index (location, title
    and text of each section). The theme's ``js/search.js`` loads it when the search box is first
    focused. The same index gives the same bytes.

    Raises:
        FileNotFoundError: MkDocs wrote no index, because ``mkdocs.yml`` does not list its
            ``search`` plugin.
    """
    source = site_dir / "search" / "search_index.json"
    if not source.is_file():
        raise FileNotFoundError(
            f"{source} is missing: list `search` among the `plugins` of mkdocs.yml, and build first"
        )
    documents = json.loads(source.read_text(encoding="utf-8"))["docs"]
    for document in documents:
        document["text"] = _PERMALINK.sub("", document["text"])
    # ASCII keeps U+2028 and U+2029, which end a line in old JavaScript, out of the script.
    data = json.dumps({"docs": documents}, ensure_ascii=True, separators=(",", ":"))
    script = source.with_suffix(".js")
    script.write_text(f"window.{_GLOBAL}={data};\n", encoding="ascii", newline="\n")
