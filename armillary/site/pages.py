"""The page of a system, as Markdown with HTML: everything on it is read from the derivation."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from armillary.derivation.record import Derivation
from armillary.site.checks import Group, groups
from armillary.site.facts import Facts
from armillary.site.figures import picture_svg
from armillary.site.kernels import cards
from armillary.site.notation import Notation
from armillary.site.references import Reference, reference_of
from armillary.site.steps import Claim, claim, notation_rows, steps
from armillary.site.studies import Studied
from armillary.site.study_page import blocks
from armillary.site.verdicts import Prints

_TEMPLATES = Path(__file__).parent / "templates"
_WORDS = {"pass": "holds", "fail": "fails", "skip": "not checked"}


@dataclass(frozen=True)
class Figure:
    """A drawing with its caption."""

    identifier: str
    svg: str
    caption: str


@dataclass(frozen=True)
class Proved:
    """An identity with what the last check said."""

    claim: Claim
    state: str

    @property
    def word(self) -> str:
        """The state in a word."""
        return _WORDS[self.state]


def system_page(
    derivation: Derivation,
    facts: Facts,
    references: dict[str, Reference],
    study: Studied | None = None,
    prints: Prints | None = None,
) -> str:
    """The page of one system.

    Raises:
        SiteError: when the derivation names a paper that the project does not have.
    """
    notation = Notation(derivation)
    found = list(steps(derivation, notation))
    drawn = figures(derivation, notation)
    key = derivation.paper
    shortened = {angle for step in found for angle in step.compact}
    known = facts.checks_of(derivation)
    checked = groups(derivation, known.rows)
    return render(
        "system.md.j2",
        name=derivation.name,
        title=derivation.title,
        summary=derivation.summary,
        figures=drawn,
        studies=blocks(study.items, derivation.name, len(drawn)) if study else [],
        assumptions=derivation.assumptions,
        rows=notation_rows(derivation),
        compact=next((a for s in found for a in sorted(s.compact)), "") if shortened else "",
        uses_turns=any("R_" in s.written.latex or "T_" in s.written.latex for s in found),
        steps=found,
        prints=prints or Prints(),
        paper=reference_of(references, key, derivation.name) if key else None,
        claims=_proved(derivation, notation, checked),
        cards=cards(derivation, facts),
        kernels=set(derivation.kernels),
        groups=[group for group in checked if group.key != "proofs"],
        outdated=known.outdated,
        conventions=_has_conventions(derivation),
    )


def figures(derivation: Derivation, notation: Notation) -> list[Figure]:
    """The drawings of a system: its chains."""
    made = []
    for k, picture in enumerate(derivation.pictures, 1):
        identifier = f"fig-{derivation.name}-{k}"
        svg = picture_svg(picture, notation, identifier)
        made.append(Figure(identifier, svg, picture.caption))
    return made


def index_page(derivations: Iterable[Derivation]) -> str:
    """The page that leads to the systems."""
    systems: list[Mapping[str, Any]] = [
        {"name": d.name, "title": d.title, "sentence": first_sentence(d.summary)}
        for d in derivations
    ]
    return render("index.md.j2", systems=systems)


def first_sentence(text: str) -> str:
    """A text up to its first full stop."""
    head, stop, _ = text.partition(". ")
    return head + stop.strip()


def _proved(derivation: Derivation, notation: Notation, checked: list[Group]) -> list[Proved]:
    states = {
        line.claim: line.state for group in checked if group.key == "proofs" for line in group.lines
    }
    return [
        Proved(claim(identity, notation), states.get(identity.claim, "skip"))
        for identity in derivation.identities
    ]


def _has_conventions(derivation: Derivation) -> bool:
    """Whether the project wrote the chapter that the page would point to."""
    project = Path(derivation.source.path).resolve().parents[2]
    return (project / "site_docs" / "conventions.md").is_file()


def render(template: str, **context: object) -> str:
    """A template filled in; text is escaped."""
    environment = Environment(
        loader=FileSystemLoader(_TEMPLATES),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=False,
        keep_trailing_newline=True,
    )
    return environment.get_template(template).render(context)
