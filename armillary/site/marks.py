"""Marks in hand-written pages, so that they need not repeat what a derivation says.

<!-- armillary: picture altazimuth -->      the first picture of a system
<!-- armillary: statuses -->                the table of statuses
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from html import escape

from armillary.derivation.record import Derivation
from armillary.derivation.status import MEANINGS, Status
from armillary.site.errors import SiteError
from armillary.site.notation import Notation
from armillary.site.pages import figures

_MARK = re.compile(r"^<!-- armillary: *(\w+) *(\w*) *-->$", re.MULTILINE)


def fill_marks(markdown: str, derivations: Mapping[str, Derivation], page: str) -> str:
    """A page with its marks replaced.

    Raises:
        SiteError: for a mark that names nothing.
    """

    def replaced(found: re.Match[str]) -> str:
        kind, name = found[1], found[2]
        if kind == "statuses":
            return statuses()
        if kind == "picture" and name in derivations and derivations[name].pictures:
            return _picture(derivations[name])
        raise SiteError(
            f"{page}: nothing to put in the place of {found[0]}",
            "write `picture` and a system that has one, or `statuses`",
        )

    return _MARK.sub(replaced, markdown)


def statuses() -> str:
    """What every status means, as a list."""
    rows = "".join(
        f"<dt><code>{int(s)}</code> {s.name}</dt><dd>{escape(MEANINGS[s])}</dd>"
        for s in sorted(Status, key=lambda s: (s < 0, abs(s)))
    )
    return f'<dl class="status">{rows}</dl>'


def _picture(derivation: Derivation) -> str:
    figure = figures(derivation, Notation(derivation))[0]
    caption = escape(figure.caption)
    return (
        f'<figure id="{figure.identifier}">{figure.svg}<figcaption>{caption}</figcaption></figure>'
    )
