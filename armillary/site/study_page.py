"""A study on its page: headings with addresses, prose, tables and figures with their data."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape

from armillary.site.plots import plot_html
from armillary.verify.studies.data import names
from armillary.verify.studies.parts import ALONE
from armillary.verify.study import Absent, Heading, Item, ParameterTable, Prose, Table

_FORMULA = re.compile(r"\$([^$\n]+)\$")


def blocks(items: Sequence[Item], system: str, figures: int) -> list[str]:
    """The study as blocks of Markdown and HTML.

    Data are linked in the folder `<system>` beside the page, by the names that `verify` gives them.

    Args:
        figures: how many figures stand on the page before it.
    """
    found: list[str] = []
    taken: dict[str, int] = {}
    tables = plots = 0
    for item, name in zip(items, names(items), strict=True):
        data = f"{system}/{name}"
        if isinstance(item, Heading):
            found.append(_heading(item, system, taken))
        elif isinstance(item, Prose):
            found.append(with_formulas(item.text))
        elif isinstance(item, Absent):
            found.append(_absent(item))
        elif isinstance(item, Table):
            tables += 1
            found.append(table_html(item, f"table-{system}-{tables}", tables, data))
        elif not isinstance(item, ParameterTable):  # these are tables by now
            plots += 1
            identifier = f"plot-{system}-{plots}"
            caption = f"<b>Figure {figures + plots}.</b> {words(item.caption)} {_link(data)}"
            found.append(
                f'<figure id="{identifier}">{plot_html(item, identifier)}'
                f"<figcaption>{caption}</figcaption></figure>"
            )
    return found


def table_html(table: Table, identifier: str, number: int, data: str) -> str:
    """A table; columns of numbers are set from the right, words in the first head their rows.

    Args:
        data: address of its data.
    """
    heads = "".join(
        f'<th scope="col"{_side(table, k)}>{words(head.name)}'
        f"{f'<br><small>{words(head.unit)}</small>' if head.unit else ''}</th>"
        for k, head in enumerate(table.heads)
    )
    rows = "".join(
        f"<tr>{''.join(_cell(table, k, text) for k, text in enumerate(row))}</tr>"
        for row in table.texts()
    )
    caption = f"<caption><b>Table {number}.</b> {words(table.caption)} {_link(data)}</caption>"
    return (
        f'<table class="study" id="{identifier}">{caption}<thead><tr>{heads}</tr></thead>'
        f"<tbody>{rows}</tbody></table>"
    )


def _link(data: str) -> str:
    return f'<a class="data" href="{data}" type="text/csv" download>CSV</a>'


def _absent(item: Absent) -> str:
    part = f" ({escape(item.part)})" if item.part not in ("", ALONE) else ""
    return f"<p>Not computed here{part}: {escape(item.why)}.</p>"


def words(text: str) -> str:
    """Plain text as HTML, with the formulas between dollars."""
    return _FORMULA.sub(_formula, escape(text, quote=False))


def with_formulas(markdown: str) -> str:
    """Markdown with the formulas between dollars."""
    return _FORMULA.sub(_formula, markdown.strip())


def _formula(found: re.Match[str]) -> str:
    latex = found[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
    return f'<span class="tex" data-tex="{escape(latex)}"></span>'


def _heading(heading: Heading, system: str, taken: dict[str, int]) -> str:
    address = re.sub(r"[^a-z0-9]+", "-", heading.title.lower()).strip("-")
    taken[address] = taken.get(address, 0) + 1
    again = f"-{taken[address]}" if taken[address] > 1 else ""
    return f"### {escape(heading.title)} {{: #study-{system}-{address}{again} }}"


def _side(table: Table, column: int) -> str:
    return ' class="num"' if table.is_number(column) else ""


def _cell(table: Table, column: int, text: str) -> str:
    if column == 0 and not table.is_number(0):
        return f'<th scope="row">{words(text)}</th>'
    return f"<td{_side(table, column)}>{words(text)}</td>"
