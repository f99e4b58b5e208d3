"""The hooks while a site is served: a derivation that is wrong at the moment keeps its old page.

MkDocs would hold back every page until the error is mended, and print a traceback.
"""

from __future__ import annotations

import logging
from typing import Any

from armillary.derivation.errors import DerivationError
from armillary.site.errors import SiteError
from armillary.site.hooks import (
    configure,
    is_fresh,
    on_files,
    on_page_markdown,
    on_post_build,
    refresh,
)

log = logging.getLogger("mkdocs.armillary")

__all__ = ["on_config", "on_files", "on_page_markdown", "on_post_build"]


def on_config(config: Any) -> Any:
    """Write the pages of the systems, or say why they stay as they were."""
    try:
        refresh(config)
    except (DerivationError, SiteError) as problem:
        if not is_fresh():
            raise
        log.error("%s\nThe pages stay as they were.", problem)
    return configure(config)
