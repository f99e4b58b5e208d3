"""`armillary site build` and `serve`: runs MkDocs on a project.

The project's own mkdocs.yml is the configuration. Nothing is written beside it: what MkDocs must
know besides is handed to it in memory, and `hooks.py` does the rest while it builds.
"""

from __future__ import annotations

import logging
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import yaml
from mkdocs.commands import build as mkdocs_build
from mkdocs.commands import serve as mkdocs_serve
from mkdocs.config import load_config
from mkdocs.exceptions import Abort, ConfigurationError
from mkdocs.utils.yaml import yaml_load

from armillary.site.errors import SiteError
from armillary.site.studies import telling
from armillary.store.lock import locked

_HERE = Path(__file__).parent
THEME = _HERE / "theme"
ADDRESS = "127.0.0.1:8000"
_LOCK = Path("build") / "site.lock"


def build_site(
    root: Path, out: Path | None = None, strict: bool = True, say: Callable[[str], None] = print
) -> Path:
    """Build the site of a project; tells the folder.

    The old site stays until the new one is whole. Of two builds of a project one waits.

    Args:
        out: folder of the site; the `site_dir` of mkdocs.yml unless given.
        strict: whether a warning is an error.
        say: takes lines for the person at the keyboard.

    Raises:
        SiteError: when the site cannot be built.
        DerivationError: for anything wrong in a derivation.
    """
    lock = locked(root / _LOCK, lambda: say("waiting for another build to finish"))
    with _plain_errors(), lock, telling(say):
        config = load_config(str(_config_file(root)), **_options(root), strict=strict)
        wanted = (out if out is not None else Path(config.site_dir)).resolve()
        draft = wanted.with_name(f".{wanted.name}.new")
        config.site_dir = str(draft)
        try:
            config.plugins.on_startup(command="build", dirty=False)
            mkdocs_build.build(config)
            _replace(wanted, draft)
        finally:
            config.plugins.on_shutdown()
            shutil.rmtree(draft, ignore_errors=True)
    return wanted


def serve(root: Path, address: str = ADDRESS) -> None:
    """Serve the site, and build it anew when a derivation or a page changes; runs until stopped."""
    talk = logging.getLogger("mkdocs")  # it says where it serves, and what it rebuilds
    talk.setLevel(logging.INFO)
    talk.addHandler(logging.StreamHandler())
    found = (root / "build" / name for name in ("checks.json", "audit.json"))
    watched = [root / "derivations", root / "generated", *found]
    with _plain_errors():
        mkdocs_serve.serve(
            str(_config_file(root)),
            watch=[str(path) for path in watched if path.exists()],
            dev_addr=address,
            **_options(root) | {"hooks": [str(_HERE / "serving.py")]},
        )


def _options(root: Path) -> dict[str, Any]:
    """What the project's mkdocs.yml need not say."""
    options: dict[str, Any] = {"hooks": [str(_HERE / "hooks.py")]}
    with _config_file(root).open(encoding="utf-8") as file:
        content = yaml_load(file)
    theme = content.get("theme")
    name = theme.get("name") if isinstance(theme, dict) else theme
    if name in (None, "armillary"):
        # By its folder, so that it need not be installed, and is the one of this very version.
        own = yaml.safe_load((THEME / "mkdocs_theme.yml").read_text("utf-8"))
        options["theme"] = {"name": None, "custom_dir": str(THEME), **own}
    options["validation"] = {
        "links": dict.fromkeys(
            ("anchors", "absolute_links", "unrecognized_links", "not_found"), "warn"
        ),
        "nav": dict.fromkeys(("omitted_files", "not_found", "absolute_links"), "warn"),
    }
    if not content.get("plugins"):
        options["plugins"] = ["search"]
    return options


def _config_file(root: Path) -> Path:
    path = root / "mkdocs.yml"
    if not path.is_file():
        raise SiteError(
            f"there is no {path}", "write one; it needs no more than a line `site_name: ...`"
        )
    return path


def _replace(wanted: Path, draft: Path) -> None:
    """Put the new site in the place of the old one."""
    old = wanted.with_name(f".{wanted.name}.old")
    shutil.rmtree(old, ignore_errors=True)
    if wanted.exists():
        wanted.rename(old)
    draft.rename(wanted)
    shutil.rmtree(old, ignore_errors=True)


@contextmanager
def _plain_errors() -> Iterator[None]:
    """MkDocs says what is wrong while it builds; what is left is one line."""
    try:
        yield
    except (Abort, ConfigurationError) as problem:
        raise SiteError(
            f"the site was not built: {problem}", "mend what the lines above name, and build again"
        ) from None
